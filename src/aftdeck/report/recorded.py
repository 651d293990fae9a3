"""Metrics of readings: each is a reading and a reducer."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from aftdeck.report.metric import Found, Metric
from aftdeck.report.reduction import Reduction
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.readings.quantity import Quantity
from aftdeck.simulation.readings.reading import Known, Reading, Recorded, Reducer
from aftdeck.simulation.readings.table import SECTIONS, readings_of
from aftdeck.tuples import MOST_JOINTS

_SENTENCES: dict[Reducer, str] = {
    "greatest": "Greatest {}.",
    "least": "Least {}.",
    "mean": "Mean over time of the {}.",
    "last": "{}, at the end.",
    "integral": "Sum over time of the {}.",
    "time": "Time {}.",
    "share": "Share of the run's time {}.",
    "begun": "Number of times that {}.",
}
"""Definition that each reducer makes of the reading's definition."""
_QUANTITIES: dict[Reducer, Quantity] = {"time": "time", "share": "share", "begun": "count"}
"""Quantity that a reducer makes of any other."""


def metrics_of(reading: Reading, how: Recorded, joints: int = MOST_JOINTS) -> tuple[Metric, ...]:
    """Return the definition of a metric, or one for each joint."""
    sentence = how.definition or _SENTENCES[how.by].format(reading.definition)
    sentence = sentence[0].upper() + sentence[1:]
    source, quantity = reading.source, how.quantity or _QUANTITIES.get(how.by, reading.quantity)
    if reading.parts != "joints":
        assert not reading.parts, f"{reading.name}: a metric of one number, or of one for each joint"
        return (Metric(how.name, how.title, quantity, sentence, source),)
    return tuple(
        Metric(f"{how.name}_joint_{k}", f"{how.title}, joint {k}", quantity, sentence.replace("{k}", str(k)), source)
        for k in range(1, joints + 1)
    )


_ALL = [
    (subject, reading, metric)
    for subject, section in SECTIONS
    for reading in section
    for how in reading.metrics
    for metric in metrics_of(reading, how)
]
_AT_ONCE = 64
"""Number of steps whose values are reduced at once."""
_BY_COLUMN = {metric.column: metric for _, _, metric in _ALL}
NEED_GAUGES = frozenset(metric.column for _, reading, metric in _ALL if reading.needs == "gauges")
"""Columns of the metrics that need gauges."""


def recorded(column: str) -> Metric:
    """Return the metric of a reading with this column of tables."""
    return _BY_COLUMN[column]


def with_recorded(subject: str, metrics: Sequence[Metric]) -> tuple[Metric, ...]:
    """Return metrics of a subject, and after them those of its readings that are not among them."""
    return (*metrics, *(metric for each, _, metric in _ALL if each == subject and metric not in metrics))


class ReadingMetrics:
    """Metrics of a run's readings.

    The steps are collected, and their values computed and reduced many at a time.
    """

    def __init__(self, scenario: Scenario) -> None:
        kept = [
            (reading, how.of or reading.of, _reductions(reading, how, scenario))
            for reading in readings_of(scenario)
            for how in reading.metrics
        ]
        self._reductions = [reduction for _, _, reductions in kept for reduction in reductions]
        self._always = [
            (of, reductions, reading.parts) for reading, of, reductions in kept if reading.needs != "gauges"
        ]
        self._gauged = [
            (of, reductions, reading.parts) for reading, of, reductions in kept if reading.needs == "gauges"
        ]
        self._steps: list[Known] = []

    def see(self, known: Known) -> None:
        """Add the next step."""
        self._steps.append(known)
        if len(self._steps) == _AT_ONCE:
            self._reduce()

    def _reduce(self) -> None:
        """Reduce the values in the collected steps."""
        steps, self._steps = self._steps, []
        gauged = [step for step in steps if step.gauges is not None]
        for readings, known in ((self._always, steps), (self._gauged, gauged)):
            for of, reductions, parts in readings if known else ():
                values = list(map(of, known))
                columns = zip(*values, strict=True) if parts else (values,)
                for reduction, column in zip(reductions, columns, strict=True):
                    reduction.see(column, known)

    def found(self) -> Iterator[Found]:
        """Yield the metrics for which there were values."""
        self._reduce()
        return filter(None, [reduction.found() for reduction in self._reductions])


def _reductions(reading: Reading, how: Recorded, scenario: Scenario) -> list[Reduction]:
    """Return the reduction of a reading's values, or one for each joint."""
    joints = scenario.arm.joints
    metrics = metrics_of(reading, how, len(joints))
    return [
        Reduction(metric, how, joint, scenario.control_period)
        for metric, joint in zip(metrics, joints if reading.parts == "joints" else ("",), strict=True)
    ]
