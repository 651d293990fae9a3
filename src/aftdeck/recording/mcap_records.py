"""Records of an MCAP file, in order and checked, so that a damaged file is distinguished from one that is cut short.

In a file of the recorder, every chunk has the CRC of its content, and the record at the end of the data has the CRC of
all bytes before it. The length of a record must agree with the lengths of its parts. A file whose writer was killed
ends within a record or within an unfinished chunk.

Another program may have written the file again: in other chunks or without chunks, without indexes, without CRCs. A CRC
of value 0 is not set. Messages without a CRC of their own are read only after the CRC of all data has been checked.

A file may come from a stranger. Memory and time to read it are therefore proportional to its own size (`decompress`).
"""

from __future__ import annotations

import os
import struct
import zlib
from collections.abc import Callable, Iterator
from io import BytesIO
from typing import BinaryIO, ParamSpec, TypeVar, cast

from mcap.data_stream import ReadDataStream
from mcap.exceptions import McapError
from mcap.opcode import Opcode
from mcap.records import Channel, Chunk, DataEnd, Header, McapRecord, Message, Schema

from aftdeck.recording.damage import DamageError, SizeError
from aftdeck.recording.decompress import MAX_UNPACKED, decompressed
from aftdeck.recording.mcap_index import IndexCheck

MAGIC = b"\x89MCAP0\r\n"
MAX_DECLARED = 2_000
"""Greatest number of schemas and channels in a file; the writer declares fewer than twenty of each."""
UNDER_WAY = 2**64 - 1
"""Value of a chunk's length fields while the chunk is being written."""
_START = struct.Struct("<BQ")
_INT, _LONG = struct.Struct("<I"), struct.Struct("<Q")
_MESSAGE_KIND = int(Opcode.MESSAGE)
_MESSAGE = struct.Struct("<HIQQ")
"""Beginning of a message: channel, sequence number, log time, publish time."""
_PARTS: dict[int, tuple[tuple[int, struct.Struct], ...]] = {
    Opcode.HEADER: ((0, _INT), (0, _INT)),
    Opcode.SCHEMA: ((2, _INT), (0, _INT), (0, _INT)),
    Opcode.CHANNEL: ((4, _INT), (0, _INT), (0, _INT)),
    Opcode.CHUNK: ((28, _INT), (0, _LONG)),
    Opcode.MESSAGE_INDEX: ((2, _INT),),
}
"""Parts of variable length in each type of record: number of bytes between the previous part (or the beginning of the
record) and the length of this part, and format of this length."""
_SKIPPED: set[int] = {Opcode.ATTACHMENT, Opcode.METADATA}
"""Types of records that no recording needs; they may have any length."""
_CONTENT: set[int] = {Opcode.SCHEMA, Opcode.CHANNEL, Opcode.MESSAGE}
"""Types of records in chunks; in a file without chunks, they stand alone."""
_KNOWN: set[int] = _SKIPPED | _CONTENT | {Opcode.HEADER, Opcode.CHUNK, Opcode.MESSAGE_INDEX, Opcode.DATA_END}
_CHUNK_CRC = slice(24, 28)
"""Place of the CRC of the content in a chunk."""
_PIECE = 2**20
"""Length of a piece of a record that is read only for its CRC [bytes]."""
_BROKEN = (McapError, struct.error, ValueError, OverflowError, MemoryError)
"""Exceptions that the libraries raise for a damaged record."""
_Given = ParamSpec("_Given")
_Result = TypeVar("_Result")


def records(file: BinaryIO) -> Iterator[McapRecord]:
    """Yield the header, then channels, schemas and messages in order, then the end of the data if the file has it.

    Args:
        file: an MCAP file, at its beginning.

    Raises:
        SizeError: a part is larger than is read.
        DamageError: the file is damaged or exceeds another limit; raised at the record where this is found.
    """
    declared, index, checked = 0, IndexCheck(), False
    size = os.fstat(file.fileno()).st_size
    total = zlib.crc32(file.read(len(MAGIC)))
    while len(start := file.read(_START.size)) == _START.size:
        opcode, length = _START.unpack(start)
        if opcode not in _KNOWN:
            raise DamageError(f"unknown record type {opcode}")
        if opcode in _SKIPPED:
            total = _crc_of_next(file, length, zlib.crc32(start, total))
            continue
        body = file.read(_not_too_long(min(length, max(size - file.tell(), 0))))
        if _computed_length(opcode, body) not in (None, UNDER_WAY, length):
            raise DamageError("the length of a record contradicts the lengths of its parts")
        if len(body) < length:
            break
        if opcode == Opcode.DATA_END:
            end = _checked(_data_end, body, total)
            _check_summary(file, index)
            yield end
            return
        total = zlib.crc32(body, zlib.crc32(start, total))
        if opcode == Opcode.MESSAGE_INDEX:
            _checked(index.check_messages, file.tell() - _START.size - length, body)
        elif _computed_length(opcode, body) == UNDER_WAY:
            break
        else:
            if not checked and _lacks_crc(opcode, body):
                checked = True
                _check_ahead(file, total)
            for record in _content(opcode, body, index, file.tell() - _START.size - length):
                declared += isinstance(record, Schema | Channel)
                _not_too_many(declared)
                yield record
    file.seek(max(size - len(MAGIC), len(MAGIC)))
    if file.read() == MAGIC:
        raise DamageError("the file has an end, but data before the end is missing")


