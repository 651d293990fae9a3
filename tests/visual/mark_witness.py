"""Marks by a depth test for each pixel: the witness for their place in the order.

A ray through the centre of a pixel meets a mark if it meets the mark's plane inside the mark's corners, from outside,
and if no solid is before this point. Of the marks of one face, the last one that the ray meets is on top.
"""

from __future__ import annotations

import numpy as np
from numba import njit

from aftdeck.arrays import Array, Indices
from aftdeck.visual.clusters import Clusters
from aftdeck.visual.scene import Aim
from tests.visual.depth_picture import rays

NEAR = 1e-6
"""Difference of the depths of a solid's face and of the mark on it, because of rounding [m]."""


def marks_at(clusters: Clusters, poses: Array, aim: Aim, absent: frozenset[str], depth: Array) -> Indices:
    """Return the mark (height, width) that each pixel shows; -1 if it shows none.

    Args:
        clusters: the clusters and their marks.
        poses: (F, 12) poses of the frames in the scene.
        aim: the camera.
        absent: parts that are not in the picture.
        depth: (height, width) depth of the nearest solid along each ray.
    """
    store, marks = clusters.store, clusters.marks
    face = np.repeat(np.arange(len(marks.first) - 1), np.diff(marks.first))
    cluster = np.searchsorted(store.first_face, face, side="right") - 1
    pose = poses[clusters.frame[cluster]]
    turns = pose[:, 3:].reshape(-1, 3, 3)
    normals = np.einsum("mij,mj->mi", turns, store.planes[face, :3])
    distances = store.planes[face, 3] + (normals * (pose[:, :3] - aim.position)).sum(axis=1)
    of = np.repeat(np.arange(len(face)), np.diff(marks.begins))
    corners = np.einsum("pij,pj->pi", turns[of], marks.points) + pose[of, :3] - aim.position
    there = np.array([clusters.clusters[k].part not in absent for k in cluster], bool)
    found: Indices = _marked(
        marks.begins, corners @ aim.axes.T, normals @ aim.axes.T, distances, there, depth,
        *rays(aim.wide, aim.high, depth.shape[1], depth.shape[0]),
    )  # fmt: skip
    return found


@njit(cache=True)
def _marked(begins, corners, normals, distances, there, depth, across, down):  # type: ignore[no-untyped-def]
    shown = np.full(depth.shape, -1, np.int64)
    for m in range(len(distances)):
        if not there[m] or distances[m] >= 0.0:
            continue
        n, first, end = normals[m], begins[m], begins[m + 1]
        for row in range(len(down)):
            for column in range(len(across)):
                x, y = across[column], down[row]
                speed = n[0] * x + n[1] * y + n[2]
                if speed >= 0.0 or not abs(distances[m] / speed - depth[row, column]) <= NEAR:
                    continue
                at = distances[m] / speed
                inside = True
                for i in range(first, end):
                    a, b = corners[i], corners[i + 1 if i + 1 < end else first]
                    ex, ey, ez = b[0] - a[0], b[1] - a[1], b[2] - a[2]
                    px, py, pz = at * x - a[0], at * y - a[1], at - a[2]
                    turn = n[0] * (ey * pz - ez * py) + n[1] * (ez * px - ex * pz) + n[2] * (ex * py - ey * px)
                    if turn < 0.0:
                        inside = False
                        break
                if inside:
                    shown[row, column] = m
    return shown
