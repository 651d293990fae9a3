from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import aftdeck
from aftdeck.arrays import Array
from aftdeck.kinematics.linkage import L5
from aftdeck.scene.poses import ArmPoses, point_in_scene, sevens

SCENE = np.diag([-1.0, 1.0, -1.0])
"""Conversion of panel components (forward, starboard, down) to scene components (aft, starboard, up)."""
ORIGIN = np.array([942.0, 0.0, 400.0]) * 0.0254
"""The scene's origin, structural (aft, starboard, up) [m]."""


@pytest.fixture(scope="module")
def arm() -> aftdeck.Arm:
    return aftdeck.load_arm("srms")


def random_angles(arm: aftdeck.Arm, count: int) -> Array:
    hard = arm.limits.hard
    return np.random.default_rng(5).uniform(hard[:, 0], hard[:, 1], (count, 6))


def placed(arm: aftdeck.Arm, q: Array) -> tuple[Array, list[Rotation]]:
    """Return origins (n, 3) and orientations of the arm's coordinate frames, in the scene."""
    rows = np.array(ArmPoses(arm.model).at(q)).reshape(-1, 7)
    return rows[:, :3], [Rotation.from_quat(row[[4, 5, 6, 3]]) for row in rows]


@pytest.mark.parametrize("name", ["srms", "concept-1972"])
def test_tip_is_where_forward_kinematics_puts_it(name: str) -> None:
    arm = aftdeck.load_arm(name)
    hand = arm.model.links[L5]
    for q in random_angles(arm, 50):
        places, turns = placed(arm, q)
        tip = arm.model.mount.to("panel", arm.forward(q))
        assert turns[6].as_matrix() == pytest.approx(SCENE @ tip.rotation, abs=1e-12)
        # structural components: aft is -X of the panel, starboard is Y, up is -Z
        assert places[6] + turns[6].apply([hand, 0.0, 0.0]) == pytest.approx(SCENE @ tip.position - ORIGIN, abs=1e-12)


def test_quaternions_have_unit_norm_and_links_keep_their_length(arm: aftdeck.Arm) -> None:
    at_rest, _ = placed(arm, np.zeros(6))
    lengths = np.linalg.norm(np.diff(at_rest, axis=0), axis=1)
    for q in random_angles(arm, 20):
        rows = np.array(ArmPoses(arm.model).at(q)).reshape(7, 7)
        assert np.linalg.norm(rows[:, 3:], axis=1) == pytest.approx(np.ones(7), abs=1e-12)
        assert np.linalg.norm(np.diff(rows[:, :3], axis=0), axis=1) == pytest.approx(lengths, abs=1e-12)


@pytest.mark.parametrize("joint", range(6))
def test_joint_turns_all_frames_beyond_it_about_its_own_axis(arm: aftdeck.Arm, joint: int) -> None:
    axis = {0: 2, 1: 1, 2: 1, 3: 1, 4: 2, 5: 0}[joint]
    q = np.radians([20.0, 60.0, -80.0, 30.0, -40.0, 70.0])
    turned = q.copy()
    turned[joint] += math.radians(15.0)
    _, before = placed(arm, q)
    _, after = placed(arm, turned)
    for k in range(joint + 1):
        assert (after[k] * before[k].inv()).magnitude() == pytest.approx(0.0, abs=1e-12)
    own = (before[joint + 1].inv() * after[joint + 1]).as_rotvec()
    assert own == pytest.approx(math.radians(15.0) * np.eye(3)[axis], abs=1e-12)
    for k in range(joint + 1, 7):
        assert (after[k] * before[k].inv()).magnitude() == pytest.approx(math.radians(15.0), abs=1e-12)


def test_frames_are_parallel_to_the_base_at_zero_angles(arm: aftdeck.Arm) -> None:
    _, turns = placed(arm, np.zeros(6))
    for turn in turns:
        assert turn.as_matrix() == pytest.approx(SCENE @ arm.model.mount.rotation, abs=1e-12)


