"""Models of an arm in MuJoCo and in Pinocchio, built from joint centres and axes alone."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import mujoco
import numpy as np
import pinocchio

from aftdeck.arrays import Array


class TipResult(NamedTuple):
    """Pose and Jacobian of the tip from a model, in the coordinate frame of the joint centres."""

    position: Array
    rotation: Array
    jacobian: Array
    """(6, 6): rows for the angular velocity, then for the linear velocity."""


Solver = Callable[[Array], TipResult]


class Chain(NamedTuple):
    """An arm at zero angles: six joint centres and the tip (7, 3) [m], joint axes (6, 3), axes of the tip (3, 3)."""

    centres: Array
    axes: Array
    tip: Array


def in_mujoco(chain: Chain) -> Solver:
    """Build the chain from MuJoCo bodies, each with a hinge at its origin."""
    spec = mujoco.MjSpec()
    body, before = spec.worldbody, np.zeros(3)
    for k in range(6):
        body = body.add_body(pos=chain.centres[k] - before)
        body.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=chain.axes[k])
        body.add_geom(size=[0.01, 0.0, 0.0], mass=1.0)
        before = chain.centres[k]
    quaternion = np.empty(4)
    mujoco.mju_mat2Quat(quaternion, np.ascontiguousarray(chain.tip).ravel())
    body.add_site(name="tip", pos=chain.centres[6] - before, quat=quaternion)
    model = spec.compile()
    data = mujoco.MjData(model)

    def solve(q: Array) -> TipResult:
        data.qpos[:] = q
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        linear, angular = np.empty((3, 6)), np.empty((3, 6))
        mujoco.mj_jacSite(model, data, linear, angular, 0)
        site = data.site("tip")
        return TipResult(np.array(site.xpos), np.array(site.xmat).reshape(3, 3), np.vstack([angular, linear]))

    return solve


def in_pinocchio(chain: Chain) -> Solver:
    """Build the chain from Pinocchio revolute joints, each about an axis of any direction."""
    model, joint, before = pinocchio.Model(), 0, np.zeros(3)
    for k in range(6):
        placement = pinocchio.SE3(np.eye(3), chain.centres[k] - before)
        joint = model.addJoint(joint, pinocchio.JointModelRevoluteUnaligned(chain.axes[k]), placement, f"joint {k}")
        before = chain.centres[k]
    placement = pinocchio.SE3(chain.tip, chain.centres[6] - before)
    tip = model.addFrame(pinocchio.Frame("tip", joint, placement, pinocchio.FrameType.OP_FRAME))
    data = model.createData()

    def solve(q: Array) -> TipResult:
        matrix = pinocchio.computeFrameJacobian(model, data, q, tip, pinocchio.LOCAL_WORLD_ALIGNED)
        pinocchio.framesForwardKinematics(model, data, q)
        pose = data.oMf[tip]
        return TipResult(np.array(pose.translation), np.array(pose.rotation), np.vstack([matrix[3:], matrix[:3]]))

    return solve
