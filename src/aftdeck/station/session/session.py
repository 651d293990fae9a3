"""Session of a server: a core with a clock and a lock, its recordings, its painter, and the laws that it compiles.

A session has no thread: `driver.Driver` steps it in real time. While one thread steps the session, another thread may
call the methods for pages.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from pathlib import Path

from aftdeck.law_change import Laws
from aftdeck.lines import print_error
from aftdeck.recording.content import Ended
from aftdeck.recording.index import Index
from aftdeck.recording.live import Live
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.scenario.model import Scenario
from aftdeck.station.core.asked import Asked
from aftdeck.station.core.autopilot import Autopilots
from aftdeck.station.core.core import OF_CONSOLE, Core
from aftdeck.station.core.desk import Answer, Page
from aftdeck.station.core.roles import ControlRoles
from aftdeck.station.core.step import PUNCTUAL, Begun, Delay
from aftdeck.station.messages import from_page
from aftdeck.station.session.painter import Painter
from aftdeck.station.session.session_recorder import SessionRecorder
from aftdeck.station.session.typing_process import TypingProcess
from aftdeck.station.session.warm import warm_up


class Session(Core):
    """Session of one scenario on a server.

    Attributes:
        folder: folder into which the runs are recorded; None if they are not recorded.
        laws: compiled laws of this process.
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
        roles: ControlRoles[Page] | None = None,
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
            roles: control roles of the pages; None: of no page yet.
        """
        self.laws = laws or Laws()
        self.laws.want(warm_up, scenario)
        self.painter = Painter(scenario)
        self._typing = TypingProcess(scenario)
        self._recorder = SessionRecorder(record, Index(), live, trial)
        self._lock = threading.Lock()
        self.folder, self._demo, self._autopilots, self._trial, self._live = record, demo, autopilots, trial, live
        super().__init__(
            scenario,
            seed,
            clock=clock,
            recording=self._recorder,
            observers=[self.painter],
            console=self._typing,
            demo=demo,
            shown=shown,
            autopilots=autopilots,
            roles=roles,
        )

    def another(self, scenario: Scenario, *, shown: bool = False) -> Session:
        """Return a session of another scenario with the same pages, settings and recording folder.

        `shown`: whether the script flies its first run, until the operator moves a stick or sends a command.
        """
        return Session(
            scenario,
            self._seed,
            demo=self._demo,
            shown=shown,
            autopilots=self._autopilots,
            record=self.folder,
            trial=self._trial,
            live=self._live,
            laws=self.laws,
            clock=self._clock,
            roles=self.desk.roles,
        )

    @property
    def file(self) -> Path | None:
        """File into which the present run is recorded; None if it is not recorded."""
        return self._recorder.file

    # --- called for pages ---------------------------------------------------------------------------------

    def receive(self, page: Page, message: from_page.FromPage) -> tuple[Answer, ...]:
        """Take a message of a page, and return the answers to it."""
        if isinstance(message, OF_CONSOLE):  # may take tenths of a second, for which no step may wait
            return super().receive(page, message)
        with self._lock:
            return super().receive(page, message)

    def change(self, changes: dict[str, str]) -> None:
        """Make changes in flight in the next step."""
        with self._lock:
            super().change(changes)

    def accept(self, message: from_page.FromPage) -> None:
        """Take a message of the page in control (`Desk.accept`)."""
        with self._lock:
            self.desk.accept(message)

    def join(self, page: Page, *, may_fly: bool = True) -> None:
        """Add a page (`Desk.join`)."""
        with self._lock:
            self.desk.join(page, may_fly=may_fly)

    def leave(self, page: Page, cause: str = "page gone") -> None:
        """Remove a page (`Desk.leave`)."""
        with self._lock:
            self.desk.leave(page, cause)

    def set_unattended(self, cause: str = "page gone") -> None:
        """Centre the sticks and delete all waiting commands (`Desk.set_unattended`)."""
        with self._lock:
            self.desk.set_unattended(cause)

    # --- called by the thread that steps the session ---------------------------------------------------------------

    def take(self) -> Asked:
        """Return what the pages ask for in the next step."""
        with self._lock:
            return super().take()

    def step(self, delay: Delay = PUNCTUAL) -> bool:
        """Do one control step with the newest inputs of the page in control.

        Args:
            delay: delay with which the step begins.

        Returns:
            Whether the step is the first of a new run.
        """
        restarted = self.step_to_frame(delay)
        self.settle()
        return restarted

    def step_to_frame(self, delay: Delay = PUNCTUAL) -> bool:
        """Do a control step as `step` does, up to all that the pages receive; `settle` does the rest."""
        for text in self._recorder.take_errors():
            self.note("recording", text, "warning")
        return self.fly(self.take(), delay).restarted

    def close(self) -> None:
        """End the run, and wait for its recording."""
        self.painter.close()
        self._typing.close()
        super().close()
        self._recorder.close()

    def _end(self, ended: Ended, step: Begun) -> None:
        """End the run and its recording; if the run has lost time, print how much."""
        super()._end(ended, step)
        if self.delays.lost_s:
            print_error(f"{self.scenario.title!r}, {self.time_s:.2f} s: {self.delays.text()}")
