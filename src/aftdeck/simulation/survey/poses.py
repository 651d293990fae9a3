"""Poses in which a survey tests an arm, and the arm's solids in these poses."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import product

import numpy as np

from aftdeck.arms.by_joint import shown
from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array
from aftdeck.bodies.pose import pose_of
from aftdeck.frames import Pose
from aftdeck.kinematics.frames import frames_of, place_frames
from aftdeck.scenario.fit import Parts
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.on_arm import arm_solids

TRIED = 5000
"""Number of random poses inside the soft stops; the test of these poses takes half a second."""


def stops(scenario: Scenario) -> Iterator[tuple[str, Array, float, float]]:
    """Yield the arm's pose at the middle of its hard limits, then its poses at all combinations of its hard stops.

    Each pose is yielded as: description, joint angles [rad], length of the telescope and position of the prong [m].
    """
    model = scenario.arm.model
    low, high = model.limits.hard.T
    ends, prong = _travel(scenario)
    yield "with every joint at the middle of its limits", 0.5 * (low + high), ends[0], prong
    # if a joint that turns has a range of a full turn or more, the middle of the range replaces the upper stop
    turns = np.where((high - low < 2.0 * math.pi) | np.array(model.slides), high, 0.5 * (low + high))
    for joints in product(*zip(low, turns, strict=True)):
        for end in ends:
            yield joints_text(model, np.array(joints)), np.array(joints), end, prong


def placed(scenario: Scenario, angles: Array, stand: float, prong: float) -> dict[str, Pose]:
    """Return the pose in L of each frame of the arm, from joint angles [rad] and telescope and prong positions [m]."""
    arm = frames_of(scenario.arm.model)
    rows = arm.rows()
    place_frames(arm.joints, angles, stand, prong, rows)
    return {name: pose_of(row) for name, row in zip(arm.names, rows, strict=True)}


def bodies(scenario: Scenario, frames: dict[str, Pose]) -> Parts:
    """Return the arm's solids in L by part, for poses of the arm's frames."""
    found: Parts = {}
    for solid in arm_solids(scenario.arm.model, scenario.worksite):
        pose = frames[solid.frame]
        found.setdefault(solid.part, []).append(solid.vertices @ pose.rotation.T + pose.position)
    return found


def joints_text(model: ArmModel, angles: Array) -> str:
    """Return the joint angles of a pose as text."""
    if not any(model.slides):
        return f"at joint angles {', '.join(f'{math.degrees(angle):.0f}' for angle in angles.tolist())} deg"
    pairs = zip(angles.tolist(), model.slides, strict=True)
    return f"with the joints at {', '.join(shown(angle, slides, '.3g') for angle, slides in pairs)}"


def inside_soft_stops(scenario: Scenario) -> Iterator[tuple[Array, float, float]]:
    """Yield `TRIED` random poses inside the soft stops: joint angles [rad], positions of telescope and prong [m].

    The telescope's length is random too; the prong is open. Every call yields the same poses.
    """
    model, rng = scenario.arm.model, np.random.default_rng(0)
    low, high = model.limits.soft.T
    ends, prong = _travel(scenario)
    for _ in range(TRIED):
        yield rng.uniform(low, high), float(rng.uniform(ends[0], ends[-1])), prong


def _travel(scenario: Scenario) -> tuple[tuple[float, ...], float]:
    """Return the ends of the telescope's travel, and the position of the open prong [m].

    Without a telescope, the height of the shoulder replaces the two ends. Without a prong, the prong's position is 0.
    """
    model = scenario.arm.model
    telescope, prong = model.telescope, model.prong
    ends = (float(model.links[0]),) if telescope is None else (telescope.least, telescope.greatest)
    return ends, 0.0 if prong is None else prong.least
