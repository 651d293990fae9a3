"""Table of the metrics of several runs: one row for each run, one column for each metric, with its unit."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, BinaryIO

from aftdeck.encodable import encodable
from aftdeck.recording.reader import Recording
from aftdeck.report.catalogue import METRICS
from aftdeck.report.extra import needed
from aftdeck.report.metric import Metric, Value
from aftdeck.report.new_file import TABLE_ENDINGS, check_new_file
from aftdeck.whole_file import new_file, write_new

Cell = bool | int | float | str | None
Row = dict[str, Cell]

RUN_COLUMNS = ("recording", "scenario", "participant", "condition", "seed", "began", "ended", "version")
"""Columns that tell which run a row belongs to."""


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
        InputError: the file exists already or cannot be written, its name has another ending, or pyarrow is missing.
    """
    check_new_file(file, TABLE_ENDINGS)
    names = [*RUN_COLUMNS, *(metric.column for metric in METRICS)]
    if file.suffix == ".parquet":
        with new_file(file) as out:
            _write_parquet(rows, names, out)
        return
    text = io.StringIO(newline="")
    table = csv.DictWriter(text, names)
    table.writeheader()
    table.writerows(rows)
    write_new(file, text.getvalue())


def _write_parquet(rows: Sequence[Row], names: Sequence[str], file: BinaryIO) -> None:
    """Write a Parquet file; a column is text if it describes the run or a metric without a number, else a double."""
    arrow: Any = needed("pyarrow")
    texts = {*RUN_COLUMNS, *(metric.column for metric in METRICS if metric.is_text)}
    kinds = {name: arrow.string() if name in texts else arrow.float64() for name in names} | {"seed": arrow.int64()}
    schema = arrow.schema([(name, kinds[name]) for name in names])
    needed("pyarrow.parquet").write_table(arrow.Table.from_pylist([dict(row) for row in rows], schema), file)
