"""Lanes of a playback or a live run: intervals of phase, mode, monitors, alarms and limits."""

from __future__ import annotations

from aftdeck.report.curves import Lane, Stretch
from aftdeck.report.lamps import Lamp
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.payloads.task_phases import TASKS
from aftdeck.worksite.watch.alarm import Level

MONITORS = ("MON 1", "MON 2")


class Lanes:
    """Phase, mode, monitors, alarms and limits of a run, collected frame by frame.

    Attributes:
        starts: number of intervals that have started, in all lanes together.
    """

    def __init__(self, period_s: float) -> None:
        self._period_s = period_s
        self._lanes: dict[str, list[tuple[int, str, Level]]] = {
            "Phase": [],
            "Mode": [],
            **{name: [] for name in MONITORS},
            "Alarms": [],
            "Limits": [],
        }
        self._ticks = self.starts = 0
        self._shown: tuple[tuple[str, ...], ...] = ((), ())
        self._seen: tuple[object, ...] = ()

    def shown(self, monitors: tuple[tuple[str, ...], ...]) -> None:
        """Set the cameras that the monitors show from the next frame on."""
        self._shown = monitors

    def add(self, frame: Frame, lamps: tuple[Lamp, ...]) -> None:
        """Add the next frame and the lamps lit in it."""
        self._ticks, ticks = frame.tick, self._ticks
        seen, self._seen = self._seen, (phase_of(frame), frame.mode, self._shown, lamps, frame.limits)
        if seen != self._seen:
            self._change(frame, lamps, ticks)

    def _change(self, frame: Frame, lamps: tuple[Lamp, ...], tick: int) -> None:
        """Add the intervals that begin with a frame; `tick` is the number of the step before it."""
        alarms = {lamp.name: lamp.level for lamp in lamps if lamp.level != "info"}
        worst: Level = "warning" if "warning" in alarms.values() else "caution" if alarms else "info"
        self._put(tick, "Phase", phase_of(frame), "info")
        self._put(tick, "Mode", frame.mode, "info")
        for name, cameras in zip(MONITORS, self._shown, strict=True):
            self._put(tick, name, " | ".join(cameras), "info")
        self._put(tick, "Alarms", " · ".join(alarms), worst)
        self._put(tick, "Limits", " · ".join(sorted({limit.kind for limit in frame.limits})), "info")

    def _put(self, tick: int, lane: str, label: str, level: Level) -> None:
        stretches = self._lanes[lane]
        if not stretches or stretches[-1][1] != label or stretches[-1][2] != level:
            stretches.append((tick, label, level))
            self.starts += 1

    def forget(self, before: int) -> None:
        """Delete the intervals that ended before the step with the number `before`."""
        for stretches in self._lanes.values():
            while len(stretches) > 1 and stretches[1][0] < before:
                del stretches[0]

    def lanes(self) -> tuple[Lane, ...]:
        """Return the lanes, each with consecutive intervals up to the last frame.

        The first interval of a lane begins at time zero, or later if `forget` has deleted intervals. A phase or monitor
        lane without labels is omitted.
        """
        return tuple(
            Lane(name, self._stretches(stretches))
            for name, stretches in self._lanes.items()
            if name not in ("Phase", *MONITORS) or any(label for _, label, _ in stretches)
        )

    def _stretches(self, stretches: list[tuple[int, str, Level]]) -> tuple[Stretch, ...]:
        ends = [*(start for start, _, _ in stretches[1:]), self._ticks]
        return tuple(
            Stretch(self._seconds(start), self._seconds(end), label, level)
            for (start, label, level), end in zip(stretches, ends, strict=True)
        )

    def _seconds(self, ticks: int) -> float:
        return round(ticks * self._period_s, 9)


def phase_of(frame: Frame) -> str:
    """Return the name of the script's phase; if there is none, the name of the task phase (``extraction``).

    Returns:
        The name; "" if the frame has neither a script phase nor payloads.
    """
    return frame.phase or (TASKS[frame.work.task] if frame.work.cargo else "")