def test_scene_origin_is_the_middle_of_the_bay() -> None:
    assert point_in_scene(np.array([-942.0, 0.0, -400.0]) * 0.0254) == pytest.approx([0.0, 0.0, 0.0], abs=1e-12)
    # the point 1 m forward, 2 m to starboard and 3 m down from the origin
    there = point_in_scene(np.array([-942.0, 0.0, -400.0]) * 0.0254 + [1.0, 2.0, 3.0])
    assert there == pytest.approx([-1.0, 2.0, -3.0], abs=1e-12)


@pytest.mark.parametrize("name", ["srms", "concept-1972"])
def test_links_compose_to_the_poses(name: str) -> None:
    arm = aftdeck.load_arm(name)
    poses = ArmPoses(arm.model)
    for q in random_angles(arm, 10):
        rows = np.array(poses.at(q, 3.1, -0.2) if name != "srms" else poses.at(q)).reshape(-1, 7)
        found = dict(zip(arm.model.frames, rows, strict=True))
        links = poses.links(q.tolist(), 3.1, -0.2) if name != "srms" else poses.links(q.tolist())
        assert {child for _, child, _ in links} == set(arm.model.frames[1:])
        for parent, child, pose in links:
            turn = Rotation.from_quat(found[parent][[4, 5, 6, 3]])
            own = turn * Rotation.from_quat(np.array(pose)[[4, 5, 6, 3]])
            assert found[parent][:3] + turn.apply(pose[:3]) == pytest.approx(found[child][:3], abs=1e-12)
            assert own.as_matrix() == pytest.approx(
                Rotation.from_quat(found[child][[4, 5, 6, 3]]).as_matrix(), abs=1e-12
            )


def test_telescope_and_prong_are_drawn_at_their_positions() -> None:
    arm = aftdeck.load_arm("concept-1972")
    poses = ArmPoses(arm.model)
    q = random_angles(arm, 1)[0]
    rows = np.array(poses.at(q, 4.0, -0.3)).reshape(-1, 7)
    found = dict(zip(arm.model.frames, rows, strict=True))
    assert found["arm.stand"][:3] == pytest.approx(found["arm.base"][:3] + np.array([0.0, 0.0, 4.0]))
    assert found["arm.stand"][3:] == pytest.approx(found["arm.base"][3:])
    y2 = Rotation.from_quat(found["arm.wrist_roll"][[4, 5, 6, 3]]).apply([0.0, 1.0, 0.0])
    assert found["arm.prong"][:3] == pytest.approx(found["arm.wrist_roll"][:3] - 0.3 * y2, abs=1e-12)
    as_loaded = np.array(poses.at(q)).reshape(-1, 7)
    assert as_loaded[7, 2] - as_loaded[0, 2] == pytest.approx(arm.stand)


def test_quaternion_is_correct_for_any_largest_component() -> None:
    rows = np.zeros((400, 12))
    turns = Rotation.random(400, random_state=7).as_matrix()
    turns[:4] = [np.eye(3), np.diag([1.0, -1.0, -1.0]), np.diag([-1.0, 1.0, -1.0]), np.diag([-1.0, -1.0, 1.0])]
    rows[:, 3:] = turns.reshape(400, 9)
    poses = np.empty((400, 7))
    sevens(np.concatenate([np.zeros(3), np.eye(3).ravel()]), rows, poses)
    for turn, pose in zip(turns, poses, strict=True):
        expected = Rotation.from_matrix(turn).as_quat(canonical=True, scalar_first=True)
        assert pose[3:] == pytest.approx(expected, abs=1e-14)


def test_own_scene_origin_shifts_all_positions() -> None:
    arm = aftdeck.load_arm("concept-1972")
    q = random_angles(arm, 1)[0]
    shuttles = np.array(ArmPoses(arm.model).at(q)).reshape(-1, 7)
    own = np.array(ArmPoses(arm.model, np.array([1.0, 2.0, 3.0])).at(q)).reshape(-1, 7)
    assert own[:, :3] - shuttles[:, :3] == pytest.approx(np.tile(ORIGIN - [1.0, 2.0, 3.0], (9, 1)), abs=1e-12)
    assert (own[:, 3:] == shuttles[:, 3:]).all()
    assert point_in_scene(np.array([-1.0, 2.0, -3.0]), np.array([1.0, 2.0, 3.0])) == pytest.approx(np.zeros(3))
