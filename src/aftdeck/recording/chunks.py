"""Records of an MCAP file, in order and checked, so that a damaged file is distinguished from one that is cut short.

Every chunk has the CRC of its content. The record at the end of the data has the CRC of all bytes before it. The length
of a record must agree with the lengths of its parts. A file whose writer was killed ends within a record or within an
unfinished chunk.
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
MAX_UNPACKED = 2**28
"""Longest chunk that is unpacked [bytes]; the chunks of the writer are more than a hundred times shorter."""
UNDER_WAY = 2**64 - 1
"""Value of a chunk's length fields while the chunk is being written."""
_START = struct.Struct("<BQ")
_INT, _LONG = struct.Struct("<I"), struct.Struct("<Q")
_PARTS: dict[int, tuple[tuple[int, struct.Struct], ...]] = {
    Opcode.HEADER: ((0, _INT), (0, _INT)),
    Opcode.CHUNK: ((28, _INT), (0, _LONG)),
    Opcode.MESSAGE_INDEX: ((2, _INT),),
}
"""Parts of variable length in each type of record: number of bytes between the previous part (or the beginning of the
record) and the length of this part, and format of this length."""
_SKIPPED: set[int] = {Opcode.MESSAGE_INDEX, Opcode.ATTACHMENT, Opcode.METADATA}
_KNOWN: set[int] = _SKIPPED | {Opcode.HEADER, Opcode.CHUNK, Opcode.DATA_END}
_BROKEN = (McapError, zstandard.ZstdError, struct.error, ValueError, OverflowError, MemoryError)
"""Exceptions that the libraries raise for a damaged chunk."""


class DamageError(Exception):
    """Damage in the file; the message describes it."""


def records(file: BinaryIO) -> Iterator[McapRecord]:
    """Yield the header, then channels, schemas and messages in order, then the end of the data if the file has it.

    Args:
        file: an MCAP file in chunks, at its beginning. Records after the end of the data are not checked.

    Raises:
        DamageError: the file is damaged; raised at the damaged record.
    """
    size = os.fstat(file.fileno()).st_size
    total = zlib.crc32(file.read(len(MAGIC)))
    while len(start := file.read(_START.size)) == _START.size:
        opcode, length = _START.unpack(start)
        body = file.read(min(length, max(size - file.tell(), 0)))
        if opcode not in _KNOWN:
            raise DamageError(f"unknown record type {opcode}")
        if _computed_length(opcode, body) not in (None, UNDER_WAY, length):
            raise DamageError("the length of a record contradicts the lengths of its parts")
        if len(body) < length:
            break
        if opcode == Opcode.DATA_END:
            (expected,) = _INT.unpack(body)
            if expected not in (0, total):
                raise DamageError("data CRC does not match")
            yield DataEnd(expected)
            return
        total = zlib.crc32(body, zlib.crc32(start, total))
        if opcode == Opcode.CHUNK:
            if _computed_length(opcode, body) == UNDER_WAY:
                break
            yield from _unpacked(body)
        elif opcode == Opcode.HEADER:
            yield _header(body)
    file.seek(max(size - len(MAGIC), len(MAGIC)))
    if file.read() == MAGIC:
        raise DamageError("the file has an end, but data before the end is missing")


def _computed_length(opcode: int, body: bytes) -> int | None:
    """Return a record's length, computed from the lengths of its parts.

    Returns:
        The length; `UNDER_WAY` if a part was still being written; None if this type of record has no parts of variable
        length, or if `body` ends before the length of a part.
    """
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
        if chunk.uncompressed_size > MAX_UNPACKED:
            raise DamageError(
                f"a chunk has {chunk.uncompressed_size} uncompressed bytes; at most {MAX_UNPACKED} are allowed"
            )
        return breakup_chunk(chunk, validate_crc=True)
    except _BROKEN as error:
        raise DamageError(str(error) or type(error).__name__) from None
