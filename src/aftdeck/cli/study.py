"""Commands ``study`` and ``studies``."""

from __future__ import annotations

import sys
import time
from datetime import timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from aftdeck.cli.app import Json, app
from aftdeck.cli.printing import print_json, print_table
from aftdeck.errors import InputError
from aftdeck.lines import print_error, print_line, visible

if TYPE_CHECKING:
    from collections.abc import Callable

    from rich.progress import Progress as Bar

    from aftdeck.study.file import Study
    from aftdeck.study.run import Progress

MOST_ERRORS = 5
"""Greatest number of errors that are listed."""


@app.command(
    short_help="Run a scenario many times, with factors that change.",
    epilog="Examples: aftdeck study plant-and-mode -o plants; aftdeck study mine.toml -o mine --jobs 4; "
    "aftdeck study mine.toml -o mine --only 17; "
    "aftdeck study mine.toml -o mine --query 'SELECT mode, avg(run_time_s) FROM results GROUP BY mode'",
)
def study(
    file: Annotated[str, typer.Argument(metavar="STUDY", help="A built-in name or a path to a .toml file.")],
    folder: Annotated[Path, typer.Option("-o", "--out", metavar="DIR", help="Folder of the results.")],
    jobs: Annotated[
        int | None, typer.Option(min=1, metavar="N", help="Number of processes; by default one for each core.")
    ] = None,
    ray: Annotated[
        str | None,
        typer.Option(
            metavar="ADDRESS", help="Run on a Ray cluster: auto, local, or an address such as ray://head:10001."
        ),
    ] = None,
    only: Annotated[
        int | None, typer.Option(metavar="INDEX", help="Run this case alone, and record it.", min=0)
    ] = None,
    query: Annotated[
        str | None,
        typer.Option(metavar="SQL", help="Run no case; answer a question about the tables `results` and `times`."),
    ] = None,
    retry: Annotated[bool, typer.Option("--retry", help="Run cases again that ended with an error.")] = False,
    as_json: Json = False,
) -> None:
    """Run a study: a scenario many times, with factors that change from run to run.

    The results are in DIR: a table (results.parquet), a page (report.html), and recordings of the worst cases. A study
    that was interrupted continues with the same command. The exit code is 1 if cases ended with an error.
    """
    from aftdeck.study.file import load_study

    if only is not None and query is not None:
        raise InputError("--only and --query cannot be combined")
    loaded = load_study(file)
    if query is not None:
        _query(loaded, folder, query, as_json)
    elif only is not None:
        _only(loaded, folder, only, as_json)
    else:
        _run(loaded, folder, jobs, ray, retry, as_json)


@app.command(epilog="Example: aftdeck studies")
def studies(as_json: Json = False) -> None:
    """List the built-in studies."""
    from aftdeck.study.design import cases
    from aftdeck.study.file import built_in, load_study

    loaded = [load_study(name) for name in built_in()]
    rows = [{"name": s.name, "scenario": s.carried.name, "cases": len(cases(s)), "title": s.spec.title} for s in loaded]
    print_table(rows, ("name", "scenario", "cases", "title"), as_json)


def _run(loaded: Study, folder: Path, jobs: int | None, ray: str | None, retry: bool, as_json: bool) -> None:
    from aftdeck.study.run import run_study

    _compile_first(loaded)
    try:
        with StudyProgress(loaded.spec.title) as progress:
            outcomes = run_study(loaded, folder, jobs=jobs, ray=ray, retry=retry, progress=progress)
    except KeyboardInterrupt:
        print_error(f"interrupted; the results so far are in {folder}, and the same command continues")
        raise
    failed = [outcome.row for outcome in outcomes if outcome.row["error"]]
    good = sum(bool(outcome.row["success"]) for outcome in outcomes)
    if as_json:
        print_json({"folder": str(folder), "cases": len(outcomes), "successful": good, "errors": len(failed)})
    else:
        print_line(f"{loaded.name}: {len(outcomes)} cases, {good} successful, {len(failed)} with an error")
        for row in failed[:MOST_ERRORS]:
            print_line(f"  case {row['index']}: {str(row['error']).splitlines()[0]}")
        if len(failed) > MOST_ERRORS:
            print_line(f"  and {len(failed) - MOST_ERRORS} more")
        print_line(f"  {folder / 'report.html'}")
    if failed:
        raise typer.Exit(1)


def _compile_first(loaded: Study) -> None:
    """Compile the laws of the study's scenario, if nothing was compiled before; workers would each do it."""
    from aftdeck.compiled_first import compiled_first
    from aftdeck.simulation.warm import warm_up

    compiled_first(warm_up, loaded.carried.scenario(()))


def _only(loaded: Study, folder: Path, index: int, as_json: bool) -> None:
    from aftdeck.study.run import run_only

    _compile_first(loaded)
    outcome, path = run_only(loaded, folder, index)
    if as_json:
        print_json({**outcome.row, "recording": str(path)}, indent=2)
    else:
        for name, value in outcome.row.items():
            if value is not None and value != "":
                print_line(f"  {name:<32} {_cell(value)}")
        print_line(f"{path}: play it back with `aftdeck replay {path} --open`")
    if outcome.row["error"]:
        raise typer.Exit(1)


def _query(loaded: Study, folder: Path, sql: str, as_json: bool) -> None:
    from aftdeck.study.query import ask
    from aftdeck.study.store import outcomes_in

    answer = ask(loaded, outcomes_in(folder, loaded), sql)
    rows: list[dict[str, Any]] = [dict(zip(answer.columns, row, strict=True)) for row in answer.rows]
    if as_json:
        print_json(rows, indent=2)
    elif rows:
        print_table([{name: _cell(value) for name, value in row.items()} for row in rows], answer.columns, False)


def _cell(value: object) -> object:
    """Return a value for a table: a number with six digits, a dash for no value."""
    if value is None:
        return "-"
    return f"{value:.6g}" if isinstance(value, float) else value


class StudyProgress:
    """Progress bar of a study with the time left; it is shown only if standard error is a terminal."""

    def __init__(self, title: str) -> None:
        self._title = title
        self._bar: Bar | None = None

    def __enter__(self) -> Callable[[Progress], None] | None:
        if not sys.stderr.isatty():
            return None
        from rich.console import Console
        from rich.markup import escape
        from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn
        from rich.progress import Progress as Bar

        columns = (
            TextColumn("{task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            TextColumn("{task.fields[failed]}"),
            TimeElapsedColumn(),
            TextColumn("{task.fields[left]}"),
        )
        bar = self._bar = Bar(*columns, console=Console(stderr=True), transient=True)
        bar.start()
        task = bar.add_task(escape(visible(self._title)), total=None, failed="", left="")
        began = time.monotonic()
        before: int | None = None

        def update(now: Progress) -> None:
            nonlocal before
            before = now.done if before is None else before
            left = time_left(now.done - before, now.cases - now.done, time.monotonic() - began)
            failed = f"{now.failed} with an error" if now.failed else ""
            bar.update(task, completed=now.done, total=now.cases, failed=failed, left=left)

        return update

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.stop()


def time_left(done: int, left: int, elapsed_s: float) -> str:
    """Return the time that is left, from the mean time of a case; "" before the first case is done.

    >>> time_left(10, 20, 30.0)
    '0:01:00 left'
    """
    if not done:
        return ""
    return f"{timedelta(seconds=round(elapsed_s / done * left))} left"
