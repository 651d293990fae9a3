"""The direction of imports: a package imports only itself and the packages in its layer or in earlier layers."""

import ast
import importlib
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

import aftdeck

SOURCE = Path(aftdeck.__file__).parent

LAYERS = (
    (
        "arrays",
        "bounds",
        "plain_values",
        "schema_check",
        "tuples",
        "dimensions",
        "unit_sizes",
        "encodable",
        "errors",
        "exact_pickle",
        "extra",
        "files",
        "folders",
        "law_folder",
        "law_digest",
        "law_library",
        "law_link",
        "law_cache",
        "law",
        "law_change",
        "progress_bar",
        "compiled_first",
        "elementary",
        "flat",
        "lent",
        "matrices",
        "quaternions",
        "lines",
        "units",
        "frames",
        "shapes",
        "state_part",
        "field_meta",
        "toml_lines",
        "version",
        "whole_file",
        "new_file",
        "table",
        "made_tables",
        "processes",
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
    ("analysis",),
    ("historical",),
    ("scene",),
    ("details",),
    ("visual",),
    ("mainprior",),
    ("task",),
    ("recording",),
    ("report",),
    ("export",),
    ("operators",),
    ("study",),
    ("station",),
    ("gym",),
    ("cli",),
    ("__init__", "__main__"),
)
"""The layers of ``src/aftdeck``, in order. A layer contains one or more packages (folders or modules)."""

LAYER = {name: rank for rank, names in enumerate(LAYERS) for name in names}

WITHIN: dict[str, tuple[tuple[str, ...], ...]] = {
    "worksite": (
        ("within", "tables", "conditions", "log_line", "free_flight", "body", "payload", "relation"),
        ("watch", "draw_in"),
        ("report",),
        ("berths", "capture"),
        ("model",),
        ("file",),
        ("sliding",),
        ("__init__",),
    ),
    "simulation": (
        ("frame", "camera_drives", "row"),
        ("inputs", "plain", "log", "constants", "parts"),
        ("state",),
        ("frame_poses", "summary"),
        ("payloads",),
        ("readings", "period"),
        ("series",),
        ("motion", "resume"),
        ("operator", "observe"),
        ("begin", "work", "in_flight"),
        ("fly",),
        ("command_check",),
        ("step",),
        ("run", "warm"),
        ("batch",),
        ("survey",),
        ("__init__",),
    ),
    "station": (
        ("built",),
        ("messages",),
        ("conversion",),
        ("playback",),
        ("core",),
        ("session",),
        ("server",),
        ("__init__",),
    ),
}
"""Order within the largest packages. Imports that are needed only for types may violate this order."""


def imports(module: str, text: str) -> Iterator[tuple[int, str]]:
    """Yield (line, full name) of every import from Aftdeck in the source ``text`` of ``module``.

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
    """Return a message for each import in ``text`` that violates the order of LAYERS."""
    package = module.split(".")[1]
    if package not in LAYER:
        return [f"{module} is in no layer: add {package!r} to LAYERS"]
    wrong = []
    for line, name in imports(module, text):
        target = [*name.split("."), "__init__"][1]
        # A name that is not a package comes from aftdeck/__init__.py, which is in the last layer.
        if LAYER.get(target, LAYER["__init__"]) > LAYER[package]:
            wrong.append(f"{module}, line {line}: {package} may not import {name}")
    return wrong


def wrong_within(module: str, text: str) -> list[str]:
    """Return a message for each import in ``text`` that violates the order of WITHIN."""
    package, own = [*module.split("."), "__init__"][1:3]
    rank = {name: rank for rank, names in enumerate(WITHIN.get(package, ())) for name in names}
    if not rank:
        return []
    if own not in rank:
        return [f"{module} has no rank: add {own!r} to WITHIN[{package!r}]"]
    wrong = []
    for line, name in imports(module, without_types(text)):
        inside = name.split(".")[1:3]
        if inside[0] == package and rank.get(inside[1], -1) > rank[own]:
            wrong.append(f"{module}, line {line}: {own} may not import {name}")
    return wrong


def without_types(text: str) -> str:
    """Return the source without the blocks ``if TYPE_CHECKING``."""
    tree = ast.parse(text)
    tree.body = [
        node for node in tree.body if not (isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING")
    ]
    return ast.unparse(tree)


def test_packages_import_only_from_their_own_and_earlier_layers() -> None:
    wrong = []
    for path in sorted(SOURCE.rglob("*.py")):
        module = ".".join(("aftdeck", *path.relative_to(SOURCE).with_suffix("").parts))
        text = path.read_text(encoding="utf-8")
        wrong += [*wrong_imports(module, text), *wrong_within(module, text)]
    assert not wrong, "\n".join(wrong)


def test_only_the_package_arms_knows_the_tables_of_arm_files() -> None:
    """Other packages read an `ArmModel`; ranges and keys of studies need the type of the whole file."""
    tables = {"aftdeck.arms.joints", "aftdeck.arms.link_file", "aftdeck.arms.model"}
    structs = {
        name for module in tables for name, kind in vars(importlib.import_module(module)).items()
        if isinstance(kind, type) and issubclass(kind, msgspec.Struct) and kind.__module__ == module
    }  # fmt: skip
    used = {
        (str(path.relative_to(SOURCE)), node.name)
        for path in SOURCE.rglob("*.py")
        if path.relative_to(SOURCE).parts[0] != "arms"
        for statement in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(statement, ast.ImportFrom) and statement.module in tables
        for node in statement.names
        if node.name in structs
    }
    assert used == {("scenario/ranges_document.py", "ArmFile"), ("scenario/keys.py", "ArmFile")}


@pytest.mark.parametrize(
    ("module", "text"),
    [
        pytest.param("aftdeck.kinematics.law", "import aftdeck.station.server.app", id="import from a later layer"),
        pytest.param("aftdeck.kinematics.law", "from aftdeck.steering import modes", id="'from' a later layer"),
        pytest.param("aftdeck.kinematics.law", "from aftdeck import station", id="later package by name"),
        pytest.param("aftdeck.kinematics.law", "from ..plant import kinematic", id="relative"),
        pytest.param("aftdeck.plant.__init__", "from ..scenario import load", id="relative, in a package"),
        pytest.param("aftdeck.arms.load", "from aftdeck import load_arm", id="the package's own names"),
        pytest.param("aftdeck.arms.load", "import aftdeck", id="the package itself"),
        pytest.param("aftdeck.units", "def f():\n    from aftdeck.arms import model", id="inside a function"),
        pytest.param("aftdeck.cellar.rats", "", id="a folder that is in no layer"),
    ],
)
def test_import_against_the_order_is_found(module: str, text: str) -> None:
    assert len(wrong_imports(module, text)) == 1


@pytest.mark.parametrize(
    ("module", "text"),
    [
        pytest.param("aftdeck.simulation.state", "from aftdeck.simulation.payloads import grasp", id="a later folder"),
        pytest.param("aftdeck.simulation.payloads.grasp", "import aftdeck.simulation.step", id="a later module"),
        pytest.param("aftdeck.station.cellar", "", id="a module without a rank"),
    ],
)
def test_import_against_the_order_within_a_package_is_found(module: str, text: str) -> None:
    assert len(wrong_within(module, text)) == 1


@pytest.mark.parametrize(
    ("module", "text"),
    [
        pytest.param("aftdeck.station.server.app", "from aftdeck.simulation.step import step", id="earlier layer"),
        pytest.param("aftdeck.station.server.app", "from .session import Session", id="own package"),
        pytest.param("aftdeck.station.server.app", "from .. import errors", id="relative, earlier layer"),
        pytest.param("aftdeck.frames", "from aftdeck.units import parse", id="shared vocabulary"),
        pytest.param("aftdeck.units", "import pint\nfrom numpy import pi", id="other packages"),
        pytest.param("aftdeck.__init__", "from aftdeck.arms import load_arm", id="the package's own file"),
    ],
)
def test_import_along_the_order_is_accepted(module: str, text: str) -> None:
    assert wrong_imports(module, text) == []


def test_every_public_name_exists() -> None:
    missing = [name for name in aftdeck.__all__ if not hasattr(aftdeck, name)]
    assert not missing, f"aftdeck.__all__ names {missing}, which aftdeck does not have"
