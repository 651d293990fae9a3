"""The human hand: reaction time, lag, deadband and noise, each against its closed answer."""

from __future__ import annotations

import math

import numpy as np
import pytest

from aftdeck.operators.hand import Hand
from aftdeck.operators.spec import OperatorSpec
from aftdeck.simulation.inputs import Inputs
from aftdeck.units import Time
from tests.each import number

PERIOD_S = 0.02


def hand(reaction: float = 0.0, lag: float = 0.0, noise: float = 0.0, deadband: float = 0.0, seed: int = 1) -> Hand:
    spec = OperatorSpec("human", Time(reaction), 0.5, Time(lag), noise, deadband)
    return Hand(spec, seed, PERIOD_S)


def pushed(of: Hand, deflection: float, steps: int) -> list[float]:
    wanted = Inputs(translation=(deflection, 0.0, 0.0))
    return [of.moved(wanted).translation[0] for _ in range(steps)]


def test_without_limits_the_hand_does_what_is_wanted() -> None:
    wanted = Inputs((0.1, -0.2, 0.3), (0.4, 0.5, -0.6), 0.7, mode="END EFF", orbiter=(0.2, 0.0, 0.0), telescope=-1.0)
    assert hand().moved(wanted) == wanted


@pytest.mark.parametrize("reaction", [0.02, 0.25, 1.0])
def test_sticks_and_switches_come_after_the_reaction_time(reaction: float) -> None:
    late = hand(reaction)
    wanted = Inputs(translation=(1.0, 0.0, 0.0), effector="close")
    moved = [late.moved(wanted) for _ in range(100)]
    first = round(reaction / PERIOD_S)
    assert [x.translation[0] for x in moved] == [0.0] * first + [1.0] * (100 - first)
    assert [x.effector for x in moved].index("close") == first


def test_a_step_is_followed_with_the_time_constant_of_the_lag() -> None:
    lag = 0.2
    reached = pushed(hand(lag=lag), 1.0, 50)
    follows = PERIOD_S / (PERIOD_S + lag)
    assert reached == pytest.approx([1.0 - (1.0 - follows) ** n for n in range(1, 51)])
    assert reached[round(lag / PERIOD_S) - 1] == pytest.approx(1.0 - math.exp(-1.0), abs=0.03)


def test_a_deflection_in_the_deadband_moves_nothing() -> None:
    assert set(pushed(hand(deadband=0.1), 0.0999, 10)) == {0.0}
    assert set(pushed(hand(deadband=0.1), 0.1001, 10)) == {0.1001}


@pytest.mark.parametrize("noise", [0.05, 0.2])
def test_noise_is_a_share_of_the_deflection(noise: float) -> None:
    for deflection in (0.1, 0.5):
        values = np.array(pushed(hand(noise=noise), deflection, number(8_000, 100_000)))
        assert values.mean() == pytest.approx(deflection, rel=0.02)
        assert values.std() == pytest.approx(noise * deflection, rel=0.06)
    assert set(pushed(hand(noise=noise), 0.0, 100)) == {0.0}


def test_no_noise_leaves_the_travel_of_a_stick() -> None:
    assert all(-1.0 <= value <= 1.0 for value in pushed(hand(noise=1.0), 1.0, 10_000))


def test_the_seed_decides_the_noise() -> None:
    first, again, other = (pushed(hand(noise=0.2, seed=seed), 0.5, 50) for seed in (1, 1, 2))
    assert first == again
    assert first != other
