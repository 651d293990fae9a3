"""Scenarios of the concept arm at its worksite, with any start pose and with the payload held or not."""

from __future__ import annotations

import functools
from collections.abc import Iterable, Iterator
from pathlib import Path

import numpy as np

import aftdeck
from aftdeck.arrays import Array
from aftdeck.frames import Pose, rotation_x, rotation_y, rotation_z
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame

Vec3 = tuple[float, float, float]

FOOT = 0.3048
DOWN = np.array([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
"""Axes of system 2 in R, with X2 pointing down."""
STAND = 16.0
NATURAL = np.radians([0.0, 32.0, -106.0, 0.0, -16.0, 0.0])
"""Joint angles with the elbow up and the wrist not flipped [rad]."""
ABOVE: Vec3 = (28.0, 0.0, -3.3)
"""Start position of the palm: 4 ft above the bar of the payload in the bay [ft]."""
ON_BAR: Vec3 = (28.0, 0.0, 0.71)
"""Position of the palm at capture: 0.03 ft above the bar [ft]."""
AT_PORT: Vec3 = (12.02, 16.0, -28.41)
"""Position of the palm with the payload at the docking port [ft]."""
AT_STOWED = np.array([28.0, 0.0, 7.12])
"""Centre of the payload in the bay, in R [ft]."""
IN_BAY = 'name = "payload"'
"""Content of a [[cargo]] table: the payload in the bay."""


@functools.cache
def arm() -> aftdeck.Arm:
    return aftdeck.load_arm("concept-1972")


def joints(at: Vec3, turned: Vec3 = (0.0, 0.0, 0.0), stand: float = STAND) -> list[str]:
    """Return joint angles for a position of the palm's centre in R [ft] and a rotation [deg] from X2 pointing down."""
    roll, pitch, yaw = np.radians(turned)
    turn = rotation_z(yaw) @ rotation_y(pitch) @ rotation_x(roll) @ DOWN
    standing = arm().at(stand=stand * FOOT)
    found = standing.inverse(Pose(np.array(at) * FOOT, turn), near=NATURAL)[0]
    return [f"{angle!r} deg" for angle in np.degrees(found).tolist()]


def scenario(
    at: Vec3 = ABOVE,
    turned: Vec3 = (0.0, 0.0, 0.0),
    *,
    held: bool = False,
    stand: float = STAND,
    cargo: str = IN_BAY,
    extra: str = "",
) -> Scenario:
    """Return a scenario that starts with the palm at a position in R, with or without a held payload.

    Args:
        at: position of the palm's centre [ft].
        turned: roll, pitch and yaw about the axes of R, from the orientation with X2 down [deg].
        held: whether the palm holds the payload at the middle of its bar, as after a capture in the bay.
        stand: the telescope's length [ft].
        cargo: lines of the [[cargo]] table.
        extra: additional lines of the scenario, before [initial].
    """
    name = cargo.split('"')[1]
    grasped = f'grasped = {{ cargo = "{name}", joints = {joints(ON_BAR)}, stand = "{STAND} ft" }}' if held else ""
    text = f"""title = "test"
arm = "concept-1972"
worksite = "concept-1972"
duration = "3600 s"
{extra}
[initial]
joints = {joints(at, turned, stand)}
stand = "{stand!r} ft"
{grasped}
[[cargo]]
{cargo}
"""
    return parse_scenario(text, "test", "test.toml", Path("."))


def flown(sim: aftdeck.Simulation, given: Iterable[aftdeck.Inputs]) -> list[Frame]:
    """Return the frames of a run with manual inputs."""
    return [sim.step(inputs) for inputs in given]


def held_for(steps: int, inputs: aftdeck.Inputs) -> Iterator[aftdeck.Inputs]:
    """Yield the same inputs for a number of steps; their switches act in each step."""
    return (inputs for _ in range(steps))


def log_of(frames: Iterable[Frame]) -> list[str]:
    """Return the log lines except those of the kind `clearance`, which occur in most runs."""
    return [event.text for frame in frames for event in frame.events if event.kind != "clearance"]


def vec3(values: Array) -> Vec3:
    """Return three numbers as a tuple."""
    x, y, z = values.tolist()
    return x, y, z
