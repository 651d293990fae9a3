"""Playback data of a run with a capture: clearance, task phases, measures."""

from __future__ import annotations

import math
from itertools import groupby, pairwise
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.recording.writer import Recorder
from aftdeck.report.curves import Strip
from aftdeck.simulation.frame import Frame
from aftdeck.station.messages.measure import Measure
from aftdeck.station.messages.playback import PlaybackIndex
from aftdeck.station.playback.store import PlaybackStore
from aftdeck.station.playback.verdict import CHECKING
from aftdeck.worksite.watch.alarm import CLEAR, level_of
from tests.loaded import scenario
from tests.station.recordings import record_capture

PERIOD = 0.02
ROUNDED = 1e-5
"""Tolerance of a recorded clearance [m]."""
RecordedRun = tuple[list[Frame], PlaybackIndex]


def read(path: Path) -> PlaybackIndex:
    with PlaybackStore(path) as store:
        return store.index(CHECKING)


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> RecordedRun:
    path = tmp_path_factory.mktemp("capture") / "flight.mcap"
    return record_capture(path), read(path)


def strip(index: PlaybackIndex, name: str) -> Strip:
    return next(strip for strip in index.strips if strip.name == name)


def figures(index: PlaybackIndex) -> dict[str, Measure]:
    return {measure.name: measure for measure in index.measures}


def stretches(index: PlaybackIndex, lane: str) -> list[tuple[str, str]]:
    (found,) = (each for each in index.lanes if each.name == lane)
    return [(stretch.label, stretch.level) for stretch in found.stretches if stretch.label]


def clearances(frames: list[Frame]) -> list[float]:
    return [frame.work.nearest.clearance for frame in frames if frame.work.nearest]


def capture_frame(frames: list[Frame]) -> int:
    """Return the index of the first frame in which the payload is held."""
    return next(i for i, frame in enumerate(frames) if frame.work.cargo[0].held)


def test_least_value_of_the_strip_is_the_smallest_clearance(recorded: RecordedRun) -> None:
    frames, index = recorded
    drawn = strip(index, "Clearance")
    least = min(value for value in drawn.curves[0].values if value is not None)
    assert least == figures(index)["Smallest clearance"].value
    assert least == pytest.approx(min(clearances(frames)), abs=ROUNDED)
    assert (drawn.caution, drawn.warning) == (0.5, 0.15)
    assert [each.name for each in index.strips if each.shown] == ["Clearance", "POR rate", "Joint rate"]


def test_clearance_alarms_are_logged_and_on_the_alarm_lane(recorded: RecordedRun) -> None:
    frames, index = recorded
    level, events = CLEAR, []
    for frame in frames:
        near = frame.work.nearest
        assert near is not None
        before, level = level, level_of(near.clearance, 0.5, 0.15, level)
        assert frame.work.clearance_level == level
        lines = [event for event in frame.events if event.kind == "clearance"]
        assert len(lines) == (level != before)
        events += lines
    assert [event.level for event in events] == ["warning", "info", "warning", "info", "info"]
    assert "payload grapple fixture" in events[0].text and "5.91 in" in events[2].text
    assert [event.text for event in index.events if event.kind == "clearance"] == [event.text for event in events]
    levels = [level for level, _ in groupby(frame.work.clearance_level for frame in frames) if level != CLEAR]
    assert stretches(index, "Alarms") == [("CLEARANCE", level) for level in levels]
    assert levels == ["warning", "caution", "warning", "caution"]
    assert figures(index)["Alarms raised"].value == 2.0


def test_phase_lane_of_a_manual_run_has_the_task_phases(recorded: RecordedRun) -> None:
    assert [label for label, _ in stretches(recorded[1], "Phase")] == ["acquisition", "extraction", "acquisition"]


def test_capture_misalignment_is_that_of_the_previous_step(recorded: RecordedRun) -> None:
    frames, index = recorded
    held = capture_frame(frames)
    measures = figures(index)
    before = frames[held - 1]
    assert measures["Capture misalignment"].angle == pytest.approx(math.radians(3.0), abs=1e-4)
    (off,) = (c.value for c in before.work.conditions if c.name == "pin off axis")
    assert measures["Capture misalignment"].value == pytest.approx(off, abs=ROUNDED)
    moved = np.subtract(before.position, frames[held - 2].position)
    assert measures["Rate at capture"].value == pytest.approx(np.linalg.norm(moved) / PERIOD, rel=0.02)
    assert (measures["Rate at capture"].value or 0.0) > 1e-4


def test_camera_changes_and_brakes_are_counted(recorded: RecordedRun) -> None:
    frames, index = recorded
    measures = figures(index)
    assert measures["Camera changes"].value == 1.0
    assert measures["Brakes used"].value == sum(now.brakes > was.brakes for was, now in pairwise(frames)) == 1


def test_measures_agree_with_the_runs_summary(tmp_path: Path) -> None:
    path, made = tmp_path / "run.mcap", scenario("first-flight")
    recorder = Recorder(path, made, made.seed)
    done = aftdeck.run(made, seen=lambda frame: recorder.step(None, frame, latency_ms=None))
    recorder.close(done.summary.ended, done.summary)
    measures, summary = figures(read(path)), done.summary
    assert measures["Smallest clearance"].value == pytest.approx(summary.min_clearance_m, abs=ROUNDED)
    assert measures["Worst joint rate"].value == pytest.approx(summary.worst_rate_ratio, abs=1e-6)
    assert measures["Run time"].value == pytest.approx(summary.time_s)
    assert measures["Ended"].text == summary.ended
    if summary.position_error_m is not None:
        assert measures["Distance to target"].value == pytest.approx(summary.position_error_m, abs=1e-8)
        assert measures["Distance to target"].angle == pytest.approx(summary.rotation_error_rad, abs=1e-8)
