"""Limit cycle: within its deadband. Coasting: exact for any step, orthonormal for hours. Translation of the orbiter."""

from __future__ import annotations

from math import radians
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.frames import endori, oriend
from aftdeck.units import FOOT
from aftdeck.worksite.free_flight import LimitCycle, coast, limit_cycle, translate

BAND, RATE = radians(1.0), radians(0.02)
PERIOD = 4.0 * BAND / RATE
"""Period of the limit cycle: 200 s."""
VECTORS = st.tuples(*[st.floats(-1.0, 1.0)] * 3).map(np.array)
CYCLES = st.builds(
    lambda band, rate, share: LimitCycle(
        tuple(band),
        tuple(rate),
        tuple(b * s for b, s in zip(band, share, strict=True)),
    ),
    st.lists(st.floats(1e-3, 0.1), min_size=3, max_size=3),
    st.lists(st.floats(1e-4, 1e-2) | st.floats(-1e-2, -1e-4), min_size=3, max_size=3),
    st.lists(st.floats(-1.0, 1.0), min_size=3, max_size=3),
)


# --- limit cycle


class Attitude(NamedTuple):
    angles: Array
    rotation: Array
    rates: Array


def limit_cycling(cycle: LimitCycle, time: float, reference: Array | None = None) -> Attitude:
    """Return the attitude relative to a reference: angles, rotation and body rates."""
    base = np.eye(3) if reference is None else reference
    flown, motion = np.zeros(12), np.zeros(6)
    limit_cycle(cycle.packed(), base, time, flown, motion)
    rotation = flown[3:].reshape(3, 3)
    assert not flown[:3].any() and not motion[3:].any()
    return Attitude(np.array(oriend(base.T @ rotation)), rotation, motion[:3])


@settings(deadline=None)
@given(CYCLES, st.floats(0.0, 1e5))
def test_limit_cycle_stays_in_its_deadband_and_repeats(cycle: LimitCycle, time: float) -> None:
    now = limit_cycling(cycle, time)
    for k, (band, rate) in enumerate(zip(cycle.deadband, cycle.rate, strict=True)):
        assert abs(now.angles[k]) <= band + 1e-15
        period = 4.0 * band / abs(rate)
        again = limit_cycling(cycle, time + period).angles[k]
        opposite = limit_cycling(cycle, time + period / 2.0).angles[k]
        assert again == pytest.approx(now.angles[k], abs=1e-9)
        assert opposite == pytest.approx(-now.angles[k], abs=1e-9)


@settings(deadline=None)
@given(CYCLES)
def test_limit_cycle_starts_at_its_rate_and_reverses_at_the_deadband(cycle: LimitCycle) -> None:
    assert limit_cycling(cycle, 0.0).angles == pytest.approx(cycle.start, abs=1e-14)
    for k, (band, rate, start) in enumerate(zip(cycle.deadband, cycle.rate, cycle.start, strict=True)):
        side = band if rate > 0.0 else -band
        arrives = (side - start) / rate
        before, after = 0.5 * arrives, arrives + 0.5 * band / abs(rate)
        assert limit_cycling(cycle, before).angles[k] == pytest.approx(start + rate * before, abs=1e-12)
        assert limit_cycling(cycle, arrives).angles[k] == pytest.approx(side, abs=1e-12)
        assert limit_cycling(cycle, after).angles[k] == pytest.approx(side - 0.5 * side, abs=1e-12)


def test_assumed_free_flyer_has_a_period_of_200_s() -> None:
    cycle = LimitCycle((BAND,) * 3, (RATE,) * 3, (0.0,) * 3)
    for time, angle in ((0.0, 0.0), (50.0, BAND), (100.0, 0.0), (150.0, -BAND), (200.0, 0.0), (36e5 + 25.0, BAND / 2)):
        assert limit_cycling(cycle, time).angles == pytest.approx([angle] * 3, abs=1e-11)
    assert pytest.approx(200.0) == PERIOD


