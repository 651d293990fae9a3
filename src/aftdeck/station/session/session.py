"""Session that pages share: one thread steps the simulation, pages send commands and get its frames.

The thread never waits for a page: only the newest frame is handed over, and commands wait in a bounded queue, one for
each step. One page is in control, the others observe. The first page takes control; when it leaves, the next one does.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable
from enum import Enum
from pathlib import Path
from typing import Literal

import msgspec

from aftdeck.errors import CommandError
from aftdeck.recording.index import Index
from aftdeck.recording.live import Live
from aftdeck.recording.tape import Tape
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.scenario.light import Lighting
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.frame import Event, Level
from aftdeck.simulation.frame import Frame as SimFrame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.observe.look_ahead import Axis
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.warm import warm_up
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.conversion.welcome_of import welcome_of
from aftdeck.station.messages import from_page, kinds
from aftdeck.station.messages.frame import Ahead
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
from aftdeck.station.session.recent import RecentFlight
from aftdeck.station.session.unattended import left_alone

LOST = 2.0
"""Silence after which deflected sticks must be centred before they act again [s]."""
SILENCE = 0.5
"""Silence after which sticks and camera switches go to zero [s]."""
MOST_WAITING = 32
"""Maximum number of waiting commands; each step takes one."""
MOST_BEHIND = 0.25
"""Largest delay of a step that is caught up [s]; after a larger one, the clock restarts from there."""
LOOK_EVERY = 10
"""Steps from one look-ahead to the next."""
LOOK_S = 5.0
"""Time span of the look-ahead until a page sets another one [s]."""
MOVED = 1e-3
"""Stick deflection above which a person takes over from the demonstration."""
NO_CONTROLLERS = from_page.Controllers(0, ())
HANDS_OFF = from_page.Sticks(-1, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0)
STILL = CameraDrive("")
"""Camera command that moves no camera."""

_encoder = msgspec.json.Encoder()


class Phase(Enum):
    """Phase in the life of a session."""

    READY = "ready"
    FLYING = "flying"
    FAILED = "failed"
    CLOSED = "closed"


class Session:
    """Session of one scenario: its simulation, the thread that steps it, and its recordings.

    Attributes:
        scenario: the scenario that is run.
        phase: phase in the life of the session.
        failure: reason for a failure, in a sentence; empty if there was none.
        welcome: first message to a new page.
        recent: the last minutes of the present run.
    """

    def __init__(
        self,
        scenario: Scenario,
        seed: int | None = None,
        *,
        demo: bool = False,
        record: Path | None = None,
        trial: Trial = NO_TRIAL,
        live: Live | None = None,
    ) -> None:
        self.phase = Phase.READY
        self.failure = ""
        self.scenario, self._seed = scenario, seed
        self._displays = Displays(scenario)
        self.welcome = welcome_of(scenario, demo=demo)
        self._start_demo = demo
        self._demo = demo
        warm_up(scenario)
        self._sim = Simulation(scenario, seed)
        self.recent = RecentFlight(scenario)
        self._displays.frame(Simulation(scenario, seed).step(Inputs()), -1)  # compiles its laws too
        self._lock = threading.Lock()
        self._record, self._trial, self._live = record, trial, live
        self._tape = Tape(record, Index(), live, trial)
        self._latency_ms: float | None = None
        self._look_s = LOOK_S
        self._ahead: Ahead | None = None
        self._axis: Axis | None = None
        self._controllers = NO_CONTROLLERS
        self._recorded = NO_CONTROLLERS
        self._monitors: tuple[kinds.Monitor, ...] = ()
        self._monitors_kept: tuple[kinds.Monitor, ...] = ()
        self._lighting = scenario.lighting
        self._lighting_kept: Lighting | None = None
        self._camera, self._camera_heard = STILL, 0.0
        self._commands: deque[from_page.FromPage] = deque()
        self._sticks = HANDS_OFF
        self._under_way = self._none_under_way()
        self._heard = self._left_until = 0.0
        self._zeroed = False
        self._lost: Literal["", "untold", "told"] = ""
        self._left = self._handed = ""
        self._log: list[Event] = []
        self._newest = b""
        self._told: Callable[[], None] = lambda: None
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._fly, name="simulation", daemon=True)

    # --- called by the server -----------------------------------------------------------------------------

    def another(self, scenario: Scenario) -> Session:
        """Return a session of another scenario with the same settings; it records into the same folder."""
        return Session(
            scenario, self._seed, demo=self._start_demo, record=self._record, trial=self._trial, live=self._live
        )

    def start(self, told: Callable[[], None]) -> None:
        """Start the run; the simulation's thread calls `told` after each step and after a failure."""
        self._told = told
        self.phase = Phase.FLYING
        self._thread.start()

    def close(self) -> None:
        """Stop the run and wait for the thread, for at most 5 s."""
        self._stop.set()
        if self._thread.is_alive():
            self._thread.join(timeout=5.0)
        self._tape.close()
        self.phase = Phase.CLOSED

    @property
    def folder(self) -> Path | None:
        """Folder into which the runs are recorded; None if they are not recorded."""
        return self._record

    @property
    def file(self) -> Path | None:
        """File into which the present run is recorded; None if it is not recorded."""
        return self._tape.file

    @property
    def newest(self) -> bytes:
        """Newest frame, encoded as JSON; empty before the first one."""
        return self._newest

    def log_since(self, index: int) -> tuple[Event, ...]:
        """Return the lines of the log from an index on."""
        with self._lock:
            return tuple(self._log[index:])

    def steer(self, sticks: from_page.Sticks) -> None:
        """Set the stick deflections that the page in control has sent.

        Deflected sticks that were silent for longer than `LOST` act again only after they have been centred.

        Raises:
            CommandError: a stick is beyond its travel, or is still deflected after such a silence (raised once).
        """
        check_sticks(sticks)
        with self._lock:
            now, deflected = time.monotonic(), any(travel(sticks))
            if self._zeroed and now - self._heard > LOST:
                self._lost = "untold"
            self._heard, self._zeroed = now, False
            if self._lost and deflected:
                self._sticks = msgspec.structs.replace(HANDS_OFF, seq=sticks.seq)
                if self._lost == "untold":
                    self._lost = "told"
                    raise CommandError("the sticks were silent: let go of them first")
                return
            self._sticks, self._lost = sticks, ""

    def turn(self, message: from_page.DriveCamera) -> None:
        """Set the switches that drive a camera.

        Raises:
            CommandError: the camera does not exist or has no drive, a switch is beyond its travel, or the script flies.
        """
        check_camera(message, self.welcome)
        if self._demo:
            raise CommandError("the script flies: take the sticks, then the cameras turn, too")
        with self._lock:
            self._camera = CameraDrive(message.camera, message.pan, message.tilt, message.zoom, message.slow)
            self._camera_heard = time.monotonic()

    def shown(self, message: from_page.Shown) -> None:
        """Set the latency that the page in control measures, and the cameras that it shows.

        Raises:
            CommandError: a camera does not exist.
        """
        check_shown(message, self.welcome)
        self._latency_ms, self._monitors = message.latency_ms, message.monitors

    def light(self, message: from_page.SetLight) -> None:
        """Set the lighting; the page in control may do so even while the script flies.

        Raises:
            CommandError: a light condition, a lamp or a camera does not exist.
        """
        check_light(message.lighting, self.welcome)
        self._lighting = message.lighting

    def controllers_in_use(self, message: from_page.Controllers) -> None:
        """Set the controllers that move the sticks of the page in control, with their settings."""
        with self._lock:
            self._controllers = message

    def let_go(self, cause: str = "page gone") -> None:
        """Set the sticks to zero and delete all commands: the controls are unattended, with a cause of `CAUSES`."""
        with self._lock:
            self._sticks, self._camera, self._zeroed, self._lost = HANDS_OFF, STILL, False, ""
            self._commands.clear()
            self._left = cause
            self._under_way = self._none_under_way()  # the next page in control has sticks with numbers of its own
            self._controllers = NO_CONTROLLERS
        self._latency_ms, self._monitors = None, ()

    def hand_over(self, text: str) -> None:
        """Set the sticks to zero and delete all commands, because another page takes control; log `text`.

        The controls then count as unattended for one step, so that nothing moves meanwhile.

        Raises:
            CommandError: a stick is deflected.
        """
        with self._lock:
            if any(travel(self._sticks)):
                raise CommandError("let go of the sticks first: they are given at rest")
            self._sticks, self._camera, self._zeroed, self._lost = HANDS_OFF, STILL, False, ""
            self._commands.clear()
            self._left, self._handed = "handed over", text
            self._under_way = self._none_under_way()
            self._controllers = NO_CONTROLLERS
        self._latency_ms = None

    def command(self, message: from_page.FromPage) -> None:
        """Queue a switch command for one of the next steps.

        STOP deletes all waiting commands, so that STOP itself is never rejected and never late.

        Raises:
            CommandError: a switch position does not exist, a target is out of range, or too many commands are
                waiting.
        """
        check_switch(message, self.welcome)
        with self._lock:
            if isinstance(message, from_page.Stop):
                self._commands.clear()
                self._sticks = msgspec.structs.replace(HANDS_OFF, seq=self._sticks.seq)
                self._camera = STILL
            if len(self._commands) >= MOST_WAITING:
                raise CommandError(f"{MOST_WAITING} commands are waiting already; this one was not taken")
            self._commands.append(message)

    # --- the simulation's thread --------------------------------------------------------------------------

    def _fly(self) -> None:
        """Do one step in each control period until the session is closed."""
        try:
            self._tape.begin(self.scenario, self._sim.seed)
            due = time.perf_counter()
            while not self._stop.is_set():
                self._step()
                self._told()
                due += self.scenario.control_period
                late = time.perf_counter() - due
                if late > MOST_BEHIND:
                    due += late
                elif late < 0.0:
                    self._stop.wait(-late)
        except Exception as error:  # any error must reach the pages
            self.failure = f"the simulation stopped at {self._time():.2f} s: {error}"
            self.phase = Phase.FAILED
            self._told()
            raise

    def _time(self) -> float:
        return self._sim.frame.time_s if self._sim.frame else 0.0

    def _step(self) -> None:
        with self._lock:
            now = time.monotonic()
            if now - self._heard > SILENCE and self._in_hand(now):
                self._zeroed = True
                self._sticks = msgspec.structs.replace(HANDS_OFF, seq=self._sticks.seq)
                self._left = self._left or "sticks silent"
            sticks, way = self._sticks, self._under_way
            camera = self._camera if time.monotonic() - self._camera_heard <= SILENCE else STILL
            message = self._commands.popleft() if self._commands else None
            left, handed, self._left, self._handed = self._left, self._handed, "", ""
            controllers = self._controllers
        if isinstance(message, from_page.Restart):
            self._restart()
            message = None
        elif isinstance(message, from_page.LookAhead):
            self._look_s, message = message.seconds, None
        elif isinstance(message, from_page.HandsOff):
            left, message = left or message.cause, None
        if controllers is not self._recorded:
            self._recorded = controllers
            self._tape.controllers(self._time(), controller_records(controllers))
        moved = any(abs(s) > MOVED for s in travel(sticks))
        if self._demo and (moved or message is not None or self._sim.ended):
            self._demo = False
            self._note("hand", "you have the sticks")
        inputs = None if self._demo else inputs_of(sticks, message, self.scenario.arm)
        flown = -1 if inputs is None else _arriving(way, sticks.seq)
        if handed:
            self._note("hand-over", handed)
        if inputs is not None and left:
            inputs = self._left_alone(inputs, left)
        if inputs is not None and (camera.pan or camera.tilt or camera.zoom):
            inputs = msgspec.structs.replace(inputs, camera=camera)
        frame = self._sim.step(inputs)
        if self._monitors != self._monitors_kept:
            self._monitors_kept = self._monitors
            self._tape.shown(frame.time_s, self._monitors)
        self._keep_light(frame.time_s)
        self._tape.step(inputs, frame, self._latency_ms)
        for text in self._tape.complaints():
            self._note("recording", text, "warning")
        if frame.tick % LOOK_EVERY == 1:
            self._axis = _deflected(frame) or self._axis
            self._ahead = self._displays.ahead(self._sim.ahead(self._look_s, self._axis), frame)
        shown = self._displays.frame(
            frame, sticks.seq, self._tape.running_s, self._ahead, self._lighting_kept, flown_seq=flown
        )
        self.recent.add(frame, shown.display.lamps, self._latency_ms, self._monitors)
        self._newest = _encoder.encode(shown)
        self._note_all(frame)

    def _none_under_way(self) -> deque[int]:
        """Return a queue of stick numbers, as long as the command delay; all are -1, the number of no page's sticks."""
        return deque([-1] * self.scenario.delay)

    def _keep_light(self, time_s: float) -> None:
        """Apply a change of the lighting from this step on, record it, and log a change of condition or lamps."""
        lighting, before = self._lighting, self._lighting_kept
        if lighting == before:
            return
        self._lighting_kept = lighting
        self._tape.light(time_s, lighting)
        if before is not None and (lighting.condition, lighting.lamps) != (before.condition, before.lamps):
            lit = ", ".join(lighting.lamps) or "none"
            self._note("light", f"light: {lighting.condition}; lamps lit: {lit}")

    def _left_alone(self, inputs: Inputs, cause: str) -> Inputs:
        now, frame = time.monotonic(), self._sim.frame
        inputs, text = left_alone(inputs, frame, cause, under_way=now < self._left_until)
        if inputs.rate_hold and frame is not None and frame.rate_hold:
            self._left_until = now + self.scenario.delay * self.scenario.control_period + SILENCE
        if text:
            self._note("hands off", text, "caution")
        return inputs

    def _in_hand(self, now: float) -> bool:
        """Return whether a stick is deflected or RATE HOLD keeps a rate, so that the page must not be silent.

        RATE HOLD that the station has cancelled stays on during the command delay; it does not count meanwhile.
        """
        frame = self._sim.frame
        kept = not self._demo and frame is not None and frame.rate_hold and now >= self._left_until
        return kept or any(travel(self._sticks))

    def _restart(self) -> None:
        self._tape.end("restarted")
        self._sim = Simulation(self.scenario, self._seed)
        self.recent = RecentFlight(self.scenario)
        self._demo = self._start_demo
        self._under_way = self._none_under_way()
        self._ahead = self._axis = None
        self._monitors_kept = ()
        self._lighting, self._lighting_kept = self.scenario.lighting, None
        self._tape.begin(self.scenario, self._sim.seed)
        self._recorded = NO_CONTROLLERS  # the new file must have the controllers too
        self._note("restart", f"{self.scenario.title}: from the beginning")

    def _note(self, kind: str, text: str, level: Level = "info") -> None:
        event = Event(self._time(), kind, level, text)
        self._tape.note(event)
        with self._lock:
            self._log.append(event)

    def _note_all(self, frame: SimFrame) -> None:
        if frame.events:
            with self._lock:
                self._log.extend(frame.events)


def _deflected(frame: SimFrame) -> Axis | None:
    """Return the axis with the largest deflection, and its sign; None if the sticks are centred."""
    axes = (*frame.rotation, *frame.translation, frame.drive)
    most = max(range(len(axes)), key=lambda k: abs(axes[k]))
    if axes[most] == 0.0:
        return None
    return most, 1 if axes[most] > 0.0 else -1


def _arriving(way: deque[int], number: int) -> int:
    """Add a stick number to the command delay, and return the number that leaves it in this step."""
    way.append(number)
    return way.popleft()
