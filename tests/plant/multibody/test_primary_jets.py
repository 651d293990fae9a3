"""The orbiter's primary jets against a parked arm: what was published about the swing of its tip."""

from __future__ import annotations

import pytest

from aftdeck.units import INCH
from benchmarks.jets import AXES, Case, Holder, swing

ROLL = AXES.index("roll")
HOLDERS: tuple[Holder, ...] = ("brakes", "servos")


@pytest.mark.slow
@pytest.mark.parametrize("held", HOLDERS)
@pytest.mark.parametrize("seconds", [0.08, 1.0, 3.0])
def test_jets_move_a_horizontal_arm_by_4_in_from_peak_to_peak_at_most(held: Holder, seconds: float) -> None:
    case = Case("horizontal, aft", 0, held, seconds)
    assert max(swing(case, axis, after=6.0).extent for axis in range(len(AXES))) < 4 * INCH


@pytest.mark.slow
@pytest.mark.parametrize("held", HOLDERS)
def test_jets_that_act_for_3_s_move_a_vertical_arm_by_about_6_in_in_roll(held: Holder) -> None:
    found = [swing(Case("vertical", 0, held, 3.0), axis, after=6.0) for axis in range(len(AXES))]
    assert max(found, key=lambda one: one.farthest) is found[ROLL]
    assert found[ROLL].farthest < 6 * INCH < found[ROLL].extent  # "excursion" may mean either


@pytest.mark.slow
def test_parked_arm_with_31_000_lb_is_at_rest_100_s_after_a_pulse() -> None:
    assert swing(Case("vertical", 31_000, "servos", 0.08), ROLL, after=125.0).rest < 100.0
