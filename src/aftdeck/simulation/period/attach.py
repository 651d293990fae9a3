"""What may capture, fix or release a payload after a control period, and the report's mode."""

from __future__ import annotations

import numpy as np

from aftdeck.bodies.pose import POSE, compose
from aftdeck.law import large_law, law
from aftdeck.simulation.payloads.task_phases import ACQUISITION, DOCKED, EXTRACTION, MANOEUVRING
from aftdeck.simulation.row.now import Flat, Motion, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    AT_PORT,
    FIXED,
    FIXED_FINGER,
    HELD,
    PRONG_AT,
    RELEASED,
    SPACING,
    TASK,
    WORKS,
)
from aftdeck.simulation.row.world import ENVELOPE, MOST, MOST_ANGLE, ONLY_Y, PORT, TIP, World, world_of
from aftdeck.worksite.berths.docking import BEFORE, DISTANCE, FOUND, INSIDE, TURNED, approach
from aftdeck.worksite.berths.on_way import NEAR
from aftdeck.worksite.capture.acquisition import acquired_bar
from aftdeck.worksite.watch.bay import any_inside
from aftdeck.worksite.watch.places import nearest_place


@large_law
def attached(flat: Flat) -> bool:
    """Return whether a payload may be captured, fixed or released now; write the report's mode into the scalars."""
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    v, c = now.scalars, world.constants
    held = int(v[HELD])
    captures = v[WORKS] != 0.0
    if len(world.bars) > 0:
        if held >= 0:
            captures = captures or c[FIXED_FINGER] - v[PRONG_AT] > c[SPACING]
        else:
            captures = captures or acquired_bar(watch.placed, world.bars, world.tolerances) >= 0
    berths, inside = v[RELEASED] != 0.0, False
    if held >= 0 and v[FIXED] == 0.0:
        begin, end = world.berth_begins[held], world.berth_begins[held + 1]
        number = nearest_place(now.frames, world.rows[held], world.berths[begin:end], world.places[begin:end], NEAR)
        if number >= 0 and world.by_itself[begin + number] != 0:
            berths = berths or docks(world, now, held, begin + number)
    if held < 0:
        v[TASK] = ACQUISITION
    elif v[AT_PORT] != 0.0:
        v[TASK] = DOCKED
    else:
        if len(world.bay) > 0:
            solids = world.bodies[world.body_begins[held] : world.body_begins[held + 1]]
            inside = any_inside(watch.placed, solids, world.scene, world.bay[0], world.bay[1])
        v[TASK] = EXTRACTION if inside else MANOEUVRING
    return bool(captures or berths)


@law
def docks(world: World, now: Motion, held: int, berth: int) -> bool:
    """Return whether the conditions of docking hold for the held payload at a port (`berths.docking`)."""
    port, found, at = world.ports[berth], np.empty(FOUND), np.empty(POSE)
    compose(now.frames[world.berths[berth]], port[PORT:ENVELOPE], at)
    probe = world.probes[world.probe_begins[berth] : world.probe_begins[berth + 1]]
    planes = port[ENVELOPE:TIP].reshape(5, 4)
    approach(probe, port[TIP:MOST], now.frames[world.rows[held]], at, planes, found)
    angle = found[TURNED + 1]
    if port[ONLY_Y] == 0.0:
        angle = max(found[TURNED], angle, found[TURNED + 2])
    return bool(
        found[BEFORE] >= 0.0 and found[INSIDE] >= 0.0 and found[DISTANCE] <= port[MOST] and angle <= port[MOST_ANGLE]
    )
