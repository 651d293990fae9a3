"""Payloads of the worksite in a MuJoCo model: free bodies, and the welds by which arm, orbiter and space hold them.

A weld is MuJoCo's equality constraint of two bodies. Its forces on the two bodies are equal and opposite, so that it
keeps the momentum of both together. A weld that begins in the payload's present pose makes no jump.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt
from typing import Any

import mujoco
import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.law import law
from aftdeck.plant.multibody.chain import set_mass
from aftdeck.plant.plant import Hold
from aftdeck.plant.state import Bodies

HOLDERS = ("hand", "orbiter", "space")
"""What can hold a payload, in the order of the columns of `Bodies.held`."""
FIRM = (0.95, 0.95, 0.001, 0.5, 2.0)
"""MuJoCo's impedance of a weld. With its default values, a light, strongly driven end effector would pull out of the
grasp of a heavy payload (derived)."""
LOOSE = (0.01, 0.01, 0.001, 0.5, 2.0)
"""MuJoCo's impedance of closing snares. With a small impedance, the weld is a damper: its force is in proportion to the
relative velocity, and it does not hinder the servos."""
NO_SPRING = 1e-6
"""Stiffness of a weld that only damps [1/s2]; MuJoCo needs a value above zero."""
SLACK, TAUT = 0.4, 8.0
"""Rates at which closing snares damp the relative motion [1/s]: the first when they begin to close; the second, times
the third power of their position, is added. With 15 t at 0.03 m/s, the force then stays below 150 N (derived)."""
_ANCHOR, _PLACE, _TURN, _TORQUE = slice(0, 3), slice(3, 6), slice(6, 10), 10
"""Parts of a weld's data in MuJoCo: anchor in the payload, its place and the payload's rotation in the holder."""


def add_payloads(spec: Any, payloads: Sequence[MassProperties], hand: str, orbiter: str) -> None:
    """Add the worksite's payloads to a specification, as free bodies that nothing holds.

    Bodies and joints are called ``cargo.K``; welds ``hand.K``, ``orbiter.K`` and ``space.K``.

    Args:
        spec: MuJoCo's specification.
        payloads: mass properties of each payload in its own frame.
        hand: name of the body of the arm's last joint.
        orbiter: name of the body whose frame is L.
    """
    for k, properties in enumerate(payloads):
        body = spec.worldbody.add_body(name=f"cargo.{k}")
        body.add_freejoint(name=f"cargo.{k}")
        set_mass(body, properties)
        for holder, name in zip(HOLDERS, (hand, orbiter, "world"), strict=True):
            spec.add_equality(
                name=f"{holder}.{k}",
                type=mujoco.mjtEq.mjEQ_WELD,
                objtype=mujoco.mjtObj.mjOBJ_BODY,
                name1=name,
                name2=f"cargo.{k}",
                active=False,
            )


class Payloads:
    """The worksite's payloads in one compiled model and its workspace."""

    def __init__(self, model: Any, data: Any) -> None:
        self._model, self._data = model, data
        self._active = data.eq_active
        self._xpos, self._xmat, self._qvel = data.xpos, data.xmat, data.qvel
        joints = [model.joint(i) for i in range(model.njnt) if model.joint(i).name.startswith("cargo.")]
        self.count = len(joints)
        self._places = np.array([int(joint.qposadr[0]) for joint in joints], dtype=np.int64)
        self._rates = np.array([int(joint.dofadr[0]) for joint in joints], dtype=np.int64)
        self._bodies = np.array([int(joint.bodyid[0]) for joint in joints], dtype=np.int64)
        self._welds = [
            {holder: int(model.equality(f"{holder}.{k}").id) for holder in HOLDERS} for k in range(self.count)
        ]
        table = [[welds[holder] for holder in HOLDERS] for welds in self._welds]
        self._table = np.array(table, dtype=np.int64).reshape(-1, len(HOLDERS))
        self._held, self._greatest = np.zeros(self._table.shape), np.zeros(self._table.shape)
        model.eq_data[:, _ANCHOR], model.eq_data[:, _TORQUE] = 0.0, 1.0

    def place(self, poses: Array, motions: Array) -> None:
        """Set poses (c, 12) in the world and motions (c, 6), as in `Bodies`; no force holds a payload yet."""
        self._held[:] = self._greatest[:] = 0.0
        for k in range(self.count):
            at, rate = self._places[k], self._rates[k]
            self._data.qpos[at : at + 3] = poses[k, :3]
            mujoco.mju_mat2Quat(self._data.qpos[at + 3 : at + 7], poses[k, 3:])
            self._data.qvel[rate : rate + 3], self._data.qvel[rate + 3 : rate + 6] = motions[k, 3:], motions[k, :3]

    def connect(self, holds: Sequence[Hold]) -> None:
        """Set the welds for one control period; a payload without a hold floats. Forget the forces so far."""
        if self.count == 0:
            return
        self._held[:] = self._greatest[:] = 0.0
        model, active = self._model, self._active
        active[:] = 0
        for hold in holds:
            weld = self._welds[hold.payload][hold.by]
            active[weld] = 1
            data = model.eq_data[weld]
            data[_PLACE] = hold.pose[:3]
            mujoco.mju_mat2Quat(data[_TURN], hold.pose[3:])
            damping = SLACK + TAUT * hold.closed**3
            held = hold.closed == 1.0
            model.eq_solref[weld] = (hold.give, 1.0) if held else (-NO_SPRING, -damping)
            model.eq_solimp[weld] = FIRM if held else LOOSE

    def add(self) -> None:
        """Find the holding forces of MuJoCo's last step, and the greatest since `connect`."""
        data = self._data
        if data.ne:
            _add_forces(self._table, data.efc_id, data.efc_force, data.ne, self._held, self._greatest)

    def write(self, bodies: Bodies) -> None:
        """Write the payloads' poses and motions from MuJoCo's present ones, and their holding forces."""
        if self.count == 0:
            return
        bodies.held[:], bodies.held_greatest[:] = self._held, self._greatest
        _write(self._bodies, self._rates, self._xpos, self._xmat, self._qvel, bodies.payloads, bodies.motions)


