"""Benchmarks of the compiled laws called from Python, compared with other libraries."""

from __future__ import annotations

import math

import mujoco
import numpy as np
import pinocchio

from aftdeck.arrays import Array
from aftdeck.frames import Pose
from aftdeck.kinematics.inverse import BRANCHES, rmangs
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.parts.carried import steering_setup
from aftdeck.steering.entry import limited_rates
from aftdeck.steering.layout import COMMAND, DRIVE, LAW, MOTION_ACTIVE, PLAN, RATE, REPORT, STATE, STICKS, TARGET
from aftdeck.steering.mode import AUTOMATIC_LAWS, MODES
from aftdeck.steering.modes import open_loop
from aftdeck.steering.modes import position as position_mode
from aftdeck.steering.msteer import msteer
from benchmarks.measure import SHORT, Call, Figure, Timing, absent, beside, microseconds
from benchmarks.plain import arithmetic

FULL, TINY = Timing(), SHORT
EAIK = "inverse by EAIK"

TWIST = (0.001, 0.002, 0.003, 0.1, 0.2, 0.3)
"""Twist of the tip in L [rad/s, m/s]. A joint would exceed its rate limit at this twist."""

POSE = (-0.5, 1.3, -1.8, -1.2, 0.3, -2.0)
"""Joint angles of an arm above the bay, far from every singularity [rad]."""


def rate_law(size: Timing) -> list[Figure]:
    """Measure RMSRAT with RATLMT (twelve numbers in, six out), and the same computation with other libraries."""
    scenario = load_scenario("first-flight")
    rules = steering_setup(scenario, scenario.payload).rules["ORB UNL", "coarse", 4]
    numbers, out = np.array([*scenario.initial_angles, *TWIST]), np.empty(6)
    limits = np.array(rules[RATE : RATE + 6])
    ours: Call = "f(rules, numbers, out)", {"f": limited_rates, "rules": rules, "numbers": numbers, "out": out}
    microseconds(*ours, SHORT)  # writes `out`
    figures = []
    peers = {
        "NumPy": ("chain of matrices, numpy.linalg.solve", _numpy_jacobian(scenario)),
        "Pinocchio": ("computeFrameJacobian, numpy.linalg.solve", _pinocchio_jacobian(scenario)),
        "MuJoCo": ("mj_kinematics, mj_jacSite, numpy.linalg.solve", _mujoco_jacobian(scenario)),
    }
    for name, (how, jacobian) in peers.items():

        def peer(angles: Array, twist: Array, jacobian: _Jacobian = jacobian) -> Array:
            rates = np.linalg.solve(jacobian(angles), twist)
            return np.asarray(rates * min(1.0, float((limits / np.maximum(np.abs(rates), 1e-300)).min())))

        rates = peer(numbers[:6], numbers[6:])
        assert np.allclose(rates, out, atol=1e-9), f"{name} gives {rates}, the law {out}"
        call: Call = "f(angles, twist)", {"f": peer, "angles": numbers[:6], "twist": numbers[6:]}
        figures.append(Figure(f"the same by {name}", microseconds(*call, size), "us", None, how))
    note = "one call from Python, 12 numbers in, 6 out"
    return [beside(figures[-1].name, call, 0.1, "RMSRAT with RATLMT", ours, size, note), *figures]


def steering(size: Timing) -> list[Figure]:
    """Measure one steering step of each mode: MSTEER, with its state."""
    scenario = load_scenario("loaded")
    rules_by_mode = steering_setup(scenario, scenario.payload).rules
    plain, name = arithmetic(turns=24, products=100), "plain compiled loop"
    note = "compiled by Numba: 24 sines and cosines, 600 products and sums, one call from Python"
    figures = [Figure(name, microseconds(*plain, size), "us", None, note)]
    for position, mode in MODES.items():
        if position.startswith("AUTO"):
            continue  # same laws as OPR CMD
        for law in mode.laws:
            rules = rules_by_mode[position, "coarse", law]
            command, state, report = np.zeros(COMMAND), np.zeros(STATE), np.zeros(REPORT)
            state[:6] = scenario.initial_angles
            command[LAW], command[MOTION_ACTIVE], command[DRIVE] = law, 1.0, 0.5
            command[STICKS : STICKS + 6] = 0.3
            command[TARGET : TARGET + 12] = [10.0, 0.0, -3.0, *np.eye(3).ravel()]
            if law == AUTOMATIC_LAWS["position"]:
                command[PLAN : PLAN + 6] = 0.5
                position_mode.plan(rules, command, state)
            if law == AUTOMATIC_LAWS["open loop"]:
                open_loop.plan(rules, command, state)
            names = {"f": msteer, "rules": rules, "command": command, "state": state, "report": report}
            step: Call = "f(rules, command, state, report)", names
            share = 3.2 if law == AUTOMATIC_LAWS["closed loop"] else 1.8
            figures.append(beside(name, plain, share, f"control step, {position}, law {law}", step, size))
    return figures


def inverse(size: Timing) -> list[Figure]:
    """Measure all eight branches of the closed-form inverse: RMANGS, one call from Python."""
    arm = load_scenario("first-flight").arm
    pose = arm.forward(POSE)
    names = {
        "f": rmangs,
        "arm": arm.model.links,
        "pose": np.concatenate([pose.position, pose.rotation.ravel()]),
        "angles": np.empty((BRANCHES, 6)),
        "excess": np.empty(BRANCHES),
    }
    ours, peer, note = ("f(arm, pose, angles, excess)", names), _eaik(pose), "one call from Python, packed arrays"
    return [beside(EAIK, peer, 0.26, "all eight inverse branches", ours, size, note), _by_eaik(peer, size)]


