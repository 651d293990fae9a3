"""Conditions: limits, margins, and their texts for the operator in feet and inches or in SI."""

from __future__ import annotations

import math

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from aftdeck.units import FOOT, INCH
from aftdeck.worksite.conditions import (
    Unit,
    Units,
    all_hold,
    condition_text,
    failing,
    quantity_text,
    rejection_text,
    tightest,
    within,
)

HEIGHT = ("palm {} above the bar", "palm {} below the bar")
PAST = ("bar {} clear of the palm", "bar {} past the palm's face")
TURNED = ("turned {}", "turned back {}")
NUMBERS = st.floats(-50.0, 50.0)


@settings(deadline=None)
@given(NUMBERS, NUMBERS, st.floats(0.0, 20.0))
@example(0.01905 + 1e-9, 0.0, 0.01905)
def test_condition_holds_within_its_limits_with_margin_to_the_nearer(value: float, least: float, wide: float) -> None:
    greatest = least + wide
    found = within("palm height", value, least, greatest, "m", HEIGHT)
    assert found.holds == (least <= value <= greatest) == (found.margin >= 0.0)
    assert found.limit in (least, greatest)
    assert abs(found.margin) == pytest.approx(abs(value - found.limit), abs=0.0)
    assert not found.holds or found.margin <= wide / 2.0 + 1e-12


@settings(deadline=None)
@given(NUMBERS)
def test_one_sided_condition_uses_its_only_limit(value: float) -> None:
    most = within("spacing", value, -math.inf, 1.0, "m", ("{}", "−{}"))
    assert (most.margin, most.limit) == (1.0 - value, 1.0)
    least = within("clear", value, 0.0, math.inf, "m", ("{}", "−{}"))
    assert (least.margin, least.limit) == (value, 0.0)


def test_condition_on_nan_never_holds() -> None:
    assert not within("palm height", math.nan, -1.0, 1.0, "m", HEIGHT).holds


@pytest.mark.parametrize(
    ("value", "units", "text"),
    [
        (2.5 * INCH, "ft-in", "palm 2.5 in above the bar, 0 to 0.75 in allowed"),
        (-0.31 * INCH, "ft-in", "palm 0.31 in below the bar, 0 to 0.75 in allowed"),
        (12.5 * FOOT, "ft-in", "palm 12.5 ft above the bar, 0 to 0.75 in allowed"),
        (2.5 * INCH, "SI", "palm 63.5 mm above the bar, 0 to 19 mm allowed"),
        (0.0, "SI", "palm 0 mm above the bar, 0 to 19 mm allowed"),
        # Enough digits to distinguish the value from the limit.
        (-2e-7 * INCH, "ft-in", "palm 0.0000002 in below the bar, 0 to 0.75 in allowed"),
        (0.7502 * INCH, "ft-in", "palm 0.7502 in above the bar, 0 to 0.75 in allowed"),
    ],
)
def test_condition_text_uses_the_operators_units(value: float, units: Units, text: str) -> None:
    assert condition_text(within("palm height", value, 0.0, 0.75 * INCH, "m", HEIGHT), units) == text


@pytest.mark.parametrize(
    ("value", "least", "greatest", "unit", "templates", "text"),
    [
        (0.1, 0.0, math.inf, "m", PAST, "bar 100 mm clear of the palm"),
        (-0.1, 0.0, math.inf, "m", PAST, "bar 100 mm past the palm's face, none allowed"),
        (-0.1, -0.05, 0.05, "rad", TURNED, "turned back 5.73°, at most 2.86° allowed"),
        (2.0, 3.0, math.inf, "s", ("{} held", ""), "2 s held, at least 3 s allowed"),
        (2.0, 3.0, 9.0, "s", ("not tested", ""), "not tested, 3 to 9 s allowed"),
        (2.0, -1.0, 1.0, "m", ("{port} {} off", ""), "{port} 2 m off, at most 1 m allowed"),
    ],
)
def test_condition_text_names_the_value_and_the_allowed_range(
    value: float, least: float, greatest: float, unit: Unit, templates: tuple[str, str], text: str
) -> None:
    assert condition_text(within("a", value, least, greatest, unit, templates), "SI") == text


def test_rejection_lists_only_the_failed_conditions() -> None:
    conditions = [within("palm height", x, 0.0, 0.75 * INCH, "m", HEIGHT) for x in (2.5 * INCH, 0.01, -1.0 * INCH)]
    assert rejection_text("CAPTURE", conditions, "ft-in") == (
        "CAPTURE refused: palm 2.5 in above the bar, 0 to 0.75 in allowed; "
        "palm 1 in below the bar, 0 to 0.75 in allowed"
    )
    assert failing(conditions) == (conditions[0], conditions[2])
    assert not all_hold(conditions)
    assert rejection_text("CAPTURE", conditions[1:2], "ft-in") == ""
    assert all_hold(conditions[1:2])


def test_tightest_condition_is_found_within_one_unit() -> None:
    wide = within("a", 0.0, -1.0, 1.0, "m", HEIGHT)
    tight = within("b", 0.9, -1.0, 1.0, "m", HEIGHT)
    angle = within("c", 0.0, -1e-3, 1e-3, "rad", HEIGHT)
    assert tightest([wide, tight, angle], "m") is tight
    assert tightest([wide, tight, angle], "rad") is angle
    assert tightest([wide, tight], "rad") is None


@settings(deadline=None)
@given(st.floats(1e-3, 1e4))
def test_quantity_text_is_accurate_and_has_no_exponent(value: float) -> None:
    text = quantity_text(value, "", "SI")
    assert "e" not in text
    assert float(text) == pytest.approx(value, rel=5.1e-3, abs=5.1e-4)
