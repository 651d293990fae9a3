"""An outside witness of contacts: the separating axis theorem on every pair of solids that is near, and how deep.

It is written for the tests alone and shares no code with `aftdeck.bodies`: face normals are cross products of the
diagonals of faces, and all 12 x 12 pairs of edges are tried.
"""

from __future__ import annotations

import numba
import numpy as np

import aftdeck
from aftdeck.arrays import Array, Indices, Mask

NEAR = 0.1
"""Pairs of solids farther apart than this [m], by their bounding spheres, are passed over."""
FACES = np.array([[0, 1, 5, 4], [0, 1, 3, 2], [0, 2, 6, 4], [1, 3, 7, 5], [4, 5, 7, 6], [2, 3, 7, 6]])
"""The corners of each face, in their order round it."""
EDGES = np.array(
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]]
)  # fmt: skip
_PARALLEL = 1e-9


@numba.njit(cache=True)  # type: ignore[misc, unused-ignore]
def overlap(a: Array, b: Array, x: float, y: float, z: float) -> float:
    """The overlap of two hulls (8, 3) along an axis, negative where it separates them [m]; inf along none."""
    length = np.sqrt(x * x + y * y + z * z)
    if length < _PARALLEL:
        return np.inf
    low_a = low_b = np.inf
    high_a = high_b = -np.inf
    for v in range(8):
        p = (a[v, 0] * x + a[v, 1] * y + a[v, 2] * z) / length
        q = (b[v, 0] * x + b[v, 1] * y + b[v, 2] * z) / length
        low_a, high_a, low_b, high_b = min(low_a, p), max(high_a, p), min(low_b, q), max(high_b, q)
    return min(high_a - low_b, high_b - low_a)


@numba.njit(cache=True)  # type: ignore[misc, unused-ignore]
def depth(a: Array, b: Array, axis: Array) -> float:
    """How deep two convex hexahedra (8, 3) are in each other, negative where an axis separates them [m].

    The axis (3,) that separated them last is tried first, and kept.
    """
    least = overlap(a, b, axis[0], axis[1], axis[2])
    if least < 0.0:
        return least
    least = np.inf
    for k in range(12 + 144):
        if k < 12:
            body = a if k < 6 else b
            f = FACES[k % 6]
            u, v = body[f[2]] - body[f[0]], body[f[3]] - body[f[1]]
        else:
            i, j = divmod(k - 12, 12)
            u, v = a[EDGES[i, 1]] - a[EDGES[i, 0]], b[EDGES[j, 1]] - b[EDGES[j, 0]]
        x, y, z = u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
        along = overlap(a, b, x, y, z)
        if along < 0.0:
            axis[0], axis[1], axis[2] = x, y, z
            return along
        least = min(least, along)
    return least


@numba.njit(cache=True)  # type: ignore[misc, unused-ignore]
def place(vertices: Array, frame: Indices, frames: Array, placed: Array) -> None:
    """Vertices (n, 8, 3) of frames (F, 12) in L."""
    for i in range(len(vertices)):
        row = frames[frame[i]]
        for v in range(8):
            for k in range(3):
                placed[i, v, k] = (
                    row[k]
                    + row[3 + 3 * k] * vertices[i, v, 0]
                    + row[4 + 3 * k] * vertices[i, v, 1]
                    + row[5 + 3 * k] * vertices[i, v, 2]
                )


@numba.njit(cache=True)  # type: ignore[misc, unused-ignore]
def look(
    placed: Array, radius: Array, pairs: Indices, begins: Indices, active: Mask, before: Array, now: Array,
    vertices: Array, frame: Indices, axes: Array, depths: Array, ways: Array,
) -> None:  # fmt: skip
    """The depth of each active group that is near, -inf where it is not [m], and how far its parts moved in the step.

    Args:
        placed: (n, 8, 3) in L.
        radius: (n,) of bounding spheres about the mean of the vertices [m].
        pairs: (m, 2) solids, those of a group together from `begins` (g + 1,).
        begins: see pairs.
        active: (g,) 1 where the group is looked at.
        before: (F, 12) the frames a step ago, and
        now: (F, 12) now.
        vertices: (n, 8, 3) in the frames' axes.
        frame: (n,) of each solid.
        axes: (m, 3) that separated each pair last; changed.
        depths: (g,) out.
        ways: (g,) out: how far a vertex of one part moved in the axes of the other, at most [m].
    """
    middles = np.empty((len(placed), 3))
    for i in range(len(placed)):
        for k in range(3):
            middles[i, k] = placed[i, :, k].mean()
    for g in range(len(active)):
        depths[g], ways[g] = -np.inf, 0.0
        if active[g] == 0:
            continue
        for m in range(begins[g], begins[g + 1]):
            i, j = pairs[m, 0], pairs[m, 1]
            apart = 0.0
            for k in range(3):
                apart += (middles[i, k] - middles[j, k]) ** 2
            if np.sqrt(apart) - radius[i] - radius[j] > NEAR:
                continue
            deep = depth(placed[i], placed[j], axes[m])
            depths[g] = max(depths[g], deep)
            if deep > 0.0:
                one, other = moved(before, now, vertices, frame, i, j), moved(before, now, vertices, frame, j, i)
                ways[g] = max(ways[g], one, other)


