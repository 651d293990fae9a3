"""Everything that a report page shows of one run, collected in one pass over its recording."""

from __future__ import annotations

import math
from array import array
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.encodable import encodable
from aftdeck.errors import RecordingError
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.gauged import messages_of
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord, Note, Opening, Shown
from aftdeck.report.curves import Lane, Strip
from aftdeck.report.lamps import lit_lamps
from aftdeck.report.lanes import Lanes
from aftdeck.report.metric import Metric, Value
from aftdeck.report.run_metrics import RunMetrics
from aftdeck.report.strips import Strips
from aftdeck.scenario.model import Scenario
from aftdeck.scene.everything import ScenePoses
from aftdeck.simulation.frame import Event, Frame
from aftdeck.task.progress import Progress

TURNING_POINTS = {
    "acquired": "acquired",
    "released": "released",
    "docked": "docked",
    "latched": "latched",
    "unlatched": "unlatched",
    "unseated": "out of its berth",
    "inhibit": "contact",
    "fault": "fault",
}
"""Kinds of log lines at which something happens to the payload or the arm, each with its name."""
PATH_POINTS = 2000
"""Greatest number of points of a drawn path."""
MOST_TURNING_POINTS = 9
"""Greatest number of turning points that are shown, the first ones."""
_NONE = (math.nan, math.nan, math.nan)


class Moment(NamedTuple):
    """A key moment of a run.

    Attributes:
        title: what happens.
        frame: the frame.
        monitors: cameras on the monitors then; empty if no page showed any.
    """

    title: str
    frame: Frame
    monitors: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Gathered:
    """Data of one run.

    Attributes:
        recording: the recording, read to its end.
        metrics: all metrics for which the run has data.
        progress: progress through the task.
        lanes: phase, mode, monitors, alarms and limits over the run.
        strips: curves over the run.
        tip: (n, 3) path of the tip in the scene [m].
        held: (n, 3) path of the held payload in the scene [m]; NaN while none is held.
        moments: key moments, in their order.
        events: log lines.
    """

    recording: Recording
    metrics: Mapping[Metric, Value]
    progress: Progress
    lanes: tuple[Lane, ...]
    strips: tuple[Strip, ...]
    tip: Array
    held: Array
    moments: tuple[Moment, ...]
    events: tuple[Event, ...]

    @property
    def scenario(self) -> Scenario:
        """Scenario of the run; runs of equal scenarios have the same one, which is not sent from process to process."""
        return scenario_of_run(self.recording.opening)

    @property
    def title(self) -> str:
        """Title of the run: the name of its file."""
        return encodable(self.recording.path.stem)


def scenario_of_run(opening: Opening) -> Scenario:
    """Return the scenario of a recording with this header, as `scenario_of` does; of equal ones the same."""
    return _scenario_of(
        msgspec.structs.replace(opening, began="", seed=0, participant="", condition="", environment=None)
    )


_scenario_of = lru_cache(maxsize=4)(scenario_of)


def with_gauges(recording: Recording) -> Gathered:
    """Return the data of a recorded run, with the metrics that need gauges; raises as `gathered`."""
    return gathered(recording, gauged=True)


def gathered(recording: Recording, *, gauged: bool = False) -> Gathered:
    """Return the data of a recorded run.

    Args:
        recording: the recording.
        gauged: as for `metrics_of`.

    Raises:
        RecordingError: the recording has no step, or is damaged, or its re-simulation differs from it.
    """
    scenario = scenario_of_run(recording.opening)
    period_s = recording.opening.control_period_s
    metrics, lanes, strips = RunMetrics(scenario), Lanes(period_s), Strips(scenario, period_s)
    poses = ScenePoses(scenario)
    tip, held, events = array("d"), array("d"), list[Event]()
    moments = _Moments()
    for message, gauges in messages_of(recording, gauged=gauged):
        if isinstance(message, FrameRecord):
            lamps = lit_lamps(scenario, message, recording.delays)
            metrics.see(message, lamps, gauges)
            lanes.add(message, lamps)
            strips.add(message, message.latency_ms)
            events += message.events
            moments.see(message)
            tip.extend(message.position)
            held.extend(next((payload.position for payload in message.work.cargo if payload.held), _NONE))
            continue
        metrics.note(message)
        if isinstance(message, Note):
            events.append(Event(message.time_s, message.kind, message.level, message.text))
        elif isinstance(message, Shown):
            lanes.shown((message.mon_1, message.mon_2))
            moments.monitors = (*message.mon_1, *message.mon_2)
    if not tip:
        raise RecordingError(f"{recording.path}: ends before its first step and has no report", "empty")
    return Gathered(
        recording,
        metrics.found(recording.delays),
        metrics.progress,
        lanes.lanes(),
        strips.strips(),
        _path(tip, poses),
        _path(held, poses),
        moments.chosen(),
        tuple(events),
    )


class _Moments:
    """Collector of the key moments.

    Attributes:
        monitors: cameras on the monitors from the next frame on.
    """

    def __init__(self) -> None:
        self.monitors: tuple[str, ...] = ()
        self._found: list[Moment] = []
        self._least: Moment | None = None
        self._clearance = math.inf
        self._last: Moment | None = None

    def see(self, frame: Frame) -> None:
        """Add the next frame."""
        self._last = Moment("end", frame, self.monitors)
        if not self._found:
            self._found.append(self._last._replace(title="start"))
        for event in frame.events:
            name = TURNING_POINTS.get(event.kind)
            if name is not None and (event.kind != "inhibit" or event.level == "warning"):
                self._found.append(self._last._replace(title=name))
        near = frame.work.nearest
        if near is not None and near.clearance < self._clearance:
            self._clearance, self._least = near.clearance, self._last._replace(title="smallest clearance")

    def chosen(self) -> tuple[Moment, ...]:
        """Return the moments in their order; of several in one step, the first."""
        found = [*self._found[: MOST_TURNING_POINTS + 1], *filter(None, (self._least, self._last))]
        by_tick: dict[int, Moment] = {}
        for moment in found:
            by_tick.setdefault(moment.frame.tick, moment)
        return tuple(sorted(by_tick.values(), key=lambda moment: moment.frame.tick))


def _path(values: array[float], poses: ScenePoses) -> Array:
    """Return points in L as points (n, 3) in the scene, thinned."""
    points = np.asarray(values).reshape(-1, 3)
    every = -(-len(points) // PATH_POINTS)
    kept = np.concatenate([points[::every], points[-1:]])
    return np.array([poses.point(tuple(point)) for point in kept.tolist()])
