"""Recording prepared for playback: its frames in blocks, and the data of the whole run.

A recording can only be read forwards and may be hours long. Therefore the store reads it once. It writes the frames
into a temporary file, compressed block by block, and collects the data of the whole run. The page requests the blocks
later.
"""

from __future__ import annotations

import zlib
from bisect import bisect
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from pathlib import Path
from tempfile import TemporaryFile, gettempdir
from threading import Lock
from types import TracebackType
from typing import TypeVar

import msgspec
from msgspec.structs import replace

from aftdeck.encodable import encodable
from aftdeck.errors import AftdeckError, RecordingError
from aftdeck.recording.bundle import scenario_of
from aftdeck.recording.convert import lighting_of
from aftdeck.recording.delays import Delays
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import DelayRecord, FrameRecord, LightRecord, Note, Shown
from aftdeck.report.lamps import lit_lamps
from aftdeck.report.lanes import Lanes
from aftdeck.report.run_metrics import RunMetrics
from aftdeck.report.strips import Strips, curve_values, worst_joint
from aftdeck.scenario.light import Lighting
from aftdeck.scenario.load import in_force
from aftdeck.simulation.frame import Event
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.conversion.measures_of import REPLAY, ended, measures_of
from aftdeck.station.conversion.welcome_of import changed_of, welcome_of
from aftdeck.station.messages.playback import BLOCK, Block, ChangedFrom, Moment, Pictured, PlaybackIndex, Verdict
from aftdeck.station.playback.lit import Lit
from aftdeck.station.playback.verdict import CHECKING
from aftdeck.steering.mode import MODES

_QUICK = 1
"""Compression level of the temporary file."""

_encoder = msgspec.msgpack.Encoder()
_T = TypeVar("_T")
_records = msgspec.msgpack.Decoder(tuple[FrameRecord, ...])


