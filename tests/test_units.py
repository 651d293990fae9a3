"""Quantities in files: bare numbers are SI, strings have units, other values are rejected."""

from __future__ import annotations

import datetime
import keyword
import math
import subprocess
import sys
import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck import units
from aftdeck.units import (
    Acceleration,
    Angle,
    AngularAcceleration,
    AngularRate,
    Length,
    Mass,
    Quantity,
    Speed,
    Time,
)
from tests.each import each

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


@each("unit", units._USUAL)
@pytest.mark.parametrize("kind", [*KINDS, Acceleration, AngularAcceleration])
def test_usual_units_have_exactly_the_size_from_pint(unit: str, kind: type[Quantity]) -> None:
    assert units._size(unit, kind.unit) == units.size_by_pint(unit, kind.unit)


@pytest.mark.slow
def test_built_in_files_are_read_without_pint() -> None:
    code = """
import sys
from aftdeck.scenario.load import built_in, load_scenario
for name in built_in():
    load_scenario(name)
assert "pint" not in sys.modules, "pint was imported"
"""
    done = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
