"""What a field of a frame or a message is, told once, beside its type: for schemas, documents, files and the page."""

from __future__ import annotations

import ast
import inspect
import itertools
import textwrap
from functools import lru_cache
from typing import cast

import msgspec

DECIMALS = 9
"""To which a number is recorded, where nothing else is told: nanometres and nanoradians."""


def told(what: str, unit: str = "", frame: str = "", decimals: int = DECIMALS) -> msgspec.Meta:
    """What a field is, its unit, the axes that it is expressed in, and the decimals to which it is recorded."""
    return msgspec.Meta(description=what, extra={"unit": unit, "frame": frame, "decimals": decimals})


@lru_cache
def comments(struct: type) -> dict[str, str]:
    """Return the string that follows each field in a class's source, its base classes' fields included."""
    found: dict[str, str] = {}
    for cls in reversed(struct.__mro__):
        if not issubclass(cls, msgspec.Struct) or cls is msgspec.Struct:
            continue
        try:
            source = inspect.getsource(cls)
        except OSError:  # made while the program runs
            continue
        body = cast(ast.ClassDef, ast.parse(textwrap.dedent(source)).body[0]).body
        for field, after in itertools.pairwise(body):
            if (
                isinstance(field, ast.AnnAssign)
                and isinstance(field.target, ast.Name)
                and isinstance(after, ast.Expr)
                and isinstance(after.value, ast.Constant)
            ):
                found[field.target.id] = inspect.cleandoc(str(after.value.value))
    return found
