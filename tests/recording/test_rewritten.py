"""Recordings written again by other programs: read and verified as the original, or named as incomplete copies."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from mcap.writer import CompressionType, IndexType

from aftdeck.errors import AftdeckError, RecordingError
from aftdeck.export.flight import read_flight
from aftdeck.recording.reader import Entry, Recording
from aftdeck.recording.replay import Verdict, verify
from aftdeck.station.playback.store import PlaybackStore
from tests.each import each, seeds
from tests.recording.damaging import check_flips, check_prefix, flipped, flips
from tests.recording.flown import STEPS, chunks, copied, messages, read_until_error, rewritten
from tests.recording.writings import SDKS, each_setting, random_settings, written, written_by_sdk

pytestmark = pytest.mark.usefixtures("scenarios_built_once")
WITHOUT_CHUNKS = {"use_chunking": False, "enable_data_crcs": True}
WITHOUT_CRCS = {"use_chunking": False, "enable_crcs": False}
LZ4 = {"compression": CompressionType.LZ4, "chunk_size": 20_000, "enable_data_crcs": True}
_verify = functools.lru_cache(verify)


def entries(path: Path) -> list[Entry]:
    return list(Recording(path).entries())


def check_copy(whole: Path, copy: Path) -> None:
    assert entries(copy) == entries(whole)
    assert verify(copy) == _verify(whole)


def fault(path: Path, read: Callable[[Path], Any]) -> tuple[str, str]:
    """Return the cause of the error with which a file is rejected, and its sentence."""
    with pytest.raises(RecordingError) as caught:
        read(path)
    text = str(caught.value)
    assert text.startswith(f"{path}: ") and "\n" not in text
    return caught.value.fault, text


def test_original_has_a_verdict_that_all_copies_can_share(whole: Path) -> None:
    assert _verify(whole).equal and _verify(whole).chain == "unbroken"


@each("settings", each_setting)
def test_copy_of_the_mcap_library_is_as_the_original(whole: Path, tmp_path: Path, settings: dict[str, Any]) -> None:
    check_copy(whole, written(whole, tmp_path / "copy.mcap", settings))


@each("seed", seeds(20, 2000))
def test_copy_with_random_settings_is_as_the_original(whole: Path, tmp_path: Path, seed: int) -> None:
    check_copy(whole, written(whole, tmp_path / "copy.mcap", random_settings(seed)))


@each("name", SDKS)
def test_copy_of_the_foxglove_library_is_as_the_original(whole: Path, tmp_path: Path, name: str) -> None:
    check_copy(whole, written_by_sdk(whole, tmp_path / f"{name}.mcap", SDKS[name]))


@pytest.mark.parametrize("settings", [{}, WITHOUT_CHUNKS])
def test_attachments_metadata_and_a_missing_profile_change_nothing(
    whole: Path, tmp_path: Path, settings: dict[str, Any]
) -> None:
    check_copy(whole, written(whole, tmp_path / "copy.mcap", settings, profile="", extras=True))


@pytest.mark.parametrize("settings", [LZ4, WITHOUT_CHUNKS, WITHOUT_CRCS])
def test_copy_can_be_played_and_exported(whole: Path, tmp_path: Path, settings: dict[str, Any]) -> None:
    copy = written(whole, tmp_path / "copy.mcap", settings)
    with PlaybackStore(copy) as store:
        assert store.ticks == STEPS
    assert read_flight(copy).records == read_flight(whole).records


# --- copies that are not the whole recording ------------------------------------------------------------------


@pytest.mark.parametrize("topic", ["/opening", "/inputs", "/frames"])
def test_copy_without_a_needed_channel_is_valid_and_names_it(whole: Path, tmp_path: Path, topic: str) -> None:
    rewritten(whole, tmp_path / "part.mcap", {}, leave_out=(topic,))
    cause, text = fault(tmp_path / "part.mcap", verify)
    assert cause == "rewritten" and f"left out {topic};" in text


def test_copy_without_inputs_can_be_played(whole: Path, tmp_path: Path) -> None:
    rewritten(whole, tmp_path / "part.mcap", {}, leave_out=("/inputs",))
    with PlaybackStore(tmp_path / "part.mcap") as store:
        assert store.ticks == STEPS


def test_copy_without_a_step_says_which(whole: Path, tmp_path: Path) -> None:
    ticks = iter(range(1, STEPS + 1))

    def edit(topic: str, data: bytes) -> Iterator[bytes]:
        if topic != "/inputs" or next(ticks) != 5:
            yield data

    copied(whole, tmp_path / "part.mcap", edit)
    cause, text = fault(tmp_path / "part.mcap", verify)
    assert cause == "rewritten" and "step 5" in text


@pytest.mark.parametrize("topic", ["/notes", "/opening"])
def test_message_after_the_footer_is_not_of_the_recorder(whole: Path, tmp_path: Path, topic: str) -> None:
    late = next(e.data for e in entries(whole) if e.channel.topic == topic)

    def edit(found: str, data: bytes) -> Iterator[bytes]:
        if found != topic or topic == "/opening":
            yield data

    copied(whole, tmp_path / "late.mcap", edit, after=((topic, late),))
    cause, text = fault(tmp_path / "late.mcap", verify)
    assert cause == "rewritten" and topic in text


def test_copy_in_the_order_of_channels_says_that_messages_were_moved(whole: Path, tmp_path: Path) -> None:
    by_channel = sorted(entries(whole), key=lambda entry: (entry.log_time, entry.channel.topic))
    after = tuple((entry.channel.topic, entry.data) for entry in by_channel)
    copied(whole, tmp_path / "moved.mcap", lambda _topic, _data: iter(()), after=after)
    cause, text = fault(tmp_path / "moved.mcap", verify)
    assert cause == "rewritten" and "moved" in text


def test_copy_without_channels_for_viewers_names_them(whole: Path, tmp_path: Path) -> None:
    rewritten(whole, tmp_path / "part.mcap", {}, leave_out=("/tf", "/log"))
    verdict = verify(tmp_path / "part.mcap")
    assert not verdict.equal and verdict.chain == "broken" and verdict.different == 0
    assert {change.channel for change in verdict.changes} == {"/tf", "/log"}


# --- damaged copies -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("settings", [LZ4, WITHOUT_CHUNKS, WITHOUT_CRCS])
def test_copy_cut_anywhere_is_read_up_to_the_cut(whole: Path, tmp_path: Path, settings: dict[str, Any]) -> None:
    data = written(whole, tmp_path / "copy.mcap", settings).read_bytes()
    everything, path, last = messages(whole), tmp_path / "cut.mcap", 0
    edges = [at + d for at, _, _ in chunks(data) for d in (-1, 0, 1, 9)]
    for end in sorted({*edges[:: len(edges) // 60], *range(0, len(data), len(data) // 40)}):
        path.write_bytes(data[:end])
        found, error = read_until_error(path)
        check_prefix(found, everything)
        assert (error is None and found) or (error and error.fault == "empty" and not found)
        assert len(found) >= last, "a longer file has fewer messages"
        last = len(found)
    assert last == len(everything)


@pytest.mark.parametrize("settings", [LZ4, WITHOUT_CHUNKS, {"enable_crcs": False, "enable_data_crcs": True}])
def test_flipped_bit_of_a_copy_is_an_error_or_has_no_effect(
    whole: Path, tmp_path: Path, settings: dict[str, Any]
) -> None:
    copy = written(whole, tmp_path / "copy.mcap", settings)
    check_flips(copy, tmp_path / "flipped.mcap", flips(copy.read_bytes(), 60, 1))


def test_flipped_bit_of_a_copy_without_crcs_breaks_the_hash_chain(whole: Path, tmp_path: Path) -> None:
    data, path = written(whole, tmp_path / "copy.mcap", WITHOUT_CRCS).read_bytes(), tmp_path / "flipped.mcap"
    unequal = 0
    for bit in flips(data, 60, 1):
        path.write_bytes(flipped(data, bit))
        try:
            verdict: Verdict | None = verify(path)
        except AftdeckError:
            verdict = None
        if verdict is None or not verdict.equal:
            unequal += 1
        elif not verdict.cut:
            assert entries(path) == entries(whole), f"bit {bit}"
    assert unequal > 40


def _without_chunks(writer: Any) -> None:
    writer.flush()
    writer._Writer__chunk_builder = None


def _without_index_of_messages(writer: Any) -> None:
    writer._Writer__index_types = IndexType.CHUNK


def _without_earlier_chunks(writer: Any) -> None:
    writer._Writer__chunk_indices.clear()


@pytest.mark.parametrize("halfway", [_without_chunks, _without_index_of_messages, _without_earlier_chunks])
def test_index_that_hides_messages_is_damage(whole: Path, tmp_path: Path, halfway: Callable[[Any], None]) -> None:
    settings = {"chunk_size": 5_000}
    written(whole, tmp_path / "hidden.mcap", settings, halfway=halfway)
    found, error = read_until_error(tmp_path / "hidden.mcap")
    assert found == messages(whole) and error is not None and error.fault == "damaged"
