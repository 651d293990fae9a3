"""Values that summarise a whole recorded run, for playback."""

from __future__ import annotations

import math

from aftdeck.recording.delays import Delays
from aftdeck.recording.records import ControllerRecord
from aftdeck.simulation.frame import Frame
from aftdeck.station.lamps import Lamp
from aftdeck.station.messages.curves import Quantity
from aftdeck.station.messages.measure import Measure
from aftdeck.station.playback.captured import CaptureMisalignment, capture_misalignment
from aftdeck.station.playback.strips import worst_rate
from aftdeck.worksite.watch.alarm import Level

RUN_TIME, TIP_PATH, ALARMS_RAISED = "Run time", "Tip path", "Alarms raised"
CAPTURE_MISALIGNMENT, SMALLEST_CLEARANCE = "Capture misalignment", "Smallest clearance"
"""Names of figures that the result of a task also has."""

_MINUTE = 60.0
_AXES = ("X", "Y", "Z", "roll", "pitch", "yaw")
_RANK: dict[Level, int] = {"info": 0, "caution": 1, "warning": 2}


class RunMetrics:
    """Values that summarise a run, collected frame by frame."""

    def __init__(self, period_s: float) -> None:
        self._period_s = period_s
        self._last: Frame | None = None
        self._lit: dict[str, Level] = {}
        self._signs = [0] * 6
        self._ticks = self._manual = self._vernier = 0
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
        self._manual += frame.by == "hand"
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
        """Add the devices that move the sticks from the next frame on."""
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
        """Count captures, and store the misalignment of the last capture."""
        for old, new in zip(before.work.cargo, frame.work.cargo, strict=True):
            if new.held and not old.held:
                self._captures += 1
                self._captured = capture_misalignment(before, old)

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

    def measures(self, ended: str, delays: Delays | None = None) -> tuple[Measure, ...]:
        """Return all values for which the run has data.

        The distance to a target is one of them only if the last frame has a target.

        Args:
            ended: reason for the end of the run; empty for a recording that was cut short.
            delays: delays of the steps; None if the recording does not tell them.
        """
        frame = self._last
        assert frame is not None, "PlaybackStore rejects a recording without a frame"
        duration = self._ticks * self._period_s
        figures = [
            Measure(RUN_TIME, "time", duration, "", "Simulated time in the recording."),
            Measure("Ended", "words", None, ended or "cut short", "Reason for the end of the run."),
            _figure("Manual share", "share", self._manual / self._ticks, "Share of the run's time with manual inputs."),
        ]
        if delays is not None:
            figures.append(_delay_figure(delays))
        if self._used:
            about = "; ".join(_controller_text(used) for used in self._used.values())
            figures.append(Measure("Controllers", "words", None, ", ".join(self._used), f"Last settings: {about}."))
        if frame.goal is not None:
            about = "Distance from the tip to the target, and angle between their attitudes, at the end of the run."
            figures.append(Measure("Distance to target", "length", frame.goal.distance, "", about, frame.goal.angle))
        if self._nearest is not None:
            least, pair, when = self._nearest
            about = f"Minimum clearance of the run, without essential contacts: {pair}, at {when:.1f} s."
            figures.append(Measure(SMALLEST_CLEARANCE, "gap", least, "", about, level=self._worst_clearance))
        if self._captures:
            figures += self._capture_figures()
        moved = max(self._deflected, 1)
        return (
            *figures,
            _figure(TIP_PATH, "distance", self._path, "Length of the tip's path."),
            _figure(
                "Greatest POR speed", "speed", self._fastest, "Greatest measured speed of the point of resolution."
            ),
            _figure(
                "Worst joint rate",
                "part of limit",
                self._worst,
                "Greatest commanded joint rate, as a fraction of the joint's limit at that time.",
            ),
            _figure("Time in vernier", "time", self._vernier * self._period_s, "Time with the rate setting vernier."),
            _figure(
                "Two-handed share",
                "share",
                self._both_hands / moved,
                "While any stick is deflected: share of the time with both THC and RHC deflected.",
            ),
            _figure(
                "Multi-axis share",
                "share",
                self._several_axes / moved,
                "While any stick is deflected: share of the time with several axes deflected.",
            ),
            _figure(
                "Reversals a minute",
                "count",
                sum(self._reversals) / duration * _MINUTE,
                "Number of times that a stick axis changed its sign, per minute.",
            ),
            self._worst_axis(),
            Measure(
                ALARMS_RAISED,
                "count",
                float(self._alarms),
                "",
                "Number of times that a lamp changed to a higher level: caution or warning.",
                level=self._worst_lamp,
            ),
            _figure("Brakes used", "count", float(self._brakes), "Number of times that the brakes were set."),
            *self._camera_figures(),
        )

    def _worst_axis(self) -> Measure:
        most = max(self._reversals)
        text = f"{_AXES[self._reversals.index(most)]}, {most}" if most else "none"
        return Measure(
            "Reversals, worst axis", "words", None, text, "Stick axis with the most reversals, and their number."
        )

    def _capture_figures(self) -> list[Measure]:
        number = "" if self._captures == 1 else f" Last of {self._captures} captures."
        offset, angle, rate = self._captured
        figures = []
        if offset is not None:
            about = f"Offset and angle between end effector and payload, in the step before the capture.{number}"
            figures.append(Measure(CAPTURE_MISALIGNMENT, "gap", offset, "", about, angle))
        about = f"Speed of the tip relative to the payload, in the step before the capture.{number}"
        return [*figures, _figure("Rate at capture", "speed", rate, about)]

    def _camera_figures(self) -> list[Measure]:
        """Return the number of camera changes, if a page reported its cameras."""
        if not self._monitors:
            return []
        about = "Number of times that a monitor changed its camera or was split."
        return [_figure("Camera changes", "count", float(self._cameras), about)]


def _figure(name: str, quantity: Quantity, value: float, about: str) -> Measure:
    return Measure(name, quantity, value, "", about)


def _delay_figure(delays: Delays) -> Measure:
    about = (
        "Time that the station did not make up, late steps (more than one control period after they were due), and the "
        "greatest delay."
    )
    return Measure("Time lost", "words", None, delays.text(), about, level="caution" if delays.lost_s else "info")


def _worse(*levels: Level) -> Level:
    return max(levels, key=lambda level: _RANK[level])


def _controller_text(used: ControllerRecord) -> str:
    """Return a device's name and settings: ``Test pad, deadband 8 %, expo 0.3``; for a keyboard only the name."""
    set_to = "" if used.kind == "keyboard" else f", deadband {used.deadband:.0%}, expo {used.expo:g}".replace("%", " %")
    return f"{used.name}{set_to}"
