"""What a replay knows of a recording is what was flown."""

from __future__ import annotations

import errno
import itertools
import math
import os
from pathlib import Path

import msgspec
import numpy as np
import pytest

from aftdeck.errors import RecordingError
from aftdeck.recording import writer
from aftdeck.simulation.frame import Frame
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.messages.playback import BLOCK, PlaybackIndex
from aftdeck.station.playback import reel as station_reel
from aftdeck.station.playback.reel import PlaybackStore
from aftdeck.station.playback.verdict import CHECKING
from tests.station.pages import scenario
from tests.station.recordings import NOTE, recorded

Flown = tuple[Path, list[Frame]]


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Flown:
    path = tmp_path_factory.mktemp("reel") / "flight.mcap"
    return path, recorded(path)


@pytest.fixture(scope="module")
def index(flown: Flown) -> PlaybackIndex:
    with PlaybackStore(flown[0]) as reel:
        return reel.index(CHECKING)


def test_blocks_hold_every_frame_once_as_the_station_would_show_it(flown: Flown) -> None:
    path, frames = flown
    displays = Displays(scenario())
    with PlaybackStore(path) as reel:
        blocks = [reel.block(number) for number in range(reel.blocks)]
    assert [len(block) for block in blocks] == [BLOCK, BLOCK, len(frames) - 2 * BLOCK]
    for moment, frame in zip((moment for block in blocks for moment in block), frames, strict=True):
        assert moment.frame.tick == frame.tick
        assert moment.frame.angles == pytest.approx(frame.angles, abs=1e-9)
    shown = displays.frame(frames[300], -1)
    assert blocks[300 // BLOCK][300 % BLOCK].frame.display.poses == pytest.approx(shown.display.poses, abs=1e-7)


def test_a_block_that_is_none_is_an_index_error(flown: Flown) -> None:
    with PlaybackStore(flown[0]) as reel:
        for number in (-1, 3):
            with pytest.raises(IndexError, match=f"blocks are numbered 0 to 2, got {number}"):
                reel.block(number)


@pytest.mark.parametrize("stride", [1, 7, 256, 600])
def test_a_thinned_reel_keeps_the_first_moment_and_every_so_manieth(flown: Flown, stride: int) -> None:
    with PlaybackStore(flown[0]) as reel:
        ticks = [moment.frame.tick for moment in reel.moments(stride)]
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


def test_a_flight_by_hand_alone_has_no_phases(tmp_path: Path) -> None:
    recorded(tmp_path / "hand.mcap", 4, script=False)
    with PlaybackStore(tmp_path / "hand.mcap") as reel:
        names = [lane.name for lane in reel.index(CHECKING).lanes]
    assert names == ["Mode", "MON 1", "MON 2", "Alarms", "Limits"]


def test_every_curve_has_a_value_in_every_moment_and_strips_their_extremes(flown: Flown, index: PlaybackIndex) -> None:
    with PlaybackStore(flown[0]) as reel:
        columns = list(zip(*(moment.values for moment in reel.moments(1)), strict=True))
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


def test_strips_tell_of_the_same_frames_as_the_read_outs(flown: Flown, index: PlaybackIndex) -> None:
    path, frames = flown
    with PlaybackStore(path) as reel:
        moment = reel.block(1)[100]
    frame = frames[BLOCK + 100]
    names = [strip.name for strip in index.strips for _ in strip.curves]
    speed = moment.values[names.index("POR rate") + 1]
    assert speed == pytest.approx(math.hypot(*moment.frame.display.actual.velocity), abs=1e-8)
    parts = [abs(rate) / limit for rate, limit in zip(frame.rates, frame.rate_limits, strict=True)]
    assert moment.values[names.index("Joint rate") + 1] == pytest.approx(max(parts), abs=1e-7)
    joint = scenario().arm.joints[parts.index(max(parts))]
    assert moment.worst == joint.replace("_", " ")


def test_measures_are_those_of_the_run(flown: Flown, index: PlaybackIndex) -> None:
    frames = flown[1]
    figures = {measure.name: measure.value for measure in index.measures}
    assert figures["Run time"] == pytest.approx(12.0)
    assert figures["Flown by hand"] == pytest.approx(0.75)
    assert figures["Two-handed share"] == figures["Multi-axis share"]
    assert 0.2 < (figures["Two-handed share"] or 0) < 0.5
    assert figures["Time in vernier"] == pytest.approx(sum(frame.rate == "vernier" for frame in frames) * 0.02)
    way = np.diff(np.array([frame.position for frame in frames]), axis=0)
    assert figures["Tip path"] == pytest.approx(np.linalg.norm(way, axis=1).sum(), abs=1e-6)
    words = {measure.name: measure.text for measure in index.measures}
    assert words["Ended"] == "stopped"


def test_the_log_holds_the_flights_lines_and_the_stations_in_order(flown: Flown, index: PlaybackIndex) -> None:
    told = [event.text for frame in flown[1] for event in frame.events]
    assert [event.text for event in index.events if event.text != NOTE.text] == told
    assert NOTE.text in [event.text for event in index.events]


def test_an_index_goes_through_json_unchanged(index: PlaybackIndex) -> None:
    assert msgspec.json.decode(msgspec.json.encode(index), type=PlaybackIndex) == index


def test_a_cut_recording_plays_as_far_as_it_goes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "cut.mcap"
    monkeypatch.setattr(writer, "FLUSH_S", 0.0)  # every step is closed, so that any cut leaves some
    recorded(path)
    data = path.read_bytes()
    path.write_bytes(data[: data.rfind(b"zstd", 0, len(data) * 3 // 4) + 20])  # within a chunk
    with PlaybackStore(path) as reel:
        index = reel.index(CHECKING)
        assert 0 < index.ticks < 600
        assert index.ended == ""
        assert next(measure.text for measure in index.measures if measure.name == "Ended") == "cut short"
        assert index.lanes[0].stretches[-1].end_s == pytest.approx(index.ticks * index.period_s)
        assert len(reel.block(reel.blocks - 1)) == index.ticks - (reel.blocks - 1) * BLOCK


def test_a_recording_without_a_step_is_told(tmp_path: Path) -> None:
    recorded(tmp_path / "empty.mcap", 0)
    with pytest.raises(RecordingError, match=r"empty\.mcap: ends before its first step; there is nothing in it to"):
        PlaybackStore(tmp_path / "empty.mcap")


def test_a_full_disk_is_told(flown: Flown, monkeypatch: pytest.MonkeyPatch) -> None:
    class Full:
        def __enter__(self) -> Full:
            return self

        def __exit__(self, *_: object) -> None: ...

        def write(self, _: bytes) -> None:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(station_reel, "TemporaryFile", lambda **_: Full())
    with pytest.raises(RecordingError, match=r"frames cannot be kept in .*: No space left on device"):
        PlaybackStore(flown[0])
