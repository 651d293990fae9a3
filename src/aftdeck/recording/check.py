"""Comparison of a recording, message by message, with the messages that its re-simulation produces."""

from __future__ import annotations

import hashlib
from collections import defaultdict, deque

import msgspec
from msgspec.structs import replace

from aftdeck.recording.apart import Apart, further
from aftdeck.recording.chain import Chain, Declared, without_head
from aftdeck.recording.channels import DECLARED, FIXED, SCENE, VIEWED
from aftdeck.recording.codec import encode
from aftdeck.recording.compare import Difference, alike, first_difference
from aftdeck.recording.convert import DIGITS, as_recorded, frame_record, input_record, inputs_of
from aftdeck.recording.reader import Entry, Recording
from aftdeck.recording.records import Closing, FrameRecord, Input, Note, Opening
from aftdeck.recording.viewing import Viewing
from aftdeck.scenario.schema import Plant
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.state import State
from aftdeck.simulation.summary import Tally
from aftdeck.state_part import declaration
from aftdeck.version import __version__

_OF_THE_OPERATOR = ("stopped", "restarted")
"""Reasons for the end of a run that the simulation does not know."""


class ChannelChange(msgspec.Struct, frozen=True):
    """Channel, other than ``/frames``, that differs from the channel that a re-simulation writes."""

    channel: str
    messages: int
    """Number of messages that differ, are missing, or are additional."""
    time_s: float
    """Simulated time of the first of them [s]."""


