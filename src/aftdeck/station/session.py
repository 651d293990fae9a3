"""A flight that pages share: one thread steps the simulation, pages send commands and get its frames.

The thread never waits for a page: frames are handed over newest first, commands wait in a bounded queue, one
a step. One page flies, the others watch; the first comes first, and when it leaves the next one takes over.
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
from aftdeck.simulation.cameras import CameraDrive
from aftdeck.simulation.frame import Event, Level
from aftdeck.simulation.frame import Frame as SimFrame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.look_ahead import Axis
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.warm import warm_up
from aftdeck.station import from_page, kinds, to_page
from aftdeck.station.commands import (
    check_camera,
    check_light,
    check_shown,
    check_sticks,
    check_switch,
    inputs_of,
    travel,
)
from aftdeck.station.recent import RecentFlight
from aftdeck.station.unattended import left_alone
from aftdeck.station.wire import Translator, controller_records

LOST = 2.0
"""Deflected sticks that are silent for longer than this are seen at rest before they are flown again [s]."""
SILENCE = 0.5
"""Sticks not heard of for this long [s] go to zero."""
MOST_WAITING = 32
"""Commands that may wait to be flown; one is taken a step."""
MOST_BEHIND = 0.25
"""A step this late [s] is not caught up on: the clock starts afresh from there."""
LOOK_EVERY = 10
"""Steps from one look ahead to the next."""
LOOK_S = 5.0
"""How far is looked ahead until a page says otherwise [s]."""
MOVED = 1e-3
"""Stick deflection from which a person takes over from the demonstration."""
NO_CONTROLLERS = from_page.Controllers(0, ())
HANDS_OFF = from_page.Sticks(-1, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0)
STILL = CameraDrive("")
"""No camera turns."""

_encoder = msgspec.json.Encoder()


class Phase(Enum):
    """Life of a session."""

    READY = "ready"
    FLYING = "flying"
    FAILED = "failed"
    CLOSED = "closed"


class Session:
    """One scenario in flight.

    Attributes:
        scenario: what is flown.
        phase: where in its life the session is.
        failure: why it failed, in a sentence.
        welcome: what a new page is told.
        recent: the last minutes of the present flight.
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
        self._translator = Translator(scenario, demo=demo)
        self.welcome = self._translator.welcome
        self._start_demo = demo
        self._demo = demo
        warm_up(scenario)
        self._sim = Simulation(scenario, seed)
        self.recent = RecentFlight(scenario)
        self._translator.frame(Simulation(scenario, seed).step(Inputs()), -1)  # its own laws too
        self._lock = threading.Lock()
        self._record, self._trial, self._live = record, trial, live
        self._tape = Tape(record, Index(), live, trial)
        self._latency_ms: float | None = None
        self._look_s = LOOK_S
        self._ahead: to_page.Ahead | None = None
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
        """A session as this one was asked for, of another scenario; its recording goes into the same folder."""
        return Session(
            scenario, self._seed, demo=self._start_demo, record=self._record, trial=self._trial, live=self._live
        )

    def start(self, told: Callable[[], None]) -> None:
        """Begin to fly; `told` is called from the simulation's thread after each step."""
        self._told = told
        self.phase = Phase.FLYING
        self._thread.start()

    def close(self) -> None:
        """Stop flying and wait for the thread."""
        self._stop.set()
        if self._thread.is_alive():
            self._thread.join(timeout=5.0)
        self._tape.close()
        self.phase = Phase.CLOSED

    @property
    def folder(self) -> Path | None:
        """Where its flights are recorded; None: nowhere."""
        return self._record

    @property
    def file(self) -> Path | None:
        """What the present flight is recorded into; None: nothing."""
        return self._tape.file

    @property
    def newest(self) -> bytes:
        """The newest frame, encoded; empty before the first."""
        return self._newest

    def log_since(self, index: int) -> tuple[Event, ...]:
        """The log's lines from an index on."""
        with self._lock:
            return tuple(self._log[index:])

    def steer(self, sticks: from_page.Sticks) -> None:
        """Where the sticks of the page that flies stand.

        Those that were deflected and silent for longer than `LOST` are flown again when they have been at rest.

        Raises:
            CommandError: a stick beyond its travel, or one that was lost and is still deflected, told once.
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
        """How the switches stand that turn a camera.

        Raises:
            CommandError: a camera that cannot be turned, a switch beyond its travel, or the script flies.
        """
        check_camera(message, self.welcome)
        if self._demo:
            raise CommandError("the script flies: take the sticks, then the cameras turn, too")
        with self._lock:
            self._camera = CameraDrive(message.camera, message.pan, message.tilt, message.zoom, message.slow)
            self._camera_heard = time.monotonic()

    def shown(self, message: from_page.Shown) -> None:
        """What the page that flies measures of itself and shows.

        Raises:
            CommandError: a camera that there is not.
        """
        check_shown(message, self.welcome)
        self._latency_ms, self._monitors = message.latency_ms, message.monitors

    def light(self, message: from_page.SetLight) -> None:
        """How the light shall stand; whoever flies may say so, the script's onlooker too.

        Raises:
            CommandError: a condition, a lamp or a camera that there is not.
        """
        check_light(message.lighting, self.welcome)
        self._lighting = message.lighting

    def controllers_in_use(self, message: from_page.Controllers) -> None:
        """What moves the sticks of the page that flies, and how."""
        with self._lock:
            self._controllers = message

    def let_go(self, cause: str = "page gone") -> None:
        """Sticks to zero and commands forgotten: nobody is at the controls, for one of `unattended.CAUSES`."""
        with self._lock:
            self._sticks, self._camera, self._zeroed, self._lost = HANDS_OFF, STILL, False, ""
            self._commands.clear()
            self._left = cause
            self._under_way = self._none_under_way()  # whoever comes numbers its sticks anew
            self._controllers = NO_CONTROLLERS
        self._latency_ms, self._monitors = None, ()

    def hand_over(self, text: str) -> None:
        """Another page will fly, as the log says: nothing moves meanwhile.

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
        """Queue a switch's movement for one of the next steps.

        STOP overtakes: what waits is forgotten, so that it is never refused and never late.

        Raises:
            CommandError: a switch position that does not exist, a target beyond all reason, or too many
                commands at once.
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
        """Step at the control period until told to stop."""
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
        except Exception as error:  # the pages must hear of it, whatever it was
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
        inputs = None if self._demo else inputs_of(sticks, message, self._translator.target)
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
            self._ahead = self._translator.ahead(self._sim.ahead(self._look_s, self._axis), frame)
        shown = self._translator.frame(
            frame, sticks.seq, self._tape.running_s, self._ahead, self._lighting_kept, flown_seq=flown
        )
        self.recent.add(frame, shown.lamps, self._latency_ms, self._monitors)
        self._newest = _encoder.encode(shown)
        self._note_all(frame)

    def _none_under_way(self) -> deque[int]:
        """Numbers of the sticks that the command delay holds back, as the simulation does their inputs: nobody's."""
        return deque([-1] * self.scenario.delay)

    def _keep_light(self, time_s: float) -> None:
        """Take over what was said of the light, with this step."""
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
        """A stick is deflected, or RATE HOLD keeps one: the page has to be heard of.

        RATE HOLD that was let go for a silent page stays on until that has come through the command delay.
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
        self._recorded = NO_CONTROLLERS  # the new file is told anew
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
    """The axis that is deflected most, and which way; None: the sticks rest."""
    axes = (*frame.rotation, *frame.translation, frame.drive)
    most = max(range(len(axes)), key=lambda k: abs(axes[k]))
    if axes[most] == 0.0:
        return None
    return most, 1 if axes[most] > 0.0 else -1


def _arriving(way: deque[int], number: int) -> int:
    """Number of the sticks that arrive as these are taken."""
    way.append(number)
    return way.popleft()
