"""Use of the hand controllers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from aftdeck.report.metric import Found, Metric, Value
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.source import PONTILLO

TWO_HANDED = Metric(
    "two_handed_share",
    "Two-handed share",
    "share",
    "While any stick is deflected: share of the time with both THC and RHC deflected.",
    PONTILLO,
)
MULTI_AXIS = Metric(
    "multi_axis_share",
    "Multi-axis share",
    "share",
    "While any stick is deflected: share of the time with several axes deflected.",
    PONTILLO,
)
TRANSLATION = Metric(
    "multi_axis_translation_share",
    "Multi-axis translation",
    "share",
    "While the THC is deflected: share of the time with several of its axes deflected.",
    PONTILLO,
)
ROTATION = Metric(
    "multi_axis_rotation_share",
    "Multi-axis rotation",
    "share",
    "While the RHC is deflected: share of the time with several of its axes deflected.",
    PONTILLO,
)
INPUTS = Metric(
    "discrete_inputs",
    "Discrete inputs",
    "count",
    "Number of times that THC, RHC or DRIVE left its centre.",
    PONTILLO,
)
REVERSALS = Metric("reversals", "Reversals", "count", "Number of times that a stick axis changed its sign.")
REVERSAL_RATE = Metric(
    "reversals_a_minute",
    "Reversals a minute",
    "count",
    "Number of times that a stick axis changed its sign, per minute of the run.",
)
WORST_AXIS = Metric(
    "most_reversed_axis", "Reversals, worst axis", "words", "Stick axis with the most reversals, and their number."
)
METRICS = (TWO_HANDED, MULTI_AXIS, TRANSLATION, ROTATION, INPUTS, REVERSALS, REVERSAL_RATE, WORST_AXIS)

_AXES = ("X", "Y", "Z", "roll", "pitch", "yaw")
_MINUTE = 60.0


class Sticks:
    """Use of the hand controllers."""

    def __init__(self, period_s: float) -> None:
        self._period_s = period_s
        self._steps = self._inputs = 0
        self._any = self._both = self._several = 0
        self._thc = self._thc_several = self._rhc = self._rhc_several = 0
        self._moved = False, False, False
        self._signs, self._reversals = [0] * 6, [0] * 6

    def see(self, frame: Frame, before: Frame | None) -> None:
        """Add the next frame."""
        self._steps += 1
        moved, self._moved = self._moved, (any(frame.translation), any(frame.rotation), frame.drive != 0.0)
        if self._moved != moved and before is not None:
            self._inputs += sum(now and not was for now, was in zip(self._moved, moved, strict=True))
        if not (self._moved[0] or self._moved[1]):
            return
        thc, rhc = _deflected(frame.translation), _deflected(frame.rotation)
        self._any += 1
        self._both += thc > 0 and rhc > 0
        self._several += thc + rhc > 1
        self._thc += thc > 0
        self._thc_several += thc > 1
        self._rhc += rhc > 0
        self._rhc_several += rhc > 1
        for i, axis in enumerate((*frame.translation, *frame.rotation)):
            sign = (axis > 0) - (axis < 0)
            if sign:
                self._reversals[i] += sign == -self._signs[i]
                self._signs[i] = sign

    def found(self) -> Iterator[Found]:
        """Yield all metrics; a share only if there was time in which it could be measured."""
        shares = (
            (TWO_HANDED, self._both, self._any),
            (MULTI_AXIS, self._several, self._any),
            (TRANSLATION, self._thc_several, self._thc),
            (ROTATION, self._rhc_several, self._rhc),
        )
        for metric, part, whole in shares:
            if whole:
                yield metric, Value(part / whole)
        yield INPUTS, Value(float(self._inputs))
        total, most = sum(self._reversals), max(self._reversals)
        yield REVERSALS, Value(float(total))
        if self._steps:
            yield REVERSAL_RATE, Value(total / (self._steps * self._period_s) * _MINUTE)
        text = f"{_AXES[self._reversals.index(most)]}, {most}" if most else "none"
        yield WORST_AXIS, Value(None, text)


def _deflected(stick: Sequence[float]) -> int:
    """Return the number of deflected axes."""
    return sum(axis != 0.0 for axis in stick)
