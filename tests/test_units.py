"""Quantities in files: bare numbers are SI, strings have units, other values are rejected."""

from __future__ import annotations

import datetime
import keyword
import math
import time
from typing import Any

import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.unit_sizes import UNITS, size_of
from aftdeck.units import (
    Angle,
    AngularRate,
    Length,
    Mass,
    Quantity,
    Speed,
    Time,
    Torque,
)
from tests.each import each

PINT: pint.UnitRegistry[Any] = pint.UnitRegistry()
KINDS = (Length, Angle, Speed, AngularRate, Mass, Time)


@pytest.mark.parametrize(
    ("kind", "text", "value"),
    [
        (Length, "12 in", 0.3048),
        (Length, "12in", 0.3048),
        (Length, " 1 ft ", 0.3048),
        (Length, "-2.5 mm", -0.0025),
        (Length, "1e3 km", 1e6),
        (Length, ".5 yd", 0.4572),
        (Angle, "180 deg", math.pi),
        (Angle, "-90 degree", -math.pi / 2),
        (Angle, "1 rad", 1.0),
        (Angle, "60 arcmin", math.pi / 180),
        (Angle, "0.5 turn", math.pi),
        (Speed, "2 ft/s", 0.6096),
        (Speed, "36 km/hour", 10.0),
        (Speed, "60 m / min", 1.0),
        (AngularRate, "4.76 deg/s", math.radians(4.76)),
        (Mass, "905 lb", 410.501),
        (Mass, "1 t", 1000.0),
        (Mass, "1 slug", 14.593903),
        (Time, "20 ms", 0.02),
        (Time, "2 min", 120.0),
    ],
)
def test_number_with_a_unit_is_converted_to_si(kind: type[Quantity], text: str, value: float) -> None:
    assert kind.read(text) == pytest.approx(value, rel=1e-6)


@pytest.mark.parametrize("kind", KINDS)
def test_bare_number_is_read_as_si(kind: type[Quantity]) -> None:
    assert kind.read(2.5) == 2.5
    assert kind.read(-3) == -3.0
    assert isinstance(kind.read(0), kind)


@pytest.mark.parametrize(
    ("kind", "given"),
    [
        (Length, "12 deg"),
        (Length, "12 parsnip"),
        (Length, "12"),
        (Length, ""),
        (Length, "m"),
        (Length, "12 m 3 cm"),
        (Length, "12 m^2"),
        (Length, "twelve in"),
        (Length, "1,5 m"),
        (Length, "nan m"),
        (Length, "1 m; 2 m"),
        (Length, "__import__('os')"),
        (Angle, "5 m"),
        (Angle, "5 Hz"),
        (Angle, "5 m/m"),
        (Angle, "5 percent"),
        (Speed, "2 ft"),
        (AngularRate, "5 Hz"),
        (AngularRate, "5 ft/s"),
        (Mass, "5 lbf"),
        (Mass, "5 degC"),
        (Time, "5 dB"),
    ],
)
def test_other_dimension_or_invalid_quantity_is_rejected(kind: type[Quantity], given: str) -> None:
    with pytest.raises(ValueError, match=f"{kind.noun}.* {kind.unit}"):
        kind.read(given)


@pytest.mark.parametrize(
    "given", [True, None, [1.0], {"value": 1.0}, datetime.date(2020, 1, 1), b"1 m"], ids=lambda g: type(g).__name__
)
def test_value_that_is_not_a_number_or_text_is_rejected(given: object) -> None:
    with pytest.raises(ValueError, match=r"number in m .*'12 in'"):
        Length.read(given)


@pytest.mark.parametrize("given", [math.nan, math.inf, -math.inf, "1e999 m", 10**400])
def test_value_that_is_not_finite_is_rejected(given: object) -> None:
    with pytest.raises(ValueError, match="finite number in m"):
        Length.read(given)


@each("word", [*keyword.kwlist, "degF", "dBm", "m/degF", "m/None", "in/in", "delta", "pH"])
def test_python_keywords_and_pint_units_are_rejected_or_read(word: str) -> None:
    try:
        assert math.isfinite(Length.read(f"5 {word}"))
    except ValueError as error:
        assert "length" in str(error)


@settings(derandomize=True, deadline=None, max_examples=150, database=None)
@given(st.one_of(st.text(max_size=20), st.from_regex(r"[-+]?[0-9.eE]{1,6} ?[a-zA-Z/* ]{0,12}", fullmatch=True)))
def test_any_text_is_read_or_raises_value_error(text: str) -> None:
    for kind in KINDS:
        try:
            assert math.isfinite(kind.read(text))
        except ValueError as error:
            assert str(error)


def test_very_long_text_is_rejected_quickly() -> None:
    began = time.thread_time()  # time of this thread only
    with pytest.raises(ValueError, match="length") as caught:
        Length.read("9" * 10_000 + "!")
    assert time.thread_time() - began < 0.5
    assert len(str(caught.value)) < 500


@each("name", UNITS)
def test_units_have_the_size_and_the_dimension_from_pint(name: str) -> None:
    unit, witness = UNITS[name], PINT.Quantity(1.0, name).to_base_units()
    powers = zip(("meter", "kilogram", "second", "radian"), unit.dimension, strict=True)
    assert unit.size == pytest.approx(witness.magnitude, rel=1e-15)
    assert witness.units == PINT.Unit("*".join(f"{base}**{power}" for base, power in powers))


@settings(derandomize=True, deadline=None, max_examples=300, database=None)
@given(st.lists(st.sampled_from(sorted(UNITS)), min_size=1, max_size=4), st.text("*/", min_size=3, max_size=3))
def test_products_and_quotients_have_the_size_from_pint(names: list[str], operators: str) -> None:
    text = names[0] + "".join(operator + name for operator, name in zip(operators, names[1:], strict=False))
    found = size_of(text)
    assert found is not None
    witness = PINT.Quantity(1.0, text).to_base_units()
    assert found[0] == pytest.approx(witness.magnitude, rel=1e-14)


@pytest.mark.parametrize("text", ["parsnip", "m*parsnip", "m/s/parsnip", "M", "Kg", "degC", "dB"])
def test_unknown_name_is_no_unit(text: str) -> None:
    assert size_of(text) is None


def test_sizes_with_which_recordings_were_made_do_not_change() -> None:
    sizes = {"ft": 0.30479999999999996, "lb": 0.4535923700000001, "deg": 0.017453292519943295, "in": 0.0254}
    assert {name: UNITS[name].size for name in sizes} == sizes
    assert Torque.read("1 ft*lbf") == 1.3558179483314001


def test_error_lists_the_units_that_a_file_may_use() -> None:
    with pytest.raises(ValueError) as caught:
        Length.read("5 furlong")
    assert all(f" {symbol}" in str(caught.value) for symbol in ("mm", "cm", "km", "in", "ft", "yd", "mi", "nmi"))
