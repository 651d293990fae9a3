"""Stops of an arm with masses: distance, time and oscillation of the tip after the end of a command."""

from __future__ import annotations

import numpy as np

from aftdeck.bodies.pose import POSE, compose, vec3
from aftdeck.matrices import distance
from aftdeck.plant.state import Bodies, Stop
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.log import log
from aftdeck.simulation.state import State
from aftdeck.steering.layout import DRIVE, MOTION_ACTIVE, STICKS
from aftdeck.tuples import Vec3
from aftdeck.worksite.conditions import quantity_text

AT_REST = 5e-3
"""Range of the tip's positions within `WINDOW` at which the tip counts as at rest [m] (assumed)."""
WINDOW = 4.0
"""Time for which the tip's positions are compared [s]: longer than a period of the unloaded flexible arm (assumed)."""


def watch_stop(flight: Flight, state: State, bodies: Bodies) -> None:
    """Measure the stop of the arm after each command, and log it when the tip is at rest or at the next command.

    A command ends when the sticks return to zero, when an automatic motion ends, or by BRAKES or SAFING. If the next
    command follows within `WINDOW`, nothing is logged.
    """
    driven, stop = _is_driven(state), bodies.stop
    if driven:
        if stop is not None and (state.tick - stop.began) * flight.scenario.control_period >= WINDOW:
            _report(flight, state, stop, _tip(flight, bodies), rests=False)
        bodies.stop = None
    elif bodies.driven:
        tip = _tip(flight, bodies)
        bodies.stop = Stop(_cause(state), state.tick, tip, 0.0, state.tick, np.array(tip), np.array(tip))
    elif stop is not None:
        _continue(flight, state, bodies, stop)
    bodies.driven = driven


def _continue(flight: Flight, state: State, bodies: Bodies, stop: Stop) -> None:
    """Continue a measurement; end it when the tip was at rest for a whole window."""
    tip = _tip(flight, bodies)
    stop.greatest = max(stop.greatest, distance(tip, stop.place))
    np.minimum(stop.low, tip, out=stop.low)
    np.maximum(stop.high, tip, out=stop.high)
    if (state.tick - stop.window) * flight.scenario.control_period < WINDOW:
        return
    stop.left = distance(stop.low.tolist(), stop.high.tolist())
    if stop.left < AT_REST:
        bodies.stop = None
        _report(flight, state, stop, tip, rests=True)
    stop.window, stop.low[:], stop.high[:] = state.tick, tip, tip


def _tip(flight: Flight, bodies: Bodies) -> Vec3:
    """Return the true position of the tip in L [m]."""
    hand = np.empty(POSE)
    compose(bodies.frames[flight.site.last_joint - 1], flight.site.hand, hand)
    return vec3(hand, 0)


def _is_driven(state: State) -> bool:
    """Return whether a stick or an automatic motion commands the arm, and no switch stops it."""
    if state.panel.brakes or state.panel.safing:
        return False
    return bool(state.command[MOTION_ACTIVE] or state.command[DRIVE] or state.command[STICKS : STICKS + 6].any())


def _cause(state: State) -> str:
    """Return what ended the command."""
    return "BRAKES" if state.panel.brakes else "SAFING" if state.panel.safing else "the command ended"


def _report(flight: Flight, state: State, stop: Stop, tip: Vec3, *, rests: bool) -> None:
    """Log a stop: distance and time, or the oscillation that is left when the next command begins."""
    units, period = flight.scenario.arm.model.units, flight.scenario.control_period
    away = distance(tip, stop.place)
    farther = max(stop.greatest - away, 0.0)
    went, beyond, left = (quantity_text(value, "m", units) for value in (away, farther, stop.left))
    until = stop.window if rests else state.tick
    how = "at rest" if rests else f"swings by {left}"
    text = f"tip {how} {(until - stop.began) * period:.1f} s after {stop.cause}, {went} on; went up to {beyond} farther"
    log(flight, state, "stop", "info", text)
