"""Metadata of the fields of frames and messages.

The metadata of a field is written once, in the field's type. Schemas, documents, files and the page use it.
"""

from __future__ import annotations

import ast
import inspect
import itertools
import textwrap
from functools import lru_cache
from typing import cast

import msgspec

DECIMALS = 9
"""Default number of decimals of a recorded number. With 9 decimals, lengths are recorded to 1 nm, angles to 1 nrad."""


def field_meta(what: str, unit: str = "", frame: str = "", decimals: int = DECIMALS) -> msgspec.Meta:
    """Return a field's metadata.

    Args:
        what: description of the field.
        unit: unit of the values.
        frame: coordinate frame of the components.
        decimals: number of decimals of a recorded value.
    """
    extra = {"unit": unit, "frame": frame, "decimals": decimals}
    return msgspec.Meta(description=what, extra=extra)


@lru_cache
def comments(struct: type) -> dict[str, str]:
    """Return the string below each field in the source code, by field name; fields of base classes are included."""
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
