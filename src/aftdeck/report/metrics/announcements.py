"""Clearance problems that the operator or an observer announces by a key."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.report.metric import Found, Metric, Value
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.source import PONTILLO

ANNOUNCED = "announced"
"""Kind of the log line of an announcement."""
BEFORE_S = 5.0
"""Time before an alarm in which an announcement belongs to it [s]; assumed."""

COUNT = Metric(
    "announcements",
    "Problems announced",
    "count",
    "Number of times that the operator or an observer announced a clearance problem.",
    PONTILLO,
)
SHARE = Metric(
    "announced_share",
    "Alarms announced",
    "share",
    f"Share of the alarms of CLEARANCE that were announced, while they lasted or up to {BEFORE_S:g} s before.",
    PONTILLO,
)
DELAY = Metric(
    "announcement_delay",
    "Delay of announcements",
    "seconds",
    "Mean time from the beginning of an alarm of CLEARANCE to its first announcement; negative if that came before.",
)
METRICS = (COUNT, SHARE, DELAY)


class Announcements:
    """Announced clearance problems of a run, and the alarms to which they belong."""

    def __init__(self) -> None:
        self._alarms: list[tuple[float, float]] = []  # beginning and end [s]
        self._announced: list[float] = []
        self._alarm = False

    def announce(self, time_s: float) -> None:
        """Add an announcement."""
        self._announced.append(time_s)

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        alarm = frame.work.clearance_level != "info"
        if alarm and not self._alarm:
            self._alarms.append((frame.time_s, frame.time_s))
        elif alarm:
            self._alarms[-1] = (self._alarms[-1][0], frame.time_s)
        self._alarm = alarm

    def found(self) -> Iterator[Found]:
        """Yield the metrics of a run with an announcement."""
        if not self._announced:
            return
        yield COUNT, Value(float(len(self._announced)))
        if not self._alarms:
            return
        firsts = [
            next((at for at in self._announced if begin - BEFORE_S <= at <= end), None) for begin, end in self._alarms
        ]
        delays = [at - begin for at, (begin, _) in zip(firsts, self._alarms, strict=True) if at is not None]
        yield SHARE, Value(len(delays) / len(self._alarms))
        if delays:
            yield DELAY, Value(sum(delays) / len(delays))
