"""Report page of a study: one HTML file, which requests nothing from a network."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import combinations
from pathlib import Path

from aftdeck.report.intervals import Interval
from aftdeck.report.page.document import Line, Link, document
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
        InputError: the file cannot be written, or matplotlib or Jinja is not installed.
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
    good = [row for row in rows if not row["error"] and study.spec.success.ended in (row["ended"], "any")]
    return document(
        "study/report.html",
        title=study.spec.title,
        text=study.spec.text,
        facts=_facts(study, rows),
        rule=_rule(study),
        success_charts=[success_chart(factor, rows) for factor in study.factors if rows],
        success=_success(study.factors, rows),
        cases=len(rows),
        good=len(good),
        came=_came(study),
        responses=[_response(study, good, column) for column in study.responses if good],
        worst=list(_worst(study, rows, folder)),
        worst_heads=_worst_heads(study),
        errors=list(_errors(rows)),
        source=study.source,
    )


def _facts(study: Study, rows: Sequence[Row]) -> list[tuple[str, str]]:
    return [
        (str(len(rows)), "cases"),
        (_percent(success_rate(rows)), "success, with 95 % interval"),
        (str(sum(bool(row["error"]) for row in rows)), "cases with an error"),
        (study.carried.name, "scenario"),
        (str(study.spec.operator.get("kind", "script")), "operator"),
        (__version__, "version of Aftdeck"),
    ]


def _rule(study: Study) -> str:
    rule = study.spec.success
    parts = ["it completes"] if rule.ended == "completed" else ["it ends without an error"]
    parts += [f"{name} ≤ {bound:g}" for name, bound in rule.at_most.items()]
    parts += [f"{name} ≥ {bound:g}" for name, bound in rule.at_least.items()]
    return f"A case is successful if {' and '.join(parts)}."


def _came(study: Study) -> str:
    return "completed" if study.spec.success.ended == "completed" else "ended without an error"


def _success(factors: Sequence[Factor], rows: Sequence[Row]) -> Iterator[Line]:
    for factor in factors:
        for group in groups(factor, rows):
            good = f"{sum(bool(row['success']) for row in group.rows)} of {len(group.rows)}"
            yield Line((factor.name, group.label, good, _percent(success_rate(group.rows))))


def _response(study: Study, rows: Sequence[Row], column: str) -> dict[str, object]:
    """Return what the template shows of a response."""
    factors = study.factors if any(row[column] is not None for row in rows) else ()
    pairs = [pair for pair in combinations(factors, 2) if pair[1].span is None][:MOST_PAIRS]
    return {
        "title": title_of(column),
        "known": any(row[column] is not None for row in rows),
        "charts": [response_chart(factor, rows, column) for factor in factors],
        "pairs": [response_chart(first, rows, column, by=second) for first, second in pairs],
        "effects": _effects(factors, rows, column),
    }


def _effects(factors: Sequence[Factor], rows: Sequence[Row], column: str) -> Iterator[Line]:
    effects = [found for factor in factors if (found := effect(factor, rows, column)) is not None]
    for found in sorted(effects, key=lambda found: -(found.share or 0.0)):
        yield Line(
            (
                found.factor,
                f"{found.least[1]:.4g} at {found.least[0]}",
                f"{found.greatest[1]:.4g} at {found.greatest[0]}",
                f"{found.greatest[1] - found.least[1]:.4g}",
                "–" if found.share is None else f"{100.0 * found.share:.0f} %",
            )
        )


def _worst_heads(study: Study) -> list[str]:
    factors = [factor.column for factor in study.factors]
    return ["case", *factors, "seed", "ended", "success", *map(title_of, study.responses), "recording"]


def _worst(study: Study, rows: Sequence[Row], folder: Path) -> Iterator[Line]:
    by_index = {row["index"]: row for row in rows}
    shown = (*(factor.column for factor in study.factors), "seed", "ended", "success", *study.responses)
    for index in worst(study, rows):
        path = recording_of(folder, index)
        link = Link("recording", path.relative_to(folder).as_posix()) if path.exists() else "–"
        yield Line((str(index), *(_text(by_index[index][name]) for name in shown), link))


def _errors(rows: Sequence[Row]) -> Iterator[Line]:
    found = Counter(str(row["error"]) for row in rows if row["error"])
    first = {str(row["error"]): row["index"] for row in reversed(rows)}
    for text, count in found.most_common(MOST_ERRORS):
        yield Line((str(count), str(first[text]), text))


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
