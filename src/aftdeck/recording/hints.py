"""Functions that read type hints: metadata, optional types, and the fields of structs and named tuples."""

from __future__ import annotations

from types import UnionType
from typing import Annotated, Any, TypeGuard, Union, get_args, get_origin

import msgspec


def apart(hint: Any) -> tuple[Any, msgspec.Meta | None]:
    """Return a type without its metadata, and its metadata; the metadata is None if the type has none."""
    if get_origin(hint) is Annotated:
        inner, *more = get_args(hint)
        return inner, next((meta for meta in more if isinstance(meta, msgspec.Meta)), None)
    return hint, None


def without_none(hint: Any) -> Any:
    """Return X for the type X | None; return any other type unchanged."""
    if get_origin(hint) in (Union, UnionType):
        return next(kind for kind in get_args(hint) if kind is not type(None))
    return hint


def is_object(hint: Any) -> TypeGuard[type]:
    """Return whether a type is written as an object: a struct or named tuple."""
    return isinstance(hint, type) and (issubclass(hint, msgspec.Struct) or hasattr(hint, "_fields"))


def names(kind: type) -> tuple[str, ...]:
    """Return the names of the fields of a struct or a named tuple, in order."""
    if issubclass(kind, msgspec.Struct):
        return kind.__struct_fields__
    named_tuple: Any = kind
    return tuple(named_tuple._fields)
