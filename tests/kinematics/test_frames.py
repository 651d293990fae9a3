"""The coordinate frames of an arm's bodies, compared with forward kinematics and with successive joint rotations."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import aftdeck
from aftdeck.arrays import Array
from aftdeck.kinematics.frames import frames_of, place_frames
from aftdeck.kinematics.linkage import L1, L5

FOOT = 0.3048
PRONG = -0.8 * FOOT


@pytest.fixture(scope="module", params=["srms", "concept-1972"])
def arm(request: pytest.FixtureRequest) -> aftdeck.Arm:
    return aftdeck.load_arm(request.param)


def placed(arm: aftdeck.Arm, q: Array, stand: float, prong: float = PRONG) -> dict[str, tuple[Array, Array]]:
    """Return origin (3,) and axes (3, 3) of each frame, in L."""
    frames = frames_of(arm.model)
    rows = frames.rows()
    place_frames(frames.joints, q, stand, prong, rows)
    return {name: (row[:3], row[3:].reshape(3, 3)) for name, row in zip(frames.names, rows, strict=True)}


def height(arm: aftdeck.Arm) -> float:
    return float(arm.model.links[L1])


def random_angles(arm: aftdeck.Arm, count: int) -> Array:
    hard = arm.limits.hard
    return np.random.default_rng(11).uniform(hard[:, 0], hard[:, 1], (count, 6))


def test_last_joint_frame_agrees_with_forward_kinematics(arm: aftdeck.Arm) -> None:
    for q in random_angles(arm, 50):
        place, axes = placed(arm, q, height(arm))[arm.model.linkage.frames[-1]]
        tip = arm.forward(q)
        assert axes == pytest.approx(tip.rotation, abs=1e-12)
        assert place + axes @ [arm.model.links[L5], 0.0, 0.0] == pytest.approx(tip.position, abs=1e-12)


def test_each_frame_is_the_previous_one_moved_and_turned_about_its_axis(arm: aftdeck.Arm) -> None:
    linkage = arm.model.linkage
    for q in random_angles(arm, 20):
        found = placed(arm, q, height(arm))
        place, turn = np.zeros(3), Rotation.identity()
        assert found["arm.base"][0] == pytest.approx(place) and found["arm.base"][1] == pytest.approx(np.eye(3))
        for name, step, axis, angle in zip(linkage.frames[1:], linkage.steps, linkage.axes, q, strict=True):
            place = place + turn.as_matrix() @ step
            turn = turn * Rotation.from_rotvec(angle * axis)
            assert found[name][0] == pytest.approx(place, abs=1e-12)
            assert found[name][1] == pytest.approx(turn.as_matrix(), abs=1e-12)


def test_concept_arm_has_two_more_frames_than_srms() -> None:
    concept, srms = (frames_of(aftdeck.load_arm(name).model) for name in ("concept-1972", "srms"))
    assert concept.names[-2:] == ("arm.stand", "arm.prong") and len(concept.names) == 9
    assert len(srms.names) == 7


@pytest.mark.parametrize("feet", [8.0, 11.3, 18.0])
def test_telescope_lifts_all_frames_above_its_foot_without_rotation(feet: float) -> None:
    arm = aftdeck.load_arm("concept-1972")
    for q in random_angles(arm, 5):
        low, high = placed(arm, q, 8.0 * FOOT), placed(arm, q, feet * FOOT)
        for name in high:
            lifted = 0.0 if name == "arm.base" else (feet - 8.0) * FOOT
            assert high[name][0] == pytest.approx(low[name][0] - [0.0, 0.0, lifted], abs=1e-12)
            assert high[name][1] == pytest.approx(low[name][1])
        assert high["arm.stand"][0] == pytest.approx([0.0, 0.0, -feet * FOOT])
        assert high["arm.stand"][1] == pytest.approx(np.eye(3))


def test_prong_moves_only_along_y2() -> None:
    arm = aftdeck.load_arm("concept-1972")
    for q in random_angles(arm, 5):
        found = placed(arm, q, height(arm))
        hand, prong = found["arm.wrist_roll"], found["arm.prong"]
        assert hand[1].T @ (prong[0] - hand[0]) == pytest.approx([0.0, PRONG, 0.0], abs=1e-12)
        assert prong[1] == pytest.approx(hand[1])


def test_rows_are_rotations_and_repeat_exactly() -> None:
    arm = aftdeck.load_arm("concept-1972")
    first = placed(arm, np.full(6, 0.3), 3.0)
    placed(arm, np.full(6, -0.4), 4.0)
    again = placed(arm, np.full(6, 0.3), 3.0)
    for name, (place, axes) in first.items():
        assert (again[name][0] == place).all() and (again[name][1] == axes).all()
        assert axes.T @ axes == pytest.approx(np.eye(3), abs=1e-14)
        assert np.linalg.det(axes) == pytest.approx(1.0)
