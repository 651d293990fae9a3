"""The dynamic collision program: it measures the clearance of every group (monitored pair of parts) in every step.

Source: Remote Manipulator Simulation, final report, chapter IV. In each step, the report's program examined three
hexahedra and one body; this program examines all parts that can touch. For each group, the last measurement and the
later motion of the two parts' frames give a lower bound of the clearance. A group is measured again only if its bound
is too small to exclude the group from the result.

The remembered data of a pair of solids serve only to prove that the pair is not the nearest. The least clearance is
always measured without such data. Of several pairs with the same clearance, the first is used. The result therefore
equals the result of a monitor without memory, to the last digit.
"""

from __future__ import annotations

from math import sqrt
from typing import Any, NamedTuple, Self

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies import pair as packed
from aftdeck.bodies.depth import greatest
from aftdeck.bodies.hexahedron import SIDES, VERTICES, place
from aftdeck.bodies.location_words import heights
from aftdeck.bodies.pair import CONTACT, PAIR
from aftdeck.bodies.pair_check import measure
from aftdeck.bodies.planes import sides
from aftdeck.bodies.pose import turned
from aftdeck.bodies.vector import dot, minus, plus, put_vector, vector_at
from aftdeck.law import large_law, law
from aftdeck.state_part import Cache
from aftdeck.worksite.watch.found import (
    CLEARANCE,
    DISTANCE,
    FEATURE_A,
    FEATURE_B,
    FOUND,
    NORMAL,
    POINT_A,
    POINT_B,
    SPEED,
    WHICH,
)
from aftdeck.worksite.watch.groups import CENTRE, POSE, RADIUS, SOLID, Layout, PackedLayout
from aftdeck.worksite.watch.motion import motion, velocity

_SLACK = 1e-9
"""Margin by which a group's bound is lowered [m]; it is more than the rounding errors."""


class Measured(NamedTuple):
    """Arrays of a `ClearanceMonitor` that the laws update; they have the names of the monitor's attributes."""

    at: Array
    placed: Array
    bound: Array
    likely: Indices
    memory: Array
    found: Array
    near: Mask


@law
def place_moved(layout: PackedLayout, frames: Array, at: Array, placed: Array) -> None:
    """Compute the positions in L of the solids whose frame has moved.

    Args:
        layout: the solids, in their own frames.
        frames: (F, 12) present poses of the frames, in L.
        at: (F, 12) poses of the frames when the solids were last placed; updated.
        placed: (n, 52) the solids in L; updated.
    """
    solids, frame = layout.solids, layout.frame
    moved = np.zeros(len(frames), np.bool_)
    for f in range(len(frames)):
        for k in range(POSE):
            if frames[f, k] != at[f, k]:
                moved[f] = True
                at[f, k] = frames[f, k]
    for i in range(len(solids)):
        f = frame[i]
        if not moved[f]:
            continue
        place(solids[i], frames[f], frames[f, 3:].reshape(3, 3), placed[i])
        put_vector(placed[i], CENTRE, plus(turned(frames[f], vector_at(solids[i], CENTRE)), vector_at(frames[f], 0)))
        placed[i, RADIUS] = solids[i, RADIUS]


