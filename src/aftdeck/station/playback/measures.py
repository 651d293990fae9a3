"""Figures of a whole recorded run, for playback."""

from __future__ import annotations

import math

from aftdeck.recording.records import ControllerRecord
from aftdeck.simulation.frame import Frame
from aftdeck.station.messages.curves import Quantity
from aftdeck.station.messages.frame import Lamp
from aftdeck.station.messages.playback import Measure
from aftdeck.station.playback.captured import CaptureMisalignment, capture_misalignment
from aftdeck.station.playback.strips import worst_rate
from aftdeck.worksite.watch.alarm import Level

_MINUTE = 60.0
_AXES = ("X", "Y", "Z", "roll", "pitch", "yaw")
_RANK: dict[Level, int] = {"info": 0, "caution": 1, "warning": 2}


class RunMetrics:
    """Figures of a run, collected frame by frame."""

    def __init__(self, period_s: float) -> None:
        self._period_s = period_s
        self._last: Frame | None = None
        self._lit: dict[str, Level] = {}
        self._signs = [0] * 6
        self._ticks = self._by_hand = self._vernier = 0
        self._deflected = self._both_hands = self._several_axes = 0
        self._reversals = [0] * 6
        self._alarms = 0
        self._worst_clearance: Level = "info"
        self._worst_lamp: Level = "info"
        self._path = self._fastest = self._worst = 0.0
        self._used: dict[str, ControllerRecord] = {}
        self._nearest: tuple[float, str, float] | None = None
        self._captures = 0
        self._captured = CaptureMisalignment()
        self._brakes = self._cameras = 0
        self._monitors: dict[int, tuple[str, ...]] = {}

    def add(self, frame: Frame, lamps: tuple[Lamp, ...]) -> None:
        """Add the next frame and the lamps lit in it."""
        if self._last is not None:
            self._path += math.dist(frame.position, self._last.position)
            self._capture(self._last, frame)
        self._brakes += frame.brakes and not (self._last and self._last.brakes)
        self._near(frame)
        self._last = frame
        self._ticks += 1
        self._by_hand += frame.by == "hand"
        self._vernier += frame.rate == "vernier"
        self._fastest = max(self._fastest, math.hypot(*frame.twist[3:]))
        self._worst = max(self._worst, worst_rate(frame.rates_commanded, frame.rate_limits)[0])
        lit: dict[str, Level] = {lamp.name: lamp.level for lamp in lamps}
        self._worst_lamp = _worse(self._worst_lamp, *lit.values())
        self._worst_clearance = _worse(self._worst_clearance, frame.work.clearance_level)
        self._alarms += sum(_RANK[level] > _RANK[self._lit.get(name, "info")] for name, level in lit.items())
        self._lit = lit
        self._sticks(frame)

    def use(self, controllers: tuple[ControllerRecord, ...]) -> None:
        """Add the controllers that move the sticks from now on."""
        self._used |= {used.kind: used for used in controllers}

    def shown(self, monitors: tuple[tuple[str, ...], ...]) -> None:
        """Set the cameras that the monitors show from the next frame on, and count the changes."""
        for monitor, names in enumerate(monitors):
            if not names:  # the page has left, or does not report its cameras
                continue
            self._cameras += names != self._monitors.get(monitor, names)
            self._monitors[monitor] = names

    def _near(self, frame: Frame) -> None:
        near = frame.work.nearest
        if near is not None and (self._nearest is None or near.clearance < self._nearest[0]):
            self._nearest = near.clearance, f"{near.a} to {near.b}", frame.time_s

    def _capture(self, before: Frame, frame: Frame) -> None:
        """Count captures, and keep the misalignment of the last one, from the step before it."""
        for was, now in zip(before.work.cargo, frame.work.cargo, strict=True):
            if now.held and not was.held:
                self._captures += 1
                self._captured = capture_misalignment(before, was)

    def _sticks(self, frame: Frame) -> None:
        axes = (*frame.translation, *frame.rotation)
        self._deflected += any(axes)
        self._both_hands += any(frame.translation) and any(frame.rotation)
        self._several_axes += sum(axis != 0 for axis in axes) > 1
        for i, axis in enumerate(axes):
            sign = (axis > 0) - (axis < 0)
            if sign:
                self._reversals[i] += sign == -self._signs[i]
                self._signs[i] = sign

    def measures(self, ended: str) -> tuple[Measure, ...]:
        """Return all figures that the run has data for.

        Figures of a target, for example, are included only if the run ended with one. `ended` says how the run ended;
        it is empty for a recording that was cut short.
        """
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
            about = "From the tip to the target and between their attitudes, at the end."
            figures.append(Measure("Left to target", "length", frame.goal.distance, "", about, frame.goal.angle))
        if self._nearest is not None:
            least, pair, when = self._nearest
            about = f"Of all watched pairs, but those that come together as the task needs it: {pair}, at {when:.1f} s."
            figures.append(Measure("Smallest clearance", "gap", least, "", about, level=self._worst_clearance))
        if self._captures:
            figures += self._capture_figures()
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
                sum(self._reversals) / duration * _MINUTE,
                "Times that a stick's axis went over to its other side.",
            ),
            self._worst_axis(),
            Measure(
                "Alarms raised",
                "count",
                float(self._alarms),
                "",
                "Times that a lamp came on to caution or to warn, or rose from the one to the other.",
                level=self._worst_lamp,
            ),
            _figure("Brakes used", "count", float(self._brakes), "Times that the brakes were put on."),
            *self._camera_figures(),
        )

    def _worst_axis(self) -> Measure:
        most = max(self._reversals)
        which = f"{_AXES[self._reversals.index(most)]}, {most}" if most else "none"
        return Measure(
            "Reversals, worst axis", "words", None, which, "Of a stick's axes, in the control frame of the mode."
        )

    def _capture_figures(self) -> list[Measure]:
        which = "" if self._captures == 1 else f" The last of {self._captures} captures."
        offset, angle, rate = self._captured
        figures = []
        if offset is not None:
            about = f"What the hand was off, in the step before it held.{which}"
            figures.append(Measure("Capture misalignment", "gap", offset, "", about, angle))
        about = f"Of the tip against the payload, in the step before the hand held it.{which}"
        return [*figures, _figure("Rate at capture", "speed", rate, about)]

    def _camera_figures(self) -> list[Measure]:
        """Return the count of camera changes, if a page reported what its monitors showed."""
        if not self._monitors:
            return []
        about = "Times that a monitor was given another camera, or split."
        return [_figure("Camera changes", "count", float(self._cameras), about)]


def _figure(name: str, quantity: Quantity, value: float, about: str) -> Measure:
    return Measure(name, quantity, value, "", about)


def _worse(*levels: Level) -> Level:
    return max(levels, key=lambda level: _RANK[level])


def _told(used: ControllerRecord) -> str:
    """Return a controller's name and settings: ``Test pad, deadband 8 %, expo 0.3``. A keyboard has no settings."""
    set_to = "" if used.kind == "keyboard" else f", deadband {used.deadband:.0%}, expo {used.expo:g}".replace("%", " %")
    return f"{used.name}{set_to}"
