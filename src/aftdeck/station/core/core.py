"""Core of a session: one scenario's runs, flown by what its pages ask for.

The core has no thread, clock, file, socket or process. A host steps it, gives it the time, brings it the messages of
the pages, and sends them what is new: a server with threads and WebSockets (`session.session`), or the caller itself
(`direct`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

import msgspec

from aftdeck.errors import InputError
from aftdeck.recording.content import Ended
from aftdeck.recording.delays import Delays
from aftdeck.report.lamps import StandingLamps, lit_lamps
from aftdeck.report.metrics.announcements import ANNOUNCED
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Event, Frame, Level
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.conversion.welcome_of import changed_of, welcome_of
from aftdeck.station.core.asked import Asked
from aftdeck.station.core.autopilot import SCRIPT, Autopilots, Engaged
from aftdeck.station.core.commands import inputs_of, travel
from aftdeck.station.core.desk import Answer, Desk, Page
from aftdeck.station.core.light import Lights
from aftdeck.station.core.link import Link, LinkDelays
from aftdeck.station.core.look import Look
from aftdeck.station.core.lost_time import LostTime
from aftdeck.station.core.page_inputs import SILENCE, Taken
from aftdeck.station.core.pulses import Pulses
from aftdeck.station.core.release import ReleaseQuestion
from aftdeck.station.core.roles import ControlRoles
from aftdeck.station.core.step import PUNCTUAL, Begun, Delay, Observer, Step
from aftdeck.station.core.task_run import TaskRun
from aftdeck.station.core.telemetry import Telemetry
from aftdeck.station.core.typewriter import Console, Now, Typewriter
from aftdeck.station.core.unattended import safe_inputs
from aftdeck.station.messages import from_page, to_page

LOOK_S = 5.0
"""Time span of the look-ahead at the start of a session [s]; a page can set another one."""
MOVED = 1e-3
"""Stick deflection above which the operator takes control from the script or another autopilot."""
QUIET_S = 1.0
"""Time after the announcement of a clearance problem in which others are ignored [s]."""

OF_CONSOLE = from_page.TypeLine | from_page.CompleteLine
"""Messages of the console."""

_encoder = msgspec.json.Encoder()


class Recording(Observer, Protocol):
    """Recording of a session's runs, by its host."""

    def begin(self, scenario: Scenario, seed: int, now: float) -> None:
        """Begin a run at the time `now` [s], on the host's clock."""

    def end(self, ended: Ended, step: Begun | None = None) -> None:
        """End a run; `step`: the step that the simulation has not made, whose delay and notes belong to the run."""

    @property
    def recorded(self) -> bool:
        """Whether the present run is recorded."""


