"""Report page of one or several recorded runs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from aftdeck.encodable import encodable
from aftdeck.report.catalogue import SUBJECTS, named
from aftdeck.report.grade import faults, grade
from aftdeck.report.intervals import mean_interval
from aftdeck.report.metric import Metric
from aftdeck.report.page.document import Line, document
from aftdeck.report.page.gather import Gathered
from aftdeck.report.page.pictures import key_moments
from aftdeck.report.page.plots import strips, timeline, views
from aftdeck.report.words import text_of
from aftdeck.version import __version__

FACTS = tuple(map(named, ("run_time_s", "task_time_s", "steps_done", "min_clearance_m", "alarms", "tip_path_m")))
"""Metrics at the head of a run's report."""


def page(runs: Sequence[Gathered]) -> str:
    """Return the report of runs as one HTML page.

    Raises:
        InputError: Jinja is not installed.
    """
    return document(
        "report/page/runs.html",
        title=_headline(runs[0]) if len(runs) == 1 else f"{len(runs)} runs",
        overview=map(_overview, runs),
        metrics=_metrics(runs),
        runs=list(map(_run, runs)),
    )


def _overview(run: Gathered) -> Line:
    opening = run.recording.opening
    who = (opening.participant or "–", opening.condition or "–")
    return Line((run.title, run.scenario.title, *who, _began(run), _ended(run)))


def _run(run: Gathered) -> dict[str, object]:
    """Return what the template ``run.html`` shows of a run."""
    opening = run.recording.opening
    about = (encodable(run.recording.path.name), opening.participant, opening.condition, _began(run))
    facts = [(text_of(metric, run.metrics[metric].number), metric.title) for metric in FACTS if metric in run.metrics]
    return {
        "title": run.title,
        "headline": _headline(run),
        "about": " · ".join([*filter(None, about), f"Aftdeck {__version__}"]),
        "facts": [*facts, (_grade(run), "grade")] if run.progress.steps else facts,
        "timeline": timeline(run),
        "steps": list(_steps(run)),
        "moments": key_moments(run),
        "views": views(run),
        "strips": strips(run, shown=True),
        "more_strips": strips(run, shown=False),
        "metrics": _metrics([run]),
        "events": [Line((f"{event.time_s:.2f}", event.kind, event.text), event.level) for event in run.events],
    }


def _headline(run: Gathered) -> str:
    return f"{run.scenario.title}, {_ended(run)}"


def _ended(run: Gathered) -> str:
    return {"": "cut short", "time": "ended by time"}.get(run.recording.ended, run.recording.ended)


def _began(run: Gathered) -> str:
    return run.recording.opening.began[:19].replace("T", " ")


def _grade(run: Gathered) -> str:
    complete = run.progress.present is None and not run.progress.skipped
    return grade(faults(run.metrics)) if complete else "–"


def _steps(run: Gathered) -> Iterator[Line]:
    before = 0.0
    for step, done_s in zip(run.progress.steps, run.progress.done_s, strict=True):
        took = "–" if done_s is None else f"{done_s - before:.1f} s"
        yield Line((step.title, "not done" if done_s is None else f"{done_s:.1f} s", took))
        before = before if done_s is None else done_s


def _metrics(runs: Sequence[Gathered]) -> Iterator[Line]:
    """Yield the metrics for which a run has a value, by subject, the runs side by side, with means and intervals."""
    for subject, metrics in SUBJECTS.items():
        known = [metric for metric in metrics if any(metric in run.metrics for run in runs)]
        if known:
            yield Line((subject,), "subject")
        yield from (_line(metric, runs) for metric in known)


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
