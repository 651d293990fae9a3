"""Pairs that count for CLEARANCE after a control period, and the arm's tip, twist and limits."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.observe import observe_near
from aftdeck.law import large_law, law
from aftdeck.lent import lend
from aftdeck.simulation.payloads.alignment import Contacting, mark
from aftdeck.simulation.period.ways import escape, zoned
from aftdeck.simulation.row.aligning import aligning_of
from aftdeck.simulation.row.now import Arrays, Flat, lent, limits_of, monitor_of, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    ALIGNED,
    ARM,
    HELD,
    LIMITS,
    NEAREST,
    NEW_LIMITS,
    SINGULAR,
    STAND_VELOCITY,
    WITHIN,
)
from aftdeck.simulation.row.world import pairs_of, world_of


@law
def observe_arm(arrays: Arrays, links: Array, sticks: Array) -> None:
    """Observe the arm after a step that Python code has made, as `observed` does."""
    observed(lent(arrays), lend(links), lend(sticks))


@large_law
def observed(flat: Flat, links: Array, sticks: Array) -> None:
    """Observe the arm, its limits and singularities, and find the ways out of them.

    Args:
        flat: constants of the run and row of the state.
        links: the arm's links with its shoulder at the present height.
        sticks: steering rules of the present mode if it is manual, else of ORB UNL.
    """
    world, now, limits = world_of(flat), motion_of(flat), limits_of(flat)
    v = now.scalars
    near = observe_near(
        links, now.angles, now.rates, v[STAND_VELOCITY], world.reach, world.constants[SINGULAR], now.observed
    )
    v[LIMITS] = 1.0 if near else 0.0
    new = zoned(world, now, limits, near)
    if near and v[ARM] == 0.0:  # ways out of contacts take precedence
        new = escape(world, now, limits, sticks) or new
    v[NEW_LIMITS] = 1.0 if new else 0.0


@large_law
def counted(flat: Flat) -> bool:
    """Mark the pairs that count for the minimum clearance of the next step, and find what is aligned for capture.

    Returns:
        False if that needs clearances on the way into a berth that are not known yet (`alignment.alarm_pairs`).
    """
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    v = now.scalars
    inhibited = v[ARM] != 0.0
    task = Contacting(watch.permitted, watch.frames_touching, watch.essential, watch.arm, inhibited)
    found = mark(
        world, aligning_of(flat), pairs_of(flat), monitor_of(watch), watch.active, now.frames, task, int(v[HELD]),
        int(v[ALIGNED]), int(v[NEAREST]), world.constants[WITHIN], watch.counts,
    )  # fmt: skip
    if found < -1:
        return False
    v[ALIGNED] = found
    return True
