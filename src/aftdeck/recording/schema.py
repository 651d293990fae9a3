"""JSON schemas of the channels, in the plain form that every viewer of MCAP files reads.

Viewers plot JSON by its schema and take neither references nor alternatives: types are written out in place, and
what may be absent or null is told as what it otherwise is.
"""

from __future__ import annotations

import types
from collections.abc import Iterator
from typing import Annotated, Any, Literal, NamedTuple, Union, get_args, get_origin, get_type_hints

import msgspec

from aftdeck.frames import Rows
from aftdeck.told import comments

_PLAIN = {float: "number", int: "integer", str: "string", bool: "boolean"}


class Told(NamedTuple):
    """A field as its type and its source tell of it."""

    name: str
    kind: Any
    optional: bool
    what: str
    unit: str
    frame: str
    rounded: bool
    """It is recorded to its decimals, a rotation as a quaternion."""


def fields(kind: type) -> Iterator[Told]:
    """The fields of a struct or a named tuple, in order."""
    hints = get_type_hints(kind, include_extras=True)
    struct = issubclass(kind, msgspec.Struct)
    said = comments(kind) if struct else {}
    for name in kind.__struct_fields__ if struct else kind._fields:  # type: ignore[attr-defined]
        inner, meta = _apart(hints[name])
        plain = _without_none(inner)
        extra = (meta and meta.extra) or {"unit": "", "frame": ""}
        what = (meta and meta.description) or said.get(name, "").rstrip(".")
        yield Told(
            name, plain, plain is not inner, " ".join(what.split()), extra["unit"], extra["frame"], meta is not None
        )


def schema(kind: type[msgspec.Struct]) -> dict[str, Any]:
    """The schema of a channel's messages."""
    return {"title": f"aftdeck.{kind.__name__}", **_object(kind)}


def is_object(kind: Any) -> bool:
    """Whether values of a type are written as objects."""
    return isinstance(kind, type) and (issubclass(kind, msgspec.Struct) or hasattr(kind, "_fields"))


def _object(kind: type) -> dict[str, Any]:
    properties = {}
    for field in fields(kind):
        extra = {"description": text} if (text := _description(field)) else {}
        properties[field.name] = {**_schema(field.kind), **extra}
    return {"type": "object", "properties": properties}


def _schema(kind: Any) -> dict[str, Any]:
    kind = _without_none(_apart(kind)[0])
    origin = get_origin(kind)
    if kind == Rows:
        return {"type": "array", "items": {"type": "number"}}
    if origin is tuple:
        return {"type": "array", "items": _schema(get_args(kind)[0])}
    if origin is Literal:
        return {"type": "string", "enum": list(get_args(kind))}
    if is_object(kind):
        return _object(kind)
    return {"type": _PLAIN[kind]}


def rotation(field: Told) -> str:
    """How a field's rotation is written."""
    return "quaternion w, x, y, z" if field.rounded else "matrix row by row"


def _description(field: Told) -> str:
    more = [rotation(field) if field.kind == Rows else "", field.unit, f"in {field.frame}" if field.frame else ""]
    note = ", ".join(part for part in more if part)
    return f"{field.what}{f' [{note}]' if note else ''}"


def _apart(kind: Any) -> tuple[Any, msgspec.Meta | None]:
    """A type without what is told of it, and that."""
    if get_origin(kind) is Annotated:
        inner, *told = get_args(kind)
        return inner, next((m for m in told if isinstance(m, msgspec.Meta)), None)
    return kind, None


def _without_none(kind: Any) -> Any:
    """X for X | None, else the type itself."""
    if get_origin(kind) in (Union, types.UnionType):
        return next(k for k in get_args(kind) if k is not type(None))
    return kind
