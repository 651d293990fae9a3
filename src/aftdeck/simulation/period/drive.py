"""Motion in a control period of what nothing touches: joints, telescope, prong, and payloads that float."""

from __future__ import annotations

import numpy as np

from aftdeck.law import large_law, law
from aftdeck.plant.kinematic import follow
from aftdeck.simulation.payloads.free_contact import measured
from aftdeck.simulation.row.now import Flat, Motion, Watch, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    CLOSES,
    CONTROLLED,
    CYCLE_AT,
    FLOATS,
    HELD,
    MOTION_AT,
    ORBITS,
    PERIOD,
    POSE_AT,
    PRONG_AT,
    PRONG_HIGH,
    PRONG_LOW,
    PRONG_RATE,
    PRONG_VELOCITY,
    REFERENCE_AT,
    STAND,
    STAND_VELOCITY,
    STOPPED,
    TELESCOPE,
    TELESCOPE_HIGH,
    TELESCOPE_LOW,
    TELESCOPE_RATE,
    TIME_AT,
)
from aftdeck.simulation.row.world import World, world_of
from aftdeck.steering.layout import RATES
from aftdeck.worksite.capture.acquisition import MEASURED, PRONG, acquire
from aftdeck.worksite.free_flight import coast, limit_cycle


@large_law
def driven(flat: Flat) -> bool:
    """Move joints and telescope for one control period, at the commanded rates, as far as their stops allow.

    Returns:
        Whether prong and floating payloads have moved, too. False if the orbiter moves or something may touch them.
    """
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    v, c = now.scalars, world.constants
    joints = len(now.angles)
    follow(now.steering[RATES : RATES + joints], c[PERIOD], world.stops, now.angles, now.rates, now.commanded)
    if v[TELESCOPE] != 0.0 or v[STAND_VELOCITY] != 0.0:
        before = v[STAND]
        v[STAND] = after(before, v[TELESCOPE], c[TELESCOPE_LOW], c[TELESCOPE_HIGH], c[TELESCOPE_RATE], c[PERIOD])
        v[STAND_VELOCITY] = (v[STAND] - before) / c[PERIOD]
    if not free(world, now, watch):
        return False
    drifted(world, now, watch)
    return True


@law
def after(position: float, drive: float, low: float, high: float, rate: float, period: float) -> float:
    """Return the position of a linear actuator after a control period: drive times `rate`, from `low` to `high` [m]."""
    return min(max(position + drive * rate * period, low), high)


@law
def free(world: World, now: Motion, watch: Watch) -> bool:
    """Return whether the orbiter rests, no contact stops the prong, and nothing can touch a floating payload."""
    v = now.scalars
    if v[ORBITS] != 0.0 or (v[CLOSES] != 0.0 and v[STOPPED] != 0.0):
        return False
    for k in range(len(now.flights)):
        if now.flights[k, FLOATS] != 0.0 and measured(watch.near, world.of_payload[k]):
            return False
    return True


@law
def drifted(world: World, now: Motion, watch: Watch) -> None:
    """Move the prong, and the payloads that float and that nothing can touch."""
    v, c = now.scalars, world.constants
    drive = v[CLOSES]
    if drive > 0.0:
        reached = after(v[PRONG_AT], drive, c[PRONG_LOW], c[PRONG_HIGH], c[PRONG_RATE], c[PERIOD])
        drive *= _closing_fraction(world, watch, int(v[HELD]), reached - v[PRONG_AT])
    if drive != 0.0 or v[PRONG_VELOCITY] != 0.0:
        before = v[PRONG_AT]
        v[PRONG_AT] = after(before, drive, c[PRONG_LOW], c[PRONG_HIGH], c[PRONG_RATE], c[PERIOD])
        v[PRONG_VELOCITY] = (v[PRONG_AT] - before) / c[PERIOD]
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


@law
def _closing_fraction(world: World, watch: Watch, held: int, distance: float) -> float:
    """Return the share of `distance` [m] that the prong moves until it touches the held payload's bar; at most 1."""
    if held < 0 or len(world.bars) == 0 or world.bars[held, 0] < 0:
        return 1.0
    found = np.empty(MEASURED)
    acquire(watch.placed, world.bars[held], world.tolerances, found)
    clearance = max(found[PRONG], 0.0)
    return 1.0 if distance <= clearance else clearance / distance
