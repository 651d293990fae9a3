"""Contacts in a MuJoCo model: the solids of arm, worksite and payloads, and the forces between them.

MuJoCo tests only the pairs of solids that the caller names, in a table of pairs that is part of the model. Its other
rows name two points far apart.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
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
IMPEDANCE = (0.2, 0.95, 0.01, 0.5, 2.0)
"""MuJoCo's impedance of a contact: it rises from the first to the second value over a depth of 10 mm (derived)."""
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

    def select(self, near: Indices) -> None:
        """Name the pairs of solids that MuJoCo tests from now on.

        Args:
            near: (p, 3) group and solids of each pair; p is at most `MOST_PAIRS`.
        """
        model, count = self._model, len(near)
        if count == len(self._near) and np.array_equal(near, self._near):
            return
        used, self._near = len(self._near), near.copy()
        model.pair_geom1[:used], model.pair_geom2[:used] = self._never
        model.pair_geom1[:count], model.pair_geom2[:count] = self._geoms[near[:, 1]], self._geoms[near[:, 2]]

    def touches(self, base: Array) -> tuple[Touch, ...]:
        """Return the contacts of the last step of MuJoCo, one for each pair of parts.

        Args:
            base: (12,) pose of L in the world.
        """
        data = self._data
        if data.ncon == 0:
            return ()
        found, sums = data.contact, np.empty((data.ncon, SUM))
        count = _sum_forces(
            found.geom, found.efc_address, found.friction, found.frame, found.pos,
            data.efc_force, self._near, self._geoms, base, sums,
        )  # fmt: skip
        return tuple(_touch(row) for row in sums[:count].tolist())


SUM = 7
"""Number of values in a row of `_sum_forces`: the group, the force in L [N], and the point at which it acts [m]."""


def _touch(row: list[float]) -> Touch:
    """Return a row of `_sum_forces` as a contact."""
    return Touch(int(row[0]), (row[1], row[2], row[3]), (row[4], row[5], row[6]))


@law
def _sum_forces(
    geoms: Indices,
    address: Indices,
    friction: Array,
    frames: Array,
    places: Array,
    edges: Array,
    near: Indices,
    geom_of: Indices,
    base: Array,
    sums: Array,
) -> int:
    """Sum the forces of all contacts of each group.

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
        base: (12,) pose of L in the world.
        sums: (k, 7) output: group, force on the group's second part and point, both in L.

    Returns:
        Number of groups.
    """
    count = 0
    weights = np.zeros(len(geoms))
    for c in range(len(geoms)):
        if address[c] < 0:
            continue
        f = edges[address[c] : address[c] + 4]
        normal = f[0] + f[1] + f[2] + f[3]
        first, second = friction[c, 0] * (f[0] - f[1]), friction[c, 1] * (f[2] - f[3])
        group, sign = _group_of(geoms[c, 0], geoms[c, 1], near, geom_of)
        row = 0
        while row < count and sums[row, 0] != group:
            row += 1
        if row == count:
            sums[row], weights[row], count = 0.0, 0.0, count + 1
            sums[row, 0] = group
        weights[row] += normal
        for i in range(3):
            force = sign * (normal * frames[c, i] + first * frames[c, 3 + i] + second * frames[c, 6 + i])
            away = normal * (places[c, i] - base[i])
            for j in range(3):  # from the world's axes to those of L
                sums[row, 1 + j] += base[3 + 3 * i + j] * force
                sums[row, 4 + j] += base[3 + 3 * i + j] * away
    for row in range(count):
        for j in range(3):
            sums[row, 4 + j] = sums[row, 4 + j] / weights[row] if weights[row] > 0.0 else 0.0
    return count


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
