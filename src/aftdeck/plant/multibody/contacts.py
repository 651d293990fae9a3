"""Contacts in a MuJoCo model: the solids of arm, worksite and payloads, and the forces between them.

MuJoCo tests only the pairs of solids that the caller names, in a table of pairs that is part of the model. Its other
rows name two points far apart.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import sqrt
from typing import Any

import mujoco
import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.frames import Pose
from aftdeck.law import law
from aftdeck.matrices import lengths, product
from aftdeck.plant.plant import MOST_PAIRS
from aftdeck.plant.state import Touch

SOFTNESS = (0.1, 1.0)
"""Time constant [s] and damping ratio [1] of a contact. With 0.02 s, trunnions in their guides would bounce 180 times
(derived); a real contact's stiffness is not known."""
IMPEDANCE = (0.01, 0.95, 0.01, 0.5, 2.0)
"""MuJoCo's impedance of a contact: it rises from the first to the second value over a depth of 10 mm.

The force of a contact that just begins is in proportion to the first value; with 0.2, a steady press of the arm would
chatter (derived)."""
FRICTION = 0.3
"""Coefficient of friction [1]; metal on metal has 0.1 to 0.6 (assumed)."""
_APART = 1e4
"""Distance of the two points that never touch [m]."""
_ROUNDING = 1e-9
"""Greatest deviation of a box's vertices from a box, for each metre of its size [1]."""


def add_solids(
    spec: Any, solids: Sequence[Array], frames: Sequence[str], homes: Mapping[str, tuple[Any, Pose]]
) -> None:
    """Add solids to a specification. Boxes are MuJoCo's boxes, other hexahedra are meshes.

    Args:
        spec: MuJoCo's specification.
        solids: vertices (8, 3) of each solid, in its frame [m].
        frames: name of each solid's frame.
        homes: for each frame, the body that carries it, and the frame's pose in this body.
    """
    never = [spec.worldbody.add_geom(name=f"never.{k}", size=[1e-3, 0, 0], pos=[k * _APART, 0, _APART]) for k in (0, 1)]
    for i, (own, frame) in enumerate(zip(solids, frames, strict=True)):
        body, pose = homes[frame]
        vertices = product(own, pose.rotation.T) + pose.position
        box = _as_box(vertices)
        if box is None:
            mesh = spec.add_mesh(name=f"solid.{i}", uservert=vertices.ravel())
            mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL  # otherwise MuJoCo rejects the smallest solids
            geom = body.add_geom(name=f"solid.{i}", type=mujoco.mjtGeom.mjGEOM_MESH, meshname=f"solid.{i}")
        else:
            geom = body.add_geom(name=f"solid.{i}", type=mujoco.mjtGeom.mjGEOM_BOX, **box)
        never.append(geom)
    for geom in never:
        geom.mass, geom.contype, geom.conaffinity = 0.0, 0, 0
    for _ in range(MOST_PAIRS if len(solids) else 0):
        pair = spec.add_pair(geomname1="never.0", geomname2="solid.0")
        pair.solref, pair.solimp, pair.condim = SOFTNESS, IMPEDANCE, 3
        pair.friction = [FRICTION, FRICTION, 0.0, 0.0, 0.0]


def _as_box(vertices: Array) -> dict[str, Any] | None:
    """Return place, axes and half sizes of a box from its vertices (8, 3); None if they are not those of a box."""
    edges = vertices[[2, 4, 1]] - vertices[0]
    sizes = lengths(edges)
    numbers = np.arange(8)
    corners = np.stack([numbers >> 1 & 1, numbers >> 2 & 1, numbers & 1], axis=1) @ edges + vertices[0]
    axes = edges / sizes[:, None]
    deviation = max(float(np.abs(corners - vertices).max()), float(np.abs(axes @ axes.T - np.eye(3)).max()))
    if deviation > _ROUNDING * max(1.0, float(sizes.max())):
        return None
    rotation, quaternion = axes.T * [1.0, 1.0, np.linalg.det(axes)], np.empty(4)
    mujoco.mju_mat2Quat(quaternion, rotation.ravel())
    return {"pos": vertices.mean(axis=0), "quat": quaternion, "size": 0.5 * sizes}


