"""What contacts, seats and walls leave of a step's motion, before the plant makes it.

Remote Manipulator Simulation, final report, chapter IV: collisions found in two successive frames inhibit the arm. Here
motion that deepens no contact is let through, so that whatever leads out can be flown.
"""

from __future__ import annotations

import numpy as np

from aftdeck.simulation.ahead import frames_after
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.sliding import slide_along
from aftdeck.simulation.state import State
from aftdeck.steering.layout import RATES, TWIST
from aftdeck.steering.mode import MODES
from aftdeck.worksite.restrain import allowed


def restrain(flight: Flight, state: State, telescope: float) -> float:
    """Cut the commanded rates in `state.steering` to what may be flown.

    Args:
        flight: what never changes.
        state: with the step's commanded rates.
        telescope: how the stand is driven, in [-1, 1].

    Returns:
        How the stand is driven.
    """
    things = state.site
    sliding = things.held if MODES[state.panel.mode].kind in ("automatic", "manual") else None
    things.contacts.essential = flight.site.essential_while(sliding)
    rates = state.steering[RATES : RATES + 6]
    if things.fast:
        return _halted(state)
    if not (telescope or np.any(rates)):
        return 0.0
    if sliding is not None:
        slides = slide_along(flight, state, telescope, sliding)
        if slides is None:
            return _halted(state)
        telescope = slides
    if not things.contacts.inhibit.arm:
        return telescope
    after = frames_after(flight, state, rates, telescope)
    if allowed(things.watch, things.contacts.arm & (1 - things.contacts.essential), after):
        return telescope
    return _halted(state)


def _halted(state: State) -> float:
    """The arm stands still, and the stand with it: the next step's steering begins from rest."""
    state.steering[RATES : RATES + 6] = 0.0
    state.steering[TWIST : TWIST + 6] = 0.0
    return 0.0
