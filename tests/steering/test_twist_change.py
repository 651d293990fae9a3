"""Changes of the twist in one step: in proportion for mode 2, within joint accelerations for modes 4 to 7."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.kinematics.jacobian import Rates, Twist, of_six
from aftdeck.steering.layout import DT, MEASURED, MOST_UP, SPEED, SPEED_UP, STATE, TURN, TURN_UP
from aftdeck.steering.rules import rules_of
from aftdeck.steering.twist_change import in_proportion, rates_between, share_of_change
from tests import loaded

PROVE = settings(derandomize=True, deadline=None, max_examples=400, database=None)
twists = st.tuples(*[st.floats(-3.0, 3.0)] * 6).map(lambda t: Twist(*t))
rates = st.tuples(*[st.floats(-0.2, 0.2)] * 6).map(lambda r: of_six(*r))


def rules_with(dt: float) -> np.ndarray:
    model = loaded.arm().model
    return np.array(rules_of(model, model.por_limits(0.0), dt)["OPR CMD", "coarse", 2])


def inside(twist: Twist, rules: np.ndarray) -> np.ndarray:
    """Return a twist (6,), scaled so that it keeps the limits of speed and angular rate."""
    whole = np.array(twist)
    excess = np.linalg.norm(whole[:3]) / rules[TURN], np.linalg.norm(whole[3:]) / rules[SPEED]
    return np.asarray(whole / max(1.0, *excess))


def check_limits(rules: np.ndarray, found: Twist, present: np.ndarray) -> None:
    """Check the speeds of a twist, and its change from the present one."""
    for part, most, up in ((slice(0, 3), TURN, TURN_UP), (slice(3, 6), SPEED, SPEED_UP)):
        assert np.linalg.norm(np.array(found)[part]) <= rules[most] * (1 + 1e-9)
        assert np.linalg.norm((np.array(found) - present)[part]) <= rules[up] * rules[DT] * (1 + 1e-6) + 1e-12


@PROVE
@given(demanded=twists, share=st.floats(0.0, 1.0), dt=st.floats(0.001, 0.2))
def test_mode_2_twist_stays_in_proportion_within_limits(demanded: Twist, share: float, dt: float) -> None:
    rules = rules_with(dt)
    whole = inside(demanded, rules)
    found, _ = in_proportion(rules, Twist(*whole), Twist(*(share * whole)))
    factor = float(np.dot(found, whole) / max(np.dot(whole, whole), 1e-300))
    assert np.array(found) == pytest.approx(factor * whole, abs=1e-12)
    assert factor <= 1.0 + 1e-9 and (factor >= share - 1e-9 or not whole.any())
    check_limits(rules, found, share * whole)


@PROVE
@given(demanded=twists, present=twists, dt=st.floats(0.001, 0.2))
def test_new_direction_in_mode_2_keeps_limits(demanded: Twist, present: Twist, dt: float) -> None:
    rules = rules_with(dt)
    now = inside(present, rules)
    found, _ = in_proportion(rules, demanded, Twist(*now))
    check_limits(rules, found, now)


@PROVE
@given(now=rates, before=rates, after=rates, dt=st.floats(0.001, 0.2))
def test_share_of_a_change_is_the_greatest_within_accelerations(
    now: Rates, before: Rates, after: Rates, dt: float
) -> None:
    rules, state = rules_with(dt), np.zeros(STATE)
    state[MEASURED : MEASURED + len(now)] = now
    change = rules[MOST_UP : MOST_UP + len(now)] * rules[DT]
    found = share_of_change(rules, state, before, after)

    def excess(share: float) -> float:
        return float((np.abs(np.array(rates_between(before, after, share)) - now) / change).max())

    assert 0.0 <= found.share <= 1.0 and (found.joint >= 0) == (found.share < 1.0)
    trials = np.linspace(0.0, 1.0, 201).tolist()
    within = [share for share in trials if excess(share) <= 1.0]
    if within:
        assert excess(found.share) <= 1.0 + 1e-9 and found.share >= max(within) - 1e-9
    assert rates_between(before, after, 1.0) == after
