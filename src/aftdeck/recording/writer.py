"""Recorder of a run: the simulation's thread appends data to a queue, and a thread of the recorder writes it.

Appending takes constant time. The recorder's thread converts the data to messages and closes a chunk of the file every
`FLUSH_S`, so that a killed program loses at most a second. An error ends the recording, never the run.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple, cast

import foxglove
from foxglove.mcap import MCAPCompression, MCAPWriteOptions

from aftdeck.encodable import encodable
from aftdeck.errors import RecordingError
from aftdeck.recording.bundle import opening
from aftdeck.recording.channels import DECLARED, Channels
from aftdeck.recording.content import Content, Ended, Entry, Recorded
from aftdeck.recording.delays import Delays
from aftdeck.recording.index import Index
from aftdeck.recording.live import Live
from aftdeck.recording.records import PROFILE
from aftdeck.recording.sink import Sink
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.recording.viewing import Viewing
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.summary import Summary

FLUSH_S = 0.85
"""Time after which a chunk of the file is closed [s]; with `POLL_S` and the writing, less than the second that a killed
program may lose. Each chunk is compressed by itself, so that shorter chunks make a longer file."""
POLL_S = 0.05
"""Interval at which the thread checks its queue [s]; to wake the thread in each step would delay the simulation."""
BATCH = 16
"""Number of entries that the thread writes at once in a run that is faster than real time. With more entries, they no
longer fit into the processor's cache."""
MAX_WAITING = 20_000
"""Maximum number of entries in the queue; beyond it, the recording ends."""
BEGIN_S = 2.0
"""Longest time for which a run waits, at its start, for the header to be written [s]."""
MAX_DISK_WAIT_S = 30.0
"""Longest wait for the disk at the end of a run, and in a run that is faster than real time [s]."""
_SLOW_DISK = f"the disk was not ready within {MAX_DISK_WAIT_S:g} s"


_Fields = tuple[Inputs | None, Frame, float, float | None]
"""Fields of `Recorded`."""


class _End(NamedTuple):
    ended: Ended
    summary: Summary | None


