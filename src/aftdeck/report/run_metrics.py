"""All metrics of one run, collected frame by frame."""

from __future__ import annotations

from aftdeck.plant.readings import Readings
from aftdeck.recording.delays import Delays
from aftdeck.recording.message import Message
from aftdeck.recording.records import ControllersRecord, Note, Shown
from aftdeck.report.lamps import Lamp
from aftdeck.report.metric import Collector, Metric, Value
from aftdeck.report.metrics.alarms import Alarms
from aftdeck.report.metrics.announcements import ANNOUNCED, Announcements
from aftdeck.report.metrics.clearance import Collisions
from aftdeck.report.metrics.desk import Desk
from aftdeck.report.metrics.moments import Moments
from aftdeck.report.metrics.path import Path
from aftdeck.report.metrics.pictures import Pictures
from aftdeck.report.metrics.steps import Steps
from aftdeck.report.metrics.sticks import Sticks
from aftdeck.report.metrics.stopping import Stopping
from aftdeck.report.metrics.times import Times
from aftdeck.report.recorded import ReadingMetrics
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.reading import Known
from aftdeck.task.progress import Progress


class RunMetrics:
    """Metrics of one run: the same for a person's flight, a script's and a policy's, live or recorded.

    A re-initialisation begins them again.

    Args:
        scenario: the scenario.
        progress: progress through its task that someone else updates by the same frames; None to compute it here.
    """

    def __init__(self, scenario: Scenario, progress: Progress | None = None) -> None:
        self._scenario, self._progress = scenario, progress
        self._desk, self._pictures = Desk(), Pictures(scenario)
        self._begin()

    def _begin(self) -> None:
        scenario, period_s = self._scenario, self._scenario.control_period
        self._alarms, self._readings = Alarms(), ReadingMetrics(scenario)
        self._announcements = Announcements()
        self._steps = Steps(scenario, self._progress)
        self._collectors: tuple[Collector, ...] = (
            Times(period_s),
            self._steps,
            Path(),
            Moments(scenario),
            Collisions(),
            Sticks(period_s),
            Stopping(),
            self._pictures,
            self._announcements,
        )
        self._before: Frame | None = None

    def see(self, frame: Frame, lamps: tuple[Lamp, ...], readings: Readings | None = None) -> None:
        """Add the next frame, the lamps that are lit in it, and the readings of its step; None without gauges."""
        if frame.events and any(event.kind == "initialise" for event in frame.events):
            self._begin()
        for collector in self._collectors:
            collector.see(frame, self._before)
        self._alarms.see(lamps)
        self._readings.see(Known(frame, self._scenario, readings))
        self._before = frame

    def note(self, message: Message) -> None:
        """Add a recorded message between two frames: devices or cameras in use from now on, or an announcement."""
        if isinstance(message, ControllersRecord):
            self._desk.use(message.controllers)
        elif isinstance(message, Shown):
            self._pictures.shown((message.mon_1, message.mon_2))
            self._steps.look()
        elif isinstance(message, Note) and message.kind == ANNOUNCED:
            self._announcements.announce(message.time_s)

    @property
    def progress(self) -> Progress:
        """Progress through the steps of the task."""
        return self._steps.progress

    def found(self, delays: Delays | None = None) -> dict[Metric, Value]:
        """Return every metric for which the run has data.

        Args:
            delays: delays of the steps; None if they are not known, as in a headless run.
        """
        found: dict[Metric, Value] = {}
        for collector in self._collectors:
            found.update(collector.found())
        found.update(self._alarms.found())
        found.update(self._readings.found())
        found.update(self._desk.found(delays))
        return found
