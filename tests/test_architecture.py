"""The control step in docs/architecture.md agrees with the code."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import aftdeck.simulation.fly
import aftdeck.simulation.step

NESTED = {"go": aftdeck.simulation.fly, "settle": aftdeck.simulation.step}
"""Functions whose calls the document shows below them."""
DOCUMENT = Path(__file__).parents[1] / "docs" / "architecture.md"


def calls(source: str) -> list[str]:
    """Return the functions called in a source, in the order of its lines."""
    found = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call)]
    in_order = sorted(found, key=lambda node: (node.lineno, node.col_offset))
    return [ast.unparse(node.func).split(".")[-1] for node in in_order]


def body(module: object, name: str) -> list[str]:
    """Return the names of the functions that a module's function calls."""
    file = Path(str(vars(module)["__file__"]))
    tree = ast.parse(file.read_text(encoding="utf-8"))
    (function,) = (node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == name)
    return calls(ast.unparse(function))


def shown() -> list[str]:
    """Return the calls in the document, without its comments."""
    text = DOCUMENT.read_text(encoding="utf-8")
    block = re.search(r"^    def step\(.*?(?=^\S)", text, re.MULTILINE | re.DOTALL)
    assert block is not None
    lines = [re.sub(r"\s*#.*", "", line) for line in block[0].splitlines()]
    return [name for line in lines for name in re.findall(r"(\w+)\(", line) if name != "step"]


def test_documented_calls_are_made_in_the_documented_order() -> None:
    documented = shown()
    assert len(documented) > 10 and set(NESTED) <= set(documented)
    made = {name: body(module, name) for name, module in NESTED.items()} | {
        "step": body(aftdeck.simulation.step, "step")
    }
    found, now = {name: list[str]() for name in made}, "step"
    for name in documented:
        now = now if name in made[now] and now in NESTED else "step"
        found[now].append(name)
        now = name if name in NESTED else now
    for name, names in found.items():
        left = iter(made[name])
        assert names and all(one in left for one in names), f"{name}: shown: {names}; made: {made[name]}"


def test_calls_of_the_step_that_change_the_state_are_documented() -> None:
    """Not documented: calls for the phase's name, the script's rate limits, initialisation and the camera drives.

    `acts_once`, `only_sticks` and `is_idle` change nothing; `finish` and `order` are parts of `operate`.
    """
    left_out = set(body(aftdeck.simulation.step, "step")) - set(shown())
    assert left_out <= {
        *("phase_name", "hand_over", "initialise", "driven", "acts_once", "only_sticks", "is_idle", "finish", "order"),
    }
