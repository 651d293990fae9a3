"""`strict` runs the steering as published, and `guards` is a separate setting."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.frames import oriend
from aftdeck.scenario.load import parse_scenario
from tests.each import each, seeds
from tests.reference.tables import table
from tests.steering.flying import finished, fly, kinds, scenario, target

HARD = np.radians(table("srms-limits")["hard"])


def by_rmangs(arm: aftdeck.Arm, position: Array, rotation: Array) -> Array:
    """Return the panel's joint angles by the flowchart of RMANGS, with theta_2 by an arc tangent."""
    l1, l2, l3, l4, l5, upper, lower = arm.model.links[:7]
    r = position - l5 * rotation[:, 0] + [0.0, 0.0, l1]
    q1 = math.atan2(r[1], r[0])
    c, s = math.cos(q1), math.sin(q1)
    b = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]) @ rotation
    q5, q6 = math.asin(b[1, 0]), math.atan2(-b[1, 2], b[1, 1])
    beta = math.atan2(-b[2, 0], b[0, 0])
    alpha = r[0] * c + r[1] * s - l4 * math.cos(beta)
    gamma = -r[2] - l4 * math.sin(beta)
    q3 = -math.acos((gamma**2 + alpha**2 - l2**2 - l3**2) / (2 * l2 * l3))
    a, d = l2 + l3 * math.cos(q3), l3 * math.sin(q3)
    q2 = math.atan2(gamma * a - alpha * d, alpha * a + gamma * d)
    return np.array([q1, q2 - upper, q3 + upper - lower, beta - q2 - q3 + lower, q5, q6])


@each("seed", seeds(6, 60))
def test_start_given_by_pose_uses_branch_of_rmangs(seed: int) -> None:
    rng, arm = np.random.default_rng(seed), aftdeck.load_arm("srms")
    while True:
        pose = arm.forward(rng.uniform([-3, 0.1, -2.6, -2, -2, -3], [3, 2.4, -0.1, 2, 2, 3]))
        try:
            expected = by_rmangs(arm, pose.position, pose.rotation)
        except ValueError:  # "ARM CANNOT REACH POSITION GIVEN" on this branch
            continue
        if ((expected >= HARD[:, 0]) & (expected <= HARD[:, 1])).all():
            break
    shown = arm.model.mount.to("orbiter", pose)
    roll, pitch, yaw = oriend(shown.rotation)
    place = f"position = {shown.position.tolist()}, roll = {roll!r}, pitch = {pitch!r}, yaw = {yaw!r}"
    text = f'title = "t"\nworksite = "space"\nstrict = true\n[initial]\npose = {{ {place} }}\n'
    made = parse_scenario(text, "t", "t.toml", Path("."))
    assert made.initial_angles == pytest.approx(expected, abs=1e-9)


BENT = (0.0, 60.0, -30.0, 20.0, 20.0, 0.0)
"""Joint angles [deg] with a nearly straight elbow, which outward motion of the tip straightens further."""
OUTWARDS = aftdeck.Inputs(translation=(1.0, 0.0, 0.0), mode="END EFF")


@pytest.mark.parametrize(
    ("lines", "slows"),
    [("", True), ("guards = false", False), ("strict = true", False), ("strict = true\nguards = true", True)],
)
def test_only_guards_slow_the_arm_before_a_singularity(lines: str, slows: bool) -> None:
    frames = fly(aftdeck.Simulation(scenario(BENT, lines)), 20.0, OUTWARDS)
    assert any("singularity" in kinds(frame) for frame in frames) == slows
    assert (min(abs(frame.singularity[1]) for frame in frames) > 0.02) == slows


@pytest.mark.parametrize(
    ("lines", "stops"), [("", True), ("strict = true", False), ("strict = true\nguards = true", True)]
)
def test_only_guards_keep_joints_inside_soft_stops(lines: str, stops: bool) -> None:
    start = (0.0, 60.0, -80.0, 112.0, 0.0, 0.0)
    sim = aftdeck.Simulation(scenario(start, lines))
    frames = fly(sim, 30.0, aftdeck.Inputs(rotation=(0.0, 1.0, 0.0), mode="END EFF"))
    wrist = np.degrees([frame.angles[3] for frame in frames])
    assert wrist.max() <= 121.4 + 1e-9
    assert (wrist.max() <= 116.4 + 1e-6) == stops


def test_strict_mode_2_ends_with_the_time_of_vclose() -> None:
    sim = aftdeck.Simulation(scenario((-31.0, 79.0, -103.0, -77.0, 17.0, -128.0), 'strict = true\nmode = "OPR CMD"'))
    goal = target(sim.scenario.arm, (-25.0, 79.0, -103.0, -77.0, 17.0, -128.0))
    frames = finished(sim, aftdeck.Inputs(target=goal, proceed=True), 120.0)
    assert frames[-2].goal is not None and frames[-2].goal.remaining_s == 0.0
    assert all(f.goal is not None and f.goal.remaining_s > 0.0 for f in frames[-40:-2])
