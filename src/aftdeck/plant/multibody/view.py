"""Access to an arm's joints and frames in a MuJoCo model, by their names."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np

from aftdeck.arms.flexures import flexures_of
from aftdeck.arms.load import ArmModel
from aftdeck.arms.switched import SwitchedJoint
from aftdeck.arrays import Array
from aftdeck.plant.multibody.chain import end_body
from aftdeck.plant.multibody.joint_laws import bends_of, poses_in_base

_DIVERGED = (mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL, mujoco.mjtWarning.mjWARN_BADQACC)


class View:
    """A compiled model with its workspace, and the places of the arm's joints and frames in it.

    Attributes:
        model: the compiled model.
        data: MuJoCo's workspace.
        has_telescope: whether the arm has a telescope.
        rows: number of the arm's frames.
        flexures: number of the arm's parts that bend.
        motors: (n,) places of the motors' angles in MuJoCo's positions.
        gearboxes: (n,) places of the gearboxes' windup; (0,) if the model is rigid.
        motor_rates: (n,) places of the motors' rates in MuJoCo's velocities.
        qpos: MuJoCo's positions, as an array of the workspace.
        qvel: MuJoCo's velocities, as an array of the workspace.
    """

    def __init__(self, model: Any, arm: ArmModel) -> None:
        self.model, self.data = model, mujoco.MjData(model)
        motors = [model.joint(f"motor.{name}") for name in arm.joints]
        self._joints = [int(joint.id) for joint in motors]
        self.motors = np.array([int(joint.qposadr[0]) for joint in motors])
        self.motor_rates = np.array([int(joint.dofadr[0]) for joint in motors])
        geared = [_find(model, mujoco.mjtObj.mjOBJ_JOINT, f"gearbox.{name}") for name in arm.joints]
        self.gearboxes = np.array([int(model.jnt_qposadr[joint]) for joint in geared if joint >= 0], dtype=np.int64)
        self._frames = np.array([model.body(name).id for name in arm.frames])
        self._orbiter = _find(model, mujoco.mjtObj.mjOBJ_BODY, "orbiter")
        self._telescope, self._drive = _switched(model, arm.telescope)
        self._prong, self._grip = _switched(model, arm.prong)
        self._height = float(arm.links[0])
        self.has_telescope, self.rows = self._telescope >= 0, len(self._frames)
        parts = flexures_of(arm) if len(self.gearboxes) else ()
        self.flexures = len(parts)
        ends = [end_body(part) for part in parts]
        self._carriers = np.array([part.frame for part in parts], dtype=np.int64)
        self._beyond = np.array([model.body(name).id for name, _ in ends], dtype=np.int64)
        self._own = np.array([own for _, own in ends]).reshape(-1, 3)
        self._ends = np.array([part.end for part in parts]).reshape(-1, 3)
        self._warnings = [self.data.warning[kind] for kind in _DIVERGED]
        self.qpos, self.qvel = self.data.qpos, self.data.qvel
        self._xpos, self._xmat = self.data.xpos, self.data.xmat

    @property
    def height(self) -> float:
        """Height of the shoulder above L's origin [m]."""
        return self._height + (float(self.qpos[self._telescope]) if self._telescope >= 0 else 0.0)

    def set_joints(self, angles: Array, rates: Array, height: float, prong: float = 0.0) -> None:
        """Set angles [rad] and rates [rad/s] of the motors, height of the shoulder and position of the prong [m].

        Nothing is bent.
        """
        self.data.qpos[self.motors], self.data.qvel[self.motor_rates] = angles, rates
        if self._telescope >= 0:
            self.data.qpos[self._telescope] = height - self._height
        if self._prong >= 0:
            self.data.qpos[self._prong] = prong

    def limit(self, stops: Array) -> None:
        """Limit the motors' angles to the hard stops (n, 2) [rad]."""
        for joint, stop in zip(self._joints, stops, strict=True):
            self.model.jnt_limited[joint], self.model.jnt_range[joint] = True, stop

    def drive_telescope(self, speed: float) -> None:
        """Set the commanded speed of the telescope, which the arm has; + lengthens it [m/s]."""
        self.data.ctrl[self._drive] = speed

    def drive_prong(self, position: float, period: float) -> None:
        """Drive the prong so that it reaches a position [m] after a time [s]."""
        if self._grip >= 0:
            self.data.ctrl[self._grip] = (position - float(self.data.qpos[self._prong])) / period

    def diverged(self) -> bool:
        """Return whether a step since the last call diverged, which MuJoCo only counts."""
        position, velocity, acceleration = self._warnings
        if not (position.number or velocity.number or acceleration.number):
            return False
        for warning in self._warnings:
            warning.number = 0
        return True

    def write_poses(self, frames: Array, bends: Array, base: Array) -> None:
        """Write poses from MuJoCo's present ones: of the arm's frames, its bent parts, and L.

        Args:
            frames: (f, 12) output: true poses of the arm's frames, in L.
            bends: (b, 6) output: bends of base and booms; (0, 6) if the model is rigid.
            base: (12,) output: pose of L, relative to its pose at the start of the run; a fixed one is not changed.
        """
        poses_in_base(self._orbiter, self._frames, self._xpos, self._xmat, base, frames)
        if self.flexures:
            bends_of(self._frames, self._carriers, self._beyond, self._xpos, self._xmat, self._own, self._ends, bends)


def _switched(model: Any, joint: SwitchedJoint | None) -> tuple[int, int]:
    """Return the places of a joint's coordinate and of its drive's input; -1 without the joint."""
    if joint is None:
        return -1, -1
    actuator = model.actuator(f"drive.{joint.driver}").id
    return int(model.joint(joint.driver).qposadr[0]), int(model.actuator_ctrladr[actuator])


def _find(model: Any, kind: Any, name: str) -> int:
    """Return the number of an object; -1 if the model has none of this name."""
    return int(mujoco.mj_name2id(model, kind, name))
