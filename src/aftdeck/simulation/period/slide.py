"""Sliding along walls: the commanded joint rates are replaced by rates that keep the held payload out of the walls.

Source: Remote Manipulator Simulation, final report, section VII.4.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.vector import dot, minus, vector_at
from aftdeck.law import large_law, law
from aftdeck.simulation.period.actuator import after
from aftdeck.simulation.period.predict import predicted
from aftdeck.simulation.row.now import Flat, monitor_of, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    HELD,
    PERIOD,
    STAND,
    TELESCOPE,
    TELESCOPE_HIGH,
    TELESCOPE_LOW,
    TELESCOPE_RATE,
)
from aftdeck.simulation.row.world import pairs_of, world_of
from aftdeck.steering.layout import RATES
from aftdeck.worksite.sliding.projection import LEAST, OUTWARD, TOUCH
from aftdeck.worksite.sliding.touches import EACH, touching
from aftdeck.worksite.sliding.walls import met, slid
from aftdeck.worksite.watch.measured import place_solids

OUT = 0.01
"""Speed at which a payload that overlaps a wall is moved out of it [m/s] (assumed)."""
INTO = 1e-7
"""Greatest allowed increase of a payload's penetration depth in a wall in one step [m].

A greater increase shows that `touching` has missed a contact.
"""


@large_law
def slid_along(flat: Flat, rules: Array) -> bool:
    """Change the commanded rates so that the held payload does not move into the walls that it may slide along.

    The telescope stops at a wall: its drive in the scalars is replaced.

    Args:
        flat: constants of the run and row of the state, with the step's commanded rates.
        rules: the steering's rules that are in force.

    Returns:
        False if no rates are found that keep the payload out of the walls, so that the arm must stop.
    """
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    v, c, steering = now.scalars, world.constants, now.steering
    held, period, rate = int(v[HELD]), c[PERIOD], c[TELESCOPE_RATE]
    walls = world.slides[held]
    payload = now.frames[world.rows[held]]
    away = minus(vector_at(payload, 0), vector_at(now.observed, 0))  # from the tip, if this is what the sticks move
    size = sqrt(dot(away, away)) + pairs_of(flat).reach[world.rows[held]]
    near = met(watch.found, watch.near, walls, steering, abs(v[TELESCOPE]) * rate, size, period)
    if near == 0.0:
        return True
    found = _touches(flat, walls, world.rows[held], near)
    v[TELESCOPE] *= _telescope_fraction(found, -v[TELESCOPE] * rate)
    height = after(v[STAND], v[TELESCOPE], c[TELESCOPE_LOW], c[TELESCOPE_HIGH], rate, period)
    commanded, nothing = steering.copy(), np.zeros(len(walls), np.uint8)
    rates, last = steering[RATES : RATES + len(now.angles)], now.frames[world.hand[0]]
    for turning in (1.0, 0.0):
        steering[:] = commanded
        slid(rules, world.joints, last, height, turning, found, steering)
        if predicted(flat, walls, nothing, rates, v[TELESCOPE], 1.0).deeper <= INTO:
            return True
    return False


@law
def _touches(flat: Flat, walls: Mask, frame: int, near: float) -> Array:
    """Return the touches (k, 7) of the payload with this frame, with rows as in `sliding.projection`.

    `near` is the clearance up to which a wall is considered [m].
    """
    watch, pairs = watch_of(flat), pairs_of(flat)
    own = monitor_of(watch)
    monitored, solids = np.empty(len(walls), np.uint8), 0
    for g in range(len(walls)):
        monitored[g] = walls[g] & watch.active[g]
        if monitored[g] != 0 and watch.near[g] != 0:
            solids += pairs.begins[g + 1] - pairs.begins[g]
            for k in range(pairs.begins[g], pairs.begins[g + 1]):
                place_solids(pairs, own, pairs.pairs[k])
    rows = np.empty((EACH * solids, TOUCH))
    period = world_of(flat).constants[PERIOD]
    count = touching(
        pairs.frame, pairs.pairs, pairs.begins, monitored, frame, watch.placed, watch.found, near, period, OUT, rows
    )
    return rows[:count]


@law
def _telescope_fraction(found: Array, speed: float) -> float:
    """Return the fraction, 0 to 1, of the speed along axis 3 [m/s] at which no contact in `found` (k, 7) deepens."""
    fraction = 1.0
    for k in range(len(found)):
        into, allowed = -speed * found[k, OUTWARD + 2], -found[k, LEAST] if found[k, LEAST] < 0.0 else 0.0
        if into > allowed:
            fraction = min(fraction, allowed / into)
    return fraction