def _lacks_crc(opcode: int, body: bytes) -> bool:
    return opcode in _CONTENT or (opcode == Opcode.CHUNK and not any(body[_CHUNK_CRC]))


def _crc_of_next(file: BinaryIO, length: int, total: int) -> int:
    """Return a CRC continued over the next bytes of a file, which are read in pieces."""
    while length > 0 and (piece := file.read(min(length, _PIECE))):
        total = zlib.crc32(piece, total)
        length -= len(piece)
    return total


def _check_ahead(file: BinaryIO, total: int) -> None:
    """Check the CRC of the data from the CRC up to here; leave the file at the same place.

    A file that was cut short has no end of the data, and so no CRC.

    Raises:
        DamageError: the CRC does not match.
    """
    here = file.tell()
    while len(start := file.read(_START.size)) == _START.size:
        opcode, length = _START.unpack(start)
        if opcode == Opcode.DATA_END:
            _checked(_data_end, file.read(_INT.size), total)
            break
        total = _crc_of_next(file, length, zlib.crc32(start, total))
    file.seek(here)


def _data_end(body: bytes, total: int) -> DataEnd:
    (expected,) = _INT.unpack(body)
    if expected not in (0, total):
        raise DamageError("data CRC does not match")
    return DataEnd(expected)


def _check_summary(file: BinaryIO, index: IndexCheck) -> None:
    """Check the records after the data; a file may be cut short within them.

    Raises:
        DamageError: they contradict the data, or bytes follow their end.
    """
    begins, left = file.tell(), os.fstat(file.fileno()).st_size
    while len(start := file.read(_START.size)) == _START.size:
        opcode, length = _START.unpack(start)
        body = file.read(_not_too_long(min(length, left)))
        if len(body) < length:
            return
        _checked(index.check_summary, opcode, body, begins)
        if opcode == Opcode.FOOTER:
            if not MAGIC.startswith(file.read(len(MAGIC) + 1)):
                raise DamageError("bytes follow the end of the file")
            return


def _checked(read: Callable[_Given, _Result], *given: _Given.args, **named: _Given.kwargs) -> _Result:
    """Return the result of a function that reads a record.

    Raises:
        DamageError: the record is damaged.
    """
    try:
        return read(*given, **named)
    except _BROKEN as error:
        raise DamageError(str(error) or type(error).__name__) from None


def _not_too_many(declared: int) -> None:
    if declared > MAX_DECLARED:
        raise DamageError(f"{declared} schemas and channels; at most {MAX_DECLARED} are allowed")


def _not_too_long(size: int) -> int:
    if size > MAX_UNPACKED:
        raise SizeError(f"a record has {size} bytes")
    return size


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


def _content(opcode: int, body: bytes, index: IndexCheck, at: int) -> Iterator[Header | Schema | Channel | Message]:
    """Yield a record that stands alone, or the records in a chunk, which begins at the offset `at` in the file.

    Schemas, channels and messages are added to `index`.
    """
    if opcode == Opcode.HEADER:
        yield _checked(_header, body)
    elif opcode == Opcode.CHUNK:
        index.add_chunk(at, _START.size + len(body))
        yield from _unpacked(body, index)
    else:
        record = _checked(_record, opcode, body)
        index.add_alone(record)
        yield record


def _unpacked(body: bytes, index: IndexCheck) -> Iterator[Schema | Channel | Message]:
    """Yield the records in a chunk, one at a time: a list of them could take many times the chunk's memory."""
    chunk = _checked(Chunk.read, ReadDataStream(BytesIO(body)))
    data = decompressed(chunk)
    if chunk.uncompressed_crc not in (0, zlib.crc32(data)):
        raise DamageError("chunk CRC does not match")
    at = 0
    size = len(data)
    while at < size:
        opcode, length = (
            _START.unpack_from(data, at) if size - at >= _START.size else _checked(_START.unpack, data[at:])
        )
        begins, at = at, at + _START.size
        if length > size - at:
            raise DamageError("a record is longer than its chunk")
        if opcode == _MESSAGE_KIND and length >= _MESSAGE.size:
            channel, sequence, log_time, publish_time = _MESSAGE.unpack_from(data, at)
            record: Schema | Channel | Message = Message(
                channel, log_time, data[at + _MESSAGE.size : at + length], publish_time, sequence
            )
        else:
            record = _checked(_record, opcode, data[at : at + length])
        index.add(record, begins)
        yield record
        at += length


def _record(opcode: int, content: bytes) -> Schema | Channel | Message:
    if opcode == Opcode.MESSAGE:
        channel, sequence, log_time, publish_time = _MESSAGE.unpack_from(content)
        return Message(channel, log_time, content[_MESSAGE.size :], publish_time, sequence)
    if opcode == Opcode.CHANNEL:
        return cast("Channel", Channel.read(ReadDataStream(BytesIO(content))))
    if opcode == Opcode.SCHEMA:
        return cast("Schema", Schema.read(ReadDataStream(BytesIO(content))))
    raise DamageError(f"unknown record type {opcode} in a chunk")
