"""Session: steps the simulation with the inputs of the page in control, and encodes each frame for all pages.

A session has no thread and no clock: `driver.Driver` steps it in real time. While one thread steps the session, other
threads may call the methods for pages.
"""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable
from pathlib import Path

import msgspec

from aftdeck.errors import CommandError
from aftdeck.law import is_plain
from aftdeck.law_change import Laws
from aftdeck.lines import print_error
from aftdeck.recording.delays import Delays
from aftdeck.recording.index import Index
from aftdeck.recording.live import Live
from aftdeck.recording.session_recorder import SessionRecorder
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.report.lamps import Lamp, StandingLamps, lit_lamps
from aftdeck.report.metrics.announcements import ANNOUNCED
from aftdeck.scenario.light import conditions
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.frame import Event, Frame, Level
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.observe.look_ahead import Axis
from aftdeck.simulation.run import Simulation
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.conversion.welcome_of import welcome_of
from aftdeck.station.messages import from_page
from aftdeck.station.messages.frame import Ahead, TaskPair
from aftdeck.station.session.autopilot import SCRIPT, Autopilots, Engaged
from aftdeck.station.session.commands import (
    check_camera,
    check_light,
    check_shown,
    check_sticks,
    check_switch,
    controller_records,
    inputs_of,
    travel,
)
from aftdeck.station.session.log import Log
from aftdeck.station.session.pace import PUNCTUAL, Delay
from aftdeck.station.session.page_inputs import NO_CONTROLLERS, SILENCE, PageInputs, Taken
from aftdeck.station.session.painter import Painter
from aftdeck.station.session.pulses import Pulses
from aftdeck.station.session.recent import RecentRun
from aftdeck.station.session.release import ReleaseQuestion
from aftdeck.station.session.reported import Reported
from aftdeck.station.session.task_run import TaskRun
from aftdeck.station.session.unattended import safe_inputs
from aftdeck.station.session.warm import warm_up

LOOK_EVERY = 10
"""Steps from one look-ahead to the next, and from one search for the task's pair to the next."""
LOOK_S = 5.0
"""Time span of the look-ahead at the start of a session [s]; a page can set another one."""
MOVED = 1e-3
"""Stick deflection above which the operator takes control from the script or another autopilot."""

LOSS_LOGGED_EVERY = 60.0
"""Least time from one log line about lost time to the next [s]."""

_encoder = msgspec.json.Encoder()


