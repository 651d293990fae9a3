"""AVCLMT, RATLMT and the braking curve: their invariants."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from aftdeck.kinematics.jacobian import Twist, of_six
from aftdeck.kinematics.solver import posture
from aftdeck.steering.layout import (
    ANGLES,
    AS_FLOWN,
    DT,
    HIGH,
    LOW,
    RATE,
    RATES,
    SPEED,
    SPEED_UP,
    STATE,
    STRICT,
    TURN,
    TURN_UP,
)
from aftdeck.steering.limiters import BY_STOP, CAUSES, NEAREST, avclmt, braked, ratlmt
from aftdeck.steering.rules import rules_of
from aftdeck.tuples import MOST_JOINTS
from tests import loaded
from tests.kinematics.poses import STRAIGHT

PROVE = settings(derandomize=True, deadline=None, max_examples=400, database=None)

periods = st.floats(0.001, 0.2)
numbers = st.floats(-20.0, 20.0)
vectors = st.tuples(numbers, numbers, numbers)
twists = st.tuples(*[st.floats(-3.0, 3.0)] * 6).map(lambda t: Twist(*t))


@PROVE
@given(gap=st.floats(0.0, 50.0), deceleration=st.floats(1e-4, 5.0), dt=periods)
def test_braking_ends_in_its_gap_within_its_deceleration(gap: float, deceleration: float, dt: float) -> None:
    left, before = gap, braked(gap, deceleration, dt)
    steps = 0
    while left > 1e-12 * gap and steps < 3000:
        rate = braked(left, deceleration, dt)
        assert before - rate <= deceleration * dt * (1 + 1e-6) + 1e-12
        left -= rate * dt
        assert left >= -1e-12 * max(gap, 1e-3)
        before, steps = rate, steps + 1
    if steps < 3000:
        assert before <= deceleration * dt * (1 + 1e-6) + 1e-12


@PROVE
@given(gap=st.floats(1e-300, 1e-11), deceleration=st.floats(1e-4, 5.0), dt=periods)
def test_braking_crosses_the_smallest_gap(gap: float, deceleration: float, dt: float) -> None:
    assert braked(gap, deceleration, dt) == pytest.approx(gap / dt, rel=1e-12)


@given(gap=st.floats(-10.0, 0.0), deceleration=st.floats(1e-4, 5.0), dt=periods)
@PROVE
def test_braked_rate_beyond_a_stop_is_zero(gap: float, deceleration: float, dt: float) -> None:
    assert braked(gap, deceleration, dt) == 0.0


def rules_with(dt: float, strict: bool = False, as_flown: bool = False) -> np.ndarray:
    por = loaded.arm().model.por_limits(0.0)
    return np.array(rules_of(loaded.arm().model, por, dt, strict=strict, as_flown=as_flown)["ORB UNL", "coarse", 4])


@pytest.mark.parametrize("degrees", [0.2, 1.0])
def test_approach_ends_at_a_distance_from_a_singularity(degrees: float) -> None:
    rules, q = rules_with(0.02), np.array([0.0, 1.0, STRAIGHT - math.radians(degrees), 0.0, 0.5, 0.0])
    state = np.zeros(STATE)
    state[ANGLES : ANGLES + 6] = q
    assert 0.0 < abs(float(loaded.arm().singularities(q).elbow)) < NEAREST
    towards, away = (
        ratlmt(rules, state, posture(rules, of_six(*q.tolist())), of_six(0.0, 0.0, rate, 0.0, 0.0, 0.0))
        for rate in (1e-4, -1e-4)
    )
    assert (towards.ratio, CAUSES[towards.cause]) == (0.0, "singularity")
    assert away.ratio == 1.0


@PROVE
@given(wanted=twists, present=twists, dt=periods, strict=st.booleans())
def test_avclmt_keeps_acceleration_and_speed_limits(wanted: Twist, present: Twist, dt: float, strict: bool) -> None:
    rules = rules_with(dt, strict)
    limited, active = avclmt(rules, wanted, present)
    for part, most, up, bit in ((slice(0, 3), TURN, TURN_UP, 4), (slice(3, 6), SPEED, SPEED_UP, 1)):
        after, before, demanded = (np.array(t[part]) for t in (limited, present, wanted))
        change = float(rules[up]) * dt
        inside = np.linalg.norm(before) <= rules[most]
        if inside:
            assert np.linalg.norm(after) <= rules[most] * (1 + 1e-12)
        if inside or not strict:
            assert np.linalg.norm(after - before) <= change * (1 + 1e-9)
        if not inside and not strict:  # braking: the speed does not increase
            assert np.linalg.norm(after) <= np.linalg.norm(before) * (1 + 1e-12)
        if not active & bit and np.linalg.norm(demanded) <= rules[most]:
            assert after == pytest.approx(demanded, abs=1e-12)


@PROVE
@given(wanted=twists)
def test_avclmt_does_not_change_a_twist_within_limits(wanted: Twist) -> None:
    rules = rules_with(0.02)
    small = Twist(*(1e-4 * x for x in wanted))
    assert avclmt(rules, small, small) == (small, 0)


@pytest.mark.parametrize("strict", [False, True])
def test_avclmt_changes_velocity_by_the_allowed_amount(strict: bool) -> None:
    rules = rules_with(0.02, strict)
    step = 2.0 * 0.3048 / 4.0 * 0.02  # 2 ft/s in 4 s
    limited, active = avclmt(rules, Twist(0, 0, 0, 0.3, 0.4, 0), Twist(0, 0, 0, 0, 0, 0))
    assert limited[3:] == pytest.approx((0.6 * step, 0.8 * step, 0.0))
    assert active == 1


rates6 = st.tuples(*[st.floats(-2.0, 2.0)] * 6)


@PROVE
@given(rates=rates6, where=st.tuples(*[st.floats(0.0, 1.0)] * 6), dt=periods)
def test_ratlmt_keeps_direction_and_rate_limits(rates: tuple[float, ...], where: tuple[float, ...], dt: float) -> None:
    rules, state = rules_with(dt), np.zeros(STATE)
    low, high = rules[LOW : LOW + 6], rules[HIGH : HIGH + 6]
    q = low + np.array(where) * (high - low)
    state[ANGLES : ANGLES + 6] = q
    found = ratlmt(rules, state, posture(rules, of_six(*q)), of_six(*rates))
    assert 0.0 <= found.ratio <= 1.0
    assert (found.cause == 0) == (found.ratio == 1.0 and found.culprit == -1)
    kept = found.ratio * np.array(rates)
    assert (np.abs(kept) <= rules[RATE : RATE + 6] * (1 + 1e-9)).all()
    after = q + kept * dt
    assert (after >= low - 1e-9).all() and (after <= high + 1e-9).all()


@PROVE
@given(rates=rates6)
def test_ratlmt_returns_the_ratio_of_the_worst_joint(rates: tuple[float, ...]) -> None:
    rules, state = rules_with(0.02), np.zeros(STATE)
    q = np.radians([0.0, 70.0, -80.0, 10.0, 0.0, 0.0])
    state[ANGLES : ANGLES + 6] = q
    found = ratlmt(rules, state, posture(rules, of_six(*q)), of_six(*rates))
    assume(CAUSES[found.cause] in ("", "joint rate"))
    worst = np.abs(rates) / np.radians([2.29, 2.29, 3.21, 4.76, 4.76, 4.76])
    assert found.ratio == pytest.approx(1.0 / max(worst.max(), 1.0))
    if found.cause:
        assert found.culprit == worst.argmax()


@PROVE
@given(joint=st.integers(0, 5), past=st.floats(1e-6, 0.05), upper=st.booleans(), rate=st.floats(1e-4, 0.03))
def test_ratlmt_past_soft_stop_allows_only_the_way_back(joint: int, past: float, upper: bool, rate: float) -> None:
    rules, state = rules_with(0.02), np.zeros(STATE)
    q = np.radians([0.0, 70.0, -80.0, 10.0, 0.0, 0.0])
    q[joint] = rules[HIGH + joint] + past if upper else rules[LOW + joint] - past
    state[ANGLES : ANGLES + 6] = q
    a = posture(rules, of_six(*q))
    out = np.zeros(6)
    out[joint] = rate if upper else -rate
    stopped = ratlmt(rules, state, a, of_six(*out))
    assert stopped.ratio == 0.0
    back = ratlmt(rules, state, a, of_six(*-out))
    assert CAUSES[back.cause] != "soft stop"
    if CAUSES[stopped.cause] == "soft stop":
        assert stopped.culprit == joint


@PROVE
@given(joint=st.integers(0, 5), rates=rates6)
def test_as_flown_joint_past_soft_stop_stops_all_joints(joint: int, rates: tuple[float, ...]) -> None:
    rules, state = rules_with(0.02, as_flown=True), np.zeros(STATE)
    q = np.radians([0.0, 70.0, -80.0, 10.0, 0.0, 0.0])
    q[joint] = rules[HIGH + joint] + 0.01
    state[ANGLES : ANGLES + 6] = q
    assert ratlmt(rules, state, posture(rules, of_six(*q)), of_six(*rates)) == (0.0, BY_STOP, joint)


def test_layout_indices_do_not_overlap() -> None:
    assert DT < STRICT < AS_FLOWN < SPEED < TURN < SPEED_UP < TURN_UP < RATE
    assert (ANGLES, RATES) == (0, MOST_JOINTS) and math.isclose(rules_with(0.02)[DT], 0.02)
