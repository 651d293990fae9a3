"""Command ``report``."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from aftdeck.cli.app import Json, app
from aftdeck.cli.printing import print_json
from aftdeck.errors import AftdeckError
from aftdeck.lines import print_error, print_line

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

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

    Several runs are shown side by side. Each metric has one definition; docs/metrics.md lists them all. A recording
    that cannot be read is left out, and the exit code is then 2.
    """
    from aftdeck.report.table import check_table, write_csv

    if table is not None:
        check_table(table)
    rows = list(_rows(files))
    if not rows:
        raise typer.Exit(2)
    if table is not None:
        write_csv(rows, table)
    if as_json:
        print_json(rows, indent=2)
    elif table is not None:
        print_line(f"{table}: {len(rows)} {'run' if len(rows) == 1 else 'runs'}, {len(rows[0])} columns")
    else:
        _print(rows)
    if len(rows) < len(files):
        raise typer.Exit(2)


def _rows(files: Sequence[Path]) -> Iterator[Row]:
    """Yield the row of each recording; print the error of one that cannot be read."""
    from aftdeck.recording.reader import Recording
    from aftdeck.report.table import row_of

    for file in files:
        try:
            yield row_of(Recording(file))
        except AftdeckError as error:
            print_error(str(error))


def _print(rows: Sequence[Row]) -> None:
    """Print the metrics for which a run has a value, by subject, the runs side by side."""
    from aftdeck.report.catalogue import METRICS, SUBJECTS

    titles = max(len(metric.title) for metric in METRICS)
    names = [Path(str(row["recording"])).stem if len(rows) > 1 else "" for row in rows]
    widths = [max(_COLUMN, len(name)) for name in names]
    for row in rows:
        by = f", {row['participant']}" if row["participant"] else ""
        print_line(f"{row['recording']}: {row['scenario']}, {row['ended']}{by}")
    if len(rows) > 1:
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
