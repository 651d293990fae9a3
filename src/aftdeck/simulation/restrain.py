"""What contacts, seats and walls leave of a step's motion, before the plant makes it.

Remote Manipulator Simulation, final report, chapter IV: collisions found in two successive frames inhibit the arm. Here
motion that deepens no contact is let through, so that whatever leads out can be flown.
"""

from __future__ import annotations

from aftdeck.simulation.ahead import frames_after
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.sliding import slide_along
from aftdeck.simulation.standstill import standing
from aftdeck.simulation.state import State
from aftdeck.steering.layout import CLOCK, PACE, RATES, RATIO, TWIST
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
    things.halt = ""
    sliding = slider(state)
    things.contacts.essential = flight.site.essential_while(sliding)
    rates = state.steering[RATES : RATES + 6]
    moved = telescope or any(rates.tolist())
    if things.fast or standing(state.panel):
        if moved:
            things.halt = "seat" if things.fast else "switch"
        return _halted(flight, state)
    if not moved:
        return 0.0
    if sliding is not None:
        slides = slide_along(flight, state, telescope, sliding)
        if slides is None:
            things.halt = "contact"
            return _halted(flight, state)
        telescope = slides
    if not things.contacts.inhibit.arm:
        return telescope
    after = frames_after(flight, state, rates, telescope)
    if allowed(things.watch, things.contacts.arm & (1 - things.contacts.essential), after):
        return telescope
    things.halt = "contact"
    return _halted(flight, state)


def slider(state: State) -> int | None:
    """The cargo that slides along the walls that it touches: what is held, in the modes that steer a point."""
    return state.site.held if MODES[state.panel.mode].kind in ("automatic", "manual") else None


def _halted(flight: Flight, state: State) -> float:
    """The arm stands still, and the stand with it: nothing is left of what was commanded.

    The next step's steering begins from rest, and the clock of modes 1 and 3 has not run.
    """
    steering = state.steering
    steering[RATES : RATES + 6] = 0.0
    steering[TWIST : TWIST + 6] = 0.0
    state.report[RATIO] = 0.0
    if MODES[state.panel.mode].kind == "automatic" and not flight.scenario.strict:
        steering[CLOCK] -= steering[PACE] * flight.scenario.control_period
        steering[PACE] = 0.0
    return 0.0
