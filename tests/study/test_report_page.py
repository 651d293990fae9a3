"""Report page of a study, and its statistics."""

from __future__ import annotations

import math
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.report.intervals import mean_interval, wilson
from aftdeck.report.table import Row
from aftdeck.study.case import Runner
from aftdeck.study.design import cases
from aftdeck.study.figures import response_chart
from aftdeck.study.plan import plan_of
from aftdeck.study.report import page
from aftdeck.study.statistics import effect, groups
from tests.study.studies import FOUR, loaded

DRAWN = """
title = "<Drawn> & listed"
scenario = "short.toml"
design = "latin"
runs = 24

[[factor]]
name = "speed"
key = "limits.por.translation"
low = "1 ft/s"
high = "2 ft/s"

[[factor]]
key = "rate"
levels = ["coarse", "vernier"]

[report]
responses = ["tip_path_m", "run_time_s"]
recordings = 3
"""


@given(st.integers(1, 10_000), st.data())
def test_interval_of_a_rate_contains_the_rate(count: int, data: st.DataObject) -> None:
    successes = data.draw(st.integers(0, count))
    found, other = wilson(successes, count), wilson(count - successes, count)
    assert 0.0 <= found.low <= found.value <= found.high <= 1.0
    assert math.isclose(found.low, 1.0 - other.high, abs_tol=1e-12)


def test_interval_of_a_rate_solves_the_equation_of_the_score_test() -> None:
    for successes, count in ((1, 10), (7, 9), (50, 200)):
        found = wilson(successes, count)
        for end in (found.low, found.high):
            z = (found.value - end) / math.sqrt(end * (1.0 - end) / count)
            assert abs(z) == pytest.approx(1.959963984540054)


def test_interval_of_a_mean_narrows_with_more_values() -> None:
    widths = [interval.high - interval.low for interval in (mean_interval([1.0, 2.0] * n) for n in (1, 2, 10, 100))]
    assert widths == sorted(widths, reverse=True)


def test_effect_explains_all_variance_of_a_response_that_follows_the_factor(tmp_path: Path) -> None:
    study = loaded(tmp_path, FOUR)
    factor = study.factors[0]
    rows: list[Row] = [{"speed_ft_s": x, "tip_path_m": 3.0 * x, "success": True} for x in (1.0, 2.0, 1.0, 2.0)]
    found = effect(factor, rows, "tip_path_m")
    assert found is not None and found.share == pytest.approx(1.0)
    assert (found.least[1], found.greatest[1]) == (3.0, 6.0)
    other: list[Row] = [{**row, "tip_path_m": float(i // 2)} for i, row in enumerate(rows)]
    none = effect(factor, other, "tip_path_m")
    assert none is not None and none.share == pytest.approx(0.0)


def test_drawn_values_are_grouped_without_loss(tmp_path: Path) -> None:
    study = loaded(tmp_path, DRAWN)
    rows: list[Row] = [{"index": case.index, "speed_ft_s": case.cells[0]} for case in cases(study)]
    found = groups(study.factors[0], rows)
    assert sorted(int(str(row["index"])) for group in found for row in group.rows) == list(range(24))
    assert max(len(group.rows) for group in found) - min(len(group.rows) for group in found) <= 1


def test_page_shows_every_part_and_requests_nothing(tmp_path: Path) -> None:
    study = loaded(tmp_path, DRAWN)
    runner = Runner(plan_of(study))
    rows = [runner.run(case).row for case in cases(study)[:8]]
    rows.append({**rows[0], "index": 8, "error": "SimulationError: <no> result", "success": False})
    made = page(study, rows, tmp_path)
    assert made == page(study, rows, tmp_path)
    for part in ("Success", "Tip path", "Main effects", "Worst cases", "Errors", "Study file"):
        assert part in made
    assert "<Drawn>" not in made and "<no>" not in made
    charts = re.findall(r"<svg.*?</svg>", made, flags=re.DOTALL)
    assert len(charts) == 2 + 2 * 3
    for chart in charts:
        ElementTree.fromstring(chart)
    outside = re.findall(r"""(?:src|href|url\()\s*=?\s*["']?(https?:|//)[^"'>]*""", made)
    assert not outside
    assert "<script" not in made and "@import" not in made


def test_chart_leaves_out_a_level_without_a_case(tmp_path: Path) -> None:
    factor = loaded(tmp_path, FOUR).factors[0]
    assert [level.cell for level in factor.levels] == [1.0, 2.0]
    rows: list[Row] = [{"speed_ft_s": 2.0, "tip_path_m": x, "success": True} for x in (3.0, 4.0)]
    labels = re.findall(r">([^<>]*)</text>", response_chart(factor, rows, "tip_path_m").svg)
    assert "2" in labels and "1" not in labels


def test_page_of_a_study_without_factors_or_results_is_written(tmp_path: Path) -> None:
    study = loaded(tmp_path, 'title = "A"\nscenario = "short.toml"\n')
    assert "<h1>A</h1>" in page(study, [], tmp_path)
    row = Runner(plan_of(study)).run(cases(study)[0]).row
    assert "Worst cases" in page(study, [row], tmp_path)
