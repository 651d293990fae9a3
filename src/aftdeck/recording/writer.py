"""Recording a run: one thread writes what the simulation's thread hands over in constant time.

What is handed over waits in a queue. The writer's thread turns it into messages and closes a chunk of the file every
`FLUSH_S`, so that a program that is killed loses no more than a second. An error ends the recording, never the flight.
"""

from __future__ import annotations

import hashlib
import threading
import time
from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import Literal, NamedTuple

import foxglove
import msgspec
from foxglove.mcap import MCAPCompression, MCAPWriteOptions

from aftdeck.errors import RecordingError
from aftdeck.recording.bundle import opening
from aftdeck.recording.channels import Channels
from aftdeck.recording.convert import frame_record, input_record, light_record
from aftdeck.recording.index import Index
from aftdeck.recording.live import Live
from aftdeck.recording.records import (
    CHANNELS,
    PROFILE,
    Closing,
    ControllerRecord,
    ControllersRecord,
    LightRecord,
    Note,
    Shown,
)
from aftdeck.recording.sink import Sink
from aftdeck.recording.trial import NO_TRIAL, Trial
from aftdeck.recording.viewing import Viewing
from aftdeck.scenario.light import Lighting
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Event, Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.summary import Summary

FLUSH_S = 0.5
"""A chunk of the file is closed this often [s]."""
LOOK_S = 0.05
"""The writer looks this often for what waits [s]: to be woken by each step would cost the flight more."""
MOST_WAITING = 20_000
"""Steps that may wait to be written; a disk that falls further behind ends the recording."""
BEGIN_S = 2.0
"""How long a session's first flight waits for its file's first message [s]."""
PATIENCE_S = 30.0
"""How long the end of a run waits for the disk [s]."""

Ended = Literal["completed", "time", "fault", "stopped", "restarted"]


class _Step(NamedTuple):
    inputs: Inputs | None
    frame: Frame
    wall_s: float
    latency_ms: float | None


class _End(NamedTuple):
    ended: Ended
    summary: Summary | None


_CHANNEL = {kind: topic for topic, (kind, _) in CHANNELS.items()}
"""Of each type of message."""
_Told = ControllersRecord | Shown | LightRecord
"""What is handed over as the message that is written, and shown to no viewer."""