class Core:
    """Session of one scenario: its simulation, what its pages ask for, its log and its observers.

    Attributes:
        scenario: the scenario that is run.
        welcome: first message to a new page.
        desk: what the pages ask for.
        link: how late the pages show what the session does.
        telemetry: log and last minutes, as the pages show them.
        log: the log of the telemetry.
        newest: newest frame, encoded as JSON; empty before the first step.
        changed: what changes in flight have changed in the welcome, encoded as JSON; empty before the first change.
        observers: further observers, which see each step last.
    """

    def __init__(
        self,
        scenario: Scenario,
        seed: int | None = None,
        *,
        clock: Callable[[], float],
        recording: Recording | None = None,
        observers: Sequence[Observer] = (),
        console: Console | None = None,
        demo: bool = False,
        shown: bool = False,
        autopilots: Autopilots | None = None,
        roles: ControlRoles[Page] | None = None,
    ) -> None:
        """Prepare a run.

        Args:
            scenario: the scenario to run.
            seed: random seed; None selects the scenario's seed.
            clock: returns the host's time [s].
            recording: records the runs; None: they are not recorded.
            observers: further observers.
            console: answers the lines of the console; None: the core does it.
            demo: whether the script runs until the operator moves a stick or sends a command; also after a restart.
            shown: whether the script runs in this way in the first run.
            autopilots: returns the autopilot that flies a scenario in this way, if the script does not; None: none.
            roles: control roles of the pages; None: of no page yet.
        """
        self.scenario, self.observers = scenario, tuple(observers)
        self._seed, self._clock, self._recording = seed, clock, recording
        self._first = SCRIPT if demo else autopilots(scenario) if autopilots else None
        self._console = console or Typewriter(scenario)
        self._displays = Displays(scenario)
        self.welcome = welcome_of(scenario, demo=demo or shown)
        self.desk: Desk = Desk(
            self.welcome, scenario.delay, scenario.lighting, clock, ControlRoles(clock) if roles is None else roles
        )
        self.link = Link(scenario.control_period, LinkDelays(scenario.telemetry_delay, scenario.camera_delay))
        self.telemetry = Telemetry(scenario)
        self.log = self.telemetry.log
        self.newest = self.changed = b""
        self._look_s = LOOK_S
        self._cancelled_until = 0.0
        self._notes: list[Event] = []
        self._changes: tuple[str, ...] = ()
        self._frame: Frame | None = None
        self._under_way: Begun | None = None
        self._unsettled: Step | None = None
        self._engaged: Engaged | None = None
        self._reset()
        if shown:
            self._engaged = Engaged(SCRIPT)
        self.desk.autopilot = None if self._engaged is None else self._engaged.name

    def _reset(self) -> None:
        """Create the simulation of a new run, and delete all data of the previous run."""
        self._sim = Simulation(self.scenario, self._seed)
        self._lost = LostTime(self.scenario.control_period)
        self._task = TaskRun(self.scenario)
        self._lights = Lights()
        self._release = ReleaseQuestion()
        self._pulses = Pulses(self.scenario)
        self._standing = StandingLamps()
        self._commanded = False
        self._quiet_until_s = 0.0
        self._engaged = None if self._first is None else Engaged(self._first)
        self._view = Look(self._displays)
        self._monitors_before: tuple[tuple[str, ...], ...] = ()

    @property
    def time_s(self) -> float:
        """Simulated time of the newest step [s]; 0 before the first one."""
        return self._sim.frame.time_s if self._sim.frame else 0.0

    @property
    def delays(self) -> Delays:
        """Delays of the control steps of the present run."""
        return self._lost.delays

    def begin(self) -> None:
        """Begin to record the run. Call this once, before the first step."""
        if self._recording is not None:
            self._recording.begin(self.scenario, self._sim.seed, self._clock())

    def close(self) -> None:
        """End the run."""
        self.settle()
        self._end("stopped", self._under_way or self._begun())

    def _end(self, ended: Ended, step: Begun) -> None:
        """End the run and its recording, with the step that the simulation has not made."""
        if self._recording is not None:
            self._recording.end(ended, step)
        self.telemetry.add(step.notes)

    def note(self, kind: str, text: str, level: Level = "info") -> None:
        """Log and record a line of the host's, with the next step."""
        self._notes.append(Event(self.time_s, kind, level, text))

    def receive(self, page: Page, message: from_page.FromPage) -> tuple[Answer, ...]:
        """Take a message of a page, and return the answers to it."""
        match message:
            case from_page.TypeLine():
                typed = self.type_line(message.line, message.seq, may_set=page == self.desk.roles.operator)
                return (Answer(page, typed),)
            case from_page.CompleteLine():
                return (Answer(page, to_page.Completed(message.seq, self.complete_line(message.line))),)
            case _:
                return self.desk.receive(page, message)

    def type_line(self, line: str, seq: int = -1, *, may_set: bool = True) -> to_page.Typed:
        """Do what a line on the console asks for, and return its answer; `may_set`: whether it may change values.

        All long work is done here and not in the step. A host with threads may call this while another one steps.
        """
        try:
            answer = self._console.reply(line, self._now(may_set=may_set))
            if answer.changes:
                # the step then has both at hand: the constants of the run, and what the pages receive
                changed_of(self._sim.prepare(self.desk.changes | answer.changes, answer.made))
                self.change(answer.changes)
        except InputError as error:
            return to_page.Typed(seq, tuple(str(error).splitlines()), refused=True)
        return to_page.Typed(seq, answer.lines, refused=False)

    def complete_line(self, line: str) -> tuple[str, ...]:
        """Return the words with which the last word of a line on the console can go on."""
        return self._console.completions(line, self._now())

    def change(self, changes: dict[str, str]) -> None:
        """Make changes in flight, which `Simulation.prepare` has checked, in the next step."""
        self.desk.changes = self.desk.changes | changes

    def _now(self, *, may_set: bool = True) -> Now:
        return Now(self._frame, self.desk.changes, may_set)

    def take(self) -> Asked:
        """Return what the pages ask for in the next step."""
        return self.desk.take(rate_held=self._rate_held(self._clock()))

    def advance(self, asked: Asked, delay: Delay = PUNCTUAL) -> Step:
        """Do one control step, and return it with what is new.

        Args:
            asked: what the pages ask for.
            delay: delay with which the step begins.
        """
        step = self.fly(asked, delay)
        self.settle()
        return step

    def fly(self, asked: Asked, delay: Delay = PUNCTUAL) -> Step:
        """Do a control step as `advance` does, up to all that the pages receive; `settle` does the rest."""
        self.settle()
        late, lost = self._lost.count(self.time_s, delay, commanded=self._commanded)
        self._under_way = begun = self._begun(late)
        if lost:
            begun.note("time lost", lost, "caution")
        taken, cause = asked.page, asked.page.cause
        if isinstance(taken.command, from_page.Restart):
            self._under_way = begun = self._restart(begun)
        elif isinstance(taken.command, from_page.HandsOff):
            cause = cause or taken.command.cause
        command = self._for_simulation(begun, taken.command)
        inputs, flown = self._inputs(begun, taken, cause, command)
        if asked.changes and self._are_possible(begun, asked.changes):
            inputs = msgspec.structs.replace(inputs or Inputs(script=True), changes=asked.changes)
        frame = self._sim.step(inputs)
        step = Step(
            *msgspec.structs.astuple(begun),
            asked=asked,
            inputs=inputs,
            frame=frame,
            lamps=self._standing.marked(lit_lamps(self.scenario, frame, self.delays)),
            autopilot=self.desk.autopilot,
            link=self.link.next(),
        )
        self._tell(step)
        self._task.see(step)
        shown = self._displays.frame(
            frame,
            taken.sticks.seq,
            frame.time_s if self._recording is not None and self._recording.recorded else None,
            self._view.ahead,
            step.lighting,
            pair=self._view.pair,
            flown_seq=flown,
            lamps=step.lamps,
            progress=self._task.progress,
            debrief=step.debrief,
            autopilot=step.autopilot,
            link=step.link,
        )
        self.newest = _encoder.encode(shown)
        self._frame = frame
        if frame.changes != self._changes:
            self._pulses = Pulses(self._sim.in_force)
            self._changes, now = frame.changes, self._sim.in_force
            self.changed = _encoder.encode(changed_of(now))
            self.link.delays = self.link.delays._replace(telemetry=now.telemetry_delay, camera=now.camera_delay)
        self.telemetry.see(step)
        self._under_way, self._unsettled = None, step
        return step

    def settle(self) -> None:
        """Do what no page waits for after the last step: record it, look ahead, and let the observers see it."""
        step, self._unsettled = self._unsettled, None
        if step is None:
            return
        self._task.settle()
        self._view.renew(self._sim, step.frame, self._task.progress, self._look_s)
        for observer in (self._recording, *self.observers):
            if observer is not None:
                observer.see(step)

    def _are_possible(self, begun: Begun, changes: dict[str, str]) -> bool:
        """Return whether changes in flight are possible now; if not, because the arm has moved since, note why."""
        try:
            self._sim.prepare(changes)
        except InputError as error:
            begun.note("change", f"refused: {error}", "caution")
            return False
        return True

    def _begun(self, late: Delay | None = None) -> Begun:
        """Return the step that begins, with the lines that wait for it; `late`: its delay, if it is to be recorded."""
        notes, self._notes = self._notes, []
        frame = self._sim.frame
        tick = frame.tick + 1 if frame else 1
        return Begun(tick, self._clock(), self.time_s, late, self.delays, self._commanded, notes)

    def _restart(self, step: Begun) -> Begun:
        """Finish the run and its recording, restart the scenario, and return the first step of the new run."""
        self._end("restarted", step)
        self._reset()
        self.begin()
        first = Begun(1, step.now, 0.0, None, self.delays, False, [], restarted=True)
        first.note("restart", f"{self.scenario.title}: restarted")
        return first

    def _inputs(
        self, step: Begun, taken: Taken, cause: str, command: from_page.FromPage | None
    ) -> tuple[Inputs | None, int]:
        """Return the inputs of the operator or the autopilot, and the number of the stick message that acts."""
        if cause or taken.handed_over:
            self._pulses.clear()  # the page no longer has the sticks
        sticks = self._pulses.deflected(taken.sticks, self._sim.frame)
        moved = any(abs(s) > MOVED for s in travel(sticks))
        if self._engaged is not None and (moved or command is not None or not self._engaged.fly(self._sim)):
            why = self._engaged.fault
            text = f"manual control: the {self._engaged.name} has stopped" + (f": {why}" if why else "")
            step.note("hand", text, "caution" if why else "info")
            self._engaged = None
        self._commanded |= moved or command is not None
        if taken.handed_over:
            step.note("hand-over", taken.handed_over)
        self.desk.autopilot = None if self._engaged is None else self._engaged.name
        if self._engaged is not None:
            return self._engaged.inputs, -1
        inputs, flown = inputs_of(sticks, command, self.scenario.arm), taken.flown()
        if cause:
            inputs = self._make_safe(step, inputs, cause)
        if taken.camera.pan or taken.camera.tilt or taken.camera.zoom:
            inputs = msgspec.structs.replace(inputs, camera=taken.camera)
        return inputs, flown

    def _tell(self, step: Step) -> None:
        """Note changes of the light, and announced clearance problems; tell the task that the operator looks."""
        asked, frame = step.asked, step.frame
        if text := self._lights.change(step.lighting):
            step.note("light", text)
        if asked.announced and frame.time_s >= self._quiet_until_s:
            self._quiet_until_s = frame.time_s + QUIET_S
            near = frame.work.nearest
            where = "" if near is None else f": {near.a} to {near.b} {near.clearance:.2f} m"
            step.note(ANNOUNCED, f"clearance problem announced by the {asked.announced}{where}")
        if self._monitors_before and asked.monitors and asked.monitors != self._monitors_before:
            self._task.progress.look()
        self._monitors_before = asked.monitors

    def _for_simulation(self, step: Begun, command: from_page.FromPage | None) -> from_page.FromPage | None:
        """Do a command that concerns the session only; return any other command, unless it must be confirmed."""
        if question := self._release.question(command, self._sim.frame, self._task.progress.present):
            step.note("release", question, "caution")
            return None
        match command:
            case from_page.Pulse():
                if reason := self._pulses.press(command, self._sim.frame):
                    step.note("refused", reason, "caution")
            case from_page.Stop() | from_page.EnterMode():
                self._pulses.clear()
                return command
            case from_page.LookAhead(seconds=seconds):
                self._look_s = seconds
            case from_page.TurnStep(to="next"):
                self._task.progress.skip()
            case from_page.TurnStep():
                self._task.progress.back()
            case from_page.Restart() | from_page.HandsOff():
                pass
            case _:
                return command
        return None

    def _rate_held(self, now: float) -> bool:
        """Return whether RATE HOLD keeps a rate.

        After the station has cancelled RATE HOLD, frames still show RATE HOLD as on during the command delay. During
        this delay, and for `SILENCE` after it, the result is False.
        """
        frame = self._sim.frame
        return self._engaged is None and frame is not None and frame.rate_hold and now >= self._cancelled_until

    def _make_safe(self, step: Begun, inputs: Inputs, cause: str) -> Inputs:
        """Return inputs that put the arm into a safe state, and log the cause."""
        frame = self._sim.frame
        inputs, text = safe_inputs(inputs, frame, cause, cancelling=step.now < self._cancelled_until)
        if inputs.rate_hold and frame is not None and frame.rate_hold:
            self._cancelled_until = step.now + self.scenario.delay * self.scenario.control_period + SILENCE
        if text:
            step.note("hands off", text, "caution")
        return inputs
