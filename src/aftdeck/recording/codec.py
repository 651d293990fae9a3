"""Conversion between values and the JSON of a recording, derived from the types of the values.

A field with declared decimals (`aftdeck.field_meta`) is rounded to these decimals; a rotation in it becomes a
quaternion (w, x, y, z). Any other field keeps all digits; a rotation in it becomes a matrix, row by row. Named tuples
become objects, because viewers do not accept lists of lists.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, TypeVar, get_args, get_origin, get_type_hints

import msgspec

from aftdeck.frames import rotation_of
from aftdeck.recording.hints import apart, is_object, names, without_none
from aftdeck.recording.plain_form import plain
from aftdeck.tuples import Rows

Change = Callable[[Any], Any]
"""Function that converts a plain form to its value."""
S = TypeVar("S", bound=msgspec.Struct)

LIMIT = 2**63
"""Least power of two that other formats cannot store."""
_encode = msgspec.json.Encoder().encode


def encode(message: msgspec.Struct) -> bytes:
    """Return a message as JSON."""
    return _encode(plain(message))


def decode(kind: type[S], data: bytes) -> S:
    """Convert JSON from `encode` to a message of the type `kind`.

    Raises:
        msgspec.MsgspecError: `data` is not a message of this type.
    """
    return _restored(kind, msgspec.json.decode(data))


def _restored(kind: type[S], data: Any) -> S:
    """Convert the plain form of a message to a message of the type `kind`; the plain form is used up.

    Raises:
        msgspec.ValidationError: `data` is not a message of this type.
    """
    change = _of_struct(kind)
    try:
        return msgspec.convert(data if change is None else change(data), kind)
    except (TypeError, ValueError, AttributeError, KeyError, ArithmeticError) as error:
        if isinstance(error, msgspec.ValidationError):
            raise
        raise msgspec.ValidationError(str(error)) from None


def as_read(message: S) -> S:
    """Return a message with the values that a reader of the file gets: rounded to the declared decimals."""
    return _restored(type(message), plain(message))


@cache
def _of_struct(kind: type, decimals: int | None = None) -> Change | None:
    """Return the conversion of the plain form of a struct or named tuple; None if no conversion is necessary.

    `decimals` applies to fields that do not declare their own.
    """
    hints = get_type_hints(kind, include_extras=True)
    changes = {name: change for name in names(kind) if (change := _of(hints[name], decimals))}
    if not issubclass(kind, msgspec.Struct):
        fields = [(name, changes.get(name)) for name in names(kind)]
        return lambda data: [data[name] if change is None else change(data[name]) for name, change in fields]
    if not changes:
        return None

    steps = tuple(changes.items())

    def read(data: Any) -> Any:
        if isinstance(data, dict):
            for name, change in steps:
                if name in data:
                    data[name] = change(data[name])
        return data

    return read


def _of(hint: Any, decimals: int | None) -> Change | None:
    """Return the conversion of the plain form of values of a type, as `_of_struct` does."""
    hint, meta = apart(hint)
    if meta is not None and meta.extra:
        decimals = meta.extra.get("decimals", decimals)
    if (kind := without_none(hint)) is not hint:
        change = _of(kind, decimals)
        return None if change is None else lambda value: None if value is None else change(value)
    if hint == Rows:
        return _rows if decimals is None else lambda attitude: rotation_of(tuple(attitude))
    if hint is int:
        return _bounded
    if get_origin(hint) is tuple:
        each = _of(get_args(hint)[0], decimals)
        return None if each is None else lambda value: [each(item) for item in value]
    if is_object(hint):  # a struct's fields declare their own decimals
        return _of_struct(hint, None if issubclass(hint, msgspec.Struct) else decimals)
    return None


def _rows(flat: Any) -> Any:
    """Return the rows of a matrix."""
    return flat[:3], flat[3:6], flat[6:]


def _bounded(value: Any) -> Any:
    """Return a value unchanged.

    Raises:
        ValueError: it is a whole number of more than 64 bits, which other formats cannot store.
    """
    if isinstance(value, int) and not -LIMIT <= value < LIMIT:
        raise ValueError("a whole number has more than 64 bits")
    return value
