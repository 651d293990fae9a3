"""Short scenarios, and runs with given inputs, for tests."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

import aftdeck
from aftdeck.arms.load import PorLimits
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.target import target_at
from aftdeck.simulation.frame import Frame
from aftdeck.units import POUND
from tests.loaded import arm

FOOT = 0.3048
BAY = (-31.0, 79.0, -103.0, -77.0, 17.0, -128.0)
"""Joint angles above the payload bay, far from every limit [deg]."""
QUICK = f"[limits]\nservo = {['20 deg/s'] * 6}"
"""Value of `extra`: joint rate limits so high that only the POR limits act."""
PAYLOAD = """
[payload]
mass = "{mass}"
roll = "19.48 deg"
yaw = "30 deg"
position = [0.5, 0.2, 2.6]
por = [0.3, -0.4, 0.1]
"""
"""Payload whose axes differ from frame 7, held away from its centre; `format` inserts its `mass`."""
LEAN = math.radians(19.48)
BODY_FROM_L = np.diag([-1.0, 1.0, -1.0]) @ np.array(
    [
        [1.0, 0.0, 0.0],
        [0.0, -math.cos(LEAN), math.sin(LEAN)],
        [0.0, -math.sin(LEAN), -math.cos(LEAN)],
    ]
)
"""Conversion from L (aft, port, down) to the orbiter's axes (forward, starboard, down); L leans 19.48 deg to port."""


def heavy_por() -> PorLimits:
    """Return the limits of the point of resolution of the Shuttle's arm with 32,000 lb."""
    return arm().model.por_limits(32_000.0 * POUND)


def scenario(joints: Sequence[float] = BAY, extra: str = "", name: str = "test") -> Scenario:
    """Return a scenario that starts at joint angles [deg], in empty space unless `extra` names a worksite."""
    head, _, tables = extra.partition("\n[")
    place = "" if "worksite" in head else 'worksite = "space"\n'
    text = f'title = "test"\n{place}{head}\n[initial]\njoints = {[f"{q!r} deg" for q in map(float, joints)]}\n'
    return parse_scenario(text + (f"[{tables}" if tables else ""), name, f"{name}.toml", Path("."))


def fly(sim: aftdeck.Simulation, seconds: float, inputs: aftdeck.Inputs) -> list[Frame]:
    """Return the frames of a run with constant sticks; switches act in the first step."""
    first, held = inputs, aftdeck.Inputs(inputs.translation, inputs.rotation, inputs.drive)
    steps = round(seconds / sim.scenario.control_period)
    return [sim.step(first if k == 0 else held) for k in range(steps)]


def disturbed(sim: aftdeck.Simulation, joints: Mapping[int, float]) -> None:
    """Set joints of the plant to angles [deg]; the steering measures them in the next step."""
    for joint, angle in joints.items():
        sim._state.plant.angles[joint] = math.radians(angle)


def joint_target(arm: aftdeck.Arm, joints: Sequence[float]) -> aftdeck.Target:
    """Return a target with joint angles [deg]."""
    a, b, c, d, e, f = (math.radians(q) for q in joints)
    return target_at(arm.forward((a, b, c, d, e, f)), (a, b, c, d, e, f))


def log_of(frames: Sequence[Frame]) -> list[str]:
    """Return the log lines."""
    return [event.text for frame in frames for event in frame.events]


def finished(sim: aftdeck.Simulation, first: aftdeck.Inputs, seconds: float) -> list[Frame]:
    """Return the frames of a check and its automatic motion, until the motion ends or a time [s] has passed."""
    frames = [sim.step(first)]
    while frames[-1].sequence in {"checking", "in progress"} and frames[-1].time_s - frames[0].time_s < seconds:
        frames.append(sim.step(aftdeck.Inputs()))
    return frames


def checked(sim: aftdeck.Simulation, first: aftdeck.Inputs | None = None, seconds: float = 60.0) -> list[Frame]:
    """Return the frames from an operator's command to the verdict of CMD CK."""
    frames = [sim.step(first or aftdeck.Inputs())]
    while frames[-1].sequence == "checking":
        assert frames[-1].time_s - frames[0].time_s < seconds
        frames.append(sim.step(aftdeck.Inputs()))
    return frames


def target(arm: aftdeck.Arm, joints: Sequence[float]) -> aftdeck.Target:
    """Return the tip's pose at joint angles [deg] as a target."""
    pose = arm.forward(np.radians(joints))
    rows = pose.rotation.tolist()
    return aftdeck.Target(tuple(pose.position.tolist()), (tuple(rows[0]), tuple(rows[1]), tuple(rows[2])))


def speed(frame: Frame) -> float:
    """Return the commanded speed of the tip [m/s]."""
    return math.hypot(*frame.twist_commanded[3:])


def turning(frame: Frame) -> float:
    """Return the commanded angular rate of the tip [rad/s]."""
    return math.hypot(*frame.twist_commanded[:3])


def kinds(frame: Frame) -> set[str]:
    """Return the kinds of the limits that acted."""
    return {limit.kind for limit in frame.limits}


def at_rate(frame: Frame) -> bool:
    """Return whether a joint is commanded at its rate limit."""
    return any(abs(r) >= m * (1 - 1e-9) for r, m in zip(frame.rates_commanded, frame.rate_limits, strict=True))
