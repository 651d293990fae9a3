"""Motion in a control period: joints, telescope, orbiter, prong, and payloads that float."""

from __future__ import annotations

import numpy as np

from aftdeck.bodies.pose import POSE
from aftdeck.law import large_law, law
from aftdeck.plant.kinematic import follow
from aftdeck.simulation.payloads.free_contact import measured
from aftdeck.simulation.period.actuator import after
from aftdeck.simulation.period.prong import prong_moved
from aftdeck.simulation.period.translate import translated
from aftdeck.simulation.row.now import Flat, Motion, Watch, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    CONTROLLED,
    CYCLE_AT,
    FLOATS,
    MOTION_AT,
    PERIOD,
    POSE_AT,
    REFERENCE_AT,
    STAND,
    STAND_VELOCITY,
    TELESCOPE,
    TELESCOPE_HIGH,
    TELESCOPE_LOW,
    TELESCOPE_RATE,
    TIME_AT,
)
from aftdeck.simulation.row.world import World, world_of
from aftdeck.steering.layout import RATES
from aftdeck.worksite.free_flight import coast, limit_cycle


@large_law
def driven(flat: Flat) -> bool:
    """Move joints and telescope for one control period, at the commanded rates, as far as their stops allow.

    Then move orbiter, prong and the payloads that float.

    Returns:
        False if something may touch a payload that floats; then none of them has moved.
    """
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    v, c = now.scalars, world.constants
    joints = len(now.angles)
    follow(now.steering[RATES : RATES + joints], c[PERIOD], world.stops, now.angles, now.rates, now.commanded)
    if v[TELESCOPE] != 0.0 or v[STAND_VELOCITY] != 0.0:
        before = v[STAND]
        v[STAND] = after(before, v[TELESCOPE], c[TELESCOPE_LOW], c[TELESCOPE_HIGH], c[TELESCOPE_RATE], c[PERIOD])
        v[STAND_VELOCITY] = (v[STAND] - before) / c[PERIOD]
    translated(flat)
    prong_moved(flat, np.empty((0, POSE)))
    if not _free(world, now, watch):
        return False
    _drifted(world, now)
    return True


@law
def _free(world: World, now: Motion, watch: Watch) -> bool:
    """Return whether nothing can touch a floating payload."""
    for k in range(len(now.flights)):
        if now.flights[k, FLOATS] != 0.0 and measured(watch.near, world.of_payload[k]):
            return False
    return True


@law
def _drifted(world: World, now: Motion) -> None:
    """Move the payloads that float, which nothing can touch."""
    c = world.constants
    for k in range(len(now.flights)):
        if now.flights[k, FLOATS] == 0.0:
            continue
        flight = now.flights[k]
        pose, motion = flight[POSE_AT:MOTION_AT], flight[MOTION_AT:REFERENCE_AT]
        coast(pose, motion, c[PERIOD])
        if flight[CONTROLLED] != 0.0:
            flight[TIME_AT] += c[PERIOD]
            reference, cycle = flight[REFERENCE_AT:CYCLE_AT].reshape(3, 3), flight[CYCLE_AT:TIME_AT]
            limit_cycle(cycle, reference, flight[TIME_AT], pose, motion)
        now.carrier[k] = -1
        now.poses_in_carrier[k] = pose
