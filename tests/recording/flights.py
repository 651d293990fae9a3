"""Recordings of runs with random sticks, and a reader that uses another library."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from mcap.reader import make_reader

from aftdeck.recording.live import Live
from aftdeck.recording.records import Note
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.recording.protobuf import Decoder

NOTE = "manual control"
"""Text of the note."""


class Decoded(NamedTuple):
    """Message as read by the mcap library, decoded by its schema."""

    schema: str
    encoding: str
    time_ns: int
    content: dict[str, Any]


def record_random_sticks(scenario: str, path: Path | None, steps: int, live: Live | None = None) -> list[Frame]:
    """Record a run with random sticks, a change of the mode and a final note; return its frames."""
    loaded = load_scenario(scenario)
    simulation = Simulation(loaded)
    recorder = Recorder(path, loaded, 1, live=live)
    frames = []
    sticks = np.random.default_rng(3).uniform(-1.0, 1.0, (steps // 25 + 1, 6))
    for k in range(steps):
        x, y, z, roll, pitch, yaw = sticks[k // 25].tolist()
        inputs = Inputs(translation=(x, y, z), rotation=(roll, pitch, yaw), mode="END EFF" if k == steps // 2 else None)
        frames.append(simulation.step(inputs))
        recorder.step(inputs, frames[-1])
    recorder.put(Note(frames[-1].time_s, "hand", "caution", NOTE, 0.0))
    recorder.close("stopped")
    assert not recorder.failure
    return frames


def read(path: Path) -> dict[str, list[Decoded]]:
    """Return all messages of a file, by topic."""
    found: dict[str, list[Decoded]] = {}
    decoders: dict[str, Decoder] = {}
    with path.open("rb") as file:
        for schema, channel, message in make_reader(file).iter_messages():
            assert schema is not None
            if schema.encoding == "protobuf":
                decoder = decoders.setdefault(schema.name, Decoder(schema.data, schema.name))
                content = decoder.decode(message.data)
            else:
                content = json.loads(message.data)
            decoded = Decoded(schema.name, channel.message_encoding, message.log_time, content)
            found.setdefault(channel.topic, []).append(decoded)
    return found
