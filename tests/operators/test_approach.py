"""Velocities of an approach: they stop at the place, keep to the sticks' travel, line up before they come closer."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.arms.load import PorLimits
from aftdeck.operators.approach import Axis, Speeds, deflection, deflections
from aftdeck.task.along_sticks import AlongSticks
from aftdeck.task.remaining import Remaining

POR = PorLimits((0.6, 0.1), (0.08, 0.01), 0.3, 0.04)
SPEEDS = Speeds(0.6, 0.08, 1.0, POR)
DOWN = np.array([0.0, 0.0, -1.0])
"""Way out of a berth: -Z is up."""
length = st.floats(-20.0, 20.0)
turn = st.floats(-3.0, 3.0)


def left(x: float, y: float, z: float, angle: float = 0.0) -> tuple[AlongSticks, Remaining]:
    remaining = Remaining("pin", None, None, math.hypot(x, y, z), abs(angle), (0.016, 0.035))
    return AlongSticks((x, y, z), (0.0, angle, 0.0)), remaining


@given(length, length, length, turn, st.sampled_from([(), (0, 1, 2), (2, 0)]), st.booleans())
def test_deflections_stay_within_the_travel(
    x: float, y: float, z: float, angle: float, way: tuple[int, ...], out: bool
) -> None:
    thc, rhc = deflections(*left(x, y, z, angle), DOWN if out else None, way, SPEEDS)
    assert np.sqrt(thc @ thc) <= 1.0 + 1e-9
    assert np.sqrt(rhc @ rhc) <= 1.0 + 1e-9


@pytest.mark.parametrize("acceleration", [0.02, 0.3, 5.0])
@pytest.mark.parametrize("distance", [0.05, 0.5, 10.0])
def test_a_motion_with_limited_acceleration_ends_at_the_place(acceleration: float, distance: float) -> None:
    period, speed, here, axis = 0.02, 0.0, 0.0, Axis(0.6, acceleration, 0.0)
    farthest = 0.0
    for _ in range(round(600.0 / period)):
        wanted = axis.limit * deflection(distance - here, axis, SPEEDS)
        speed += max(-acceleration * period, min(acceleration * period, wanted - speed))
        here += speed * period
        farthest = max(farthest, here)
    assert here == pytest.approx(distance, abs=1e-4)
    assert farthest <= distance + 0.01 * distance + 1e-3


@given(st.floats(0.01, 3.0), length, length)
def test_it_comes_closer_only_within_the_cone_and_last_if_lined_up(height: float, x: float, y: float) -> None:
    error = max(0.0, math.hypot(x, y) - 0.008)
    thc, _ = deflections(*left(x, y, height), DOWN, (), SPEEDS)
    assert thc[2] >= 0.0
    assert (thc[2] > 0.0) == (error == 0.0 or height > max(0.5, 4.0 * error))


def test_deep_in_a_berth_the_way_out_comes_first() -> None:
    thc, rhc = deflections(*left(3.0, 0.0, -4.0, 0.5), DOWN, (), SPEEDS)
    assert thc.tolist() == [0.0, 0.0, -1.0]
    assert not rhc.any()


def test_the_way_gives_the_order_of_the_axes() -> None:
    first, _ = deflections(*left(3.0, -2.0, -1.0), None, (1, 2, 0), SPEEDS)
    then, _ = deflections(*left(3.0, 0.0, -1.0), None, (1, 2, 0), SPEEDS)
    last, _ = deflections(*left(3.0, 0.0, 0.0), None, (1, 2, 0), SPEEDS)
    assert [np.flatnonzero(thc).tolist() for thc in (first, then, last)] == [[1], [2], [0]]


def test_a_correction_that_matters_is_at_least_the_least_deflection() -> None:
    human = SPEEDS._replace(least=0.08)
    axis = Axis(0.6, 0.3, 0.003)
    assert deflection(0.004, axis, human) == 0.08
    assert deflection(0.002, axis, human) == pytest.approx(0.002 / 0.6)
    assert deflection(-0.004, axis, human) == -0.08
