"""Recordings for the tests: recorded runs, and copies with changed messages."""

from __future__ import annotations

import functools
import struct
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from mcap.records import Channel
from mcap.records import Message as McapMessage
from mcap.stream_reader import StreamReader
from mcap.writer import CompressionType, Writer

import aftdeck
from aftdeck.errors import RecordingError
from aftdeck.recording.message import Message
from aftdeck.recording.reader import Recording
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
    source: Path, out: Path, change: dict[str, bytes], *, profile: str = "aftdeck", leave_out: tuple[str, ...] = ()
) -> None:
    """Rewrite a recording with another library; `change` maps a topic to new data for its first message."""
    topics: dict[int, str] = {}
    channels: dict[str, int] = {}
    changes = dict(change)
    with source.open("rb") as file, out.open("wb") as new:
        writer = Writer(new, compression=CompressionType.ZSTD)
        writer.start(profile, "a test")
        for record in StreamReader(file).records:
            if isinstance(record, Channel) and record.topic not in channels:
                topics[record.id] = record.topic
                schema = writer.register_schema(record.topic, "jsonschema", b"{}")
                channels[record.topic] = writer.register_channel(record.topic, "json", schema)
            elif isinstance(record, McapMessage):
                topic = topics[record.channel_id]
                if topic not in leave_out:
                    data = changes.pop(topic, record.data)
                    writer.add_message(channels[topic], record.log_time, data, record.publish_time)
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
