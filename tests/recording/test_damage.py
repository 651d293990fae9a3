"""Files that are cut, flipped or not ours: a sentence or the same messages; never a crash, never less untold."""

from __future__ import annotations

import os
import random
from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest
from mcap.writer import CompressionType, Writer

from aftdeck.errors import RecordingError
from aftdeck.recording.codec import plain
from aftdeck.recording.message import Message
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import Closing, FrameRecord
from aftdeck.recording.replay import verify
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.frame import Event
from aftdeck.simulation.run import Simulation
from tests.recording.flown import as_far, bay, chunks, messages, rewritten

STEPS = 40
FLIPS = 160


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A closed recording in several chunks, a note in it."""
    path = tmp_path_factory.mktemp("whole") / "whole.mcap"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("aftdeck.recording.writer.FLUSH_S", 0.0)
        made = bay()
        sim = Simulation(made)
        recorder = Recorder(path, made, 0)
        for k in range(STEPS):
            recorder.step(None, sim.step())
            if k == STEPS // 2:
                recorder.note(Event(1.0, "hand", "info", "you have the sticks"))
        recorder.close("stopped")
    assert recorder.failure == ""
    assert sum(kind == 6 for _, kind, _ in chunks(path.read_bytes())) > 10
    return path


@pytest.fixture(scope="module")
def unclosed(whole: Path) -> Path:
    """The same as a killed program leaves it: its last chunk whole, and a byte more."""
    data = whole.read_bytes()
    last_chunk = [at for at, kind, _ in chunks(data) if kind == 6][-1]
    path = whole.with_name("unclosed.mcap")
    path.write_bytes(data[: last_chunk + 1])
    return path


def told(path: Path) -> str:
    """What is said of a file that cannot be opened."""
    with pytest.raises(RecordingError) as caught:
        Recording(path)
    text = str(caught.value)
    assert text.startswith(f"{path}: ") and "\n" not in text
    return text.removeprefix(f"{path}: ")


def check_prefix(found: list[Message], all_of_it: list[Message]) -> None:
    assert found == all_of_it[: len(found)]


def test_a_file_cut_anywhere_is_read_as_far_as_it_goes(whole: Path, tmp_path: Path) -> None:
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
            assert told(path) == "was cut short before its first second; there is nothing in it to read"
            continue
        recording = Recording(path)
        found = list(recording.messages())
        check_prefix(found, everything)
        assert len(found) >= last, "a longer file holds less"
        last = len(found)
        assert recording.cut == (not isinstance(found[-1], Closing))
        if end >= data_ends:
            assert found == everything and recording.ended == "stopped"


def test_a_cut_file_is_verified_as_far_as_it_goes(whole: Path, tmp_path: Path) -> None:
    data = whole.read_bytes()
    path = tmp_path / "cut.mcap"
    ends = [at for at, kind, _ in chunks(data) if kind == 6]
    path.write_bytes(data[: ends[-3] + 5])
    verdict = verify(path)
    assert verdict.equal and verdict.cut
    assert 0 < verdict.frames < STEPS
    assert verdict.time_s == pytest.approx(verdict.frames * 0.02)


def flips(data: bytes, count: int, seed: int) -> list[int]:
    """Bits to flip: some anywhere, some in the records' heads, which few bytes are."""
    rng = random.Random(seed)
    heads = [at + d for at, _, _ in chunks(data) for d in range(60) if at + d < len(data)]
    return [8 * rng.randrange(len(data)) + rng.randrange(8) for _ in range(count // 2)] + [
        8 * rng.choice(heads) + rng.randrange(8) for _ in range(count - count // 2)
    ]


def check_flips(source: Path, path: Path, bits: list[int]) -> None:
    data, everything = source.read_bytes(), messages(source)
    wrong = 0
    for bit in bits:
        flipped = bytearray(data)
        flipped[bit // 8] ^= 1 << bit % 8
        path.write_bytes(flipped)
        found, text = as_far(path)
        check_prefix(found, everything)
        if text:
            wrong += 1
            assert text.startswith(f"{path}: ") and "\n" not in text and len(text) < 400
        else:
            assert found == everything, f"bit {bit} makes the flight shorter, and nobody says so"
    assert wrong > len(bits) / 2


def test_a_flipped_bit_is_found_or_does_no_harm(whole: Path, tmp_path: Path) -> None:
    check_flips(whole, tmp_path / "flipped.mcap", flips(whole.read_bytes(), FLIPS, 1))


def test_a_flipped_bit_in_a_cut_file_is_found_or_does_no_harm(unclosed: Path, tmp_path: Path) -> None:
    check_flips(unclosed, tmp_path / "flipped.mcap", flips(unclosed.read_bytes(), FLIPS, 2))


@pytest.mark.slow
@pytest.mark.parametrize("source", ["whole", "unclosed"])
def test_any_flipped_bit_of_a_records_head_is_found_or_does_no_harm(
    source: str, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    path: Path = request.getfixturevalue(source)
    data = path.read_bytes()
    heads = [at for at, kind, _ in chunks(data) if kind in (1, 6, 7, 15)]
    chosen = [heads[0], heads[1], *heads[-4:]]
    bits = [8 * (at + d) + b for at in chosen for d in range(49) for b in range(8) if at + d < len(data)]
    check_flips(path, tmp_path / "flipped.mcap", bits)


@pytest.mark.slow
def test_several_flipped_bytes_are_found_or_do_no_harm(whole: Path, tmp_path: Path) -> None:
    data, everything = whole.read_bytes(), messages(whole)
    rng = random.Random(3)
    path = tmp_path / "flipped.mcap"
    for _ in range(1000):
        broken = bytearray(data)
        at = rng.randrange(len(data))
        broken[at : at + 8] = rng.randbytes(len(broken[at : at + 8]))
        path.write_bytes(broken)
        found, text = as_far(path)
        check_prefix(found, everything)
        assert text or found == everything


def test_a_stretch_taken_out_is_found(whole: Path, tmp_path: Path) -> None:
    data = whole.read_bytes()
    at, _, length = [record for record in chunks(data) if record[1] == 6][5]
    path = tmp_path / "gap.mcap"
    path.write_bytes(data[:at] + data[at + 9 + length :])
    found, text = as_far(path)
    check_prefix(found, messages(whole))
    assert "is damaged after" in text and "follows step" in text


@pytest.mark.parametrize("topic", ["/inputs", "/frames"])
def test_a_step_without_its_inputs_or_its_frame_is_damage(whole: Path, tmp_path: Path, topic: str) -> None:
    path = tmp_path / "without.mcap"
    rewritten(whole, path, {}, leave_out=(topic,))
    with pytest.raises(RecordingError, match=r"is damaged after 0.0[02] s: step (1 has no inputs|2 follows step 0)"):
        list(Recording(path).steps())


def test_a_note_is_read_where_it_was_written(whole: Path) -> None:
    (note,) = Recording(whole).notes()
    assert (note.kind, note.text) == ("hand", "you have the sticks")


# --- files that are no recordings -------------------------------------------------------------------------


def test_a_missing_file_is_told(tmp_path: Path) -> None:
    assert told(tmp_path / "none.mcap") == "cannot be read: No such file or directory"


def test_a_folder_is_told(tmp_path: Path) -> None:
    assert told(tmp_path) == "is a folder, no recording"


def test_a_pipe_is_told_and_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.mcap")
    assert told(tmp_path / "pipe.mcap") == "is no file, no recording"


@pytest.mark.parametrize("data", [b"title = 'x'\n", b"\x89MCAP1\r\n" + bytes(100), bytes(1000), b"\x89PNG\r\n\x1a\n"])
def test_another_kind_of_file_is_told(tmp_path: Path, data: bytes) -> None:
    (tmp_path / "other").write_bytes(data)
    assert told(tmp_path / "other") == "is no MCAP file, so no recording of Aftdeck"


def test_an_empty_file_is_told(tmp_path: Path) -> None:
    (tmp_path / "empty.mcap").touch()
    assert "nothing in it to read" in told(tmp_path / "empty.mcap")


@pytest.mark.parametrize("packing", list(CompressionType))
@pytest.mark.parametrize("chunked", [True, False])
@pytest.mark.parametrize("topic", ["/camera", "/frames", "/opening"])
def test_an_mcap_file_by_others_is_told(tmp_path: Path, topic: str, chunked: bool, packing: CompressionType) -> None:
    if packing is CompressionType.LZ4:
        packing = CompressionType.NONE  # its library is another
    path = tmp_path / "other.mcap"
    with path.open("wb") as file:
        writer = Writer(file, compression=packing, use_chunking=chunked)
        writer.start("ros2", "another program")
        schema = writer.register_schema("thing", "jsonschema", b"{}")
        channel = writer.register_channel(topic, "json", schema)
        writer.add_message(channel, 0, b'{"format": 1, "x": [1, 2]}', 0)
        finish: Callable[[], None] = writer.finish  # without types in its library
        finish()
    assert told(path) == "is an MCAP file, but no recording of Aftdeck"


def test_a_file_of_our_profile_without_an_opening_is_told(whole: Path, tmp_path: Path) -> None:
    rewritten(whole, tmp_path / "headless.mcap", {}, leave_out=("/opening",))
    assert "is damaged" in told(tmp_path / "headless.mcap")


def test_a_newer_layout_is_told_whatever_else_is_in_it(whole: Path, tmp_path: Path) -> None:
    newer = msgspec.json.encode({"format": 3, "version": "7.1.0", "begins": {"with": "something new"}})
    rewritten(whole, tmp_path / "newer.mcap", {"/opening": newer})
    assert told(tmp_path / "newer.mcap") == "has layout 3 of Aftdeck 7.1.0; this one reads up to 2"


def test_a_message_that_is_not_understood_is_told_with_its_channel(whole: Path, tmp_path: Path) -> None:
    first = next(m for m in messages(whole) if isinstance(m, FrameRecord))
    odd = msgspec.json.encode({**plain(first), "angles": "all of them"})
    rewritten(whole, tmp_path / "odd.mcap", {"/frames": odd})
    _, text = as_far(tmp_path / "odd.mcap")
    assert "a message in /frames is not understood" in text


def test_fields_of_a_later_version_of_the_same_layout_are_passed_over(whole: Path, tmp_path: Path) -> None:
    start = msgspec.to_builtins(Recording(whole).opening)
    rewritten(whole, tmp_path / "later.mcap", {"/opening": msgspec.json.encode({**start, "weather": "fine"})})
    assert verify(tmp_path / "later.mcap").equal
