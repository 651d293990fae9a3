"""Report page of one or several recorded runs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape

from aftdeck.encodable import encodable
from aftdeck.report.catalogue import SUBJECTS
from aftdeck.report.grade import faults, grade
from aftdeck.report.intervals import mean_interval
from aftdeck.report.metric import Metric
from aftdeck.report.metrics.alarms import RAISED
from aftdeck.report.metrics.clearance import LEAST
from aftdeck.report.metrics.path import PATH
from aftdeck.report.metrics.steps import DONE, TASK
from aftdeck.report.metrics.times import RUN
from aftdeck.report.page.document import Line, charts, document, facts, table
from aftdeck.report.page.gather import Gathered
from aftdeck.report.page.pictures import pictures
from aftdeck.report.page.plots import strips, timeline, views
from aftdeck.report.words import text_of
from aftdeck.version import __version__

FACTS = (RUN, TASK, DONE, LEAST, RAISED, PATH)
"""Metrics at the head of a run's report."""


def page(runs: Sequence[Gathered]) -> str:
    """Return the report of runs as one HTML page.

    Raises:
        InputError: matplotlib is not installed.
    """
    if len(runs) == 1:
        return document(_headline(runs[0]), _run(runs[0]))
    return document(f"{len(runs)} runs", _together(runs))


def _together(runs: Sequence[Gathered]) -> Iterator[str]:
    yield f"<h1>{len(runs)} runs</h1>"
    yield table(
        ("run", "scenario", "participant", "condition", "began", "ended"),
        (
            Line(
                (
                    run.title,
                    run.scenario.title,
                    run.recording.opening.participant or "–",
                    run.recording.opening.condition or "–",
                    run.recording.opening.began[:19].replace("T", " "),
                    _ended(run),
                )
            )
            for run in runs
        ),
    )
    yield "<h2>Metrics</h2>"
    yield (
        '<p class="note">Mean with Student’s interval of 95 %, over the runs that have a value. '
        "docs/metrics.md has the definitions.</p>"
    )
    yield _metrics(runs)
    for run in runs:
        yield f"<details><summary>{escape(run.title)}: {escape(_headline(run))}</summary>"
        yield from _run(run)
        yield "</details>"


def _run(run: Gathered) -> Iterator[str]:
    opening = run.recording.opening
    about = [
        encodable(run.recording.path.name),
        opening.participant,
        opening.condition,
        opening.began[:19].replace("T", " "),
    ]
    yield f"<h1>{escape(_headline(run))}</h1>"
    yield f'<p class="note">{escape(" · ".join(filter(None, about)))} · Aftdeck {escape(__version__)}</p>'
    found = [(text_of(metric, run.metrics[metric].number), metric.title) for metric in FACTS if metric in run.metrics]
    yield facts([*found, (_grade(run), "grade")] if run.progress.steps else found)
    yield "<h2>Timeline</h2>"
    yield charts([timeline(run)], whole=True)
    if run.progress.steps:
        yield "<h2>Steps of the task</h2>"
        yield _steps(run)
    yield "<h2>Key moments</h2>"
    yield charts(pictures(run))
    yield "<h2>Path</h2>"
    yield charts(views(run))
    yield "<h2>Strip charts</h2>"
    yield charts(strips(run, shown=True))
    yield f"<details><summary>More strip charts</summary>{charts(strips(run, shown=False))}</details>"
    yield "<h2>Metrics</h2>"
    yield _metrics([run])
    yield "<h2>Events</h2>"
    yield _events(run)


def _headline(run: Gathered) -> str:
    return f"{run.scenario.title}, {_ended(run)}"


def _ended(run: Gathered) -> str:
    return {"": "cut short", "time": "ended by time"}.get(run.recording.ended, run.recording.ended)


def _grade(run: Gathered) -> str:
    complete = run.progress.present is None and not run.progress.skipped
    return grade(faults(run.metrics)) if complete else "–"


def _steps(run: Gathered) -> str:
    lines, before = [], 0.0
    for step, done_s in zip(run.progress.steps, run.progress.done_s, strict=True):
        took = "–" if done_s is None else f"{done_s - before:.1f} s"
        lines.append(Line((step.title, "not done" if done_s is None else f"{done_s:.1f} s", took)))
        before = before if done_s is None else done_s
    return table(("step", "done at", "took"), lines, numbers=(1, 2))


def _metrics(runs: Sequence[Gathered]) -> str:
    """Return the metrics for which a run has a value, by subject, the runs side by side, with means and intervals."""
    lines: list[Line] = []
    for subject, metrics in SUBJECTS.items():
        known = [metric for metric in metrics if any(metric in run.metrics for run in runs)]
        if known:
            lines.append(Line((subject,), "subject"))
        lines += [_line(metric, runs) for metric in known]
    if len(runs) == 1:
        return table(("", "value", "where"), lines, numbers=(1,))
    heads = ("", *(run.title for run in runs), "mean, 95 % interval")
    return table(heads, lines, numbers=range(1, len(heads)))


def _line(metric: Metric, runs: Sequence[Gathered]) -> Line:
    found = [run.metrics.get(metric) for run in runs]
    texts = ["–" if value is None else value.text or text_of(metric, value.number) for value in found]
    if len(runs) == 1:
        value = found[0]
        return Line((metric.title, *texts, "" if value is None else value.detail), "" if value is None else value.level)
    numbers = [value.number for value in found if value is not None and value.number is not None]
    return Line((metric.title, *texts, _mean(metric, numbers)))


def _mean(metric: Metric, numbers: Sequence[float]) -> str:
    if not numbers:
        return "–"
    mean = mean_interval(numbers)
    if len(numbers) == 1:
        return text_of(metric, mean.value)
    return f"{text_of(metric, mean.value)} ({text_of(metric, mean.low)} to {text_of(metric, mean.high)})"


def _events(run: Gathered) -> str:
    lines = [Line((f"{event.time_s:.2f}", event.kind, event.text), event.level) for event in run.events]
    return table(("time [s]", "kind", "text"), lines, numbers=(0,))
