"""Random scenario files load, or raise ScenarioError with problems."""

from __future__ import annotations

import datetime
import math
from pathlib import Path
from typing import Any

import tomlkit
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck.errors import ScenarioError
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario

PROVE = settings(derandomize=True, deadline=None, max_examples=100, database=None)

numbers = st.one_of(
    st.integers(-3, 10),
    st.integers(-(10**25), 10**25),
    st.floats(allow_nan=True, allow_infinity=True),
    st.floats(-2.0, 2.0),
    st.sampled_from([0, 1, -1, 0.02, 1e300, -1e-300, math.nan, math.inf]),
)
texts = st.one_of(
    st.text(st.characters(exclude_categories=["Cs", "Cc"]), max_size=8),
    st.sampled_from(["2 ft/s", "20 deg", "1 in", "20 ms", "srms", "OPR CMD", "SINGLE", "wrist_yaw", "panel", "x.toml"]),
)
leaves = st.one_of(numbers, texts, st.booleans(), st.just(datetime.date(2020, 1, 1)))
sixes = st.lists(numbers, min_size=5, max_size=7)
matrices = st.lists(st.lists(numbers, min_size=3, max_size=3), min_size=3, max_size=3)
values: st.SearchStrategy[Any] = st.one_of(
    leaves, sixes, matrices, st.lists(leaves, max_size=4), st.dictionaries(texts, leaves, max_size=3)
)


def table(**fields: st.SearchStrategy[Any]) -> st.SearchStrategy[dict[str, Any]]:
    """Return a strategy for some of the fields, each with a valid or a random value."""
    return st.fixed_dictionaries({}, optional={name: st.one_of(good, values) for name, good in fields.items()})


poses = table(
    joints=sixes, position=st.lists(numbers, min_size=3, max_size=3), frame=texts, roll=numbers, matrix=matrices
)
phases = table(
    mode=st.sampled_from([2, 4, 5, 8]),
    rate=st.just("vernier"),
    translation=st.lists(st.floats(-1, 1), min_size=3, max_size=3),
    joint=st.just("wrist_yaw"),
    drive=st.floats(-1, 1),
    joint_at=numbers,
    target=poses,
    duration=numbers,
)
files = table(
    title=texts,
    initial=table(joints=sixes, rates=sixes, pose=poses, near=sixes),
    arm=st.just("srms"),
    worksite=st.just("orbiter"),
    seed=numbers,
    duration=numbers,
    control_period=numbers,
    mode=st.sampled_from([2, 4, 5, 8]),
    strict=st.booleans(),
    limits=table(hard=st.lists(st.lists(numbers, min_size=2, max_size=2), min_size=6, max_size=6), servo=sixes,
                 por=table(translation=numbers, reached_in=numbers)),
    payload=table(mass=numbers, position=st.lists(numbers, min_size=3, max_size=3), matrix=matrices, roll=numbers),
    phase=st.lists(phases, max_size=2),
)  # fmt: skip


def loads(text: str) -> None:
    try:
        assert isinstance(parse_scenario(text, "f", "f.toml", Path("/nowhere")), Scenario)
    except ScenarioError as error:
        assert error.problems and all(problem.startswith("f.toml") for problem in error.problems)


@PROVE
@given(files)
def test_random_values_load_or_raise_scenario_error(file: dict[str, Any]) -> None:
    loads(tomlkit.dumps(file))


@settings(PROVE, max_examples=40)
@given(files)
def test_random_values_with_a_valid_start_load_or_raise_scenario_error(file: dict[str, Any]) -> None:
    good = {"title": "t", "initial": {"joints": [0, 1, -1, 0, 0, 0]}, "duration": 600, "control_period": 0.02}
    loads(tomlkit.dumps({**file, **good}))


@PROVE
@given(st.text(max_size=200))
def test_random_text_loads_or_raises_scenario_error(text: str) -> None:
    loads(text)
    loads('title = "t"\n[initial]\njoints = [0, 1, -1, 0, 0, 0]\n' + text)
