"""Pairs of solids that are near each other: only these can touch before the next measurement."""

from __future__ import annotations

from math import sqrt

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.hexahedron import VERTICES
from aftdeck.bodies.pair import CONTACT, PAIR
from aftdeck.bodies.pair_check import measure
from aftdeck.bodies.vector import Vector, dot, minus, vector_at
from aftdeck.law import law
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.groups import CENTRE, RADIUS
from aftdeck.worksite.watch.motion import Motion, motion, velocity

_ROUNDING = 1e-6
"""Margin by which two boxes may be apart although their solids are in contact [m]: more than rounding errors."""


@law
def _boxes_near(a: Array, b: Array, within: float) -> bool:
    """Return whether the bounding boxes of two packed solids (52,) are nearer than `within` along each axis [m]."""
    near = True
    for axis in range(3):
        begin = axis * VERTICES
        low_a = high_a = a[begin]
        low_b = high_b = b[begin]
        for v in range(begin + 1, begin + VERTICES):
            low_a, high_a = min(low_a, a[v]), max(high_a, a[v])
            low_b, high_b = min(low_b, b[v]), max(high_b, b[v])
        near = near and low_a - high_b < within and low_b - high_a < within
    return near


@law
def near_pairs(
    active: Mask,
    found: Array,
    within: float,
    period: float,
    before: Array,
    now: Array,
    reach: Array,
    frame: Indices,
    begins: Indices,
    pairs: Indices,
    placed: Array,
    near: Indices,
) -> int:
    """Find the pairs of solids that can touch in the next step, in all groups.

    These are the pairs that are nearer than `within` and the distance that they would cover together in one step at
    their present speeds relative to each other.

    Args:
        active: (g,) 1 for groups that are monitored.
        found: (g, 14) measurements, rows as in `worksite.watch.found`.
        within: distance of a pair without motion [m].
        period: duration of a step [s].
        before: (F, 12) poses of the frames one step before, in L.
        now: (F, 12) present poses of the frames, in L.
        reach: (F,) as `Layout.reach`.
        frame: (n,) as `Layout.frame`.
        begins: (g + 1,) as `Layout.begins`.
        pairs: (m, 2) as `Layout.pairs`.
        placed: (n, 52) the solids in L.
        near: (p, 3) output: the group and the two solids of each pair, as far as there is room.

    Returns:
        Number of pairs found, which can be greater than p.
    """
    count, pair = 0, np.zeros(PAIR)
    motions = np.empty((len(now), 6))
    for f in range(len(now)):
        m = motion(before[f], now[f], period)
        for k in range(6):
            motions[f, k] = m[k]
    for g in range(len(active)):
        begin = begins[g]
        if active[g] == 0 or begins[g + 1] == begin or not found[g, CLEARANCE] < np.inf:
            continue
        i, j = frame[pairs[begin, 0]], frame[pairs[begin, 1]]
        most = min(
            _speed(now, motions, i, j, vector_at(now[i], 0), reach[i]),
            _speed(now, motions, i, j, vector_at(now[j], 0), reach[j]),
        )
        if found[g, CLEARANCE] >= within + period * most:
            continue
        for k in range(begin, begins[g + 1]):
            a, b = placed[pairs[k, 0]], placed[pairs[k, 1]]
            of_a, of_b = vector_at(a, CENTRE), vector_at(b, CENTRE)
            speed = min(
                _speed(now, motions, i, j, of_a, a[RADIUS]),
                _speed(now, motions, i, j, of_b, b[RADIUS]),
            )
            distance = within + period * speed
            away, around = minus(of_b, of_a), distance + a[RADIUS] + b[RADIUS]
            if dot(away, away) > around * around or not _boxes_near(a, b, distance):
                continue
            if measure(a, b, pair) >= distance:
                continue
            if count < len(near):
                near[count, 0], near[count, 1], near[count, 2] = g, pairs[k, 0], pairs[k, 1]
            count += 1
    return count


@law
def _speed(now: Array, motions: Array, i: int, j: int, centre: Vector, radius: float) -> float:
    """Return an upper bound of the speed at which the points of a sphere move with one frame relative to another.

    Args:
        now: (F, 12) present poses of the frames, in L.
        motions: (F, 6) motions of the frames.
        i: the first frame; its solid or the second one's has the sphere.
        j: the second frame.
        centre: centre of the sphere in L [m].
        radius: its radius [m].
    """
    past = minus(velocity(now[i], _of(motions[i]), centre), velocity(now[j], _of(motions[j]), centre))
    turn = minus(vector_at(motions[i], 0), vector_at(motions[j], 0))
    return sqrt(dot(past, past)) + radius * sqrt(dot(turn, turn))


@law
def _of(row: Array) -> Motion:
    """Return the motion of a frame from its row (6,)."""
    return Motion(row[0], row[1], row[2], row[3], row[4], row[5])


@law
def touch(a: Array, b: Array, pair: Array) -> bool:
    """Return whether two solids are in contact.

    Args:
        a: (52,) the first solid, in L.
        b: (52,) the second solid, in L.
        pair: workspace of `measure`.
    """
    return _boxes_near(a, b, _ROUNDING) and measure(a, b, pair) <= CONTACT
