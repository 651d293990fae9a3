"""Conversion of messages to their plain form: objects, lists, numbers and texts (`codec` has the rules).

A change replaces an item of a list or of an object by its plain form. All numbers of a message are rounded together,
after everything else.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, get_args, get_origin, get_type_hints

import msgspec
from msgspec.structs import astuple

from aftdeck.frames import quaternion_of_rows
from aftdeck.recording.hints import apart, is_object, names, without_none
from aftdeck.recording.rounding import Rounding
from aftdeck.tuples import Rows

Change = Callable[[Any, Any, Rounding], None]
"""Function that changes the item of a list or an object; the second argument is the index or the key of the item."""


def plain(message: msgspec.Struct) -> Any:
    """Return a message in plain form: objects, lists, numbers and texts."""
    change = _of_object(type(message))
    if change is None:
        return message
    box, rounding = [message], Rounding()
    change(box, 0, rounding)
    rounding.finish()
    return box[0]


@cache
def _of_object(kind: type, decimals: int | None = None) -> Change | None:
    """Return the change of a struct or named tuple; None if no change is necessary.

    `decimals` applies to fields that do not declare their own.
    """
    hints, fields = get_type_hints(kind, include_extras=True), names(kind)
    changes = {name: change for name in fields if (change := _of(hints[name], decimals))}
    if not issubclass(kind, msgspec.Struct):
        return _written(fields, tuple, changes)
    if not changes:
        return None
    if kind.__struct_config__.omit_defaults:
        defaults = [field.default for field in msgspec.structs.fields(kind)]
        return _without_defaults(fields, defaults, changes)
    return _written(fields, astuple, changes)


def _written(fields: tuple[str, ...], values: Callable[[Any], Any], changes: dict[str, Change]) -> Change:
    """Return the change of a struct or named tuple with all its fields; `values` returns their values."""
    numbers = [(name, change.decimals) for name, change in changes.items() if isinstance(change, _Number)]
    lists = [(name, change.decimals) for name, change in changes.items() if isinstance(change, _Numbers)]
    others = [(name, change) for name, change in changes.items() if not isinstance(change, _Number | _Numbers)]
    rotations = [name for name, change in changes.items() if isinstance(change, _Rotation)]

    def write(box: Any, key: Any, rounding: Rounding) -> None:
        box[key] = out = dict(zip(fields, values(box[key]), strict=True))
        for name, change in others:
            change(out, name, rounding)
        for name in rotations:
            out[name] = quaternion_of_rows(out[name])
        rounding.add(out, numbers, lists)

    return write


def _without_defaults(fields: tuple[str, ...], defaults: list[object], changes: dict[str, Change]) -> Change:
    """Return the change of a struct that omits fields with their default values."""

    def write(box: Any, key: Any, rounding: Rounding) -> None:
        rows = zip(fields, astuple(box[key]), defaults, strict=True)
        box[key] = out = {name: value for name, value, default in rows if value != default}
        for name in out:
            if name in changes:
                changes[name](out, name, rounding)

    return write


def _of(hint: Any, decimals: int | None) -> Change | None:
    """Return the change of values of a type, as `_of_object` does."""
    hint, meta = apart(hint)
    if meta is not None and meta.extra:
        decimals = meta.extra.get("decimals", decimals)
    if (kind := without_none(hint)) is not hint:
        change = _of(kind, decimals)
        return None if change is None else _unless_none(change)
    if hint == Rows:
        return _matrix if decimals is None else _Rotation(bytes([decimals]))
    if hint is float and decimals is not None:
        return _Number(bytes([decimals]))
    if get_origin(hint) is tuple:
        return _of_tuple(get_args(hint)[0], decimals)
    if is_object(hint):  # a struct's fields declare their own decimals
        return _of_object(hint, None if issubclass(hint, msgspec.Struct) else decimals)
    return None


def _of_tuple(kind: Any, decimals: int | None) -> Change | None:
    """Return the change of a tuple with items of one type, as `_of_object` does."""
    change = _of(kind, decimals)
    if change is None:
        return None
    if isinstance(change, _Number):
        return _Numbers(change.decimals)

    def write(box: Any, key: Any, rounding: Rounding) -> None:
        if box[key]:
            box[key] = items = list(box[key])
            for n in range(len(items)):
                change(items, n, rounding)

    return write


def _unless_none(change: Change) -> Change:
    def write(box: Any, key: Any, rounding: Rounding) -> None:
        if box[key] is not None:
            change(box, key, rounding)

    return write


class _Number:
    """Change of a number: it is rounded."""

    def __init__(self, decimals: bytes) -> None:
        self.decimals = decimals

    def __call__(self, box: Any, key: Any, rounding: Rounding) -> None:
        rounding.add(box, ((key, self.decimals),), ())


class _Numbers:
    """Change of a list or tuple of numbers: they are rounded."""

    def __init__(self, decimals: bytes) -> None:
        self.decimals = decimals

    def __call__(self, box: Any, key: Any, rounding: Rounding) -> None:
        rounding.add(box, (), ((key, self.decimals),))


class _Rotation(_Numbers):
    """Change of a rotation: it becomes a quaternion, whose numbers are rounded."""

    def __call__(self, box: Any, key: Any, rounding: Rounding) -> None:
        box[key] = quaternion_of_rows(box[key])
        super().__call__(box, key, rounding)


def _matrix(box: Any, key: Any, rounding: Rounding) -> None:
    box[key] = [number for row in box[key] for number in row]
