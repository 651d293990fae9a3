"""Reader of protobuf messages whose schema is in a recording; it supports what Foxglove's messages need."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from typing import Any, NamedTuple

Fields = dict[int, list[Any]]
_DOUBLE, _ENUM, _INT32, _MESSAGE, _STRING, _BYTES, _FIXED32 = 1, 14, 5, 11, 9, 12, 7
_REPEATED = 3


class _Field(NamedTuple):
    name: str
    kind: int
    repeated: bool
    of: str


class Decoder:
    """Decoder for messages of one type, given by its full name and the FileDescriptorSet that describes it."""

    def __init__(self, descriptors: bytes, name: str) -> None:
        self._name = name
        self._types: dict[str, dict[int, _Field]] = {}
        for file in _fields(descriptors)[1]:
            content = _fields(file)
            package = content[2][0].decode()
            for message in content.get(4, []):
                self._add(package, message)

    def _add(self, scope: str, message: bytes) -> None:
        content = _fields(message)
        name = f"{scope}.{content[1][0].decode()}"
        self._types[name] = {}
        for raw in content.get(2, []):
            field = _fields(raw)
            of = field[6][0].decode().removeprefix(".") if 6 in field else ""
            described = _Field(field[1][0].decode(), field[5][0], field[4][0] == _REPEATED, of)
            self._types[name][field[3][0]] = described
        for inner in content.get(3, []):
            self._add(name, inner)

    def decode(self, data: bytes) -> dict[str, Any]:
        """Return a message; a field that was not sent has its default."""
        return self._message(data, self._name)

    def _message(self, data: bytes, name: str) -> dict[str, Any]:
        sent = _fields(data)
        assert set(sent) <= set(self._types[name]), f"fields of {name} that its schema does not have"
        return {field.name: self._value(field, sent.get(number, [])) for number, field in self._types[name].items()}

    def _value(self, field: _Field, sent: list[Any]) -> Any:
        if field.repeated and field.kind == _FIXED32 and sent:
            return [n for part in sent for (n,) in struct.iter_unpack("<I", part)]
        values = [self._single(field, raw) for raw in sent]
        if field.repeated:
            return values
        default = {_DOUBLE: 0.0, _STRING: "", _BYTES: b"", _MESSAGE: None}.get(field.kind, 0)
        return values[-1] if values else default

    def _single(self, field: _Field, raw: Any) -> Any:
        if field.kind == _MESSAGE:
            return self._message(raw, field.of)
        if field.kind == _DOUBLE:
            return struct.unpack("<d", raw)[0]
        return raw.decode() if field.kind == _STRING else raw


def _fields(data: bytes) -> Fields:
    """Return the raw values of a message by field number."""
    found: Fields = {}
    for number, value in _walk(data):
        found.setdefault(number, []).append(value)
    return found


def _walk(data: bytes) -> Iterator[tuple[int, Any]]:
    at = 0
    while at < len(data):
        key, at = _varint(data, at)
        number, wire = key >> 3, key & 7
        if wire == 0:
            value, at = _varint(data, at)
            yield number, value
            continue
        if wire == 2:
            size, at = _varint(data, at)
        else:
            size = {1: 8, 5: 4}[wire]
        yield number, data[at : at + size]
        at += size


def _varint(data: bytes, at: int) -> tuple[int, int]:
    value = shift = 0
    while True:
        byte = data[at]
        value |= (byte & 127) << shift
        at, shift = at + 1, shift + 7
        if byte < 128:
            return value, at
