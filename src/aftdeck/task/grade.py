"""Grade of a run after its task: each of three kinds of faults lowers it by one."""

from __future__ import annotations

from typing import Literal, get_args

from aftdeck.simulation.frame import AT_HARD, Frame

Grade = Literal["A", "B", "C", "D"]
_GRADES: tuple[Grade, ...] = get_args(Grade)


class Faults:
    """Faults of a run, collected frame by frame. What the first frame has already is no fault: the arm in its cradle.

    Attributes:
        contacts: number of times that a contact began to inhibit the arm.
        warnings: number of times that the minimum clearance fell below the threshold of a warning.
        stops: number of times that a joint reached a hard stop.
    """

    def __init__(self) -> None:
        self.contacts = self.warnings = self.stops = 0
        self._before: tuple[bool, bool, bool] | None = None

    def see(self, frame: Frame) -> None:
        """Add the next frame."""
        now = frame.work.arm_inhibit, frame.work.clearance_level == "warning", AT_HARD in frame.zones
        before = now if self._before is None else self._before
        self.contacts += now[0] and not before[0]
        self.warnings += now[1] and not before[1]
        self.stops += now[2] and not before[2]
        self._before = now

    def texts(self) -> tuple[str, ...]:
        """Return each kind of fault as a text for the operator."""
        kinds = (
            (self.contacts, "contact that inhibited the arm", "contacts that inhibited the arm"),
            (self.warnings, "warning by CLEARANCE", "warnings by CLEARANCE"),
            (self.stops, "joint at its hard stop", "joints at their hard stops"),
        )
        return tuple(f"{count} {one if count == 1 else more}" for count, one, more in kinds if count)


def grade(faults: tuple[str, ...]) -> Grade:
    """Return the grade of a run with these kinds of faults: A without faults, then one lower for each kind."""
    return _GRADES[min(len(faults), len(_GRADES) - 1)]
