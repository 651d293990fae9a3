"""Joints past their limits, singularities that are near, and the ways out of both."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.kinematics.freeing import joint_out
from aftdeck.kinematics.observe import SEEN
from aftdeck.law import law
from aftdeck.simulation.frame import AT_HARD, FREE, PAST_REACH, PAST_SOFT
from aftdeck.simulation.row.now import Limits, Motion
from aftdeck.simulation.row.scalars import BY_JOINT, FLOWN, SINGULAR
from aftdeck.simulation.row.world import World
from aftdeck.steering.layout import ANGLES, COMMAND, LAW
from aftdeck.steering.way_out import DIRECTIONS, way_out

TOUCHING = 1e-6
"""Distance from a hard stop within which a joint counts as at the stop [rad]."""
LEAST = 1e-3
"""Least rate at which a stick direction must lead away to count as an escape direction.

The rate is the growth of the distance from a singularity [1/s], or the rate of a joint away from its limit [rad/s].
"""
NEARLY = 0.6
"""Fraction of the greatest rate [1]. The previous escape direction is kept if its rate is at least this fraction."""
HOW, WHICH, SIGN = range(3)
"""Columns of `Limits.ways`: how the cause is left; the stick direction, 0 to 11 (axis by axis, + before -), or the
joint; and the sign of the joint's motion."""
NOT_NEEDED, BY_STICK, BY_ONE_JOINT = range(3)
"""Values of the column `HOW`."""


@law
def zoned(world: World, now: Motion, limits: Limits, near: bool) -> bool:
    """Write the zones of the joints and the singularities that are near; return whether any of them has changed.

    Args:
        world: constants of the run.
        now: joints, and distances from the singularities.
        limits: those of the step before; changed.
        near: False if a simpler test has shown that no joint is past its reach limits and no singularity is near.
    """
    changed = False
    for i in range(len(limits.zones)):
        zone = _zone(now.angles[i], world.reach[i], world.soft[i], world.stops[i]) if near else FREE
        changed = changed or zone != limits.zones[i]
        limits.zones[i] = zone
    for s in range(len(limits.singular)):
        mark = 1 if near and abs(now.observed[SEEN + s]) < world.constants[SINGULAR] else 0
        changed = changed or mark != limits.singular[s]
        limits.singular[s] = mark
    return changed


@law
def _zone(angle: float, reach: Array, soft: Array, hard: Array) -> int:
    """Return the zone of a joint: free, or past its reach limit or soft stop, or at its hard stop."""
    if reach[0] <= angle <= reach[1]:
        return FREE
    if soft[0] <= angle <= soft[1]:
        return PAST_REACH
    return PAST_SOFT if hard[0] + TOUCHING < angle < hard[1] - TOUCHING else AT_HARD


@law
def escape(world: World, now: Motion, limits: Limits, rules: Array) -> bool:
    """Write a way out of each singularity that is near and of each limit that a joint has passed.

    Args:
        world: constants of the run.
        now: joints and steering.
        limits: zones and singularities of this step; `advice` and `ways` are written.
        rules: steering rules of the present mode if it is manual, else of ORB UNL.

    Returns:
        Whether a cause has a stick direction that had none before.
    """
    v, singular, joints, new = now.scalars, len(limits.singular), len(limits.zones), False
    command, steering, speeds = np.zeros(COMMAND), now.steering.copy(), np.zeros(DIRECTIONS)
    command[LAW] = v[FLOWN]
    steering[ANGLES : ANGLES + joints] = now.angles
    for c in range(singular + joints):
        joint = c - singular
        limits.ways[c, HOW] = NOT_NEEDED
        if (limits.singular[c] if joint < 0 else limits.zones[joint]) == 0:
            continue
        sign = 0 if joint < 0 else _inward(world.reach, now.angles, joint)
        if v[BY_JOINT] == 0.0:
            way_out(rules, command, steering, c if joint < 0 else -1, joint, float(sign), speeds)
            best = _best(speeds, limits.advice[c])
            if best >= 0:
                new = new or limits.advice[c] < 0
                limits.advice[c] = best
                limits.ways[c, HOW], limits.ways[c, WHICH] = BY_STICK, best
                continue
        if joint < 0:
            joint, sign = joint_out(world.links, now.angles, world.reach, c, world.constants[SINGULAR])
            if limits.zones[joint] != 0:
                sign = _inward(world.reach, now.angles, joint)
        limits.ways[c, HOW], limits.ways[c, WHICH], limits.ways[c, SIGN] = BY_ONE_JOINT, joint, sign
    return new


@law
def _best(speeds: Array, before: int) -> int:
    """Return the stick direction that leads away fastest, or the previous direction if it is nearly as fast.

    Args:
        speeds: (12,) rate at which each stick direction leads away.
        before: the previous direction; -1 for none.

    Returns:
        The direction; -1 if every stick direction leads away more slowly than `LEAST`.
    """
    best = 0
    for k in range(1, len(speeds)):
        if speeds[k] > speeds[best]:
            best = k
    if speeds[best] < LEAST:
        return -1
    return before if before >= 0 and speeds[before] >= NEARLY * speeds[best] else best


@law
def _inward(reach: Array, angles: Array, joint: int) -> int:
    """Return the direction, +1 or -1, in which a joint moves away from the nearer of its reach limits."""
    return 1 if angles[joint] < 0.5 * (reach[joint, 0] + reach[joint, 1]) else -1
