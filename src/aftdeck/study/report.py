"""Report page of a study: one HTML file, which requests nothing from a network."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from html import escape
from itertools import combinations
from pathlib import Path

from aftdeck.report.intervals import Interval
from aftdeck.report.page.document import Line, charts, document, facts, figure, table
from aftdeck.report.table import Row
from aftdeck.study.case import Outcome
from aftdeck.study.factor import Factor
from aftdeck.study.figures import response_chart, success_chart, title_of
from aftdeck.study.file import Study
from aftdeck.study.statistics import effect, groups, success_rate
from aftdeck.study.worst import recording_of, worst
from aftdeck.table import Cell
from aftdeck.version import __version__
from aftdeck.whole_file import write_whole

REPORT = "report.html"
"""File of the report."""
MOST_ERRORS = 20
"""Greatest number of different errors that are listed."""
MOST_PAIRS = 3
"""Greatest number of pairs of factors that are drawn together."""


def write_report(study: Study, outcomes: Sequence[Outcome], folder: Path) -> None:
    """Write the report page of a study into its folder.

    Raises:
        InputError: the file cannot be written, or matplotlib is not installed.
    """
    rows = [outcome.row for outcome in outcomes]
    write_whole(folder / REPORT, page(study, rows, folder))


def page(study: Study, rows: Sequence[Row], folder: Path) -> str:
    """Return the report page.

    Args:
        study: the study.
        rows: all cases.
        folder: folder of the study, to find the recordings.
    """
    return document(study.spec.title, _body(study, rows, folder))


def _body(study: Study, rows: Sequence[Row], folder: Path) -> Iterator[str]:
    good = [row for row in rows if not row["error"] and study.spec.success.ended in (row["ended"], "any")]
    yield f"<h1>{escape(study.spec.title)}</h1>"
    if study.spec.text:
        yield f"<p>{escape(study.spec.text)}</p>"
    yield _facts(study, rows)
    if rows and study.factors:
        yield "<h2>Success</h2>"
        yield f'<p class="note">{escape(_rule(study))} The bars are Wilson’s intervals of 95 %.</p>'
        yield charts(figure(success_chart(factor, rows)) for factor in study.factors)
        yield _success_table(study.factors, rows)
    for column in study.responses if good else ():
        yield f"<h2>{escape(title_of(column))}</h2>"
        if len(good) < len(rows):
            yield f'<p class="note">Only the {len(good)} cases that {_came(study)}.</p>'
        yield from _response(study, good, column)
    yield from _worst(study, rows, folder)
    yield from _errors(rows)
    yield "<h2>Study file</h2>"
    yield f"<details><summary>{escape(study.source.name)}</summary><pre>{escape(study.source.text)}</pre></details>"


def _facts(study: Study, rows: Sequence[Row]) -> str:
    errors = sum(bool(row["error"]) for row in rows)
    rate = success_rate(rows)
    return facts(
        [
            (str(len(rows)), "cases"),
            (_percent(rate), "success, with 95 % interval"),
            (str(errors), "cases with an error"),
            (study.carried.name, "scenario"),
            (str(study.spec.operator.get("kind", "script")), "operator"),
            (__version__, "version of Aftdeck"),
        ]
    )


def _rule(study: Study) -> str:
    rule = study.spec.success
    parts = ["it completes"] if rule.ended == "completed" else ["it ends without an error"]
    parts += [f"{name} ≤ {bound:g}" for name, bound in rule.at_most.items()]
    parts += [f"{name} ≥ {bound:g}" for name, bound in rule.at_least.items()]
    return f"A case is successful if {' and '.join(parts)}."


def _came(study: Study) -> str:
    return "completed" if study.spec.success.ended == "completed" else "ended without an error"


def _success_table(factors: Sequence[Factor], rows: Sequence[Row]) -> str:
    lines = [
        (
            factor.name,
            group.label,
            f"{sum(bool(row['success']) for row in group.rows)} of {len(group.rows)}",
            _percent(success_rate(group.rows)),
        )
        for factor in factors
        for group in groups(factor, rows)
    ]
    return table(("factor", "value", "successful", "rate, 95 % interval"), map(Line, lines))


def _response(study: Study, rows: Sequence[Row], column: str) -> Iterator[str]:
    if all(row[column] is None for row in rows):
        yield '<p class="note">No case has a value.</p>'
        return
    if not study.factors:
        return
    yield charts(figure(response_chart(factor, rows, column)) for factor in study.factors)
    pairs = [pair for pair in combinations(study.factors, 2) if pair[1].span is None][:MOST_PAIRS]
    if pairs:
        yield "<h3>Two factors together</h3>"
        yield charts(figure(response_chart(first, rows, column, by=second)) for first, second in pairs)
    yield "<h3>Main effects</h3>"
    effects = [found for factor in study.factors if (found := effect(factor, rows, column)) is not None]
    effects.sort(key=lambda found: -(found.share or 0.0))
    lines = [
        (
            found.factor,
            f"{found.least[1]:.4g} at {found.least[0]}",
            f"{found.greatest[1]:.4g} at {found.greatest[0]}",
            f"{found.greatest[1] - found.least[1]:.4g}",
            "–" if found.share is None else f"{100.0 * found.share:.0f} %",
        )
        for found in effects
    ]
    yield table(("factor", "least mean", "greatest mean", "difference", "share of the variance"), map(Line, lines))


def _worst(study: Study, rows: Sequence[Row], folder: Path) -> Iterator[str]:
    chosen = worst(study, rows)
    if not chosen:
        return
    factors, responses = [factor.column for factor in study.factors], study.responses
    by_index = {row["index"]: row for row in rows}
    yield "<h2>Worst cases</h2>"
    yield (
        '<p class="note">A recording opens with <code>aftdeck replay FILE --open</code>; '
        "<code>aftdeck study STUDY -o DIR --only CASE</code> makes one of any other case.</p>"
    )
    lines = []
    for index in chosen:
        row, path = by_index[index], recording_of(folder, index)
        link = f'<a href="{path.relative_to(folder).as_posix()}">recording</a>' if path.exists() else "–"
        values = [row[name] for name in (*factors, "seed", "ended", "success", *responses)]
        lines.append([str(index), *(escape(_text(value)) for value in values), link])
    heads = ["case", *factors, "seed", "ended", "success", *map(title_of, responses), "recording"]
    yield table(heads, map(Line, lines), escaped=True)


def _errors(rows: Sequence[Row]) -> Iterator[str]:
    found = Counter(str(row["error"]) for row in rows if row["error"])
    if not found:
        return
    first = {str(row["error"]): row["index"] for row in reversed(rows)}
    yield "<h2>Errors</h2>"
    lines = [(str(count), str(first[text]), text) for text, count in found.most_common(MOST_ERRORS)]
    yield table(("cases", "first case", "error"), map(Line, lines))


def _percent(rate: Interval) -> str:
    if rate.value != rate.value:
        return "–"
    return f"{100.0 * rate.value:.0f} % ({100.0 * rate.low:.0f} to {100.0 * rate.high:.0f})"


def _text(value: Cell) -> str:
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.4g}" if isinstance(value, float) else str(value)
