"""Reader of recordings, whether complete, cut short or damaged."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import BinaryIO, NamedTuple

import msgspec
from mcap.records import Channel as McapChannel
from mcap.records import Header, Schema
from mcap.records import Message as McapMessage

from aftdeck.errors import RecordingError, RecordingFault
from aftdeck.recording import on_demand
from aftdeck.recording.chain import Declared
from aftdeck.recording.codec import decode
from aftdeck.recording.damage import DamageError, SizeError
from aftdeck.recording.decompress import MAX_UNPACKED
from aftdeck.recording.delays import Delays
from aftdeck.recording.mcap_records import MAGIC, records
from aftdeck.recording.message import Message
from aftdeck.recording.records import (
    CHANNELS,
    FORMAT,
    PROFILE,
    Closing,
    ControllersRecord,
    DelayRecord,
    FrameRecord,
    Input,
    Note,
    Opening,
)
from aftdeck.recording.rewritten import rewritten
from aftdeck.tuples import Joints
from aftdeck.units import short


class _Layout(msgspec.Struct):
    """Fields that the header has in every layout: layout number and version."""

    format: int
    version: str


MAX_MESSAGE, MAX_TEXTS = 2**20, 2**24
"""Longest message [bytes]; header and footer, which contain whole files and summaries, may have `MAX_TEXTS`."""
MAX_WITHOUT_STEP = 10_000
"""Greatest number of messages between two steps; a step of the writer has fewer than a hundred."""
MAX_TIME_ERROR = 1e-6
"""Greatest difference between the time of a frame and its number of control periods [s]."""
_LONGEST_SEED = 2**63
_Decode = Callable[[type[Message], bytes], Message]
"""Function that decodes a message of a type."""


class Entry(NamedTuple):
    """Message as it is in the file."""

    channel: Declared
    log_time: int
    """Time since 1970 [ns]."""
    publish_time: int
    """Time since 1970 [ns]."""
    data: bytes
    message: Message | None
    """The decoded message; None in a channel that is not one of Aftdeck's own (`CHANNELS`)."""


