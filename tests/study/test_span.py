"""Ranges and distributions of a factor."""

from __future__ import annotations

import math
import statistics

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.errors import InputError
from aftdeck.study.schema import FactorSpec
from aftdeck.study.span import measure, span_of

RANGE = FactorSpec(low=2.0, high=50.0)
SPECS = [
    RANGE,
    FactorSpec(low=2.0, high=50.0, scale="log"),
    FactorSpec(distribution="uniform", low="2 ft", high="50 ft"),
    FactorSpec(distribution="triangular", low=2.0, high=50.0, mean=10.0),
    FactorSpec(distribution="normal", mean=10.0, deviation=3.0),
    FactorSpec(distribution="normal", mean=10.0, deviation=3.0, low=9.0, high=30.0),
    FactorSpec(distribution="lognormal", mean=10.0, deviation=0.3),
    FactorSpec(distribution="lognormal", mean=10.0, deviation=0.3, low=-1.0, high=11.0),
]
SHARES = st.floats(0.0, 1.0)


@pytest.mark.parametrize("spec", SPECS)
@given(first=SHARES, second=SHARES)
def test_greater_share_never_gives_a_smaller_value(spec: FactorSpec, first: float, second: float) -> None:
    span = span_of(spec)
    low, high = sorted((first, second))
    assert span.low <= span.at(low) <= span.at(high) <= span.high


def test_range_begins_and_ends_at_its_bounds() -> None:
    for spec in SPECS[:4]:
        span = span_of(spec)
        assert (span.at(0.0), span.at(1.0)) == (2.0, 50.0)


def test_equal_steps_on_a_logarithmic_scale_are_equal_ratios() -> None:
    span = span_of(SPECS[1])
    assert span.at(0.5) / span.at(0.25) == pytest.approx(span.at(0.75) / span.at(0.5), rel=1e-8)


@pytest.mark.parametrize(
    ("spec", "mean", "deviation"),
    [
        (SPECS[3], (2.0 + 50.0 + 10.0) / 3.0, math.sqrt((4 + 2500 + 100 - 100 - 20 - 500) / 18.0)),
        (SPECS[4], 10.0, 3.0),
        (SPECS[6], 10.0 * math.exp(0.045), 10.0 * math.exp(0.045) * math.sqrt(math.exp(0.09) - 1.0)),
    ],
)
def test_distribution_has_its_mean_and_deviation(spec: FactorSpec, mean: float, deviation: float) -> None:
    span, count = span_of(spec), 20_000
    values = [span.at((i + 0.5) / count) for i in range(count)]
    assert statistics.fmean(values) == pytest.approx(mean, rel=1e-3)
    assert statistics.pstdev(values) == pytest.approx(deviation, rel=2e-3)


def test_value_keeps_its_unit() -> None:
    span = span_of(SPECS[2])
    assert measure(span.value(span.at(0.3))) == (span.at(0.3), "ft")


@pytest.mark.parametrize(
    ("spec", "field"),
    [
        (FactorSpec(low=1.0), "high"),
        (FactorSpec(low=1.0, high="2 m"), "low"),
        (FactorSpec(low=3.0, high=2.0), "high"),
        (FactorSpec(low=0.0, high=2.0, scale="log"), "low"),
        (FactorSpec(low=0.0, high=2.0, mean=1.0), "mean"),
        (FactorSpec(low="much", high=2.0), "low"),
        (FactorSpec(distribution="normal", mean=1.0), "deviation"),
        (FactorSpec(distribution="normal", mean=1.0, deviation=0.0), "deviation"),
        (FactorSpec(distribution="normal", mean=1.0, deviation=1.0, scale="log"), "scale"),
        (FactorSpec(distribution="lognormal", mean=-1.0, deviation=1.0), "mean"),
        (FactorSpec(distribution="triangular", low=0.0, high=1.0, mean=2.0), "mean"),
    ],
)
def test_contradiction_is_reported_at_its_field(spec: FactorSpec, field: str) -> None:
    with pytest.raises(InputError, match=f"^{field}: "):
        span_of(spec)
