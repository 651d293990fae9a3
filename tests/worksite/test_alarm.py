"""Alarm level of a clearance, from two thresholds and a hysteresis."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.worksite.watch.alarm import HYSTERESIS, Level, level_of, unchanged_between

CAUTION, WARNING = 0.6, 0.15


@pytest.mark.parametrize(
    ("clearance", "before", "level"),
    [
        (0.61, "info", "info"),
        (0.59, "info", "caution"),
        (0.61, "caution", "caution"),
        (0.63, "caution", "info"),
        (0.14, "info", "warning"),
        (0.152, "warning", "warning"),
        (0.16, "warning", "caution"),
        (0.61, "warning", "caution"),
        (-0.01, "info", "warning"),
    ],
)
def test_alarm_level_ends_only_beyond_its_hysteresis(clearance: float, before: Level, level: Level) -> None:
    assert level_of(clearance, CAUTION, WARNING, before) == level


def test_clearance_oscillating_at_a_threshold_changes_the_level_once() -> None:
    levels: list[Level] = ["info"]
    for k in range(100):
        clearance = CAUTION * (1.0 + 0.9 * HYSTERESIS * (-1.0) ** k)
        levels.append(level_of(clearance, CAUTION, WARNING, levels[-1]))
    assert sum(one != other for one, other in pairwise(levels)) == 1


@given(st.floats(-1.0, 2.0), st.sampled_from([0.15, 0.3, CAUTION]), st.sampled_from(["info", "caution", "warning"]))
def test_limits_between_which_a_level_remains_are_those_of_the_level(
    clearance: float, warning: float, before: Level
) -> None:
    least, beyond = unchanged_between(before, CAUTION, warning)
    for value in (clearance, least, min(beyond, 1e300)):
        assert (least <= value < beyond) == (level_of(value, CAUTION, warning, before) == before)
