"""Time histories: their columns, and the same values from a run, a repeated run and a recording."""

from __future__ import annotations

import csv
import math
import textwrap
from itertools import takewhile
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.errors import InputError, RecordingError
from aftdeck.recording import gauged
from aftdeck.recording.reader import Recording
from aftdeck.recording.run import record
from aftdeck.report.series import series_of
from aftdeck.simulation.readings.reading import Known
from aftdeck.simulation.run import Run, Simulation, run
from aftdeck.simulation.series.groups import columns_of, in_series
from aftdeck.table import Table, with_unit
from tests.pages import ROOT
from tests.plant.multibody.flights import scenario

SHORT = "[[phase]]\nname = 'push'\nmode = 'ORB UNL'\ntranslation = [1.0, 0.0, -1.0]\nduration = '2 s'\n"
ROUNDED = 5e-4
"""Half of the last decimal of a recorded torque [N m], the coarsest of all recorded numbers."""


@pytest.fixture(scope="module")
def flown() -> Run:
    """A short run of a flexible arm with a payload."""
    return run(scenario("flexible", SHORT, pounds=8000.0, orbiter="free"))


@pytest.mark.parametrize(
    ("name", "plant"),
    [
        *((name, plant) for name in ("loaded", "srms-berth") for plant in ("kinematic", "rigid", "flexible")),
        ("concept-1972-script", "kinematic"),
        ("concept-1972-script", "rigid"),  # the concept arm has no springs
    ],
)
def test_every_group_has_a_value_for_each_of_its_columns(name: str, plant: str) -> None:
    sim = Simulation(aftdeck.load_scenario(name, {"plant": plant}), gauged=True)
    frame, names = sim.step(), []
    for reading in in_series(sim.scenario):
        columns, values = columns_of(reading, sim.scenario), reading.values(Known(frame, sim.scenario, sim.readings))
        assert len(values) == len(columns), reading.name
        assert [isinstance(value, str) for value in values] == [column.kind == "text" for column in columns]
        names += [column.name for column in columns]
        assert all(column.name.endswith(with_unit("", column.unit)) for column in columns)
    assert len(names) == len(set(names))


def test_columns_are_those_asked_for_and_the_time(flown: Run) -> None:
    assert list(flown.table("end_effector_peak_moment_n_m", "torque_elbow_pitch_n_m")) == [
        "time_s",
        "torque_elbow_pitch_n_m",
        "end_effector_peak_moment_n_m",
    ]
    for name in ("torque", "payload_1_x_m", ""):
        with pytest.raises(InputError):
            flown.table(name)
    with pytest.raises(InputError):
        run("first-flight", keep_frames=False).table("loads")


def test_repeated_run_gives_the_values_of_the_frames(flown: Run) -> None:
    again = run(flown.scenario, keep_frames=False)
    assert len(again.frames) == 1
    kept, repeated = flown.table("true_tip", "torques"), again.table("true_tip", "torques")
    assert_equal(kept, repeated, 0.0)
    assert kept["true_tip_x_m"][-1] == flown.frames[-1].dynamics.position[0]  # type: ignore[union-attr]
    assert len(kept["time_s"]) == len(flown.frames) > 50


def test_recording_and_run_give_the_same_history(flown: Run, tmp_path: Path) -> None:
    record(flown.scenario, tmp_path / "run.mcap")
    table = flown.table()
    assert_equal(table, series_of(Recording(tmp_path / "run.mcap")), ROUNDED)
    peaks = np.asarray(table["upper_boom_peak_moment_n_m"], dtype=float)
    last = np.linalg.norm([table[f"upper_boom_moment_{axis}_n_m"] for axis in "xyz"], axis=0)
    assert (peaks >= last - 1e-9).all() and peaks.max() > 10.0


def test_manual_run_is_repeated_with_its_inputs(tmp_path: Path) -> None:
    given = scenario("rigid", pounds=8000.0)

    def sticks(sim: Simulation) -> aftdeck.Inputs | None:
        tick = 0 if sim.frame is None else sim.frame.tick
        return aftdeck.Inputs(mode="ORB UNL", translation=(math.sin(0.1 * tick), 0.0, 0.0)) if tick < 100 else None

    done = run(given, inputs=sticks)
    assert_equal(done.table("true_tip"), run(given, inputs=sticks, keep_frames=False).table("true_tip"), 0.0)
    loads = done.table("loads", "true_tip")
    assert list(loads["true_tip_x_m"]) == list(done.table("true_tip")["true_tip_x_m"])


@pytest.mark.parametrize("ending", [".csv", ".parquet"])
def test_file_has_the_values_of_the_table(flown: Run, tmp_path: Path, ending: str) -> None:
    table, file = flown.table("phase", "torques", "contacts", "loads"), tmp_path / f"run{ending}"
    table.write(file)
    if ending == ".csv":
        with file.open(newline="", encoding="utf-8") as text:
            rows = list(csv.DictReader(text))
        found = {name: [row[name] for row in rows] for name in table}
        for column in table.columns:
            if column.kind == "text":
                assert found[column.name] == list(table[column.name])
            else:
                numbers = [float(text or "nan") for text in found[column.name]]
                np.testing.assert_array_equal(numbers, np.asarray(table[column.name]))
    else:
        read = pytest.importorskip("pyarrow.parquet").read_table(file)
        assert read.column_names == list(table)
        for column, field in zip(table.columns, read.schema, strict=True):
            assert field.metadata[b"unit"].decode() == column.unit
            values = [math.nan if value is None else value for value in read[column.name].to_pylist()]
            np.testing.assert_array_equal(values, list(table[column.name]))
    with pytest.raises(InputError):
        table.write(file)


def test_recording_that_cannot_be_repeated_has_no_loads(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    given, other = scenario("rigid", SHORT), scenario("rigid", SHORT.replace("1.0,", "-1.0,"))
    record(given, tmp_path / "run.mcap")
    monkeypatch.setattr(gauged, "scenario_of", lambda _: other)
    with pytest.raises(RecordingError):
        series_of(Recording(tmp_path / "run.mcap"), ["loads"])
    assert len(series_of(Recording(tmp_path / "run.mcap"), ["torques"])["time_s"]) > 99


def assert_equal(table: Table, other: Table, tolerance: float) -> None:
    assert list(table) == list(other)
    for column in table.columns:
        if column.kind == "text":
            assert list(table[column.name]) == list(other[column.name])
        else:
            np.testing.assert_allclose(table[column.name], other[column.name], rtol=0.0, atol=tolerance)


@pytest.mark.slow
def test_program_of_the_document_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lines = (ROOT / "docs" / "series.md").read_text(encoding="utf-8").splitlines()
    first = lines.index("    import aftdeck")
    block = list(takewhile(lambda line: not line or line.startswith("    "), lines[first:]))
    monkeypatch.chdir(tmp_path)
    record(aftdeck.load_scenario("loaded", {"plant": "rigid"}), tmp_path / "run.mcap")
    exec(textwrap.dedent("\n".join(block)), {})
    assert (tmp_path / "loaded.csv").stat().st_size > 0
