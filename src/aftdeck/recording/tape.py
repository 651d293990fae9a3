"""Recording flight after flight into a folder: a file for each, and none of it ever in the flight's way."""

from __future__ import annotations

import os
import sys
from datetime import UTC, datetime
from pathlib import Path

from aftdeck.errors import RecordingError
from aftdeck.recording.index import Index
from aftdeck.recording.live import Live
from aftdeck.recording.records import ControllerRecord
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.recording.writer import Ended, Recorder
from aftdeck.scenario.light import Lighting
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Event, Frame
from aftdeck.simulation.inputs import Inputs

MOST_OF_A_NAME = 999
"""Files that may begin in one second under one name."""


class Tape:
    """Records the flights of one session.

    Attributes:
        file: of the present flight; None: it is not recorded.
    """

    def __init__(
        self, folder: Path | None, index: Index | None, live: Live | None = None, trial: Trial = NO_TRIAL
    ) -> None:
        """Record into a folder.

        Args:
            folder: where to; None records nothing.
            index: list to keep the files in.
            live: where viewers attach.
            trial: who takes part, and under which condition: every file says so.
        """
        self._folder, self._index, self._live, self._trial = folder, index, live, trial
        self._recorder: Recorder | None = None
        self._ending: list[Recorder] = []
        self._complaints: list[str] = []
        self._told: set[str] = set()
        self._period = 0.0

    @property
    def file(self) -> Path | None:
        """The present flight's file; None: it is not recorded."""
        return self._recorder.path if self._recorder and not self._recorder.failure else None

    @property
    def running_s(self) -> float | None:
        """Simulated time in the present file [s]; None: the flight is not recorded."""
        return self._recorder.steps * self._period if self._recorder and self.file else None

    def begin(self, scenario: Scenario, seed: int) -> None:
        """A flight begins. What cannot be recorded is told by `complaints`."""
        if self._folder is None and self._live is None:
            return
        self._period = scenario.control_period
        still = [recorder for recorder in self._ending if recorder.writing]
        self._look()  # after that: what those that are done had to say is said
        self._ending = still
        before = self._ending[-1] if self._ending else None
        try:
            path = self._folder and _free_name(self._folder, scenario.name)
            self._recorder = Recorder(
                path, scenario, seed, trial=self._trial, live=self._live, index=self._index, after=before
            )
        except RecordingError as error:
            self._complain(f"nothing is recorded: {error}")
            if self._live is not None:
                self._recorder = Recorder(None, scenario, seed, live=self._live, after=before)

    def step(self, inputs: Inputs | None, frame: Frame, latency_ms: float | None) -> None:
        """A step of the flight."""
        if self._recorder is not None:
            self._recorder.step(inputs, frame, latency_ms)

    def note(self, event: Event) -> None:
        """A line that the station wrote in the log."""
        if self._recorder is not None:
            self._recorder.note(event)

    def controllers(self, time_s: float, used: tuple[ControllerRecord, ...]) -> None:
        """What moves the sticks from the next step on."""
        if self._recorder is not None:
            self._recorder.controllers(time_s, used)

    def shown(self, time_s: float, monitors: tuple[tuple[str, ...], ...]) -> None:
        """What the monitors show from now on."""
        if self._recorder is not None:
            self._recorder.shown(time_s, monitors)

    def light(self, time_s: float, lighting: Lighting) -> None:
        """How the light stands from now on."""
        if self._recorder is not None:
            self._recorder.light(time_s, lighting)

    def complaints(self) -> list[str]:
        """What went wrong since this was last asked, a sentence each."""
        self._look()
        told, self._complaints = self._complaints, []
        return told

    def _look(self) -> None:
        """Ask each recorder what went wrong with it."""
        for recorder in (*self._ending, *([self._recorder] if self._recorder else [])):
            for text in (recorder.failure, recorder.unlisted):
                if text and text not in self._told:
                    self._complain(text)

    def end(self, ended: Ended) -> None:
        """The flight ends; its file is closed behind its back."""
        if self._recorder is not None:
            self._recorder.finish(ended)
            self._ending.append(self._recorder)
            self._recorder = None

    def close(self) -> None:
        """The session ends: wait for its files, and say on the terminal what went wrong with them."""
        self.end("stopped")
        for recorder in self._ending:
            recorder.close("stopped")
        self.complaints()
        self._ending.clear()

    def _complain(self, text: str) -> None:
        self._told.add(text)
        self._complaints.append(text)
        print(f"aftdeck: {text}", file=sys.stderr, flush=True)


def _free_name(folder: Path, scenario: str) -> Path:
    """``first-flight-20261121-143000.mcap``, UTC, with a number behind it where there is such a file."""
    stem = f"{scenario}-{datetime.now(UTC):%Y%m%d-%H%M%S}"
    for ending in ("", *(f"-{n}" for n in range(2, MOST_OF_A_NAME))):
        path = folder / f"{stem}{ending}.mcap"
        if not os.path.lexists(path):  # unlike Path.exists, raises nothing where the folder cannot be looked into
            return path
    raise RecordingError(f"{folder}: {MOST_OF_A_NAME} recordings called {stem} are there already")
