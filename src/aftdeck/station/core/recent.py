"""Last minutes of a run, for pages that draw strips."""

from __future__ import annotations

from collections import deque
from itertools import islice
from threading import Lock
from typing import NamedTuple

from aftdeck.report.lanes import Lanes
from aftdeck.report.strips import blank, curve_values, worst_joint
from aftdeck.scenario.model import Scenario
from aftdeck.station.core.step import Step
from aftdeck.station.messages import to_page

KEPT_S = 300.0
"""Length of the stored part of the run [s]."""
SPACING_S = 0.1
"""Time from one sample to the next [s]; the page updates its numbers at the same rate."""
DECIMALS = 5
"""Number of decimals of a sample's values; lengths [m] are thus rounded to a hundredth of a millimetre."""


class Mark(NamedTuple):
    """Mark in the data of a run; a page has already received all data before the mark.

    Attributes:
        run: the run.
        samples: number of samples of the run before the mark.
        starts: number of lane intervals that started before the mark.
    """

    run: RecentRun
    samples: int
    starts: int


class RecentRun:
    """Strips and lanes of the last `KEPT_S` seconds of a run. One thread adds data, another thread reads it."""

    def __init__(self, scenario: Scenario) -> None:
        period = scenario.control_period
        self._scenario = scenario
        self._every = max(1, round(SPACING_S / period))
        self._ticks_kept = round(KEPT_S / period)
        self._strips, self._values = blank(scenario), curve_values(scenario)
        self._lanes = Lanes(period)
        self._samples: deque[to_page.Sample] = deque(maxlen=self._ticks_kept // self._every)
        self._count = 0
        self._lock = Lock()

    def see(self, step: Step) -> None:
        """Add a step: its frame and lit lamps, and the reported latency and cameras on the monitors."""
        frame = step.frame
        with self._lock:
            self._lanes.shown((*step.asked.monitors, (), ())[:2])
            self._lanes.add(frame, step.lamps)
            if (frame.tick - 1) % self._every:
                return
            self._lanes.forget(frame.tick - self._ticks_kept)
            values = self._values(frame, step.asked.latency_ms)
            rounded = tuple([None if value is None else round(value, DECIMALS) for value in values])
            self._samples.append(to_page.Sample(frame.time_s, rounded, worst_joint(frame, self._scenario)))
            self._count += 1

    def news(self, sent: Mark | None) -> tuple[to_page.Recent, Mark] | None:
        """Return the data that a page has not received yet, and the mark for the next call.

        Args:
            sent: the mark returned by the last call; None: the page has received nothing.

        Returns:
            Message and new mark; None if there is no new sample.
        """
        with self._lock:
            begins = sent is None or sent.run is not self
            known = 0 if begins or sent is None else sent.samples
            if known == self._count:
                return None
            new = min(self._count - known, len(self._samples))
            samples = tuple(islice(self._samples, len(self._samples) - new, None))
            changed = sent is None or begins or sent.starts != self._lanes.starts
            lanes = self._lanes.lanes() if changed else ()
            mark = Mark(self, self._count, self._lanes.starts)
            return to_page.Recent(self._strips if begins else (), samples, lanes), mark