class Recorder:
    """Writes one run into one file, or for viewers alone.

    Attributes:
        path: the file; None: there is none.
        failure: why recording stopped, in a sentence; empty while it goes on.
        unlisted: why the file is not in the list of recordings, in a sentence; empty where it is, or need not be.
        steps: handed over so far.
    """

    def __init__(
        self,
        path: Path | None,
        scenario: Scenario,
        seed: int,
        *,
        changes: tuple[str, ...] = (),
        trial: Trial = NO_TRIAL,
        live: Live | None = None,
        index: Index | None = None,
        after: Recorder | None = None,
    ) -> None:
        """Begin the file.

        Args:
            path: where; its folder is made where it is missing. None: viewers alone see the run.
            scenario: what is flown.
            seed: with which seed.
            changes: KEY=VALUE, where a replay changed the scenario.
            trial: who takes part, and under which condition.
            live: where viewers attach; it outlives the run.
            index: list to keep the file in.
            after: the recorder of the run before, which is let finish before this one writes.

        Raises:
            RecordingError: it exists already or cannot be written.
        """
        self.path = path
        self.failure = self.unlisted = ""
        self._index = index if path else None
        self._after = after
        self.steps = 0
        self._sink = Sink(path) if path else None
        self._began = time.perf_counter()
        self._began_ns = time.time_ns()
        self._opening = opening(scenario, seed, self._began_ns, changes, trial)
        self._waiting: deque[_Step | Note | _Told | _End] = deque()
        self._over = threading.Event()
        self._live = live
        self._scenario = scenario
        self._ended = False
        self._thread = threading.Thread(target=self._work, name="recording", daemon=True)
        self._begun = threading.Event()
        self._thread.start()
        if after is None:  # before a session's first flight there is time to see that its file stands
            self._begun.wait(BEGIN_S)

    # --- called by whoever flies --------------------------------------------------------------------------

    def step(self, inputs: Inputs | None, frame: Frame, latency_ms: float | None = None) -> None:
        """Hand over a step: what was flown and what came of it."""
        if self.failure:
            return
        self._waiting.append(_Step(inputs, frame, time.perf_counter() - self._began, latency_ms))
        self.steps += 1
        if len(self._waiting) > MOST_WAITING:
            self._fail(f"{MOST_WAITING} steps wait to be written: the disk is too slow")

    def note(self, event: Event) -> None:
        """Hand over a line that the station wrote in the log."""
        if not self.failure:
            wall = round(time.perf_counter() - self._began, 6)
            self._waiting.append(Note(event.time_s, event.kind, event.level, event.text, wall))

    def controllers(self, time_s: float, used: tuple[ControllerRecord, ...]) -> None:
        """Hand over what moves the sticks from now on."""
        if not self.failure:
            wall = round(time.perf_counter() - self._began, 6)
            self._waiting.append(ControllersRecord(time_s, used, wall))

    def shown(self, time_s: float, monitors: tuple[tuple[str, ...], ...]) -> None:
        """Hand over what the monitors show from now on."""
        if not self.failure:
            mon_1, mon_2 = (*monitors, (), ())[:2]
            self._waiting.append(Shown(time_s, mon_1, mon_2))

    def light(self, time_s: float, lighting: Lighting) -> None:
        """Hand over how the light stands from now on."""
        if not self.failure:
            self._waiting.append(light_record(time_s, lighting))

    def wait_for_room(self) -> None:
        """Let the disk catch up: for runs that no clock drives."""
        while len(self._waiting) > MOST_WAITING // 2 and not self.failure:
            time.sleep(0.001)

    def finish(self, ended: Ended, summary: Summary | None = None) -> None:
        """The run has ended: what waits is written, and the end. Nobody waits for it."""
        if not self._ended:
            self._ended = True
            self._waiting.append(_End(ended, summary))
            self._over.set()

    def close(self, ended: Ended, summary: Summary | None = None) -> None:
        """As `finish`, and wait until it is done."""
        self.finish(ended, summary)
        self.wait()

    @property
    def writing(self) -> bool:
        """Whether something may still be written."""
        return self._thread.is_alive()

    def wait(self) -> None:
        """Wait until everything is written; a disk that takes nothing ends the recording."""
        self._thread.join(PATIENCE_S)
        if self._thread.is_alive():
            self._fail(f"the disk took nothing for {PATIENCE_S:g} s")

    # --- the writer's thread ------------------------------------------------------------------------------

    def _fail(self, why: str) -> None:
        if not self.failure:
            self.failure = f"{self.path or 'viewers'}: recording stopped, the flight goes on: {why}"

    def _work(self) -> None:
        if self._after is not None:
            self._after.wait()
            self._after = None
        ended, time_s = "cut", 0.0
        listing = threading.Thread(  # apart, since other programs may hold the list for seconds
            target=self._list, args=(lambda index, path: index.begin(path, self._opening),), daemon=True
        )
        listing.start()
        try:
            ended, time_s = self._write()
        except BaseException as error:  # whatever it is, a breakdown in the library too: the flight's people must hear
            self._fail(f"{type(error).__name__}: {error}")
        finally:
            self._begun.set()
            self._waiting.clear()
            if self._sink is not None:
                self._sink.close()
                if self._sink.error:
                    self._fail(self._sink.error)
            listing.join()
            self._list(lambda index, path: index.end(path, ended, time_s))

    def _list(self, tell: Callable[[Index, Path], None]) -> None:
        try:
            if self._index is not None and self.path is not None:
                tell(self._index, self.path)
        except (RecordingError, OSError) as error:
            self.unlisted = str(error)

    def _write(self) -> tuple[str, float]:
        """Write until the end; how the run ended, and after how long [s]."""
        channels = self._live.channels if self._live else Channels()
        file = None
        if self._sink is not None:
            file = foxglove.open_mcap(self._sink, context=channels.context, writer_options=_options())
        channels.log("/opening", self._opening, self._began_ns)
        if file is not None:
            file.flush()
        self._begun.set()
        due = time.monotonic() + FLUSH_S
        view = Viewing(channels, self._scenario, self._began_ns, self._live)
        view.open()
        frames = hashlib.sha256()
        ticks, time_s, now = 0, 0.0, self._began_ns
        item: _Step | Note | _Told | _End | None = None
        while not isinstance(item, _End):
            if not self._waiting:
                self._over.wait(LOOK_S)
            item = self._waiting.popleft() if self._waiting else None
            if isinstance(item, _Step):
                frames.update(bytes.fromhex(item.frame.sha256))
                ticks, time_s = item.frame.tick, item.frame.time_s
                now = self._began_ns + round(time_s * 1e9)
                channels.log("/inputs", input_record(ticks, item.inputs), now)
                record = frame_record(item.frame, item.wall_s, item.latency_ms)
                channels.log("/frames", record, now)
                view.frame(item.frame)
            elif isinstance(item, Note):
                channels.log("/notes", item, now)
                view.line(item, now)
            elif isinstance(item, _Told):
                channels.log(_CHANNEL[type(item)], item, now)
            if time.monotonic() >= due:
                if file is not None:
                    file.flush()
                due = time.monotonic() + FLUSH_S
            if self.failure or (self._sink is not None and self._sink.error):
                return "cut", time_s
        summary = msgspec.json.encode(item.summary).decode() if item.summary else ""
        channels.log("/closing", Closing(item.ended, ticks, frames.hexdigest(), summary), now)
        if file is not None:
            file.close()
        return item.ended, time_s


def _options() -> MCAPWriteOptions:
    return MCAPWriteOptions(
        compression=MCAPCompression.Zstd, compression_level=LEVEL, compression_threads=0, profile=PROFILE
    )


LEVEL = 1
"""Of zstd: on chunks of a second the higher ones are slower and hardly smaller."""
