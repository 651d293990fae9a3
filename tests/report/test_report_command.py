"""`aftdeck report`: metrics of recorded runs as text, JSON and a table."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

from aftdeck.recording.run import record
from aftdeck.recording.trial import Trial
from aftdeck.report.catalogue import METRICS
from aftdeck.report.table import RUN_COLUMNS
from tests.commands import Run


@pytest.fixture(scope="module")
def recordings(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """Two recordings."""
    folder = tmp_path_factory.mktemp("runs")
    files = [folder / "first.mcap", folder / "second.mcap"]
    for file in files:
        record("first-flight", file, trial=Trial("P07", file.stem))
    return [str(file) for file in files]


def test_table_has_a_row_for_each_run_and_a_column_for_each_metric(
    run: Run, recordings: list[str], tmp_path: Path
) -> None:
    table = tmp_path / "runs.csv"
    code, out, _ = run("report", *recordings, "--table", str(table), "--json")
    assert code == 0
    rows = json.loads(out)
    with table.open(newline="", encoding="utf-8") as file:
        written = list(csv.DictReader(file))
    assert [row["condition"] for row in rows] == ["first", "second"]
    assert [list(row) for row in rows] == [[*RUN_COLUMNS, *(metric.column for metric in METRICS)]] * 2
    assert written == [{key: "" if value is None else str(value) for key, value in row.items()} for row in rows]
    assert rows[0]["capture_offset_m"] is None and rows[0]["run_time_s"] > 0.0


def test_existing_table_is_not_overwritten(run: Run, recordings: list[str], tmp_path: Path) -> None:
    table = tmp_path / "runs.csv"
    table.write_text("mine")
    assert run("report", *recordings, "--table", str(table))[0] == 2
    assert table.read_text() == "mine"
    assert run("report", *recordings, "--table", str(tmp_path / "runs.xlsx"))[0] == 2


def test_recording_that_cannot_be_read_does_not_end_the_report(run: Run, recordings: list[str], tmp_path: Path) -> None:
    bad = tmp_path / "bad.mcap"
    bad.write_bytes(b"no recording")
    code, out, err = run("report", str(bad), *recordings, "--json")
    assert code == 2
    assert len(json.loads(out)) == 2
    assert "bad.mcap" in err
    assert run("report", str(bad))[:2] == (2, "")


def test_runs_stand_side_by_side(run: Run, recordings: list[str]) -> None:
    code, out, _ = run("report", *recordings)
    assert code == 0
    (line,) = [line for line in out.splitlines() if line.strip().startswith("Run time")]
    values = line.split()[2:]
    assert values[:2] == values[2:] and values[1] == "s"
