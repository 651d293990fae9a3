"""Recording of each run of a session into its own file in a folder, without delaying the simulation."""

from __future__ import annotations

import os
from datetime import UTC, datetime
from pathlib import Path

from aftdeck.errors import RecordingError
from aftdeck.lines import print_error
from aftdeck.recording.content import Ended
from aftdeck.recording.index import Index
from aftdeck.recording.live import Live
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.model import Scenario
from aftdeck.station.core.entries import Entries
from aftdeck.station.core.step import Begun, Step

MAX_FILES_PER_SECOND = 999
"""Maximum number of recordings of one scenario that begin in the same second; a number distinguishes their names."""


class SessionRecorder:
    """Recorder of the runs of one session.

    Attributes:
        file: file of the present run; None if the run is not recorded.
    """

    def __init__(
        self, folder: Path | None, index: Index | None, live: Live | None = None, trial: Trial = NO_TRIAL
    ) -> None:
        """Set the folder, the list and the server for the runs of the session.

        Args:
            folder: folder of the recordings; None: runs are not recorded.
            index: list of recordings to which the files are added.
            live: server to which viewers attach.
            trial: participant and condition, stored in each file.
        """
        self._folder, self._index, self._live, self._trial = folder, index, live, trial
        self._recorder: Recorder | None = None
        self._ending: list[Recorder] = []
        self._new_errors: list[str] = []
        self._reported: set[str] = set()
        self._entries = Entries(0.0)

    @property
    def file(self) -> Path | None:
        """File of the present run; None if the run is not recorded."""
        return self._recorder.path if self._recorder and not self._recorder.failure else None

    @property
    def recorded(self) -> bool:
        """Whether the present run is recorded into a file."""
        return self.file is not None

    def begin(self, scenario: Scenario, seed: int, now: float) -> None:
        """Start to record a run at the time `now` [s]; after a failure, `take_errors` returns the reason."""
        if self._folder is None and self._live is None:
            return
        self._entries = Entries(now)
        writing = [recorder for recorder in self._ending if recorder.writing]
        # Collect errors only after this list is made: a recorder that is not in the list has already stored its errors.
        self._collect_errors()
        self._ending = writing
        before = self._ending[-1] if self._ending else None
        try:
            path = self._folder and _free_name(self._folder, scenario.name)
            self._recorder = Recorder(
                path,
                scenario,
                seed,
                trial=self._trial,
                live=self._live,
                index=self._index,
                after=before,
                real_time=True,
            )
        except RecordingError as error:
            self._report(f"the run is not recorded: {error}")
            if self._live is not None:
                self._recorder = Recorder(None, scenario, seed, live=self._live, after=before, real_time=True)

    def see(self, step: Step) -> None:
        """Record a step of the run."""
        if self._recorder is None:
            return
        for entry in self._entries.of(step):
            self._recorder.put(entry)
        if step.debrief is not None:
            self._recorder.grade = step.debrief.grade or ""

    def take_errors(self) -> list[str]:
        """Return the errors since the last call, each as a sentence."""
        self._collect_errors()
        errors, self._new_errors = self._new_errors, []
        return errors

    def _collect_errors(self) -> None:
        """Collect new errors from all recorders, and print them."""
        for recorder in (*self._ending, *([self._recorder] if self._recorder else [])):
            for text in (recorder.failure, recorder.unlisted):
                if text and text not in self._reported:
                    self._report(text)

    def end(self, ended: Ended, step: Begun | None = None) -> None:
        """End the run, with the step that the simulation has not made; another thread closes its file."""
        if self._recorder is not None:
            for entry in self._entries.before_the_end(step) if step is not None else ():
                self._recorder.put(entry)
            self._recorder.finish(ended)
            self._ending.append(self._recorder)
            self._recorder = None

    def close(self) -> None:
        """End the session: wait for its files, and print their errors on the terminal."""
        self.end("stopped")
        for recorder in self._ending:
            recorder.close("stopped")
        self.take_errors()
        self._ending.clear()

    def _report(self, text: str) -> None:
        self._reported.add(text)
        self._new_errors.append(text)
        print_error(text)


def _free_name(folder: Path, scenario: str) -> Path:
    """Return a path at which no file exists, such as ``first-flight-20261121-143000.mcap`` (time in UTC).

    If a file with this name exists, ``-2`` is appended to the name, or the next number that is free.
    """
    stem = f"{scenario}-{datetime.now(UTC):%Y%m%d-%H%M%S}"
    for ending in ("", *(f"-{n}" for n in range(2, MAX_FILES_PER_SECOND + 1))):
        path = folder / f"{stem}{ending}.mcap"
        if not os.path.lexists(path):  # Path.exists raises if the folder cannot be read
            return path
    raise RecordingError(f"{folder}: has {MAX_FILES_PER_SECOND} recordings with the name {stem} already")