@numba.njit(cache=True)  # type: ignore[misc, unused-ignore]
def moved(before: Array, now: Array, vertices: Array, frame: Indices, i: int, j: int) -> float:
    """How far a vertex of solid i moved in the axes of solid j in a step, at most [m]."""
    most = 0.0
    f, g = frame[i], frame[j]
    for v in range(8):
        way = 0.0
        was, is_now = np.empty(3), np.empty(3)
        for frames, out in ((before, was), (now, is_now)):
            a, b = frames[f], frames[g]
            p = np.empty(3)
            for k in range(3):
                p[k] = a[k] - b[k]
                for c in range(3):
                    p[k] += a[3 + 3 * k + c] * vertices[i, v, c]
            for k in range(3):
                out[k] = b[3 + k] * p[0] + b[6 + k] * p[1] + b[9 + k] * p[2]
        for k in range(3):
            way += (is_now[k] - was[k]) ** 2
        most = max(most, np.sqrt(way))
    return most


class Witness:
    """Looks at a simulation after each step, and keeps for each group how deep it may be.

    It looks at the groups that are watched, and at the fingers and the bar that they hold.

    Attributes:
        worst: by pair of parts, how much deeper it was than two steps' travel and what its relation permits [m].
        deepest: by pair of parts, how deep it was [m].
    """

    def __init__(self, sim: aftdeck.Simulation) -> None:
        self.sim, site = sim, sim._flight.site
        self.layout = site.layout
        # the packed body begins with its vertices' x, then y, then z
        self.vertices = self.layout.solids[:, :24].reshape(-1, 3, 8).transpose(0, 2, 1).copy()
        middles = self.vertices.mean(axis=1, keepdims=True)
        self.radius = np.linalg.norm(self.vertices - middles, axis=2).max(axis=1)
        self.placed, self.axes = np.empty_like(self.vertices), np.zeros((len(self.layout.pairs), 3))
        groups = len(self.layout.groups)
        self.depths, self.ways, self.last = np.empty(groups), np.empty(groups), np.zeros(groups)
        self.budget, self.steps = np.zeros(groups), np.zeros(groups, np.int64)
        self.was_active, self.fingers = np.zeros(groups, np.uint8), np.zeros(groups, np.uint8)
        self.permitted = np.zeros(groups)
        for meeting in site.meetings:
            self.permitted[meeting.group] = meeting.depth
            self.fingers[meeting.group] = meeting.relation == "acquisition"
        self.worst: dict[tuple[str, str], float] = {}
        self.deepest: dict[tuple[str, str], float] = {}

    def begin(self) -> None:
        """Go on from another state."""
        self.budget[:], self.steps[:], self.was_active[:] = 0.0, 0, 0

    def look(self) -> None:
        """Look at the step just made."""
        worksite = self.sim._state.worksite
        active = worksite.watch.active | self.fingers
        place(self.vertices, self.layout.frame, worksite.frames, self.placed)
        look(
            self.placed, self.radius, self.layout.pairs, self.layout.begins, active, worksite.before,
            worksite.frames, self.vertices, self.layout.frame, self.axes, self.depths, self.ways,
        )  # fmt: skip
        # what moves between two looks begins with the step in which the two came together
        entered = (self.depths > 0.0) & (self.steps == 0)
        self.steps = np.where(self.depths > 0.0, self.steps + 1, 0)
        known = self.was_active & active
        here = np.where(known != 0, 0.0, np.maximum(self.depths, 0.0))
        self.budget = np.where(entered, here + self.ways, self.budget + np.where(self.steps == 2, self.ways, 0.0))
        self.was_active = active
        for g in np.flatnonzero(self.depths > 0.0).tolist():
            pair = self.layout.named(g)
            over = float(self.depths[g] - self.budget[g] - self.permitted[g])
            self.worst[pair] = max(self.worst.get(pair, -np.inf), over)
            self.deepest[pair] = max(self.deepest.get(pair, 0.0), float(self.depths[g]))