class ContactPairs:
    """Table of the pairs of solids that MuJoCo tests, and the forces between them."""

    def __init__(self, model: Any, data: Any) -> None:
        self._model, self._data = model, data
        names = [model.geom(k).name for k in range(model.ngeom)]
        self._geoms = np.array([k for k in range(model.ngeom) if names[k].startswith("solid.")], dtype=np.int64)
        order = np.argsort([int(names[k].removeprefix("solid.")) for k in self._geoms.tolist()])
        self._geoms = self._geoms[order]
        self._never = [names.index("never.0"), names.index("never.1")]
        model.pair_geom1[:], model.pair_geom2[:] = self._never
        self._near = np.empty((0, 3), dtype=np.int64)
        self._sums, self._count = np.empty((MOST_PAIRS, SUM)), 0

    def select(self, near: Indices) -> None:
        """Name the pairs of solids that MuJoCo tests from now on, and forget the forces so far.

        Args:
            near: (p, 3) group and solids of each pair; p is at most `MOST_PAIRS`.
        """
        model, count = self._model, len(near)
        self._count = 0
        if count == len(self._near) and np.array_equal(near, self._near):
            return
        used, self._near = len(self._near), near.copy()
        model.pair_geom1[:used], model.pair_geom2[:used] = self._never
        model.pair_geom1[:count], model.pair_geom2[:count] = self._geoms[near[:, 1]], self._geoms[near[:, 2]]

    def add(self) -> None:
        """Add the forces of MuJoCo's last step."""
        data = self._data
        if data.ncon == 0:
            return
        found = data.contact
        self._count = _add_forces(
            found.geom, found.efc_address, found.friction, found.frame, found.pos,
            data.efc_force, self._near, self._geoms, self._sums, self._count,
        )  # fmt: skip

    def touches(self, base: Array, steps: int) -> tuple[Touch, ...]:
        """Return the forces since `select`, one for each pair of parts that pushed each other.

        Args:
            base: (12,) pose of L in the world.
            steps: number of steps of MuJoCo since then.
        """
        if self._count == 0:
            return ()
        rows = np.empty((self._count, TOUCH))
        _write_touches(self._sums[: self._count], base, steps, rows)
        return tuple(
            Touch(int(row[0]), (row[1], row[2], row[3]), (row[4], row[5], row[6]), row[7]) for row in rows.tolist()
        )


SUM = 12
"""Number of values in a row of `_add_forces`, in the world: the group; the sum over the steps of the force on the
group's second part [N]; the sum of its points of action, weighted by the normal forces, and the sum of these weights;
the greatest size of the force in a step; and the force in the last step."""
TOUCH = 8
"""Number of values in a row of `_write_touches`, in L: group, mean force, point of action, and greatest force."""


@law
def _add_forces(
    geoms: Indices,
    address: Indices,
    friction: Array,
    frames: Array,
    places: Array,
    edges: Array,
    near: Indices,
    geom_of: Indices,
    sums: Array,
    count: int,
) -> int:
    """Add the forces of all contacts of a step to the sums of their groups.

    MuJoCo states a contact's force by the four edges of a friction pyramid: along the normal plus or minus the friction
    coefficient times each tangent.

    Args:
        geoms: (k, 2) geometries of each contact.
        address: (k,) index of the first of the contact's edges in `edges`; negative if there is no force.
        friction: (k, 5) friction coefficients; the first two are those of the tangents.
        frames: (k, 9) normal, from the first to the second geometry, and two tangents, in the world.
        places: (k, 3) points in the world [m].
        edges: forces along the edges [N].
        near: (p, 3) as `Surroundings.near`.
        geom_of: (n,) geometry of each solid.
        sums: (p, 12) sums of each group, rows as in `SUM`; updated.
        count: number of rows so far.

    Returns:
        Number of rows.
    """
    for row in range(count):
        sums[row, 9:] = 0.0
    for c in range(len(geoms)):
        if address[c] < 0:
            continue
        f = edges[address[c] : address[c] + 4]
        normal = f[0] + f[1] + f[2] + f[3]
        if normal <= 0.0:
            continue
        first, second = friction[c, 0] * (f[0] - f[1]), friction[c, 1] * (f[2] - f[3])
        group, sign = _group_of(geoms[c, 0], geoms[c, 1], near, geom_of)
        row = 0
        while row < count and sums[row, 0] != group:
            row += 1
        if row == count:
            sums[row], count = 0.0, count + 1
            sums[row, 0] = group
        sums[row, 7] += normal
        for i in range(3):
            force = sign * (normal * frames[c, i] + first * frames[c, 3 + i] + second * frames[c, 6 + i])
            sums[row, 1 + i] += force
            sums[row, 9 + i] += force
            sums[row, 4 + i] += normal * places[c, i]
    for row in range(count):
        sums[row, 8] = max(sums[row, 8], sqrt(sums[row, 9] ** 2 + sums[row, 10] ** 2 + sums[row, 11] ** 2))
    return count


@law
def _write_touches(sums: Array, base: Array, steps: int, rows: Array) -> None:
    """Write the forces of all groups in L.

    Args:
        sums: (r, 12) sums of the groups, rows as in `SUM`.
        base: (12,) pose of L in the world.
        steps: number of steps over which the mean is taken.
        rows: (r, 8) output, rows as in `TOUCH`.
    """
    for r in range(len(sums)):
        rows[r, 0], rows[r, 7] = sums[r, 0], sums[r, 8]
        for j in range(3):  # from the world's axes to those of L
            rows[r, 1 + j] = rows[r, 4 + j] = 0.0
            for i in range(3):
                rows[r, 1 + j] += base[3 + 3 * i + j] * sums[r, 1 + i] / steps
                rows[r, 4 + j] += base[3 + 3 * i + j] * (sums[r, 4 + i] / sums[r, 7] - base[i])


@law
def _group_of(a: int, b: int, near: Indices, geom_of: Indices) -> tuple[int, float]:
    """Return the group of a contact of two geometries; 1 if `a` belongs to the group's first part, else -1."""
    for p in range(len(near)):
        first, second = geom_of[near[p, 1]], geom_of[near[p, 2]]
        if first == a and second == b:
            return near[p, 0], 1.0
        if first == b and second == a:
            return near[p, 0], -1.0
    return -1, 1.0
