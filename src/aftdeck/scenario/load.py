"""Loading a scenario: a file or a built-in name becomes a `Scenario`, checked once and frozen."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any, NamedTuple

from aftdeck.dimensions import KEY, derive_from, has_formulas
from aftdeck.errors import ScenarioError
from aftdeck.files import Changes, Problem, Text, beside, examine, read, sentences
from aftdeck.scenario.build import build
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import ScenarioFile
from aftdeck.worksite.load import dimensions_of

HERE = Path(__file__).parent / "builtin"


def built_in() -> tuple[str, ...]:
    """Names of the scenarios that come with Aftdeck."""
    return tuple(sorted(path.stem for path in HERE.glob("*.toml")))


class About(NamedTuple):
    """What a built-in scenario's file says of it."""

    title: str
    text: str
    file: str
    """All of the file."""


def about(name: str) -> About:
    """Title and text of a built-in scenario, read without building it, which takes a second or so."""
    file = (HERE / f"{name}.toml").read_text(encoding="utf-8")
    said = tomllib.loads(file)
    return About(said["title"], said["text"], file)


def load_scenario(name_or_path: str | Path) -> Scenario:
    """The scenario of a built-in name or of a file.

    Raises:
        ScenarioError: no such scenario, or everything that is wrong in it, each with its place in the file.
    """
    path = Path(name_or_path)
    if path.suffix != ".toml":
        if str(name_or_path) not in built_in():
            raise ScenarioError(
                [
                    f"no scenario {str(name_or_path)!r}: built in are {', '.join(built_in())}; "
                    "a path to a scenario file ends in .toml"
                ]
            )
        path = HERE / f"{name_or_path}.toml"
    return parse_scenario(read(path).text, path.stem, path.name, path.parent)


def _derived(raw: dict[str, Any], folder: Path, file: Text) -> list[Problem]:
    """Put values in the place of expressions of the worksite's dimensions; return what is wrong.

    Raises:
        ScenarioError: they have no values, since the worksite cannot be read.
    """
    name, own = raw.get("worksite", "orbiter"), raw.get(KEY, {})
    if not has_formulas(raw) or not isinstance(name, str) or not isinstance(own, dict):
        return []
    try:
        return derive_from(dimensions_of(beside(name, folder), own), raw)
    except ScenarioError as error:
        wrong = [Problem(("worksite",), problem) for problem in error.problems]
        raise ScenarioError(sentences(wrong, *file)) from None


def parse_scenario(text: str, name: str, file: str, folder: Path, changes: Changes | None = None) -> Scenario:
    """As `load_scenario`, from text; `file` stands for it in messages, arm files are sought from `folder`.

    `changes` are put in place of what the text says.
    """
    source = Text(file, text)
    spec, wrong = examine(ScenarioFile, source, changes, lambda raw: _derived(raw, folder, source))
    problems = Problems(wrong)
    scenario = None if spec is None else build(problems, spec, name, text, folder)
    if scenario is None or problems:
        raise ScenarioError(problems.sentences(file, text))
    return scenario
