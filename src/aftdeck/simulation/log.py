"""Log of a step, and the names of joints in it."""

from __future__ import annotations

import msgspec

from aftdeck.simulation.frame import Event, Level


class Log(msgspec.Struct, frozen=True):
    """Log of one control step: each line has the time at the end of the step."""

    events: list[Event]
    """Lines of the step so far."""
    time: float
    """Time at the end of the step, not rounded [s]."""

    def add(self, kind: str, level: Level, text: str) -> None:
        """Add a line."""
        self.events.append(Event(round(self.time, 9), kind, level, text))

    def reject(self, text: str) -> None:
        """Add the line of a rejected command, with the reason."""
        self.add("refused", "caution", text)


def joint_label(joint: str) -> str:
    """Return a joint's name in words: ``elbow pitch`` for ``elbow_pitch``."""
    return joint.replace("_", " ")
