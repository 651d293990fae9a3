"""What a session's steps put into a recording."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.recording.content import Entry, Recorded
from aftdeck.recording.convert import light_record
from aftdeck.recording.records import ControllersRecord, DelayRecord, Note, Shown
from aftdeck.scenario.light import Lighting
from aftdeck.simulation.frame import Event
from aftdeck.station.core.commands import controller_records
from aftdeck.station.core.page_inputs import NO_CONTROLLERS
from aftdeck.station.core.step import Begun, Step
from aftdeck.station.messages import from_page, kinds


class Entries:
    """Entries of one run's recording. What is recorded when it changes is compared with the step before."""

    def __init__(self, began: float) -> None:
        """Begin a run at the time `began` [s], on the clock of the session's host."""
        self._began = began
        self._controllers: from_page.Controllers = NO_CONTROLLERS
        self._monitors: tuple[kinds.Monitor, ...] = ()
        self._lighting: Lighting | None = None

    def of(self, step: Step) -> Iterator[Entry]:
        """Yield the entries of a step: what it begins with, its inputs and frame, and the lines about its result."""
        wall, page = self._wall(step), step.asked.page
        yield from self.late(step)
        if page.controllers is not self._controllers:
            self._controllers = page.controllers
            yield ControllersRecord(step.began_s, controller_records(page.controllers), wall)
        yield from (_note(event, wall) for event in step.notes if event.time_s < step.frame.time_s)
        time_s = step.frame.time_s
        if step.asked.monitors != self._monitors:
            self._monitors = step.asked.monitors
            mon_1, mon_2 = (*self._monitors, (), ())[:2]
            yield Shown(time_s, mon_1, mon_2)
        if step.lighting != self._lighting:
            self._lighting = step.lighting
            yield light_record(time_s, self._lighting)
        yield Recorded(step.inputs, step.frame, wall, step.asked.latency_ms)
        yield from (_note(event, wall) for event in step.notes if event.time_s >= time_s)

    def late(self, step: Begun) -> Iterator[Entry]:
        """Yield the entry of a late step, with which a run can also end."""
        if step.late is not None:
            late_s, lost_s = step.late
            yield DelayRecord(
                step.tick,
                step.began_s,
                round(late_s, 6),
                round(lost_s, 6),
                self._wall(step),
                step.commanded,
            )

    def _wall(self, step: Begun) -> float:
        return round(step.now - self._began, 6)


def _note(event: Event, wall_s: float) -> Note:
    return Note(event.time_s, event.kind, event.level, event.text, wall_s)
