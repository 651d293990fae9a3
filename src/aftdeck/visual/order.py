"""Order of the clusters in one picture: which one hides which, and the priority output table.

Two clusters are compared only if their outlines in the picture overlap: a plane between the two shows which one is
nearer to the eye. Comparing all clusters would give cycles where there is nothing to hide. Inside one frame, a
permanent list (`visual.lists`) or a tree of planes (`visual.trees`) replaces the planes.

Source: Remote Manipulator Simulation, final report, chapter V: visual priority, separating planes, and the priority
output table (POT).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.law import law
from aftdeck.visual.bisectors import remember_bisectors
from aftdeck.visual.cutting import CROSSED, FULL, part_of, position_of
from aftdeck.visual.outlines import bound, outcodes, outline, overlap, touches_eye
from aftdeck.visual.placing import Memory, place, remembered, separated, trim
from aftdeck.visual.planes import best_plane, extent, nearer_by
from aftdeck.visual.store import Store
from aftdeck.visual.trees import Forest, trace_all

SLACK = 1e-9
"""Overlap of two outlines that does not count, as a tangent of an angle of view: much less than a pixel."""
MOST_CUTS = 64
"""Greatest number of cuts in one picture."""
INSIDE, TOO_MANY, UNORDERED = -1, -2, -3
"""Results of `ordered` for pictures that cannot be drawn: the eye is inside a cluster; there is no space for the
pieces; the number of cuts is not enough."""
CUTS, OVERLAPS, FIRST, SECOND, COMPARED, RANKED, ENTERED = range(7)
"""Indices in the notes (7,) of `ordered`: number of cuts; number of pairs that overlap in space; clusters of the first
such pair, or the cluster that contains the eye; number of compared pairs; how many of them were compared by rank;
number of entries."""
NOTES = 7
"""Number of notes."""


class Entries(NamedTuple):
    """Polyhedra of a picture, for the work of `ordered`.

    Attributes:
        body: (E,) polyhedron of each entry.
        slot: (E,) its slot in the memory of planes.
        outline: (E, MOST_POINTS, 2) its outline in the picture.
        size: (E,) number of corners of its outline; 0 if it is not in the picture.
        box: (E, 4) bounds of its outline.
        new: (E,) whether it has not been compared yet.
        hides: (E, E) 1 in [a, b] if entry a hides a part of entry b.
    """

    body: Indices
    slot: Indices
    outline: Array
    size: Indices
    box: Array
    new: Mask
    hides: Array


@law
def ordered(
    store: Store,
    frame: Indices,
    trims: Indices,
    bisected: Indices,
    poses: Array,
    shown: Mask,
    wide: float,
    high: float,
    placed: Store,
    forest: Forest,
    listed: Mask,
    rank: Indices,
    memory: Memory,
    entries: Entries,
    table: Indices,
    notes: Indices,
) -> int:
    """Write the priority output table of a picture: its polyhedra, highest priority first.

    Args:
        store: the clusters, each in its own frame.
        frame: (N,) frame of each cluster.
        trims: (T, 2) pairs of clusters: the second is removed from the first.
        bisected: (B, 2) pairs of clusters that a plane through a pin of the arm may separate.
        poses: (F, 12) poses of the frames in the coordinates of the camera: x right, y down, z ahead.
        shown: (N,) 1 for each cluster that can be in the picture.
        wide: tangent of half the horizontal field of view.
        high: tangent of half the vertical field of view.
        placed: store with the same clusters and free space; output: the clusters and their pieces in the coordinates
            of the camera.
        forest: the trees of separating planes of all frames.
        listed: (F,) 1 for each frame for which the camera has a permanent list.
        rank: (N,) ranks of the clusters in the frames that have a list; the ranks of the others are updated.
        memory: the last separating planes of this camera; updated.
        entries: room for the work.
        table: (E,) output: polyhedra of `placed`, highest priority first.
        notes: (7,) output: numbers and clusters to report.

    Returns:
        Number of polyhedra in the picture; INSIDE, TOO_MANY or UNORDERED if there is no picture.
    """
    notes[:] = 0
    place(store, frame, poses, placed)
    remember_bisectors(bisected, placed, frame, poses, memory)
    trace_all(forest, poses, listed, rank)
    visible = np.empty(len(shown), np.uint8)
    for k in range(len(shown)):
        visible[k] = shown[k] and outcodes(placed, k, wide, high)[0] == 0
    count = trim(placed, trims, visible, shown, memory, poses, frame, entries.body)
    free = len(frame)
    for n in range(count):
        entries.new[n], entries.slot[n] = 1, entries.body[n]
        if entries.body[n] >= len(frame):
            entries.slot[n] = free
            free += 1
    while True:
        if count < 0 or free + 1 > len(memory.owner):
            return TOO_MANY
        count = _outlined(placed, entries, count, wide, high, notes)
        if count < 0:
            return count
        _compare(placed, entries, count, rank, memory, poses, frame, notes)
        if _sorted(entries.hides, count, table) == count:
            break
        if notes[CUTS] == MOST_CUTS or count == len(table):
            return UNORDERED
        notes[CUTS] += 1
        entry, part = _cut(placed, entries, count)
        if part == FULL:
            return TOO_MANY
        # one part of the cut polyhedron has taken its entry; the other part becomes the last entry
        entries.body[count], entries.slot[count] = part, free
        entries.new[entry], entries.new[count] = 1, 1
        free += 1
        count += 1
    notes[ENTERED], drawn = count, 0
    for i in range(count):
        if entries.size[table[i]] > 0:
            table[drawn] = entries.body[table[i]]
            drawn += 1
    for i in range(drawn // 2):
        table[i], table[drawn - 1 - i] = table[drawn - 1 - i], table[i]
    return drawn


@law
def _outlined(placed: Store, entries: Entries, count: int, wide: float, high: float, notes: Indices) -> int:
    """Find the outlines of the new entries.

    At first, all entries are new, and those that are not in the picture are left out. Later, the parts of a cut
    polyhedron are new; a part that is not in the picture keeps its entry, with an outline of size 0.

    Returns:
        Number of entries; INSIDE or TOO_MANY if there is no picture.
    """
    kept = 0
    for n in range(count):
        k = entries.body[n]
        if entries.new[n]:
            every, some = outcodes(placed, k, wide, high)
            size = 0
            if every == 0:
                if touches_eye(placed, k):
                    notes[FIRST] = placed.owner[k]
                    return INSIDE
                size = outline(placed, k, some != 0, wide, high, entries.outline[kept])
                if size == FULL:
                    return TOO_MANY
            if size == 0 and notes[CUTS] == 0:
                continue
            entries.size[kept] = size
            bound(entries.outline, kept, size, entries.box)
        entries.body[kept], entries.slot[kept], entries.new[kept] = k, entries.slot[n], entries.new[n]
        kept += 1
    return kept


@law
def _compare(
    placed: Store,
    entries: Entries,
    count: int,
    rank: Indices,
    memory: Memory,
    poses: Array,
    frame: Indices,
    notes: Indices,
) -> None:
    """Fill `hides` for all pairs with a new entry; then no entry is new.

    Two clusters of one frame are compared by their ranks in the frame's list or tree, if these differ. Any other pair
    is compared by a plane between the two.

    The loop is inside this law, because a call in it would count the references of all arrays for each pair.
    """
    body, slot, new, hides = entries.body, entries.slot, entries.new, entries.hides
    for a in range(count):
        hides[a, a] = 0
        memory.owner[slot[a]] = placed.owner[body[a]]
        for b in range(a):
            if not (new[a] or new[b]):
                continue
            hides[a, b], hides[b, a] = 0, 0
            if not overlap(entries.outline, entries.size, entries.box, a, b, SLACK):
                continue
            first, second = (a, b) if slot[a] < slot[b] else (b, a)
            i, j, p, q = body[first], body[second], slot[first], slot[second]
            notes[COMPARED] += 1
            own, other = placed.owner[i], placed.owner[j]
            if frame[own] == frame[other] and rank[own] != rank[other]:
                notes[RANKED] += 1
                hides[first, second] = rank[own] < rank[other]
                hides[second, first] = rank[own] > rank[other]
                continue
            if not separated(placed, i, j, memory, p, q, poses, frame):
                if notes[OVERLAPS] == 0:
                    notes[FIRST], notes[SECOND] = own, other
                notes[OVERLAPS] += 1
            way = nearer_by(extent(placed, i, j, remembered(memory, p, q, poses, frame)), 0.0)
            hides[first, second], hides[second, first] = way > 0, way < 0
    for n in range(count):
        new[n] = 0


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
def _cut(placed: Store, entries: Entries, count: int) -> tuple[int, int]:
    """Cut one polyhedron of a shortest cycle by the plane between two neighbours in the cycle.

    On the way round the cycle from the farther to the nearer of the two, some polyhedron is on both sides of the plane:
    nothing behind the plane can hide anything before it. Of all such planes, the one that cuts the fewest is used.

    Returns:
        Entry of the polyhedron, which becomes one of the two parts, and the other part; the part is FULL if there is no
        space.
    """
    cycle = np.empty(count, np.int64)
    length = _shortest_cycle(entries.hides, count, cycle)
    fewest, entry = count + 1, -1
    plane, best = np.empty(4), np.empty(4)
    for s in range(length):
        i, j = entries.body[cycle[s]], entries.body[cycle[s + 1 if s + 1 < length else 0]]
        found = best_plane(placed, i, j)
        along = extent(placed, i, j, found.normal)
        plane[0], plane[1], plane[2] = found.normal.x, found.normal.y, found.normal.z
        plane[3] = 0.5 * (along.a + along.b)
        crossed, first = 0, -1
        for u in range(length):
            k = entries.body[cycle[u]]
            if k not in (i, j) and position_of(placed, k, plane) == CROSSED:
                crossed += 1
                first = cycle[u] if first < 0 else first
        if 0 < crossed < fewest:
            fewest, entry = crossed, first
            best[:] = plane
    if entry < 0:
        return -1, FULL
    k = entries.body[entry]
    below = part_of(placed, k, best, 1.0)
    above = part_of(placed, k, best, -1.0)
    if FULL in (below, above):
        return entry, FULL
    entries.body[entry] = below
    return entry, above
