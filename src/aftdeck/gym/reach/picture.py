"""Pictures of Reach: the arm in empty space, with the axes of the goal and of the tip."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from aftdeck.arrays import Array
from aftdeck.export.pictures import Pixels
from aftdeck.files import Changes
from aftdeck.frames import Pose
from aftdeck.gym.picture import Bar, Pictures
from aftdeck.gym.reach.simulated import SCENARIO
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario, Start
from aftdeck.simulation.run import Simulation
from aftdeck.visual.picture import Look

CAMERA = "ENG"
"""Usual camera: the engineering view, nearer than that of the worksite."""
_VIEW = ("worksite", "camera", 0)
VIEW: Changes = {(*_VIEW, "boresight"): [0.61, -0.705, -0.27], (*_VIEW, "field_of_view"): "30 deg"}
"""Direction of the engineering view: starts and goals are in its middle."""
_COLOURS = ((255, 80, 70), (80, 220, 90), (90, 140, 255))
"""Colours of the axes 1, 2 and 3."""
_GOAL = (1.2, 0.008)
_TIP = (0.8, 0.004)
"""Length of an axis of the goal and of the tip [m], and its width as a fraction of the picture's height."""


class ReachPictures:
    """Pictures of Reach; arguments and errors as for `Pictures`."""

    def __init__(self, camera: str | None, look: Look, width: int, height: int) -> None:
        scenario = _scenario()
        self._pictures = Pictures(scenario, camera, (CAMERA,), look, width, height)
        self._sim, self._stand = Simulation(scenario, digests=False), float(scenario.arm.model.links[0])

    def at(self, angles: Array, goal: Pose) -> Pixels:
        """Return the picture (height, width, 3) of joint angles (6,) [rad] and a goal in L."""
        self._sim.restart(Start(angles, np.zeros(6), self._stand, None))
        frame = self._sim.look()
        tip = Pose(np.array(frame.position), np.array(frame.orientation))
        return self._pictures.draw(frame, [*_axes(goal, *_GOAL), *_axes(tip, *_TIP)])


@lru_cache(maxsize=1)
def _scenario() -> Scenario:
    """Return the scenario of the pictures."""
    return load_scenario(SCENARIO, VIEW)


def _axes(pose: Pose, length: float, width: float) -> list[Bar]:
    """Return a bar for each axis of a pose."""
    ends = [np.array([pose.position, pose.position + length * axis]) for axis in pose.rotation.T]
    return [Bar(one, colour, width) for one, colour in zip(ends, _COLOURS, strict=True)]
