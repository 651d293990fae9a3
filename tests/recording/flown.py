"""Flights into session files, and files put together message by message, for tests."""

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
    """A scenario over the bay with more lines of TOML, loaded once."""
    return scenario(extra=extra, name=name)


def recorded(
    path: Path, made: Scenario, given: Iterator[Inputs | None], steps: int, ended: Ended = "stopped"
) -> list[tuple[Inputs | None, Frame]]:
    """Fly a number of steps into a file; what was flown and what came of it."""
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


def random_flight(
    path: Path, seed: int, steps: int, extra: str = "", name: str = "test"
) -> list[tuple[Inputs | None, Frame]]:
    """Fly with random sticks, switches, targets and holds from a random pose, with a payload or none, into a file."""
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
    """All of a recording's messages."""
    return list(Recording(path).messages())


def as_far(path: Path) -> tuple[list[Message], str]:
    """A recording's messages as far as it can be read, and what was then said."""
    found: list[Message] = []
    try:
        for message in Recording(path).messages():
            found.append(message)
    except RecordingError as error:
        return found, str(error)
    return found, ""


def rewritten(
    source: Path, out: Path, change: dict[str, bytes], *, profile: str = "aftdeck", leave_out: tuple[str, ...] = ()
) -> None:
    """A recording written anew by another library, with the first message of some topics changed."""
    topics: dict[int, str] = {}
    channels: dict[str, int] = {}
    left = dict(change)
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
                    data = left.pop(topic, record.data)
                    writer.add_message(channels[topic], record.log_time, data, record.publish_time)
        finish: Callable[[], None] = writer.finish  # without types in its library
        finish()


def chunks(whole: bytes) -> list[tuple[int, int, int]]:
    """Where a file's records begin, their kinds and lengths."""
    found, at = [], 8
    while at + 9 <= len(whole):
        kind, length = struct.unpack_from("<BQ", whole, at)
        found.append((at, kind, length))
        at += 9 + length
    return found
