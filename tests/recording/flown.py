"""Recordings for the tests: recorded runs, and copies with changed messages."""

from __future__ import annotations

import functools
import struct
from collections.abc import Callable, Iterator
from pathlib import Path

import msgspec
import numpy as np
from mcap.records import Channel, Schema
from mcap.records import Message as McapMessage
from mcap.stream_reader import StreamReader
from mcap.writer import CompressionType, Writer
from msgspec.structs import replace

import aftdeck
from aftdeck.errors import RecordingError
from aftdeck.recording.chain import Chain, Declared
from aftdeck.recording.codec import encode
from aftdeck.recording.message import Message
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import Closing
from aftdeck.recording.writer import Ended, Recorder
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from tests.steering.flying import scenario
from tests.steering.random_runs import equipped, inputs, start


@functools.cache
def bay(extra: str = "", name: str = "test") -> Scenario:
    """Return a scenario above the bay with these additional lines of TOML, loaded once."""
    return scenario(extra=extra, name=name)


def record_steps(
    path: Path, made: Scenario, given: Iterator[Inputs | None], steps: int, ended: Ended = "stopped"
) -> list[tuple[Inputs | None, Frame]]:
    """Record a number of steps; return their inputs and frames."""
    sim = aftdeck.Simulation(made)
    recorder = Recorder(path, made, sim.seed)
    flown = []
    for inputs_now, _ in zip(given, range(steps), strict=False):
        flown.append((inputs_now, sim.step(inputs_now)))
        recorder.step(*flown[-1])
        recorder.wait_for_room()
    recorder.close(ended)
    assert recorder.failure == ""
    return flown


def record_random_run(
    path: Path, seed: int, steps: int, extra: str = "", name: str = "test"
) -> list[tuple[Inputs | None, Frame]]:
    """Record a run from a random pose with random inputs, with or without a payload; return inputs and frames."""
    rng = np.random.default_rng(seed)
    first = start(rng)
    made = scenario(first.tolist(), extra + equipped(rng, first, "32000 lb" if seed % 2 else ""), name)
    sim = aftdeck.Simulation(made)
    recorder = Recorder(path, made, sim.seed)
    flown: list[tuple[Inputs | None, Frame]] = []
    for given, _ in zip(inputs(rng, sim), range(steps), strict=False):
        flown.append((given, sim.step(given)))
        recorder.step(*flown[-1])
        recorder.wait_for_room()
    recorder.close("stopped")
    assert recorder.failure == ""
    return flown


def messages(path: Path) -> list[Message]:
    """Return all messages of a recording."""
    return list(Recording(path).messages())


def read_until_error(path: Path) -> tuple[list[Message], RecordingError | None]:
    """Return the messages of a recording before its first error, and the error or None."""
    found: list[Message] = []
    try:
        for message in Recording(path).messages():
            found.append(message)
    except RecordingError as error:
        return found, error
    return found, None


def rewritten(
    source: Path,
    out: Path,
    change: dict[str, bytes],
    *,
    profile: str = "aftdeck",
    leave_out: tuple[str, ...] = (),
    rechained: bool = False,
) -> None:
    """Rewrite a recording with another library.

    Args:
        source: the recording.
        out: the copy.
        change: new data, by topic, for the topic's first message.
        profile: profile of the copy.
        leave_out: topics without messages in the copy.
        rechained: whether the copy gets a new hash chain, as of a forger who rewrites the whole file.
    """
    changes, chain = dict(change), Chain()

    def edit(topic: str, data: bytes) -> Iterator[bytes]:
        if topic not in leave_out:
            yield changes.pop(topic, data)

    def sealed(channel: Declared, log_time: int, data: bytes) -> bytes:
        if channel.topic != "/closing":
            chain.add(channel, log_time, log_time, data)
            return data
        closing = replace(msgspec.json.decode(data, type=Closing), chain="")
        chain.add(channel, log_time, log_time, encode(closing))
        return encode(replace(closing, chain=chain.head()))

    copied(source, out, edit, profile=profile, sealed=sealed if rechained else None)


def copied(
    source: Path,
    out: Path,
    edit: Callable[[str, bytes], Iterator[bytes]],
    *,
    profile: str = "aftdeck",
    sealed: Callable[[Declared, int, bytes], bytes] | None = None,
) -> None:
    """Write a valid copy of a recording with the messages that `edit` returns for each message, by topic and data.

    `sealed` returns the final data of each message of the copy.
    """
    schemas: dict[int, Schema] = {}
    declared: dict[int, Declared] = {}
    channels: dict[int, int] = {}
    with source.open("rb") as file, out.open("wb") as new:
        writer = Writer(new, compression=CompressionType.ZSTD)
        writer.start(profile, "a test")
        for record in StreamReader(file).records:
            if isinstance(record, Schema):
                schemas[record.id] = record
            elif isinstance(record, Channel) and record.id not in channels:
                own = schemas[record.schema_id]
                declared[record.id] = Declared(record.topic, record.message_encoding, own.name, own.encoding, own.data)
                schema = writer.register_schema(own.name, own.encoding, own.data)
                channels[record.id] = writer.register_channel(record.topic, record.message_encoding, schema)
            elif isinstance(record, McapMessage):
                for data in edit(declared[record.channel_id].topic, record.data):
                    final = data if sealed is None else sealed(declared[record.channel_id], record.log_time, data)
                    writer.add_message(channels[record.channel_id], record.log_time, final, record.publish_time)
        finish: Callable[[], None] = writer.finish  # the writer's library has no types
        finish()


def chunks(whole: bytes) -> list[tuple[int, int, int]]:
    """Return offset, type and length of each record of a file."""
    found, at = [], 8
    while at + 9 <= len(whole):
        kind, length = struct.unpack_from("<BQ", whole, at)
        found.append((at, kind, length))
        at += 9 + length
    return found
