"""No source on which a frame depends uses a function whose last digits differ between machines or versions."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import aftdeck
from tests.each import each
from tests.test_imports import LAYER, LAYERS

SOURCE = Path(aftdeck.__file__).parent
LAST = LAYER["scene"]
"""Layer of the scene, whose shapes and poses a recording contains. Frames depend on layers before it."""

INEXACT = {
    "math": {"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "hypot", "dist", "exp", "log", "pow", "sumprod"},
    "np": {"sin", "cos", "tan", "arcsin", "arccos", "arctan", "arctan2", "hypot", "exp", "log", "power", "linalg"}
    | {"dot", "vdot", "inner", "matmul", "einsum", "tensordot"},
}
"""Functions of Python and NumPy that come from libraries; `elementary.py` and `matrices.py` replace them."""

EXEMPT = {
    "analysis": "linear models for callers; no frame depends on it",
    "arms/check.py": "decides whether a file is accepted",
    "arms/links.py": "only plants with masses depend on it",
    "arms/joint_check.py": "decides whether a file is accepted",
    "arms/masses.py": "only plants with masses depend on it",
    "arms/old_masses.py": "only plants with masses depend on it",
    "arms/rank.py": "a count, and a number of two digits",
    "bodies/hexahedron_check.py": "decides whether a solid is accepted",
    "bodies/mass_properties.py": "only plants with masses depend on it",
    "bodies/overlap.py": "decides whether a start is accepted",
    "historical": "formats of the reports; no frame depends on them",
    "jsc12628": "interface for callers; no frame depends on it",
    "plant/multibody": "MuJoCo's results are the same on one machine only",
    "scenario/fit.py": "decides whether a scenario is accepted",
    "scenario/poses.py": "decides whether a rotation is accepted",
    "simulation/constants/multibody.py": "makes the models of MuJoCo",
    "simulation/inputs.py": "decides whether a target is accepted",
    "simulation/readings": "what is shown of a frame; no frame depends on it",
    "simulation/survey": "prints cautions; no frame depends on it",
    "shapes.py": "its only sum counts shapes",
    "worksite/file/check.py": "decides whether a file is accepted",
}
"""Sources without effect on any frame of an accepted scenario, each with the reason."""


def inexact(text: str) -> Iterator[tuple[int, str]]:
    """Yield line and name of each operation in a source text whose last digits are not the same everywhere."""
    for node in ast.walk(ast.parse(text)):
        match node:
            case ast.BinOp(op=ast.MatMult()):
                yield node.lineno, "@"
            case ast.BinOp(op=ast.Pow(), left=left) if not isinstance(left, ast.Constant):
                yield node.lineno, "**"
            case ast.Attribute(value=ast.Name(id=module), attr=name) if name in INEXACT.get(module, ()):
                yield node.lineno, f"{module}.{name}"
            case ast.ImportFrom(module="math", names=names):
                yield from ((node.lineno, f"math.{one.name}") for one in names if one.name in INEXACT["math"])
            case ast.Call(func=ast.Name(id="sum"), args=[ast.GeneratorExp(elt=element), *_]):
                if not isinstance(element, ast.Compare):  # counts are exact
                    yield node.lineno, "sum"
            case ast.Call(func=ast.Name(id="sum")):
                yield node.lineno, "sum"


def sources() -> list[str]:
    """Return the paths of all sources on which a frame depends."""
    packages = [name for layer in LAYERS[: LAST + 1] for name in layer]
    paths = [
        path for path in sorted(SOURCE.rglob("*.py")) if path.relative_to(SOURCE).parts[0].split(".")[0] in packages
    ]
    names = [path.relative_to(SOURCE).as_posix() for path in paths]
    names += ["recording/entities.py", "recording/viewing.py"]
    return [name for name in names if not any(name == one or name.startswith(f"{one}/") for one in EXEMPT)]


@each("name", sources)
def test_source_has_no_inexact_operation(name: str) -> None:
    assert list(inexact((SOURCE / name).read_text(encoding="utf-8"))) == []


@each("name", EXEMPT)
def test_exempt_source_exists(name: str) -> None:
    assert (SOURCE / name).exists()


@pytest.mark.parametrize(
    "text",
    [
        "c = a @ b",
        "c = a**2",
        "import math\nmath.atan2(1.0, 2.0)",
        "from math import hypot",
        "np.linalg.norm(a)",
        "sum(x * x for x in v)",
        "sum(values)",
    ],
)
def test_search_finds_an_inexact_operation(text: str) -> None:
    assert list(inexact(text))


@pytest.mark.parametrize("text", ["2.0**30", "x * x", "math.sqrt(2.0)", "sum(x < 3 for x in v)", "np.sqrt(a)"])
def test_search_accepts_exact_operations(text: str) -> None:
    assert not list(inexact(text))