class Recorder:
    """Recorder of one run, into one file or for viewers only.

    Attributes:
        path: the file; None if the run is only sent to viewers.
        failure: reason why the recording failed, in a sentence; empty if it has not failed.
        unlisted: reason why the file is not in the list of recordings, in a sentence; empty if no error occurred.
        steps: number of steps recorded so far.
        chain: head of the hash chain over the file's messages; empty until the footer is written.
        delays: delays of the steps written so far; None if the run is not in real time.
        grade: grade of the operator's task, for the list of recordings; empty if it has none.
    """

    def __init__(
        self,
        path: Path | None,
        scenario: Scenario,
        seed: int,
        *,
        trial: Trial = NO_TRIAL,
        live: Live | None = None,
        index: Index | None = None,
        after: Recorder | None = None,
        real_time: bool = False,
    ) -> None:
        """Begin the recording.

        Args:
            path: file to create; its folder is created if it is missing. None: the run is only sent to viewers.
            scenario: the scenario of the run.
            seed: the seed of the run.
            trial: participant and condition.
            live: server for viewers; it continues after the run.
            index: list of recordings to which the file is added.
            after: recorder of the previous run; this recorder writes only after `after` has finished.
            real_time: whether the steps are due at times of the wall clock; late steps are then recorded.

        Raises:
            RecordingError: the file exists already or cannot be written.
        """
        self.path = path
        self.failure = self.unlisted = self.chain = self.grade = ""
        self._index = index if path else None
        self._after = after
        self.steps = 0
        self._sink = Sink(path) if path else None
        self._began = time.perf_counter()
        self._began_ns = time.time_ns()
        self._opening = opening(scenario, seed, self._began_ns, trial, real_time=real_time)
        self._waiting: deque[Entry | _Fields | _End] = deque()
        self._wake, self._empty = threading.Event(), threading.Event()
        self.delays: Delays | None = None
        self._live = live
        self._scenario = scenario
        self._ended = False
        self._thread = threading.Thread(target=self._work, name="recording", daemon=True)
        self._begun = threading.Event()
        self._thread.start()
        if after is None:  # otherwise the header must wait for the end of the previous recording
            self._begun.wait(BEGIN_S)

    # --- called by the simulation's thread ----------------------------------------------------------------

    def step(self, inputs: Inputs | None, frame: Frame, latency_ms: float | None = None) -> None:
        """Record a step: its inputs and its frame."""
        if not self.failure:  # plain statements: after the wait for a step, each call of a function takes microseconds
            self._waiting.append((inputs, frame, time.perf_counter() - self._began, latency_ms))
            self.steps += 1
            if len(self._waiting) > MAX_WAITING:
                self._end_full()

    def put(self, entry: Entry) -> None:
        """Record an entry."""
        if not self.failure:
            self._waiting.append(entry)
            self.steps += isinstance(entry, Recorded)
            if len(self._waiting) > MAX_WAITING:
                self._end_full()

    def take_turns(self) -> None:
        """Wait until the queue is empty if it has `BATCH` entries; used in runs that are faster than real time.

        The recording fails if this takes longer than `MAX_DISK_WAIT_S`. Without turns, the threads of simulation and
        recorder compete for Python's lock, which takes 20 to 30 us in each step.
        """
        if len(self._waiting) < BATCH:
            return
        self._empty.clear()
        self._wake.set()
        latest = time.monotonic() + MAX_DISK_WAIT_S
        while self._waiting and self.writing and not self.failure:
            self._empty.wait(POLL_S)
            if time.monotonic() > latest:
                self._fail(_SLOW_DISK)

    def finish(self, ended: Ended, summary: Summary | None = None) -> None:
        """End the run; do not wait until the rest of the queue and the footer are written."""
        if not self._ended:
            self._ended = True
            self._waiting.append(_End(ended, summary))
            self._wake.set()

    def close(self, ended: Ended, summary: Summary | None = None) -> None:
        """End the run like `finish`, and wait until everything is written."""
        self.finish(ended, summary)
        self.wait()

    @property
    def writing(self) -> bool:
        """Whether the recorder's thread is running."""
        return self._thread.is_alive()

    def wait(self) -> None:
        """Wait until everything is written; if this takes longer than `MAX_DISK_WAIT_S`, the recording fails."""
        self._thread.join(MAX_DISK_WAIT_S)
        if self._thread.is_alive():
            self._fail(_SLOW_DISK)

    def _end_full(self) -> None:
        self._fail(f"the disk is too slow: {MAX_WAITING} steps are waiting")

    # --- the recorder's thread ------------------------------------------------------------------------------

    def _fail(self, why: str) -> None:
        if not self.failure:
            self.failure = encodable(f"{self.path or 'viewers'}: recording stopped, the run continues: {why}")

    def _work(self) -> None:
        if self._after is not None:
            self._after.wait()
            self._after = None
        ended, time_s = "cut", 0.0
        listing = threading.Thread(  # in its own thread, because other programs may lock the list for seconds
            target=self._list, args=(lambda index, path: index.begin(path, self._opening),), daemon=True
        )
        listing.start()
        try:
            ended, time_s = self._write()
        except BaseException as error:  # report every error to the operator, even a panic in the library
            self._fail(f"{type(error).__name__}: {error}")
        finally:
            self._begun.set()
            self._waiting.clear()
            if self._sink is not None:
                self._sink.close()
                if self._sink.error:
                    self._fail(self._sink.error)
            listing.join()
            self._list(lambda index, path: index.end(path, ended, time_s, self.chain, self.delays, self.grade))

    def _list(self, update: Callable[[Index, Path], None]) -> None:
        try:
            if self._index is not None and self.path is not None:
                update(self._index, self.path)
        except (RecordingError, OSError) as error:
            self.unlisted = str(error)

    def _next(self) -> Entry | _End | None:
        """Return the next entry of the queue; None if there is none within `POLL_S`."""
        if not self._waiting:
            self._empty.set()
            self._wake.wait(POLL_S)
            self._wake.clear()
        if not self._waiting:
            return None
        item = self._waiting.popleft()
        return Recorded(*item) if type(item) is tuple else cast("Entry | _End", item)

    def _write(self) -> tuple[str, float]:
        """Write until the run or the recording ends; return the reason and the simulated time [s] of the end."""
        channels = self._live.channels if self._live else Channels()
        file = None
        if self._sink is not None:
            file = foxglove.open_mcap(self._sink, context=channels.context, writer_options=_options())
        content = Content(channels.log, DECLARED, self._opening, self._began_ns)
        if file is not None:
            file.flush()
        self._begun.set()
        due = time.monotonic() + FLUSH_S
        view = Viewing(content.log, self._scenario, self._began_ns, self._live)
        view.open()
        content.viewer = view
        self.delays = content.delays
        while not isinstance(item := self._next(), _End):
            if item is not None:
                content.add(item)
                self.delays = content.delays
            if time.monotonic() >= due:
                if file is not None:
                    file.flush()
                due = time.monotonic() + FLUSH_S
            if self.failure or (self._sink is not None and self._sink.error):
                return "cut", content.time_s
        content.close(item.ended, item.summary)
        self.chain = content.head
        if file is not None:
            file.close()
        return item.ended, content.time_s


def _options() -> MCAPWriteOptions:
    return MCAPWriteOptions(
        compression=MCAPCompression.Zstd, compression_level=LEVEL, compression_threads=0, profile=PROFILE
    )


LEVEL = 1
"""Compression level of zstd. A higher level is slower and, because the chunks are short, saves hardly any bytes."""
