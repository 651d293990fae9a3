"""VCLOSE: both motions end together at the target, without a jump or a division by zero."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.steering.profiles import vclose
from aftdeck.steering.rules import rules_of
from tests import loaded

PROVE = settings(derandomize=True, deadline=None, max_examples=100, database=None)
SPEED, SPEED_UP = 2 * 0.3048, 2 * 0.3048 / 4
TURN, TURN_UP = math.radians(4.76), math.radians(4.76) / 4


def rules(dt: float, strict: bool = False) -> np.ndarray:
    por = loaded.arm().model.por_limits(0.0)
    return rules_of(loaded.arm().model, por, dt, strict=strict)["OPR CMD", "coarse", 2]


distances = st.one_of(st.just(0.0), st.floats(1e-300, 1e-12), st.floats(1e-9, 40.0))
angles = st.one_of(st.just(0.0), st.floats(1e-300, 1e-12), st.floats(1e-9, math.pi))


@PROVE
@given(distance=distances, angle=angles, dt=st.floats(0.001, 0.2), strict=st.booleans())
def test_vclose_is_finite_and_within_limits(distance: float, angle: float, dt: float, strict: bool) -> None:
    found = vclose(rules(dt, strict), distance, angle)
    assert all(math.isfinite(x) and x >= 0.0 for x in found)
    if not strict:
        assert found.speed <= SPEED * (1 + 1e-12) and found.turn <= TURN * (1 + 1e-12)


@PROVE
@given(distance=distances, angle=angles, dt=st.sampled_from([0.005, 0.02, 0.08]))
def test_vclose_reaches_target_without_overshoot(distance: float, angle: float, dt: float) -> None:
    r = rules(dt)
    v = w = math.nan
    for _ in range(round(120.0 / dt)):
        found = vclose(r, distance, angle)
        if not math.isnan(v):
            assert v - found.speed <= SPEED_UP * dt * (1 + 1e-6) + 1e-9
            assert w - found.turn <= TURN_UP * dt * (1 + 1e-6) + 1e-9
        v, w = found.speed, found.turn
        distance, angle = distance - v * dt, angle - w * dt
        assert distance >= -1e-12 and angle >= -1e-12
        distance, angle = max(distance, 0.0), max(angle, 0.0)
        if distance < 1e-9 and angle < 1e-9:
            break
    assert distance < 1e-9 and angle < 1e-9


@PROVE
@given(distance=st.floats(0.5, 40.0), angle=st.floats(0.1, math.pi))
def test_vclose_ends_both_motions_together(distance: float, angle: float) -> None:
    r, left = rules(0.02), np.array([distance, angle])
    for _ in range(round(120.0 / 0.02)):
        found = vclose(r, *left.tolist())
        left = left - 0.02 * np.array([found.speed, found.turn])
        ended = left <= 1e-9 * np.array([distance, angle])
        if ended.any():
            break
    assert ended.all()


@PROVE
@given(distance=st.floats(1e-6, 40.0), angle=st.floats(1e-6, math.pi), dt=st.floats(0.001, 0.2))
def test_vclose_demands_what_remains_in_proportion(distance: float, angle: float, dt: float) -> None:
    found = vclose(rules(dt), distance, angle)
    assert found.speed / distance == pytest.approx(found.turn / angle, rel=1e-12)
    alone = vclose(rules(dt), distance, 0.0).speed, vclose(rules(dt), 0.0, angle).turn
    assert found.speed == pytest.approx(alone[0]) or found.turn == pytest.approx(alone[1])


def test_vclose_time_of_a_long_distance_is_that_of_a_trapezoid() -> None:
    # 12 m at 2 ft/s; braking takes the last 4 s, at half the speed on average, so it adds 2 s
    assert vclose(rules(0.001), 12.0, 0.0).remaining == pytest.approx(12.0 / SPEED + 2.0, rel=1e-3)


@pytest.mark.parametrize("tiny", [1e-15, 1e-18, 1e-22, 1e-30])
def test_tiny_rotation_does_not_delay_the_translation(tiny: float) -> None:
    found = vclose(rules(0.02), 3.0, tiny)
    assert found.speed == pytest.approx(SPEED)
    found = vclose(rules(0.02), tiny, 1.0)
    assert found.turn == pytest.approx(TURN)
