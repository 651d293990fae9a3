"""Order of the clusters in one picture: which one hides which, and the priority output table.

Two clusters are compared only if their outlines in the picture overlap: a plane between the two shows which one is
nearer to the eye. Comparing all clusters would give cycles where there is nothing to hide. The report's program traced
permanent lists and trees of planes; the result is the same (`visual.lists`).

Source: Remote Manipulator Simulation, final report, chapter V: visual priority, separating planes, and the priority
output table (POT).
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.law import law
from aftdeck.visual.cutting import CROSSED, FULL, part_of, position_of
from aftdeck.visual.outlines import outcodes, outline, overlap, touches_eye
from aftdeck.visual.placing import place, remembered, separated, trim
from aftdeck.visual.planes import TOLERANCE, best_plane, extent
from aftdeck.visual.store import Store

OVER, UNDER, NEITHER = 1, -1, 0
"""Results of a comparison: the first polyhedron hides the second, the second hides the first, or neither."""
SLACK = 1e-9
"""Overlap of two outlines that does not count, as a tangent of an angle of view: much less than a pixel."""
MOST_CUTS = 64
"""Greatest number of cuts in one picture."""
INSIDE, TOO_MANY, UNORDERED = -1, -2, -3
"""Results of `ordered` for pictures that cannot be drawn: the eye is inside a cluster; there is no space for the pieces;
the number of cuts is not enough."""
CUTS, OVERLAPS, FIRST, SECOND, COMPARED = range(5)
"""Indices in the notes (5,) of `ordered`: number of cuts; number of pairs that overlap in space; clusters of the first
such pair, or the cluster that contains the eye; number of compared pairs."""


@law
def ordered(
    store: Store,
    frame: Indices,
    trims: Indices,
    poses: Array,
    shown: Mask,
    wide: float,
    high: float,
    placed: Store,
    normals: Array,
    outlines: Array,
    hides: Array,
    table: Indices,
    notes: Indices,
) -> int:
    """Write the priority output table of a picture: its polyhedra, highest priority first.

    Args:
        store: the clusters, each in its own frame.
        frame: (N,) frame of each cluster.
        trims: (T, 2) pairs of clusters: the second is removed from the first.
        poses: (F, 12) poses of the frames in the coordinates of the camera: x right, y down, z ahead.
        shown: (N,) 1 for each cluster that can be in the picture.
        wide: tangent of half the horizontal field of view.
        high: tangent of half the vertical field of view.
        placed: store with the same clusters and free space; output: the clusters and their pieces in the coordinates
            of the camera.
        normals: (N, N, 3) normals of the last separating planes; updated.
        outlines: (E, MOST_POINTS, 2) for the work.
        hides: (E, E) for the work.
        table: (E,) output: polyhedra of `placed`, highest priority first.
        notes: (5,) output: numbers and clusters to report.

    Returns:
        Number of polyhedra in the picture; INSIDE, TOO_MANY or UNORDERED if there is no picture.
    """
    notes[:] = 0
    place(store, frame, poses, placed)
    count = trim(placed, trims, shown, normals, poses, frame, table)
    if count == FULL:
        return TOO_MANY
    sizes, new, done = np.zeros(len(table), np.int64), np.ones(len(table), np.bool_), np.empty(len(table), np.int64)
    while True:
        count = _outlined(placed, table, count, new, wide, high, outlines, sizes, notes)
        if count < 0:
            return count
        for a in range(count):
            hides[a, a] = 0
            for b in range(a):
                if new[a] or new[b]:
                    hides[a, b], hides[b, a] = 0, 0
                    _compare(placed, table, a, b, outlines, sizes, normals, poses, frame, hides, notes)
        new[:] = False
        if _sorted(hides, count, done) == count:
            break
        if notes[CUTS] == MOST_CUTS:
            return UNORDERED
        entry, part = _cut(placed, table, hides, count)
        if entry < 0:
            return UNORDERED
        if part < 0 or count == len(table):
            return TOO_MANY
        notes[CUTS] += 1
        # one part of the cut polyhedron has taken its entry in the table; the other part becomes the last entry
        table[count] = part
        new[entry], new[count] = True, True
        count += 1
    drawn = 0
    for i in range(count):
        if sizes[done[i]] > 0:
            done[drawn] = table[done[i]]
            drawn += 1
    for i in range(drawn):
        table[i] = done[drawn - 1 - i]
    return drawn


@law
def _outlined(
    placed: Store,
    table: Indices,
    count: int,
    new: Mask,
    wide: float,
    high: float,
    outlines: Array,
    sizes: Indices,
    notes: Indices,
) -> int:
    """Find the outlines of the new entries of the table.

    At first, all entries are new, and those that are not in the picture are left out. Later, the parts of a cut
    polyhedron are new; a part that is not in the picture keeps its entry, with an outline of size 0.

    Returns:
        Number of entries; INSIDE or TOO_MANY if there is no picture.
    """
    kept = 0
    for n in range(count):
        k = table[n]
        if new[n]:
            every, some = outcodes(placed, k, wide, high)
            size = 0
            if every == 0:
                if touches_eye(placed, k):
                    notes[FIRST] = placed.owner[k]
                    return INSIDE
                size = outline(placed, k, some != 0, wide, high, outlines[kept])
                if size == FULL:
                    return TOO_MANY
            if size == 0 and notes[CUTS] == 0:
                continue
            sizes[kept] = size
        table[kept] = k
        kept += 1
    return kept


@law
def _compare(
    placed: Store,
    table: Indices,
    a: int,
    b: int,
    outlines: Array,
    sizes: Indices,
    normals: Array,
    poses: Array,
    frame: Indices,
    hides: Array,
    notes: Indices,
) -> None:
    """Fill `hides` for entries `a` and `b` of the table: OVER in [a, b] if the first has to be drawn over the second."""
    if sizes[a] == 0 or sizes[b] == 0:
        return
    if not overlap(outlines[a], sizes[a], outlines[b], sizes[b], SLACK):
        return
    i, j = table[a], table[b]
    p, q = placed.owner[i], placed.owner[j]
    if p > q:
        a, b, i, j, p, q = b, a, j, i, q, p
    notes[COMPARED] += 1
    if not separated(placed, i, j, normals, poses, frame):
        if notes[OVERLAPS] == 0:
            notes[FIRST], notes[SECOND] = p, q
        notes[OVERLAPS] += 1
    along = extent(placed, i, j, remembered(normals, p, q, poses, frame))
    result = NEITHER
    if along.a <= along.b:
        if along.b <= 0.0:
            result = UNDER
        elif along.a >= 0.0:
            result = OVER
    else:
        result = UNDER if along.a + along.b < 0.0 else OVER
    if result == OVER:
        hides[a, b] = 1
    elif result == UNDER:
        hides[b, a] = 1


@law
def _sorted(hides: Array, count: int, done: Indices) -> int:
    """Write entries of the table into `done`, each after all entries that it hides; return how many could be written.

    The number is less than `count` if there are cycles.
    """
    under = np.zeros(count, np.int64)
    for a in range(count):
        for b in range(count):
            under[a] += hides[a, b]
    written, at = 0, 0
    for a in range(count):
        if under[a] == 0:
            done[written] = a
            written += 1
    while at < written:
        b = done[at]
        at += 1
        for a in range(count):
            if hides[a, b]:
                under[a] -= 1
                if under[a] == 0:
                    done[written] = a
                    written += 1
    return written


@law
def _shortest_cycle(hides: Array, count: int, cycle: Indices) -> int:
    """Write the entries of a shortest cycle into `cycle`, each hidden by the following one; return their number."""
    length = count + 1
    before, distance, queue = np.empty(count, np.int64), np.empty(count, np.int64), np.empty(count, np.int64)
    for start in range(count):
        distance[:] = -1
        distance[start], queue[0] = 0, start
        at, end = 0, 1
        while at < end:
            b = queue[at]
            at += 1
            if distance[b] + 1 >= length:
                break
            if hides[start, b]:
                length = distance[b] + 1
                entry = b
                for k in range(length):
                    cycle[length - 1 - k] = entry
                    entry = before[entry]
                break
            for a in range(count):
                if hides[a, b] and distance[a] < 0:
                    distance[a], before[a] = distance[b] + 1, b
                    queue[end] = a
                    end += 1
    return length if length <= count else 0


@law
def _cut(placed: Store, table: Indices, hides: Array, count: int) -> tuple[int, int]:
    """Cut one polyhedron of a shortest cycle by the plane between two neighbours in the cycle.

    On the way round the cycle from the farther to the nearer of the two, some polyhedron is on both sides of the plane:
    nothing behind the plane can hide anything before it. Of all such planes, the one that cuts the fewest is used.

    Returns:
        Entry of the polyhedron, which becomes one of the two parts, and the other part; the part is FULL if there is no
        space.
    """
    cycle = np.empty(count, np.int64)
    length = _shortest_cycle(hides, count, cycle)
    fewest, entry = count + 1, -1
    plane, best = np.empty(4), np.empty(4)
    for s in range(length):
        i, j = table[cycle[s]], table[cycle[s + 1 if s + 1 < length else 0]]
        found = best_plane(placed, i, j)
        along = extent(placed, i, j, found.normal)
        plane[0], plane[1], plane[2] = found.normal.x, found.normal.y, found.normal.z
        plane[3] = 0.5 * (along.a + along.b)
        crossed, first = 0, -1
        for u in range(length):
            k = table[cycle[u]]
            if k not in (i, j) and position_of(placed, k, plane) == CROSSED:
                crossed += 1
                first = cycle[u] if first < 0 else first
        if 0 < crossed < fewest:
            fewest, entry = crossed, first
            best[:] = plane
    if entry < 0:
        return -1, FULL
    k = table[entry]
    below = part_of(placed, k, best, 1.0)
    above = part_of(placed, k, best, -1.0)
    if below == FULL or above == FULL:
        return entry, FULL
    table[entry] = below
    return entry, above
