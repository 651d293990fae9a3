"""JSON schemas of the channels, in the plain form that every viewer of MCAP files reads.

Viewers plot JSON by its schema and take neither references nor alternatives: types are written out in place, and
what may be absent or null is told as what it otherwise is.
"""

from __future__ import annotations

import types
from collections.abc import Iterator
from typing import Annotated, Any, Literal, NamedTuple, Union, get_args, get_origin, get_type_hints

import msgspec

_PLAIN = {float: "number", int: "integer", str: "string", bool: "boolean"}


class Told(NamedTuple):
    """A field as its type tells of it."""

    name: str
    kind: Any
    optional: bool
    meta: msgspec.Meta | None


def fields(kind: type[msgspec.Struct]) -> Iterator[Told]:
    """The fields of a type, in order."""
    hints = get_type_hints(kind, include_extras=True)
    for name in kind.__struct_fields__:
        inner, meta = _apart(hints[name])
        plain = _without_none(inner)
        yield Told(name, plain, plain is not inner, meta)


def schema(kind: type[msgspec.Struct]) -> dict[str, Any]:
    """The schema of a channel's messages."""
    return {"title": f"aftdeck.{kind.__name__}", **_object(kind)}


def _object(kind: type[msgspec.Struct]) -> dict[str, Any]:
    properties = {}
    for field in fields(kind):
        extra = {"description": _description(field.meta)} if field.meta else {}
        properties[field.name] = {**_schema(field.kind), **extra}
    return {"type": "object", "properties": properties}


def _schema(kind: Any) -> dict[str, Any]:
    kind = _without_none(_apart(kind)[0])
    origin = get_origin(kind)
    if origin is tuple:
        return {"type": "array", "items": _schema(get_args(kind)[0])}
    if origin is Literal:
        return {"type": "string", "enum": list(get_args(kind))}
    if isinstance(kind, type) and issubclass(kind, msgspec.Struct):
        return _object(kind)
    return {"type": _PLAIN[kind]}


def _description(meta: msgspec.Meta) -> str:
    extra = meta.extra or {}
    more = [extra["unit"], f"in {extra['frame']}" if extra["frame"] else ""]
    note = ", ".join(part for part in more if part)
    return f"{meta.description}{f' [{note}]' if note else ''}"


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
