"""The direction of imports: a room uses itself and the rooms before it in ROOMS, nothing else of Aftdeck."""

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import get_args

import pytest

import aftdeck
from aftdeck.arms.model import ArmFile

SOURCE = Path(aftdeck.__file__).parent

ROOMS = (
    (
        "arrays",
        "dimensions",
        "errors",
        "files",
        "law",
        "lines",
        "units",
        "frames",
        "shapes",
        "state_part",
        "told",
        "toml_lines",
        "version",
    ),
    ("bodies",),
    ("arms",),
    ("kinematics",),
    ("steering",),
    ("jsc12628",),
    ("plant",),
    ("worksite",),
    ("scenario",),
    ("simulation",),
    ("scene",),
    ("recording",),
    ("station",),
    ("cli",),
    ("__init__", "__main__"),
)
"""The rooms, each a folder or a module of ``src/aftdeck`` (or several that share a place), in their order."""

PLACE = {name: place for place, names in enumerate(ROOMS) for name in names}


def imports(module: str, text: str) -> Iterator[tuple[int, str]]:
    """Yields (line, full name) of everything of Aftdeck that the source ``text`` of ``module`` imports.

    ``module`` is a dotted name; a package's own file is ``package.__init__``. Imports inside functions count.
    """
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            above = module.split(".")[: -node.level] if node.level else []
            origin = ".".join([*above, *([node.module] if node.module else [])])
            names = [f"{origin}.{alias.name}" for alias in node.names]
        else:
            continue
        yield from ((node.lineno, name) for name in names if name.split(".")[0] == "aftdeck")


def wrong_imports(module: str, text: str) -> list[str]:
    """Returns a sentence for each import in ``text`` that goes against the order of ROOMS."""
    room = module.split(".")[1]
    if room not in PLACE:
        return [f"{module} stands in no room: add {room!r} to ROOMS"]
    wrong = []
    for line, name in imports(module, text):
        target = [*name.split("."), "__init__"][1]
        # What is no room is a name taken from the package itself, which stands after all rooms.
        if PLACE.get(target, PLACE["__init__"]) > PLACE[room]:
            wrong.append(f"{module}, line {line}: {room} may not import {name}")
    return wrong


def test_rooms_import_only_themselves_and_the_rooms_before_them() -> None:
    wrong = []
    for path in sorted(SOURCE.rglob("*.py")):
        module = ".".join(("aftdeck", *path.relative_to(SOURCE).with_suffix("").parts))
        wrong += wrong_imports(module, path.read_text(encoding="utf-8"))
    assert not wrong, "\n".join(wrong)


def test_no_room_but_that_of_the_arms_knows_a_family_of_arms() -> None:
    families = {family.__name__ for family in get_args(ArmFile)}
    known = {
        path.relative_to(SOURCE).parts[0]
        for path in SOURCE.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if (isinstance(node, ast.alias) and node.name.split(".")[-1] in families)
        or (isinstance(node, ast.Attribute) and node.attr in {*families, "family"})
    }
    assert known == {"arms"}


@pytest.mark.parametrize(
    ("module", "text"),
    [
        pytest.param("aftdeck.kinematics.law", "import aftdeck.station.app", id="import of a later room"),
        pytest.param("aftdeck.kinematics.law", "from aftdeck.steering import modes", id="from a later room"),
        pytest.param("aftdeck.kinematics.law", "from aftdeck import station", id="later room by name"),
        pytest.param("aftdeck.kinematics.law", "from ..plant import kinematic", id="relative"),
        pytest.param("aftdeck.plant.__init__", "from ..scenario import load", id="relative, in a package"),
        pytest.param("aftdeck.arms.load", "from aftdeck import load_arm", id="the package's own names"),
        pytest.param("aftdeck.arms.load", "import aftdeck", id="the package itself"),
        pytest.param("aftdeck.units", "def f():\n    from aftdeck.arms import model", id="inside a function"),
        pytest.param("aftdeck.cellar.rats", "", id="a folder that is no room"),
    ],
)
def test_an_import_against_the_order_is_found(module: str, text: str) -> None:
    assert len(wrong_imports(module, text)) == 1


@pytest.mark.parametrize(
    ("module", "text"),
    [
        pytest.param("aftdeck.station.app", "from aftdeck.simulation.step import step", id="earlier room"),
        pytest.param("aftdeck.station.app", "from .session import Session", id="own room"),
        pytest.param("aftdeck.station.app", "from .. import errors", id="relative, earlier room"),
        pytest.param("aftdeck.frames", "from aftdeck.units import parse", id="shared vocabulary"),
        pytest.param("aftdeck.units", "import pint\nfrom numpy import pi", id="other packages"),
        pytest.param("aftdeck.__init__", "from aftdeck.arms import load_arm", id="the package's own file"),
    ],
)
def test_an_import_along_the_order_is_let_through(module: str, text: str) -> None:
    assert wrong_imports(module, text) == []


def test_every_public_name_exists() -> None:
    missing = [name for name in aftdeck.__all__ if not hasattr(aftdeck, name)]
    assert not missing, f"aftdeck.__all__ names {missing}, which aftdeck does not have"