class PlaybackStore:
    """Recording ready for playback; close it after use."""

    def __init__(self, path: Path) -> None:
        """Read a recording to its end, or to the point where it was cut short.

        Raises:
            RecordingError: the file is not a recording, is damaged or has no step; or its frames cannot be stored.
        """
        recording = Recording(path)
        self._delays: list[tuple[int, Delays | None]] = [(0, recording.delays)]
        self._ends, self._lock = [0], Lock()
        with ExitStack() as opened:
            self._file = opened.enter_context(TemporaryFile(prefix="aftdeck-"))
            try:
                self._scenario = scenario = scenario_of(recording.opening)
                self._displays = Displays(scenario)
                self._values = curve_values(scenario)
                self._lights: list[tuple[int, Lighting]] = [(0, scenario.lighting)]
                self._index = self._read(recording)
            except RecordingError:
                raise
            except (AftdeckError, ArithmeticError, ValueError, LookupError) as error:  # a frame of impossible values
                raise RecordingError(f"{path}: cannot be played: {error}") from None
            self._opened = opened.pop_all()

    def __enter__(self) -> PlaybackStore:
        """Return the store itself."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Close the store."""
        self.close()

    def close(self) -> None:
        """Close and thereby delete the temporary file."""
        self._opened.close()

    @property
    def ticks(self) -> int:
        """Number of steps in the recording."""
        return self._index.ticks

    @property
    def blocks(self) -> int:
        """Number of blocks; each except the last has `BLOCK` frames."""
        return len(self._ends) - 1

    def index(self, verdict: Verdict, stride: int = 1) -> PlaybackIndex:
        """Return the data of the whole run.

        Args:
            verdict: result of the re-simulation.
            stride: steps from one delivered frame to the next.
        """
        return replace(self._index, verdict=verdict, stride=stride)

    def block(self, number: int) -> Block:
        """Return each step of a block as a `Moment`. May be called from any thread.

        Raises:
            IndexError: the block does not exist.
        """
        return tuple([self._moment(record) for record in self._unpack(number)])

    def lit(self, tick: int) -> Lit:
        """Return a step of the run in its light. May be called from any thread.

        Raises:
            IndexError: the step does not exist.
        """
        if not 1 <= tick <= self.ticks:
            raise IndexError(f"steps are numbered 1 to {self.ticks}, got {tick}")
        number, place = divmod(tick - 1, BLOCK)
        return Lit(self._unpack(number)[place], _at(self._lights, tick).condition)

    def moments(self, stride: int) -> Iterator[Moment]:
        """Yield every `stride`-th step of the run as a `Moment`, beginning with the first."""
        for number in range(self.blocks):
            for record in self._unpack(number):
                if (record.tick - 1) % stride == 0:
                    yield self._moment(record)

    def _read(self, recording: Recording) -> PlaybackIndex:
        opening = recording.opening
        period = opening.control_period_s
        lanes, strips, metrics = Lanes(period), Strips(self._scenario, period), RunMetrics(self._scenario)
        events: list[Event] = []
        pictures: list[Pictured] = []
        waiting: list[FrameRecord] = []
        changed: list[ChangedFrom] = []
        ticks, in_flight = 0, tuple[str, ...]()
        for message in recording.messages():
            metrics.note(message)
            if isinstance(message, Note):
                events.append(Event(message.time_s, message.kind, message.level, message.text))
            elif isinstance(message, Shown):
                monitors = message.mon_1, message.mon_2
                pictures.append(Pictured(message.time_s, monitors))
                lanes.shown(monitors)
            elif isinstance(message, LightRecord):
                self._lights.append((ticks + 1, lighting_of(message)))
            elif isinstance(message, DelayRecord):
                self._delays.append((message.tick, recording.delays))
            elif isinstance(message, FrameRecord):
                if message.mode not in MODES:
                    raise RecordingError(f"{recording.path}: step {message.tick} has the unknown mode {message.mode!r}")
                lit = lit_lamps(self._scenario, message, recording.delays)
                lanes.add(message, lit)
                strips.add(message, message.latency_ms)
                metrics.see(message, lit)
                events += message.events
                if message.changes != in_flight:
                    in_flight = message.changes
                    changed = changed or [ChangedFrom(0, changed_of(self._scenario))]
                    changed.append(ChangedFrom(message.tick, changed_of(in_force(self._scenario, in_flight))))
                ticks = message.tick
                waiting.append(message)
                if len(waiting) == BLOCK:
                    self._pack(waiting)
                    waiting = []
        if not ticks:
            raise RecordingError(f"{recording.path}: ends before its first step and cannot be played", "empty")
        if waiting:
            self._pack(waiting)
        return PlaybackIndex(
            welcome=welcome_of(self._scenario, demo=True),
            file=encodable(recording.path.name),
            began=opening.began,
            version=opening.version,
            seed=opening.seed,
            changes=opening.changes,
            participant=opening.participant,
            condition=opening.condition,
            period_s=period,
            ticks=ticks,
            stride=1,
            block=BLOCK,
            ended=recording.ended,
            verdict=CHECKING,
            events=tuple(sorted(events, key=lambda event: event.time_s)),
            lanes=lanes.lanes(),
            pictures=tuple(pictures),
            strips=strips.strips(),
            measures=(ended(recording.ended), *measures_of(metrics.found(recording.delays), REPLAY)),
            changed=tuple(changed),
        )

    def _pack(self, records: list[FrameRecord]) -> None:
        try:
            self._file.write(zlib.compress(_encoder.encode(records), _QUICK))
        except OSError as error:
            why = error.strerror or str(error)
            raise RecordingError(f"the recording's frames cannot be stored in {gettempdir()}: {why}") from None
        self._ends.append(self._file.tell())

    def _unpack(self, number: int) -> tuple[FrameRecord, ...]:
        if not 0 <= number < self.blocks:
            raise IndexError(f"blocks are numbered 0 to {self.blocks - 1}, got {number}")
        with self._lock:
            self._file.seek(self._ends[number])
            packed = self._file.read(self._ends[number + 1] - self._ends[number])
        return _records.decode(zlib.decompress(packed))

    def _moment(self, record: FrameRecord) -> Moment:
        lamps = lit_lamps(self._scenario, record, _at(self._delays, record.tick))
        return Moment(
            self._displays.frame(record, -1, lighting=_at(self._lights, record.tick), lamps=lamps),
            self._values(record, record.latency_ms),
            worst_joint(record, self._scenario),
        )


def _at(changes: Sequence[tuple[int, _T]], tick: int) -> _T:
    """Return the value in a step, from a list of changes: the step from which on a value holds, and the value."""
    return changes[bisect(changes, tick, key=lambda change: change[0]) - 1][1]
