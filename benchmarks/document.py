"""``python -m benchmarks.document RESULTS``: write docs/figures.md, and what other pages quote from it.

A quotation is a link whose title names a figure: ``[1.2 µs](figures.md#collision "verdict, cold, boxes")``.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

from benchmarks.measure import Figure
from benchmarks.names import NAMES
from benchmarks.results import ROOT, Head, Outcome, read
from benchmarks.table import note_text, target_text, unit_text, value_text

PAGE = ROOT / "docs" / "figures.md"
QUOTING = (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")))
"""Documents that may quote."""
QUOTATION = re.compile(r'\[(?P<value>[^]]*)](?P<rest>\((?:docs/)?figures\.md#(?P<name>[\w-]+) "(?P<figure>[^"]+)"\))')
OPENING = """\
# Figures

The speed of Aftdeck, measured by one command on one machine. A command writes this page; do not edit it. Other pages
quote from it.

| | |
|---|---|
"""
READING = """
To repeat the measurement, run `make bench`. It prints the figures and the path of its file of results. Then
`.venv/bin/python -m benchmarks.document RESULTS` writes this page from that file, and what other pages quote.
`make bench ARGS="collision reach"` measures these two subjects only. `make bench BASE=COMMIT` compares this version
with another commit: both run their own benchmarks in turn.

A time says as much of the machine as of the program. Therefore most targets are shares of another figure of the same
run: of the same work by another library, of a plain loop, or of a part of the work. The note gives the measured share
and the greatest allowed one. A target without a share is for something that a person waits for, or for a size.
"""


def page(head: Head, outcomes: Iterable[Outcome]) -> str:
    """Return the page as Markdown.

    Raises:
        ValueError: the results are those of a tiny run, or some are missing.
    """
    if head.size != "FULL":
        raise ValueError(f"got results of a {head.size} run, expected FULL: tiny runs measure nothing")
    found = {outcome.benchmark: outcome for outcome in outcomes}
    if missing := [name for name, benchmark in NAMES.items() if benchmark.by_default and name not in found]:
        raise ValueError(f"the file of results has no {', '.join(missing)}; expected a run of all benchmarks")
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


def quoted(text: str, outcomes: Iterable[Outcome]) -> str:
    """Return a document whose quotations have the values of these outcomes.

    Raises:
        ValueError: a quoted figure does not exist.
    """
    values = {
        (outcome.benchmark, figure.name): _with_unit(figure) for outcome in outcomes for figure in outcome.figures
    }

    def value(found: re.Match[str]) -> str:
        key = found["name"], found["figure"]
        if key not in values:
            names = ", ".join(figure for name, figure in values if name == found["name"])
            raise ValueError(f"no figure {key[1]!r} of the benchmark {key[0]!r}; available: {names or 'none'}")
        return f"[{values[key]}]{found['rest']}"

    return QUOTATION.sub(value, text)


def _with_unit(figure: Figure) -> str:
    """Return a value with its unit."""
    return f"{value_text(figure)} {'' if figure.value is None else unit_text(figure.unit)}".strip()


def _row(figure: Figure) -> str:
    value = _with_unit(figure)
    target = target_text(figure)
    if not figure.kept:
        target = f"**Missed:** {target}"
    return f"| {figure.name} | {value} | {target} | {note_text(figure)} |".replace("  ", " ")


if __name__ == "__main__":
    (results,) = sys.argv[1:]
    head, outcomes = read(Path(results))
    made = page(head, outcomes)
    quoting = {file: quoted(file.read_text(encoding="utf-8"), outcomes) for file in QUOTING}
    for file, text in (quoting | {PAGE: made}).items():
        file.write_text(text, encoding="utf-8")
