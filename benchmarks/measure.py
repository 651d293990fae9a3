"""Measured figures and their targets, and timing of short calls."""

from __future__ import annotations

import math
import time
import timeit
from collections.abc import Callable
from typing import NamedTuple

import msgspec


class Figure(msgspec.Struct, frozen=True):
    """Measured number.

    A target in seconds says more of the machine than of the program. Therefore most targets are shares of another
    figure of the same run, made by `against`. Absolute targets are for what a person waits for, and for sizes.

    Attributes:
        name: what was measured.
        value: the number; None if it could not be measured, for the reason in `note`.
        unit: its unit.
        target: greatest value that is promised. None for a figure without a promise.
        note: conditions of the measurement.
        share: `target` as a share of the peer's value; None if the target is absolute.
        peer: name of the figure of the same run with which this one is compared; empty if there is none.
    """

    name: str
    value: float | None
    unit: str
    target: float | None = None
    note: str = ""
    share: float | None = None
    peer: str = ""

    def __post_init__(self) -> None:
        """Check the value.

        Raises:
            ValueError: the value is infinite or not a number.
        """
        if self.value is not None and not math.isfinite(self.value):
            raise ValueError(f"figure {self.name!r} is {self.value}; expected a finite number")

    @property
    def kept(self) -> bool:
        """True if the value meets its target, or if one of both is absent."""
        return self.target is None or self.value is None or self.value <= self.target

    @property
    def ratio(self) -> float | None:
        """Value as a multiple of the peer's value; None for a figure without a peer."""
        if self.value is None or self.target is None or self.share is None:
            return None
        return self.value * self.share / self.target


def against(peer: Figure, share: float, name: str, value: float, unit: str, note: str = "") -> Figure:
    """Return a figure that promises to be at most `share` of the value of a peer, which has the same unit.

    If the peer could not be measured, the figure has no target.

    Raises:
        ValueError: the units differ.
    """
    if peer.unit != unit:
        raise ValueError(f"figure {name!r} in {unit} cannot be compared with {peer.name!r} in {peer.unit}")
    if peer.value is None:
        return Figure(name, value, unit, None, note)
    return Figure(name, value, unit, share * peer.value, note, share, peer.name)


def absent(name: str, unit: str, why: str) -> Figure:
    """Return a figure that could not be measured; `why` says what to install."""
    return Figure(name, None, unit, None, f"not measured: {why}")


class Timing(NamedTuple):
    """Extent of the timing of a short call.

    Attributes:
        repeat: number of loops; the shortest one counts.
        span: time of each loop [s].
    """

    repeat: int = 150
    span: float = 0.002


SHORT = Timing(2, 1e-4)
"""Timing that only shows that the call works."""


def microseconds(
    statement: str, names: dict[str, object], timing: Timing, clock: Callable[[], float] = time.process_time
) -> float:
    """Return the time of one execution of `statement` [us]: that of the shortest loop.

    It is the time of the processor, so that other work of the machine does not count. A statement that lets several
    threads work needs another clock.
    """
    timer = timeit.Timer(statement, globals=names, timer=clock)
    timer.timeit(1)  # compiles
    once = max(timer.timeit(3) / 3, 1e-8)
    number = max(1, round(timing.span / once))
    return min(timer.repeat(timing.repeat, number)) / number * 1e6


Call = tuple[str, dict[str, object]]
"""Statement, and the values of its names."""


ROUNDS = 5
"""Number of turns of two statements that are compared."""


def in_turn(first: Call, second: Call, timing: Timing) -> tuple[float, float]:
    """Return the times of one execution of two statements [us], timed in turn.

    Then other work of the machine delays both, and their ratio is hardly affected.
    """
    times = [[microseconds(*one, timing) for one in (first, second)] for _ in range(ROUNDS)]
    return min(one for one, _ in times), min(other for _, other in times)


def beside(peer: str, its: Call | None, share: float, name: str, call: Call, timing: Timing, note: str = "") -> Figure:
    """Time a call in turn with a peer's call; return a figure that promises at most a share of the peer's time.

    The figure has no target if the peer is absent: `its` is None.
    """
    if its is None:
        return Figure(name, microseconds(*call, timing), "us", None, note)
    ours, other = in_turn(call, its, timing._replace(repeat=max(1, timing.repeat // ROUNDS)))
    return against(Figure(peer, other, "us"), share, name, ours, "us", note)


def percentile(values: list[float], percent: float) -> float:
    """Return the smallest value that at least `percent` % of the values do not exceed."""
    ordered = sorted(values)
    return ordered[max(0, math.ceil(percent / 100 * len(ordered)) - 1)]
