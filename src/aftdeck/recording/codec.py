"""Conversion between values and the JSON of a recording, derived from the types of the values.

A field with declared decimals (`aftdeck.field_meta`) is rounded to these decimals; a rotation in it becomes a
quaternion (w, x, y, z). Any other field keeps all digits; a rotation in it becomes a matrix, row by row. Named tuples
become objects, because viewers do not accept lists of lists.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, TypeVar, cast, get_args, get_origin, get_type_hints

import msgspec
import numpy as np

from aftdeck.frames import quaternion, rotation_of
from aftdeck.recording.hints import apart, is_object, names, without_none
from aftdeck.tuples import Rows

Change = Callable[[Any], Any]
"""Function that converts a value to its plain form, or a plain form to its value."""
S = TypeVar("S", bound=msgspec.Struct)

_LIMIT = 2**63
_encode = msgspec.json.Encoder().encode


def encode(message: msgspec.Struct) -> bytes:
    """Return a message as JSON."""
    return _encode(plain(message))


def decode(kind: type[S], data: bytes) -> S:
    """Convert JSON from `encode` to a message of the type `kind`.

    Raises:
        msgspec.MsgspecError: `data` is not a message of this type.
    """
    return restored(kind, msgspec.json.decode(data))


def plain(message: msgspec.Struct) -> Any:
    """Return a message in plain form: objects, lists, numbers and texts."""
    change = _of_struct(type(message), back=False)
    return message if change is None else change(message)


def restored(kind: type[S], data: Any) -> S:
    """Convert the plain form of a message to a message of the type `kind`.

    Raises:
        msgspec.ValidationError: `data` is not a message of this type.
    """
    change = _of_struct(kind, back=True)
    try:
        return msgspec.convert(data if change is None else change(data), kind)
    except (TypeError, ValueError, AttributeError, KeyError, ArithmeticError) as error:
        if isinstance(error, msgspec.ValidationError):
            raise
        raise msgspec.ValidationError(str(error)) from None


def as_read(message: S) -> S:
    """Return a message with the values that a reader of the file gets: rounded to the declared decimals."""
    return restored(type(message), plain(message))


@cache
def _of_struct(kind: type, *, back: bool, decimals: int | None = None) -> Change | None:
    """Return the conversion of a struct or named tuple to its plain form, or from its plain form if `back`.

    Return None if no conversion is necessary. `decimals` applies to fields that do not declare their own.
    """
    hints = get_type_hints(kind, include_extras=True)
    changes = {name: change for name in names(kind) if (change := _of(hints[name], back=back, decimals=decimals))}
    if issubclass(kind, msgspec.Struct) and not changes:
        return None
    if not back:
        return _written(kind, changes)
    if not issubclass(kind, msgspec.Struct):
        return lambda data: [changes[name](data[name]) if name in changes else data[name] for name in names(kind)]

    def read(data: Any) -> Any:
        if not isinstance(data, dict):
            return data
        return {name: changes[name](value) if name in changes else value for name, value in data.items()}

    return read


def _written(kind: type, changes: dict[str, Change]) -> Change:
    """Return the conversion of a struct or named tuple to its plain form."""
    defaults: dict[str, object] = {}
    if issubclass(kind, msgspec.Struct) and kind.__struct_config__.omit_defaults:
        defaults = {field.name: field.default for field in msgspec.structs.fields(kind)}

    def write(value: Any) -> dict[str, Any]:
        out = {}
        for name in names(kind):
            item = getattr(value, name)
            if name in defaults and item == defaults[name]:
                continue
            change = changes.get(name)
            out[name] = item if change is None else change(item)
        return out

    return write


def _of(hint: Any, *, back: bool, decimals: int | None = None) -> Change | None:
    """Return the conversion of values of a type, as `_of_struct` does; None if no conversion is necessary."""
    hint, meta = apart(hint)
    if meta is not None and meta.extra:
        decimals = meta.extra.get("decimals", decimals)
    if (kind := without_none(hint)) is not hint:
        change = _of(kind, back=back, decimals=decimals)
        return None if change is None else lambda value: None if value is None else change(value)
    if hint == Rows:
        return _rotation(decimals, back=back)
    if hint is float and decimals is not None and not back:
        return lambda value: round(value, decimals)
    if hint is int and back:
        return _bounded
    if get_origin(hint) is tuple:
        return _of_tuple(get_args(hint), back=back, decimals=decimals)
    if is_object(hint):  # a struct's fields declare their own decimals
        return _of_struct(hint, back=back, decimals=None if issubclass(hint, msgspec.Struct) else decimals)
    return None


def _of_tuple(kinds: tuple[Any, ...], *, back: bool, decimals: int | None) -> Change | None:
    """Return the conversion of a tuple with items of one type, as `_of_struct` does; None if none is necessary."""
    change = _of(kinds[0], back=back, decimals=decimals)
    if change is None:
        return None
    if kinds[0] is float:
        return lambda value: [round(item, cast("int", decimals)) for item in value]
    return lambda value: [change(item) for item in value]


def _bounded(value: Any) -> Any:
    """Return a value unchanged.

    Raises:
        ValueError: it is a whole number of more than 64 bits, which other formats cannot store.
    """
    if isinstance(value, int) and not -_LIMIT <= value < _LIMIT:
        raise ValueError("a whole number has more than 64 bits")
    return value


def _rotation(decimals: int | None, *, back: bool) -> Change:
    if decimals is None:
        return (
            (lambda flat: (flat[:3], flat[3:6], flat[6:]))
            if back
            else (lambda rows: [number for row in rows for number in row])
        )
    if back:
        return lambda attitude: rotation_of(tuple(attitude))
    return lambda rows: [round(float(number), decimals) for number in quaternion(np.array(rows))]
