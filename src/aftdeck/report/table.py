"""Table of the metrics of several runs: one row for each run, one column for each metric, with its unit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from aftdeck.encodable import encodable
from aftdeck.recording.reader import Recording
from aftdeck.report.catalogue import METRICS
from aftdeck.report.metric import Metric, Value
from aftdeck.simulation.readings.quantity import UNITS
from aftdeck.table import Cell, Column, Table

Row = dict[str, Cell]

RUN_COLUMNS = ("recording", "scenario", "participant", "condition", "seed", "began", "ended", "version")
"""Columns that tell which run a row belongs to; all but the seed are texts."""


def row_of(recording: Recording, metrics: Mapping[Metric, Value]) -> Row:
    """Return the row of a recording: `RUN_COLUMNS`, then all metrics in the order of the catalogue; None for no value.

    Args:
        recording: the recording, read to its end.
        metrics: its metrics.
    """
    opening = recording.opening
    run: Row = {
        "recording": encodable(recording.path),
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


def write_table(rows: Sequence[Row], file: Path) -> None:
    """Write rows to a new CSV or Parquet file, with the names of the columns; a missing value is an empty cell or null.

    Raises:
        InputError: as for `Table.write`.
    """
    columns = [*map(_of_run, RUN_COLUMNS), *map(column_of, METRICS)]
    Table(columns, [[row[column.name] for row in rows] for column in columns]).write(file)


def column_of(metric: Metric) -> Column:
    """Return the column of a metric."""
    about = f"{metric.title}. {metric.definition}"
    return Column(metric.column, UNITS[metric.quantity], about, "text" if metric.is_text else "number")


def _of_run(name: str) -> Column:
    return Column(name, "", f"{name} of the run", "whole number" if name == "seed" else "text")