class Check:
    """Comparison of all messages of a recording, which `take` receives in their order.

    A file of this version must have exactly the bytes that this version writes. In a file of another version, only the
    values of frames are compared.

    Attributes:
        digests: whether digests are compared; not if the recording's version declares other fields of the state.
        strict: whether the file is of this version.
        frames: number of frames compared.
        different: number of frames that differ.
        first: difference in the first frame that differs; None if all frames are equal.
        apart: greatest differences of lengths and angles; None if all frames are equal.
        head: head of the hash chain over the messages taken.
        stated: head in the footer; empty before the footer, and in a file of an earlier version.
        topics: channels with at least one message.
    """

    def __init__(self, recording: Recording, sim: Simulation) -> None:
        opening = recording.opening
        self.digests = opening.digests == declaration(State)
        self.strict = opening.version == __version__
        self.frames = self.different = 0
        self.first: Difference | None = None
        self.apart: Apart | None = None
        self.head = self.stated = ""
        self.topics: dict[str, None] = {}
        self._recording, self._sim = recording, sim
        self._chain, self._tally, self._frames = Chain(), Tally(), hashlib.sha256()
        self._changes: dict[str, ChannelChange] = {}
        self._due: defaultdict[str, deque[tuple[bytes, int]]] = defaultdict(deque)
        self._view: Viewing | None = None
        self._began = self._now = 0

    def take(self, entry: Entry) -> None:
        """Compare a message; an input advances the simulation.

        Raises:
            AftdeckError: the simulation rejects the inputs, or fails.
        """
        topic, message = entry.channel.topic, entry.message
        self.topics[topic] = None
        data = without_head(entry.data, message.chain) if isinstance(message, Closing) else entry.data
        self._chain.add(entry.channel, entry.log_time, entry.publish_time, data)
        if isinstance(message, Opening):
            self._began = self._now = entry.log_time
            if self.strict and message.viewed:
                self._view = Viewing(self._expect, self._sim.scenario, self._began)
                self._view.open()
        elif isinstance(message, Input):
            self._sim.advance(inputs_of(message))
            self._now = self._began + round(self._sim.look().time_s * 1e9)
            if self.strict:
                self._expect(topic, encode(input_record(message.tick, inputs_of(message))), self._now)
        elif isinstance(message, FrameRecord):
            self._frame(message, entry)
        elif isinstance(message, Note) and self._view is not None:
            self._view.line(message, self._now)
        elif isinstance(message, Closing):
            self._close(message)
        if self.strict:
            self._compare(entry)

    @property
    def plant(self) -> Plant:
        """Plant of the run."""
        return self._sim.scenario.plant

    def changes(self) -> tuple[ChannelChange, ...]:
        """Return the channels that differ, after the last message."""
        if not self._recording.cut:
            for topic, due in self._due.items():
                for _ in due:
                    self._change(topic)
        return tuple(self._changes.values())

    def recomputed(self) -> tuple[str, ...]:
        """Return the channels whose messages were computed again and compared."""
        ours = ("/frames", "/closing", *VIEWED) if self.strict else ("/frames",)
        return tuple(topic for topic in self.topics if topic in ours)

    def _frame(self, record: FrameRecord, entry: Entry) -> None:
        """Compare a frame with the simulation's; its wall time and latency are not the simulation's."""
        frame = self._sim.look()
        digest = self._sim.seal()
        self._frames.update(digest)
        self._sim.add_to(self._tally)
        self.frames += 1
        if self._view is not None:
            self._view.frame(frame)
        equal = not self.digests or digest.hex()[:DIGITS] == record.sha256
        if equal and self.strict and self.digests:
            expected = encode(frame_record(frame, record.wall_s, record.latency_ms))
            equal = entry.data == expected or _same(entry.data, expected)
            if equal:
                return
        computed = as_recorded(frame)
        logged = _logged(record, self.strict) == _logged(computed, self.strict)
        if equal and not (self.strict and self.digests) and alike(record, computed) and logged:
            return
        self.different += 1
        self.first = self.first or first_difference(record, computed, events=not logged)
        self.apart = further(self.apart, record, computed)

    def _close(self, closing: Closing) -> None:
        """Compare the footer; reasons for the end that only the operator knows are not the simulation's."""
        self.stated, self.head = closing.chain, self._chain.head()
        ended, summary, frames = closing.ended, closing.summary, closing.frames_sha256
        if ended not in _OF_THE_OPERATOR:
            ended = self._sim.ended or "completed"
        if summary and self.frames:
            text = self._tally.summary(
                self._sim.scenario, self._sim.seed, self._sim.ended or "completed", self._sim.look()
            )
            if not self.digests:  # the digest of the frames' digests, which are not compared
                text = replace(text, frames_sha256=frames)
            summary = msgspec.json.encode(text).decode()
        if self.digests:
            frames = self._frames.hexdigest()
        expected = replace(closing, ended=ended, ticks=self.frames, frames_sha256=frames, delays=self._recording.delays)
        if self.strict:
            self._expect("/closing", encode(replace(expected, summary=summary)), self._now)
        elif closing != expected:
            self._change("/closing")

    def _expect(self, topic: str, data: bytes, time_ns: int) -> None:
        self._due[topic].append((data, time_ns))

    def _compare(self, entry: Entry) -> None:
        """Compare a message with the next one that is expected in its channel, and the channel's declaration.

        Frames are compared elsewhere. Of channels whose messages cannot be computed, only the times are compared.
        """
        topic = entry.channel.topic
        due = self._due[topic]
        if topic in (FIXED, SCENE) and not due and self._view is not None:  # a viewer subscribed during the run
            self._view.send_topic(topic, self._now)
        if topic in VIEWED or topic in ("/inputs", "/closing"):
            data, time_ns = due.popleft() if due else (b"", 0)
        else:
            data, time_ns = entry.data, self._now
        same = data == entry.data or (topic not in VIEWED and _same(entry.data, data, defaults=topic == "/closing"))
        if not (same and _known(entry.channel) and entry.log_time == entry.publish_time == time_ns):
            self._change(topic)

    def _change(self, topic: str) -> None:
        found = self._changes.get(topic) or ChannelChange(topic, 0, self._recording.time_s)
        self._changes[topic] = replace(found, messages=found.messages + 1)


def _logged(record: FrameRecord, wording: bool) -> list[tuple[float, str, str, str]]:
    """Return the log lines of a frame; without `wording`, with empty texts: versions may word them differently."""
    return [(event.time_s, event.kind, event.level, event.text if wording else "") for event in record.events]


def _known(channel: Declared) -> bool:
    """Return whether a channel is declared as this version declares it.

    The schemas of Aftdeck's own channels may differ: they only describe messages that can be read without them, and
    another state of this version may have other descriptions or additional fields.
    """
    own = DECLARED.get(channel.topic, channel)
    return channel == own or (own.encoding == "json" and channel._replace(schema_data=own.schema_data) == own)


def _same(data: bytes, expected: bytes, *, defaults: bool = False) -> bool:
    """Return whether two JSON texts have equal values: a number may be written as ``40`` or as ``40.0``.

    With `defaults`, `data` may lack fields: an earlier state of this version did not write them.
    """
    try:
        found, ours = msgspec.json.decode(data, type=dict), msgspec.json.decode(expected, type=dict)
        return bool(({**ours, **found} if defaults else found) == ours)
    except (msgspec.MsgspecError, RecursionError):
        return False
