"""Content of a recording: the messages of a run in their order, each added to the hash chain.

The content has no thread, clock or file. Who records gives the times, and keeps or writes the messages.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from typing import Literal, NamedTuple, Protocol

import msgspec

from aftdeck.recording.chain import Chain, Declared
from aftdeck.recording.codec import encode
from aftdeck.recording.convert import frame_record, input_record
from aftdeck.recording.declared import Log
from aftdeck.recording.delays import Delays
from aftdeck.recording.records import (
    CHANNELS,
    Closing,
    ControllersRecord,
    DelayRecord,
    LightRecord,
    Note,
    Opening,
    Shown,
)
from aftdeck.simulation.frame import Event, Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.summary import Summary

Ended = Literal["completed", "time", "fault", "stopped", "restarted"]
"""Reason for the end of a run."""


class Recorded(NamedTuple):
    """Control step to be recorded.

    Attributes:
        inputs: its inputs; None if the script supplied them.
        frame: its frame.
        wall_s: wall time since the run began [s].
        latency_ms: latency that the page displays [ms]; None if not measured.
    """

    inputs: Inputs | None
    frame: Frame
    wall_s: float
    latency_ms: float | None


_Ready = ControllersRecord | Shown | LightRecord | DelayRecord
"""Messages in their final form that no viewer uses."""
Entry = Recorded | Note | _Ready
"""What is recorded between the opening and the closing."""

_TOPIC = {kind: topic for topic, (kind, _) in CHANNELS.items()}


class Viewer(Protocol):
    """Writer of further messages, for viewers, from the same run."""

    def frame(self, frame: Frame) -> None:
        """Write the messages about a frame."""

    def line(self, event: Event, time_ns: int) -> None:
        """Write a line of the log."""


class Content:
    """Content of the recording of one run.

    Attributes:
        viewer: writer of further messages; None: there are none.
        ticks: number of the last step.
        time_s: simulated time of the last step [s].
        delays: delays of the steps so far; None if the run is not in real time.
        head: head of the hash chain; empty before `close`.
    """

    def __init__(self, log: Log, declared: Mapping[str, Declared], start: Opening, began_ns: int) -> None:
        """Begin with the opening.

        Args:
            log: writes a message.
            declared: declaration of each channel.
            start: header of the recording.
            began_ns: wall time at which the run began, since 1970 [ns].
        """
        self.viewer: Viewer | None = None
        self.ticks, self.time_s, self.head = 0, 0.0, ""
        self.delays: Delays | None = Delays() if start.real_time else None
        self._out, self._declared, self._began_ns = log, declared, began_ns
        self._now = began_ns
        self._chain, self._frames = Chain(), hashlib.sha256()
        self.log("/opening", encode(start), began_ns)

    def log(self, topic: str, data: bytes, time_ns: int) -> None:
        """Write a message, and add it to the chain."""
        self._out(topic, data, time_ns)
        self._chain.add(self._declared[topic], time_ns, time_ns, data)

    def add(self, entry: Entry) -> None:
        """Write the messages of an entry."""
        if isinstance(entry, Recorded):
            frame = entry.frame
            self._frames.update(bytes.fromhex(frame.sha256))
            self.ticks, self.time_s = frame.tick, frame.time_s
            self._now = self._began_ns + round(frame.time_s * 1e9)
            self.log("/inputs", encode(input_record(frame.tick, entry.inputs)), self._now)
            self.log("/frames", encode(frame_record(frame, entry.wall_s, entry.latency_ms)), self._now)
            if self.viewer is not None:
                self.viewer.frame(frame)
            return
        self.log(_TOPIC[type(entry)], encode(entry), self._now)
        if isinstance(entry, Note) and self.viewer is not None:
            self.viewer.line(entry, self._now)
        if isinstance(entry, DelayRecord) and self.delays is not None:
            self.delays = self.delays.after(entry.time_s, entry.late_s, entry.lost_s, commanded=entry.commanded)

    def close(self, ended: Ended, summary: Summary | None) -> None:
        """Write the closing; `summary`: that of a scripted run."""
        text = msgspec.json.encode(summary).decode() if summary else ""
        closing = Closing(ended, self.ticks, self._frames.hexdigest(), text, delays=self.delays)
        self._chain.add(self._declared["/closing"], self._now, self._now, encode(closing))
        self.head = self._chain.head()
        self._out("/closing", encode(msgspec.structs.replace(closing, chain=self.head)), self._now)
