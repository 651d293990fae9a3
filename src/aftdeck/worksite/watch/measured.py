"""What the collision program remembers, and the nearest pair of solids of a group.

The remembered data of a pair of solids serve only to prove that the pair is not the nearest. The least clearance is
always measured without such data. Of several pairs with the same clearance, the first is used. The result therefore
equals the result of a monitor without memory, to the last digit.

A solid is placed in L when it is measured. A frame's solids have moved by at most the sum of the frame's motions: this
sum lowers the bounds of its groups, so that a motion costs nothing for each solid and for each group.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies import pair as packed
from aftdeck.bodies.hexahedron import place
from aftdeck.bodies.pair_check import measure
from aftdeck.bodies.pose import turned
from aftdeck.bodies.vector import dot, minus, plus, put_vector, vector_at
from aftdeck.law import law
from aftdeck.lent import lend
from aftdeck.worksite.watch.groups import CENTRE, POSE, RADIUS, LayoutArrays, PackedLayout, layout_from

_SLACK = 1e-9
"""Margin by which the bounds of groups and pairs are lowered [m]; it is more than the rounding errors."""
NEVER = -1
"""In `placed_after`: a solid that was never placed."""


class Measured(NamedTuple):
    """Arrays of a `ClearanceMonitor` that the laws update; F frames, n solids, m pairs of solids, g groups.

    Attributes:
        at: (F, 12) last poses of the frames, in L.
        placed: (n, 52) the solids in L, each at the pose that its frame had when it was placed.
        bound: (g,) lower bound of each group's clearance, before the motions in `moved` [m].
        moved: (F,) upper bound of the displacement of each frame's points, summed over its motions [m].
        moved_then: (F,) `moved` when the groups were listed.
        beyond: (3,) values from when the groups were listed [m]: lower bound of the clearances of the active groups
            that are not listed; the same for those of them that count; clearance up to which all were measured.
        pair_bound: (m,) lower bound of the clearance of each pair of solids, as `bound` is of each group's [m].
        memory: (m, 17) remembered data of each pair of solids.
        found: (g, 14) the last measurements, rows as in `worksite.watch.found`.
        likely: (g,) nearest pair of each group at its last measurement.
        moves: (F,) number of motions of each frame.
        placed_after: (n,) number of its frame's motions after which a solid was placed; `NEVER` before.
        listed: (g + 1,) groups that may be near, in their order; the last entry is their number.
        near: (g,) 1 for groups whose clearance in `found` is finite.
        reviewed: (2 g,) the groups that were active when the groups were listed, and then those that counted.
    """

    at: Array
    placed: Array
    bound: Array
    moved: Array
    moved_then: Array
    beyond: Array
    pair_bound: Array
    memory: Array
    found: Array
    likely: Indices
    moves: Indices
    placed_after: Indices
    listed: Indices
    near: Mask
    reviewed: Mask


MeasuredArrays = tuple[
    Array, Array, Array, Array, Array, Array, Array, Array, Array, Indices, Indices, Indices, Indices, Mask, Mask
]
"""The arrays of a `Measured`, as Python passes them to a law."""


@law
def measured_of(arrays: MeasuredArrays) -> Measured:
    """Return the arrays of a monitor under their names, lent: they have to live until the calling law returns."""
    a, b, c, d, e, f, g, h, i, j, k, m, n, o, p = arrays
    return Measured(
        lend(a), lend(b), lend(c), lend(d), lend(e), lend(f), lend(g), lend(h), lend(i), lend(j), lend(k), lend(m),
        lend(n), lend(o), lend(p),
    )  # fmt: skip


@law
def apart(own: Measured) -> Measured:
    """Return the arrays with those copied that change when frames and solids are placed elsewhere.

    `bound`, `memory`, `found`, `likely` and the list of the groups are shared. No solid is placed in the copy.
    """
    return Measured(
        own.at.copy(), np.empty_like(own.placed), own.bound, own.moved.copy(), own.moved_then, own.beyond,
        own.pair_bound.copy(), own.memory, own.found, own.likely, own.moves.copy(),
        np.full_like(own.placed_after, NEVER), own.listed, own.near, own.reviewed,
    )  # fmt: skip


@law
def follow(layout: PackedLayout, own: Measured, frames: Array) -> None:
    """Take new poses of the frames (F, 12), in L: lower the bounds, and mark the solids that have moved."""
    travel = np.empty(len(frames))
    travelled(frames, own.at, layout.reach, travel)
    for f in range(len(frames)):
        if own.at[f, 0] == own.at[f, 0]:  # a frame without an earlier pose has NaN, and its solids have no bounds yet
            own.moved[f] += travel[f] if travel[f] == travel[f] else np.inf
        if travel[f] != 0.0:
            own.moves[f] += 1
            for k in range(POSE):
                own.at[f, k] = frames[f, k]


@law
def travelled(frames: Array, at: Array, reach: Array, travel: Array) -> None:
    """Compute for each frame an upper bound of the displacement of its points between two poses.

    Args:
        frames: (F, 12) poses of the frames, in L.
        at: (F, 12) earlier poses of the frames, in L; NaN if there were none.
        reach: (F,) upper bound of the distance of a frame's solids from the frame's origin [m].
        travel: (F,) output: upper bounds of the displacements [m]; NaN for a frame without an earlier pose.
    """
    for f in range(len(frames)):
        origin, rotation = 0.0, 0.0
        for k in range(3):
            away = frames[f, k] - at[f, k]
            origin += away * away
        for k in range(3, POSE):
            away = frames[f, k] - at[f, k]
            rotation += away * away
        # the spectral norm of a difference of two rotations is its Frobenius norm divided by the square root of 2
        travel[f] = sqrt(origin) + sqrt(0.5 * rotation) * reach[f]


@law
def motion_between(layout: PackedLayout, own: Measured, g: int) -> float:
    """Return the motion in `moved` by which the parts of group g may have approached each other [m]."""
    a, b = layout.between_frames[g, 0], layout.between_frames[g, 1]
    moved: float = own.moved[a] + own.moved[b]
    return moved


@law
def lower_bound(layout: PackedLayout, own: Measured, g: int) -> float:
    """Return a lower bound of the clearance of group g at the last poses [m]."""
    bound: float = own.bound[g] - motion_between(layout, own, g)
    return bound


@law
def lower_bounds(layout: PackedLayout, own: Measured) -> None:
    """Lower all bounds by the motions in `moved`, which begin at 0 again: rounding errors grow with their sums."""
    for g in range(len(own.bound)):
        moved = motion_between(layout, own, g)
        own.bound[g] -= moved
        for k in range(layout.begins[g], layout.begins[g + 1]):
            own.pair_bound[k] -= moved
    own.moved[:] = 0.0


@law
def place_solid(layout: PackedLayout, own: Measured, i: int) -> None:
    """Place solid i in L, unless it is placed at its frame's last pose."""
    f = layout.frame[i]
    if own.placed_after[i] == own.moves[f]:
        return
    own.placed_after[i] = own.moves[f]
    solid, at, placed = layout.solids[i], own.at[f], own.placed[i]
    place(solid, at, at[3:].reshape(3, 3), placed)
    put_vector(placed, CENTRE, plus(turned(at, vector_at(solid, CENTRE)), vector_at(at, 0)))
    placed[RADIUS] = solid[RADIUS]


