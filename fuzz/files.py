"""Attack on the loaders of files: each mutant of a built-in file is loaded, or rejected with readable problems."""

from __future__ import annotations

import functools
import random
import tempfile
import unicodedata
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import aftdeck.arms.load
import aftdeck.scenario.build
import aftdeck.scenario.light
import aftdeck.scenario.load
import aftdeck.worksite.file.load
from aftdeck.arms.load import ArmModel
from aftdeck.arms.shapes import shapes_of
from aftdeck.errors import ScenarioError
from aftdeck.files import Text, parse
from aftdeck.scenario.light import LightFile
from fuzz.mutants import mutant

LONGEST_PROBLEM = 4_000
"""Greatest length of one problem's sentence [characters]."""
_ARMS = aftdeck.arms.load.HERE
_WORKSITES = Path(aftdeck.worksite.file.load.__file__).parents[1]
_SCENARIOS = aftdeck.scenario.build.BUILT_IN
_LIGHT = Path(aftdeck.scenario.light.__file__).parent / "light.toml"


class Original(NamedTuple):
    """Built-in file whose mutants are loaded.

    Attributes:
        kind: arm, shapes, worksite, light or scenario.
        path: the file.
        load: function that loads a changed text of the file.
    """

    kind: str
    path: Path
    load: Callable[[str], object]


@functools.cache
def originals() -> tuple[Original, ...]:
    """Return the built-in files of every kind."""
    arms = aftdeck.arms.load.built_in()
    shapes = tuple(name for name in arms if (_ARMS / f"{name}.shapes.toml").exists())
    worksites = aftdeck.worksite.file.load.worksites()
    scenarios = aftdeck.scenario.load.built_in()
    return (
        *(Original("arm", _ARMS / f"{name}.toml", functools.partial(load_arm, name)) for name in arms),
        *(Original("shapes", _ARMS / f"{name}.shapes.toml", functools.partial(_shapes, name)) for name in shapes),
        *(Original("worksite", _WORKSITES / f"{name}.toml", load_worksite) for name in worksites),
        Original("light", _LIGHT, lambda text: parse(LightFile, Text("light.toml", text))),
        *(Original("scenario", _SCENARIOS / f"{name}.toml", load_scenario) for name in scenarios),
    )


def attack(seed: int) -> str:
    """Load a mutant of a built-in file; return whether it was accepted or rejected.

    Raises:
        Exception: the loader raised something other than a `ScenarioError`.
        AssertionError: a problem is not one readable line.
    """
    rng = random.Random(seed)
    kinds = sorted({original.kind for original in originals()})
    kind = rng.choice(kinds)
    original = rng.choice([original for original in originals() if original.kind == kind])
    try:
        original.load(mutant(text_of(original.path), rng))
    except ScenarioError as error:
        check_problems(error)
        return f"{kind} rejected"
    return f"{kind} accepted"


def check_problems(error: ScenarioError) -> None:
    """Assert that an error has problems, and that each problem is one readable line."""
    assert error.problems, "the error lists no problem"
    for problem in error.problems:
        assert len(problem) <= LONGEST_PROBLEM, f"the problem has {len(problem)} characters: {problem[:200]!r}"
        hidden = [sign for sign in problem if unicodedata.category(sign) in ("Cc", "Cf")]
        assert not hidden, f"the problem contains {hidden}: {problem!r}"


@functools.cache
def text_of(path: Path) -> str:
    """Return the text of a file."""
    return path.read_text(encoding="utf-8")


def load_arm(name: str, text: str) -> object:
    """Load an arm and its shapes from a changed text of the built-in arm `name`."""
    return _with_shapes(name, arm=text)


def _shapes(name: str, text: str) -> object:
    return _with_shapes(name, shapes=text)


def _with_shapes(name: str, arm: str | None = None, shapes: str | None = None) -> object:
    """Load an arm and its shapes from changed texts of the built-in arm `name`."""
    with tempfile.TemporaryDirectory() as folder:
        own = _ARMS / f"{name}.shapes.toml"
        if shapes is not None or own.exists():
            written(Path(folder) / own.name, text_of(own) if shapes is None else shapes)
        model: ArmModel = aftdeck.arms.load.load_model(
            written(Path(folder) / "mutant.toml", text_of(_ARMS / f"{name}.toml") if arm is None else arm)
        )
        return model, shapes_of(model)


def load_worksite(text: str) -> object:
    """Load a worksite from a text."""
    with tempfile.TemporaryDirectory() as folder:
        return aftdeck.worksite.file.load.load_worksite(written(Path(folder) / "mutant.toml", text))


def load_scenario(text: str) -> object:
    """Load a scenario from a text."""
    return aftdeck.scenario.load.parse_scenario(text, "mutant", "mutant.toml", _SCENARIOS)


def written(path: Path, text: str) -> Path:
    """Write a text to a file and return the file's path."""
    path.write_text(text, encoding="utf-8", newline="")
    return path
