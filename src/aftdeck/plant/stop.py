"""State of the arm's tip on a plant with masses, and of the measurement of its stops."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.state_part import StatePart
from aftdeck.tuples import Vec3


class Stop(StatePart):
    """Measurement of how the tip comes to rest.

    Attributes:
        cause: event that began the stop, as text for the log.
        began: tick at which it began: the last tick of the command.
        place: true position of the tip at that time, in L [m].
        speed: speed of the tip at that time [m/s].
        slot: number of ticks of one row of `low` and `high`.
        low: (n, 3) least coordinates of the tip in each of the last n slots, in L [m]; infinite for a slot to come.
        high: (n, 3) greatest coordinates, likewise.
        turned: (2, 3) least and greatest coordinates of the tip since it first turned back, in L [m]; infinite before.
        greatest: greatest distance of the tip from `place` so far [m].
    """

    cause: str
    began: int
    place: Vec3
    speed: float
    slot: int
    low: Array
    high: Array
    turned: Array
    greatest: float = 0.0


class TipMotion(StatePart):
    """Motion of the tip, and its stop.

    Attributes:
        place: true position of the tip after the last step, in L [m]; None before the first step.
        speed: mean speed of the tip in the last step [m/s].
        driven: whether the operator or an automatic motion moved the arm in the last step.
        braked: whether the brakes were on in the last step.
        stop: measurement of the stop in progress; None if there is none.
    """

    place: Vec3 | None = None
    speed: float = 0.0
    driven: bool = False
    braked: bool = False
    stop: Stop | None = None
