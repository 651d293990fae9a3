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
from aftdeck.visual.outlines import GATHERED, bound, convex_hull, outcodes, outline, overlapping, touches_eye
from aftdeck.visual.placing import place, remembered, seek_plane, separates, trim
from aftdeck.visual.planes import best_plane, extent, nearer_by
from aftdeck.visual.store import MOST_CORNERS, Store
from aftdeck.visual.trees import Forest, trace_all

SLACK = 1e-9
"""Overlap of two outlines that does not count, as a tangent of an angle of view: much less than a pixel."""
MOST_CUTS = 64
"""Greatest number of cuts in one picture."""
INSIDE, TOO_MANY, UNORDERED = -1, -2, -3
"""Results of `ordered` for pictures that cannot be drawn: the eye is inside a cluster; there is no space for the
pieces; the number of cuts is not enough."""
CUTS, OVERLAPS, FIRST, SECOND, COMPARED, RANKED, HIDING = range(7)
"""Indices in the notes (7,) of `ordered`: number of cuts; number of pairs that overlap in space; clusters of the first
such pair, or the cluster that contains the eye; number of compared pairs; how many of them were compared by rank;
number of pairs of entries of which one hides a part of the other."""
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
        pairs: (E * E / 2, 2) pairs of entries, the first of which hides a part of the second.
    """

    body: Indices
    slot: Indices
    outline: Array
    size: Indices
    box: Array
    new: Mask
    pairs: Indices


class Graph(NamedTuple):
    """Pairs of entries of which one hides a part of the other, sorted by the hidden one.

    Attributes:
        first: (n + 1,) for each entry, index of the first of those that hide a part of it.
        nearer: (m,) entries that hide a part of another one; those of one entry are in ascending order.
    """

    first: Indices
    nearer: Indices


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
    memory: Array,
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
        memory: the last separating planes of this camera (`placing.remembered`); updated.
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
    visible, points, first = np.empty(len(shown), np.uint8), placed.points, placed.first_point
    for k in range(len(shown)):
        visible[k] = shown[k] and outcodes(points, first[k], first[k + 1], wide, high)[0] == 0
    count = trim(placed, trims, visible, shown, memory, poses, frame, entries.body)
    free = len(frame)
    for n in range(count):
        entries.new[n], entries.slot[n] = 1, entries.body[n]
        if entries.body[n] >= len(frame):
            entries.slot[n] = free
            free += 1
    while True:
        if count < 0 or free + 1 > len(memory):
            return TOO_MANY
        count = _outlined(placed, entries, count, wide, high, notes)
        if count < 0:
            return count
        notes[HIDING] = _compare(placed, entries, count, rank, memory, poses, frame, notes)
        graph = _graph(entries.pairs, notes[HIDING], count)
        written = _sorted(graph, table)
        if written == count:
            break
        if notes[CUTS] == MOST_CUTS or count == len(table):
            return UNORDERED
        notes[CUTS] += 1
        entry, part = _cut(placed, entries, graph, table[:written])
        if part == FULL:
            return TOO_MANY
        # one part of the cut polyhedron has taken its entry; the other part becomes the last entry
        entries.body[count], entries.slot[count] = part, free
        entries.new[entry], entries.new[count] = 1, 1
        free += 1
        count += 1
    drawn = 0
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
    body, slot, new, sizes, outlines = entries.body, entries.slot, entries.new, entries.size, entries.outline
    points, first_point, planes, first_face = placed.points, placed.first_point, placed.planes, placed.first_face
    flat = np.empty((GATHERED, 2))
    polygon, work = np.empty((MOST_CORNERS + 8, 3)), np.empty((MOST_CORNERS + 8, 3))
    kept = 0
    for n in range(count):
        k = body[n]
        if new[n]:
            every, some = outcodes(points, first_point[k], first_point[k + 1], wide, high)
            size = 0
            if every == 0:
                if touches_eye(planes, first_face[k], first_face[k + 1]):
                    notes[FIRST] = placed.owner[k]
                    return INSIDE
                gathered = outline(placed, k, some != 0, wide, high, flat, polygon, work)
                size = gathered if gathered == FULL else convex_hull(flat, gathered, outlines[kept])
                if size == FULL:
                    return TOO_MANY
            if size == 0 and notes[CUTS] == 0:
                continue
            sizes[kept] = size
            bound(outlines, kept, size, entries.box)
        body[kept], slot[kept], new[kept] = k, slot[n], new[n]
        kept += 1
    return kept


@law
def _compare(
    placed: Store,
    entries: Entries,
    count: int,
    rank: Indices,
    memory: Array,
    poses: Array,
    frame: Indices,
    notes: Indices,
) -> int:
    """Find the pairs of entries of which one hides a part of the other; then no entry is new. Return their number.

    `notes[HIDING]` is the number of those that are known already. Two clusters of one frame are compared by their ranks
    in the frame's list or tree, if these differ. Any other pair is compared by a plane between the two.
    """
    body, slot, new, pairs = entries.body, entries.slot, entries.new, entries.pairs
    owner, points, first_point = placed.owner, placed.points, placed.first_point
    kept = 0
    for n in range(notes[HIDING]):
        if not (new[pairs[n, 0]] or new[pairs[n, 1]]):
            pairs[kept, 0], pairs[kept, 1] = pairs[n, 0], pairs[n, 1]
            kept += 1
    begin = kept
    end = overlapping(entries.outline, entries.size, entries.box, new, count, SLACK, pairs, begin)
    notes[COMPARED] += end - begin
    for n in range(begin, end):
        a, b = pairs[n, 0], pairs[n, 1]
        first, second = (a, b) if slot[a] < slot[b] else (b, a)
        i, j, p, q = body[first], body[second], slot[first], slot[second]
        own, other = owner[i], owner[j]
        if frame[own] == frame[other] and rank[own] != rank[other]:
            notes[RANKED] += 1
            way = 1 if rank[own] < rank[other] else -1
        else:
            normal = remembered(memory, p, q, poses, frame[own])
            along = extent(points, first_point, i, j, normal)
            if not separates(normal, along):
                if not seek_plane(placed, i, j, memory, p, q, poses, frame[own]):
                    if notes[OVERLAPS] == 0:
                        notes[FIRST], notes[SECOND] = own, other
                    notes[OVERLAPS] += 1
                along = extent(points, first_point, i, j, remembered(memory, p, q, poses, frame[own]))
            way = nearer_by(along, 0.0)
        if way != 0:
            pairs[kept, 0], pairs[kept, 1] = (first, second) if way > 0 else (second, first)
            kept += 1
    for n in range(count):
        new[n] = 0
    return kept


@law
def _graph(pairs: Indices, hiding: int, count: int) -> Graph:
    """Return the graph of the first `hiding` pairs of `count` entries."""
    first, nearer = np.zeros(count + 1, np.int64), np.empty(hiding, np.int64)
    for n in range(hiding):
        first[pairs[n, 1] + 1] += 1
    for b in range(count):
        first[b + 1] += first[b]
    end = first.copy()
    for n in range(hiding):
        a, b = pairs[n, 0], pairs[n, 1]
        at = end[b]
        while at > first[b] and nearer[at - 1] > a:
            nearer[at] = nearer[at - 1]
            at -= 1
        nearer[at] = a
        end[b] += 1
    return Graph(first, nearer)


@law
def _sorted(graph: Graph, done: Indices) -> int:
    """Write entries of the table into `done`, each after all entries that it hides; return how many could be written.

    The number is less than that of all entries if there are cycles.
    """
    first, nearer = graph
    count, written, at = len(first) - 1, 0, 0
    under = np.zeros(count, np.int64)
    for k in range(len(nearer)):
        under[nearer[k]] += 1
    for a in range(count):
        if under[a] == 0:
            done[written] = a
            written += 1
    while at < written:
        b = done[at]
        at += 1
        for k in range(first[b], first[b + 1]):
            a = nearer[k]
            under[a] -= 1
            if under[a] == 0:
                done[written] = a
                written += 1
    return written


@law
def _in_cycles(graph: Graph, done: Indices) -> Mask:
    """Return (n,) 1 for each entry that can be in a cycle.

    These are all entries without those that hide no other one of them, which are `done`, and without those that are
    hidden by no other one of them.
    """
    first, nearer = graph
    left, changed = np.ones(len(first) - 1, np.uint8), True
    for n in range(len(done)):
        left[done[n]] = 0
    while changed:
        changed = False
        for b in range(len(left)):
            if left[b]:
                left[b] = 0
                for k in range(first[b], first[b + 1]):
                    left[b] |= left[nearer[k]]
                changed = changed or left[b] == 0
    return left


@law
def _shortest_cycle(graph: Graph, done: Indices, cycle: Indices) -> int:
    """Write the entries of a shortest cycle into `cycle`, each hidden by the following one; return their number.

    The entries `done` hide none of the others, and so are in no cycle.
    """
    first, nearer = graph
    count, left = len(first) - 1, _in_cycles(graph, done)
    length = count + 1
    before, distance, queue = np.empty(count, np.int64), np.empty(count, np.int64), np.empty(count, np.int64)
    for start in range(count):
        if not left[start]:
            continue
        distance[:] = -1
        distance[start], queue[0] = 0, start
        at, end = 0, 1
        while at < end and distance[queue[at]] + 1 < length:
            b = queue[at]
            at += 1
            for k in range(first[b], first[b + 1]):
                a = nearer[k]
                if a == start:
                    length = distance[b] + 1
                    for m in range(length):
                        cycle[length - 1 - m] = b
                        b = before[b]
                    break
                if left[a] and distance[a] < 0:
                    distance[a], before[a] = distance[b] + 1, b
                    queue[end] = a
                    end += 1
    return length if length <= count else 0


@law
def _cut(placed: Store, entries: Entries, graph: Graph, done: Indices) -> tuple[int, int]:
    """Cut one polyhedron of a shortest cycle by the plane between two neighbours in the cycle.

    On the way round the cycle from the farther to the nearer of the two, some polyhedron is on both sides of the plane:
    nothing behind the plane can hide anything before it. Of all such planes, the one that cuts the fewest is used.

    Args:
        placed: the polyhedra; updated.
        entries: the entries; the cut one is updated.
        graph: the pairs of them of which one hides a part of the other.
        done: entries that hide none of the others, and so are in no cycle.

    Returns:
        Entry of the polyhedron, which becomes one of the two parts, and the other part; the part is FULL if there is no
        space.
    """
    count = len(graph.first) - 1
    cycle = np.empty(count, np.int64)
    length = _shortest_cycle(graph, done, cycle)
    points, first_point = placed.points, placed.first_point
    fewest, entry = count + 1, -1
    plane, best = np.empty(4), np.empty(4)
    for s in range(length):
        i, j = entries.body[cycle[s]], entries.body[cycle[s + 1 if s + 1 < length else 0]]
        found = best_plane(placed, i, j)
        along = extent(points, first_point, i, j, found.normal)
        plane[0], plane[1], plane[2] = found.normal.x, found.normal.y, found.normal.z
        plane[3] = 0.5 * (along.a + along.b)
        crossed, first = 0, -1
        for u in range(length):
            k = entries.body[cycle[u]]
            if k not in (i, j) and position_of(points, first_point[k], first_point[k + 1], plane) == CROSSED:
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
