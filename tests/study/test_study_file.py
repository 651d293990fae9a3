"""Wrong study files: each error is reported with its line."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from aftdeck.errors import ScenarioError
from aftdeck.scenario import keys
from aftdeck.schema_check import problems_of
from aftdeck.study.file import built_in, load_study
from tests.study import studies
from tests.study.studies import SHORT, loaded

HEAD = 'title = "A"\nscenario = "short.toml"\n'
FACTOR = "[[factor]]\n"


@pytest.mark.parametrize(
    ("text", "line", "named"),
    [
        pytest.param('title = "A"\nscenario = "none"\n', 2, "first-flight", id="no such scenario"),
        pytest.param('title = "A"\nscenario = "none.toml"\n', 2, "none.toml", id="no such file"),
        pytest.param(HEAD + 'design = "cube"\n', 3, "sobol", id="no such design"),
        pytest.param(
            HEAD + 'design = "latin"\n' + FACTOR + 'key = "rate"\nlevels = ["coarse"]\n',
            3,
            "runs",
            id="design without runs",
        ),
        pytest.param(HEAD + "runs = 5\n", 3, "repeats", id="grid with runs"),
        pytest.param(HEAD + "seeds = [1, 1]\n", 3, "twice", id="seed twice"),
        pytest.param(HEAD + "repeats = 2\nseeds = [1, 2]\n", 4, "repeats", id="seeds and repeats"),
        pytest.param(
            HEAD + "repeats = 1000000\n" + FACTOR + 'key = "rate"\nlevels = ["coarse", "vernier"]',
            0,
            "cases",
            id="too many cases",
        ),
        pytest.param(HEAD + 'metrics = ["run_time_s", "speed"]\n', 3, "tip_path_m", id="no such metric"),
        pytest.param(HEAD + "hurry = true\n", 3, "limit", id="unknown field"),
        pytest.param(HEAD + 'limit = "5 m"\n', 3, "s", id="wrong unit"),
        pytest.param(HEAD + '[operator]\nkind = "robot"\n', 4, "perfect", id="no such operator"),
        pytest.param(HEAD + '[operator]\ngain = "high"\n', 4, "gain", id="wrong gain"),
        pytest.param(HEAD + "[success]\nat_most = { speed = 1 }\n", 4, "collisions", id="no such bound"),
        pytest.param(HEAD + '[report]\nresponses = ["controllers"]\n', 4, "run_time_s", id="response is a text"),
        pytest.param(
            HEAD + 'metrics = ["collisions"]\n[report]\nresponses = ["run_time_s"]\n',
            5,
            "metrics",
            id="response is not kept",
        ),
        pytest.param(HEAD + FACTOR + 'key = "rate"\n', 3, "levels", id="no levels"),
        pytest.param(HEAD + FACTOR + "levels = [1, 2]\n", 3, "key", id="no key"),
        pytest.param(
            HEAD + FACTOR + 'key = "rate"\nlevels = ["coarse"]\nlow = 1\nhigh = 2\n',
            3,
            "levels",
            id="levels and a range",
        ),
        pytest.param(HEAD + FACTOR + 'key = "ra te"\nlevels = ["coarse"]\n', 4, "phase[0].rate", id="not a key"),
        pytest.param(HEAD + FACTOR + 'key = "pace"\nlevels = [1, 2]\n', 5, "rate", id="unknown key"),
        pytest.param(HEAD + FACTOR + 'key = "rate"\nlevels = ["coarse", "fast"]\n', 5, "vernier", id="wrong level"),
        pytest.param(HEAD + FACTOR + 'key = "phase[7].rate"\nlevels = ["coarse"]\n', 5, "1", id="no such item"),
        pytest.param(
            HEAD + FACTOR + 'key = "control_period"\nlow = 0.01\nhigh = 7.0\n', 6, "0.2", id="range beyond the bounds"
        ),
        pytest.param(HEAD + FACTOR + 'key = "arm"\nlevels = ["srms", "canada"]\n', 5, "concept-1972", id="no such arm"),
        pytest.param(
            HEAD + FACTOR + 'key = "arm.joint[0].step"\nlevels = [7.0]\n',
            5,
            "step",
            id="arm key of the wrong kind",
        ),
        pytest.param(
            HEAD + FACTOR + 'key = "worksite.dimension"\nlevels = [7.0]\n',
            5,
            "dimensions",
            id="unknown key of the worksite",
        ),
        pytest.param(
            HEAD + FACTOR + 'key = "operator.pace"\nlevels = [7.0]\n', 5, "gain", id="unknown key of the operator"
        ),
        pytest.param(HEAD + FACTOR + 'key = "monitors.mon_3"\nlevels = ["A"]\n', 5, "mon_1", id="no such monitor"),
        pytest.param(
            HEAD + FACTOR + 'name = "seed"\nkey = "rate"\nlevels = ["coarse"]\n', 3, "seed", id="column exists"
        ),
        pytest.param(
            HEAD + FACTOR + '[[factor.level]]\nname = "x"\nset = { rate = "coarse" }\n',
            3,
            "name",
            id="levels without a name of the factor",
        ),
        pytest.param(
            HEAD + FACTOR + 'name = "f"\n[[factor.level]]\nname = "x"\nset = { rate = "fast" }\n',
            5,
            "vernier",
            id="wrong value in a named level",
        ),
        pytest.param(
            HEAD + 'design = "latin"\nruns = 4\n' + FACTOR + 'key = "command_delay"\nlow = 0\nhigh = 1\ncount = 3\n',
            9,
            "grid",
            id="count without a grid",
        ),
    ],
)
def test_error_has_its_line_and_what_is_allowed(tmp_path: Path, text: str, line: int, named: str) -> None:
    with pytest.raises(ScenarioError) as error:
        loaded(tmp_path, text)
    (problem,) = error.value.problems
    place = problem.partition(": ")[0]
    assert place == (f"study.toml:{line}" if line else "study.toml")
    assert named in problem.partition(": ")[2]


def test_all_errors_are_reported_together(tmp_path: Path) -> None:
    text = HEAD + "runs = 5\nmetrics = ['pace']\n" + FACTOR + 'key = "rate"\n'
    with pytest.raises(ScenarioError) as error:
        loaded(tmp_path, text)
    assert len(error.value.problems) == 3


def test_check_of_a_level_does_not_read_the_rest_of_the_scenario(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    phases = "".join(f'[[phase]]\nmode = "ORB UNL"\ntranslation = [0.{i}, 0, 0]\nduration = "1 s"\n' for i in range(9))
    monkeypatch.setattr(studies, "SHORT", SHORT + phases)
    parsed: list[str] = []
    checked: list[int] = []
    plain = tomllib.loads

    def loads(text: str) -> dict[str, Any]:
        parsed.append(text)
        return plain(text)

    def problems(raw: dict[str, Any], kind: object) -> list[Any]:
        checked.append(len(raw["phase"]))
        return problems_of(raw, kind)

    monkeypatch.setattr(tomllib, "loads", loads)
    monkeypatch.setattr(keys, "problems_of", problems)
    levels = ", ".join(f'"{k} s"' for k in range(1, 41))
    study = loaded(tmp_path, HEAD + FACTOR + f'key = "phase[7].duration"\nlevels = [{levels}]\n')
    assert len(study.factors[0].levels) == 40
    assert checked == [1] * 40
    assert len(parsed) < 10


@pytest.mark.parametrize(
    ("key", "level", "named"),
    [
        ("phase[0].duration", '"x"', "phase[0].duration: 'x' is not a time"),
        ("phase[0].mode.x", "1", "phase[0].mode is not a table"),
        ("phase[1].mode", '"OPR CMD"', "there is no item 1"),
        ("phase", "3", "phase: Expected `array`"),
        ("initial.joints[6]", "1", "there is no item 6"),
        ("initial.joints[5]", '"1 s"', "initial.joints[5]: "),
        ("initial.pose.frame", "3", "initial.pose.frame: "),
        ("command_delay", '"\\u202e"', "control character"),
    ],
)
def test_wrong_place_or_value_of_a_key_is_named(tmp_path: Path, key: str, level: str, named: str) -> None:
    with pytest.raises(ScenarioError) as error:
        loaded(tmp_path, HEAD + FACTOR + f'key = "{key}"\nlevels = [{level}]\n')
    (problem,) = error.value.problems
    assert named in problem


def test_unknown_name_lists_the_built_in_studies() -> None:
    with pytest.raises(ScenarioError) as error:
        load_study("nothing")
    assert all(name in str(error.value) for name in built_in())
