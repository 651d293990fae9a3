"""``python -m benchmarks.stops``: stops of the loaded arm from its permitted speeds, as a table in Markdown.

Each stop begins after the sticks were held until the point of resolution has its permitted speed. The payload's centre
is at the tip, or 2.3 m ahead of it.
"""

from __future__ import annotations

import math
from pathlib import Path

from aftdeck.scenario.load import parse_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.units import FOOT

POSES = {
    "stretched": "0 deg, 30 deg, -5 deg, 0 deg, 0 deg, 0 deg",
    "over the bay": "-31 deg, 79 deg, -103 deg, -77 deg, 17 deg, -128 deg",
}
"""Joint angles at the start of each stop."""
PUSH = (0.5, 0.0, -0.866)
"""Deflection of the sticks."""
LOADS = (250, 500, 1_000, 2_500, 5_000, 8_000, 15_000, 32_000, 65_000)
"""Masses of the payload [lb]."""
AHEAD = (0.0, 2.3)
"""Distances of the payload's centre from the tip, along the end effector's axis [m]."""


def stop(plant: str, pounds: float, pose: str, ahead: float) -> float:
    """Return the greatest distance of the true tip from its place when the sticks are released [m]."""
    text = f"""
title = "a stop"
worksite = "space"
plant = "{plant}"
mode = "ORB LD"
duration = "600 s"
dynamics = {{ orbiter = "fixed" }}
[initial]
joints = [{", ".join(f"'{angle}'" for angle in POSES[pose].split(", "))}]
[payload]
mass = "{pounds} lb"
position = [{ahead}, 0.0, 0.0]
"""
    sim = Simulation(parse_scenario(text, "stop", "stop.toml", Path()))
    assert sim.scenario.payload is not None
    limits = sim.scenario.arm.model.por_limits(sim.scenario.payload.mass)
    for _ in range(round(1.3 * limits.translation[0] / limits.acceleration / sim.scenario.control_period)):
        frame = sim.step(Inputs(translation=PUSH))
    assert frame.dynamics is not None
    began, farthest = frame.dynamics.position, 0.0
    for _ in range(round(50.0 / sim.scenario.control_period)):
        frame = sim.step(Inputs())
        assert frame.dynamics is not None
        farthest = max(farthest, math.dist(began, frame.dynamics.position))
    return farthest


def main() -> None:
    """Print the table."""
    columns = [(plant, pose, ahead) for plant in ("rigid", "flexible") for pose in POSES for ahead in AHEAD]
    heads = [f"{plant}, {pose}, {ahead:g} m ahead" for plant, pose, ahead in columns]
    print(f"| payload, lb | {' | '.join(heads)} |\n|---{'|---' * len(heads)}|")
    for pounds in LOADS:
        found = [stop(plant, pounds, pose, ahead) / FOOT for plant, pose, ahead in columns]
        print(f"| {pounds:,} | {' | '.join(f'{feet:.2f}' for feet in found)} |", flush=True)


if __name__ == "__main__":
    main()