@law
def _write(
    bodies: Indices, rates: Indices, xpos: Array, xmat: Array, qvel: Array, poses: Array, motions: Array
) -> None:
    """Write poses and motions.

    Args:
        bodies: (c,) numbers of the payloads' bodies.
        rates: (c,) places of the payloads' velocities in `qvel`.
        xpos: (b, 3) positions of all bodies in the world [m].
        xmat: (b, 9) rotations of all bodies, row by row.
        qvel: MuJoCo's velocities.
        poses: (c, 12) output.
        motions: (c, 6) output.
    """
    for k in range(len(bodies)):
        body, at = bodies[k], rates[k]
        poses[k, :3], poses[k, 3:] = xpos[body], xmat[body]
        motions[k, :3], motions[k, 3:] = qvel[at + 3 : at + 6], qvel[at : at + 3]


@law
def _add_forces(welds: Indices, numbers: Indices, force: Array, rows: int, held: Array, greatest: Array) -> None:
    """Write holding forces, and update the greatest ones.

    Args:
        welds: (c, 3) numbers of each payload's welds.
        numbers: numbers of the objects that cause the constraints.
        force: forces of the constraints [N or N m].
        rows: number of constraints that are equalities; they come first.
        held: (c, 3) output [N].
        greatest: (c, 3) updated [N].
    """
    for k in range(welds.shape[0]):
        for h in range(welds.shape[1]):
            square, left = 0.0, 3  # the first three rows of a weld are forces, the others are torques
            for row in range(rows):
                if numbers[row] == welds[k, h] and left > 0:
                    square += force[row] * force[row]
                    left -= 1
            held[k, h] = sqrt(square)
            greatest[k, h] = max(greatest[k, h], held[k, h])
