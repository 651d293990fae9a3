"""Records of an MCAP file, in order and checked, so that a damaged file is distinguished from one that is cut short.

Every chunk has the CRC of its content. The record at the end of the data has the CRC of all bytes before it. The length
of a record must agree with the lengths of its parts. A file whose writer was killed ends within a record or within an
unfinished chunk.

A file may come from a stranger. Memory and time to read it are therefore proportional to its own size: a chunk is
decompressed only up to the size that it states, and this size is limited, also in proportion to the compressed bytes.
"""

from __future__ import annotations

import os
import struct
import zlib
from collections.abc import Callable, Iterator
from io import BytesIO
from typing import BinaryIO, cast

import zstandard
from mcap.data_stream import ReadDataStream
from mcap.exceptions import McapError
from mcap.opcode import Opcode
from mcap.records import Channel, Chunk, DataEnd, Header, McapRecord, Message, Schema

from aftdeck.recording.damage import DamageError
from aftdeck.recording.mcap_index import IndexCheck

MAGIC = b"\x89MCAP0\r\n"
MAX_UNPACKED = 2**26
"""Longest record, and longest chunk after decompression [bytes].

The writer closes a chunk at one megabyte. Only the first chunk may be longer, because the header contains four files of
at most `files.MOST_BYTES` each.
"""
MAX_RATIO, SMALL = 500, 2**16
"""Greatest ratio of a chunk's length to its compressed length; a chunk may always have `SMALL` bytes.

A chunk of the writer has at most about 70 times its compressed length, if the arm rests (measured with every arm).
"""
MAX_WINDOW = 2**26
"""Greatest memory that a decompressor may use for its window [bytes]; the writer's level of compression uses 2**19."""
MAX_DECLARED = 2_000
"""Greatest number of schemas and channels in a file; the writer declares fewer than twenty of each."""
UNDER_WAY = 2**64 - 1
"""Value of a chunk's length fields while the chunk is being written."""
_START = struct.Struct("<BQ")
_INT, _LONG = struct.Struct("<I"), struct.Struct("<Q")
_MESSAGE = struct.Struct("<HIQQ")
"""Beginning of a message: channel, sequence number, log time, publish time."""
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


def records(file: BinaryIO) -> Iterator[McapRecord]:
    """Yield the header, then channels, schemas and messages in order, then the end of the data if the file has it.

    Args:
        file: an MCAP file in chunks, at its beginning.

    Raises:
        DamageError: the file is damaged or exceeds a limit; raised at the record where this is found.
    """
    declared, index = 0, IndexCheck()
    size = os.fstat(file.fileno()).st_size
    total = zlib.crc32(file.read(len(MAGIC)))
    while len(start := file.read(_START.size)) == _START.size:
        opcode, length = _START.unpack(start)
        body = file.read(_allowed(min(length, max(size - file.tell(), 0))))
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
            _check_summary(file, index)
            yield DataEnd(expected)
            return
        total = zlib.crc32(body, zlib.crc32(start, total))
        if opcode == Opcode.CHUNK:
            if _computed_length(opcode, body) == UNDER_WAY:
                break
            index.add_chunk(file.tell() - _START.size - length, _START.size + length)
            for record in _unpacked(body, index):
                declared += not isinstance(record, Message)
                _allowed(declared, MAX_DECLARED, "schemas and channels")
                yield record
        elif opcode == Opcode.MESSAGE_INDEX:
            _checked(index.check_messages, file.tell() - _START.size - length, body)
        elif opcode == Opcode.HEADER:
            yield _header(body)
    file.seek(max(size - len(MAGIC), len(MAGIC)))
    if file.read() == MAGIC:
        raise DamageError("the file has an end, but data before the end is missing")


def _check_summary(file: BinaryIO, index: IndexCheck) -> None:
    """Check the records after the data; a file may be cut short within them.

    Raises:
        DamageError: they contradict the data, or bytes follow their end.
    """
    begins, left = file.tell(), os.fstat(file.fileno()).st_size
    while len(start := file.read(_START.size)) == _START.size:
        opcode, length = _START.unpack(start)
        body = file.read(_allowed(min(length, left)))
        if len(body) < length:
            return
        _checked(index.check_summary, opcode, body, begins)
        if opcode == Opcode.FOOTER:
            if not MAGIC.startswith(file.read(len(MAGIC) + 1)):
                raise DamageError("bytes follow the end of the file")
            return


def _checked(check: Callable[..., None], *given: object) -> None:
    try:
        check(*given)
    except _BROKEN as error:
        raise DamageError(str(error) or type(error).__name__) from None


def _allowed(count: int, most: int = MAX_UNPACKED, what: str = "bytes in a record") -> int:
    if count > most:
        raise DamageError(f"{count} {what}; at most {most} are allowed")
    return count


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


def _unpacked(body: bytes, index: IndexCheck) -> Iterator[Schema | Channel | Message]:
    """Yield the records in a chunk, one at a time: a list of them could take many times the chunk's memory.

    Each record is added to `index`.
    """
    try:
        chunk = Chunk.read(ReadDataStream(BytesIO(body)))
        data = _decompressed(chunk)
        if chunk.uncompressed_crc not in (0, zlib.crc32(data)):
            raise DamageError("chunk CRC does not match")
        at = 0
        while at < len(data):
            opcode, length = _START.unpack_from(data, at)
            at += _START.size
            if length > len(data) - at:
                raise DamageError("a record is longer than its chunk")
            record = _record(opcode, data[at : at + length])
            if isinstance(record, Message):
                index.add_message(record.channel_id, record.log_time, at - _START.size)
            else:
                index.add_declaration(record)
            yield record
            at += length
    except _BROKEN as error:
        raise DamageError(str(error) or type(error).__name__) from None


def _decompressed(chunk: Chunk) -> bytes:
    stated, packed = chunk.uncompressed_size, len(chunk.data)
    most = min(MAX_UNPACKED, MAX_RATIO * packed + SMALL)
    if stated > most:
        raise DamageError(f"a chunk of {packed} bytes states {stated} uncompressed bytes; at most {most} are allowed")
    if chunk.compression == "":
        data = chunk.data
    elif chunk.compression == "zstd":
        with zstandard.ZstdDecompressor(max_window_size=MAX_WINDOW).stream_reader(chunk.data) as stream:
            data = stream.read(stated + 1)
    else:
        raise DamageError(f"chunks of Aftdeck are compressed with 'zstd' or not, got {chunk.compression!r}")
    if len(data) != stated:
        raise DamageError(
            f"a chunk states {stated} uncompressed bytes but has {'more' if len(data) > stated else 'fewer'}"
        )
    return data


def _record(opcode: int, content: bytes) -> Schema | Channel | Message:
    if opcode == Opcode.MESSAGE:
        channel, sequence, log_time, publish_time = _MESSAGE.unpack_from(content)
        return Message(channel, log_time, content[_MESSAGE.size :], publish_time, sequence)
    if opcode == Opcode.CHANNEL:
        return cast("Channel", Channel.read(ReadDataStream(BytesIO(content))))
    if opcode == Opcode.SCHEMA:
        return cast("Schema", Schema.read(ReadDataStream(BytesIO(content))))
    raise DamageError(f"unknown record type {opcode} in a chunk")
