"""Loader of scenarios: reads a built-in scenario or a scenario file into a checked and frozen `Scenario`."""

from __future__ import annotations

import re
import tomllib
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from aftdeck.arms.load import ArmModel, model_of
from aftdeck.dimensions import KEY, derive_from, has_formulas, is_formula
from aftdeck.encodable import encodable
from aftdeck.errors import AftdeckError, InputError, ScenarioError
from aftdeck.files import Changes, Problem, Text, examine, find_toml, read, sentences
from aftdeck.law import interpreted
from aftdeck.scenario.build import BUILT_IN, build
from aftdeck.scenario.changes import GivenChanges, change_text, located, parse_change
from aftdeck.scenario.in_flight import check_key, merged
from aftdeck.scenario.keys import ARM, SCENARIO, SHAPES, WORKSITE, Change, key_at, problem_in
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import ScenarioFile, ScenarioGroup
from aftdeck.scenario.sources import Folder, Sources, apart
from aftdeck.worksite.file.load import dimensions_of


def built_in() -> tuple[str, ...]:
    """Return the names of the scenarios that come with Aftdeck."""
    return tuple(sorted(path.stem for path in BUILT_IN.glob("*.toml")))


class About(NamedTuple):
    """What a list says about a built-in scenario, and the scenario's file."""

    title: str
    text: str
    group: ScenarioGroup
    minutes: int
    next: str | None
    file: str
    """Text of the whole file."""
    scripted: bool
    """Whether the file has a script."""


def about(name: str) -> About:
    """Return what a list says about a built-in scenario.

    The scenario is not built, because building takes a tenth of a second.
    """
    file = (BUILT_IN / f"{name}.toml").read_text(encoding="utf-8")
    table = tomllib.loads(file)
    said = table["title"], table["text"], table["group"], table["minutes"], table.get("next")
    return About(*said, file, scripted="phase" in table)


class Source(NamedTuple):
    """A scenario's text, with its name, file name and folder: the arguments of `parse_scenario`."""

    text: str
    name: str
    file: str
    folder: Path


def find_scenario(name_or_path: str | Path) -> Source:
    """Return the text of a built-in scenario or of a file; the text is not checked.

    Raises:
        ScenarioError: there is no such scenario, or its file cannot be read.
    """
    names = "scenario", "scenarios"
    path = find_toml(name_or_path, BUILT_IN, built_in(), names, lambda text: ScenarioError([text]))
    file = read(path)
    return Source(file.text, encodable(path.stem), file.name, path.parent)


def load_scenario(name_or_path: str | Path, changes: GivenChanges | None = None) -> Scenario:
    """Load a built-in scenario by its name, or a scenario file by its path.

    Args:
        name_or_path: built-in name or path.
        changes: new values, each with the key of the value that it replaces: a text as for ``--set``, such as
            ``phase[0].rate``, or a tuple such as ``("phase", 0, "rate")``.

    Raises:
        InputError: a key is neither a text nor a tuple that names a value.
        ScenarioError: there is no such scenario, or its file has errors; the message lists all errors, with their
            places in the file.
    """
    return parse_scenario(*find_scenario(name_or_path), located(changes or {}))


def _derived(raw: dict[str, Any], sources: Sources, file: Text) -> list[Problem]:
    """Replace each expression in a scenario's raw contents by its value; expressions use the worksite's dimensions.

    Return the problems found.

    Raises:
        ScenarioError: the worksite, which defines the dimensions, cannot be read.
    """
    name, own_dimensions = raw.get("worksite", "orbiter"), raw.get(KEY, {})
    if not has_formulas(raw) or not isinstance(name, str) or not isinstance(own_dimensions, dict):
        return []
    try:
        return derive_from(dimensions_of(sources.worksite(name), own_dimensions), raw)
    except ScenarioError as error:
        problems = [Problem(("worksite",), problem) for problem in error.problems]
        raise ScenarioError(sentences(problems, *file)) from None


