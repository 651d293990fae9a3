"""What a session's steps put into a recording."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.recording.content import Entry, Recorded
from aftdeck.recording.convert import light_record, shown_record
from aftdeck.recording.records import ControllersRecord, DelayRecord, Note
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
        yield from self._late(step, wall)
        if page.controllers is not self._controllers:
            self._controllers = page.controllers
            yield ControllersRecord(step.began_s, controller_records(page.controllers), wall)
        time_s = step.frame.time_s
        yield from (_note(event, wall) for event in step.notes if event.time_s < time_s)
        if step.asked.monitors != self._monitors:
            self._monitors = step.asked.monitors
            yield shown_record(time_s, self._monitors)
        if step.lighting != self._lighting:
            self._lighting = step.lighting
            yield light_record(time_s, self._lighting)
        yield Recorded(step.inputs, step.frame, wall, step.asked.latency_ms)
        yield from (_note(event, wall) for event in step.notes if event.time_s >= time_s)

    def before_the_end(self, step: Begun) -> Iterator[Entry]:
        """Yield the entries of a step that the simulation has not made, because the run ends."""
        wall = self._wall(step)
        yield from self._late(step, wall)
        yield from (_note(event, wall) for event in step.notes)

    def _late(self, step: Begun, wall_s: float) -> Iterator[Entry]:
        if step.late is not None:
            late_s, lost_s = step.late
            yield DelayRecord(step.tick, step.began_s, round(late_s, 6), round(lost_s, 6), wall_s, step.commanded)

    def _wall(self, step: Begun) -> float:
        return round(step.now - self._began, 6)


def _note(event: Event, wall_s: float) -> Note:
    return Note(event.time_s, event.kind, event.level, event.text, wall_s)
