"""Named dimensions and quantities derived from them: arithmetic with units, and the location of mistakes."""

from __future__ import annotations

import math
import re
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
def test_expression_equals_the_same_arithmetic_in_si(a: float, b: float, c: float) -> None:
    names = {"a": f"{a!r} ft", "b": f"{b!r} ft", "c": c}
    result = derived("= -(a - b / 2) * c + max(a, b, 1 m) * cos(30 deg) - 2 ft", **names)
    a, b = a * FOOT, b * FOOT
    expected = -(a - b / 2.0) * c + max(a, b, 1.0) * math.cos(math.radians(30.0)) - 2.0 * FOOT
    assert float(Length.read(result)) == pytest.approx(expected, abs=1e-12)


@given(sizes, sizes)
def test_units_propagate_through_products_quotients_and_roots(a: float, b: float) -> None:
    names = {"a": f"{a!r} ft", "b": f"{b!r} in", "t": "2 s"}
    assert derived("= sqrt(a * a + b * b)", **names).endswith(" m")
    assert derived("= a / t", **names).endswith(" m/s")
    assert derived("= a / b", **names) == pytest.approx(12.0 * a / b)
    assert derived("= 3 deg / t + 1 deg/s", **names).endswith(" rad/s")


def test_dimension_can_use_only_dimensions_above_it() -> None:
    assert derived("= c", a="1 m", b="= a * 2", c="= b + a") == "3.0 m"
    assert wrong("= a", a="= b", b="1 m").startswith("dimensions.a: ")


@pytest.mark.parametrize(
    ("expression", "pattern"),
    [
        ("= heigth", r"body\.size: .*'heigth'.* height, turn"),
        ("= height + turn", r"body\.size: .*length.* angle "),
        ("= height + 1", r"body\.size: .*length.* number "),
        ("= height * height", r"body\.size: .*result.* length"),
        ("= height / (height - height)", r"body\.size: .*divide.* 0"),
        ("= 2 parsnips", r"body\.size: 'parsnips'.* unit"),
        ("= height ** 2", r"body\.size: .*\+ - \* /"),
        ("= __import__('os')", r"body\.size: "),
        ("= height.real", r"body\.size: 'height\.real'"),
        ("= cos(height)", r"body\.size: cos .*angle"),
        ("= sqrt(-height)", r"body\.size: sqrt .*-0"),
        ("= (height", r"body\.size: '\(height'"),
        ("=" + "(" * 400, r"body\.size: .*300"),
        ("=" + "-" * 299, r"body\.size: "),
        ("= 1e308 m * 10 + 1e308 m * 10", r"body\.size: "),
    ],
)
def test_invalid_expression_is_rejected_with_its_location(expression: str, pattern: str) -> None:
    assert re.match(pattern, wrong(expression, height="2 ft", turn="30 deg"))


@pytest.mark.parametrize("given_", [True, [1], float("nan")])
def test_invalid_dimension_is_rejected(given_: object) -> None:
    assert wrong("1 m", height=given_).startswith("dimensions.height: ")


def test_expressions_can_use_the_dimensions_of_another_file() -> None:
    raw: dict[str, Any] = {"phase": [{"above": "= depth + 0.5 ft"}]}
    assert derive_from({"depth": "1.0 m"}, raw) == []
    assert float(Length.read(raw["phase"][0]["above"])) == pytest.approx(1.0 + 0.5 * FOOT)
