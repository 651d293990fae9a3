"""The dynamic collision program: it measures the clearance of every group (monitored pair of parts) in every step.

Source: Remote Manipulator Simulation, final report, chapter IV. In each step, the report's program examined three
hexahedra and one body; this program examines all parts that can touch. For each group, the last measurement and the
later motion of the two parts' frames give a lower bound of the clearance. A group is measured again only if its bound
is too small to exclude the group from the result.

The groups with small bounds are *listed*. While no other group can be near, or be the nearest, a step examines only
the listed groups; otherwise all groups are examined, and listed again.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies import pair as packed
from aftdeck.bodies.depth import greatest
from aftdeck.bodies.hexahedron import SIDES, VERTICES
from aftdeck.bodies.location_words import heights
from aftdeck.bodies.pair import CONTACT, PAIR
from aftdeck.bodies.vector import dot, plus, put_vector, vector_at
from aftdeck.law import law
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
    WHICH,
)
from aftdeck.worksite.watch.groups import POSE, SOLID, Layout, LayoutArrays, PackedLayout, layout_from
from aftdeck.worksite.watch.measured import (
    NEVER,
    Measured,
    MeasuredArrays,
    follow,
    lower_bound,
    lower_bounds,
    measure_group,
    measured_of,
    place_which,
)

ROOM = 0.25
"""How much a group's bound may exceed the limit below which it matters, and the group is listed [m] (assumed): with
less, groups are listed again sooner; with more, each step examines more of them."""
FAR = 10.0
"""Sum of a frame's motions after which all bounds are lowered by them, and the sums begin at 0 again [m] (assumed)."""


@law
def watch(
    layout: LayoutArrays,
    active: Mask,
    counts: Mask,
    now: Array,
    within: float,
    own: MeasuredArrays,
) -> None:
    """Run `measure_groups`."""
    measure_groups(layout_from(layout), measured_of(own), active, counts, now, within)


@law
def measure_groups(
    layout: PackedLayout,
    own: Measured,
    active: Mask,
    counts: Mask,
    now: Array,
    within: float,
) -> bool:
    """Measure the active groups with clearances below `within`.

    The nearest active group with a 1 in `counts` is always measured.

    Args:
        layout: the solids and the groups.
        own: arrays of the monitor; updated.
        active: (g,) 1 for groups that are measured.
        counts: (g,) 1 for groups that count: the nearest of them is measured even if it is not nearer than `within`.
        now: (F, 12) present poses of the frames, in L.
        within: clearance up to which groups are measured [m]; inf for all groups.

    Returns:
        Whether groups that are not listed may have been near before.
    """
    follow(layout, own, now)
    most = greatest_approach(own.moved, own.moved_then)
    every = own.beyond[2] != within or have_moved_far(own)
    every = every or not (own.beyond[0] - most >= within and same_groups(own, active, counts))
    while True:
        if every:
            list_all(layout, own, active, counts)
        least = measure_listed(layout, own, active, counts, within)
        if every:
            shorten_list(layout, own, active, counts, max(within, least if least < np.inf else 0.0) + ROOM)
            own.beyond[2] = within
            return True
        every = own.beyond[1] < np.inf and not own.beyond[1] - most > least
        if not every:
            return False


@law
def list_all(layout: PackedLayout, own: Measured, active: Mask, counts: Mask) -> None:
    """List all groups."""
    if have_moved_far(own):
        lower_bounds(layout, own)
    own.moved_then[:] = own.moved
    groups = len(active)
    for g in range(groups):
        own.listed[g], own.reviewed[g], own.reviewed[groups + g] = g, active[g], counts[g]
    own.listed[groups] = groups


@law
def have_moved_far(own: Measured) -> bool:
    """Return whether the motions of a frame add up to more than `FAR`."""
    far = False
    for f in range(len(own.moved)):
        far = far or own.moved[f] > FAR
    return far


@law
def same_groups(own: Measured, active: Mask, counts: Mask) -> bool:
    """Return whether the same groups are active and count as when the groups were listed."""
    changed, groups = 0, len(active)
    for g in range(groups):
        changed |= (own.reviewed[g] ^ active[g]) | (own.reviewed[groups + g] ^ counts[g])
    return changed == 0


@law
def greatest_approach(moved: Array, moved_then: Array) -> float:
    """Return the distance by which two parts may have approached each other [m], from `moved` (F,) now and before."""
    first, second = 0.0, 0.0
    for f in range(len(moved)):
        by = moved[f] - moved_then[f]
        if by > first:
            first, second = by, first
        elif by > second:
            second = by
    return first + second


@law
def measure_listed(layout: PackedLayout, own: Measured, active: Mask, counts: Mask, within: float) -> float:
    """Measure the listed groups, as `measure_groups` does for all; return the least clearance of those that count [m].

    It is inf if none of them counts.
    """
    found, near, listed = own.found, own.near, own.listed
    count, measures = listed[len(active)], np.empty(packed.PAIR)
    least, nearest, lowest = np.inf, -1, np.inf
    for m in range(count):
        g = listed[m]
        close = active[g] != 0 and not lower_bound(layout, own, g) >= within
        if close:
            close = measure_group(layout, own, g, measures) < within
        if close:
            _fill(layout, own, g, measures)
        elif near[g] != 0:
            found[g, CLEARANCE], found[g, POINT_A:], near[g] = np.inf, 0.0, 0
        if active[g] != 0 and counts[g] != 0:
            if near[g] != 0:
                least = min(least, found[g, CLEARANCE])
            bound = lower_bound(layout, own, g)
            if bound < lowest:
                nearest, lowest = g, bound
    if least < np.inf or nearest < 0:
        return least
    # of groups with equal clearance use the first: the result then does not depend on where the search begins
    best, other = nearest, np.empty(packed.PAIR)
    for m in range(-1, count):
        g = nearest if m < 0 else listed[m]
        if m >= 0 and (active[g] == 0 or counts[g] == 0 or g == nearest or lower_bound(layout, own, g) >= least):
            continue
        clearance = measure_group(layout, own, g, other)
        if clearance < least or (clearance == least and g < best):
            best, least = g, clearance
            measures[:] = other
    _fill(layout, own, best, measures)
    return least