class Recording:
    """Recording, read from its beginning to its end or to the point where it is cut short.

    Attributes:
        path: the file.
        opening: header of the recording.
        ended: reason for the end of the run; empty if the file is cut short, and before it has been read to its end.
        cut: whether the file is cut short, because the program was killed or the disk was full; False before the file
            has been read.
        time_s: simulated time of the last frame read [s].
        share: fraction of the file that has been read, 0 to 1.
        frames_sha256: SHA-256 over the digests of all frames; empty while `ended` is empty.
        summary: summary of a scripted run, JSON; empty while `ended` is empty, and for a manual run.
        delays: delays of the steps read so far; None if the file does not tell them: the run was not in real time, or
            an earlier version recorded it.
    """

    def __init__(self, path: str | Path) -> None:
        """Open a recording.

        Raises:
            RecordingError: the file is not a recording of Aftdeck, has another layout, or has no header.
        """
        self.path = Path(path)
        self.ended, self.cut, self.time_s, self.share = "", False, 0.0, 0.0
        self.frames_sha256 = self.summary = ""
        entry = next(self._entries(), None)
        if entry is None:
            raise RecordingError(f"{self.path}: was cut short before its first second; it has no data", "empty")
        first = entry.message
        if not isinstance(first, Opening):
            raise self._misplaced("the first message is not the header")
        if not 0 <= first.seed < _LONGEST_SEED:
            raise self._damaged(f"the seed must be between 0 and 2**63, got {short(first.seed)}")
        self.opening = first
        self.delays = Delays() if first.real_time else None

    def messages(self) -> Iterator[Message]:
        """Yield all messages of Aftdeck's own channels in order, and then set `ended` or `cut`.

        Raises:
            RecordingError: the file is damaged; raised at the damaged message.
        """
        return (entry.message for entry in self.entries() if entry.message is not None)

    def messages_on_demand(self) -> Iterator[Message]:
        """Yield the messages as `messages` does; their attitudes are converted when they are read (`on_demand`)."""
        return (entry.message for entry in self._checked(on_demand.decode) if entry.message is not None)

    def entries(self) -> Iterator[Entry]:
        """Yield the messages of all channels as `messages` does, with their channels, times and bytes."""
        return self._checked(decode)

    def _checked(self, read: _Decode) -> Iterator[Entry]:
        """Yield the messages of all channels, whose order and steps are checked."""
        self.ended, self.cut, self.time_s = "", False, 0.0
        self.delays = Delays() if self.opening.real_time else None
        tick = quiet = 0
        for number, entry in enumerate(self._entries(read)):
            message = entry.message
            if self.ended:
                raise self._misplaced(f"a message in {short(entry.channel.topic)} follows the footer")
            quiet += 1
            if isinstance(message, (FrameRecord, Input)) and message.tick != tick + 1:
                raise self._misplaced(f"step {short(message.tick)} follows step {tick}")
            if isinstance(message, FrameRecord):
                self._check_step(message)
                tick, quiet, self.time_s = message.tick, 0, message.time_s
            elif quiet > MAX_WITHOUT_STEP:
                raise self._damaged(f"more than {MAX_WITHOUT_STEP} messages without a step")
            elif message is None or isinstance(message, Input):
                pass
            elif number and isinstance(message, Opening):
                raise self._misplaced("a second header follows the first")
            elif isinstance(message, DelayRecord) and self.delays is not None:
                self.delays = self.delays.after(
                    message.time_s, message.late_s, message.lost_s, commanded=message.commanded
                )
            elif isinstance(message, Closing):
                if message.ticks != tick:
                    raise self._misplaced(f"the file ends after step {tick} of {short(message.ticks)}")
                self.ended, self.frames_sha256, self.summary = message.ended, message.frames_sha256, message.summary
            yield entry
        self.cut = not self.ended

    def _check_step(self, frame: FrameRecord) -> None:
        """Check the time of a frame, and the number of values in its lists of joints."""
        if not abs(frame.time_s - frame.tick * self.opening.control_period_s) <= MAX_TIME_ERROR:
            raise self._damaged(f"step {frame.tick} has the time {frame.time_s:g} s")
        joints = len(self.opening.joints)
        if set(map(len, _joint_values(frame))) != {joints}:
            raise self._damaged(f"step {frame.tick} does not have one value for each of {joints} joints")

    def entries_with_inputs(self) -> Iterator[Entry]:
        """Yield the messages as `entries` does, for a re-simulation, which needs the inputs of each step.

        Raises:
            RecordingError: a step has no inputs before its frame.
        """
        given = 0
        for entry in self.entries():
            message = entry.message
            if isinstance(message, Input):
                given = message.tick
            elif isinstance(message, FrameRecord) and message.tick != given:
                raise self._misplaced(f"step {message.tick} has no inputs")
            yield entry

    def steps(self) -> Iterator[tuple[Input, FrameRecord]]:
        """Yield the inputs and the frame of each step; skip all other messages.

        Raises:
            RecordingError: a step has no inputs before its frame.
        """
        inputs = Input(tick=0)
        for entry in self.entries_with_inputs():
            if isinstance(entry.message, Input):
                inputs = entry.message
            elif isinstance(entry.message, FrameRecord):
                yield inputs, entry.message

    def notes(self) -> Iterator[Note]:
        """Return an iterator over the log lines of the station."""
        return (message for message in self.messages() if isinstance(message, Note))

    def controllers(self) -> Iterator[ControllersRecord]:
        """Return an iterator over the records of the devices that moved the sticks, one for each change.

        The iterator is empty for a scripted run, and for a file of an earlier version without these records.
        """
        return (message for message in self.messages() if isinstance(message, ControllersRecord))

    def _entries(self, read: _Decode = decode) -> Iterator[Entry]:
        try:
            if self.path.exists() and not self.path.is_file():  # reading a pipe or a device may never end
                kind = "a folder" if self.path.is_dir() else "not a regular file"
                raise RecordingError(f"{self.path}: is {kind}, not a recording", "unreadable")
            with self.path.open("rb") as file:
                yield from self._decoded(file, read)
        except OSError as error:
            raise RecordingError(f"{self.path}: cannot be read: {error.strerror or error}", "unreadable") from None
        except SizeError as error:
            raise RecordingError(
                f"{self.path}: {error}; at most {MAX_UNPACKED} bytes are read at once: use the original, or let the "
                "other program write smaller chunks",
                "rewritten",
            ) from None
        except DamageError as error:
            raise self._damaged(str(error)) from None

    def _decoded(self, file: BinaryIO, read: _Decode) -> Iterator[Entry]:
        start = file.read(len(MAGIC))
        if start != MAGIC[: len(start)]:
            raise RecordingError(
                f"{self.path}: is not an MCAP file, and therefore not a recording of Aftdeck", "foreign"
            )
        file.seek(0)
        size = max(self.path.stat().st_size, 1)
        schemas: dict[int, Schema] = {}
        channels: dict[int, Declared] = {}
        profile = PROFILE
        for record in records(file):
            if isinstance(record, McapMessage):
                self.share = file.tell() / size
                channel = channels.get(record.channel_id)
                if channel is None:
                    raise DamageError(f"a message belongs to channel {record.channel_id}, which is not declared")
                if profile != PROFILE:
                    if not channel.schema.startswith(f"{PROFILE}."):
                        raise self._foreign()
                    profile = PROFILE  # another program may have written none
                message = self._message(channel.topic, record.data, read)
                yield Entry(channel, record.log_time, record.publish_time, record.data, message)
            elif isinstance(record, Header):
                profile = self._profile_of(record)
            elif isinstance(record, Schema):
                if schemas.setdefault(record.id, record) != record:
                    raise DamageError(f"schema {record.id} is declared twice, and differently")
            elif isinstance(record, McapChannel):
                declared = _declared(record, schemas.get(record.schema_id))
                if channels.setdefault(record.id, declared) != declared:
                    raise DamageError(f"channel {record.id} is declared twice, and differently")
        if profile != PROFILE:
            raise self._foreign()

    def _profile_of(self, header: Header) -> str:
        """Return the profile of a file, which may be empty."""
        if header.profile not in (PROFILE, ""):
            raise self._foreign()
        return header.profile

    def _message(self, topic: str, data: bytes, read: _Decode) -> Message | None:
        if topic not in CHANNELS:
            return None
        kind, _ = CHANNELS[topic]
        texts = kind in (Opening, Closing)
        if len(data) > (most := MAX_TEXTS if texts else MAX_MESSAGE):
            raise self._damaged(f"a message in {topic} has {len(data)} bytes; at most {most} are allowed")
        try:
            if kind is Opening:
                self._check_layout(msgspec.json.decode(data, type=_Layout))
            if texts:  # decoded directly, because unknown fields then take no memory
                return msgspec.json.decode(data, type=kind)
            return read(kind, data)
        except (msgspec.MsgspecError, AttributeError, KeyError, TypeError, ValueError, RecursionError) as error:
            raise self._damaged(f"invalid message in {topic}: {error}") from None

    def _check_layout(self, layout: _Layout) -> None:
        if layout.format == FORMAT:
            return
        age: RecordingFault = "newer layout" if layout.format > FORMAT else "older layout"
        raise RecordingError(
            f"{self.path}: has layout {layout.format} of Aftdeck {layout.version}; this version reads layout {FORMAT}",
            age,
        )

    def _foreign(self) -> RecordingError:
        return RecordingError(f"{self.path}: is an MCAP file, but not a recording of Aftdeck", "foreign")

    def _misplaced(self, why: str) -> RecordingError:
        """Return the error for messages that are missing or not in the order of the recorder."""
        return rewritten(self.path, why) or self._damaged(why)

    def _damaged(self, why: str) -> RecordingError:
        return RecordingError(f"{self.path}: is damaged after {self.time_s:.2f} s: {why}", "damaged")


def _joint_values(frame: FrameRecord) -> list[Joints | tuple[int, ...]]:
    """Return every list of a frame that has a value for each joint."""
    found = [frame.angles, frame.rates, frame.angles_commanded, frame.rates_commanded, frame.rate_limits, frame.zones]
    if frame.check is not None and frame.check.joints is not None:
        found.append(frame.check.joints)
    if frame.work.master is not None:
        found.append(frame.work.master)
    if frame.dynamics is not None:
        found.append(frame.dynamics.torques)
    return found


def _declared(channel: McapChannel, schema: Schema | None) -> Declared:
    metadata = msgspec.json.encode(channel.metadata, order="sorted").decode() if channel.metadata else ""
    own = ("", "", b"") if schema is None else (schema.name, schema.encoding, schema.data)
    return Declared(channel.topic, channel.message_encoding, *own, metadata)
