"""Digests of laws: a change makes the machine code of a law and of those that use it new, and no other."""

from __future__ import annotations

import ast
import importlib
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any, NamedTuple

import numpy as np
import pytest

import aftdeck
from aftdeck import law, law_digest
from aftdeck.law_digest import digest_of, digest_of_types

HOME = Path(aftdeck.__file__).parent
LAWS = {"law", "elementary_law", "large_law"}
TEXT = """
import math
from typing import NamedTuple
from aftdeck.law import law
import numpy as np

class Pair(NamedTuple):
    low: float
    high: float

FACTOR = 2.0
TABLE = np.array([1.0, 2.0])
UNUSED = 1

@law
def inner(x):
    "Return a product."
    return FACTOR * x

@law
def outer(x):
    return inner(x) + TABLE[0]

@law
def other(x):
    return Pair(x, math.sqrt(x))
"""

CALLS_ITSELF = """
@law
def other(x):
    return other(x - 1) if x > 0 else 0
"""


def digests(text: str) -> dict[str, str]:
    """Return the digests of the laws of a module with this text."""
    law_digest._known.clear()
    module = ModuleType("some_laws")
    module.__dict__["__name__"] = "aftdeck.some_laws"
    exec(compile(text, "some_laws.py", "exec"), module.__dict__)
    return {name: digest_of(_function(module, name)) for name in ("inner", "outer", "other")}


def _function(module: ModuleType, name: str) -> FunctionType:
    found: Any = getattr(module, name)
    function = getattr(found, "py_func", None) or found.function
    assert isinstance(function, FunctionType)
    return function


@pytest.mark.parametrize(
    ("old", "new", "changed"),
    [
        ("UNUSED = 1", "UNUSED = 2\n\n\n", set()),
        ("Return a product.", "Return twice the value.", set()),
        ("return FACTOR * x", "return x * FACTOR", {"inner", "outer"}),
        ("FACTOR = 2.0", "FACTOR = 2", {"inner", "outer"}),
        ("FACTOR = 2.0", "FACTOR = np.float64(2.0)", {"inner", "outer"}),
        ("[1.0, 2.0]", "[1.0, 2.5]", {"outer"}),
        ("[1.0, 2.0]", "[1, 2]", {"outer"}),
        ("inner(x) +", "inner(x) -", {"outer"}),
        ("@law\ndef inner", "from aftdeck.law import large_law\n@large_law\ndef inner", {"outer"}),
        ("    low: float\n    high: float", "    high: float\n    low: float", {"other"}),
        ("math.sqrt", "math.exp", {"other"}),
    ],
)
def test_digest_changes_with_what_a_law_uses(old: str, new: str, changed: set[str]) -> None:
    assert TEXT.count(old) == 1
    before, after = digests(TEXT), digests(TEXT.replace(old, new))
    assert {name for name in before if before[name] != after[name]} == changed


def test_law_may_call_itself_and_laws_in_a_circle_are_an_error() -> None:
    before, after = digests(TEXT + CALLS_ITSELF), digests(TEXT + CALLS_ITSELF.replace("- 1", "- 2"))
    assert {name for name in before if before[name] != after[name]} == {"other"}
    with pytest.raises(TypeError, match="circle"):
        digests(TEXT.replace("return FACTOR * x", "return outer(x)"))
    assert digests(TEXT) == digests(TEXT), "nothing is left of the error"


class _Backward(NamedTuple):
    high: float
    low: float


class _Forward(NamedTuple):
    low: float
    high: float


def test_types_of_arguments_tell_the_names_of_the_fields() -> None:
    import numba  # noqa: PLC0415

    typeof: Any = numba.typeof
    found = [digest_of_types((typeof(1.0), typeof((kind(1.0, 2.0), 3)))) for kind in (_Backward, _Forward)]
    assert "('high', 'low')" in found[0] and "('low', 'high')" in found[1]


_strange = object()


def test_value_without_a_known_digest_is_an_error() -> None:
    def uses() -> object:
        return _strange

    with pytest.raises(TypeError, match="no digest is known"):
        digest_of(uses)


def test_a_changed_law_makes_its_users_new_and_hardly_any_other() -> None:
    """A second witness reads the users from the sources.

    A few others are new, too, because an attribute and a law have the same name.
    """
    uses, laws = _uses()
    functions = {name: _function(importlib.import_module(name[0]), name[1]) for name in laws}
    callers = {name: _users(uses, name) & laws for name in laws}
    before, others = _all(functions), 0
    for name, function in functions.items():
        code = function.__code__
        function.__code__ = code.replace(co_consts=(*code.co_consts, 0.125))
        after = _all(functions)
        function.__code__ = code
        changed = {one for one in functions if before[one] != after[one]}
        needed = callers[name] | {name}
        assert needed <= changed, name
        others += len(changed - needed)
    assert others < 0.05 * sum(map(len, callers.values()))
    law_digest._known.clear()
    assert len(functions) > 100 and sum(map(len, callers.values())) > 400


