"""Recordings read by another library: schemas, summary, indexes."""

from __future__ import annotations

import itertools
from collections import Counter
from pathlib import Path
from typing import Any

import msgspec
import pytest
from mcap.reader import make_reader
from mcap.records import Channel, Message, Schema, Statistics

import aftdeck
from aftdeck.recording.records import CHANNELS, Note
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.run import Simulation
from tests.recording.flown import bay, record_random_run

STEPS = 300
KINDS: dict[str, tuple[type, ...]] = {
    "number": (int, float),
    "integer": (int,),
    "string": (str,),
    "boolean": (bool,),
}


def disagreements(value: Any, schema: dict[str, Any], where: str = "") -> list[str]:
    """Return the locations at which a value contradicts a simple JSON schema; null counts as absent."""
    if value is None:
        return []
    kind = schema["type"]
    if kind == "object":
        properties = schema["properties"]
        if not isinstance(value, dict):
            return [f"{where}: not an object"]
        found = [f"{where}.{name}: not in the schema" for name in value.keys() - properties.keys()]
        shared = value.keys() & properties.keys()
        return found + [d for n in shared for d in disagreements(value[n], properties[n], f"{where}.{n}")]
    if kind == "array":
        if not isinstance(value, list):
            return [f"{where}: not an array"]
        return [d for i, x in enumerate(value) for d in disagreements(x, schema["items"], f"{where}[{i}]")]
    right = isinstance(value, KINDS[kind]) and (kind == "boolean" or not isinstance(value, bool))
    if not right or ("enum" in schema and value not in schema["enum"]):
        return [f"{where}: {value!r} is not a {kind} {schema.get('enum', '')}"]
    return []


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recording of a run with a payload, targets and holds."""
    path = tmp_path_factory.mktemp("mcap") / "flight.mcap"
    record_random_run(path, 5, STEPS)
    return path


def own(path: Path) -> list[tuple[Schema | None, Channel, Message]]:
    """Return the messages of Aftdeck's own channels."""
    with path.open("rb") as stream:
        return [item for item in make_reader(stream, validate_crcs=True).iter_messages() if item[1].topic in CHANNELS]


def test_every_message_agrees_with_its_channels_schema(file: Path) -> None:
    seen: Counter[str] = Counter()
    for schema, channel, message in own(file):
        assert schema is not None
        assert (schema.encoding, channel.message_encoding) == ("jsonschema", "json")
        plain = msgspec.json.decode(schema.data)
        assert plain["title"] == schema.name == f"aftdeck.{CHANNELS[channel.topic][0].__name__}"
        assert disagreements(msgspec.json.decode(message.data), plain) == []
        seen[channel.topic] += 1
    assert seen == {"/opening": 1, "/inputs": STEPS, "/frames": STEPS, "/closing": 1}


def test_disagreements_finds_each_contradiction() -> None:
    schema = {"type": "object", "properties": {"a": {"type": "array", "items": {"type": "integer"}}}}
    assert disagreements({"a": [1, 2]}, schema) == []
    assert len(disagreements({"a": [1, "2", 2.5, True], "b": 1}, schema)) == 4


def test_note_agrees_with_its_schema(tmp_path: Path) -> None:
    made = bay()
    recorder = Recorder(tmp_path / "note.mcap", made, 0)
    recorder.step(None, Simulation(made).step())
    recorder.put(Note(0.02, "hand", "warning", "manual control", 0.0))
    recorder.close("restarted")
    (note,) = [item for item in own(tmp_path / "note.mcap") if item[1].topic == "/notes"]
    assert note[0] is not None
    content = msgspec.json.decode(note[2].data)
    assert disagreements(content, msgspec.json.decode(note[0].data)) == []
    assert (content["text"], content["level"]) == ("manual control", "warning")


def test_summary_has_the_number_of_messages(file: Path) -> None:
    with file.open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        assert reader.get_header().profile == "aftdeck"
        summary = reader.get_summary()
        counted = Counter(channel.id for _, channel, _ in reader.iter_messages())
    assert summary is not None
    statistics = summary.statistics
    assert isinstance(statistics, Statistics)
    assert statistics.channel_message_counts == counted
    assert statistics.message_count == sum(counted.values())
    assert statistics.chunk_count == len(summary.chunk_indexes) >= 2
    assert summary.channels.keys() == counted.keys()


def test_messages_are_found_by_time_with_the_index(file: Path) -> None:
    with file.open("rb") as stream:
        reader = make_reader(stream)
        summary = reader.get_summary()
        assert summary is not None and summary.statistics is not None
        began = summary.statistics.message_start_time
        first, end = (began + 1_990_000_000, began + 2_990_000_000)
        found = [
            msgspec.json.decode(message.data)["tick"]
            for _, _, message in reader.iter_messages(["/frames"], starting_at=first, ending_before=end)
        ]
    assert found == list(range(100, 150))


def test_log_times_are_the_start_plus_simulated_time(file: Path) -> None:
    messages = own(file)
    began = messages[0][2].log_time
    for _, channel, message in messages:
        if channel.topic in ("/inputs", "/frames"):
            tick = msgspec.json.decode(message.data)["tick"]
            assert message.log_time - began == round(round(tick * 0.02, 9) * 1e9)
    assert all(a[2].log_time <= b[2].log_time for a, b in itertools.pairwise(messages))


def test_header_has_every_text_of_the_run(file: Path) -> None:
    opening = msgspec.json.decode(own(file)[0][2].data)
    arm = aftdeck.load_arm("srms").model
    assert opening["arm_text"] == arm.text
    assert arm.shapes is not None and opening["shapes_text"] == arm.shapes.text
    assert opening["shapes_file"] == "srms.shapes.toml"
