"""The twist of a coordinate frame over a step, against the exponential of the twist."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.bodies.vector import Vector
from aftdeck.worksite.watch.motion import Motion, motion, velocity
from tests.worksite.scenes import moved, poses


@settings(deadline=None)
@given(st.integers(0, 2**32 - 1), st.sampled_from([1e-9, 1e-4, 9e-3, 1.1e-2, 0.3, 2.0, 3.1]))
def test_constant_twist_is_recovered(seed: int, angle: float) -> None:
    rng = np.random.default_rng(seed)
    frame, twist, period = poses(rng)[1:2], rng.normal(size=(1, 6)), 0.02
    twist[0, :3] *= angle / period / np.linalg.norm(twist[0, :3])
    twist[0, 3:] *= angle / period
    now = moved(frame, twist, period)[0]
    found = np.array(motion(frame[0], now, period))
    # the axis is computed from the sine of the angle, which is small near half a turn
    near = {"abs": 1e-11 * (1.0 + angle) / period / abs(np.sin(angle) / angle)}
    assert found[:3] == pytest.approx(twist[0, :3], **near)
    assert found[3:] == pytest.approx(np.cross(twist[0, :3], now[:3]) + twist[0, 3:], **near)
    point = rng.normal(size=3)
    expected = np.cross(twist[0, :3], point) + twist[0, 3:]
    assert velocity(now, Motion(*found), Vector(*point)) == pytest.approx(expected, **near)


def test_stationary_coordinate_frame_has_zero_twist() -> None:
    frame = poses(np.random.default_rng(3))[2]
    assert motion(frame, frame.copy(), 0.02) == (0.0,) * 6
