"""Control step of a session, as those see it who observe a session: recorder, task, log, painter, and others."""

from __future__ import annotations

from typing import NamedTuple, Protocol

import msgspec

from aftdeck.recording.delays import Delays
from aftdeck.report.lamps import Lamp
from aftdeck.scenario.light import Lighting
from aftdeck.simulation.frame import Event, Frame, Level
from aftdeck.simulation.inputs import Inputs
from aftdeck.station.core.asked import Asked
from aftdeck.station.messages.frame import AutopilotName, Debrief, LinkSteps


class Delay(NamedTuple):
    """Delay of one step.

    Attributes:
        late_s: time from the moment when the step was due to its beginning [s].
        lost_s: part of it by which all following steps are postponed [s]: all or nothing.
    """

    late_s: float = 0.0
    lost_s: float = 0.0


PUNCTUAL = Delay()


class Begun(msgspec.Struct):
    """Control step that has begun: the simulation has not made it yet."""

    tick: int
    """Its number."""
    now: float
    """Time at its beginning [s], on the clock of the session's host."""
    began_s: float
    """Simulated time at its beginning [s]."""
    late: Delay | None
    """Delay, if it is longer than a control period."""
    delays: Delays
    """Delays of the run's steps so far."""
    commanded: bool
    """Whether an input had been given before."""
    notes: list[Event]
    """Lines of the session's own for the log."""
    restarted: bool = False
    """Whether it is the first step of a new run."""

    @property
    def time_s(self) -> float:
        """Simulated time that the step has reached [s]."""
        return self.began_s

    def note(self, kind: str, text: str, level: Level = "info") -> None:
        """Add a line of the session's own to the log."""
        self.notes.append(Event(self.time_s, kind, level, text))


class Step(Begun, kw_only=True):
    """Control step that was made, and what is new."""

    asked: Asked
    """What the pages asked for."""
    inputs: Inputs | None
    """The simulation's inputs; None if the script supplies them."""
    frame: Frame
    """The frame."""
    lamps: tuple[Lamp, ...]
    """Lit lamps."""
    autopilot: AutopilotName | None
    """What flies; None: the operator."""
    link: LinkSteps
    """Number of the step, and the steps that the pages show when it has been made."""
    debrief: Debrief | None = None
    """Result of the operator's task; None until all its steps are past."""

    @property
    def time_s(self) -> float:
        """Simulated time at the end of the step [s]."""
        return self.frame.time_s

    @property
    def lighting(self) -> Lighting:
        """Lighting during the step."""
        return self.asked.lighting


class Observer(Protocol):
    """Observer of a session: it sees each step after it was made."""

    def see(self, step: Step) -> None:
        """Take what this observer needs of a step."""
