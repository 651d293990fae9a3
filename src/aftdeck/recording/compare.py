"""Differences between two frames, and between two runs."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from typing import Any

import msgspec

from aftdeck.recording.records import FrameRecord
from aftdeck.recording.resample import SAME_TIME
from aftdeck.tuples import Vec3

_NOT_COMPARED = {"wall_s", "latency_ms", "sha256", "tick", "events", "motions"}
"""Fields that are not compared value by value: equal runs may differ in them. Events are compared separately; files of
earlier versions lack `motions`, which follow from the state."""


class FieldChange(msgspec.Struct, frozen=True):
    """Value that differs, of a frame or of an environment; before and after, as JSON or as text.

    In a frame, `field` is the place of a single number, text or truth value, such as ``dynamics.torques[2]``. It is the
    place of a list or an object if only one frame has it, or if the lists differ in length.
    """

    field: str
    before: str
    after: str


class Difference(msgspec.Struct, frozen=True):
    """Difference between two frames."""

    time_s: float
    tick: int
    fields: tuple[FieldChange, ...]
    """Values that differ; empty if the frames differ only in decimals that are not recorded, or as text."""


class Greatest(msgspec.Struct, frozen=True):
    """Greatest difference of a quantity, and the simulated time at which it occurs."""

    value: float
    time_s: float


class EventChange(msgspec.Struct, frozen=True):
    """Log line whose time differs between two runs; a time is None if the run does not have the line."""

    text: str
    before_s: float | None
    after_s: float | None


def first_difference(before: FrameRecord, after: FrameRecord, *, events: bool = False) -> Difference:
    """Return the recorded values in which two frames differ, with their log lines if `events`."""
    fields = list(_changes(before, after))
    if events:
        fields.append(FieldChange("events", _shown(before.events), _shown(after.events)))
    return Difference(before.time_s, before.tick, tuple(fields))


def alike(before: FrameRecord, after: FrameRecord) -> bool:
    """Return whether two frames are equal in all compared fields."""
    return next(_changes(before, after), None) is None


def _changes(before: FrameRecord, after: FrameRecord) -> Iterator[FieldChange]:
    for name in FrameRecord.__struct_fields__:
        if name not in _NOT_COMPARED:
            yield from _values(name, getattr(before, name), getattr(after, name))


def _values(place: str, old: Any, new: Any) -> Iterator[FieldChange]:
    """Yield the differing values of two objects, lists or single values."""
    if old == new:
        return
    parts = _parts(old)
    if not parts or parts != _parts(new):
        yield FieldChange(place, _shown(old), _shown(new))
        return
    for part in parts:
        if isinstance(part, str):
            yield from _values(f"{place}.{part}", getattr(old, part), getattr(new, part))
        else:
            yield from _values(f"{place}[{part}]", old[part], new[part])


def _parts(value: object) -> tuple[str, ...] | range:
    """Return the names of an object's fields, or the indices of a list; empty for a single value."""
    if isinstance(value, msgspec.Struct):
        return value.__struct_fields__
    if isinstance(value, tuple):
        return getattr(value, "_fields", range(len(value)))
    return ()


def true_tip(frame: FrameRecord) -> Vec3:
    """Return the true position of the tip in L [m]; without masses, the encoders measure it."""
    return frame.position if frame.dynamics is None else frame.dynamics.position


def _shown(value: object) -> str:
    return msgspec.json.encode(value).decode()


class Comparison:
    """Comparison of a run with another, frame by frame at equal times.

    Attributes:
        first: first difference; None if all compared frames are equal.
        tip: greatest distance between the true positions of the tips [m].
        joint: greatest difference of a joint angle [rad].
        joint_name: name of that joint; empty if no angle differs.
        tip_at_end: distance between these positions at the last time at which both runs have a frame [m].
        compared: number of compared pairs of frames.
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
        self.tip_at_end = math.dist(true_tip(before), true_tip(after))
        if self.tip_at_end > self.tip.value:
            self.tip = Greatest(self.tip_at_end, before.time_s)
        differences = [abs(a - b) for a, b in zip(before.angles, after.angles, strict=True)]
        if max(differences) > self.joint.value:
            self.joint = Greatest(max(differences), before.time_s)
            self.joint_name = self._joints[differences.index(max(differences))]

    def _note(self, before: FrameRecord | None, after: FrameRecord | None) -> None:
        """Store the log lines of two frames; a frame is None if its run has no frame at this time."""
        if before is not None:
            self._before += [(event.text, event.time_s) for event in before.events]
        if after is not None:
            self._after += [(event.text, event.time_s) for event in after.events]

    @property
    def events(self) -> tuple[EventChange, ...]:
        """Log lines that only one run has, or whose times differ.

        The n-th line with a text in one run is compared with the n-th line with the same text in the other run.
        """
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