@law
def shorten_list(layout: PackedLayout, own: Measured, active: Mask, counts: Mask, limit: float) -> None:
    """List the groups whose bounds are below `limit` [m], and those that are near."""
    count, beyond, counting = 0, np.inf, np.inf
    for g in range(len(active)):
        if active[g] == 0:
            continue
        bound = lower_bound(layout, own, g)
        if own.near[g] != 0 or bound < limit:
            own.listed[count] = g
            count += 1
        else:
            beyond = min(beyond, bound)
            if counts[g] != 0:
                counting = min(counting, bound)
    own.listed[len(active)], own.beyond[0], own.beyond[1] = count, beyond, counting


@law
def _fill(layout: PackedLayout, own: Measured, g: int, measures: Array) -> None:
    """Write the latest measurements of a group's nearest pair, `measures` (17,), into the group's row (14,)."""
    k, row = own.likely[g], own.found[g]
    i, j = layout.pairs[k, 0], layout.pairs[k, 1]
    copy_pair(measures, row)
    own.near[g], row[WHICH] = 1, k
    if row[CLEARANCE] <= CONTACT:
        way_apart(own.placed[i], own.placed[j], row)


@law
def copy_pair(pair: Array, row: Array) -> None:
    """Copy clearance, points, plane and features of a pair from its measurements (17,) into its group's row (14,)."""
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
        found: (g, 14) the last measurements, rows as in `worksite.watch.found`.
        near: (g,) 1 for groups whose clearance in `found` is finite.
        likely: (g,) nearest pair of each group at its last measurement.
        memory: (m, 17) remembered data of each pair of solids.
        at: (F, 12) poses of the frames at the last measurement, in L.
        solids: (n, 52) the solids in L; those that were needed are at these poses.
        least: lower bound of the clearances in `found` [m].
        packed: the arrays that the laws update; `bound` to `reviewed` are described in `Measured`.
    """

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self.active = np.ones(len(layout.groups), np.uint8)
        self.counts = self.active.copy()
        self.found = np.zeros((len(layout.groups), FOUND))
        self.found[:, CLEARANCE] = np.inf
        groups, solids, frames = len(layout.groups), len(layout.solids), len(layout.frames)
        self.likely, self.listed = np.empty(groups, np.int64), np.zeros(groups + 1, np.int64)
        self.memory, self.pair_bound = np.empty((len(layout.pairs), PAIR)), np.empty(len(layout.pairs))
        self.bound, self.beyond = np.empty(groups), np.empty(3)
        self.moved, self.moved_then = np.empty(frames), np.empty(frames)
        self.at, self.solids = np.full((frames, POSE), np.nan), np.zeros((solids, SOLID))
        self.moves, self.placed_after = np.zeros(frames, np.int64), np.full(solids, NEVER, np.int64)
        self.near, self.reviewed = np.zeros(groups, np.uint8), np.zeros(2 * groups, np.uint8)
        self.least = -np.inf
        self.pack()
        self.forget()

    def pack(self) -> None:
        """Set `packed` to the present arrays."""
        self.packed: MeasuredArrays = (
            self.at, self.solids, self.bound, self.moved, self.moved_then, self.beyond, self.pair_bound, self.memory,
            self.found, self.likely, self.moves, self.placed_after, self.listed, self.near, self.reviewed,
        )  # fmt: skip

    @property
    def placed(self) -> Array:
        """The solids (n, 52) at the poses of the last measurement, in L."""
        return self.place(self.layout.all_solids)

    def place(self, which: Indices) -> Array:
        """Place the solids `which` (k,) at the poses of the last measurement; return all solids, as in `Placing`."""
        place_which(self.layout.arrays, self.packed, which)
        return self.solids

    def forget(self) -> None:
        """Discard the remembered data. This changes neither where the solids are nor the result of a measurement."""
        self.likely[:] = self.layout.begins[:-1]
        self.memory[:] = 0.0
        self.bound[:] = self.pair_bound[:] = self.beyond[:] = -np.inf
        self.moved[:] = self.moved_then[:] = 0.0

    def update(self, now: Array) -> None:
        """Measure all active groups and write the results into `found`; other groups get the clearance inf in `found`.

        `now`: (F, 12) present poses of the frames, in L.
        """
        self.look_near(now, self.active, np.inf)

    def look_near(self, now: Array, counts: Mask, within: float) -> None:
        """Measure the active groups that are nearer than `within` [m]; in `found`, other groups get the clearance inf.

        The nearest active group with a 1 in `counts` (g,) is measured even if it is not nearer than `within`. `now` as
        for `update`.
        """
        self.least = -np.inf
        watch(self.layout.arrays, self.active, counts, now, within, self.packed)

    def nearest(self, counts: Mask) -> int:
        """Return the group of least clearance among groups with a 1 in `counts` (g,); -1 if none was measured."""
        return minimum_clearance_group(self.found, self.near, counts)

    def copied(self) -> Self:
        """Return a copy of the monitor with the same measurements and remembered data."""
        copy = type(self)(self.layout)
        copy.active[:], copy.counts[:] = self.active, self.counts
        own: Sequence[NDArray[Any]] = copy.packed
        for array, other in zip(own, self.packed, strict=True):
            array[...] = other
        return copy