@law
def place_which(layout: LayoutArrays, own: MeasuredArrays, which: Indices) -> None:
    """Run `place_solids`."""
    place_solids(layout_from(layout), measured_of(own), which)


@law
def place_solids(layout: PackedLayout, own: Measured, which: Indices) -> None:
    """Place the solids `which` (k,) in L."""
    for i in which:
        place_solid(layout, own, i)


@law
def place_bars(layout: PackedLayout, own: Measured, bars: Indices) -> None:
    """Place the solids of bars and of the parts that enclose them; `bars` (c, 4) as for `acquisition.acquired_bar`."""
    for k in range(len(bars)):
        if bars[k, 0] >= 0:
            place_solids(layout, own, bars[k])


@law
def spheres_apart(a: Array, b: Array) -> float:
    """Return the distance of the bounding spheres of two solids [m]; negative if they overlap."""
    centres = minus(vector_at(b, CENTRE), vector_at(a, CENTRE))
    return sqrt(dot(centres, centres)) - float(a[RADIUS]) - float(b[RADIUS])


@law
def nearest_pair(layout: PackedLayout, own: Measured, g: int, limit: float, measures: Array) -> int:
    """Return the pair of solids of a group that has the least clearance; of pairs with equal clearance, the first.

    Args:
        layout: the solids and the groups.
        own: arrays of the monitor. The search begins with the pair in `likely`, and `memory` is updated; neither
            `likely` nor `memory` affects the result.
        g: the group.
        limit: pairs that are not nearer than this are ignored [m].
        measures: (17,) output: packed measurements of the pair.

    Returns:
        Index of the pair; -1 if no pair is below the limit.
    """
    placed, pairs, memory, moved = own.placed, layout.pairs, own.memory, motion_between(layout, own, g)
    begin, end, first = layout.begins[g], layout.begins[g + 1], own.likely[g]
    best, least, found = -1, limit, np.empty(packed.PAIR)
    for visit in range(begin - 1, end):
        k = first if visit < begin else visit
        # remembered data are used only to show that a pair is not the nearest
        beyond = least + _SLACK
        if visit == first or (visit >= begin and own.pair_bound[k] - moved > beyond):
            continue
        place_solid(layout, own, pairs[k, 0])
        place_solid(layout, own, pairs[k, 1])
        a, b = placed[pairs[k, 0]], placed[pairs[k, 1]]
        if visit >= begin:
            bound = spheres_apart(a, b)
            if bound <= beyond:
                bound = measure(a, b, memory[k])
            own.pair_bound[k] = bound - _SLACK + moved
            if bound > beyond:
                continue
        found[:] = 0.0
        clearance = measure(a, b, found)
        if visit < begin:
            memory[k] = found
            own.pair_bound[k] = clearance - _SLACK + moved
        if clearance < least or (clearance == least and k < best):
            best, least = k, clearance
            measures[:] = found
    return best


@law
def measure_group(layout: PackedLayout, own: Measured, g: int, measures: Array) -> float:
    """Return the clearance of group g [m]; write the measurements of its nearest pair into `measures` (17,).

    Also update `bound` and `likely`.
    """
    own.likely[g] = nearest_pair(layout, own, g, np.inf, measures)
    clearance: float = measures[packed.CLEARANCE]
    own.bound[g] = clearance - _SLACK + motion_between(layout, own, g)
    return clearance
