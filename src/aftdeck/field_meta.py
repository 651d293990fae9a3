"""Metadata of fields of frames and messages, stated once beside the type; for schemas, documents, files, the page."""

from __future__ import annotations

import ast
import inspect
import itertools
import textwrap
from functools import lru_cache
from typing import cast

import msgspec

DECIMALS = 9
"""Default number of decimals to which a number is recorded: nanometres and nanoradians."""


def field_meta(what: str, unit: str = "", frame: str = "", decimals: int = DECIMALS) -> msgspec.Meta:
    """Return a field's metadata: description, unit, the axes of its components, and the decimals recorded."""
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
        except OSError:  # a class created at run time has no source
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
