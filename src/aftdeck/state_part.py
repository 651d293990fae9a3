"""Parts of a simulation's state; copies, saved states and digests are derived from each part's declaration.

A part is a struct of plain values, arrays and other parts. No part contains constants of the run; methods take the
constants as arguments. A cache is a field that only makes a step faster. No result depends on a cache, so caches are
neither saved nor part of the digest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache
from hashlib import sha256
from typing import Any, Self, TypeVar, get_args, get_type_hints

import msgspec
import numpy as np

from aftdeck.errors import InputError


class StatePart(msgspec.Struct, array_like=True):
    """A part of the state. Everything on which the next step depends is a field of one of the parts."""


class Cache:
    """Field of a part that only makes a step faster. A state with empty caches gives the same results."""

    def copied(self) -> Self:
        """Return the cache for a copy of the state. A cache that a step never changes returns itself."""
        return self


P = TypeVar("P", bound=StatePart)


DIGEST = "msgpack with nil for arrays and caches, then the arrays"
"""Description of the bytes from which `digest` computes the SHA-256. They contain no array sizes: each array has the
same size in all states of a run."""


@lru_cache
def declaration(kind: type[StatePart]) -> str:
    """Return 16 digits of the SHA-256 of `DIGEST` and a part's declaration: each field, with its type and position.

    Parts with different declarations, such as those of different versions, cannot be compared by their digests.
    """
    lines = [DIGEST]
    _declare(kind, lines, set())
    return sha256("\n".join(lines).encode()).hexdigest()[:16]


def _declare(hint: Any, lines: list[str], known: set[object]) -> None:
    """Append one line for each field of every struct that occurs in the type `hint`, including nested structs."""
    if isinstance(hint, type) and issubclass(hint, msgspec.Struct) and hint not in known:
        known.add(hint)
        hints = get_type_hints(hint)
        for name in hint.__struct_fields__:
            lines.append(f"{hint.__name__}.{name}: {hint.__annotations__.get(name, hints[name])}")
            _declare(hints[name], lines, known)
    for one in get_args(hint):
        _declare(one, lines, known)


def encoded(part: StatePart) -> bytes:
    """Return a part as bytes: all of its fields, with None for each cache."""
    return _encode(part)


def digest(part: StatePart) -> bytes:
    """Return the SHA-256 digest of a part, computed from the exact values of all its fields except caches (`DIGEST`).

    Raises:
        TypeError: a value is neither a plain value nor an array nor a cache.
    """
    others: list[Any] = []
    array = np.ndarray
    plain = msgspec.msgpack.encode(part, enc_hook=others.append)
    # joining all arrays at once takes much less time than encoding each array
    arrays: list[Any] = [value for value in others if type(value) is array or not isinstance(value, Cache)]
    return sha256(b"".join((plain, *arrays))).digest()


def copied(part: P) -> P:
    """Return a copy of a part; the two share no object that a step changes."""
    return type(part)(*[_copied(getattr(part, name)) for name in part.__struct_fields__])


def decoded(like: P, data: bytes, empty: Callable[[type], Cache]) -> P:
    """Return the part from the bytes that `encoded` returned.

    Args:
        like: a part of the same run, with arrays of the same lengths.
        data: the bytes.
        empty: function that returns an empty cache of the given class.

    Raises:
        InputError: the bytes do not encode a part with the type and sizes of `like`.
    """

    def hook(kind: type, given: Any) -> object:
        # the annotation of an array has type arguments; that of a cache is a class and has none
        return _array(kind, given) if get_args(kind) else empty(kind)

    try:
        part: P = msgspec.msgpack.decode(data, type=type(like), dec_hook=hook)
    except (msgspec.DecodeError, ValueError, TypeError) as error:
        raise InputError(f"the saved state cannot be read: {error}") from None
    if (where := _unlike(part, like)) is not None:
        raise InputError(f"the saved state belongs to another worksite or arm: {where} has a different size here")
    return part


def _plain(value: object) -> object:
    """Return the bytes of an array, preceded by its shape if it has more than one axis; return None for a cache."""
    if isinstance(value, np.ndarray):
        return value.tobytes() if value.ndim == 1 else (value.shape, value.tobytes())
    if isinstance(value, Cache):
        return None
    raise NotImplementedError(f"a state cannot contain a value of the type {type(value).__name__}")


_encode = msgspec.msgpack.Encoder(enc_hook=_plain).encode


def _array(kind: type, given: Any) -> object:
    shape, data = given if isinstance(given, list) else (-1, given)
    return np.frombuffer(data, _dtype(kind)).reshape(shape).copy()


@lru_cache
def _dtype(kind: type) -> np.dtype[Any]:
    """Return the NumPy number type in an array's annotation."""
    numbers: np.dtype[Any] = np.dtype(get_args(get_args(kind)[1])[0])
    return numbers


def _copied(value: Any) -> Any:
    match value:
        case StatePart():
            return copied(value)
        case Cache():
            return value.copied()
        case np.ndarray():
            return value.copy()
        case list():
            return [_copied(one) for one in value]
        case dict():
            return dict(value)
    return value


def _unlike(part: StatePart, like: StatePart) -> str | None:
    """Return the path of the first array or list of parts that has different sizes in `part` and `like`, or None."""
    sizes = dict(_sizes(part, ""))
    return next((where for where, size in _sizes(like, "") if sizes.get(where) != size), None)


def _sizes(value: Any, where: str) -> Iterator[tuple[str, tuple[int, ...]]]:
    """Yield the path and the size of every array, and of every list of parts, in a value."""
    match value:
        case np.ndarray():
            yield where, value.shape
        case StatePart():
            for name in value.__struct_fields__:
                yield from _sizes(getattr(value, name), f"{where}.{name}".lstrip("."))
        case [StatePart() | None, *_]:
            yield where, (len(value),)
            for k, one in enumerate(value):
                yield from _sizes(one, f"{where}[{k}]")
