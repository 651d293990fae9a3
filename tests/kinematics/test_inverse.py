"""RMANGS: all branches, round trips, order, revolutions, limits, and rejected poses."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.errors import InputError, SingularityError, UnreachableError
from aftdeck.frames import Pose
from aftdeck.kinematics.inverse import BRANCHES, rmangs
from tests.kinematics.poses import STRAIGHT, apart, legal, over_the_shoulder
from tests.reference.tables import table

MADE_UP = Path(__file__).parents[1] / "arms" / "made-up.toml"


def anywhere(seed: int, count: int) -> Array:
    """Return random angles (count, 6) in a full turn, without limits."""
    return np.random.default_rng(seed).uniform(-math.pi, math.pi, (count, 6))


def all_branches(arm: aftdeck.Arm, q: Array) -> tuple[Array, Array]:
    """Return the angles (n, 8, 6) and excess (n, 8) that RMANGS gives for the poses of the joint angles `q` (n, 6)."""
    pose = arm.forward(q)
    packed = np.concatenate([pose.position, pose.rotation.reshape(-1, 9)], axis=1)
    angles, excess = np.empty((len(q), BRANCHES, 6)), np.empty((len(q), BRANCHES))
    for i, row in enumerate(packed):
        rmangs(arm.model.links, row, angles[i], excess[i])
    return angles, excess


def nearness(arm: aftdeck.Arm, q: Array) -> Array:
    """Return the distance from the nearest singularity."""
    return np.asarray(np.abs(np.stack(arm.singularities(q))).min(axis=0))


@pytest.mark.parametrize("where", ["legal", "anywhere"])
def test_each_branch_of_50000_poses_maps_back_and_one_is_the_original(any_arm: aftdeck.Arm, where: str) -> None:
    q = legal(any_arm, 10, 50_000) if where == "legal" else anywhere(11, 50_000)
    angles, excess = all_branches(any_arm, q)
    found = excess == 0.0
    pose, back = any_arm.forward(q), any_arm.forward(angles)
    off = np.linalg.norm(back.position - pose.position[:, None], axis=2)
    turned = np.abs(back.rotation - pose.rotation[:, None]).max(axis=(2, 3))
    assert max(off[found].max(), turned[found].max()) < 1e-9
    # the error of the angles is inversely proportional to the distance from a singularity
    near = nearness(any_arm, q)
    miss = np.where(found, np.abs(apart(angles, q[:, None])).max(axis=2), np.inf).min(axis=1)
    assert (miss * near)[near > 1e-5].max() < 1e-11
    # each shoulder and wrist branch has two elbow solutions or none
    assert (found[:, 0::2] == found[:, 1::2]).all()
    if where == "anywhere":
        original = np.where(found, np.abs(apart(angles, q[:, None])).max(axis=2), np.inf).argmin(axis=1)
        assert set(original) == set(range(BRANCHES))


def test_branches_away_from_singularities_are_distinct(any_arm: aftdeck.Arm) -> None:
    q = anywhere(12, 3000)
    q = q[nearness(any_arm, q) > 0.05]
    angles, excess = all_branches(any_arm, q)
    for rows, found in zip(angles, excess == 0.0, strict=True):
        solutions = rows[found]
        for i, one in enumerate(solutions):
            assert all(np.abs(apart(one, other)).max() > 1e-3 for other in solutions[:i])


@pytest.mark.parametrize("name", ["srms", str(MADE_UP), "concept-1972"])
def test_inverse_returns_the_original_angles_first_when_near(name: str) -> None:
    arm = aftdeck.load_arm(name)
    for q in legal(arm, 13, 400):
        if nearness(arm, q) < 1e-4 or np.abs(q[:4]).max() > math.pi - 1e-6:
            continue
        pose = arm.forward(q)
        found = arm.inverse(pose, near=q)
        assert found[0] == pytest.approx(q, abs=1e-7)
        assert 1 <= len(found) <= 8
        assert (found >= arm.limits.hard[:, 0] - 1e-9).all() and (found <= arm.limits.hard[:, 1] + 1e-9).all()
        back = arm.forward(found)
        assert np.abs(back.position - pose.position).max() < 1e-9
        assert np.abs(back.rotation - pose.rotation).max() < 1e-9


def test_inverse_returns_shoulder_yaw_of_180_deg_on_the_near_side(arm: aftdeck.Arm) -> None:
    for yaw in (math.pi, -math.pi):
        q = np.array([yaw, 1.0, -1.2, 0.3, 0.2, 0.1])
        assert arm.inverse(arm.forward(q), near=q)[0] == pytest.approx(q, abs=1e-9)


def test_solutions_are_sorted_by_their_distance_from_near(any_arm: aftdeck.Arm) -> None:
    rng = np.random.default_rng(14)
    for q in legal(any_arm, 14, 100):
        if nearness(any_arm, q) < 1e-3:
            continue
        near = rng.uniform(-1.0, 1.0, 6)
        ways = np.linalg.norm(any_arm.inverse(any_arm.forward(q), near=near, limits=False) - near, axis=1)
        assert (np.diff(ways) >= 0.0).all()


def test_pose_well_inside_reach_has_eight_solutions_without_limits(arm: aftdeck.Arm) -> None:
    pose = arm.forward(np.radians([30, 70, -90, 40, 20, 10]))
    assert len(arm.inverse(pose, limits=False)) == 8


@pytest.mark.parametrize("turns", [-1, 0, 1])
def test_wrist_roll_is_in_the_revolution_nearest_to_near(arm: aftdeck.Arm, turns: int) -> None:
    q = np.radians([30, 70, -90, 40, 20, 60 + 360 * turns])
    assert arm.inverse(arm.forward(q), near=q)[0] == pytest.approx(q, abs=1e-9)


def test_wrist_roll_is_within_half_a_turn_without_near(arm: aftdeck.Arm) -> None:
    q = np.radians([30, 70, -90, 40, 20, 420])
    found = arm.inverse(arm.forward(q))
    assert np.abs(found[:, 5]).max() <= math.pi
    assert any(apart(row, q) == pytest.approx(np.zeros(6), abs=1e-9) for row in found)


def test_wrist_roll_stays_inside_its_stops_for_any_near(arm: aftdeck.Arm) -> None:
    pose = arm.forward(np.radians([30, 70, -90, 40, 20, 60]))
    found = arm.inverse(pose, near=np.radians([30, 70, -90, 40, 20, 1000]))
    assert any(row[5] == pytest.approx(math.radians(420), abs=1e-9) for row in found)
    free = arm.inverse(pose, near=np.radians([30, 70, -90, 40, 20, 1000]), limits=False)
    assert any(row[5] == pytest.approx(math.radians(60 + 1080), abs=1e-9) for row in free)


def test_limits_exclude_exactly_the_solutions_outside_the_stops(arm: aftdeck.Arm) -> None:
    low, high = np.radians(table("srms-limits")["hard"]).T
    refused = 0
    for q in legal(arm, 15, 300):
        if nearness(arm, q) < 1e-3 or np.abs(q[:4]).max() > math.pi - 1e-6:
            continue
        pose = arm.forward(q)
        free, held = arm.inverse(pose, limits=False), arm.inverse(pose)
        inside = free[((free >= low - 1e-9) & (free <= high + 1e-9)).all(axis=1)]
        refused += len(free) - len(inside)
        assert held == pytest.approx(inside)
    assert refused > 300


@pytest.mark.parametrize("beyond", [1e-3, 0.25, 20.0])
def test_pose_out_of_reach_is_rejected_with_its_excess(arm: aftdeck.Arm, beyond: float) -> None:
    q = np.array([0.4, 0.7, STRAIGHT, -0.1, 0.15, 0.3])
    pose = arm.forward(q)
    # the elbow is below the boom line, so the elevation of the straight arm is shoulder pitch minus a constant
    lift = q[1] - math.atan2(6.0, 251.05)
    along = np.array([math.cos(0.4) * math.cos(lift), math.sin(0.4) * math.cos(lift), -math.sin(lift)])
    with pytest.raises(UnreachableError, match="too far") as caught:
        arm.inverse(Pose(pose.position + beyond * along, pose.rotation))
    assert caught.value.excess == pytest.approx(beyond, abs=1e-9)
    assert caught.value.joint is None


def test_stretched_arm_is_within_reach(arm: aftdeck.Arm) -> None:
    q = legal(arm, 16, 5000)
    q[:, 2] = STRAIGHT
    q = q[np.abs(np.stack(arm.singularities(q)))[[0, 2]].min(axis=0) > 1e-3]
    _, excess = all_branches(arm, q)
    assert (excess == 0.0).any(axis=1).all()


def test_pose_too_close_is_rejected_with_its_excess(arm: aftdeck.Arm) -> None:
    # the wrist yaw joint is 0.1 m from the shoulder pitch joint; the end effector is level, so the wrist pitch joint
    # is at the same height as wrist yaw, 18 inches away from it
    upper, lower = math.hypot(251.05, 6.0) * 0.0254, math.hypot(277.95, 6.0) * 0.0254
    inside = lower - upper - (0.1 - 18 * 0.0254) * -1.0
    outside = lower - upper - (0.1 + 18 * 0.0254)
    pose = Pose(np.array([0.1 + 56 * 0.0254, 0.0, -0.3048]), np.eye(3))
    with pytest.raises(UnreachableError, match="too close") as caught:
        arm.inverse(pose)
    assert caught.value.excess == pytest.approx(min(inside, outside), abs=1e-9)


def test_pose_outside_the_stops_is_rejected_with_joint_and_excess(arm: aftdeck.Arm) -> None:
    low, high = np.radians(table("srms-limits")["hard"]).T
    seen = set()
    for q in anywhere(17, 400):
        if nearness(arm, q) < 1e-2:
            continue
        pose = arm.forward(q)
        try:
            arm.inverse(pose)
        except UnreachableError as error:
            free = arm.inverse(pose, limits=False)
            turns = free + math.tau * np.arange(-2, 3)[:, None, None]
            beyond = np.maximum(low - turns, turns - high).min(axis=0)  # in the revolution nearest to the limits
            branch = beyond.max(axis=1).argmin()
            joint = int(beyond[branch].argmax())
            assert error.joint == arm.joints[joint]
            assert error.excess == pytest.approx(beyond[branch, joint], abs=1e-9)
            assert f"{math.degrees(beyond[branch, joint]):.2f} deg" in str(error)
            seen.add(joint)
    assert len(seen) >= 3


@pytest.mark.parametrize("yaw", [90.0, -90.0])
def test_wrist_yaw_of_90_deg_raises_the_wrist_singularity(arm: aftdeck.Arm, yaw: float) -> None:
    with pytest.raises(SingularityError, match=r"wrist yaw .*\+-90 deg") as caught:
        arm.inverse(arm.forward(np.radians([20, 60, -80, 30, yaw, 15])))
    assert caught.value.singularity == "wrist"
    assert abs(caught.value.distance) < 1e-9


def test_wrist_over_the_shoulder_axis_raises_the_shoulder_singularity(arm: aftdeck.Arm) -> None:
    q = over_the_shoulder(arm)
    with pytest.raises(SingularityError, match="shoulder singularity") as caught:
        arm.inverse(arm.forward(q))
    assert caught.value.singularity == "shoulder"
    assert abs(caught.value.distance) < 1e-9


def test_inverse_near_a_singularity_maps_back(arm: aftdeck.Arm) -> None:
    for off in (1e-3, 1e-5, 1e-7):
        beside = over_the_shoulder(arm) + np.array([0, off, 0, 0, 0, 0])
        for q in (beside, np.array([0.2, 1, -1, 0.3, math.pi / 2 - off, 0.2])):
            pose = arm.forward(q)
            for row in arm.inverse(pose, near=q):
                back = arm.forward(row)
                assert back.position == pytest.approx(pose.position, abs=1e-9)
                assert back.rotation == pytest.approx(pose.rotation, abs=1e-9)


MIRROR = np.diag([1.0, 1.0, -1.0])


@pytest.mark.parametrize(
    ("pose", "near", "pattern"),
    [
        (Pose(np.zeros(2), np.eye(3)), None, r"\(2,\) and \(3, 3\)$"),
        (Pose(np.zeros(3), np.zeros(9)), None, r"\(3,\) and \(9,\)$"),
        (Pose(np.zeros(3), 2 * np.eye(3)), None, r"R R\^T .*3"),
        (Pose(np.zeros(3), MIRROR), None, r"determinant.*-1.*\+1"),
        (Pose(np.full(3, math.nan), np.eye(3)), None, "position: .*finite"),
        (Pose(np.zeros(3), np.full((3, 3), math.inf)), None, "rotation: .*finite"),
        (Pose(np.full(3, 5.0), np.eye(3)), np.zeros(5), r"near: .*\(6,\).*\(5,\)"),
        (Pose(np.full(3, 5.0), np.eye(3)), np.full(6, math.nan), "near: .*finite"),
    ],
)
def test_invalid_pose_is_rejected(arm: aftdeck.Arm, pose: Pose, near: Array | None, pattern: str) -> None:
    with pytest.raises(InputError, match=pattern):
        arm.inverse(pose, near=near)


def test_panel_coordinates_round_trip(arm: aftdeck.Arm) -> None:
    for q in legal(arm, 18, 100):
        pose = arm.forward(q)
        place, attitude = arm.panel(pose)
        assert all(0.0 <= angle < 360.0 for angle in attitude)
        back = arm.from_panel(np.array(place) * 0.0254, np.radians(attitude))
        assert back.position == pytest.approx(pose.position, abs=1e-11)
        assert back.rotation == pytest.approx(pose.rotation, abs=1e-7)


def test_cradled_arm_reads_the_historical_panel_values(arm: aftdeck.Arm) -> None:
    place, attitude = arm.panel(arm.forward(np.zeros(6)))
    assert [round(x) for x in place] == [-1282, -108, -445] or place == pytest.approx((-1282.5, -108, -445), abs=0.5)
    # the end effector points aft with its camera up: a yaw of 180 deg from the orbiter's axes
    assert attitude == pytest.approx((180.0, 0.0, 180.0)) or attitude == pytest.approx((0.0, 180.0, 0.0))
