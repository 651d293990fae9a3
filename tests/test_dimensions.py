"""Dimensions by name and quantities derived from them: arithmetic with units, and every mistake with its place."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.dimensions import derive, derive_from
from aftdeck.files import place
from aftdeck.units import Length

FOOT = 0.3048
sizes = st.floats(0.01, 100.0)


def derived(expression: str, **dimensions: object) -> Any:
    raw: dict[str, Any] = {"dimensions": dict(dimensions), "body": [{"size": [expression]}]}
    problems = derive(raw)
    assert not problems, problems
    return raw["body"][0]["size"][0]


def wrong(expression: object, **dimensions: object) -> str:
    raw: dict[str, Any] = {"dimensions": dict(dimensions), "body": {"size": expression}}
    problem = derive(raw)[0]
    return f"{place(problem.where)}: {problem.what}"


@given(sizes, sizes, sizes)
def test_a_result_is_that_of_the_same_arithmetic_in_si(a: float, b: float, c: float) -> None:
    names = {"a": f"{a!r} ft", "b": f"{b!r} ft", "c": c}
    result = derived("= -(a - b / 2) * c + max(a, b, 1 m) * cos(30 deg) - 2 ft", **names)
    a, b = a * FOOT, b * FOOT
    expected = -(a - b / 2.0) * c + max(a, b, 1.0) * math.cos(math.radians(30.0)) - 2.0 * FOOT
    assert float(Length.read(result)) == pytest.approx(expected, abs=1e-12)


@given(sizes, sizes)
def test_units_go_through_products_quotients_and_roots(a: float, b: float) -> None:
    names = {"a": f"{a!r} ft", "b": f"{b!r} in", "t": "2 s"}
    assert derived("= sqrt(a * a + b * b)", **names).endswith(" m")
    assert derived("= a / t", **names).endswith(" m/s")
    assert derived("= a / b", **names) == pytest.approx(12.0 * a / b)
    assert derived("= 3 deg / t + 1 deg/s", **names).endswith(" rad/s")


def test_a_dimension_is_derived_from_those_above_it() -> None:
    assert derived("= c", a="1 m", b="= a * 2", c="= b + a") == "3.0 m"
    assert wrong("= a", a="= b", b="1 m").startswith("dimensions.a: no dimension 'b'")


@pytest.mark.parametrize(
    ("expression", "said"),
    [
        ("= heigth", "body.size: no dimension 'heigth'; there are: height, turn"),
        ("= height + turn", "body.size: a length and an angle cannot be added or compared"),
        ("= height + 1", "body.size: a length and a number cannot be added or compared"),
        ("= height * height", "body.size: the result is not a length"),
        ("= height / (height - height)", "body.size: the expression divides by 0"),
        ("= 2 parsnips", "body.size: 'parsnips' is not a unit"),
        ("= height ** 2", "body.size: the only operators are + - * /"),
        ("= __import__('os')", "body.size: "),
        ("= height.real", "body.size: 'height.real' cannot be computed"),
        ("= cos(height)", "body.size: cos needs an angle"),
        ("= sqrt(-height)", "body.size: sqrt needs a value of 0 or more"),
        ("= (height", "body.size: '(height' is not an expression"),
        ("=" + "(" * 400, "body.size: an expression has at most 300 characters"),
        ("=" + "-" * 299, "body.size: "),
        ("= 1e308 m * 10 + 1e308 m * 10", "body.size: "),
    ],
)
def test_a_mistake_is_told_with_its_place(expression: str, said: str) -> None:
    assert wrong(expression, height="2 ft", turn="30 deg").startswith(said)


@pytest.mark.parametrize("given_", [True, [1], float("nan")])
def test_a_dimension_that_is_none_is_refused(given_: object) -> None:
    assert wrong("1 m", height=given_).startswith("dimensions.height: expected a quantity")


def test_another_files_dimensions_serve_expressions() -> None:
    raw: dict[str, Any] = {"phase": [{"above": "= depth + 0.5 ft"}]}
    assert derive_from({"depth": "1.0 m"}, raw) == []
    assert float(Length.read(raw["phase"][0]["above"])) == pytest.approx(1.0 + 0.5 * FOOT)
