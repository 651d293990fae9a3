"""``python -m benchmarks.flight_tests``: stops of the built-in flight tests, as a table in Markdown."""

from __future__ import annotations

from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation

TESTS = {"flight-test": "none", "flight-test-loaded": "32,000 lb"}
"""Scenarios, and their payloads."""


def stops(name: str, plant: str) -> list[tuple[str, str]]:
    """Run a flight test; return for each stop the name of its step and the text of its log line.

    The stops of the motions between the configurations are left out.
    """
    sim, found, step = Simulation(load_scenario(name, {("plant",): plant})), [], ""
    while not sim.ended:
        sim.advance()
        for event in sim._state.events:
            if event.kind == "stop" and step:
                found.append((step, event.text))
                step = ""
            if event.kind == "phase":
                phase = event.text.split("'")[1]
                step = phase if "stopped by" in phase else step
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