@law
def travelled(frames: Array, at: Array, reach: Array, travel: Array) -> None:
    """Compute for each frame an upper bound of the displacement of its solids' points since the solids were placed.

    Args:
        frames: (F, 12) present poses of the frames, in L.
        at: (F, 12) poses of the frames when the solids were last placed, in L; NaN if the solids were never placed.
        reach: (F,) upper bound of the distance of a frame's solids from the frame's origin [m].
        travel: (F,) output: upper bounds of the displacements [m]; NaN for a frame whose solids were never placed.
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
def not_nearer(a: Array, b: Array, pair: Array, best: float) -> bool:
    """Return whether the bounding spheres or the last normal prove that two solids are not nearer than `best` [m]."""
    centres = minus(vector_at(b, CENTRE), vector_at(a, CENTRE))
    reach = best + a[RADIUS] + b[RADIUS]
    if reach < 0.0 or dot(centres, centres) > reach * reach:
        return True
    along = sides(a, b, vector_at(pair, packed.NORMAL))
    apart = along.b - along.a
    # a pair without a normal has a zero vector, for which `apart` is 0
    return apart > 0.0 and apart > best


@large_law
def nearest_pair(layout: PackedLayout, own: Measured, g: int, limit: float, measures: Array) -> int:
    """Return the pair of solids of a group that has the least clearance; of pairs with equal clearance, the first.

    Args:
        layout: the solids and the groups.
        own: arrays of the monitor. The positions of the solids are in `placed`. The search begins with the pair in
            `likely`, and `memory` is updated; neither `likely` nor `memory` affects the result.
        g: the group.
        limit: pairs that are not nearer than this are ignored [m].
        measures: (17,) output: packed measurements of the pair.

    Returns:
        Index of the pair; -1 if no pair is below the limit.
    """
    placed, pairs, memory = own.placed, layout.pairs, own.memory
    begin, end, first = layout.begins[g], layout.begins[g + 1], own.likely[g]
    best, least, found = -1, limit, np.empty(packed.PAIR)
    for visit in range(begin - 1, end):
        k = first if visit < begin else visit
        if visit == first:
            continue
        a, b = placed[pairs[k, 0]], placed[pairs[k, 1]]
        # remembered data are used only to show that a pair is not the nearest
        beyond = least + _SLACK
        if visit >= begin and (not_nearer(a, b, memory[k], beyond) or measure(a, b, memory[k]) > beyond):
            continue
        found[:] = 0.0
        clearance = measure(a, b, found)
        if visit < begin:
            memory[k] = found
        if clearance < least or (clearance == least and k < best):
            best, least = k, clearance
            measures[:] = found
    return best


@law
def watch(
    solids: Array,
    frame: Indices,
    pairs: Indices,
    begins: Indices,
    between_frames: Indices,
    reach: Array,
    active: Mask,
    counts: Mask,
    before: Array,
    now: Array,
    period: float,
    within: float,
    at: Array,
    placed: Array,
    bound: Array,
    likely: Indices,
    memory: Array,
    found: Array,
    near: Mask,
) -> None:
    """Run `measure_groups`.

    The arrays of the layout and of the monitor are separate arguments here, because Python passes separate arrays
    faster than a tuple of arrays.
    """
    layout = PackedLayout(solids, frame, pairs, begins, between_frames, reach)
    own = Measured(at, placed, bound, likely, memory, found, near)
    measure_groups(layout, own, active, counts, before, now, period, within)


@large_law
def measure_groups(
    layout: PackedLayout,
    own: Measured,
    active: Mask,
    counts: Mask,
    before: Array,
    now: Array,
    period: float,
    within: float,
) -> None:
    """Measure the active groups with clearances below `within`.

    The nearest active group with a 1 in `counts` is always measured.

    Args:
        layout: the solids and the groups.
        own: arrays of the monitor; updated.
        active: (g,) 1 for groups that are measured.
        counts: (g,) 1 for groups that count: the nearest of them is measured even if it is not nearer than `within`.
        before: (F, 12) poses of the frames one step before, in L.
        now: (F, 12) present poses of the frames, in L.
        period: time between `before` and `now` [s].
        within: clearance up to which groups are measured [m]; inf for all groups.
    """
    bound, found, between, near = own.bound, own.found, layout.between_frames, own.near
    travel = np.empty(len(now))
    travelled(now, own.at, layout.reach, travel)
    place_moved(layout, now, own.at, own.placed)
    measures = np.empty(packed.PAIR)
    least, nearest, lowest = np.inf, -1, np.inf
    for g in range(len(active)):
        bound[g] -= travel[between[g, 0]] + travel[between[g, 1]]
        close = active[g] != 0 and not bound[g] >= within
        if close:
            close = measure_group(layout, own, g, measures) < within
        if close:
            _fill(layout, own, g, before, now, period, measures)
        elif near[g] != 0:
            found[g, CLEARANCE], found[g, SPEED:], near[g] = np.inf, 0.0, 0
        if active[g] != 0 and counts[g] != 0:
            if near[g] != 0:
                least = min(least, found[g, CLEARANCE])
            if bound[g] < lowest:
                nearest, lowest = g, bound[g]
    if least < np.inf or nearest < 0:
        return
    # of groups with equal clearance use the first: the result then does not depend on where the search begins
    best = nearest
    least = measure_group(layout, own, best, measures)
    other = np.empty(packed.PAIR)
    for g in range(len(active)):
        if active[g] != 0 and counts[g] != 0 and bound[g] < least and g != nearest:
            clearance = measure_group(layout, own, g, other)
            if clearance < least or (clearance == least and g < best):
                best, least = g, clearance
                measures[:] = other
    _fill(layout, own, best, before, now, period, measures)


@law
def measure_group(layout: PackedLayout, own: Measured, g: int, measures: Array) -> float:
    """Return the clearance of group g [m]; write the measurements of its nearest pair into `measures` (17,).

    Also update `bound` and `likely`. The bound is slightly lower than the clearance. Rounding errors therefore cannot
    make the clearance less than the bound.
    """
    own.likely[g] = nearest_pair(layout, own, g, np.inf, measures)
    clearance: float = measures[packed.CLEARANCE]
    own.bound[g] = clearance - _SLACK
    return clearance


@law
def _fill(
    layout: PackedLayout, own: Measured, g: int, before: Array, now: Array, period: float, measures: Array
) -> None:
    """Write the latest measurements of a group's nearest pair, `measures` (17,), into the group's row (15,)."""
    k, row = own.likely[g], own.found[g]
    i, j = layout.pairs[k, 0], layout.pairs[k, 1]
    copy_pair(measures, row)
    own.near[g], row[WHICH] = 1, k
    if row[CLEARANCE] <= CONTACT:
        way_apart(own.placed[i], own.placed[j], row)
    a, b = layout.frame[i], layout.frame[j]
    va = velocity(now[a], motion(before[a], now[a], period), vector_at(row, POINT_A))
    vb = velocity(now[b], motion(before[b], now[b], period), vector_at(row, POINT_B))
    row[SPEED] = dot(vector_at(row, NORMAL), minus(va, vb))


@law
def copy_pair(pair: Array, row: Array) -> None:
    """Copy clearance, points, plane and features of a pair from its measurements (17,) into its group's row (15,)."""
    row[CLEARANCE] = pair[packed.CLEARANCE]
    put_vector(row, POINT_A, vector_at(pair, packed.POINT_A))
    put_vector(row, POINT_B, vector_at(pair, packed.POINT_B))
    put_vector(row, NORMAL, vector_at(pair, packed.NORMAL))
    row[DISTANCE] = pair[packed.DISTANCE]
    row[FEATURE_A], row[FEATURE_B] = pair[packed.FEATURE_A], pair[packed.FEATURE_B]


