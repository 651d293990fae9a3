"""Stops of an arm with masses: distance, time and oscillation of the tip after the end of a command."""

from __future__ import annotations

from math import nan, sqrt

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, vec3
from aftdeck.law import law
from aftdeck.matrices import distance
from aftdeck.plant.state import Bodies
from aftdeck.plant.stop import Stop
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.log import Log
from aftdeck.simulation.motion.tip_rest import (
    WINDOW,
    final_place,
    new_stop,
    observe,
    swing_about,
    swing_left,
    window_began,
)
from aftdeck.simulation.state import State
from aftdeck.steering.layout import DRIVE, MOTION_ACTIVE, STICKS
from aftdeck.tuples import Vec3
from aftdeck.units import INCH
from aftdeck.worksite.conditions import Units, quantity_text

RELEASED = "BRAKES off"
"""Cause of a stop that begins when the brakes are released."""
_NOWHERE = nan, nan, nan
"""Position of the tip before the first step."""
_DECIMALS = {"in": 2, "mm": 1}
"""Number of decimals of a length in the log."""


def watch_stop(flight: Flight, state: State, log: Log, bodies: Bodies) -> None:
    """Measure the stop of the arm after each command, and log it when the tip is at rest or when the stop ends.

    A command ends when the sticks return to zero, when an automatic motion ends, or by BRAKES or SAFING. A stop ends
    with the next command, and when the brakes are set or released; then a new one begins. If it ends within `WINDOW`,
    nothing is logged. A release of the brakes that moves the tip by less than `tip_rest.AT_REST` is not logged.
    """
    motion, period, units = bodies.tip, flight.scenario.control_period, flight.scenario.arm.model.units
    site, panel, before = flight.site, state.panel, motion.place
    tip, moved, commanded = tip_motion(
        bodies.frames, site.last_joint - 1, site.hand, _NOWHERE if before is None else before, state.command
    )
    driven, braked, stop = commanded and not (panel.brakes or panel.safing), panel.brakes, motion.stop
    switched = braked != motion.braked
    if stop is not None and (driven or switched):
        if (state.tick - stop.began) * period >= WINDOW:
            _report(stop, state.tick, log, period, units, rests=False)
        motion.stop = None
    if not driven and (motion.driven or (switched and (stop is not None or not braked))):
        loaded = state.carried.payload is not None
        place = tip if before is None else before
        motion.stop = new_stop(_cause(state), state.tick - 1, place, motion.speed, period, loaded=loaded)
    if motion.stop is not None and observe(motion.stop, state.tick, tip):
        since = window_began(motion.stop, state.tick)
        if motion.stop.cause != RELEASED or since > motion.stop.began:  # the tip moved after a release of the brakes
            _report(motion.stop, since, log, period, units, rests=True)
        motion.stop = None
    motion.speed = 0.0 if before is None else moved / period
    motion.place, motion.driven, motion.braked = tip, driven, braked


def is_at_rest(state: State) -> bool:
    """Return whether no command moves the arm and its last stop has ended. The kinematic arm stops at once."""
    bodies = state.plant.bodies
    return not _is_driven(state) and (bodies is None or bodies.tip.stop is None)


@law
def tip_motion(frames: Array, last: int, hand: Array, before: Vec3, command: Array) -> tuple[Vec3, float, bool]:
    """Return the true position of the tip in L [m], its distance from an earlier one [m], and `is_commanded`.

    Args:
        frames: (f, 12) true poses of the arm's frames in L.
        last: row of the last joint's frame.
        hand: (12,) pose of the tip in this frame.
        before: the earlier position in L [m].
        command: input of the steering laws.
    """
    tip = np.empty(POSE)
    compose(frames[last], hand, tip)
    x, y, z = tip[0] - before[0], tip[1] - before[1], tip[2] - before[2]
    return vec3(tip, 0), sqrt(x * x + y * y + z * z), is_commanded(command)


@law
def is_commanded(command: Array) -> bool:
    """Return whether a stick or an automatic motion commands the arm; `command` is the input of the steering laws."""
    driven = command[MOTION_ACTIVE] != 0.0 or command[DRIVE] != 0.0
    for k in range(6):
        driven = driven or command[STICKS + k] != 0.0
    return bool(driven)


def _is_driven(state: State) -> bool:
    """Return whether a stick or an automatic motion commands the arm, and no switch stops it."""
    return not (state.panel.brakes or state.panel.safing) and is_commanded(state.command)


def _cause(state: State) -> str:
    """Return the event that begins a stop in this step, as text for the log."""
    if state.panel.brakes:
        return "BRAKES"
    if state.plant.bodies is not None and state.plant.bodies.tip.braked:
        return RELEASED
    return "SAFING" if state.panel.safing else "the command"


def _report(stop: Stop, until: int, log: Log, period: float, units: Units, *, rests: bool) -> None:
    """Log a stop: its time, speed and distances, and the oscillation that is left if the tip is not at rest.

    Args:
        stop: the measurement.
        until: tick from which the tip is at rest, or at which the measurement ended.
        log: log of the step.
        period: control period [s].
        units: units of lengths in the text.
        rests: whether the tip is at rest.
    """
    end = final_place(stop)
    away = distance(end.tolist(), stop.place)
    lengths = away, max(stop.greatest - away, 0.0), swing_about(stop, end), swing_left(stop)
    per, unit = (INCH, "in") if units == "ft-in" else (1e-3, "mm")
    went, beyond, swung, left = (f"{length / per:.{_DECIMALS[unit]}f}" for length in lengths)
    how = "at rest" if rests else f"swings {left} {unit},"
    seconds = (until - stop.began) * period
    speed = quantity_text(stop.speed, "m/s", units)
    text = f"tip {how} {seconds:.1f} s after {stop.cause} at {speed}: {went} {unit} on, {beyond} farther, swung {swung}"
    log.add("stop", "info", text)
