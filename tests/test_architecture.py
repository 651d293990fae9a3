"""The control step in docs/architecture.md agrees with the code."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import aftdeck.simulation.fly
import aftdeck.simulation.step

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
    assert len(documented) > 10 and "go" in documented
    at = documented.index("go")
    inner = body(aftdeck.simulation.fly, "go")
    ends = at + 1 + sum(name in inner for name in documented[at + 1 :])
    for names, made in (
        (documented[: at + 1] + documented[ends:], body(aftdeck.simulation.step, "step")),
        (documented[at + 1 : ends], inner),
    ):
        left = iter(made)
        assert all(name in left for name in names), f"shown: {names}; made: {made}"


def test_calls_of_the_step_that_change_the_state_are_documented() -> None:
    """Not documented: calls for the phase's name, the script's rate limits, initialisation and the camera drives.

    `acts_once`, `only_sticks` and `is_idle` change nothing; `finish` and `order` are parts of `operate`.
    """
    left_out = set(body(aftdeck.simulation.step, "step")) - set(shown())
    assert left_out <= {
        *("phase_name", "hand_over", "initialise", "driven", "acts_once", "only_sticks", "is_idle", "finish", "order"),
    }
