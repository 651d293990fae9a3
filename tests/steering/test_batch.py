"""Many arms in closed loop: agreement with a single arm and with another implementation, and rejected arguments."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.frames import Pose
from aftdeck.steering.batch import Steered, pace_of, steer_batch
from aftdeck.steering.blocks import LANES, steer_one
from tests.steering.flying import BAY

PERIOD, GAIN = 0.08, 0.8


@pytest.fixture(scope="module")
def arm() -> aftdeck.Arm:
    return aftdeck.load_arm("srms")


def random_batch(arm: aftdeck.Arm, seed: int, count: int, spread: float) -> tuple[Array, Array]:
    """Return (count, 6) angles above the bay, and (count, 12) targets, which are the poses of nearby angles."""
    rng = np.random.default_rng(seed)
    start = np.radians(BAY) + rng.uniform(-0.4, 0.4, (count, 6))
    pose = arm.forward(start + rng.uniform(-spread, spread, (count, 6)))
    return start, np.concatenate([pose.position, pose.rotation.reshape(-1, 9)], axis=1)


def about(axis: int, angle: Array) -> Array:
    """Return (n, 3, 3) rotations about x, y or z."""
    c, s = np.cos(angle), np.sin(angle)
    turn = np.zeros((len(angle), 3, 3))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turn[:, axis, axis], turn[:, i, i], turn[:, j, j], turn[:, i, j], turn[:, j, i] = 1.0, c, c, -s, s
    return turn


def chained_step(arm: aftdeck.Arm, q: Array, target: Array) -> Array:
    """Return the angles after a step, computed by chained rotations, joint axes and positions, and a linear solver."""
    l1, l2, l3, l4, l5, upper, lower = arm.model.links[:7]
    yaw = about(2, q[:, 0])
    pitched = yaw @ about(1, q[:, 1:4].sum(axis=1))
    wrist = pitched @ about(2, q[:, 4])
    tip = wrist @ about(0, q[:, 5])
    shoulder = np.broadcast_to([0.0, 0.0, -l1], (len(q), 3))
    elbow = shoulder + l2 * (yaw @ about(1, q[:, 1] + upper))[:, :, 0]
    pitch = elbow + l3 * (yaw @ about(1, q[:, 1] + q[:, 2] + lower))[:, :, 0]
    bend = pitch + l4 * pitched[:, :, 0]
    end = bend + l5 * wrist[:, :, 0]
    axes = np.stack([yaw[:, :, 2], yaw[:, :, 1], yaw[:, :, 1], yaw[:, :, 1], pitched[:, :, 2], wrist[:, :, 0]], axis=2)
    positions = np.stack([shoulder, shoulder, elbow, pitch, bend, end], axis=2)
    arms = np.cross(axes, end[:, :, None] - positions, axis=1)
    turn = target[:, 3:].reshape(-1, 3, 3) @ np.swapaxes(tip, 1, 2)
    skew = 0.5 * (turn - np.swapaxes(turn, 1, 2))
    twist = GAIN * np.concatenate([skew[:, [2, 0, 1], [1, 2, 0]], target[:, :3] - end], axis=1)
    rates = np.linalg.solve(np.concatenate([axes, arms], axis=1), twist[:, :, None])[:, :, 0]
    worst = np.abs(rates / arm.rate_limits).max(axis=1, keepdims=True)
    return np.asarray(q + PERIOD * rates / np.maximum(worst, 1.0))


def steered(arm: aftdeck.Arm, start: Array, targets: Array, steps: int) -> Steered:
    return steer_batch(arm, start, targets, steps=steps, period=PERIOD, gain=GAIN)


@pytest.mark.slow
@pytest.mark.parametrize("spread", [1e-3, 0.3, 2.0])
def test_each_arm_of_a_batch_equals_the_single_arm(arm: aftdeck.Arm, spread: float) -> None:
    start, targets = random_batch(arm, 60, 2000, spread)
    alone, pace = start.copy(), pace_of(arm, PERIOD, GAIN)
    for q, target in zip(alone, targets, strict=True):
        for _ in range(3):
            steer_one(arm.model.links, pace, q, target)
    assert (steered(arm, start, targets, 3).angles == alone).all()


def test_batch_of_one_equals_the_single_step(arm: aftdeck.Arm) -> None:
    pace = pace_of(arm, PERIOD, GAIN)
    for start, target in zip(*random_batch(arm, 61, 200, 0.3), strict=True):
        alone = start.copy()
        steer_one(arm.model.links, pace, alone, target)
        assert (steered(arm, start, target, 1).angles == alone).all()


@pytest.mark.parametrize("spread", [1e-3, 0.2])
def test_batch_steps_agree_with_an_independent_solver(arm: aftdeck.Arm, spread: float) -> None:
    q, targets = random_batch(arm, 62, 3000, spread)
    clear = np.abs(np.stack(arm.singularities(q))).min(axis=0) > 0.05
    q, targets = q[clear], targets[clear]
    assert len(q) > 2000
    got = steered(arm, q, targets, 20)
    for _ in range(20):
        q = chained_step(arm, q, targets)
    assert got.angles == pytest.approx(q, abs=1e-9)


def test_batch_arms_reach_their_targets(arm: aftdeck.Arm) -> None:
    start, targets = random_batch(arm, 63, 500, 0.2)
    clear = np.abs(np.stack(arm.singularities(start))).min(axis=0) > 0.3
    start, targets = start[clear], targets[clear]
    end = steered(arm, start, targets, 2000)
    pose = arm.forward(end.angles)
    assert len(start) > 100
    assert np.abs(pose.position - targets[:, :3]).max() < 1e-9
    assert np.abs(pose.rotation - targets[:, 3:].reshape(-1, 3, 3)).max() < 1e-9
    assert max(np.abs(end.position_error).max(), np.abs(end.rotation_error).max()) < 1e-9


def test_returned_errors_belong_to_the_returned_angles(arm: aftdeck.Arm) -> None:
    start, targets = random_batch(arm, 64, 300, 0.5)
    end = steered(arm, start, targets, 7)
    pose = arm.forward(end.angles)
    assert end.position_error == pytest.approx(targets[:, :3] - pose.position, abs=1e-13)
    turn = targets[:, 3:].reshape(-1, 3, 3) @ np.swapaxes(pose.rotation, 1, 2)
    expected = 0.5 * np.stack(
        [turn[:, 2, 1] - turn[:, 1, 2], turn[:, 0, 2] - turn[:, 2, 0], turn[:, 1, 0] - turn[:, 0, 1]], 1
    )
    assert end.rotation_error == pytest.approx(expected, abs=1e-13)


def test_batch_keeps_rate_limits_at_singularities(arm: aftdeck.Arm) -> None:
    rng = np.random.default_rng(65)
    q = rng.uniform(-math.pi, math.pi, (3000, 6))
    q[::3, 4] = math.pi / 2
    _, targets = random_batch(arm, 65, 3000, 1.0)
    period = 2.0**-4  # a power of two: dividing by it does not round
    moved = steer_batch(arm, q, targets, period=period, gain=10.0).angles - q
    rates = np.abs(moved) / period
    ratio = (rates / arm.rate_limits).max(axis=1)
    # the difference of two angles is rounded, the rate is not
    assert ratio.max() <= 1.0 + 1e-12
    assert (ratio > 1.0 - 1e-12).mean() > 0.9


def test_many_steps_in_one_call_equal_single_steps(arm: aftdeck.Arm) -> None:
    start, targets = random_batch(arm, 66, 10 * LANES + 3, 0.3)
    whole, q = steered(arm, start, targets, 100).angles, start
    for _ in range(100):
        q = steered(arm, q, targets, 1).angles
    assert (whole == q).all()


@pytest.mark.parametrize("lead", [(), (1,), (LANES - 1,), (LANES,), (2, 3, LANES), (0,)])
def test_result_keeps_leading_dimensions(arm: aftdeck.Arm, lead: tuple[int, ...]) -> None:
    start, targets = random_batch(arm, 67, math.prod(lead), 0.1)
    flat = steered(arm, start, targets, 2)
    end = steered(arm, start.reshape(*lead, 6), targets.reshape(*lead, 12), 2)
    assert end.angles.shape == (*lead, 6)
    assert end.position_error.shape == end.rotation_error.shape == (*lead, 3)
    assert (end.angles.reshape(-1, 6) == flat.angles).all()


def test_targets_may_be_poses_or_rows_shared_or_single(arm: aftdeck.Arm) -> None:
    start, targets = random_batch(arm, 68, 5, 0.1)
    each = steered(arm, start, targets, 2)
    poses = Pose(targets[:, :3], targets[:, 3:].reshape(-1, 3, 3))
    assert (steer_batch(arm, start, poses, steps=2, period=PERIOD, gain=GAIN).angles == each.angles).all()
    one = steered(arm, start, targets[0], 2)
    assert (one.angles == steered(arm, start, np.tile(targets[0], (5, 1)), 2).angles).all()


def test_zero_steps_return_the_errors(arm: aftdeck.Arm) -> None:
    start, targets = random_batch(arm, 69, 5, 0.1)
    end = steered(arm, start, targets, 0)
    assert (end.angles == start).all()
    assert end.position_error == pytest.approx(targets[:, :3] - arm.forward(start).position, abs=1e-14)


def test_batch_does_not_change_its_inputs(arm: aftdeck.Arm) -> None:
    start, targets = random_batch(arm, 70, LANES, 0.1)
    before = start.copy(), targets.copy()
    steered(arm, start, targets, 5)
    assert (start == before[0]).all() and (targets == before[1]).all()


HERE = np.concatenate([[5.0, 0.0, -3.0], np.eye(3).ravel()])
MIRRORED = np.concatenate([[5.0, 0.0, -3.0], np.diag([1.0, 1.0, -1.0]).ravel()])


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"angles": np.zeros(5)}, "joint angles: expected shape (..., 6), got (5,)"),
        ({"angles": [0, 0, 0, 0, 0, math.nan]}, "joint angles: expected finite numbers"),
        ({"angles": ["a"] * 6}, "joint angles: expected numbers, got"),
        ({"targets": np.zeros((2, 11))}, "targets: expected shape (..., 12), got (2, 11)"),
        ({"targets": np.tile(HERE, (3, 1))}, "targets: expected the leading shape of the joint angles, (2,), or one"),
        ({"targets": np.zeros(12)}, "deviation 1,"),
        ({"targets": MIRRORED}, "deviation 2,"),
        ({"targets": Pose(np.zeros(3), np.zeros((2, 3, 3)))}, "targets: got shapes (3,) and (2, 3, 3)"),
        ({"period": 0.0}, "period: got 0.0,"),
        ({"period": math.nan}, "period: got nan,"),
        ({"gain": 0.0}, "gain: got 0.0,"),
        ({"gain": 51.0}, "gain: got 51;"),
        ({"steps": -1}, "steps: got -1,"),
        ({"steps": 1.5}, "steps: got 1.5,"),
    ],
)
def test_invalid_batch_arguments_are_rejected(arm: aftdeck.Arm, change: dict[str, object], message: str) -> None:
    given: dict[str, object] = {"angles": np.zeros((2, 6)), "targets": HERE, "steps": 1, "period": 0.02, "gain": 1.0}
    with pytest.raises(InputError, match=re.escape(message)):
        steer_batch(arm, **(given | change))  # type: ignore[arg-type]


def test_fast_batch_differs_from_the_exact_one_by_rounding_only(arm: aftdeck.Arm) -> None:
    start, targets = random_batch(arm, 84, 2 * LANES, 0.1)
    exact, fast = (
        steer_batch(arm, start, targets, steps=20, period=PERIOD, gain=GAIN, fast=fast).angles for fast in (False, True)
    )
    assert np.allclose(exact, fast, rtol=0.0, atol=1e-12)
