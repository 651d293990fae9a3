"""Command ``report``."""

from __future__ import annotations

from contextlib import ExitStack
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from aftdeck.cli.app import Json, app
from aftdeck.cli.printing import print_json
from aftdeck.errors import AftdeckError, InputError
from aftdeck.lines import print_error, print_line
from aftdeck.whole_file import write_new

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from aftdeck.report.page.gather import Gathered
    from aftdeck.report.table import Row

_COLUMN = 14
"""Least width of a run's column [characters]."""


@app.command(
    short_help="Compute the metrics of recorded runs, as text, table or page.",
    epilog="Examples: aftdeck report run.mcap; aftdeck report run.mcap -o report.html; "
    "aftdeck report first.mcap second.mcap -o both.html; aftdeck report P07-*.mcap --table runs.parquet; "
    "aftdeck report run.mcap --series run.csv --columns torques,loads",
)
def report(
    files: Annotated[list[Path], typer.Argument(metavar="RECORDING...", help="Recordings (.mcap).")],
    out: Annotated[
        Path | None,
        typer.Option(
            "-o", "--out", metavar="FILE.html", help="Write a page with metrics, charts, pictures and events."
        ),
    ] = None,
    table: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", help="Write a row for each run, with all metrics as columns with units: .csv or .parquet."
        ),
    ] = None,
    series: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", help="Write the time history of one run, a row for each step, with units: .csv or .parquet."
        ),
    ] = None,
    columns: Annotated[
        str | None,
        typer.Option(
            metavar="NAME,...",
            help="Groups or columns of the time history (docs/series.md); default: all. Needs --series.",
        ),
    ] = None,
    gauges: Annotated[
        bool,
        typer.Option(
            "--gauges", help="Simulate runs with masses again, for the metrics of the moments inside the arm."
        ),
    ] = False,
    as_json: Json = False,
) -> None:
    """Compute the metrics of recorded runs: times, path, clearance, use of the sticks, captures, limits, loads.

    Several runs are shown side by side. Each metric has one definition; docs/metrics.md lists them all. A recording
    that cannot be read is left out, and the exit code is then 2. With --series, write a run's time history instead.
    """
    if series is not None:
        if len(files) > 1 or table is not None or out is not None or gauges:
            raise InputError("--series needs one recording, and cannot be combined with --table, --out and --gauges")
        _write_series(files[0], series, () if columns is None else columns.split(","), as_json)
        return
    if columns is not None:
        raise InputError("--columns needs --series")
    _check_new(table, out)
    if out is None:
        rows = list(_read(files, f"aftdeck.report.of_recording:{'gauged' if gauges else 'recorded'}_row"))
    else:
        with ExitStack() as page:
            prepare = partial(_prepare_page, page, files[0])
            gather = "with_gauges" if gauges else "gathered"
            runs: list[Gathered] = list(_read(files, f"aftdeck.report.page.gather:{gather}", prepare))
            from aftdeck.report.table import row_of

            rows = [row_of(run.recording, run.metrics) for run in runs]
            text = _write_page(runs, out) if runs else ""
        if text and not as_json:
            print_line(text)
    if not rows:
        raise typer.Exit(2)
    if table is not None:
        from aftdeck.report.table import write_table

        write_table(rows, table)
    if table is not None and not as_json:
        print_line(f"{table}: {len(rows)} {'run' if len(rows) == 1 else 'runs'}, {len(rows[0])} columns")
    if as_json:
        print_json(rows, indent=2)
    elif table is None and out is None:
        _print(rows)
    if len(rows) < len(files):
        raise typer.Exit(2)


def _read(files: Sequence[Path], read: str, meanwhile: Callable[[], object] = lambda: None) -> Iterator[Any]:
    """Yield what the function named `read` makes of each recording; print the error of one that cannot be read."""
    from aftdeck.report.read_all import read_all

    for found in read_all(files, read, meanwhile):
        if isinstance(found, AftdeckError):
            print_error(str(found))
        else:
            yield found


def _check_new(table: Path | None, page: Path | None) -> None:
    """Check that the files can be written."""
    from aftdeck.new_file import check_new_file
    from aftdeck.table import ENDINGS

    if table is not None:
        check_new_file(table, ENDINGS)
    if page is not None:
        check_new_file(page, (".html",))


def _write_series(file: Path, out: Path, columns: Sequence[str], as_json: bool) -> None:
    """Write the time history of a recorded run."""
    from aftdeck.progress_bar import ProgressBar
    from aftdeck.recording.reader import Recording
    from aftdeck.report.series import series_of

    _check_new(out, None)
    with ProgressBar(f"{out}") as progress:
        table = series_of(Recording(file), columns, progress)
    table.write(out)
    if as_json:
        print_json([column._asdict() for column in table.columns], indent=2)
    else:
        print_line(f"{out}: {len(table['time_s'])} steps, {len(table)} columns")


def _prepare_page(page: ExitStack, first: Path) -> None:
    """Load what draws the page, and the scene of the first run; `page` is closed when the page is drawn."""
    from aftdeck.cli.laws import compiled_meanwhile
    from aftdeck.report.page.pictures import draw_first
    from aftdeck.visual.warm import FILES

    page.enter_context(compiled_meanwhile(draw_first, first, files=FILES))
    import_module("aftdeck.report.page.runs").page([])


def _write_page(runs: Sequence[Gathered], out: Path) -> str:
    """Write the page; return a text about it."""
    from aftdeck.report.page.runs import page

    text = page(runs)
    write_new(out, text)
    return f"{out}: {len(runs)} {'run' if len(runs) == 1 else 'runs'}, {len(text) / 1e6:.1f} MB"


def _print(rows: Sequence[Row]) -> None:
    """Print the metrics for which a run has a value, by subject, the runs side by side."""
    from aftdeck.report.catalogue import METRICS, SUBJECTS
    from aftdeck.report.words import text_of

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
            texts = [text_of(metric, row[metric.column]).rjust(width) for row, width in zip(rows, widths, strict=True)]
            print_line(f"    {metric.title:<{titles}}{'  '.join(texts)}")
