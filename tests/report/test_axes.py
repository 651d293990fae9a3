"""Charts of a report: their numbers, and what is drawn into their axes."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.ticker import MaxNLocator

from aftdeck.report.page.axes import Axes, Margins, Span, span_of
from aftdeck.report.page.ticks import ticks

MARGINS = Margins(0.5, 0.5, 0.5, 0.5)


@given(st.floats(-1e5, 1e5), st.floats(1e-4, 1e6), st.floats(1.0, 30.0))
def test_numbers_of_an_axis_are_few_and_inside_it(low: float, extent: float, most: float) -> None:
    high = low + extent
    found = ticks(low, high, most)
    assert 2 <= len(found.values) <= 10
    assert low - 1e-6 * extent <= found.values[0] and found.values[-1] <= high + 1e-6 * extent
    steps = np.diff(found.values)
    assert steps == pytest.approx(steps[0], rel=1e-6)


def test_numbers_of_an_axis_are_those_of_matplotlib() -> None:
    rng = np.random.default_rng(7)
    for _ in range(500):
        low, extent, most = rng.normal(0.0, 100.0), 10.0 ** rng.uniform(-1.0, 4.0), int(rng.integers(1, 10))
        locator = MaxNLocator(nbins=most, steps=[1, 2, 2.5, 5, 10])
        expected = [value for value in locator.tick_values(low, low + extent) if low <= value <= low + extent]
        assert ticks(low, low + extent, most).values == pytest.approx(expected, abs=1e-9 * extent)


@given(st.floats(-1e3, 1e3), st.floats(1e-3, 1e4))
def test_texts_of_an_axis_are_its_numbers(low: float, extent: float) -> None:
    found = ticks(low, low + extent, 5.0)
    factor = float(found.power or 1.0)
    written = [float(text.replace("−", "-")) * factor for text in found.texts]
    assert written == pytest.approx(list(found.values), abs=2e-3 * (found.values[1] - found.values[0]))
    assert len(set(found.texts)) == len(found.texts)


@pytest.mark.parametrize(
    ("low", "high", "texts", "power"),
    [
        (0.0, 1.0, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"], ""),
        (-180.0, 190.0, ["−100", "0", "100"], ""),
        (0.0, 4e-7, ["0", "1", "2", "3", "4"], "1e-7"),
        (0.0, 4e7, ["0", "1", "2", "3", "4"], "1e7"),
    ],
)
def test_small_and_great_numbers_are_multiples_of_a_power(
    low: float, high: float, texts: list[str], power: str
) -> None:
    found = ticks(low, high, 5.0)
    assert (found.texts, found.power) == (texts, power)


def test_the_range_of_values_has_a_margin_even_if_all_are_equal() -> None:
    assert span_of([1.0, 3.0]) == (0.9, 3.1)
    for value in (0.0, 2.0, -5.0):
        first, last = span_of([value, value])
        assert first < value < last


def paths(text: str) -> list[str]:
    return re.findall(r'clip-path="[^"]*" d="([^"]*)"', text)


def test_a_line_is_interrupted_where_it_has_no_values() -> None:
    axes = Axes((2.0, 2.0), MARGINS, Span(0.0, 4.0), Span(0.0, 1.0))
    axes.line(np.arange(5.0), np.array([math.nan, 0.0, 1.0, math.nan, 0.5]), "#000", 1.0)
    (path,) = paths(axes.chart("a line").svg)
    assert path == "M54 108 72 36M108 72"


def test_axes_of_equal_scale_are_in_the_middle() -> None:
    axes = Axes((3.0, 2.0), MARGINS, Span(10.0, 0.0), Span(0.0, 10.0), equal=True)
    assert axes.right - axes.left == pytest.approx(axes.bottom - axes.top)
    assert 0.5 * (axes.left + axes.right) == pytest.approx(108.0)
    assert axes.across(10.0) == pytest.approx(axes.left)  # the greater value is at the left


def test_texts_of_a_chart_are_escaped() -> None:
    axes = Axes((2.0, 2.0), MARGINS, Span(0.0, 1.0), Span(0.0, 1.0))
    axes.title("<b> & co")
    assert "&lt;b&gt; &amp; co" in axes.chart("a title").svg
