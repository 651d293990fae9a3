"""Coordinate systems of RMS-VS in a frame: where each of them is in the reference system R.

R has its origin at the foot of STAND; X aft, Y port, Z down. Systems 0, 1 and 2 are fixed to ARM 0, ARM 1 and the end
effector, with their origins at shoulder, elbow and wrist and X along the link. P is fixed to the payload, with its
origin at the payload's centre; its axes are those of R while the payload lies in the bay. W (wrist heading) and S
(`space`) are ours.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.mainprior.tables import System
from aftdeck.matrices import product
from aftdeck.scenario.model import Scenario
from aftdeck.scene.cameras import turn
from aftdeck.simulation.frame import Frame
from aftdeck.visual.scene import VisualScene

ARMS: dict[System, int] = {"L0": 2, "L1": 3, "L2": 6, "LW": 4}
"""Joint frames of the systems of the arm, in `ArmModel.linkage.frames`."""
OVER = np.diag([1.0, -1.0, -1.0])
"""Rotation between axes with z up (a payload, the scene) and axes with z down (P, R); it is its own inverse."""


class Placed(NamedTuple):
    """Pose of a coordinate system or a frame in R.

    Attributes:
        origin: (3,) position of its origin [m].
        axes: (3, 3) rotation; the columns are its axes.
    """

    origin: Array
    axes: Array

    def within(self, points: Array) -> Array:
        """Convert points (..., 3) from R to this system [m]."""
        return product(points - self.origin, self.axes)

    def outside(self, points: Array) -> Array:
        """Convert points (..., 3) from this system to R [m]."""
        return product(points, self.axes.T) + self.origin


def in_reference(scenario: Scenario, scene: VisualScene, frame: Frame) -> dict[str, Placed]:
    """Return the poses in R of all frames of the scene, by name; `orbiter` and `space` are among them."""
    bodies = scene.bodies_at(frame)
    foot = _placed(bodies[scenario.arm.model.linkage.frames[0]])
    found = {name: _seen_from(foot, _placed(body)) for name, body in bodies.items()}
    for name, row in zip(scene.clusters.frames, scene.frames_at(frame), strict=True):
        found[name] = _seen_from(foot, Placed(row[:3], row[3:].reshape(3, 3)))
    return found


def systems_at(scenario: Scenario, frames: dict[str, Placed]) -> dict[System, Placed]:
    """Return the coordinate systems in R; LP only if there is a payload, LS only if a body is fixed to ``space``.

    Args:
        scenario: the scenario, with one payload at most.
        frames: result of `in_reference`.
    """
    names = scenario.arm.model.linkage.frames
    found: dict[System, Placed] = {"LR": Placed(np.zeros(3), np.eye(3))}
    found.update({system: frames[names[number]] for system, number in ARMS.items()})
    for payload in scenario.payloads:
        pose = frames[payload.name]
        found["LP"] = Placed(pose.origin, product(pose.axes, OVER))
    if "space" in frames:
        found["LS"] = Placed(frames["space"].origin, product(frames["space"].axes, OVER))
    return found


def _placed(seven: Array) -> Placed:
    return Placed(seven[:3], np.array(turn(seven)))


def _seen_from(base: Placed, body: Placed) -> Placed:
    """Return the pose of a body in the frame whose pose is `base`."""
    return Placed(base.within(body.origin), product(base.axes.T, body.axes))
