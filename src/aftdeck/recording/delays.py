"""Delays of a run's control steps, and time that was lost."""

from __future__ import annotations

from typing import Annotated

from aftdeck.field_meta import field_meta
from aftdeck.recording.message import Message


class Delays(Message, frozen=True):
    """Delays of the control steps of a run in real time, from its beginning on."""

    late_steps: Annotated[
        int, field_meta("number of steps that began more than one control period after they were due")
    ] = 0
    worst_s: Annotated[float, field_meta("greatest delay of such a step", "s")] = 0.0
    lost_s: Annotated[
        float, field_meta("time that was not made up: by it, the simulated time is behind the wall time", "s")
    ] = 0.0
    lost_at_s: Annotated[
        float | None,
        field_meta("simulated time at which time was lost last, after the first command; null if none was", "s"),
    ] = None

    def after(self, time_s: float, late_s: float, lost_s: float, *, commanded: bool) -> Delays:
        """Return the delays including one more late step.

        Args:
            time_s: simulated time at which the step began [s].
            late_s: delay of the step [s].
            lost_s: part of this delay that is not made up [s].
            commanded: whether a command or a stick had moved the arm before. Until then a page may still be loading,
                and lost time disturbs no operator.
        """
        return Delays(
            self.late_steps + 1,
            max(self.worst_s, late_s),
            self.lost_s + lost_s,
            time_s if lost_s and commanded else self.lost_at_s,
        )

    def text(self) -> str:
        """Return the delays in words: ``0.31 s lost, 12 late steps, the worst 0.31 s``."""
        if not self.late_steps:
            return "no step was late"
        steps = "1 late step" if self.late_steps == 1 else f"{self.late_steps} late steps"
        return f"{self.lost_s:.2f} s lost, {steps}, the worst {self.worst_s:.2f} s"
