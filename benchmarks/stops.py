"""``python -m benchmarks.stops``: stops of the loaded arm from its permitted speeds, as a table in Markdown.

Each stop begins after the sticks were held until the point of resolution has its permitted speed. The payload's centre
is at the tip, or 2.3 m ahead of it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.units import FOOT
from benchmarks.empty_space import in_space

POSES = {"stretched": (0, 30, -5, 0, 0, 0), "over the bay": (-31, 79, -103, -77, 17, -128)}
"""Joint angles at the start of each stop [deg]."""
PUSH = (0.5, 0.0, -0.866)
"""Deflection of the sticks."""
LOADS = (250, 500, 1_000, 2_500, 5_000, 8_000, 15_000, 32_000, 65_000)
"""Masses of the payload [lb]."""
AHEAD = (0.0, 2.3)
"""Distances of the payload's centre from the tip, along the end effector's axis [m]."""


class Size(NamedTuple):
    """Stops of the table: masses of the payload [lb]; plants, poses and distances of the columns."""

    loads: tuple[int, ...]
    columns: tuple[tuple[str, str, float], ...]


FULL = Size(LOADS, tuple((plant, pose, ahead) for plant in ("rigid", "flexible") for pose in POSES for ahead in AHEAD))
TINY = Size((250,), (("rigid", "stretched", 0.0),))


def stop(plant: str, pounds: float, pose: str, ahead: float) -> float:
    """Return the greatest distance of the true tip from its place when the sticks are released [m]."""
    sim = Simulation(in_space(plant, np.radians(POSES[pose]).tolist(), pounds=pounds, ahead=ahead))
    assert sim.scenario.payload is not None
    limits = sim.scenario.arm.model.por_limits(sim.scenario.payload.mass)
    for _ in range(round(1.3 * limits.translation[0] / limits.acceleration / sim.scenario.control_period)):
        frame = sim.step(Inputs(mode="ORB LD", translation=PUSH))
    assert frame.dynamics is not None
    began, farthest = frame.dynamics.position, 0.0
    for _ in range(round(50.0 / sim.scenario.control_period)):
        frame = sim.step(Inputs())
        assert frame.dynamics is not None
        farthest = max(farthest, math.dist(began, frame.dynamics.position))
    return farthest


def table(size: Size) -> Iterator[str]:
    """Yield the lines of the table."""
    heads = [f"{plant}, {pose}, {ahead:g} m ahead" for plant, pose, ahead in size.columns]
    yield f"| payload, lb | {' | '.join(heads)} |"
    yield f"|---{'|---' * len(heads)}|"
    for pounds in size.loads:
        found = [stop(plant, pounds, pose, ahead) / FOOT for plant, pose, ahead in size.columns]
        yield f"| {pounds:,} | {' | '.join(f'{feet:.2f}' for feet in found)} |"


if __name__ == "__main__":
    for line in table(FULL):
        print(line, flush=True)
