"""``python -m benchmarks.flight_tests``: stops of the built-in flight tests, as a table in Markdown."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation

TESTS = {"flight-test": "none", "flight-test-loaded": "32,000 lb"}
"""Scenarios, and their payloads."""
FULL = tuple((name, plant) for name in TESTS for plant in ("rigid", "flexible"))
TINY = (("flight-test", "rigid"),)
"""Flight tests of the table: scenario and plant."""
CAUSES = {"brakes": "BRAKES", "command": "the command", "safing": "SAFING"}
"""Words of the log about the cause of a stop, by the last word of a step's name."""
LINE = re.compile(
    r"tip (?:at rest|swings (?P<left>[\d.]+) mm,) (?P<seconds>[\d.]+) s after (?P<cause>.+?) at (?P<speed>[\d.]+) m/s: "
    r"(?P<moved>[\d.]+) mm on, (?P<farther>[\d.]+) farther, swung (?P<swung>[\d.]+)"
)
"""Log line of a stop of an arm with SI units."""


class Measured(NamedTuple):
    """Measurements of a stop.

    Attributes:
        cause: event that began the stop.
        seconds: time until the tip was at rest, or until the measurement ended [s].
        speed: speed of the tip when the stop began [m/s].
        moved: distance of the tip's last place from its place when the stop began [m].
        farther: distance by which the tip was at most farther away [m].
        swung: greatest distance from its last place, after it had turned back [m].
        left: oscillation that is left [m]; None if the tip is at rest.
    """

    cause: str
    seconds: float
    speed: float
    moved: float
    farther: float
    swung: float
    left: float | None


def measured(text: str) -> Measured:
    """Return the measurements in a log line in SI units."""
    found = LINE.fullmatch(text)
    assert found is not None, text
    moved, farther, swung, left = (float(found[name] or "nan") / 1e3 for name in ("moved", "farther", "swung", "left"))
    speed, seconds = float(found["speed"]), float(found["seconds"])
    return Measured(found["cause"], seconds, speed, moved, farther, swung, None if found["left"] is None else left)


def stops(name: str, plant: str) -> list[tuple[str, Measured]]:
    """Run a flight test; return for each stop the name of its step and the measurements.

    The stops of the motions between the configurations are left out.
    """
    given = load_scenario(name, {("plant",): plant})
    sim = Simulation(replace(given, arm=Arm(replace(given.arm.model, units="SI"))))
    step, cause, found = "", "", []
    while not sim.ended:
        sim.advance()
        for event in sim._state.events:
            if event.kind == "stop" and step and measured(event.text).cause == cause:
                found.append((step, measured(event.text)))
                step = ""
            if event.kind == "phase" and "stopped by" in event.text:
                _, step, _ = event.text.split("'")
                cause = CAUSES[step.rsplit(maxsplit=1)[1]]
    return found


def table(flights: tuple[tuple[str, str], ...]) -> Iterator[str]:
    """Yield the lines of the table."""
    yield "| payload | plant | step, stopped by | at, mm/s | moved, mm | farther, mm | swung, mm | end |"
    yield "|---|---|---|---|---|---|---|---|"
    for name, plant in flights:
        for step, stop in stops(name, plant):
            sizes = (stop.speed, stop.moved, stop.farther, stop.swung)
            numbers = " | ".join(_millimetres(size) for size in sizes)
            how = "at rest" if stop.left is None else f"swings by {_millimetres(stop.left)} mm"
            title = step.replace(", stopped by", ",")
            yield f"| {TESTS[name]} | {plant} | {title} | {numbers} | {how} after {stop.seconds:.1f} s |"


def _millimetres(size: float) -> str:
    """Return a length or a speed in millimetres, rounded to 1, or to 0.1 below 10."""
    return f"{size * 1e3:.0f}" if size >= 0.01 else f"{size * 1e3:.1f}"


if __name__ == "__main__":
    for line in table(FULL):
        print(line, flush=True)
