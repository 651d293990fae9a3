"""Measurement of a stop: distances of the tip, and the time from which it is at rest.

The tip is at rest if a box with a diagonal below `AT_REST` contains all its positions of a whole window of time. The
window is divided into slots, and the least and greatest coordinates of each slot are kept. The time of rest is
therefore known to one slot, and the state keeps no trajectory.
"""

from __future__ import annotations

import math

import numpy as np

from aftdeck.arrays import Array
from aftdeck.matrices import distance, length
from aftdeck.plant.stop import Stop
from aftdeck.tuples import Vec3

AT_REST = 5e-3
"""Diagonal of the box of the tip's positions below which the tip is at rest [m] (assumed)."""
WINDOW, WINDOW_LOADED = 4.0, 20.0
"""Windows of time without and with a payload [s].

Each is at least half the longest period of the straight flexible arm (2.8 s; with 32,000 lb 32 s, with 65,000 lb 50 s,
for which it is a little shorter), so that no turning point of a swing counts as rest.
"""
SLOTS = 40
"""Number of slots of a window; a slot has at least one control period."""
_TURNED = 1e-4
"""Decrease of the distance from the place of the stop from which the tip has turned back [m] (assumed)."""


def new_stop(cause: str, tick: int, place: Vec3, speed: float, period: float, *, loaded: bool) -> Stop:
    """Return a measurement that begins.

    Args:
        cause: event that begins the stop, as text for the log.
        tick: number of the last step before it.
        place: true position of the tip after that step, in L [m].
        speed: speed of the tip in that step [m/s].
        period: control period [s].
        loaded: whether the arm holds a payload.
    """
    window = WINDOW_LOADED if loaded else WINDOW
    slot = max(1, round(window / (SLOTS * period)))
    rows = math.ceil(window / (slot * period) - 1e-9)
    low, high = np.full((rows, 3), math.inf), np.full((rows, 3), -math.inf)
    low[0] = high[0] = place
    return Stop(cause, tick, place, speed, slot, low, high, np.array([[math.inf] * 3, [-math.inf] * 3]))


def observe(stop: Stop, tick: int, tip: Vec3) -> bool:
    """Add the tip's position of one step; return whether the tip was at rest for the whole window before it."""
    row, ticks = divmod(tick - stop.began, stop.slot)
    low, high = stop.low[row % len(stop.low)], stop.high[row % len(stop.low)]
    if ticks == 0:
        if row >= len(stop.low) and swing_left(stop) < AT_REST:
            return True
        low[:] = high[:] = tip
    else:
        np.minimum(low, tip, out=low)
        np.maximum(high, tip, out=high)
    away = distance(tip, stop.place)
    stop.greatest = max(stop.greatest, away)
    if stop.greatest - away > _TURNED or stop.turned[0, 0] < math.inf:
        np.minimum(stop.turned[0], tip, out=stop.turned[0])
        np.maximum(stop.turned[1], tip, out=stop.turned[1])
    return False


def window_began(stop: Stop, tick: int) -> int:
    """Return the tick at which a window began that ended before step `tick`."""
    return tick - len(stop.low) * stop.slot


def swing_left(stop: Stop) -> float:
    """Return the diagonal of the box of the tip's positions in the last window [m]."""
    low, high = _box(stop)
    return distance(low.tolist(), high.tolist())


def final_place(stop: Stop) -> Array:
    """Return the middle of the tip's positions in the last window, (3,), in L [m]."""
    low, high = _box(stop)
    return 0.5 * (low + high)


def swing_about(stop: Stop, place: Array) -> float:
    """Return the greatest distance of the tip from a place since the tip first turned back [m]; 0 if it never did.

    It is the distance of the farthest corner of a box around these positions: for a swing in one line the exact
    distance, for a circle at most 1.41 times as much.
    """
    low, high = stop.turned
    if low[0] == math.inf:
        return 0.0
    return length(np.maximum(high - place, place - low).tolist())


def _box(stop: Stop) -> tuple[Array, Array]:
    """Return the least and the greatest coordinates of the tip in the last window, (3,) each, in L [m]."""
    return stop.low.min(axis=0), stop.high.max(axis=0)
