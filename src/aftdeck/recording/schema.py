"""JSON schemas of the channels, in the simple form that every viewer of MCAP files can read.

A viewer plots JSON messages by their schema, and accepts neither references nor alternatives in a schema. Therefore
each schema repeats the types of all inner fields. If a field may be absent or null, its schema describes only its other
values.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal, NamedTuple, get_args, get_origin, get_type_hints

import msgspec

from aftdeck.field_meta import comments
from aftdeck.recording.hints import apart, is_object, names, without_none
from aftdeck.tuples import Rows

_PLAIN = {float: "number", int: "integer", str: "string", bool: "boolean"}


class FieldInfo(NamedTuple):
    """Description of a field, read from its type and from the string below it in the source code."""

    name: str
    kind: Any
    optional: bool
    description: str
    unit: str
    frame: str
    rounded: bool
    """True if the field has declared decimals. Its numbers are then rounded, and rotations are quaternions."""


def fields(kind: type) -> Iterator[FieldInfo]:
    """Yield the descriptions of the fields of a struct or a named tuple, in order."""
    hints = get_type_hints(kind, include_extras=True)
    texts = comments(kind)
    for name in names(kind):
        inner, meta = apart(hints[name])
        plain = without_none(inner)
        extra = (meta and meta.extra) or {"unit": "", "frame": ""}
        text = (meta and meta.description) or texts.get(name, "").rstrip(".")
        yield FieldInfo(
            name, plain, plain is not inner, " ".join(text.split()), extra["unit"], extra["frame"], meta is not None
        )


def schema(kind: type[msgspec.Struct]) -> dict[str, Any]:
    """Return the schema of a channel's messages."""
    return {"title": f"aftdeck.{kind.__name__}", **_object(kind)}


def _object(kind: type) -> dict[str, Any]:
    properties = {}
    for field in fields(kind):
        extra = {"description": text} if (text := _description(field)) else {}
        properties[field.name] = {**_schema(field.kind), **extra}
    return {"type": "object", "properties": properties}


def _schema(kind: Any) -> dict[str, Any]:
    kind = without_none(apart(kind)[0])
    origin = get_origin(kind)
    if kind == Rows:
        return {"type": "array", "items": {"type": "number"}}
    if origin is tuple:
        return {"type": "array", "items": _schema(get_args(kind)[0])}
    if origin is Literal:
        return {"type": "string", "enum": list(get_args(kind))}
    if origin is dict:
        return {"type": "object", "properties": {}}  # viewers demand properties
    if is_object(kind):
        return _object(kind)
    return {"type": _PLAIN[kind]}


def rotation(field: FieldInfo) -> str:
    """Return how a recording represents a rotation in this field."""
    return "quaternion w, x, y, z" if field.rounded else "matrix row by row"


def _description(field: FieldInfo) -> str:
    more = [rotation(field) if field.kind == Rows else "", field.unit, f"in {field.frame}" if field.frame else ""]
    note = ", ".join(part for part in more if part)
    return f"{field.description}{f' [{note}]' if note else ''}"