def parse_scenario(text: str, name: str, file: str, folder: Path, changes: Changes | None = None) -> Scenario:
    """Build a scenario from text, as `load_scenario` does from a file.

    Args:
        text: text of the scenario file.
        name: name of the scenario.
        file: name of the file, for messages.
        folder: folder for relative paths of the arm's file and the worksite's file.
        changes: new values, each with the place of the value that it replaces.

    Raises:
        ScenarioError: the text has errors; the message lists all of them, with their places in the text.
    """
    return scenario_from(text, name, file, Folder(folder), changes)


def scenario_from(
    text: str, name: str, file: str, sources: Sources, changes: Changes | None = None, begun: Scenario | None = None
) -> Scenario:
    """Build a scenario from text, with an arm and a worksite from `sources`; otherwise like `parse_scenario`.

    Changes of the arm's and the worksite's files, ``arm.…`` and ``worksite.…``, are then in the texts of these files;
    `Scenario.changes` has those of the scenario's own file. `begun`: scenario with which a run has begun that goes on
    with this one.
    """
    source = Text(file, text)
    origin, own = apart(sources, changes or {})
    spec, found = examine(ScenarioFile, source, own, lambda raw: _derived(raw, origin, source))
    problems = Problems(found)
    with interpreted():
        scenario = None if spec is None else build(problems, spec, name, text, _texts(own), origin, begun)
    if scenario is None or problems:
        raise ScenarioError(problems.sentences(file, text))
    if begun is None and scenario.planned_changes:
        _check_planned(scenario, file)
    return scenario


def _check_planned(scenario: Scenario, file: str) -> None:
    """Check that the planned changes in flight are possible, each with those before it.

    Raises:
        ScenarioError: they are not; the message says which and why.
    """
    problems, before = Problems(), tuple[str, ...]()
    for planned in scenario.planned_changes:
        after = merged(before, planned.changes)
        try:
            in_force(scenario, after)
            before = after
        except InputError as error:
            problems.add(("event", planned.number, "set"), str(error))
    if problems:
        raise ScenarioError(problems.sentences(file, scenario.text))


class _Texts(NamedTuple):
    """Arm and worksite of a scenario, as they are."""

    scenario: Scenario

    def arm(self, _: str) -> ArmModel:
        """Return the arm, with its own limits instead of those of the scenario."""
        return model_of(text_of(self.scenario, ARM), lambda _: text_of(self.scenario, SHAPES))

    def worksite(self, _: str) -> Text:
        """Return the worksite's text."""
        return text_of(self.scenario, WORKSITE)


def text_of(scenario: Scenario, kind: str) -> Text:
    """Return the name and the text of one of a scenario's files.

    Raises:
        InputError: the arm has no file of shapes.
    """
    model = scenario.arm.model
    if kind == SHAPES:
        if model.shapes is None:
            raise InputError(f"the arm {model.name!r} has no file of shapes")
        return model.shapes
    names = {SCENARIO: (scenario.name, scenario.text), ARM: (model.name, model.text)}
    name, text = names.get(kind, (scenario.worksite.name, scenario.worksite.text))
    return Text(f"{name}.toml", text)


_PLACES = re.compile(r"[^\s:]+\.toml(:\d+)?: ")
"""Places in files, which say nothing about a value that is in none of them."""


@lru_cache(maxsize=64)
def in_force(scenario: Scenario, changes: tuple[str, ...]) -> Scenario:
    """Return a scenario with changes in flight; the same object for the same changes.

    Args:
        scenario: the scenario with which the run began.
        changes: the changes, each as KEY=VALUE.

    Raises:
        InputError: a key does not exist or cannot change in flight, or the files do not allow its value; the message
            says why.
    """
    if not changes:
        return scenario
    new = dict(map(parse_change, scenario.changes))
    for where, value in map(parse_change, changes):
        key = key_at(where)
        check_key(key)
        if not is_formula(value) and (what := problem_in(text_of(scenario, key.kind), Change(key, value))):
            raise InputError(what)
        new[where] = value
    try:
        return scenario_from(scenario.text, scenario.name, f"{scenario.name}.toml", _Texts(scenario), new, scenario)
    except AftdeckError as error:
        raise InputError(_PLACES.sub("", str(error))) from None


def _texts(changes: Changes) -> tuple[str, ...]:
    """Return changes as texts."""
    return tuple(change_text(where, value) for where, value in changes.items())
