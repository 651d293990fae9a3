"""Independent measurement of penetration depths, for near pairs of solids, by the separating axis theorem.

This module shares no code with `aftdeck.bodies`: face normals are cross products of the diagonals of faces, and all
12 x 12 pairs of edges are tested.
"""

from __future__ import annotations

import numba
import numpy as np

import aftdeck
from aftdeck.arrays import Array, Indices, Mask

NEAR = 0.1
"""Distance between bounding spheres beyond which a pair of solids is not tested [m]."""
FACES = np.array([[0, 1, 5, 4], [0, 1, 3, 2], [0, 2, 6, 4], [1, 3, 7, 5], [4, 5, 7, 6], [2, 3, 7, 6]])
"""Corners of each face, in order around the face."""
EDGES = np.array(
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]]
)  # fmt: skip
_PARALLEL = 1e-9


@numba.njit(cache=True)  # type: ignore[misc, unused-ignore]
def overlap(a: Array, b: Array, x: float, y: float, z: float) -> float:
    """Return the overlap of two hulls (8, 3) along an axis [m]; negative if there is a gap, inf for a zero axis."""
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
    """Return the penetration depth of two convex hexahedra (8, 3) [m]; negative if an axis separates them.

    `axis` (3,) is the most recent separating axis of the two solids. It is tested first, and is updated.
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
    """Write the vertices (n, 8, 3) of solids in L into `placed`; `frames` (F, 12): poses of the coordinate frames."""
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
def measure(
    placed: Array, radius: Array, pairs: Indices, begins: Indices, active: Mask, before: Array, now: Array,
    vertices: Array, frame: Indices, axes: Array, depths: Array, travels: Array,
) -> None:  # fmt: skip
    """Write the depth of each monitored pair of parts, and the relative motion of its two parts in the step.

    Args:
        placed: (n, 8, 3) vertices of the solids in L.
        radius: (n,) radii of bounding spheres about the mean of the vertices [m].
        pairs: (m, 2) pairs of solids, in the order of the pairs of parts.
        begins: (g + 1,) first row in `pairs` of each pair of parts.
        active: (g,) 1 for monitored pairs of parts.
        before: (F, 12) poses of the coordinate frames before the step.
        now: (F, 12) poses of the coordinate frames after the step.
        vertices: (n, 8, 3) vertices in their coordinate frames.
        frame: (n,) coordinate frame of each solid.
        axes: (m, 3) most recent separating axis of each pair of solids; updated.
        depths: (g,) out: depth of each pair of parts [m]; -inf if the parts are not near each other.
        travels: (g,) out: greatest motion of a vertex of one part in the axes of the other part [m].
    """
    middles = np.empty((len(placed), 3))
    for i in range(len(placed)):
        for k in range(3):
            middles[i, k] = placed[i, :, k].mean()
    for g in range(len(active)):
        depths[g], travels[g] = -np.inf, 0.0
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
                first, second = moved(before, now, vertices, frame, i, j), moved(before, now, vertices, frame, j, i)
                travels[g] = max(travels[g], first, second)


@numba.njit(cache=True)  # type: ignore[misc, unused-ignore]
def moved(before: Array, now: Array, vertices: Array, frame: Indices, i: int, j: int) -> float:
    """Return the greatest motion of a vertex of solid i in the axes of solid j in a step [m]."""
    most = 0.0
    f, g = frame[i], frame[j]
    for v in range(8):
        squared = 0.0
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
            squared += (is_now[k] - was[k]) ** 2
        most = max(most, np.sqrt(squared))
    return most


class DepthMeter:
    """Measurement of the penetration depths after each step of a simulation, and comparison with the allowed depths.

    It covers the monitored pairs, and also the fingers with the bar that they hold. The allowed depth is the permitted
    depth plus the relative motion of the two parts in the first two steps of their overlap. If the pair was not
    monitored before these steps, its first depth is added.

    Attributes:
        worst: for each pair of parts, greatest excess of its depth over the allowed depth [m].
        deepest: for each pair of parts, greatest depth [m].
    """

    def __init__(self, sim: aftdeck.Simulation) -> None:
        self.sim, site = sim, sim._flight.site
        self.layout = site.layout
        # a packed body begins with the x of its vertices, then their y, then their z
        self.vertices = self.layout.solids[:, :24].reshape(-1, 3, 8).transpose(0, 2, 1).copy()
        middles = self.vertices.mean(axis=1, keepdims=True)
        self.radius = np.linalg.norm(self.vertices - middles, axis=2).max(axis=1)
        self.placed, self.axes = np.empty_like(self.vertices), np.zeros((len(self.layout.pairs), 3))
        groups = len(self.layout.groups)
        self.depths, self.travels, self.last = np.empty(groups), np.empty(groups), np.zeros(groups)
        self.budget, self.steps = np.zeros(groups), np.zeros(groups, np.int64)
        self.was_active, self.fingers = np.zeros(groups, np.uint8), np.zeros(groups, np.uint8)
        self.permitted = np.zeros(groups)
        for meeting in site.meetings:
            self.permitted[meeting.group] = meeting.depth
            self.fingers[meeting.group] = meeting.relation == "acquisition"
        self.worst: dict[tuple[str, str], float] = {}
        self.deepest: dict[tuple[str, str], float] = {}

    def begin(self) -> None:
        """Continue from another state of the simulation."""
        self.budget[:], self.steps[:], self.was_active[:] = 0.0, 0, 0

    def measure(self) -> None:
        """Measure the state after the last step."""
        worksite = self.sim._state.worksite
        active = worksite.watch.active | self.fingers
        place(self.vertices, self.layout.frame, worksite.frames, self.placed)
        measure(
            self.placed, self.radius, self.layout.pairs, self.layout.begins, active, worksite.before,
            worksite.frames, self.vertices, self.layout.frame, self.axes, self.depths, self.travels,
        )  # fmt: skip
        # the allowed depth includes the motion in the step in which the overlap begins
        entered = (self.depths > 0.0) & (self.steps == 0)
        self.steps = np.where(self.depths > 0.0, self.steps + 1, 0)
        known = self.was_active & active
        here = np.where(known != 0, 0.0, np.maximum(self.depths, 0.0))
        self.budget = np.where(entered, here + self.travels, self.budget + np.where(self.steps == 2, self.travels, 0.0))
        self.was_active = active
        for g in np.flatnonzero(self.depths > 0.0).tolist():
            pair = self.layout.named(g)
            over = float(self.depths[g] - self.budget[g] - self.permitted[g])
            self.worst[pair] = max(self.worst.get(pair, -np.inf), over)
            self.deepest[pair] = max(self.deepest.get(pair, 0.0), float(self.depths[g]))
