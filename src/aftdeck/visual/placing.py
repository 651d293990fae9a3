"""Clusters in the coordinates of a camera, and the parts of them that other clusters cut off."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pose import turned, turned_back
from aftdeck.bodies.vector import Vector, dot
from aftdeck.law import law
from aftdeck.visual.cutting import FULL, subtract
from aftdeck.visual.planes import TOLERANCE, best_plane, extent
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
def remembered(normals: Array, a: int, b: int, poses: Array, frame: Indices) -> Vector:
    """Return the last separating normal of two clusters, a < b, from `a` to `b`; it is kept in the frame of `a`."""
    own = normals[a, b]
    return turned(poses[frame[a]], Vector(own[0], own[1], own[2]))


@law
def separated(placed: Store, i: int, j: int, normals: Array, poses: Array, frame: Indices) -> bool:
    """Return whether two polyhedra are separate, and remember the plane that separates them.

    Args:
        placed: the polyhedra.
        i: the first polyhedron; its owner has to come before the owner of `j`.
        j: the second polyhedron.
        normals: (N, N, 3) remembered normals; updated.
        poses: (F, 12) poses of the frames.
        frame: (N,) frame of each cluster.
    """
    a, b = placed.owner[i], placed.owner[j]
    last = remembered(normals, a, b, poses, frame)
    if dot(last, last) > 0.0:  # a pair that was never compared has a zero vector
        along = extent(placed, i, j, last)
        if along.b - along.a >= -TOLERANCE:
            return True
    best = best_plane(placed, i, j)
    own = turned_back(poses[frame[a]], best.normal)
    normals[a, b, 0], normals[a, b, 1], normals[a, b, 2] = own.x, own.y, own.z
    return best.apart >= -TOLERANCE


@law
def trim(
    placed: Store,
    trims: Indices,
    shown: Mask,
    normals: Array,
    poses: Array,
    frame: Indices,
    pieces: Indices,
) -> int:
    """List the polyhedra to draw: all shown clusters, without the parts that others cut off.

    Args:
        placed: the clusters, in the coordinates of the camera; the pieces are appended.
        trims: (T, 2) pairs of clusters, sorted by the first; the second is removed from the first.
        shown: (N,) 1 for each cluster that is in the picture.
        normals: (N, N, 3) remembered normals of the pairs; updated.
        poses: (F, 12) poses of the frames.
        frame: (N,) frame of each cluster.
        pieces: output: indices of the polyhedra to draw.

    Returns:
        Number of polyhedra to draw; FULL if there is no free space left.
    """
    count, t = 0, 0
    clusters, work = len(frame), np.empty(len(pieces), np.int64)
    for k in range(clusters):
        begin = count
        if shown[k]:
            pieces[count] = k
            count += 1
        while t < len(trims) and trims[t, 0] == k:
            m = trims[t, 1]
            t += 1
            if not shown[k] or not shown[m] or count == begin:
                continue
            a, b = min(k, m), max(k, m)
            if separated(placed, a, b, normals, poses, frame):
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
def find_overlaps(
    store: Store, frame: Indices, samples: Array, pairs: Indices, placed: Store, found: Mask
) -> None:
    """Set a 1 in `found` (m,) for each pair (m, 2) of clusters that overlaps in one of the sampled poses (s, F, 12)."""
    for s in range(len(samples)):
        place(store, frame, samples[s], placed)
        for k in range(len(pairs)):
            if found[k] == 0 and best_plane(placed, pairs[k, 0], pairs[k, 1]).apart < -TOLERANCE:
                found[k] = 1