@law
def way_apart(a: Array, b: Array, row: Array) -> None:
    """Write a plane for two solids in contact into a group's row.

    The plane is perpendicular to the shortest move that separates the solids, halfway between their closest points.
    """
    above_b, above_a = np.empty((SIDES, VERTICES)), np.empty((SIDES, VERTICES))
    heights(a, b, above_b)
    heights(b, a, above_a)
    out = greatest(a, b, above_b, above_a).normal
    put_vector(row, NORMAL, out)
    row[DISTANCE] = 0.5 * dot(out, plus(vector_at(row, POINT_A), vector_at(row, POINT_B)))


@law
def minimum_clearance_group(found: Array, near: Mask, counts: Mask) -> int:
    """Return the group of least clearance among groups with a 1 in `counts` (g,); -1 if none of these was measured."""
    best, least = -1, np.inf
    for g in range(len(near)):
        if near[g] != 0 and counts[g] != 0 and found[g, CLEARANCE] < least:
            best, least = g, found[g, CLEARANCE]
    return best


class ClearanceMonitor(Cache):
    """Clearance monitor: measures the groups of a layout, and remembers data that make the next measurement faster.

    The measurements depend only on the poses of the frames, not on the remembered data.

    Attributes:
        layout: the solids and the groups.
        active: (g,) 1 for groups that are measured; the caller sets it.
        counts: (g,) 1 for groups that count in the search for the nearest group; the caller sets it.
        found: (g, 15) the last measurements, rows as in `worksite.watch.found`.
        near: (g,) 1 for groups whose clearance in `found` is finite.
        likely: (g,) nearest pair of each group at its last measurement.
        memory: (m, 17) remembered data of each pair of solids.
        at: (F, 12) poses of the frames at the last measurement, in L.
        placed: (n, 52) the solids at these poses, in L.
        bound: (g,) lower bound of each group's clearance at these poses [m].
        least: lower bound of the clearances in `found` [m].
        packed: the arrays that the laws update.
    """

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self.active = np.ones(len(layout.groups), np.uint8)
        self.counts = self.active.copy()
        self.found = np.zeros((len(layout.groups), FOUND))
        self.found[:, CLEARANCE] = np.inf
        self.likely = np.empty(len(layout.groups), np.int64)
        self.memory = np.empty((len(layout.pairs), PAIR))
        self.bound = np.empty(len(layout.groups))
        self.at = np.empty((len(layout.frames), POSE))
        self.placed = np.zeros((len(layout.solids), SOLID))
        self.near = np.zeros(len(layout.groups), np.uint8)
        self.least = -np.inf
        self.pack()
        self.forget()

    def pack(self) -> None:
        """Set `packed` to the present arrays."""
        own = Measured(self.at, self.placed, self.bound, self.likely, self.memory, self.found, self.near)
        self.packed: tuple[Any, Any, Any, Any, Any, Any, Any] = own

    def forget(self) -> None:
        """Discard the remembered data. This does not change the result of the next measurement."""
        self.likely[:] = self.layout.begins[:-1]
        self.memory[:] = 0.0
        self.bound[:] = -np.inf
        self.at[:] = np.nan

    def update(self, before: Array, now: Array, period: float) -> None:
        """Measure all active groups and write the results into `found`; other groups get the clearance inf in `found`.

        Args:
            before: (F, 12) poses of the frames one step before, in L; equal to `now` if there was no step before.
            now: (F, 12) present poses of the frames, in L.
            period: time between `before` and `now` [s].
        """
        self.look_near(before, now, period, self.active, np.inf)

    def look_near(self, before: Array, now: Array, period: float, counts: Mask, within: float) -> None:
        """Measure the active groups that are nearer than `within` [m]; in `found`, other groups get the clearance inf.

        The nearest active group with a 1 in `counts` (g,) is measured even if it is not nearer than `within`. The other
        arguments are those of `update`.
        """
        self.least = -np.inf
        watch(*self.layout.packed, self.active, counts, before, now, period, within, *self.packed)

    def nearest(self, counts: Mask) -> int:
        """Return the group of least clearance among groups with a 1 in `counts` (g,); -1 if none was measured."""
        return minimum_clearance_group(self.found, self.near, counts)

    def copied(self) -> Self:
        """Return a copy of the monitor with the same measurements and remembered data."""
        copy = type(self)(self.layout)
        copy.active[:], copy.counts[:] = self.active, self.counts
        for own, array in zip(copy.packed, self.packed, strict=True):
            own[:] = array
        return copy
