"""``python -m benchmarks.plants``: modes 1, 2 and 3 on every plant, without and with payloads, as a table in Markdown.

The arm moves its tip by 3 m in empty space, from a pose over the bay. The payload is a uniform cylinder whose centre is
at the tip; the orbiter is fixed. *Off the line* is the greatest distance of the tip from the straight line (modes 2 and
3), and *miss* the distance and angle from the target when the motion ends: by the encoders, and truly.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import Pose
from aftdeck.kinematics.arm import load_arm
from aftdeck.simulation.run import Simulation
from aftdeck.steering.mode import LawChoice
from benchmarks.empty_space import in_space, move_to

START = np.radians([-31.0, 79.0, -103.0, -77.0, 17.0, -128.0])
BY = np.array([2.0, 1.5, -1.65])
"""Displacement of the tip in L: 3.0 m."""
LAWS: dict[int, LawChoice] = {1: "position", 2: "closed loop", 3: "open loop"}
LOADS = (0, 15_000, 32_000, 65_000)
"""Masses of the payload [lb]."""
PLANTS = ("kinematic", "rigid", "flexible")


class Size(NamedTuple):
    """Motions of the table: modes, masses of the payload [lb], and plants."""

    modes: tuple[int, ...]
    loads: tuple[int, ...]
    plants: tuple[str, ...]


FULL, TINY = Size((1, 2, 3), LOADS, PLANTS), Size((1,), (0,), ("rigid",))


class Row(NamedTuple):
    """Result of one motion; lengths in m, angles in rad, by encoder and true."""

    time: float
    off: tuple[float, float]
    miss: tuple[float, float]
    turn: tuple[float, float]
    late: float
    """Time after the end of the motion until the true tip stays within 10 mm of its last position [s]."""


def flight(law: LawChoice, pounds: float, plant: str) -> Row:
    """Make one motion and return its result."""
    tip = load_arm("srms").forward(START)
    target = tip.position + BY
    wait = "[[phase]]\nmode = 'ORB UNL'\nduration = '90 s'\n"
    phases = move_to(Pose(target, tip.rotation), law) + wait
    sim = Simulation(in_space(plant, START.tolist(), pounds=pounds, phases=phases))
    seen, true, times, ended = [], [], [], None
    while not sim.ended:
        frame = sim.step()
        seen.append(frame.position)
        true.append(frame.position if frame.dynamics is None else frame.dynamics.position)
        times.append(frame.time_s)
        if ended is None and frame.goal is not None and any(event.kind == "arrived" for event in frame.events):
            ended = len(seen) - 1
            turned = frame.goal.angle, frame.goal.angle if frame.dynamics is None else _turn(frame.dynamics.miss)
    assert ended is not None, f"law {law}, {pounds} lb, {plant}: the motion did not end"
    last = np.linalg.norm(np.array(true) - true[-1], axis=1)
    unsettled = [times[i] for i in range(ended, len(times)) if last[i] > 1e-2]
    return Row(
        times[ended],
        (_off(np.array(seen[:ended]), tip.position), _off(np.array(true[:ended]), tip.position)),
        (math.dist(seen[ended], target), math.dist(true[ended], target)),
        turned,
        max(unsettled, default=times[ended]) - times[ended],
    )


def _turn(miss: tuple[float, float] | None) -> float:
    return math.nan if miss is None else miss[1]


def _off(tips: Array, start: Array) -> float:
    """Return the greatest distance of the tips (n, 3) from the line along `BY` through `start` [m]."""
    along = BY / np.linalg.norm(BY)
    away = tips - start
    return float(np.linalg.norm(away - np.outer(away @ along, along), axis=1).max())


def table(size: Size) -> Iterator[str]:
    """Yield the lines of the table."""
    yield "| mode | payload, lb | plant | time, s | off the line, mm | miss, mm | miss, deg | within 10 mm after, s |"
    yield "|---|---|---|---|---|---|---|---|"
    for mode in size.modes:
        for pounds in size.loads:
            for plant in size.plants:
                row = flight(LAWS[mode], pounds, plant)
                off = "–" if mode == 1 else _pair(row.off, 1e3, 1)
                turn = _pair(row.turn, math.degrees(1.0), 3)
                yield (
                    f"| {mode} | {pounds:,} | {plant} | {row.time:.1f} | {off} | {_pair(row.miss, 1e3, 1)} "
                    f"| {turn} | {row.late:.0f} |"
                )


def _pair(values: tuple[float, float], scale: float, digits: int) -> str:
    """Return the values by encoder and true, as text; one value if both are equal."""
    seen, true = (f"{scale * value:.{digits}f}" for value in values)
    return seen if seen == true else f"{seen} ({true})"


if __name__ == "__main__":
    for line in table(FULL):
        print(line, flush=True)