class Session:
    """Session of one scenario: its simulation, the inputs of its pages, its log and its recordings.

    Attributes:
        scenario: the scenario that is run.
        welcome: first message to a new page.
        recent: the last minutes of the present run.
        laws: compiled laws of this process.
        log: events of all runs of the session.
        delays: delays of the control steps of the present run.
        newest: newest frame, encoded as JSON; empty before the first step.
        painter: painter of the pictures in the look of 1972, and of the sheets that explain them.
    """

    def __init__(
        self,
        scenario: Scenario,
        seed: int | None = None,
        *,
        demo: bool = False,
        shown: bool = False,
        autopilots: Autopilots | None = None,
        record: Path | None = None,
        trial: Trial = NO_TRIAL,
        live: Live | None = None,
        laws: Laws | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Prepare a run; unless this process runs the laws as plain Python for now, compile or load them all.

        Args:
            scenario: the scenario to run.
            seed: random seed; None selects the scenario's seed.
            demo: whether the script runs until the operator moves a stick or sends a command; also after a restart.
            shown: whether the script runs in this way in the first run.
            autopilots: returns the autopilot that flies a scenario in this way, if the script does not; None: none.
            record: folder into which each run is recorded; None: runs are not recorded.
            trial: participant and condition, stored in each recording.
            live: server for viewers of the run; None: viewers cannot attach.
            laws: compiled laws of this process; None: new ones.
            clock: function that returns the time [s]; used to measure the age of the last message.
        """
        self.scenario, self._seed = scenario, seed
        self._start_demo, self._record, self._trial, self._live = demo, record, trial, live
        self._autopilots = autopilots
        self._first = SCRIPT if demo else autopilots(scenario) if autopilots else None
        self._clock = clock
        self._displays = Displays(scenario)
        self.welcome = welcome_of(scenario, demo=demo or shown)
        self.laws = laws or Laws()
        self.laws.want(warm_up, scenario)
        self._recorder = SessionRecorder(record, Index(), live, trial)
        self.log = Log()
        self.newest = b""
        self.painter = Painter(scenario)
        self._lights = {condition.name: condition for condition in conditions()}
        self._lock = threading.Lock()
        self._inputs = PageInputs(scenario.delay)
        self._reported = Reported(scenario.lighting)
        self._look_s = LOOK_S
        self._cancelled_until = 0.0
        self._engaged: Engaged | None = None
        self._reset()
        if shown:
            self._engaged = Engaged(SCRIPT)

    def _reset(self) -> None:
        """Create the simulation of a new run, and delete all data of the previous run."""
        self._sim = Simulation(self.scenario, self._seed)
        self.recent = RecentRun(self.scenario)
        self.delays = Delays()
        self._task = TaskRun(self.scenario)
        self._release = ReleaseQuestion()
        self._pulses = Pulses(self.scenario)
        self._standing = StandingLamps()
        self._lost_logged = 0.0
        self._commanded = False
        self._log_loss_from = -math.inf
        self._engaged = None if self._first is None else Engaged(self._first)
        self._ahead: Ahead | None = None
        self._pair: TaskPair | None = None
        self._axis: Axis | None = None
        self._controllers_recorded = NO_CONTROLLERS

    def another(self, scenario: Scenario, *, shown: bool = False) -> Session:
        """Return a session of another scenario with the same settings and the same recording folder.

        `shown`: whether the script flies its first run, until the operator moves a stick or sends a command.
        """
        return Session(
            scenario,
            self._seed,
            demo=self._start_demo,
            shown=shown,
            autopilots=self._autopilots,
            record=self._record,
            trial=self._trial,
            live=self._live,
            laws=self.laws,
            clock=self._clock,
        )

    @property
    def folder(self) -> Path | None:
        """Folder into which the runs are recorded; None if they are not recorded."""
        return self._record

    @property
    def file(self) -> Path | None:
        """File into which the present run is recorded; None if it is not recorded."""
        return self._recorder.file

    @property
    def time_s(self) -> float:
        """Simulated time of the newest step [s]; 0 before the first one."""
        return self._sim.frame.time_s if self._sim.frame else 0.0

    # --- called for pages ---------------------------------------------------------------------------------

    def steer(self, sticks: from_page.Sticks) -> None:
        """Set the stick deflections.

        Raises:
            CommandError: a deflection is not in [-1, 1], or the sticks must be centred first (`PageInputs.steer`).
        """
        check_sticks(sticks)
        with self._lock:
            self._inputs.steer(sticks, self._clock())

    def turn(self, message: from_page.DriveCamera) -> None:
        """Set the switches that drive a camera.

        Raises:
            CommandError: the camera does not exist or has no drive, a switch is not in [-1, 1], or an autopilot
                is in control.
        """
        check_camera(message, self.welcome)
        if (engaged := self._engaged) is not None:
            raise CommandError(f"the {engaged.name} is in control: move a stick to take over, then move the camera")
        camera = CameraDrive(message.camera, message.pan, message.tilt, message.zoom, message.slow)
        with self._lock:
            self._inputs.turn(camera, self._clock())

    def command(self, message: from_page.FromPage) -> None:
        """Queue a switch command for one of the next steps.

        Raises:
            CommandError: a switch position does not exist, a target is out of range, or too many commands are
                waiting.
        """
        check_switch(message, self.welcome)
        with self._lock:
            self._inputs.command(message)

    def controllers_in_use(self, message: from_page.Controllers) -> None:
        """Set the devices that move the sticks of the page in control."""
        with self._lock:
            self._inputs.use(message)

    def shown(self, message: from_page.Shown) -> None:
        """Set the latency that the page in control measures, and the cameras on its monitors.

        Raises:
            CommandError: a camera does not exist.
        """
        check_shown(message, self.welcome)
        if self._reported.monitors and message.monitors != self._reported.monitors:
            self._task.progress.look()
        self._reported.latency_ms, self._reported.monitors = message.latency_ms, message.monitors

    def announce(self, by: str) -> None:
        """Log and record a clearance problem that somebody has noticed; `by`: ``operator`` or ``observer``."""
        self._reported.announced = by

    def light(self, message: from_page.SetLight) -> None:
        """Set the lighting; allowed even while an autopilot flies.

        Raises:
            CommandError: a light condition, a lamp or a camera does not exist.
        """
        check_light(message.lighting, self.welcome)
        self._reported.lighting = message.lighting

    def set_unattended(self, cause: str = "page gone") -> None:
        """Centre the sticks and delete all waiting commands; `cause` is one of `unattended.CAUSES`."""
        with self._lock:
            self._inputs.set_unattended(cause)
        self._reported.latency_ms, self._reported.monitors = None, ()

    def hand_over(self, text: str) -> None:
        """Centre the sticks and delete all waiting commands, because another page takes control; log `text`.

        For one step the controls then count as unattended: RATE HOLD is cancelled and POSITION HOLD is set.

        Raises:
            CommandError: a stick is deflected.
        """
        with self._lock:
            self._inputs.hand_over(text)
        self._reported.latency_ms, self._reported.monitors = None, ()

    # --- called by the thread that steps the session ---------------------------------------------------------------

    def begin(self) -> None:
        """Start to record the run. Call this once, before the first step."""
        self._recorder.begin(self.scenario, self._sim.seed)

    def close(self) -> None:
        """Finish the recording; if the run has lost time, print how much."""
        self.painter.close()
        self._recorder.close()
        self._print_loss()

    def _print_loss(self) -> None:
        if self.delays.lost_s:
            print_error(f"{self.scenario.title!r}, {self.time_s:.2f} s: {self.delays.text()}")

    def step(self, delay: Delay = PUNCTUAL) -> bool:
        """Do one control step with the newest inputs of the page in control, and encode its frame.

        Args:
            delay: delay with which the step begins.

        Returns:
            Whether the step is the first of a new run.
        """
        now = self._clock()
        self._count(delay)
        with self._lock:
            taken = self._inputs.take(now, rate_held=self._rate_held(now))
        cause = taken.cause
        restarted = isinstance(taken.command, from_page.Restart)
        if restarted:
            self._restart()
        elif isinstance(taken.command, from_page.HandsOff):
            cause = cause or taken.command.cause
        command = self._for_simulation(taken.command)
        if taken.controllers is not self._controllers_recorded:
            self._controllers_recorded = taken.controllers
            self._recorder.controllers(self.time_s, controller_records(taken.controllers))
        sticks = self._sticks(taken, cause)
        moved = any(abs(s) > MOVED for s in travel(sticks))
        if self._engaged is not None and (moved or command is not None or not self._engaged.fly(self._sim)):
            why = self._engaged.fault
            text = f"manual control: the {self._engaged.name} has stopped" + (f": {why}" if why else "")
            self.note("hand", text, "caution" if why else "info")
            self._engaged = None
        self._commanded |= moved or command is not None
        if taken.handed_over:
            self.note("hand-over", taken.handed_over)
        if self._engaged is not None:
            inputs, flown = self._engaged.inputs, -1
        else:
            inputs, flown = inputs_of(sticks, command, self.scenario.arm), taken.flown()
            if cause:
                inputs = self._make_safe(inputs, cause, now)
            if taken.camera.pan or taken.camera.tilt or taken.camera.zoom:
                inputs = msgspec.structs.replace(inputs, camera=taken.camera)
        frame = self._sim.step(inputs)
        self._note_reported(frame)
        self._recorder.step(inputs, frame, self._reported.latency_ms)
        for text in self._recorder.take_errors():
            self.note("recording", text, "warning")
        self._look(frame)
        seq, running_s = taken.sticks.seq, self._recorder.running_s
        lit = self._reported.lit
        lamps = self._standing.marked(lit_lamps(self.scenario, frame, self.delays))
        self._see_task(frame, lamps)
        shown = self._displays.frame(
            frame,
            seq,
            running_s,
            self._ahead,
            lit,
            pair=self._pair,
            flown_seq=flown,
            lamps=lamps,
            progress=self._task.progress,
            debrief=self._task.debrief,
            autopilot=None if self._engaged is None else self._engaged.name,
        )
        self.recent.add(frame, shown.display.lamps, self._reported.latency_ms, self._reported.monitors)
        self.newest = _encoder.encode(shown)
        self.painter.show(frame, self._lights[shown.display.lighting.condition])
        self.log.add(frame.events if frame.tick > 1 else map(_from_the_start, frame.events))
        return restarted

    def _look(self, frame: Frame) -> None:
        """Compute the look-ahead and the task's pair, in different steps, when they are due.

        As plain Python, each takes several control periods: then there are none.
        """
        if is_plain():
            self._ahead, self._pair = None, None
        elif frame.tick % LOOK_EVERY == 1:
            self._axis = _deflected(frame) or self._axis
            self._ahead = self._displays.ahead(self._sim.ahead(self._look_s, self._axis), frame)
        elif frame.tick % LOOK_EVERY == 1 + LOOK_EVERY // 2:
            self._pair = self._displays.pair(self._sim.watched, frame, self._task.progress)

    def _sticks(self, taken: Taken, cause: str) -> from_page.Sticks:
        """Return the sticks with the pulses' deflections; end all pulses if the page no longer has the sticks."""
        if cause or taken.handed_over:
            self._pulses.clear()
        return self._pulses.deflected(taken.sticks, self._sim.frame)

    def _note_reported(self, frame: Frame) -> None:
        """Record what the page reports; log the light and announcements."""
        if text := self._reported.record(self._recorder, frame.time_s):
            self.note("light", text)
        if text := self._reported.announcement(frame):
            self.note(ANNOUNCED, text)

    def _see_task(self, frame: Frame, lamps: tuple[Lamp, ...]) -> None:
        """Update the task; log the steps that are done, and list the grade."""
        autopilot = None if self._engaged is None else self._engaged.name
        for i in self._task.see(frame, lamps, autopilot, self.delays):
            self.note("task", f"step {i + 1} of {len(self.scenario.steps)} done: {self.scenario.steps[i].title}")
            if (result := self._task.debrief) is not None:
                self._recorder.graded(result.grade or "")

    def _for_simulation(self, command: from_page.FromPage | None) -> from_page.FromPage | None:
        """Do a command that concerns the session only; return any other command, unless it must be confirmed."""
        if question := self._release.question(command, self._sim.frame, self._task.progress.present):
            self.note("release", question, "caution")
            return None
        match command:
            case from_page.Pulse():
                if reason := self._pulses.press(command, self._sim.frame):
                    self.note("refused", reason, "caution")
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

    def _count(self, delay: Delay) -> None:
        """Record a delay of more than one control period, and log lost time, at most every `LOSS_LOGGED_EVERY`."""
        time_s, tick = self.time_s, self._sim.frame.tick + 1 if self._sim.frame else 1
        if delay.late_s > self.scenario.control_period:
            self.delays = self.delays.after(time_s, *delay, commanded=self._commanded)
            self._recorder.delay(tick, time_s, *delay, commanded=self._commanded)
        if not self._commanded:
            self._lost_logged = self.delays.lost_s
        if self.delays.lost_s > self._lost_logged and time_s >= self._log_loss_from:
            lost, self._lost_logged = self.delays.lost_s - self._lost_logged, self.delays.lost_s
            self._log_loss_from = time_s + LOSS_LOGGED_EVERY
            text = f"the computer was too slow: {lost:.2f} s lost ({self.delays.lost_s:.2f} s in this run)"
            self.note("time lost", text, "caution")

    def _rate_held(self, now: float) -> bool:
        """Return whether RATE HOLD keeps a rate.

        After the station has cancelled RATE HOLD, frames still show RATE HOLD as on during the command delay. During
        this delay, and for `SILENCE` after it, the result is False.
        """
        frame = self._sim.frame
        return self._engaged is None and frame is not None and frame.rate_hold and now >= self._cancelled_until

    def _make_safe(self, inputs: Inputs, cause: str, now: float) -> Inputs:
        """Return inputs that put the arm into a safe state, and log the cause."""
        frame = self._sim.frame
        inputs, text = safe_inputs(inputs, frame, cause, cancelling=now < self._cancelled_until)
        if inputs.rate_hold and frame is not None and frame.rate_hold:
            self._cancelled_until = now + self.scenario.delay * self.scenario.control_period + SILENCE
        if text:
            self.note("hands off", text, "caution")
        return inputs

    def _restart(self) -> None:
        """Finish the run and its recording, and restart the scenario."""
        self._recorder.end("restarted")
        self._print_loss()
        self._reset()
        self._reported.begin_run(self.scenario.lighting)
        self.begin()
        self.note("restart", f"{self.scenario.title}: restarted")

    def note(self, kind: str, text: str, level: Level = "info") -> None:
        """Log and record a line of the station's own."""
        event = Event(self.time_s, kind, level, text)
        self._recorder.note(event)
        self.log.add([event])


def _from_the_start(event: Event) -> Event:
    """Return an event of the first step as information: it tells the state in which the scenario begins."""
    if event.level == "info":
        return event
    return msgspec.structs.replace(event, level="info", text=f"from the start: {event.text}")


def _deflected(frame: Frame) -> Axis | None:
    """Return the index of the axis with the largest deflection, and its sign; None if the sticks are centred."""
    axes = (*frame.rotation, *frame.translation, frame.drive)
    largest = max(range(len(axes)), key=lambda k: abs(axes[k]))
    if axes[largest] == 0.0:
        return None
    return largest, 1 if axes[largest] > 0.0 else -1
