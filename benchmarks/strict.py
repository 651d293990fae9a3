"""Table of the STS-400 motion in modes 1 to 3, as published (strict) and corrected: `python -m benchmarks.strict`."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from aftdeck.scenario.build import BUILT_IN
from aftdeck.scenario.load import parse_scenario
from aftdeck.simulation.run import Run, run

MOVES = {"1": "sts-400-position", "2": "sts-400-closed", "3": "sts-400-open"}
FULL = tuple((mode, period, strict) for mode in MOVES for period in (0.02, 0.08) for strict in (True, False))
TINY = (("1", 0.08, True),)
"""Rows of the table: mode, control period [s], and whether the laws run as published."""


def flown(name: str, strict: bool, period: float) -> Run:
    """Run a built-in scenario with these values of `strict` and of the control period [s]."""
    text = (BUILT_IN / f"{name}.toml").read_text()
    top = text.index("\n[initial]")
    settings = f"\nstrict = {str(strict).lower()}\ncontrol_period = {period}\n"
    return run(parse_scenario(text[:top] + settings + text[top:], name, f"{name}.toml", BUILT_IN))


def off_the_line(flight: Run) -> float:
    """Return the greatest distance of the tip from the straight line between its first pose and its target [m]."""
    start = flight.scenario.arm.forward(flight.scenario.initial_angles).position
    goal = next(frame.goal for frame in flight.frames if frame.goal is not None)
    line = np.array(goal.position) - start
    line /= np.linalg.norm(line)
    travelled = np.array([frame.position for frame in flight.frames]) - start
    return float(np.linalg.norm(travelled - np.outer(travelled @ line, line), axis=1).max())


def arrivals(flight: Run) -> tuple[float, float]:
    """Return the times from which the tip stays within 1 mm, and within 0.01 deg, of its target [s]."""
    tip = turn = 0.0
    for frame in flight.frames:
        if frame.goal is None or frame.goal.distance > 1e-3:
            tip = frame.time_s
        if frame.goal is None or frame.goal.angle > math.radians(0.01):
            turn = frame.time_s
    return tip, turn


def table(rows: tuple[tuple[str, float, bool], ...]) -> Iterator[str]:
    """Yield the lines of the table of docs/steering.md."""
    yield "| mode | control period | | off the line | final error | tip, rotation on target | ends |"
    yield "|---|---|---|---|---|---|---|"
    for mode, period, strict in rows:
        flight = flown(MOVES[mode], strict, period)
        s = flight.summary
        assert s.position_error_m is not None and s.rotation_error_rad is not None
        tip, turn = arrivals(flight)
        times = f"{tip:.2f}, {turn:.2f} s" if max(tip, turn) < s.time_s - period else "never"
        line = "—" if mode == "1" else f"{off_the_line(flight) * 1e3:.3f} mm"
        yield (
            f"| {mode} | {period} s | {'as published' if strict else 'corrected'} | {line} | "
            f"{s.position_error_m * 1e3:.3f} mm, {math.degrees(s.rotation_error_rad):.4f}° | {times} | "
            f"{s.ended}, {s.time_s:.2f} s |"
        )


if __name__ == "__main__":
    for row in table(FULL):
        print(row, flush=True)
