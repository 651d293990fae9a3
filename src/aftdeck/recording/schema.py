"""JSON schemas of the channels, in the simple form that every viewer of MCAP files reads.

Viewers plot JSON by its schema, and accept neither references nor alternatives. Types are therefore written out in
place, and a field that may be absent or null has the schema of its other values.
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
    """Description of a field, read from its type and its source."""

    name: str
    kind: Any
    optional: bool
    what: str
    unit: str
    frame: str
    rounded: bool
    """True if the field is recorded to its decimals, and a rotation in it as a quaternion."""


def fields(kind: type) -> Iterator[Told]:
    """Yield the descriptions of the fields of a struct or a named tuple, in order."""
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
    """Return the schema of a channel's messages."""
    return {"title": f"aftdeck.{kind.__name__}", **_object(kind)}


def is_object(kind: Any) -> bool:
    """Return whether values of a type are written as objects."""
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
    """Return the text that says how a field's rotation is written."""
    return "quaternion w, x, y, z" if field.rounded else "matrix row by row"


def _description(field: Told) -> str:
    more = [rotation(field) if field.kind == Rows else "", field.unit, f"in {field.frame}" if field.frame else ""]
    note = ", ".join(part for part in more if part)
    return f"{field.what}{f' [{note}]' if note else ''}"


def _apart(kind: Any) -> tuple[Any, msgspec.Meta | None]:
    """Return a type without its metadata, and the metadata; None if it has none."""
    if get_origin(kind) is Annotated:
        inner, *told = get_args(kind)
        return inner, next((m for m in told if isinstance(m, msgspec.Meta)), None)
    return kind, None


def _without_none(kind: Any) -> Any:
    """Return X for X | None, otherwise the type itself."""
    if get_origin(kind) in (Union, types.UnionType):
        return next(k for k in get_args(kind) if k is not type(None))
    return kind
