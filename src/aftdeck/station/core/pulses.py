"""PULSE: a deflection of a stick that moves the arm by a small fixed distance or angle, whatever the machine's speed.

A pulse is a deflection of the same sticks as the operator's, for a number of control periods that is computed from the
limits in force. Therefore each mode, arm and plant moves as by hand, the recording needs no new input, and lost time
makes no pulse longer.

The sticks command a speed, which a motion reaches and leaves with the same acceleration a. A deflection that demands
the speed v for a time T >= v / a therefore moves the point by v T, whatever a is.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple, cast

from aftdeck.arrays import Array
from aftdeck.scenario.limits import por_with
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.station.conversion.frame_of import payload_id
from aftdeck.station.conversion.payload_table import loads
from aftdeck.station.core.commands import travel
from aftdeck.station.messages import from_page
from aftdeck.steering.layout import RATE_UP, SPEED_UP, TURN_UP
from aftdeck.steering.mode import MODES
from aftdeck.steering.rules import Key, rules_of
from aftdeck.tuples import Vec3

DISTANCE = 0.1 * 0.0254
"""Motion of the point of resolution, the telescope or the orbiter by one pulse [m]; assumed: an eighth of the smallest
tolerance of a built-in task, 0.75 in."""
ANGLE = math.radians(0.1)
"""Turn of the point of resolution, or of a joint, by one pulse [rad]; assumed: a third of the smallest tolerance of a
built-in task, 0.3 deg."""
LEAST_S = 0.5
"""Least duration of a pulse's deflection [s]; assumed: slow enough to see, and to stay below the limits."""
CHANNELS = 11
"""Number of the sticks' channels, in the order of `travel`."""
MOST = 20
"""Greatest number of pulses that wait in one direction."""
TOUCHED = 1e-9
"""Deflection while the motion of a pulse comes to rest [1]: it demands no motion, but counts as a held stick. POSITION
HOLD therefore keeps the place where the motion ends, not a place before it."""


class Axis(NamedTuple):
    """Limits of one channel of the sticks.

    Attributes:
        step: motion by one pulse [m or rad].
        speed: speed at full deflection [m/s or rad/s].
        acceleration: acceleration of its motion [m/s² or rad/s²].
    """

    step: float
    speed: float
    acceleration: float

    def duration(self) -> float:
        """Return the shortest time of a deflection that reaches its speed [s], at least `LEAST_S`."""
        return max(LEAST_S, math.sqrt(self.step / self.acceleration), self.step / self.speed)


class Pulses:
    """Pulses that have not ended.

    For each channel of `travel`: the motion that is still to be demanded [m or rad], and the control periods in which
    the motion still comes to rest.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._scenario = scenario
        self._left, self._rest = [0.0] * CHANNELS, [0] * CHANNELS
        self._rules_of = lru_cache(maxsize=None)(self._rules_for)

    def press(self, pulse: from_page.Pulse, frame: Frame | None) -> str:
        """Add a pulse; return why it is rejected, empty if it is not."""
        if frame is None:
            return "PULSE refused: the run has not started"
        arm = any((*pulse.translation, *pulse.rotation, pulse.drive))
        if arm and MODES[frame.mode].kind not in ("manual", "single"):
            return f"PULSE refused: the sticks do not move the arm in {frame.mode}"
        if arm and frame.rate_hold:
            return "PULSE refused: RATE HOLD keeps the rates; cancel it first"
        axes = self._axes(frame)
        after = [left + sign * axis.step for left, sign, axis in zip(self._left, travel(pulse), axes, strict=True)]
        if any(abs(left) > (MOST + 0.5) * axis.step for left, axis in zip(after, axes, strict=True)):
            return f"PULSE refused: {MOST} pulses are waiting already"
        self._left = after
        return ""

    def clear(self) -> None:
        """Forget all pulses; the sticks then are where the operator holds them."""
        self._left, self._rest = [0.0] * CHANNELS, [0] * CHANNELS

    def deflected(self, sticks: from_page.Sticks, frame: Frame | None) -> from_page.Sticks:
        """Return the sticks with the pulses' deflections for the next control period.

        Sticks that the operator deflects end all pulses.
        """
        if any(travel(sticks)):
            self.clear()
        if frame is None or not (any(self._left) or any(self._rest)):
            return sticks
        x, y, z, roll, pitch, yaw, drive, telescope, *orbiter = [
            self._next(channel, axis) for channel, axis in enumerate(self._axes(frame))
        ]
        return from_page.Sticks(
            sticks.seq, (x, y, z), (roll, pitch, yaw), drive, telescope, cast("Vec3", tuple(orbiter))
        )

    def _next(self, channel: int, axis: Axis) -> float:
        """Return the deflection of a channel in the next control period, and count it."""
        period, left = self._scenario.control_period, self._left[channel]
        if not left:
            self._rest[channel] = max(self._rest[channel] - 1, 0)
            return TOUCHED if self._rest[channel] else 0.0
        part = axis.step / math.ceil(axis.duration() / period - 1e-9)
        now = math.copysign(min(part, abs(left)), left)
        self._left[channel] = left - now if abs(left - now) > 1e-6 * axis.step else 0.0
        self._rest[channel] = math.ceil(part / period / axis.acceleration / period) + 1
        return now / (axis.speed * period)

    def _axes(self, frame: Frame) -> tuple[Axis, ...]:
        """Return the limits of all channels in the order of `travel`, with the modes, rates and payload of a frame."""
        mode = MODES[frame.mode]
        rules = self._rules_of(payload_id(frame))[mode.position, frame.rate, mode.laws[0]]
        point = Axis(DISTANCE, frame.por_limits[0], float(rules[SPEED_UP]))
        turn = Axis(ANGLE, frame.por_limits[1], float(rules[TURN_UP]))
        slides = self._scenario.arm.model.slides[frame.joint]
        joint = Axis(DISTANCE if slides else ANGLE, frame.rate_limits[frame.joint], float(rules[RATE_UP + frame.joint]))
        return (*[point] * 3, *[turn] * 3, joint, self._telescope(), *[self._orbiter()] * 3)

    def _rules_for(self, number: int) -> dict[Key, Array]:
        """Return the rules with the payload whose PL ID is `number`."""
        model, (_, mass) = self._scenario.arm.model, loads(self._scenario)[number]
        return rules_of(model, por_with(model, mass, self._scenario.por), self._scenario.control_period)

    def _telescope(self) -> Axis:
        """Return the telescope's limits; it has no ramp. Without a telescope, its stick moves nothing."""
        telescope = self._scenario.arm.model.telescope
        return Axis(DISTANCE, 1.0 if telescope is None else telescope.rate, math.inf)

    def _orbiter(self) -> Axis:
        """Return the limits of the orbiter's translation; without one, the simulation rejects the command."""
        rule = self._scenario.worksite.translation
        return (
            Axis(DISTANCE, 1.0, math.inf) if rule is None else Axis(DISTANCE, rule.speed, rule.speed / rule.reached_in)
        )
