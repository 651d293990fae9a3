"""Command ``report``."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from aftdeck.cli.app import Json, app
from aftdeck.cli.printing import print_json
from aftdeck.lines import print_line

if TYPE_CHECKING:
    from collections.abc import Sequence

    from aftdeck.report.metric import Metric
    from aftdeck.report.table import Cell, Row

_COLUMN = 14
"""Least width of a run's column [characters]."""


@app.command(
    short_help="Compute the metrics of recorded runs.",
    epilog="Examples: aftdeck report run.mcap; aftdeck report first.mcap second.mcap; "
    "aftdeck report P07-*.mcap --table runs.csv",
)
def report(
    files: Annotated[list[Path], typer.Argument(metavar="RECORDING...", help="Recordings (.mcap).")],
    table: Annotated[
        Path | None,
        typer.Option(metavar="FILE.csv", help="Write one row for each run, with all metrics as columns with units."),
    ] = None,
    as_json: Json = False,
) -> None:
    """Compute the metrics of recorded runs: times, path, clearance, use of the sticks, captures, limits.

    Several runs are shown side by side. Each metric has one definition; docs/metrics.md lists them all.
    """
    from aftdeck.recording.reader import Recording
    from aftdeck.report.table import row_of, write_csv

    rows = [row_of(Recording(file)) for file in files]
    if table is not None:
        write_csv(rows, table)
    if as_json:
        print_json(rows, indent=2)
    elif table is not None:
        print_line(f"{table}: {len(rows)} {'run' if len(rows) == 1 else 'runs'}, {len(rows[0])} columns")
    else:
        _print(files, rows)


def _print(files: Sequence[Path], rows: Sequence[Row]) -> None:
    """Print the metrics for which a run has a value, by subject, the runs side by side."""
    from aftdeck.report.catalogue import METRICS, SUBJECTS

    titles = max(len(metric.title) for metric in METRICS)
    names = [file.stem if len(files) > 1 else "" for file in files]
    widths = [max(_COLUMN, len(name)) for name in names]
    for row in rows:
        by = f", {row['participant']}" if row["participant"] else ""
        print_line(f"{row['recording']}: {row['scenario']}, {row['ended']}{by}")
    if len(files) > 1:
        print_line(" " * (titles + 4) + "  ".join(name.rjust(width) for name, width in zip(names, widths, strict=True)))
    for subject, metrics in SUBJECTS.items():
        known = [metric for metric in metrics if any(row[metric.column] is not None for row in rows)]
        if known:
            print_line(f"  {subject}")
        for metric in known:
            texts = [_text(metric, row[metric.column]).rjust(width) for row, width in zip(rows, widths, strict=True)]
            print_line(f"    {metric.title:<{titles}}{'  '.join(texts)}")


def _text(metric: Metric, value: Cell) -> str:
    """Return a value with its unit; angles in degrees, shares in per cent."""
    if value is None:
        return "-"
    if isinstance(value, str):
        return value
    from aftdeck.report.quantity import UNITS

    match metric.quantity:
        case "share":
            return f"{100.0 * value:.0f} %"
        case "count":
            return f"{value:.0f}" if float(value).is_integer() else f"{value:.1f}"
        case "angle" | "turn rate":
            return f"{math.degrees(value):.2f} {UNITS[metric.quantity].replace('rad', 'deg')}"
        case quantity:
            return f"{value:.3f} {UNITS[quantity]}".rstrip()
