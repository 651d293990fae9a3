"""The records of an MCAP file from its beginning, each checked, so that damage is told apart from a cut-off end.

Every chunk carries the sum of what is in it, the end of the data the sum of all before it, and every length is
given twice; a file whose writer was killed ends within a record, or in a chunk that was under way.
"""

from __future__ import annotations

import os
import struct
import zlib
from collections.abc import Iterator
from io import BytesIO
from typing import BinaryIO

import zstandard
from mcap.data_stream import ReadDataStream
from mcap.exceptions import McapError
from mcap.opcode import Opcode
from mcap.records import Chunk, DataEnd, Header, McapRecord
from mcap.stream_reader import breakup_chunk

MAGIC = b"\x89MCAP0\r\n"
MOST_UNPACKED = 2**28
"""Longest chunk that is unpacked [bytes]; the writer closes one at less than a hundredth of it."""
UNDER_WAY = 2**64 - 1
"""Stands in place of a length while its chunk is being written."""
_START = struct.Struct("<BQ")
_INT, _LONG = struct.Struct("<I"), struct.Struct("<Q")
_PARTS: dict[int, tuple[tuple[int, struct.Struct], ...]] = {
    Opcode.HEADER: ((0, _INT), (0, _INT)),
    Opcode.CHUNK: ((28, _INT), (0, _LONG)),
    Opcode.MESSAGE_INDEX: ((2, _INT),),
}
"""A record's parts that say how long they are: the bytes before each, and the number that it begins with."""
_SKIPPED: set[int] = {Opcode.MESSAGE_INDEX, Opcode.ATTACHMENT, Opcode.METADATA}
_KNOWN: set[int] = _SKIPPED | {Opcode.HEADER, Opcode.CHUNK, Opcode.DATA_END}
_BROKEN = (McapError, zstandard.ZstdError, struct.error, ValueError, OverflowError, MemoryError)
"""What a damaged chunk makes the libraries raise."""


class DamageError(Exception):
    """What is wrong in the file."""


def records(file: BinaryIO) -> Iterator[McapRecord]:
    """The header, then channels, schemas and messages in order; last the end of the data, if the file has come to it.

    Args:
        file: an MCAP file in chunks, at its beginning. What is behind the end of its data is not looked at.

    Raises:
        DamageError: at the record in which the damage lies.
    """
    size = os.fstat(file.fileno()).st_size
    total = zlib.crc32(file.read(len(MAGIC)))
    while len(start := file.read(_START.size)) == _START.size:
        opcode, length = _START.unpack(start)
        body = file.read(min(length, max(size - file.tell(), 0)))
        if opcode not in _KNOWN:
            raise DamageError(f"it has a record of kind {opcode}, which no recording has")
        if _told_length(opcode, body) not in (None, UNDER_WAY, length):
            raise DamageError("a record's length is wrong")
        if len(body) < length:
            break
        if opcode == Opcode.DATA_END:
            (expected,) = _INT.unpack(body)
            if expected not in (0, total):
                raise DamageError("the sum of all its bytes is wrong")
            yield DataEnd(expected)
            return
        total = zlib.crc32(body, zlib.crc32(start, total))
        if opcode == Opcode.CHUNK:
            if _told_length(opcode, body) == UNDER_WAY:
                break
            yield from _unpacked(body)
        elif opcode == Opcode.HEADER:
            yield _header(body)
    file.seek(max(size - len(MAGIC), len(MAGIC)))
    if file.read() == MAGIC:
        raise DamageError("it has an end, but not all that comes before it")


def _told_length(opcode: int, body: bytes) -> int | None:
    """A record's length by what it says of its parts; None: it does not say, or not in what there is of it."""
    if opcode == Opcode.DATA_END:
        return _INT.size
    at = 0
    for before, size in _PARTS.get(opcode, ()):
        at += before
        if len(body) < at + size.size:
            return None
        (part,) = size.unpack_from(body, at)
        if part == UNDER_WAY:
            return UNDER_WAY
        at += size.size + int(part)
    return at or None


def _header(body: bytes) -> Header:
    (first,) = _INT.unpack_from(body)
    profile, library = body[4 : 4 + first], body[8 + first :]
    return Header(profile.decode(errors="replace"), library.decode(errors="replace"))


def _unpacked(body: bytes) -> list[McapRecord]:
    try:
        chunk = Chunk.read(ReadDataStream(BytesIO(body)))
        if chunk.uncompressed_size > MOST_UNPACKED:
            raise DamageError(f"a chunk says that it has {chunk.uncompressed_size} bytes")
        return breakup_chunk(chunk, validate_crc=True)
    except _BROKEN as error:
        raise DamageError(str(error) or type(error).__name__) from None