Name = tuple[str, str]


def _all(functions: dict[Name, FunctionType]) -> dict[Name, str]:
    law_digest._known.clear()
    return {name: digest_of(function) for name, function in functions.items()}


def _uses() -> tuple[dict[Name, set[Name]], set[Name]]:
    """Return the names that each law, and each value of a module, uses; and the names of the laws."""
    found: dict[Name, set[Name]] = {}
    laws = set[Name]()
    for path in sorted(HOME.rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        module = ".".join(("aftdeck", *path.relative_to(HOME).with_suffix("").parts)).removesuffix(".__init__")
        imported = {
            alias.asname or alias.name: (node.module, alias.name)
            for node in ast.walk(tree)
            if isinstance(node, ast.ImportFrom) and node.module
            for alias in node.names
        }

        def used(node: ast.AST, imported: dict[str, Name] = imported, module: str = module) -> set[Name]:
            names = {one.id for one in ast.walk(node) if isinstance(one, ast.Name)}
            found = {imported.get(name, (module, name)) for name in names}
            for one in ast.walk(node):
                if isinstance(one, ast.Attribute) and isinstance(one.value, ast.Name) and one.value.id in imported:
                    found.add((".".join(imported[one.value.id]), one.attr))  # of a module
            return found

        for node in tree.body:
            if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
                found[module, node.targets[0].id] = used(node.value)
            elif isinstance(node, ast.FunctionDef) and any(
                isinstance(one, ast.Name) and one.id in LAWS for one in node.decorator_list
            ):
                laws.add((module, node.name))
                found[module, node.name] = {one for part in node.body for one in used(part)}
    return found, laws


def _users(uses: dict[Name, set[Name]], name: Name) -> set[Name]:
    """Return all that uses a law, also by others."""
    known, new = set[Name](), {name}
    while new:
        new = {one for one, used in uses.items() if used & new} - known
        known |= new
    return known - {name}


USED = """
from aftdeck.law import law

FACTOR = 3.0

@law
def inner(value):
    return FACTOR * value

@law
def outer(value):
    return inner(value) + 1.0

@law
def other(value):
    return value - 1.0
"""
RUN = """
import users_laws as laws
from aftdeck import law
law.load()
print(laws.outer(2.0), laws.other(2.0), laws.inner(2.0))
print([one.stats.cache_misses != {} for one in (laws.outer, laws.other, laws.inner)])
"""


def test_only_what_has_changed_is_compiled_again(tmp_path: Path) -> None:
    def run(text: str) -> list[str]:
        (tmp_path / "users_laws.py").write_text(text)
        env = {**os.environ, "PYTHONPATH": str(tmp_path), "NUMBA_CACHE_DIR": str(tmp_path / "cache")}
        done = subprocess.run(
            [sys.executable, "-c", RUN], env=env, capture_output=True, text=True, check=True, timeout=300
        )
        return done.stdout.splitlines()

    assert run(USED) == ["7.0 1.0 6.0", "[True, True, True]"]
    assert run(USED) == ["7.0 1.0 6.0", "[False, False, False]"]
    assert run("\n\n" + USED + "\nMORE = 1\n") == ["7.0 1.0 6.0", "[False, False, False]"]
    assert run(USED.replace("3.0", "4.0")) == ["9.0 1.0 8.0", "[True, False, True]"]
    assert run(USED.replace("+ 1.0", "+ 2.0")) == ["8.0 1.0 6.0", "[True, False, False]"]
    assert run(USED) == ["7.0 1.0 6.0", "[False, False, False]"], "machine code of another version is kept"


def test_digests_are_those_of_another_process_before_and_after_loading() -> None:
    code = """
import sys
from aftdeck import law
from aftdeck.law_digest import digest_of
from aftdeck.kinematics import solver
from aftdeck.steering import msteer
print(digest_of(msteer.msteer.function))
law.load()
from aftdeck import law_digest
law_digest._known.clear()
print(digest_of(msteer.msteer.py_func))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=300)
    from aftdeck.steering import msteer  # noqa: PLC0415

    law_digest._known.clear()
    assert set(done.stdout.split()) == {digest_of(_function(msteer, "msteer"))}


def test_arrays_and_options_are_told_apart() -> None:
    def of(value: object) -> str:
        def uses() -> object:
            return value

        return digest_of(uses)

    values: list[object] = [1, 1.0, True, -0.0, 0.0, "1", b"1", (1,), [1], np.float64(1.0), np.zeros(1), np.zeros(2)]
    made: list[Callable[..., object]] = [law.law(_plain), law.large_law(_plain), law.fused(_plain)]
    assert len({of(value) for value in (*values, *made)}) == len(values) + len(made)


def _plain(x: float) -> float:
    return x
