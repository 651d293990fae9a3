"""Damaged, cut and foreign files: each gives an error of the right kind, or the unchanged messages."""

from __future__ import annotations

import os
import random
import re
import struct
from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest
from mcap.writer import CompressionType, Writer

from aftdeck.errors import RecordingError
from aftdeck.recording.plain_form import plain
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import Closing, FrameRecord, Note
from aftdeck.recording.replay import verify
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.run import Simulation
from tests.each import number
from tests.recording.damaging import check_flips, check_prefix, flips
from tests.recording.flown import bay, chunks, messages, read_until_error, rewritten

STEPS = 40
NOTE = "manual control"
FLIPS = 160


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Complete recording in several chunks, with a note."""
    path = tmp_path_factory.mktemp("whole") / "whole.mcap"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("aftdeck.recording.writer.FLUSH_S", 0.0)
        made = bay()
        sim = Simulation(made)
        recorder = Recorder(path, made, 0)
        for k in range(STEPS):
            recorder.step(None, sim.step())
            if k == STEPS // 2:
                recorder.put(Note(1.0, "hand", "info", NOTE, 1.0))
        recorder.close("stopped")
    assert recorder.failure == ""
    assert sum(kind == 6 for _, kind, _ in chunks(path.read_bytes())) > 10
    return path


@pytest.fixture(scope="module")
def unclosed(whole: Path) -> Path:
    """The same recording up to the first byte of its last chunk, like the recording of a killed program."""
    data = whole.read_bytes()
    last_chunk = [at for at, kind, _ in chunks(data) if kind == 6][-1]
    path = whole.with_name("unclosed.mcap")
    path.write_bytes(data[: last_chunk + 1])
    return path


def fault(path: Path) -> str:
    """Open a file, and return the error's `fault`; check that the error's message is one line and names the file."""
    with pytest.raises(RecordingError) as caught:
        Recording(path)
    text = str(caught.value)
    assert text.startswith(f"{path}: ") and "\n" not in text
    return caught.value.fault


def test_file_cut_anywhere_is_read_up_to_the_cut(whole: Path, tmp_path: Path) -> None:
    data, everything = whole.read_bytes(), messages(whole)
    records = chunks(data)
    edges = [at + d for at, _, _ in records for d in (-1, 0, 1, 8, 9, 10)]
    rng = random.Random(4)
    path = tmp_path / "cut.mcap"
    opening_ends = next(at + 9 + length for at, kind, length in records if kind == 6)
    data_ends = next(at + 9 + length for at, kind, length in records if kind == 15)
    last = 0
    for end in sorted({*range(100), *rng.sample(edges, 60), *(rng.randrange(len(data)) for _ in range(60))}):
        path.write_bytes(data[:end])
        if end < opening_ends:
            assert fault(path) == "empty"
            continue
        recording = Recording(path)
        found = list(recording.messages())
        check_prefix(found, everything)
        assert len(found) >= last, "a longer file has fewer messages"
        last = len(found)
        assert recording.cut == (not isinstance(found[-1], Closing))
        if end >= data_ends:
            assert found == everything and recording.ended == "stopped"


def test_cut_file_is_verified_up_to_the_cut(whole: Path, tmp_path: Path) -> None:
    data = whole.read_bytes()
    path = tmp_path / "cut.mcap"
    ends = [at for at, kind, _ in chunks(data) if kind == 6]
    path.write_bytes(data[: ends[-3] + 5])
    verdict = verify(path)
    assert verdict.equal and verdict.cut
    assert 0 < verdict.frames < STEPS
    assert verdict.time_s == pytest.approx(verdict.frames * 0.02)


def test_flipped_bit_is_an_error_or_has_no_effect(whole: Path, tmp_path: Path) -> None:
    check_flips(whole, tmp_path / "flipped.mcap", flips(whole.read_bytes(), FLIPS, 1))


def test_flipped_bit_in_a_cut_file_is_an_error_or_has_no_effect(unclosed: Path, tmp_path: Path) -> None:
    check_flips(unclosed, tmp_path / "flipped.mcap", flips(unclosed.read_bytes(), FLIPS, 2))


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("source", ["whole", "unclosed"])
def test_every_bit_of_a_record_start_is_checked_or_has_no_effect(
    source: str, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    path: Path = request.getfixturevalue(source)
    data = path.read_bytes()
    starts = [at for at, kind, _ in chunks(data) if kind in (1, 6, 7, 15)]
    chosen = [starts[0], starts[1], *starts[-number(1, 4) :]]
    bits = [8 * (at + d) + b for at in chosen for d in range(49) for b in range(8) if at + d < len(data)]
    check_flips(path, tmp_path / "flipped.mcap", bits)


@pytest.mark.slow
def test_several_changed_bytes_are_an_error_or_have_no_effect(whole: Path, tmp_path: Path) -> None:
    data, everything = whole.read_bytes(), messages(whole)
    rng = random.Random(3)
    path = tmp_path / "flipped.mcap"
    for _ in range(1000):
        broken = bytearray(data)
        at = rng.randrange(len(data))
        broken[at : at + 8] = rng.randbytes(len(broken[at : at + 8]))
        path.write_bytes(broken)
        found, error = read_until_error(path)
        check_prefix(found, everything)
        assert error or found == everything


def test_missing_chunk_is_damage(whole: Path, tmp_path: Path) -> None:
    data = whole.read_bytes()
    first, after = [at for at, kind, _ in chunks(data) if kind == 6][5:7]
    path = tmp_path / "gap.mcap"
    path.write_bytes(data[:first] + data[after:])  # without the chunk and the indexes of its messages
    found, error = read_until_error(path)
    check_prefix(found, messages(whole))
    last = max(m.tick for m in found if isinstance(m, FrameRecord))
    assert error is not None and error.fault == "damaged"
    assert re.search(rf"step (\d+) .*step {last}$", str(error))


def test_note_is_read(whole: Path) -> None:
    (note,) = Recording(whole).notes()
    assert (note.kind, note.text) == ("hand", NOTE)


# --- files that are not recordings -------------------------------------------------------------------------


def test_missing_file_is_unreadable(tmp_path: Path) -> None:
    assert fault(tmp_path / "none.mcap") == "unreadable"


def test_folder_is_unreadable(tmp_path: Path) -> None:
    assert fault(tmp_path) == "unreadable"


def test_pipe_is_unreadable_without_waiting(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.mcap")
    assert fault(tmp_path / "pipe.mcap") == "unreadable"


@pytest.mark.parametrize("data", [b"title = 'x'\n", b"\x89MCAP1\r\n" + bytes(100), bytes(1000), b"\x89PNG\r\n\x1a\n"])
def test_file_of_another_format_is_foreign(tmp_path: Path, data: bytes) -> None:
    (tmp_path / "other").write_bytes(data)
    assert fault(tmp_path / "other") == "foreign"


def test_empty_file_is_empty(tmp_path: Path) -> None:
    (tmp_path / "empty.mcap").touch()
    assert fault(tmp_path / "empty.mcap") == "empty"


@pytest.mark.parametrize("packing", list(CompressionType))
@pytest.mark.parametrize("chunked", [True, False])
@pytest.mark.parametrize("topic", ["/camera", "/frames", "/opening"])
def test_mcap_file_of_another_program_is_foreign(
    tmp_path: Path, topic: str, chunked: bool, packing: CompressionType
) -> None:
    path = tmp_path / "other.mcap"
    with path.open("wb") as file:
        writer = Writer(file, compression=packing, use_chunking=chunked)
        writer.start("ros2", "another program")
        schema = writer.register_schema("thing", "jsonschema", b"{}")
        channel = writer.register_channel(topic, "json", schema)
        writer.add_message(channel, 0, b'{"format": 1, "x": [1, 2]}', 0)
        finish: Callable[[], None] = writer.finish  # the mcap library has no type annotations
        finish()
    assert fault(path) == "foreign"


@pytest.mark.parametrize(("layout", "version", "age"), [(3, "7.1.0", "newer layout"), (1, "0.1.0", "older layout")])
def test_other_layout_is_rejected_with_its_version(
    whole: Path, tmp_path: Path, layout: int, version: str, age: str
) -> None:
    opening = msgspec.json.encode({"format": layout, "version": version, "begins": {"with": "something else"}})
    rewritten(whole, tmp_path / "other.mcap", {"/opening": opening})
    assert fault(tmp_path / "other.mcap") == age
    with pytest.raises(RecordingError, match=f"layout {layout} of Aftdeck {version}"):
        Recording(tmp_path / "other.mcap")


@pytest.mark.parametrize(
    "field", ["angles", "rates", "angles_commanded", "rates_commanded", "rate_limits", "zones", "master"]
)
@pytest.mark.parametrize("number", [0, 5, 7])
def test_frame_with_another_number_of_joints_is_damage(whole: Path, tmp_path: Path, field: str, number: int) -> None:
    first = plain(next(m for m in messages(whole) if isinstance(m, FrameRecord)))
    of = first["work"] if field == "master" else first
    of[field] = [0] * number
    rewritten(whole, tmp_path / "odd.mcap", {"/frames": msgspec.json.encode(first)})
    with pytest.raises(RecordingError, match="each of 6 joints") as caught:
        list(Recording(tmp_path / "odd.mcap").messages())
    assert caught.value.fault == "damaged"


def test_invalid_message_is_damage_and_names_its_channel(whole: Path, tmp_path: Path) -> None:
    first = next(m for m in messages(whole) if isinstance(m, FrameRecord))
    odd = msgspec.json.encode({**plain(first), "angles": "all of them"})
    rewritten(whole, tmp_path / "odd.mcap", {"/frames": odd})
    _, error = read_until_error(tmp_path / "odd.mcap")
    assert error is not None and error.fault == "damaged" and "/frames" in str(error)


def test_unknown_fields_of_the_same_layout_are_ignored(whole: Path, tmp_path: Path) -> None:
    start = msgspec.to_builtins(Recording(whole).opening)
    rewritten(
        whole,
        tmp_path / "later.mcap",
        {"/opening": msgspec.json.encode({**start, "weather": "fine"})},
        rechained=True,
    )
    assert verify(tmp_path / "later.mcap").equal


# --- the index, by which other readers find messages --------------------------------------------------------


def reads_as_damage(data: bytes, path: Path) -> None:
    path.write_bytes(data)
    _, error = read_until_error(path)
    assert error is not None and error.fault == "damaged"


def test_forged_index_of_chunks_is_damage(whole: Path, tmp_path: Path) -> None:
    data = whole.read_bytes()
    indexes = [at for at, kind, _ in chunks(data) if kind == 8]
    for at in indexes[:3]:
        for field in range(9, 9 + 4 * 8, 8):  # times, offset and length of the chunk
            forged = bytearray(data)
            forged[at + field] ^= 1
            reads_as_damage(bytes(forged), tmp_path / "forged.mcap")
    length = struct.unpack_from("<Q", data, indexes[0] + 1)[0]
    shorter = bytearray(data[: indexes[0]] + data[indexes[0] + 9 + length :])
    reads_as_damage(bytes(shorter), tmp_path / "forged.mcap")


def test_second_summary_behind_the_first_is_damage(whole: Path, tmp_path: Path) -> None:
    data = whole.read_bytes()
    at = next(at for at, kind, _ in chunks(data) if kind == 15) + 13
    reads_as_damage(data + data[at:], tmp_path / "forged.mcap")
    footer = next(at for at, kind, _ in chunks(data) if kind == 2)
    forged = bytearray(data)
    struct.pack_into("<Q", forged, footer + 9, 100)  # the summary begins elsewhere
    reads_as_damage(bytes(forged), tmp_path / "forged.mcap")


def test_forged_schema_in_the_summary_is_damage(whole: Path, tmp_path: Path) -> None:
    data = whole.read_bytes()
    end = next(at for at, kind, _ in chunks(data) if kind == 15)
    at, _, length = next(record for record in chunks(data) if record[0] > end and record[1] == 3)
    forged = bytearray(data)
    forged[at + 9 + length - 3] ^= 1
    reads_as_damage(bytes(forged), tmp_path / "forged.mcap")
