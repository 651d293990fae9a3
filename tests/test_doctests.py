"""The examples in the docstrings of the sources give the results that stand there."""

from __future__ import annotations

import doctest
import importlib
from pathlib import Path

import aftdeck

SOURCE = Path(aftdeck.__file__).parent


def test_examples_in_docstrings_are_correct() -> None:
    with_examples = [path for path in sorted(SOURCE.rglob("*.py")) if ">>> " in path.read_text(encoding="utf-8")]
    assert with_examples
    for path in with_examples:
        module = importlib.import_module(".".join(path.relative_to(SOURCE.parent).with_suffix("").parts))
        failed, tried = doctest.testmod(module)
        assert (failed, tried > 0) == (0, True), path
