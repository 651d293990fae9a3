"""Tables of docs/recording.md, generated from the message types: ``python -m aftdeck.recording.document FILE``.

The command replaces the text between the two marks in FILE.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal, get_args, get_origin

import msgspec

from aftdeck.made_tables import renew_file
from aftdeck.recording.hints import is_object
from aftdeck.recording.records import CHANNELS
from aftdeck.recording.schema import fields, rotation
from aftdeck.tuples import Rows

_NAMES = {float: "number", int: "whole number", str: "text", bool: "true or false"}


def tables() -> str:
    """Return a heading and a table of fields for each channel, and for each type that the tables name."""
    return "\n".join(_channels())


def _channels() -> Iterator[str]:
    inner: dict[str, type[msgspec.Struct]] = {}
    for topic, (kind, when) in CHANNELS.items():
        yield f"### `{topic}`: {_first(kind)}\n\nSchema `aftdeck.{kind.__name__}`. This message is written {when}.\n"
        yield _table(kind, inner)
    while inner:
        name, within = inner.popitem()
        yield f"### `{name}`, part of a message: {_first(within)}\n"
        yield _table(within, inner)


def _table(kind: type[msgspec.Struct], inner: dict[str, type[msgspec.Struct]]) -> str:
    rows = ["| field | type | unit | axes | description |", "|---|---|---|---|---|"]
    for field in fields(kind):
        optional = " or null" if field.optional else ""
        shown = (rotation(field) if field.kind == Rows else _type(field.kind, inner)) + optional
        rows.append(f"| `{field.name}` | {shown} | {field.unit} | {field.frame} | {field.description} |")
    return "\n".join(rows) + "\n"


def _type(kind: Any, inner: dict[str, type[msgspec.Struct]]) -> str:
    origin = get_origin(kind)
    if origin is tuple:
        return f"list: {_type(get_args(kind)[0], inner)}"
    if origin is Literal:
        return " / ".join(f"`{value}`" for value in get_args(kind))
    if origin is dict:
        return f"object: {_type(get_args(kind)[1], inner)} by names"
    if is_object(kind):
        inner[kind.__name__] = kind
        return f"`{kind.__name__}`"
    return _NAMES[kind]


def _first(kind: type) -> str:
    sentence = (kind.__doc__ or "").splitlines()[0].rstrip(".")
    return sentence[0].lower() + sentence[1:]


if __name__ == "__main__":
    renew_file(tables())
