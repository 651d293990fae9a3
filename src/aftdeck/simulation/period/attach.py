"""What may capture, fix or release a payload after a control period, and the report's mode."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import turned
from aftdeck.bodies.vector import plus, vector_at
from aftdeck.law import large_law, law
from aftdeck.simulation.payloads.met import berth_holds, pin_met
from aftdeck.simulation.payloads.relations import berth_near
from aftdeck.simulation.payloads.task_phases import ACQUISITION, DOCKED, EXTRACTION, MANOEUVRING
from aftdeck.simulation.row.aligning import Aligning, aligning_of
from aftdeck.simulation.row.now import Flat, Motion, monitor_of, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    AT_PORT,
    CLOSES,
    CONTR,
    FIXED,
    FIXED_FINGER,
    HELD,
    PERIOD,
    PRONG_AT,
    PRONG_HIGH,
    PRONG_LOW,
    RELEASED,
    SNARE_MODE,
    SPACING,
    TASK,
    WORKS,
)
from aftdeck.simulation.row.world import World, pairs_of, world_of
from aftdeck.worksite.capture.acquisition import acquired_bar
from aftdeck.worksite.capture.effector import BEGINS, MOVES, RESTS
from aftdeck.worksite.capture.snare import (
    ACCEPTED,
    CAPTURED,
    CAPTURES,
    DRAWN,
    MOTION,
    RELEASES,
    RING,
    begin_motion,
    ends_motion,
    next_part,
    refused,
    travel,
)
from aftdeck.worksite.watch.bay import any_inside, may_be_inside
from aftdeck.worksite.watch.groups import CENTRE, RADIUS, PackedLayout
from aftdeck.worksite.watch.measured import Measured, place_bars, place_solid


@large_law
def attached(flat: Flat) -> bool:
    """Return whether a payload may be captured, fixed or released now; write the report's mode into the scalars."""
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    v, c, pairs, own = now.scalars, world.constants, pairs_of(flat), monitor_of(watch)
    held = int(v[HELD])
    captures = v[WORKS] == BEGINS
    if len(world.bars) > 0:
        if held >= 0:
            captures = captures or c[FIXED_FINGER] - v[PRONG_AT] > c[SPACING]
        else:
            place_bars(pairs, own, world.bars)
            captures = captures or acquired_bar(own.placed, world.bars, world.tolerances) >= 0
    berths, inside = v[RELEASED] != 0.0 and not _stays(world, aligning_of(flat), now, held), False
    if held >= 0 and v[FIXED] == 0.0 and not berths:
        berth = berth_near(world, now.frames, held)
        berths = (
            berth >= 0
            and world.by_itself[berth] != 0
            and berth_holds(world, aligning_of(flat), now.frames, held, berth)
        )
    if held < 0:
        v[TASK] = ACQUISITION
    elif v[AT_PORT] != 0.0:
        v[TASK] = DOCKED
    else:
        if len(world.bay) > 0:
            inside = _in_bay(world, pairs, own, now.frames[world.rows[held]], held)
        v[TASK] = EXTRACTION if inside else MANOEUVRING
    if captures or berths:
        return True
    return v[WORKS] == MOVES and not _snares_move(world, aligning_of(flat), now, held)


@law
def _in_bay(world: World, pairs: PackedLayout, own: Measured, pose: Array, held: int) -> bool:
    """Return whether a vertex of the held payload, whose pose is given (12,), is inside the payload bay."""
    low, high = world.bay[0], world.bay[1]
    if not may_be_inside(vector_at(pose, 0), pairs.reach[world.rows[held]], world.scene, low, high):
        return False
    for m in range(world.body_begins[held], world.body_begins[held + 1]):
        i = world.bodies[m]
        solid = pairs.solids[i]
        centre = plus(turned(pose, vector_at(solid, CENTRE)), vector_at(pose, 0))
        if may_be_inside(centre, solid[RADIUS], world.scene, low, high):
            place_solid(pairs, own, i)
            if any_inside(own.placed, world.bodies[m : m + 1], world.scene, low, high):
                return True
    return False


@law
def _snares_move(world: World, aligning: Aligning, now: Motion, held: int) -> bool:
    """Move snares and carriage; return False, with nothing changed, if a part arrives or a payload is drawn."""
    mode, contr = int(now.scalars[SNARE_MODE]), int(now.scalars[CONTR])
    part, _ = next_part(now.snare, mode, contr)
    if part < 0 or ends_motion(now.snare, mode) or (now.snare[CAPTURED] != 0.0) == (held < 0):
        return False
    closes = part == RING and now.snare[MOTION] == CAPTURES and held < 0
    moved = now.snare.copy()
    inside = closes and pin_met(world, aligning, now.frames, np.inf) == 1.0
    if travel(moved, world.snare_times, mode, contr, world.constants[PERIOD], inside) >= 0.0:
        return False
    if held >= 0 and moved[DRAWN] != now.snare[DRAWN]:
        return False
    now.snare[:] = moved
    return True


@law
def press(world: World, now: Motion, switch: float) -> bool:
    """Press the switch of the end effector before a control period; write what then moves into the scalars.

    Args:
        world: constants of the run.
        now: the state.
        switch: 1 closes, -1 opens.

    Returns:
        Whether a sequence of the snares begins, which has changed their state.
    """
    v, snare = now.scalars, now.snare
    if world.constants[PRONG_LOW] != world.constants[PRONG_HIGH]:
        v[CLOSES] = switch
    if len(world.snare_times) == 0:
        return False
    trigger = CAPTURES if switch > 0.0 else RELEASES
    if refused(snare, int(v[SNARE_MODE]), trigger) != ACCEPTED:
        v[WORKS] = BEGINS if snare[MOTION] != 0.0 or v[CONTR] != 0.0 else RESTS
        return False
    v[WORKS] = MOVES
    if trigger == snare[MOTION] and snare[RING] > 0.0:
        return False
    begin_motion(snare, trigger)
    return True


@law
def _stays(world: World, aligning: Aligning, now: Motion, held: int) -> bool:
    """Return whether the held payload is still where a berth has just released it, so that nothing changes."""
    berth = int(now.scalars[RELEASED]) - 1
    if berth < 0 or berth_near(world, now.frames, held) != berth:
        return False
    return berth_holds(world, aligning, now.frames, held, berth)
