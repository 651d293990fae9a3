"""What a replay knows of a run with a capture: clearance, tasks, the capture, and what the summary tells, too."""

from __future__ import annotations

import math
from itertools import groupby, pairwise
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.recording.writer import Recorder
from aftdeck.simulation.frame import Frame
from aftdeck.station.messages.curves import Strip
from aftdeck.station.messages.playback import Measure, PlaybackIndex
from aftdeck.station.playback.reel import PlaybackStore
from aftdeck.station.playback.verdict import CHECKING
from aftdeck.worksite.watch.alarm import CLEAR, level_of
from tests.station.pages import scenario
from tests.station.recordings import grappled

PERIOD = 0.02
ROUNDED = 1e-5
"""Of a recorded clearance [m]."""
Flown = tuple[list[Frame], PlaybackIndex]


def read(path: Path) -> PlaybackIndex:
    with PlaybackStore(path) as reel:
        return reel.index(CHECKING)


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Flown:
    path = tmp_path_factory.mktemp("capture") / "flight.mcap"
    return grappled(path), read(path)


def strip(index: PlaybackIndex, name: str) -> Strip:
    return next(strip for strip in index.strips if strip.name == name)


def figures(index: PlaybackIndex) -> dict[str, Measure]:
    return {measure.name: measure for measure in index.measures}


def stretches(index: PlaybackIndex, lane: str) -> list[tuple[str, str]]:
    (found,) = (each for each in index.lanes if each.name == lane)
    return [(stretch.label, stretch.level) for stretch in found.stretches if stretch.label]


def clearances(frames: list[Frame]) -> list[float]:
    return [frame.work.nearest.clearance for frame in frames if frame.work.nearest]


def taken(frames: list[Frame]) -> int:
    """Index of the first frame in which the payload is held."""
    return next(i for i, frame in enumerate(frames) if frame.work.cargo[0].held)


def test_the_strips_least_value_is_the_smallest_clearance_of_the_flight(flown: Flown) -> None:
    frames, index = flown
    drawn = strip(index, "Clearance")
    least = min(value for value in drawn.curves[0].values if value is not None)
    assert least == figures(index)["Smallest clearance"].value
    assert least == pytest.approx(min(clearances(frames)), abs=ROUNDED)
    assert (drawn.caution, drawn.warning) == (0.5, 0.15)
    assert [each.name for each in index.strips if each.shown] == ["Clearance", "POR rate", "Joint rate"]


def test_clearance_is_an_alarm_with_its_lines_in_the_log(flown: Flown) -> None:
    frames, index = flown
    level, told = CLEAR, []
    for frame in frames:
        near = frame.work.nearest
        assert near is not None
        before, level = level, level_of(near.clearance, 0.5, 0.15, level)
        assert frame.work.clearance_level == level
        lines = [event for event in frame.events if event.kind == "clearance"]
        assert len(lines) == (level != before)
        told += lines
    assert [event.level for event in told] == ["warning", "info", "warning", "info", "info"]
    assert "payload grapple fixture" in told[0].text and "end effector within 5.91 in of payload" in told[2].text
    assert [event.text for event in index.events if event.kind == "clearance"] == [event.text for event in told]
    levels = [level for level, _ in groupby(frame.work.clearance_level for frame in frames) if level != CLEAR]
    assert stretches(index, "Alarms") == [("CLEARANCE", level) for level in levels]
    assert levels == ["warning", "caution", "warning", "caution"]
    assert figures(index)["Alarms raised"].value == 2.0


def test_by_hand_the_phases_are_the_reports_modes(flown: Flown) -> None:
    assert [label for label, _ in stretches(flown[1], "Phase")] == ["acquisition", "extraction", "acquisition"]


def test_capture_is_told_as_it_was_in_the_step_before_it(flown: Flown) -> None:
    frames, index = flown
    held = taken(frames)
    told = figures(index)
    before = frames[held - 1]
    assert told["Capture misalignment"].angle == pytest.approx(math.radians(3.0), abs=1e-4)
    (off,) = (c.value for c in before.work.conditions if c.name == "pin off axis")
    assert told["Capture misalignment"].value == pytest.approx(off, abs=ROUNDED)
    moved = np.subtract(before.position, frames[held - 2].position)
    assert told["Rate at capture"].value == pytest.approx(np.linalg.norm(moved) / PERIOD, rel=0.02)
    assert (told["Rate at capture"].value or 0.0) > 1e-4


def test_cameras_and_brakes_are_counted(flown: Flown) -> None:
    frames, index = flown
    told = figures(index)
    assert told["Camera changes"].value == 1.0
    assert told["Brakes used"].value == sum(now.brakes > was.brakes for was, now in pairwise(frames)) == 1


def test_the_figures_are_those_of_the_runs_summary(tmp_path: Path) -> None:
    path, made = tmp_path / "run.mcap", scenario("first-flight")
    recorder = Recorder(path, made, made.seed)
    done = aftdeck.run(made, seen=lambda frame: recorder.step(None, frame, latency_ms=None))
    recorder.close(done.summary.ended, done.summary)
    told, summary = figures(read(path)), done.summary
    assert told["Smallest clearance"].value == pytest.approx(summary.min_clearance_m, abs=ROUNDED)
    assert told["Worst joint rate"].value == pytest.approx(summary.worst_rate_ratio, abs=1e-6)
    assert told["Run time"].value == pytest.approx(summary.time_s)
    assert told["Ended"].text == summary.ended
    if summary.position_error_m is not None:
        assert told["Left to target"].value == pytest.approx(summary.position_error_m, abs=1e-8)
        assert told["Left to target"].angle == pytest.approx(summary.rotation_error_rad, abs=1e-8)
