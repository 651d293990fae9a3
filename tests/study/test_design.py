"""Cases of a study."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest

from aftdeck.study.design import cases
from tests.study.studies import loaded

HEAD = 'title = "A"\nscenario = "short.toml"\n'
GRID = """
[[factor]]
key = "rate"
levels = ["coarse", "vernier"]

[[factor]]
name = "speed"
key = "limits.por.translation"
low = "1 ft/s"
high = "2 ft/s"
count = 3
"""
DRAWN = """
[[factor]]
name = "delay"
key = "telemetry_delay"
distribution = "normal"
mean = 1.0
deviation = 0.1
"""
RATES = """
[[factor]]
key = "limits.por.translation"
low = 0.1
high = 0.6

[[factor]]
key = "rate"
levels = ["coarse", "vernier"]
"""


def test_grid_has_each_combination_once_for_each_seed(tmp_path: Path) -> None:
    found = cases(loaded(tmp_path, f"{HEAD}seeds = [3, 5]\n{GRID}"))
    assert [case.index for case in found] == list(range(12))
    assert [(*case.cells, case.seed) for case in found] == list(product(("coarse", "vernier"), (1.0, 1.5, 2.0), (3, 5)))


def test_study_without_factors_repeats_the_scenario(tmp_path: Path) -> None:
    found = cases(loaded(tmp_path, f"{HEAD}repeats = 3\nseed = 7\n"))
    assert [(case.seed, case.cells, case.changes) for case in found] == [(7, (), ()), (8, (), ()), (9, (), ())]


def test_value_of_a_change_has_the_unit_of_the_file(tmp_path: Path) -> None:
    found = cases(loaded(tmp_path, HEAD + GRID))
    assert {change.value for case in found for change in case.changes} == {
        "coarse",
        "vernier",
        "1.0 ft/s",
        "1.5 ft/s",
        "2.0 ft/s",
    }


def test_points_of_a_grid_share_their_draws(tmp_path: Path) -> None:
    study = loaded(tmp_path, f"{HEAD}repeats = 5\n{GRID}{DRAWN}")
    draws: dict[tuple[object, ...], list[object]] = {}
    for case in cases(study):
        draws.setdefault(case.cells[:2], []).append(case.cells[2])
    first, *others = draws.values()
    assert len(set(first)) == 5
    assert all(other == first for other in others)


@pytest.mark.parametrize("design", ["latin", "sobol"])
def test_points_fill_the_range_evenly(tmp_path: Path, design: str) -> None:
    found = cases(loaded(tmp_path, f'{HEAD}design = "{design}"\nruns = 16\n{RATES}'))
    shares = sorted((float(str(case.cells[0])) - 0.1) / 0.5 for case in found)
    assert all(i / 16 - 1e-9 <= share <= (i + 1) / 16 + 1e-9 for i, share in enumerate(shares))
    assert sum(case.cells[1] == "coarse" for case in found) == 8


@pytest.mark.parametrize("design", ["latin", "sobol"])
def test_design_depends_on_the_file_alone(tmp_path: Path, design: str) -> None:
    text = f'{HEAD}design = "{design}"\nruns = 6\nrepeats = 2\n{RATES}'
    first, again = cases(loaded(tmp_path, text)), cases(loaded(tmp_path, text))
    other = cases(loaded(tmp_path, text.replace("runs", "seed = 1\nruns")))
    assert first == again
    assert [case.cells for case in first] != [case.cells for case in other]
    assert [case.cells for case in first[::2]] == [case.cells for case in first[1::2]]
