"""Clusters in the coordinates of a camera, and the parts of them that other clusters cut off."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pose import turned_back
from aftdeck.bodies.vector import Vector, dot
from aftdeck.law import law
from aftdeck.visual.cutting import FULL, subtract
from aftdeck.visual.planes import TOLERANCE, Extent, best_plane, extent
from aftdeck.visual.store import CLUSTERS, Store


@law
def place(store: Store, frame: Indices, poses: Array, placed: Store) -> None:
    """Place all clusters of a store, and remove the pieces that `placed` contains from the last picture.

    Args:
        store: the clusters, each in its own frame.
        frame: (N,) frame of each cluster.
        poses: (F, 12) poses of the frames.
        placed: a store with the same clusters and with free space; updated.
    """
    for k in range(store.used[CLUSTERS]):
        pose = poses[frame[k]]
        x0, y0, z0 = pose[0], pose[1], pose[2]
        for i in range(store.first_point[k], store.first_point[k + 1]):
            x, y, z = store.points[i, 0], store.points[i, 1], store.points[i, 2]
            placed.points[i, 0] = x0 + pose[3] * x + pose[4] * y + pose[5] * z
            placed.points[i, 1] = y0 + pose[6] * x + pose[7] * y + pose[8] * z
            placed.points[i, 2] = z0 + pose[9] * x + pose[10] * y + pose[11] * z
        for f in range(store.first_face[k], store.first_face[k + 1]):
            x, y, z = store.planes[f, 0], store.planes[f, 1], store.planes[f, 2]
            u = pose[3] * x + pose[4] * y + pose[5] * z
            v = pose[6] * x + pose[7] * y + pose[8] * z
            w = pose[9] * x + pose[10] * y + pose[11] * z
            placed.planes[f, 0], placed.planes[f, 1], placed.planes[f, 2] = u, v, w
            placed.planes[f, 3] = store.planes[f, 3] + u * x0 + v * y0 + w * z0
    placed.used[:] = store.used


@law
def remembered(memory: Array, a: int, b: int, poses: Array, f: int) -> Vector:
    """Return the last separating normal between slots a < b, in the coordinates in which `poses` are given.

    A plane that still separates two polyhedra need not be sought again. Each cluster has a slot in the memory, and each
    piece gets one of the slots that follow.

    Args:
        memory: (S, S, 3) unit normal between two slots, from the lower to the higher one, in the frame of the lower
            one's cluster; zero if there was none.
        a: the lower slot.
        b: the higher slot.
        poses: (F, 12) poses of the frames.
        f: the frame of the lower slot's cluster.
    """
    # not by `bodies.pose.turned`: a row of `poses` as its argument would count references in an inner loop
    x, y, z = memory[a, b, 0], memory[a, b, 1], memory[a, b, 2]
    return Vector(
        poses[f, 3] * x + poses[f, 4] * y + poses[f, 5] * z,
        poses[f, 6] * x + poses[f, 7] * y + poses[f, 8] * z,
        poses[f, 9] * x + poses[f, 10] * y + poses[f, 11] * z,
    )


@law
def separates(normal: Vector, along: Extent) -> bool:
    """Return whether a remembered normal, with the extents of two polyhedra along it, still separates them."""
    # two polyhedra that were never compared have a zero vector
    return dot(normal, normal) > 0.0 and along.b - along.a >= -TOLERANCE


@law
def seek_plane(placed: Store, i: int, j: int, memory: Array, a: int, b: int, poses: Array, f: int) -> bool:
    """Seek the best plane between polyhedra `i` and `j`, and remember its normal; return whether it separates them.

    `a` and `b` are their slots; the other arguments are as for `remembered`.
    """
    best = best_plane(placed, i, j)
    own = turned_back(poses[f], best.normal)
    memory[a, b, 0], memory[a, b, 1], memory[a, b, 2] = own.x, own.y, own.z
    return best.apart >= -TOLERANCE


@law
def trim(
    placed: Store,
    trims: Indices,
    visible: Mask,
    shown: Mask,
    memory: Array,
    poses: Array,
    frame: Indices,
    pieces: Indices,
) -> int:
    """List the polyhedra to draw: all visible clusters, without the parts that others cut off.

    Args:
        placed: the clusters, in the coordinates of the camera; the pieces are appended.
        trims: (T, 2) pairs of clusters, sorted by the first; the second is removed from the first.
        visible: (N,) 1 for each cluster that can be in the picture.
        shown: (N,) 1 for each cluster that is there; others cut nothing off.
        memory: the last separating planes.
        poses: (F, 12) poses of the frames.
        frame: (N,) frame of each cluster.
        pieces: output: indices of the polyhedra to draw.

    Returns:
        Number of polyhedra to draw; FULL if there is no free space left.
    """
    count, t = 0, 0
    points, first = placed.points, placed.first_point
    clusters, work = len(frame), np.empty(len(pieces), np.int64)
    for k in range(clusters):
        begin = count
        if visible[k]:
            if count == len(pieces):
                return FULL
            pieces[count] = k
            count += 1
        while t < len(trims) and trims[t, 0] == k:
            m = trims[t, 1]
            t += 1
            if not shown[m] or count == begin:
                continue
            a, b = min(k, m), max(k, m)
            last = remembered(memory, a, b, poses, frame[a])
            if separates(last, extent(points, first, a, b, last)):
                continue
            old = count - begin
            for i in range(old):
                work[i] = pieces[begin + i]
            count = begin
            for i in range(old):
                count = subtract(placed, work[i], placed, m, pieces, count)
                if count == FULL:
                    return FULL
    return count


@law
def find_overlaps(store: Store, frame: Indices, samples: Array, pairs: Indices, placed: Store, found: Mask) -> None:
    """Set a 1 in `found` (m,) for each pair (m, 2) of clusters that overlaps in one of the sampled poses (s, F, 12)."""
    for s in range(len(samples)):
        place(store, frame, samples[s], placed)
        for k in range(len(pairs)):
            if found[k] == 0 and best_plane(placed, pairs[k, 0], pairs[k, 1]).apart < -TOLERANCE:
                found[k] = 1