@settings(deadline=None)
@given(CYCLES, st.floats(0.0, 1e3))
def test_body_rates_are_the_derivative_of_the_attitude(cycle: LimitCycle, time: float) -> None:
    step = 1e-3
    before, now, after = (limit_cycling(cycle, t) for t in (time, time + step / 2.0, time + step))
    half = [band / abs(rate) for band, rate in zip(cycle.deadband, cycle.rate, strict=True)]
    turns = [
        int((sign * start + band + abs(rate) * t) // (2.0 * band))
        for t in (time, time + step)
        for band, rate, start, sign in zip(cycle.deadband, cycle.rate, cycle.start, np.sign(cycle.rate), strict=True)
    ]
    if turns[:3] != turns[3:] or min(half) < step:
        return  # an axis reverses between the two times
    moved = Rotation.from_matrix(before.rotation.T @ after.rotation).as_rotvec() / step
    assert now.rates == pytest.approx(moved, abs=1e-8)


@settings(deadline=None)
@given(CYCLES, st.floats(0.0, 1e4), VECTORS)
def test_body_cycles_about_its_reference_attitude(cycle: LimitCycle, time: float, turn: Array) -> None:
    reference = Rotation.from_rotvec(turn).as_matrix()
    alone, there = limit_cycling(cycle, time), limit_cycling(cycle, time, reference)
    assert there.rotation == pytest.approx(reference @ endori(*alone.angles), abs=1e-14)
    assert there.rates == pytest.approx(alone.rates, abs=0.0)


def test_axis_without_rate_or_deadband_does_not_move() -> None:
    cycle = LimitCycle((BAND, 0.0, BAND), (0.0, RATE, -RATE), (0.3 * BAND, 0.0, BAND))
    found = limit_cycling(cycle, 25.0)
    assert found.angles == pytest.approx([0.3 * BAND, 0.0, BAND / 2.0], abs=1e-12)


def test_start_outside_the_deadband_is_rejected() -> None:
    with pytest.raises(InputError, match=r"axis 2: .*0\.2 rad.*0\.1 rad"):
        LimitCycle((0.1,) * 3, (0.01,) * 3, (0.0, 0.2, 0.0)).packed()


# --- coasting


def pose(position: Array, rotation: Array) -> Array:
    return np.concatenate([position, rotation.ravel()])


@settings(deadline=None, max_examples=60)
@given(VECTORS, VECTORS, VECTORS, VECTORS, st.floats(0.0, 30.0), st.integers(1, 300))
def test_coasting_does_not_depend_on_the_number_of_steps(
    place: Array, turn: Array, rates: Array, velocity: Array, time: float, steps: int
) -> None:
    start = Rotation.from_rotvec(turn).as_matrix()
    flown = pose(place, start)
    motion = np.concatenate([rates, velocity])
    for _ in range(steps):
        coast(flown, motion, time / steps)
    assert flown[:3] == pytest.approx(place + velocity * time, abs=1e-11)
    expected = start @ Rotation.from_rotvec(rates * time).as_matrix()
    assert flown[3:].reshape(3, 3) == pytest.approx(expected, abs=1e-11)


@pytest.mark.parametrize("rate", [1e-7, 3e-3, 0.2, 40.0])
def test_rotation_stays_orthonormal_for_two_hours(rate: float) -> None:
    axis = np.array([0.36, -0.48, 0.8])
    flown, motion = pose(np.zeros(3), np.eye(3)), np.concatenate([axis * rate, np.zeros(3)])
    steps = 360_000  # two hours
    for _ in range(steps):
        coast(flown, motion, 0.02)
    rotation = flown[3:].reshape(3, 3)
    assert np.abs(rotation.T @ rotation - np.eye(3)).max() < 1e-12
    assert np.linalg.det(rotation) == pytest.approx(1.0, abs=1e-12)
    expected = Rotation.from_rotvec(axis * ((rate * 0.02 * steps) % (2.0 * np.pi))).as_matrix()
    assert rotation == pytest.approx(expected, abs=1e-8)


# --- the orbiter's translation

SPEED, REACHED_IN = 0.2 * FOOT, 2.0


def translated(commands: list[tuple[float, tuple[float, float, float]]], dt: float) -> tuple[Array, Array]:
    position, velocity = np.zeros(3), np.zeros(3)
    for seconds, command in commands:
        for _ in range(round(seconds / dt)):
            translate(position, velocity, np.array(command, dtype=np.float64), SPEED, REACHED_IN, dt)
    return position, velocity


def test_orbiter_reaches_its_speed_and_stops_when_the_stick_is_centred() -> None:
    position, velocity = translated([(1.0, (1, 0, -1))], 0.02)
    assert velocity == pytest.approx([SPEED / 2.0, 0.0, -SPEED / 2.0])
    assert position == pytest.approx([SPEED / 4.0, 0.0, -SPEED / 4.0])
    position, velocity = translated([(5.0, (1, 0, -1))], 0.02)
    assert velocity == pytest.approx([SPEED, 0.0, -SPEED], abs=0.0)
    assert position == pytest.approx([4.0 * SPEED, 0.0, -4.0 * SPEED])
    position, velocity = translated([(5.0, (1, 0, -1)), (2.5, (0, 0, 0))], 0.02)
    assert velocity == pytest.approx([0.0, 0.0, 0.0], abs=0.0)
    assert position == pytest.approx([5.0 * SPEED, 0.0, -5.0 * SPEED])
    # A reversal changes the velocity by 2 SPEED, and so takes 4 s.
    position, velocity = translated([(2.0, (0, 1, 0)), (4.0, (0, -1, 0))], 0.02)
    assert velocity[1] == pytest.approx(-SPEED)
    assert position[1] == pytest.approx(SPEED)


@settings(deadline=None, max_examples=60)
@given(
    st.lists(
        st.tuples(st.integers(1, 8).map(lambda n: n * 0.75), st.tuples(*[st.sampled_from([-1, 0, 1])] * 3)),
        max_size=6,
    ),
    st.sampled_from([0.75, 0.25, 0.05]),
)
def test_orbiter_position_does_not_depend_on_the_step(
    commands: list[tuple[float, tuple[float, float, float]]], dt: float
) -> None:
    position, velocity = translated(commands, dt)
    fine, speeds = translated(commands, 0.0125)
    assert position == pytest.approx(fine, abs=1e-11)
    assert velocity == pytest.approx(speeds, abs=1e-11)
    assert np.all(np.abs(velocity) <= SPEED * (1.0 + 1e-12))
