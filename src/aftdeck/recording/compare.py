"""What differs between two frames, and between two runs of the same inputs."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator

import msgspec

from aftdeck.recording.records import FrameRecord
from aftdeck.recording.resample import SAME_TIME

_NOT_FLOWN = {"wall_s", "latency_ms", "sha256", "tick", "events"}
"""Fields that say nothing of the flight's state; events are compared apart."""


class FieldChange(msgspec.Struct, frozen=True):
    """A field that differs."""

    field: str
    before: str
    after: str


class Difference(msgspec.Struct, frozen=True):
    """How one frame differs from another."""

    time_s: float
    tick: int
    fields: tuple[FieldChange, ...]
    """Empty: they differ beyond the recorded decimals only."""


class Greatest(msgspec.Struct, frozen=True):
    """The greatest difference of a quantity, and when it was."""

    value: float
    time_s: float


class EventChange(msgspec.Struct, frozen=True):
    """A line of the log that only one run has, or has at another time."""

    text: str
    before_s: float | None
    after_s: float | None


def first_difference(before: FrameRecord, after: FrameRecord) -> Difference:
    """The fields in which two frames differ, as far as they are recorded."""
    return Difference(before.time_s, before.tick, tuple(_changes(before, after)))


def alike(before: FrameRecord, after: FrameRecord) -> bool:
    """Whether two frames say the same of the flight, as far as they are recorded."""
    return next(_changes(before, after), None) is None


def _changes(before: FrameRecord, after: FrameRecord) -> Iterator[FieldChange]:
    for name in FrameRecord.__struct_fields__:
        old, new = getattr(before, name), getattr(after, name)
        if old != new and name not in _NOT_FLOWN:
            yield FieldChange(name, _shown(old), _shown(new))


def _shown(value: object) -> str:
    return msgspec.json.encode(value).decode()


class Comparison:
    """Gathers how a run departs from another, frame by frame at equal times.

    Attributes:
        first: the first difference.
        tip: greatest distance between the tips [m].
        joint: greatest difference of a joint's angle [rad].
        joint_name: of that joint.
        tip_at_end: distance between the tips at the last time that both have [m].
        compared: frames compared.
    """

    def __init__(self, joints: tuple[str, ...]) -> None:
        self._joints = joints
        self.first: Difference | None = None
        self.tip = self.joint = Greatest(0.0, 0.0)
        self.joint_name = ""
        self.tip_at_end = 0.0
        self.compared = 0
        self._before: list[tuple[str, float]] = []
        self._after: list[tuple[str, float]] = []

    def follow(self, before: Iterator[FrameRecord], after: Iterator[FrameRecord]) -> None:
        """Compare two runs to their ends, frame by frame where their times are equal."""
        old, new = next(before, None), next(after, None)
        while old is not None or new is not None:
            if new is None or (old is not None and old.time_s < new.time_s - SAME_TIME):
                self._note(old, None)
                old = next(before, None)
            elif old is None or new.time_s < old.time_s - SAME_TIME:
                self._note(None, new)
                new = next(after, None)
            else:
                self._note(old, new)
                self._add(old, new)
                old, new = next(before, None), next(after, None)

    def _add(self, before: FrameRecord, after: FrameRecord) -> None:
        """Compare two frames of the same time."""
        self.compared += 1
        if self.first is None and not alike(before, after):
            self.first = first_difference(before, after)
        self.tip_at_end = math.dist(before.position, after.position)
        if self.tip_at_end > self.tip.value:
            self.tip = Greatest(self.tip_at_end, before.time_s)
        apart = [abs(a - b) for a, b in zip(before.angles, after.angles, strict=True)]
        if max(apart) > self.joint.value:
            self.joint = Greatest(max(apart), before.time_s)
            self.joint_name = self._joints[apart.index(max(apart))]

    def _note(self, before: FrameRecord | None, after: FrameRecord | None) -> None:
        """Remember the log's lines of a frame of each run."""
        if before is not None:
            self._before += [(event.text, event.time_s) for event in before.events]
        if after is not None:
            self._after += [(event.text, event.time_s) for event in after.events]

    @property
    def events(self) -> tuple[EventChange, ...]:
        """Lines that only one of the runs has, or that came at another time; the n-th of a text meets the n-th."""
        before, after = _numbered(self._before), _numbered(self._after)
        changes = [
            EventChange(text, before.get((text, n)), after.get((text, n)))
            for text, n in {**before, **after}
            if before.get((text, n)) != after.get((text, n))
        ]
        return tuple(sorted(changes, key=_when))


def _when(change: EventChange) -> float:
    return min(t for t in (change.before_s, change.after_s) if t is not None)


def _numbered(lines: list[tuple[str, float]]) -> dict[tuple[str, int], float]:
    seen: Counter[str] = Counter()
    numbered = {}
    for text, time in lines:
        seen[text] += 1
        numbered[text, seen[text]] = time
    return numbered
