"""Flights by random sticks, recorded for the tests."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from mcap.reader import make_reader

from aftdeck.recording.live import Live
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.frame import Event, Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.recording.protobuf import Decoder


class Seen(NamedTuple):
    """A message as the mcap library reads it, decoded by the schema beside it."""

    schema: str
    encoding: str
    time_ns: int
    content: dict[str, Any]


def fly(scenario: str, path: Path | None, steps: int, live: Live | None = None) -> list[Frame]:
    """Fly by random sticks, half way in another mode, and record it; a note is written at the end."""
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
    recorder.note(Event(frames[-1].time_s, "hand", "caution", "you have the sticks"))
    recorder.close("stopped")
    assert not recorder.failure
    return frames


def read(path: Path) -> dict[str, list[Seen]]:
    """All messages of a file, by topic."""
    seen: dict[str, list[Seen]] = {}
    decoders: dict[str, Decoder] = {}
    with path.open("rb") as file:
        for schema, channel, message in make_reader(file).iter_messages():
            assert schema is not None
            if schema.encoding == "protobuf":
                decoder = decoders.setdefault(schema.name, Decoder(schema.data, schema.name))
                content = decoder.decode(message.data)
            else:
                content = json.loads(message.data)
            told = Seen(schema.name, channel.message_encoding, message.log_time, content)
            seen.setdefault(channel.topic, []).append(told)
    return seen
