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
from aftdeck.bodies.pose import POSE, relative
from aftdeck.frames import Pose
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
            spec.add_mesh(name=f"solid.{i}", uservert=vertices.ravel())
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
        self._used = model.npair
        self._groups: dict[tuple[int, int], tuple[int, float]] = {}
        self._near = np.empty((0, 3), dtype=np.int64)
        self._force = np.empty(6)
        self.select(self._near)

    def select(self, near: Indices) -> None:
        """Name the pairs of solids that MuJoCo tests from now on.

        Args:
            near: (p, 3) group and solids of each pair; p is at most `MOST_PAIRS`.
        """
        model, count = self._model, len(near)
        if count == len(self._near) and np.array_equal(near, self._near):
            return
        self._near = near.copy()
        model.pair_geom1[: self._used], model.pair_geom2[: self._used] = self._never
        model.pair_geom1[:count], model.pair_geom2[:count] = self._geoms[near[:, 1]], self._geoms[near[:, 2]]
        self._used = count
        self._groups = {}
        for group, a, b in near.tolist():
            first, second = int(self._geoms[a]), int(self._geoms[b])
            self._groups[first, second], self._groups[second, first] = (group, 1.0), (group, -1.0)
        contact = int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
        model.opt.disableflags = model.opt.disableflags & ~contact if count else model.opt.disableflags | contact

    def touches(self, base: Array) -> tuple[Touch, ...]:
        """Return the contacts of the last step of MuJoCo, one for each pair of parts.

        Args:
            base: (12,) pose of L in the world.
        """
        model, data = self._model, self._data
        if data.ncon == 0:
            return ()
        sums: dict[int, list[Array]] = {}
        places, axes, geoms = data.contact.pos, data.contact.frame, data.contact.geom
        for i in range(data.ncon):
            mujoco.mj_contactForce(model, data, i, self._force)
            group, sign = self._groups[int(geoms[i, 0]), int(geoms[i, 1])]
            force = sign * (self._force[:3] @ axes[i].reshape(3, 3))
            sums.setdefault(group, []).append(np.concatenate([force, float(np.linalg.norm(force)) * places[i]]))
        return tuple(_touch(group, np.array(found), base) for group, found in sorted(sums.items()))


def _touch(group: int, found: Array, base: Array) -> Touch:
    """Return the sum of a group's contacts, converted to L.

    Args:
        group: the group.
        found: (k, 6) for each contact, the force [N], and its magnitude times its point [N m].
        base: (12,) pose of L in the world.
    """
    size = lengths(found[:, :3]).sum()
    there, here = np.empty(POSE), np.empty(POSE)
    there[:3] = found[:, 3:].sum(axis=0) / size if size > 0.0 else base[:3]
    there[3:] = base[3:]
    relative(base, there, here)
    x, y, z = (base[3:].reshape(3, 3).T @ found[:, :3].sum(axis=0)).tolist()
    return Touch(group, (x, y, z), (float(here[0]), float(here[1]), float(here[2])))
