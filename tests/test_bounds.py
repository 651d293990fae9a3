"""Plausible ranges: each number of each file has one with its reason, and what is outside is rejected with its line."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import aftdeck.arms.load
from aftdeck.arms.load import load_model
from aftdeck.arms.shapes import shapes_of
from aftdeck.errors import ScenarioError
from aftdeck.made_tables import renewed
from aftdeck.scenario.load import load_scenario, parse_scenario
from aftdeck.scenario.ranges_document import FILES, Number, numbers, tables
from aftdeck.worksite import load_worksite
from aftdeck.worksite.file import load as worksite_file

ARMS = aftdeck.arms.load.HERE
WORKSITES = Path(worksite_file.__file__).parents[1]
UNBOUNDED = {("ScenarioFile", "mode"), ("Phase", "mode")}
"""Fields with the number or the name of a mode, of which only those that exist are accepted."""


def all_numbers() -> list[Number]:
    known: set[Any] = set()
    return [number for kinds in FILES.values() for kind in kinds for number in numbers(kind, known)]


def test_each_number_of_each_file_has_a_range_and_its_reason() -> None:
    found = all_numbers()
    assert len(found) > 150
    for number in found:
        if (number.struct.__name__, number.field) in UNBOUNDED:
            continue
        bounds = number.range
        assert bounds is not None, f"{number.struct.__name__}.{number.field} has no range"
        assert bounds.least < bounds.greatest and len(bounds.reason) > 10


def test_tables_of_the_ranges_agree_with_the_types() -> None:
    text = (Path(__file__).parents[1] / "docs" / "files.md").read_text(encoding="utf-8")
    assert renewed(text, tables()) == text


def load(kind: str, name: str, old: str, new: str, folder: Path) -> None:
    """Load a built-in file in which one text is replaced."""
    home = {"arm": ARMS, "shapes": ARMS, "worksite": WORKSITES}.get(kind)
    if home is None:
        text = load_scenario(name).text
        assert old in text
        parse_scenario(text.replace(old, new, 1), "changed", "changed.toml", Path("."))
        return
    text = (home / f"{name}.toml").read_text(encoding="utf-8")
    assert old in text
    changed = text.replace(old, new, 1)
    if kind == "worksite":
        (folder / "changed.toml").write_text(changed, encoding="utf-8")
        load_worksite(folder / "changed.toml")
    elif kind == "shapes":
        (folder / f"{name}.toml").write_text(changed, encoding="utf-8")
        (folder / "srms.toml").write_text((ARMS / "srms.toml").read_text(encoding="utf-8"), encoding="utf-8")
        shapes_of(load_model(folder / "srms.toml"))
    else:
        (folder / "changed.toml").write_text(changed.replace('shapes = "', '# "'), encoding="utf-8")
        load_model(folder / "changed.toml")


@pytest.mark.parametrize(
    ("kind", "name", "old", "new", "value", "greatest"),
    [
        ("arm", "srms", '"251.05 in"', '"1e100 in"', "2.54e+98 m", "200 m"),
        ("arm", "srms", '"2.29 deg/s"', '"1e100 deg/s"', "1.74533e+98 rad/s", "10 rad/s"),
        ("arm", "srms", '"-180 deg"', '"-9e7 deg"', "-1.5708e+06 rad", "62.84 rad"),
        ("arm", "concept-1972", "[joint.greatest]\nvalue = ", "[joint.greatest]\nvalue = 1e6 # ", "1e+06 m", "200 m"),
        ("scenario", "tutorial", "duration = ", "duration = 6e7 #", "6e+07 s", "86400 s"),
        ("arm", "srms", "sides = 8", "sides = 1" + "0" * 17, "1e+17", "360"),
    ],
)
def test_implausible_number_is_rejected_with_value_range_reason_and_line(
    kind: str, name: str, old: str, new: str, value: str, greatest: str, tmp_path: Path
) -> None:
    with pytest.raises(ScenarioError) as caught:
        load(kind, name, old, new, tmp_path)
    problem = next(problem for problem in caught.value.problems if "because" in problem)
    assert value in problem and f"to {greatest}, because " in problem
    file, line, _ = problem.split(":", 2)
    assert file.endswith(".toml") and line.isdigit()


@pytest.mark.parametrize(
    ("kind", "name", "old", "new"),
    [
        ("shapes", "srms.shapes", "radius = ", "radius = inf #"),
        ("worksite", "orbiter", "outline = [[", "outline = [[-inf, 0], ["),
        ("arm", "srms", "confidence = ", "confidense = "),
        ("arm", "srms", "sides = 8", "sides = 1" + "0" * 400),
        ("arm", "srms", "sides = 8", "sides = 0x" + "f" * 5000),
        ("arm", "srms", 'title = "', 'title = "\\u001b[2J'),
        ("arm", "srms", 'title = "', 'title = "' + "x" * 100_000),
        ("worksite", "concept-1972", "[dimensions]", "[dimensions]\nhuge = 1" + "0" * 400),
    ],
)
def test_impossible_value_is_rejected_in_readable_sentences(
    kind: str, name: str, old: str, new: str, tmp_path: Path
) -> None:
    with pytest.raises(ScenarioError) as caught:
        load(kind, name, old, new, tmp_path)
    assert all(problem.isprintable() and len(problem) < 4000 for problem in caught.value.problems)


def test_misspelt_key_in_any_constant_is_reported_with_its_line(tmp_path: Path) -> None:
    lines = (ARMS / "srms.toml").read_text(encoding="utf-8").splitlines(keepends=True)
    keys = [i for i, line in enumerate(lines) if line.startswith(("value =", "source =", "confidence ="))]
    for i in keys:
        changed = [*lines[:i], "x" + lines[i], *lines[i + 1 :]]
        (tmp_path / "changed.toml").write_text("".join(changed), encoding="utf-8")
        with pytest.raises(ScenarioError) as caught:
            load_model(tmp_path / "changed.toml")
        assert any(f"changed.toml:{i + 1}: " in problem and "unknown" in problem for problem in caught.value.problems)
