"""Gauges: loads inside the arm, and velocities of the bodies, from MuJoCo's workspace after a step.

A load is what the bodies beyond a cut need for their motion, less what contacts, welds and jets give them (Newton and
Euler, by MuJoCo's `mj_rnePostConstraint`). The accelerations are those that the step made: the change of the velocities
divided by the duration of the step. MuJoCo's own `qacc` differs from them, because the integrator is implicit in the
damping of servos, brakes and springs.
"""

from __future__ import annotations

from math import sqrt

import mujoco
import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array, Indices
from aftdeck.law import law
from aftdeck.matrices import product
from aftdeck.plant.multibody.view import View
from aftdeck.plant.readings import CUTS, Load, Readings
from aftdeck.tuples import plain_vector

LOAD = 8
"""Numbers of a load: force [N] and moment [N m] at the end of a step, and the greatest size of each."""


class Gauges:
    """Gauges of one model."""

    def __init__(self, view: View, arm: ArmModel) -> None:
        model = view.model
        self._model, self._data = model, view.data
        rows = (*arm.linkage.arms, arm.linkage.arms[-1])[:2]  # an arm with one joint has both cuts at it
        booms = [model.body(arm.linkage.frames[row]).id for row in rows]
        self._bodies = np.array([*booms, model.body("payload").id])
        self._axes = np.array([*booms, model.body(arm.linkage.frames[-1]).id])
        self._roots = np.array(model.body_rootid[self._bodies], dtype=np.int64)
        numbers = range(sum(model.body(k).name.startswith("cargo.") for k in range(model.nbody)))
        self._payloads = [model.body(f"cargo.{k}").id for k in numbers]
        self._rates = [int(model.joint(f"cargo.{k}").dofadr[0]) for k in numbers]
        self._welds = [int(model.equality(f"hand.{k}").id) for k in numbers]
        self._orbiter = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, "orbiter")
        self._before = np.empty(model.nv)
        self._loads = np.zeros((len(CUTS), LOAD))

    def clear(self) -> None:
        """Begin the greatest loads of a control step."""
        self._loads[:] = 0.0

    def step(self) -> None:
        """Make a step of MuJoCo, and measure the loads in it."""
        model, data = self._model, self._data
        self._before[:] = data.qvel
        mujoco.mj_step(model, data)
        data.qacc[:] = (data.qvel - self._before) / model.opt.timestep
        mujoco.mj_rnePostConstraint(model, data)
        measure_loads(
            self._bodies, self._roots, self._axes, data.cfrc_int, data.subtree_com, data.xpos, data.xmat,
            self._held_load(), self._loads,
        )  # fmt: skip

    def _held_load(self) -> Array:
        """Return the load (6,) by which welds of the end effector act on payloads of the worksite, about the tip.

        Force [N] and moment [N m] have the axes of the world.
        """
        data, load = self._data, np.zeros(6)
        for weld, body, at in zip(self._welds, self._payloads, self._rates, strict=True):
            if not data.eq_active[weld]:
                continue
            ours = (data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY) & (data.efc_id == weld)
            found = np.empty(self._model.nv)
            mujoco.mj_mulJacTVec(self._model, data, found, np.where(ours, data.efc_force, 0.0))
            force, torque = found[at : at + 3], product(data.xmat[body].reshape(3, 3), found[at + 3 : at + 6])
            load[:3] += force
            load[3:] += torque + np.cross(data.xpos[body] - data.xpos[self._bodies[-1]], force)
        return load

    def read(self) -> Readings:
        """Return the readings after a control step; MuJoCo's poses are those after it, too."""
        loads = [
            Load(cut, (row[0], row[1], row[2]), (row[3], row[4], row[5]), row[6], row[7])
            for cut, row in zip(CUTS, self._loads.tolist(), strict=True)
        ]
        turn, velocity, axes = np.zeros(3), np.zeros(3), np.eye(3)
        if self._orbiter >= 0:
            at, body = int(self._model.jnt_dofadr[self._orbiter]), int(self._model.jnt_bodyid[self._orbiter])
            axes = self._data.xmat[body].reshape(3, 3)
            turn, velocity = self._data.qvel[at + 3 : at + 6], product(axes.T, self._data.qvel[at : at + 3])
        rates = [
            self._data.qvel[at + 3 : at + 6] - product(self._data.xmat[body].reshape(3, 3).T, product(axes, turn))
            for body, at in zip(self._payloads, self._rates, strict=True)
        ]
        return Readings(tuple(loads), plain_vector(turn), plain_vector(velocity), tuple(map(plain_vector, rates)))


@law
def measure_loads(
    bodies: Indices,
    roots: Indices,
    axes: Indices,
    inside: Array,
    centres: Array,
    xpos: Array,
    xmat: Array,
    held: Array,
    loads: Array,
) -> None:
    """Write the loads at all cuts, and raise the greatest ones.

    Args:
        bodies: (3,) numbers of the bodies beyond the cuts, whose origins are the places of the cuts.
        roots: (3,) numbers of the roots of these bodies' trees.
        axes: (3,) numbers of the bodies in whose axes the loads are written.
        inside: (b, 6) MuJoCo's moment [N m] and force [N] on each body by its parent, in the axes of the world, about
            the centre of mass of its tree.
        centres: (b, 3) centres of mass of all trees [m].
        xpos: (b, 3) positions of all bodies in the world [m].
        xmat: (b, 9) rotations of all bodies, row by row.
        held: (6,) force and moment that act at the last cut besides, in the axes of the world.
        loads: (3, 8) output, rows as `LOAD`.
    """
    last = len(bodies) - 1
    load = np.empty(6)
    for n in range(len(bodies)):
        body, root, to = bodies[n], roots[n], axes[n]
        fx, fy, fz = inside[body, 3], inside[body, 4], inside[body, 5]
        x, y, z = centres[root, 0] - xpos[body, 0], centres[root, 1] - xpos[body, 1], centres[root, 2] - xpos[body, 2]
        load[0], load[1], load[2] = fx, fy, fz
        load[3] = inside[body, 0] + (y * fz - z * fy)
        load[4] = inside[body, 1] + (z * fx - x * fz)
        load[5] = inside[body, 2] + (x * fy - y * fx)
        if n == last:
            for i in range(6):
                load[i] += held[i]
        for half in range(2):
            at, square = 3 * half, 0.0
            for i in range(3):
                found = 0.0
                for j in range(3):
                    found += xmat[to, 3 * j + i] * load[at + j]
                loads[n, at + i] = found
                square += found * found
            loads[n, 6 + half] = max(loads[n, 6 + half], sqrt(square))
