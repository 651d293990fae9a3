"""Metrics of a recorded run against those of the same run while it was flown, and against its summary."""

from __future__ import annotations

from pathlib import Path

import pytest

from aftdeck.errors import RecordingError
from aftdeck.recording.reader import Recording
from aftdeck.recording.run import record
from aftdeck.recording.writer import Recorder
from aftdeck.report.catalogue import named
from aftdeck.report.lamps import lit_lamps
from aftdeck.report.metrics import moments, times
from aftdeck.report.of_recording import metrics_of
from aftdeck.report.run_metrics import RunMetrics
from aftdeck.simulation.run import Simulation
from tests.loaded import scenario

ROUNDED = 1e-5
"""Greatest effect of the rounding of recorded frames, relative and in SI units."""


@pytest.mark.parametrize("name", ["concept-1972-script"])
def test_recorded_and_flown_metrics_agree_with_each_other_and_with_the_summary(tmp_path: Path, name: str) -> None:
    live: list[RunMetrics] = []

    def see(sim: Simulation) -> None:
        if not live:
            live.append(RunMetrics(sim.scenario))
        live[0].see(sim.look(), lit_lamps(sim.scenario, sim.look()))

    run = record(name, tmp_path / "run.mcap", stepped=see)
    recorded, flown, summary = metrics_of(Recording(tmp_path / "run.mcap")), live[0].found(), run.summary
    assert recorded.keys() == flown.keys()
    for metric, value in flown.items():
        if value.number is not None:
            assert recorded[metric].number == pytest.approx(value.number, rel=ROUNDED, abs=ROUNDED), metric.column
        assert (recorded[metric].text, recorded[metric].level) == (value.text, value.level), metric.column
    assert recorded[named("min_clearance_m")].number == pytest.approx(summary.min_clearance_m, abs=ROUNDED)
    assert recorded[named("worst_joint_rate")].number == pytest.approx(summary.worst_rate_ratio, abs=ROUNDED)
    assert recorded[times.RUN].number == pytest.approx(summary.time_s)
    kinds = [event.kind for event in summary.events]
    assert recorded[moments.DOCK.number].number == kinds.count("docked")
    assert recorded[moments.CAPTURE.number].number == kinds.count("acquired")


def test_recording_without_a_step_has_no_metrics(tmp_path: Path) -> None:
    Recorder(tmp_path / "empty.mcap", scenario("first-flight"), 0).close("stopped")
    with pytest.raises(RecordingError, match="first step"):
        metrics_of(Recording(tmp_path / "empty.mcap"))
