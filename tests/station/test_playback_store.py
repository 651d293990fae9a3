"""Playback data of a recording agrees with the run."""

from __future__ import annotations

import errno
import itertools
import math
import os
from pathlib import Path
from tempfile import gettempdir

import msgspec
import numpy as np
import pytest

from aftdeck.errors import RecordingError
from aftdeck.recording import writer
from aftdeck.simulation.frame import Frame
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.messages.playback import BLOCK, PlaybackIndex
from aftdeck.station.playback import store as playback_store
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.playback.verdict import CHECKING
from tests.loaded import scenario
from tests.station.recordings import NOTE, record_run

RecordedRun = tuple[Path, list[Frame]]


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> RecordedRun:
    path = tmp_path_factory.mktemp("store") / "flight.mcap"
    return path, record_run(path)


@pytest.fixture(scope="module")
def index(recorded: RecordedRun) -> PlaybackIndex:
    with PlaybackStore(recorded[0]) as store:
        return store.index(CHECKING)


def test_blocks_have_every_frame_once_with_its_display(recorded: RecordedRun) -> None:
    path, frames = recorded
    displays = Displays(scenario())
    with PlaybackStore(path) as store:
        blocks = [store.block(number) for number in range(store.blocks)]
    assert [len(block) for block in blocks] == [BLOCK, BLOCK, len(frames) - 2 * BLOCK]
    for moment, frame in zip((moment for block in blocks for moment in block), frames, strict=True):
        assert moment.frame.tick == frame.tick
        assert moment.frame.angles == pytest.approx(frame.angles, abs=1e-9)
    shown = displays.frame(frames[300], -1)
    assert blocks[300 // BLOCK][300 % BLOCK].frame.display.poses == pytest.approx(shown.display.poses, abs=1e-7)


def test_block_number_out_of_range_is_an_index_error(recorded: RecordedRun) -> None:
    with PlaybackStore(recorded[0]) as store:
        for number in (-1, 3):
            with pytest.raises(IndexError, match=f"0 to 2, got {number}$"):
                store.block(number)


@pytest.mark.parametrize("stride", [1, 7, 256, 600])
def test_stride_yields_the_first_moment_and_every_nth(recorded: RecordedRun, stride: int) -> None:
    with PlaybackStore(recorded[0]) as store:
        ticks = [moment.frame.tick for moment in store.moments(stride)]
    assert ticks == list(range(1, 601, stride))


def test_lanes_cover_the_run_without_gaps(index: PlaybackIndex) -> None:
    assert [lane.name for lane in index.lanes] == ["Phase", "Mode", "MON 1", "MON 2", "Alarms", "Limits"]
    for lane in index.lanes:
        ends = [0.0, *(stretch.end_s for stretch in lane.stretches)]
        assert [stretch.start_s for stretch in lane.stretches] == ends[:-1]
        assert ends[-1] == pytest.approx(index.ticks * index.period_s)
        assert all(stretch.end_s > stretch.start_s for stretch in lane.stretches)
        labels = [stretch.label for stretch in lane.stretches]
        assert all(one != other for one, other in itertools.pairwise(labels))


def test_manual_run_has_no_phase_lane(tmp_path: Path) -> None:
    record_run(tmp_path / "hand.mcap", 4, script=False)
    with PlaybackStore(tmp_path / "hand.mcap") as store:
        names = [lane.name for lane in store.index(CHECKING).lanes]
    assert names == ["Mode", "MON 1", "MON 2", "Alarms", "Limits"]


def test_strips_keep_the_extremes_of_the_moments_values(recorded: RecordedRun, index: PlaybackIndex) -> None:
    with PlaybackStore(recorded[0]) as store:
        columns = list(zip(*(moment.values for moment in store.moments(1)), strict=True))
    curves = [(strip, curve) for strip in index.strips for curve in strip.curves]
    assert len(curves) == len(columns)
    for (strip, curve), column in zip(curves, columns, strict=True):
        values = [value for value in column if value is not None]
        drawn = [value for value in curve.values if value is not None]
        if values:
            assert (min(drawn), max(drawn)) == (min(values), max(values))
            assert strip.low <= min(values) <= max(values) <= strip.high
            for time, value in zip(curve.times_s, curve.values, strict=True):
                assert value == column[round(time / index.period_s) - 1]


def test_strips_have_the_values_of_the_read_outs(recorded: RecordedRun, index: PlaybackIndex) -> None:
    path, frames = recorded
    with PlaybackStore(path) as store:
        moment = store.block(1)[100]
    frame = frames[BLOCK + 100]
    names = [strip.name for strip in index.strips for _ in strip.curves]
    speed = moment.values[names.index("POR rate") + 1]
    assert speed == pytest.approx(math.hypot(*moment.frame.display.actual.velocity), abs=1e-8)
    parts = [abs(rate) / limit for rate, limit in zip(frame.rates, frame.rate_limits, strict=True)]
    assert moment.values[names.index("Joint rate") + 1] == pytest.approx(max(parts), abs=1e-7)
    joint = scenario().arm.joints[parts.index(max(parts))]
    assert moment.worst == joint.replace("_", " ")


def test_measures_agree_with_the_frames(recorded: RecordedRun, index: PlaybackIndex) -> None:
    frames = recorded[1]
    figures = {measure.name: measure.value for measure in index.measures}
    assert figures["Run time"] == pytest.approx(12.0)
    assert figures["Manual share"] == pytest.approx(0.75)
    assert figures["Two-handed share"] == figures["Multi-axis share"]
    assert 0.2 < (figures["Two-handed share"] or 0) < 0.5
    assert figures["Time in vernier"] == pytest.approx(sum(frame.rate == "vernier" for frame in frames) * 0.02)
    steps = np.diff(np.array([frame.position for frame in frames]), axis=0)
    assert figures["Tip path"] == pytest.approx(np.linalg.norm(steps, axis=1).sum(), abs=1e-6)
    words = {measure.name: measure.text for measure in index.measures}
    assert words["Ended"] == "stopped"


def test_log_has_the_lines_of_the_run_and_of_the_station(recorded: RecordedRun, index: PlaybackIndex) -> None:
    lines = [event.text for frame in recorded[1] for event in frame.events]
    assert [event.text for event in index.events if event.text != NOTE.text] == lines
    assert NOTE.text in [event.text for event in index.events]


def test_index_survives_json(index: PlaybackIndex) -> None:
    assert msgspec.json.decode(msgspec.json.encode(index), type=PlaybackIndex) == index


def test_recording_cut_short_is_played_to_its_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "cut.mcap"
    monkeypatch.setattr(writer, "FLUSH_S", 0.0)  # each step is flushed, so the cut file contains some steps
    record_run(path)
    data = path.read_bytes()
    path.write_bytes(data[: data.rfind(b"zstd", 0, len(data) * 3 // 4) + 20])  # within a chunk
    with PlaybackStore(path) as store:
        index = store.index(CHECKING)
        assert 0 < index.ticks < 600
        assert index.ended == ""
        assert next(measure.text for measure in index.measures if measure.name == "Ended") == "cut short"
        assert index.lanes[0].stretches[-1].end_s == pytest.approx(index.ticks * index.period_s)
        assert len(store.block(store.blocks - 1)) == index.ticks - (store.blocks - 1) * BLOCK


def test_recording_without_a_step_is_rejected(tmp_path: Path) -> None:
    record_run(tmp_path / "empty.mcap", 0)
    with pytest.raises(RecordingError, match=r"empty\.mcap: "):
        PlaybackStore(tmp_path / "empty.mcap")


def test_full_temporary_disk_is_reported(recorded: RecordedRun, monkeypatch: pytest.MonkeyPatch) -> None:
    class Full:
        def __enter__(self) -> Full:
            return self

        def __exit__(self, *_: object) -> None: ...

        def write(self, _: bytes) -> None:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(playback_store, "TemporaryFile", lambda **_: Full())
    with pytest.raises(RecordingError, match=rf"{gettempdir()}: No space left on device$"):
        PlaybackStore(recorded[0])
