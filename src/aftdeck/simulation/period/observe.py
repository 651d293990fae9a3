"""Pairs that count for CLEARANCE after a control period, and the arm's tip, twist and limits."""

from __future__ import annotations

from math import sqrt

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, relative
from aftdeck.kinematics.observe import observe_near
from aftdeck.law import large_law, law
from aftdeck.simulation.payloads.alignment import mark_task_pairs
from aftdeck.simulation.payloads.grasp import NEAR
from aftdeck.simulation.row.now import Flat, Motion, Watch, motion_of, watch_of
from aftdeck.simulation.row.scalars import HELD, LIMITS, NEAREST, RADIUS, SINGULAR, STAND_VELOCITY, WITHIN
from aftdeck.simulation.row.world import World, world_of
from aftdeck.worksite.capture.acquisition import enclosed_bar
from aftdeck.worksite.watch.places import nearest_place


@large_law
def observed(flat: Flat, links: Array) -> None:
    """Observe the arm, and write into the scalars whether a limit is near."""
    world, now = world_of(flat), motion_of(flat)
    v = now.scalars
    near = observe_near(
        links, now.angles, now.rates, v[STAND_VELOCITY], world.reach, world.constants[SINGULAR], now.observed
    )
    v[LIMITS] = 1.0 if near else 0.0


@large_law
def counted(flat: Flat) -> bool:
    """Mark the pairs that count for the minimum clearance of the next step.

    Returns:
        False if a payload may be aligned with the end effector, a berth or a guide: its pairs then do not count
        (`payloads.alignment`).
    """
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    v, c = now.scalars, world.constants
    held = int(v[HELD])
    if held >= 0:
        begin, end = world.berth_begins[held], world.berth_begins[held + 1]
        if nearest_place(now.frames, world.rows[held], world.berths[begin:end], world.places[begin:end], NEAR) >= 0:
            return False
    elif _may_be_aligned(world, now, watch):
        return False
    watch.counts[:] = world.detrimental
    return len(world.meetings) == 0 or not mark_task_pairs(
        world.meetings, world.aligns, watch.active, watch.found, watch.bound, watch.permitted, int(v[NEAREST]), NEAR,
        c[WITHIN], watch.counts,
    )  # fmt: skip


@law
def _may_be_aligned(world: World, now: Motion, watch: Watch) -> bool:
    """Return whether the empty end effector may be aligned with a payload for capture."""
    if len(world.bars) > 0 and enclosed_bar(watch.placed, world.bars, world.tolerances, NEAR) >= 0:
        return True
    outer, inner, pin = np.empty(POSE), np.empty(POSE), np.empty(POSE)
    for k in range(len(world.fixtures)):
        if world.fixtures[k, 0] != world.fixtures[k, 0]:
            continue
        compose(now.frames[world.hand[0]], world.effector, outer)
        compose(now.frames[world.rows[k]], world.fixtures[k], inner)
        relative(outer, inner, pin)
        if abs(pin[0]) <= NEAR and sqrt(pin[1] * pin[1] + pin[2] * pin[2]) <= world.constants[RADIUS]:
            return True
    return False
