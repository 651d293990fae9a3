"""Limit one step's commanded motion to what contacts, seats and walls allow, before the plant makes it.

Source: *Remote Manipulator Simulation*, final report, chapter IV: a collision found in two successive steps inhibits
the arm until it is relieved. Deviation: motion that relieves the contact (`worksite.restrain`) is allowed, so that the
operator can always back out. A held payload slides where sliding is permitted (`worksite.sliding`).
"""

from __future__ import annotations

from aftdeck.arrays import Mask
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame_poses import frames_after
from aftdeck.simulation.motion.standstill import standing
from aftdeck.simulation.payloads.sliding import slide_along
from aftdeck.simulation.state import State
from aftdeck.steering.layout import CLOCK, PACE, RATES, RATIO, TWIST
from aftdeck.steering.mode import MODES
from aftdeck.worksite.watch.contact_motion import leads_out, relieves, worsened

AHEAD = (1.0, 8.0, 64.0, 512.0)
"""Numbers of steps after which a motion is tested for leading out of the contacts."""


def restrain(flight: Flight, state: State, telescope: float) -> float:
    """Limit the commanded rates in `state.steering`, and the stand's drive, to what contacts, seats and walls allow.

    Args:
        flight: constants of the run.
        state: state with the step's commanded rates.
        telescope: commanded drive of the stand, in [-1, 1].

    Returns:
        Allowed drive of the stand, in [-1, 1].
    """
    things = state.site
    things.halt = ""
    sliding = slider(state)
    things.contacts.essential[:] = flight.site.essential_while(sliding, things.permitted)
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
    apart = kept_apart(flight, state, sliding=sliding is not None)
    if relieves(things.watch, *apart, after):
        return telescope
    ahead = [frames_after(flight, state, steps * rates, steps * telescope)[None] for steps in AHEAD]
    if leads_out(things.watch, *apart, after[None], ahead)[0] > 0.0:
        return telescope
    # no motion leads out: allow a step that worsens no contact, so that the arm is not stuck
    if not things.advice and worsened(things.watch, apart[0], after) < 0:
        return telescope
    things.halt = "contact"
    return _halted(flight, state)


def kept_apart(flight: Flight, state: State, *, sliding: bool) -> tuple[Mask, Mask]:
    """Return the groups whose contacts an inhibited arm must not deepen, and those of them that it must relieve.

    Args:
        flight: constants of the run.
        state: state whose contacts are up to date.
        sliding: True if the held cargo slides along walls, as in the modes that steer a point. The groups of the
            cargo and its walls are then in neither result, because sliding keeps the cargo off its walls.
    """
    things = state.site
    own = things.contacts.arm
    if sliding and things.held is not None:
        own = own & (1 - flight.site.slides[things.held])
    return own, own & (1 - things.permitted)


def slider(state: State) -> int | None:
    """Return the cargo that slides along walls, the held one in modes that steer a point; None if no cargo slides."""
    return state.site.held if MODES[state.panel.mode].kind in ("automatic", "manual") else None


def _halted(flight: Flight, state: State) -> float:
    """Stop the arm, and return 0.0, the drive that stops the stand.

    The next step's steering starts from rest. In the automatic modes, except under `strict`, the clock of modes 1 and 3
    is set back by this step.
    """
    steering = state.steering
    steering[RATES : RATES + 6] = 0.0
    steering[TWIST : TWIST + 6] = 0.0
    state.report[RATIO] = 0.0
    if MODES[state.panel.mode].kind == "automatic" and not flight.scenario.strict:
        steering[CLOCK] -= steering[PACE] * flight.scenario.control_period
        steering[PACE] = 0.0
    return 0.0
