"""Check of an MCAP file's index, by which other readers find the messages, against the file's data.

A reader such as Foxglove does not read a file from its beginning to its end: it reads the chunks and messages that the
index names, and the schemas and channels of the summary. A forged index could show other messages than the data. An
index of some chunks or messages could hide the others; so a file must index all of its chunks or none, and the messages
of all chunks or of none.
"""

from __future__ import annotations

import struct
from io import BytesIO
from typing import NamedTuple

from mcap.data_stream import ReadDataStream
from mcap.opcode import Opcode
from mcap.records import Channel, ChunkIndex, Footer, Message, Schema

from aftdeck.recording.damage import DamageError

_OTHERS: set[int] = {
    Opcode.STATISTICS,
    Opcode.SUMMARY_OFFSET,
    Opcode.ATTACHMENT_INDEX,
    Opcode.METADATA_INDEX,
}
"""Types of records in a summary that name no message."""

_INDEX, _INDEXED = struct.Struct("<HI"), struct.Struct("<QQ")
"""Beginning of an index of messages: channel, length of the rest; and an entry: log time, offset in the chunk."""


class _Chunk(NamedTuple):
    length: int
    """Length of the record with its type and length [bytes]."""
    messages: dict[int, list[tuple[int, int]]]
    """Log time and offset in the chunk of each message, by the number of its channel; emptied when it was compared."""
    indexes: dict[int, int]
    """Offset in the file of the index of each channel's messages."""
    times: set[int]
    """First and last log time of the messages; empty without messages."""


class IndexCheck:
    """Check of the indexes of a file, whose records are added in their order."""

    def __init__(self) -> None:
        self._chunks: dict[int, _Chunk] = {}
        self._last = _Chunk(0, {}, {}, set())
        self._schemas: dict[int, Schema] = {}
        self._channels: dict[int, Channel] = {}
        self._indexed: set[int] = set()
        self._alone = False
        self._with_messages: set[bool] = set()

    def add_chunk(self, at: int, length: int) -> None:
        """Add a chunk, with its offset in the file and its length [bytes]."""
        for messages in self._last.messages.values():
            self._compared(messages)  # their index would have followed: the file has none
        self._last = self._chunks[at] = _Chunk(length, {}, {}, set())

    def add(self, record: Schema | Channel | Message, at: int) -> None:
        """Add a record of the last chunk, with its offset in the chunk."""
        if isinstance(record, Message):
            self._last.messages.setdefault(record.channel_id, []).append((record.log_time, at))
        elif isinstance(record, Schema):
            self._schemas[record.id] = record
        else:
            self._channels[record.id] = record

    def add_alone(self, record: Schema | Channel | Message) -> None:
        """Add a record that is not in a chunk; no index can name it."""
        if isinstance(record, Message):
            self._alone = True
        else:
            self.add(record, 0)

    def check_messages(self, at: int, body: bytes) -> None:
        """Check an index of messages, with its offset in the file; it belongs to the last chunk.

        Raises:
            DamageError: it names other messages than those in the chunk.
        """
        channel, _ = _INDEX.unpack_from(body)
        found = self._last.messages.get(channel, [])
        if sorted(_INDEXED.iter_unpack(body[_INDEX.size :])) != sorted(found):
            raise DamageError(f"the index of channel {channel} names other messages than its chunk has")
        if found:
            self._last.indexes[channel] = at
            self._compared(found)

    def _compared(self, messages: list[tuple[int, int]]) -> None:
        """Forget messages of the last chunk, except for the first and last time."""
        if messages:
            times = (min(messages)[0], max(messages)[0], *self._last.times)
            self._last.times.clear()
            self._last.times.update((min(times), max(times)))
            messages.clear()

    def check_summary(self, kind: int, body: bytes, begins: int) -> None:
        """Check a record of the summary, which begins at the offset `begins` in the file.

        Raises:
            DamageError: it contradicts the data.
        """
        for messages in self._last.messages.values():
            self._compared(messages)
        if kind == Opcode.CHUNK_INDEX:
            index = ChunkIndex.read(_stream(body))
            chunk = self._chunks.get(index.chunk_start_offset)
            if (
                chunk is None
                or index.chunk_length != chunk.length
                or {channel: at for channel, at in index.message_index_offsets.items() if channel in chunk.messages}
                != chunk.indexes
                or (chunk.times and {index.message_start_time, index.message_end_time} != chunk.times)
                or set(chunk.indexes) not in (set(chunk.messages), set())
            ):
                raise DamageError("the index of a chunk contradicts the chunk")
            self._indexed.add(index.chunk_start_offset)
            if chunk.messages:
                self._with_messages.add(bool(chunk.indexes))
        elif kind == Opcode.SCHEMA:
            schema = Schema.read(_stream(body))
            if self._schemas.get(schema.id, schema) != schema:
                raise DamageError(f"the summary has another schema {schema.id} than the data")
        elif kind == Opcode.CHANNEL:
            channel = Channel.read(_stream(body))
            if self._channels.get(channel.id, channel) != channel:
                raise DamageError(f"the summary has another channel {channel.id} than the data")
        elif kind == Opcode.FOOTER:
            start = Footer.read(_stream(body)).summary_start
            if start not in (0, begins):
                raise DamageError("the index of the chunks is elsewhere")
            if self._indexed and (self._indexed != set(self._chunks) or self._alone or len(self._with_messages) > 1):
                raise DamageError("the index of the chunks is not complete")
        elif kind not in _OTHERS:
            raise DamageError(f"unknown record type {kind} in the summary")


def _stream(body: bytes) -> ReadDataStream:
    return ReadDataStream(BytesIO(body))
