"""``python -m benchmarks.document RESULTS FILE``: write docs/figures.md from a file of results."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

from benchmarks.measure import Figure
from benchmarks.names import NAMES
from benchmarks.results import Head, Outcome, read
from benchmarks.table import note_text, number, target_text, unit_text, value_text

OPENING = """\
# Figures

The speed of Aftdeck, measured by one command on one machine. A command writes this page; do not edit it. Other pages
quote from it.

| | |
|---|---|
"""
READING = """
To repeat the measurement, run `make bench`. It prints the figures and the path of its file of results. Then
`.venv/bin/python -m benchmarks.document RESULTS docs/figures.md` writes this page from that file.
`make bench ARGS="collision reach"` measures these two subjects only. `make bench BASE=COMMIT` compares this version
with another commit: both run their own benchmarks in turn.

A time says as much of the machine as of the program. Therefore most targets are shares of another figure of the same
run: of the same work by another library, of a plain loop, or of a part of the work. The note gives the measured share
and the greatest allowed one. A target without a share is for something that a person waits for, or for a size.
"""


def page(head: Head, outcomes: Iterable[Outcome]) -> str:
    """Return the page as Markdown.

    Raises:
        ValueError: the results are those of a tiny run.
    """
    if head.size != "FULL":
        raise ValueError(f"got results of a {head.size} run, expected FULL: tiny runs measure nothing")
    found = {outcome.benchmark: outcome for outcome in outcomes}
    lines = [OPENING + "\n".join(_conditions(head)), READING]
    subject = ""
    for name, benchmark in NAMES.items():
        if name not in found:
            continue
        if benchmark.subject != subject:
            subject = benchmark.subject
            lines.append(f"## {subject}\n")
        lines += _section(found[name])
    return "\n".join(lines)


def _conditions(head: Head) -> Iterator[str]:
    """Yield the rows about machine, date and commit."""
    machine = head.machine
    yield f"| machine | {machine.processor}, {machine.cores} cores, {machine.system} |"
    yield f"| Python | {machine.python} |"
    yield f"| date | {head.date} |"
    yield f"| commit | {head.commit or 'unknown'} |"
    if head.busy is not None:
        yield f"| other work of the machine at the start (load average) | {head.busy:g} |"


def _section(outcome: Outcome) -> Iterator[str]:
    """Yield the lines about one benchmark."""
    yield f"### `{outcome.benchmark}`\n"
    if outcome.error:
        yield f"Failed: {outcome.error}\n"
        return
    yield f"{outcome.about}\n"
    if outcome.figures:
        yield "| figure | value | target | note |\n|---|---|---|---|"
        yield from map(_row, outcome.figures)
    else:
        yield from outcome.lines
    yield ""


def _row(figure: Figure) -> str:
    value = value_text(figure) if figure.value is None else f"{number(figure.value)} {unit_text(figure.unit)}".strip()
    target = target_text(figure)
    if not figure.kept:
        target = f"**Missed:** {target}"
    return f"| {figure.name} | {value} | {target} | {note_text(figure)} |".replace("  ", " ")


if __name__ == "__main__":
    results, file = sys.argv[1:]
    Path(file).write_text(page(*read(Path(results))), encoding="utf-8")
