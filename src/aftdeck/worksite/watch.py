"""The dynamic collision program in flight: every watched group, frame after frame.

Remote Manipulator Simulation, final report, chapter IV. Its program looked at three hexahedra and one body a frame;
here are all parts that can meet. Of each group it is known how near it can be at most, from when it was measured last
and from how far its two frames have moved since; it is measured again when that is nearer than matters.

What is remembered of a pair only rules it out: where the least clearance is, is measured from nothing, and of equals
the first is taken. So the answer is that of a watch that remembers nothing, to the last digit.
"""

from __future__ import annotations

from math import sqrt
from typing import Self

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies import pair as packed
from aftdeck.bodies.depth import greatest
from aftdeck.bodies.hexahedron import SIDES, VERTICES, place
from aftdeck.bodies.pair import CONTACT, PAIR
from aftdeck.bodies.planes import sides
from aftdeck.bodies.watch import measure
from aftdeck.bodies.words import heights
from aftdeck.law import law
from aftdeck.state_part import Cache
from aftdeck.worksite.found import (
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
from aftdeck.worksite.layout import CENTRE, POSE, RADIUS, SOLID, Layout
from aftdeck.worksite.motion import motion, velocity

_SLACK = 1e-9
"""By how much a group is taken to be nearer than it can be [m]: more than rounding takes off."""


@law
def place_moved(solids: Array, frame: Indices, frames: Array, at: Array, placed: Array) -> None:
    """Place the solids whose frame is not where it was.

    Args:
        solids: (n, 52) in their own frames.
        frame: (n,) which frame each stands in.
        frames: (F, 12) where the frames are, in L.
        at: (F, 12) where they were when the solids were placed; brought up to date.
        placed: (n, 52) the solids in L, brought up to date.
    """
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
        r = frames[f, 3:].reshape(3, 3)
        place(solids[i], frames[f], r, placed[i])
        x, y, z = solids[i, CENTRE], solids[i, CENTRE + 1], solids[i, CENTRE + 2]
        placed[i, CENTRE] = r[0, 0] * x + r[0, 1] * y + r[0, 2] * z + frames[f, 0]
        placed[i, CENTRE + 1] = r[1, 0] * x + r[1, 1] * y + r[1, 2] * z + frames[f, 1]
        placed[i, CENTRE + 2] = r[2, 0] * x + r[2, 1] * y + r[2, 2] * z + frames[f, 2]
        placed[i, RADIUS] = solids[i, RADIUS]


@law
def travelled(frames: Array, at: Array, reach: Array, ways: Array) -> None:
    """How far any point of a frame's solids has come, at most, from where the frame was placed last: into ways (F,).

    Args:
        frames: (F, 12) where the frames are, in L.
        at: (F, 12) where they were.
        reach: (F,) how far from its frame's origin a solid reaches [m].
        ways: (F,) out [m]; NaN from nowhere.
    """
    for f in range(len(frames)):
        origin, turn = 0.0, 0.0
        for k in range(3):
            origin += (frames[f, k] - at[f, k]) ** 2
        for k in range(3, POSE):
            turn += (frames[f, k] - at[f, k]) ** 2
        # of a difference of two rotations the spectral norm is the Frobenius norm over the root of 2
        ways[f] = sqrt(origin) + sqrt(0.5 * turn) * reach[f]


@law
def not_nearer(a: Array, b: Array, pair: Array, best: float) -> bool:
    """Whether two solids cannot be nearer than `best` [m]: by their spheres, or along the pair's last normal."""
    x, y, z = b[CENTRE] - a[CENTRE], b[CENTRE + 1] - a[CENTRE + 1], b[CENTRE + 2] - a[CENTRE + 2]
    reach = best + a[RADIUS] + b[RADIUS]
    if reach < 0.0 or x * x + y * y + z * z > reach * reach:
        return True
    along = sides(a, b, pair[packed.NORMAL], pair[packed.NORMAL + 1], pair[packed.NORMAL + 2])
    apart = along.b - along.a
    # a pair without a normal has zeros there, and 0 between its sides
    return apart > 0.0 and apart > best


@law
def nearest_pair(
    placed: Array, pairs: Indices, memory: Array, begin: int, end: int, first: int, limit: float, told: Array
) -> int:
    """Which of a group's pairs of solids, `begin` up to `end`, has the least clearance; of equals, the first.

    Args:
        placed: (n, 52) the solids.
        pairs: (m, 2) of the layout.
        memory: (m, 17) what is remembered of each pair, brought up to date; it changes no answer.
        begin: see above.
        end: see above.
        first: the pair that is likely to have it.
        limit: what is not nearer is not looked for [m].
        told: (17,) out, what was measured of that pair, packed.

    Returns:
        The pair; -1 where none is below the limit.
    """
    least = limit
    for turn in range(begin - 1, end):
        k = first if turn < begin else turn
        a, b = placed[pairs[k, 0]], placed[pairs[k, 1]]
        if turn != first and not not_nearer(a, b, memory[k], least):
            least = min(least, measure(a, b, memory[k]))
    # only what may be the nearest is measured from nothing
    best, own = -1, np.empty(packed.PAIR)
    nearest, beyond = limit, least + _SLACK
    for k in range(begin, end):
        a, b = placed[pairs[k, 0]], placed[pairs[k, 1]]
        if not not_nearer(a, b, memory[k], beyond):
            own[:] = 0.0
            clearance = measure(a, b, own)
            if clearance < nearest:
                best, nearest = k, clearance
                told[:] = own
    return best


@law
def watch(
    solids: Array,
    frame: Indices,
    pairs: Indices,
    begins: Indices,
    between: Indices,
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
) -> None:
    """Look at the groups that count: at all that are nearer than `within`, and where none is, at the nearest.

    Args:
        solids: (n, 52), frame (n,), pairs (m, 2), begins (g + 1,), between (g, 2), reach (F,): of the layout.
        frame: see solids.
        pairs: see solids.
        begins: see solids.
        between: see solids.
        reach: see solids.
        active: (g,) 1 where the group is looked at.
        counts: (g,) 1 for groups of which one may be the nearest.
        before: (F, 12) the frames a step ago, in L.
        now: (F, 12) the frames now.
        period: from then till now [s].
        within: how far groups are looked at [m]; inf: all.
        at: (F, 12) where frames were when placed, and
        placed: (n, 52) solids in L, and
        bound: (g,) how near the groups can be at most [m], all three brought up to date.
        likely: (g,) which pair of each group was the nearest when it was measured last, and
        memory: (m, 17) what is remembered of each pair, both brought up to date.
        found: (g, 15) out.
    """
    ways, motions = np.empty(len(now)), np.empty((len(now), 6))
    travelled(now, at, reach, ways)
    place_moved(solids, frame, now, at, placed)
    for f in range(len(now)):
        m = motion(before[f], now[f], period)
        for k in range(6):
            motions[f, k] = m[k]
    told = np.empty(packed.PAIR)
    least, nearest, lowest = np.inf, -1, np.inf
    for g in range(len(active)):
        bound[g] -= ways[between[g, 0]] + ways[between[g, 1]]
        near = active[g] != 0 and not bound[g] >= within
        if near:
            near = _measured(placed, pairs, begins, g, bound, likely, memory, told) < within
        if near:
            _tell(placed, frame, pairs, now, motions, likely[g], told, found[g])
        elif found[g, CLEARANCE] < np.inf:
            found[g, CLEARANCE], found[g, SPEED:] = np.inf, 0.0
        if active[g] != 0 and counts[g] != 0:
            least = min(least, found[g, CLEARANCE])
            if bound[g] < lowest:
                nearest, lowest = g, bound[g]
    if least < np.inf or nearest < 0:
        return
    # of equals the first, wherever the search begins
    best = nearest
    least = _measured(placed, pairs, begins, best, bound, likely, memory, told)
    other = np.empty(packed.PAIR)
    for g in range(len(active)):
        if active[g] != 0 and counts[g] != 0 and bound[g] < least and g != nearest:
            clearance = _measured(placed, pairs, begins, g, bound, likely, memory, other)
            if clearance < least or (clearance == least and g < best):
                best, least = g, clearance
                told[:] = other
    _tell(placed, frame, pairs, now, motions, likely[best], told, found[best])


@law
def _measured(
    placed: Array, pairs: Indices, begins: Indices, g: int, bound: Array, likely: Indices, memory: Array, told: Array
) -> float:
    """The clearance of group g [m], and in `told` (17,) the pair that has it; bound and likely are brought up to date.

    The bound is a little lower: what is not below it is farther apart to the last digit.
    """
    likely[g] = nearest_pair(placed, pairs, memory, begins[g], begins[g + 1], likely[g], np.inf, told)
    clearance: float = told[packed.CLEARANCE]
    bound[g] = clearance - _SLACK
    return clearance


@law
def _tell(
    placed: Array, frame: Indices, pairs: Indices, now: Array, motions: Array, k: int, told: Array, row: Array
) -> None:
    """Write what was just measured of pair k, told (17,), into its group's row (15,)."""
    i, j = pairs[k, 0], pairs[k, 1]
    copy_pair(told, row)
    row[WHICH] = k
    if row[CLEARANCE] <= CONTACT:
        way_apart(placed[i], placed[j], row)
    va = velocity(now, motions, frame[i], row[POINT_A], row[POINT_A + 1], row[POINT_A + 2])
    vb = velocity(now, motions, frame[j], row[POINT_B], row[POINT_B + 1], row[POINT_B + 2])
    row[SPEED] = row[NORMAL] * (va[0] - vb[0]) + row[NORMAL + 1] * (va[1] - vb[1]) + row[NORMAL + 2] * (va[2] - vb[2])


@law
def copy_pair(pair: Array, row: Array) -> None:
    """Copy what was measured of a pair, packed (17,), into its group's row (15,)."""
    row[CLEARANCE] = pair[packed.CLEARANCE]
    for c in range(3):
        row[POINT_A + c] = pair[packed.POINT_A + c]
        row[POINT_B + c] = pair[packed.POINT_B + c]
        row[NORMAL + c] = pair[packed.NORMAL + c]
    row[DISTANCE] = pair[packed.DISTANCE]
    row[FEATURE_A], row[FEATURE_B] = pair[packed.FEATURE_A], pair[packed.FEATURE_B]


@law
def way_apart(a: Array, b: Array, row: Array) -> None:
    """Write the plane of two solids in contact into their group's row."""
    above_b, above_a = np.empty((SIDES, VERTICES)), np.empty((SIDES, VERTICES))
    heights(a, b, above_b)
    heights(b, a, above_a)
    out = greatest(a, b, above_b, above_a)
    row[NORMAL], row[NORMAL + 1], row[NORMAL + 2] = out.x, out.y, out.z
    row[DISTANCE] = 0.5 * (
        out.x * (row[POINT_A] + row[POINT_B])
        + out.y * (row[POINT_A + 1] + row[POINT_B + 1])
        + out.z * (row[POINT_A + 2] + row[POINT_B + 2])
    )


@law
def nearest_group(found: Array, counts: Mask) -> int:
    """The group of least clearance among those with a 1 in `counts` (g,); -1 where none of them is active."""
    best, least = -1, np.inf
    for g in range(len(found)):
        if counts[g] != 0 and found[g, CLEARANCE] < least:
            best, least = g, found[g, CLEARANCE]
    return best


class Watch(Cache):
    """The watched groups of a flight.

    What it has found follows from where everything is; what it remembers makes the next look quicker.

    Attributes:
        layout: what is watched.
        active: (g,) 1 where a group counts; the caller sets it.
        counts: (g,) 1 for groups of which the next look finds the nearest; the caller sets it.
        found: (g, 15) what the last look found, as `worksite.found` says.
        likely: (g,) which pair of each group was the nearest when it was measured last.
        memory: (m, 17) what is remembered of each pair of solids.
        at: (F, 12) where the frames were at the last look, in L.
        placed: (n, 52) the solids there, in L.
        bound: (g,) how near each group can have been there, at most [m].
        packed: the last of the arguments of `watch`.
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
        self.packed = self.at, self.placed, self.bound, self.likely, self.memory, self.found
        self.forget()

    def forget(self) -> None:
        """Remember nothing of what was looked at; the next look finds what it would have found."""
        self.likely[:] = self.layout.begins[:-1]
        self.memory[:] = 0.0
        self.bound[:] = -np.inf
        self.at[:] = np.nan

    def look(self, before: Array, now: Array, period: float) -> None:
        """Look at every group that is active, into `found`; the others are inf there.

        Args:
            before: (F, 12) the frames a step ago, in L; those of now, where nothing came before.
            now: (F, 12) the frames now.
            period: from then till now [s].
        """
        self.look_near(before, now, period, self.active, np.inf)

    def look_near(self, before: Array, now: Array, period: float, counts: Mask, within: float) -> None:
        """Look at the active groups that are nearer than `within`; the others are inf in `found`.

        Where none with a 1 in `counts` (g,) is so near, the nearest of those is looked at as well. Else as `look`.
        """
        watch(*self.layout.packed, self.active, counts, before, now, period, within, *self.packed)

    def nearest(self, counts: Mask) -> int:
        """The group of least clearance among those with a 1 in `counts` (g,); -1 where none of them is active."""
        return nearest_group(self.found, counts)

    def copied(self) -> Self:
        """Another watch that goes on from here."""
        copy = type(self)(self.layout)
        copy.active[:], copy.counts[:] = self.active, self.counts
        for own, array in zip(copy.packed, self.packed, strict=True):
            own[:] = array
        return copy
