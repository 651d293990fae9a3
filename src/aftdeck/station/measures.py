"""A replay's figures of the whole run."""

from __future__ import annotations

import math

from aftdeck.recording.records import ControllerRecord
from aftdeck.simulation.frame import Frame
from aftdeck.station.playback import Measure, Quantity
from aftdeck.station.protocol import Lamp
from aftdeck.station.strips import worst_rate

_MINUTE = 60.0


class Measures:
    """Figures collected frame by frame."""

    def __init__(self, period_s: float) -> None:
        self._period_s = period_s
        self._last: Frame | None = None
        self._lit: frozenset[str] = frozenset()
        self._signs = [0] * 6
        self._ticks = self._by_hand = self._vernier = 0
        self._deflected = self._both_hands = self._several_axes = 0
        self._reversals = self._alarms = 0
        self._path = self._fastest = self._worst = 0.0
        self._used: dict[str, ControllerRecord] = {}

    def add(self, frame: Frame, lamps: tuple[Lamp, ...]) -> None:
        """The next frame and the lamps lit in it."""
        if self._last is not None:
            self._path += math.dist(frame.position, self._last.position)
        self._last = frame
        self._ticks += 1
        self._by_hand += frame.by == "hand"
        self._vernier += frame.rate == "vernier"
        self._fastest = max(self._fastest, math.hypot(*frame.twist[3:]))
        self._worst = max(self._worst, worst_rate(frame.rates_commanded, frame.rate_limits)[0])
        lit = frozenset(lamp.name for lamp in lamps if lamp.level != "info")
        self._alarms += len(lit - self._lit)
        self._lit = lit
        self._sticks(frame)

    def use(self, controllers: tuple[ControllerRecord, ...]) -> None:
        """What moves the sticks from here on."""
        self._used |= {used.kind: used for used in controllers}

    def _sticks(self, frame: Frame) -> None:
        axes = (*frame.translation, *frame.rotation)
        self._deflected += any(axes)
        self._both_hands += any(frame.translation) and any(frame.rotation)
        self._several_axes += sum(axis != 0 for axis in axes) > 1
        for i, axis in enumerate(axes):
            sign = (axis > 0) - (axis < 0)
            if sign:
                self._reversals += sign == -self._signs[i]
                self._signs[i] = sign

    def measures(self, ended: str) -> tuple[Measure, ...]:
        """All figures, those of a target only where the run ended with one."""
        frame = self._last
        assert frame is not None, "a recording without a frame is refused before"
        duration = self._ticks * self._period_s
        figures = [
            Measure("Run time", "time", duration, "", "Simulated time that the recording holds."),
            Measure("Ended", "words", None, ended or "cut short", "How the run ended."),
            _figure("Flown by hand", "share", self._by_hand / self._ticks, "Part of the time that no script flew."),
        ]
        if self._used:
            about = "; ".join(_told(used) for used in self._used.values())
            figures.append(Measure("Controllers", "words", None, ", ".join(self._used), f"As used last: {about}."))
        if frame.goal is not None:
            figures += [
                _figure("Distance left", "length", frame.goal.distance, "From the tip to the target, at the end."),
                _figure("Angle left", "angle", frame.goal.angle, "From the tip's attitude to the target's."),
            ]
        moved = max(self._deflected, 1)
        return (
            *figures,
            _figure("Tip path", "distance", self._path, "Way of the tip through space."),
            _figure("Greatest POR speed", "speed", self._fastest, "Of the point of resolution, as it moved."),
            _figure(
                "Worst joint rate", "part of limit", self._worst, "Largest commanded joint rate of the limit in force."
            ),
            _figure("Time in vernier", "time", self._vernier * self._period_s, "With the rate switch at VERNIER."),
            _figure("Two-handed share", "share", self._both_hands / moved, "Of the time with a stick off its middle."),
            _figure(
                "Multi-axis share", "share", self._several_axes / moved, "Of the time with a stick off its middle."
            ),
            _figure(
                "Reversals a minute",
                "count",
                self._reversals / duration * _MINUTE,
                "Times that a stick's axis went over to its other side.",
            ),
            _figure("Alarms raised", "count", float(self._alarms), "Times that a caution lamp came on."),
        )


def _figure(name: str, quantity: Quantity, value: float, about: str) -> Measure:
    return Measure(name, quantity, value, "", about)


def _told(used: ControllerRecord) -> str:
    """A controller and how it was set: ``Test pad, deadband 8 %, expo 0.3``; keys have neither."""
    set_to = "" if used.kind == "keyboard" else f", deadband {used.deadband:.0%}, expo {used.expo:g}".replace("%", " %")
    return f"{used.name}{set_to}"