def calls(size: Timing) -> list[Figure]:
    """Measure the public calls of an arm, with their checks, beside EAIK's inverse."""
    arm, angles, twist = load_scenario("first-flight").arm, np.array(POSE), np.array(TWIST)
    pose = arm.forward(angles)
    peer = _eaik(pose)
    names = {"arm": arm, "q": angles, "t": twist, "pose": pose}
    figures = [_by_eaik(peer, size)]
    for call, share in (
        ("arm.forward(q)", 0.9),
        ("arm.jacobian(q)", 0.7),
        ("arm.singularities(q)", 0.9),
        ("arm.joint_rates(q, t)", 1.5),
        ("arm.inverse(pose)", 1.6),
        ("arm.inverse(pose, near=q)", 1.7),
    ):
        figures.append(beside(EAIK, peer, share, call, (call, names), size))
    return figures


def _by_eaik(call: Call | None, size: Timing) -> Figure:
    """Measure EAIK's inverse."""
    if call is None:
        return absent(EAIK, "us", "install eaik (dependency group `bench`)")
    return Figure(EAIK, microseconds(*call, size), "us", None, "HPRobot.IK, one call from Python")


def _eaik(pose: Pose) -> Call | None:
    """Return the call of EAIK's inverse, after a check of its first branch; None if EAIK is not installed."""
    try:
        from eaik.IK_HP import HPRobot  # noqa: PLC0415  (only `make bench` installs it)
    except ImportError:
        return None
    centres, axes = _chain(load_scenario("first-flight"))
    peer = HPRobot(axes, np.vstack([centres[0], np.diff(centres, axis=0)]))
    target = np.eye(4)
    target[:3, :3], target[:3, 3] = pose.rotation, pose.position
    tip = peer.fwdKin(peer.IK(target).Q[0])[:3, 3]
    assert np.allclose(tip, pose.position, atol=1e-6), f"EAIK's first branch gives the position {tip}"
    return "f(pose)", {"f": peer.IK, "pose": target}


class _Jacobian:
    """Function from joint angles (6,) [rad] to the (6, 6) Jacobian of the tip in L, by another library."""

    def __call__(self, angles: Array) -> Array:
        raise NotImplementedError


def _chain(scenario: Scenario) -> tuple[Array, Array]:
    """Return joint centres and tip (7, 3) [m], and joint axes (6, 3), at zero angles in L."""
    linkage = scenario.arm.model.linkage
    centres = np.cumsum(linkage.steps, axis=0)
    tip = scenario.arm.forward(np.zeros(6)).position
    return np.vstack([centres, tip]), linkage.axes


def _numpy_jacobian(scenario: Scenario) -> _Jacobian:
    centres, axes = _chain(scenario)
    crosses = [np.cross(np.eye(3), axis) for axis in axes]
    outer = [np.outer(axis, axis) for axis in axes]

    class ByNumPy(_Jacobian):
        def __call__(self, angles: Array) -> Array:
            rotation, position = np.eye(3), centres[0]
            directions, positions = [], []
            for k in range(6):
                positions.append(position)
                directions.append(rotation @ axes[k])
                c, s = math.cos(angles[k]), math.sin(angles[k])
                rotation = rotation @ (c * np.eye(3) + s * crosses[k] + (1.0 - c) * outer[k])
                position = position + rotation @ (centres[k + 1] - centres[k])
            angular = np.array(directions).T
            return np.vstack([angular, np.cross(np.array(directions), position - np.array(positions)).T])

    return ByNumPy()


def _pinocchio_jacobian(scenario: Scenario) -> _Jacobian:
    centres, axes = _chain(scenario)
    model, joint, before = pinocchio.Model(), 0, np.zeros(3)
    for k in range(6):
        step = pinocchio.SE3(np.eye(3), centres[k] - before)
        joint = model.addJoint(joint, pinocchio.JointModelRevoluteUnaligned(axes[k]), step, f"joint {k}")
        before = centres[k]
    last = pinocchio.SE3(np.eye(3), centres[6] - before)
    tip = model.addFrame(pinocchio.Frame("tip", joint, last, pinocchio.FrameType.OP_FRAME))
    data = model.createData()

    class ByPinocchio(_Jacobian):
        def __call__(self, angles: Array) -> Array:
            linear_first = pinocchio.computeFrameJacobian(model, data, angles, tip, pinocchio.LOCAL_WORLD_ALIGNED)
            return np.vstack([linear_first[3:], linear_first[:3]])

    return ByPinocchio()


def _mujoco_jacobian(scenario: Scenario) -> _Jacobian:
    centres, axes = _chain(scenario)
    spec = mujoco.MjSpec()
    body, before = spec.worldbody, np.zeros(3)
    for k in range(6):
        body = body.add_body(pos=centres[k] - before)
        body.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=axes[k])
        body.add_geom(size=[0.01, 0.0, 0.0], mass=1.0)
        before = centres[k]
    body.add_site(name="tip", pos=centres[6] - before)
    model = spec.compile()
    data, jacobian = mujoco.MjData(model), np.empty((6, 6))

    class ByMuJoCo(_Jacobian):
        def __call__(self, angles: Array) -> Array:
            data.qpos[:] = angles
            mujoco.mj_kinematics(model, data)
            mujoco.mj_comPos(model, data)
            mujoco.mj_jacSite(model, data, jacobian[3:], jacobian[:3], 0)
            return jacobian

    return ByMuJoCo()
