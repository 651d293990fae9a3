"""Table of the metrics of several runs: one row for each run, one column for each metric, with its unit."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping
from pathlib import Path

from aftdeck.errors import InputError
from aftdeck.recording.reader import Recording
from aftdeck.report.catalogue import METRICS
from aftdeck.report.metric import Metric, Value
from aftdeck.report.of_recording import metrics_of

Cell = str | float | int | None
Row = dict[str, Cell]

RUN_COLUMNS = ("recording", "scenario", "participant", "condition", "seed", "began", "ended", "version")
"""Columns that tell which run a row belongs to."""


def row_of(recording: Recording) -> Row:
    """Return the row of a recording: `RUN_COLUMNS`, then all metrics in the order of the catalogue; None for no value.

    Raises:
        RecordingError: the recording has no step.
    """
    metrics = metrics_of(recording)
    opening = recording.opening
    run: Row = {
        "recording": str(recording.path),
        "scenario": opening.scenario,
        "participant": opening.participant,
        "condition": opening.condition,
        "seed": opening.seed,
        "began": opening.began,
        "ended": recording.ended or "cut",
        "version": opening.version,
    }
    return run | cells(metrics)


def cells(metrics: Mapping[Metric, Value]) -> Row:
    """Return the columns of all metrics; None for a metric without a value."""
    return {metric.column: _cell(metrics.get(metric)) for metric in METRICS}


def _cell(value: Value | None) -> Cell:
    if value is None:
        return None
    return value.text if value.number is None else value.number


def check_table(file: Path) -> None:
    """Check that a table can be written to a file.

    Raises:
        InputError: the file exists already, or its name does not end with ``.csv``.
    """
    if file.suffix != ".csv":
        raise InputError(f"the table's name has to end with .csv, got {file}")
    if file.exists():
        raise InputError(f"{file} exists already")


def write_csv(rows: Iterable[Row], file: Path) -> None:
    """Write rows to a new CSV file, with the names of the columns first; a missing value is an empty cell.

    Raises:
        InputError: the file exists already or cannot be written, or its name does not end with ``.csv``.
    """
    check_table(file)
    try:
        with file.open("x", newline="", encoding="utf-8") as out:
            table = csv.DictWriter(out, [*RUN_COLUMNS, *(metric.column for metric in METRICS)])
            table.writeheader()
            table.writerows(rows)
    except OSError as error:
        raise InputError(f"cannot write {file}: {error.strerror or error}") from None
