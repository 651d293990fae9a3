"""Recordings for the tests: recorded runs, and copies with changed messages."""

from __future__ import annotations

import functools
import struct
from collections.abc import Callable, Iterable, Iterator
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
from aftdeck.recording.channels import VIEWED
from aftdeck.recording.codec import encode
from aftdeck.recording.content import Ended
from aftdeck.recording.message import Message
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import (
    CHANNELS,
    Closing,
    ControllerRecord,
    ControllersRecord,
    DelayRecord,
    LightRecord,
    Note,
    Shown,
)
from aftdeck.recording.writer import Recorder
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
        recorder.take_turns()
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
        recorder.take_turns()
    recorder.close("stopped")
    assert recorder.failure == ""
    return flown


STEPS = 12
"""Number of steps of `record_every_channel`."""


def record_every_channel(path: Path) -> None:
    """Record a run of `STEPS` steps with at least one message in every channel."""
    made = bay()
    sim = aftdeck.Simulation(made)
    recorder = Recorder(path, made, sim.seed, real_time=True)
    recorder.put(LightRecord(0.0, "night", (), ()))
    keyboard = ControllerRecord("keyboard", "keys", 0.1, 0.3, ("KeyW +X",), (0.0,))
    recorder.put(ControllersRecord(0.0, (keyboard,), 0.0))
    recorder.put(Shown(0.0, ("A",), ("B", "C")))
    for k in range(STEPS):
        inputs = Inputs((0.5, -0.2, 0.1), (0.0, 0.3, 0.0), mode="END EFF" if k == 3 else None)
        recorder.step(inputs, sim.step(inputs), 40.0)
    recorder.put(Note(0.2, "hand", "info", "manual control", 0.2))
    recorder.put(DelayRecord(STEPS, 0.4, 0.4, 0.15, 0.4))
    recorder.close("stopped")
    assert recorder.failure == "" and recorder.chain
    topics = {entry.channel.topic for entry in Recording(path).entries()}
    assert topics == {*CHANNELS, *VIEWED}


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
    changes = dict(change)

    def edit(topic: str, data: bytes) -> Iterator[bytes]:
        if topic not in leave_out:
            yield changes.pop(topic, data)

    copied(source, out, edit, profile=profile, rechained=rechained)


def copied(
    source: Path,
    out: Path,
    edit: Callable[[str, bytes], Iterator[bytes]],
    *,
    profile: str = "aftdeck",
    rechained: bool = False,
    after: Iterable[tuple[str, bytes]] = (),
) -> None:
    """Write a valid copy of a recording with the messages that `edit` returns for each message, by topic and data.

    `after` are additional messages at the end; the other arguments are those of `rewritten`.
    """
    chain = Chain()
    with out.open("wb") as new:
        writer = Writer(new, compression=CompressionType.ZSTD)
        writer.start(profile, "a test")
        channels: dict[str, int] = {}
        last = 0
        for channel, time_ns, data in raw_messages(source):
            if channel.topic not in channels:
                schema = writer.register_schema(channel.schema, channel.schema_encoding, channel.schema_data)
                channels[channel.topic] = writer.register_channel(channel.topic, channel.encoding, schema)
            for edited in edit(channel.topic, data):
                final = _chained(chain, channel, time_ns, edited) if rechained else edited
                writer.add_message(channels[channel.topic], time_ns, final, time_ns)
            last = time_ns
        for topic, data in after:
            writer.add_message(channels[topic], last, data, last)
        finish: Callable[[], None] = writer.finish  # the writer's library has no types
        finish()


def raw_messages(source: Path) -> Iterator[tuple[Declared, int, bytes]]:
    """Yield channel, time and data of all messages, as another library reads them."""
    schemas: dict[int, Schema] = {}
    channels: dict[int, Declared] = {}
    with source.open("rb") as file:
        for record in StreamReader(file).records:
            if isinstance(record, Schema):
                schemas[record.id] = record
            elif isinstance(record, Channel):
                own = schemas[record.schema_id]
                channels[record.id] = Declared(record.topic, record.message_encoding, own.name, own.encoding, own.data)
            elif isinstance(record, McapMessage):
                yield channels[record.channel_id], record.log_time, record.data


def _chained(chain: Chain, channel: Declared, time_ns: int, data: bytes) -> bytes:
    """Add a message to a new chain; return the message, a footer with the chain's head."""
    if channel.topic != "/closing":
        chain.add(channel, time_ns, time_ns, data)
        return data
    closing = msgspec.json.decode(data, type=Closing)
    chain.add(channel, time_ns, time_ns, encode(replace(closing, chain="")))
    return encode(replace(closing, chain=chain.head()))


def chunks(whole: bytes) -> list[tuple[int, int, int]]:
    """Return offset, type and length of each record of a file."""
    found, at = [], 8
    while at + 9 <= len(whole):
        kind, length = struct.unpack_from("<BQ", whole, at)
        found.append((at, kind, length))
        at += 9 + length
    return found
