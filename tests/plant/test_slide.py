"""Telescope and prong: rates and ranges."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.arms.load import load_model
from aftdeck.kinematics.linkage import L1
from aftdeck.plant.linear_actuator import Slide, Travel, travel_of_prong, travel_of_stand

FOOT = 0.3048


@given(
    drives=st.lists(st.sampled_from([-1.0, 0.0, 1.0]), min_size=1, max_size=300),
    period=st.floats(0.001, 0.2),
    rate=st.floats(0.01, 2.0),
)
def test_slide_keeps_its_range_and_rate(drives: list[float], period: float, rate: float) -> None:
    slide, travel = Slide(3.0), Travel(2.5, 3.3, rate)
    for drive in drives:
        before = slide.position
        slide.move(travel, drive, period)
        assert 2.5 <= slide.position <= 3.3
        assert abs(slide.velocity) <= rate * (1.0 + 1e-9) and drive * slide.velocity >= 0.0
        assert slide.position == pytest.approx(before + slide.velocity * period, abs=1e-15)
        if 2.5 < slide.position < 3.3:
            assert slide.velocity == pytest.approx(drive * rate, abs=1e-12 / period)


def test_driven_slide_stops_at_its_end_and_leaves_it() -> None:
    slide, travel = Slide(3.0), Travel(2.5, 3.3, 0.7)
    for _ in range(100):
        slide.move(travel, 1.0, 0.02)
    assert (slide.position, slide.velocity) == (3.3, 0.0)
    slide.move(travel, -1.0, 0.02)
    assert slide.velocity == pytest.approx(-0.7)


def test_concept_telescope_has_published_range_and_rate() -> None:
    model = load_model("concept-1972")
    stand, travel = Slide(float(model.links[L1])), travel_of_stand(model)
    assert stand.position == pytest.approx(12 * FOOT)
    stand.move(travel, 1.0, 2.0)
    assert stand.position == pytest.approx(14 * FOOT)
    stand.move(travel, 1.0, 20.0)
    assert stand.position == pytest.approx(18 * FOOT)
    stand.move(travel, -1.0, 20.0)
    assert stand.position == pytest.approx(9.5 * FOOT)


def test_arm_without_telescope_has_a_fixed_height() -> None:
    model = load_model("srms")
    stand, travel = Slide(float(model.links[L1])), travel_of_stand(model)
    for drive in (1.0, -1.0):
        stand.move(travel, drive, 1.0)
        assert (stand.position, stand.velocity) == (float(model.links[L1]), 0.0)


@pytest.mark.slow
def test_prong_closes_and_opens_in_3_5_s() -> None:
    travel = travel_of_prong(load_model("concept-1972"))
    prong = Slide(travel.low)
    assert prong.position == pytest.approx(-1.25 * FOOT)
    seconds = 0.0
    while prong.position < travel.high:
        prong.move(travel, 1.0, 0.02)
        seconds += 0.02
    assert seconds == pytest.approx((1.25 - 0.375) / 0.25, abs=0.021)
    assert prong.position == pytest.approx(-0.375 * FOOT)
    prong.move(travel, -1.0, 1.0)
    assert prong.position == pytest.approx(-0.625 * FOOT)
    prong.move(travel, 0.0, 1.0)
    assert prong.velocity == 0.0
