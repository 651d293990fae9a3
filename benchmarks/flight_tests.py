"""``python -m benchmarks.flight_tests``: stops of the built-in flight tests, as a table in Markdown."""

from __future__ import annotations

from dataclasses import replace

from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation

TESTS = {"flight-test": "none", "flight-test-loaded": "32,000 lb"}
"""Scenarios, and their payloads."""


CAUSES = {"brakes": "BRAKES", "safing": "SAFING", "command": "the command ended"}
"""Words of the log about the cause of a stop, by the last word of a step's name."""


def stops(name: str, plant: str) -> list[tuple[str, str]]:
    """Run a flight test; return for each stop the name of its step and the text of its log line.

    The stops of the motions between the configurations are left out.
    """
    given = load_scenario(name, {("plant",): plant})
    sim, found = Simulation(replace(given, arm=Arm(replace(given.arm.model, units="SI")))), []
    steps: dict[str, str] = {}
    while not sim.ended:
        sim.advance()
        for event in sim._state.events:
            if event.kind == "phase" and "stopped by" in event.text:
                step = event.text.split("'")[1]
                steps[step.split()[-1]] = step
            if event.kind == "stop":
                cause = next(cause for cause, words in CAUSES.items() if words in event.text)
                if cause in steps:
                    found.append((steps.pop(cause), event.text))
    return found


def main() -> None:
    """Print the table."""
    print("| payload | plant | step | result |\n|---|---|---|---|")
    for name, payload in TESTS.items():
        for plant in ("rigid", "flexible"):
            for step, text in stops(name, plant):
                print(f"| {payload} | {plant} | {step} | {text} |")


if __name__ == "__main__":
    main()
