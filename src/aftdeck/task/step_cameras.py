"""Pictures that a task's steps show although they are turned against the sticks, for ``aftdeck check``."""

from __future__ import annotations

import math
from collections.abc import Iterator

import msgspec
import numpy as np

from aftdeck.files import Problem
from aftdeck.frames import SCENE_FROM_PANEL_AXES
from aftdeck.matrices import product
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.task_step import TaskStep
from aftdeck.scene.cameras import SceneCameras
from aftdeck.scene.stick_axes import StickAxes
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.steering.mode import MODES
from aftdeck.task.remaining import Aims

CROSSED = math.radians(100.0)
"""Greatest angle between picture and sticks that is easy to use [rad]: a quarter turn, and the tilt of a camera that
looks down, as in `web/src/cameras/best-pair.ts`."""


class StepCameras:
    """Angles between the pictures of a scenario's cameras and the sticks, in the steps of its task."""

    def __init__(self, scenario: Scenario) -> None:
        self._scenario = scenario
        self._aims, self._sticks, self._cameras = Aims(scenario), StickAxes(scenario), SceneCameras(scenario)
        self._start = Simulation(scenario).step(Inputs())
        self._bodies = self._cameras.bodies_at(self._start)

    def turned(self, step: TaskStep, camera: str) -> float:
        """Return the angle between a picture's directions and the sticks' directions in a step [rad].

        It is zero if +X points into the picture, +Y to the right and +Z down, and if the step moves single joints.
        The tip has its attitude at the step's target. A camera on the arm turns with it, and counts at the start.
        """
        frame = self._start if step.mode is None else msgspec.structs.replace(self._start, mode=step.mode)
        mode = MODES[frame.mode]
        if mode.by_joint or step.joint is not None or (mode.axes == "payload axes" and frame.payload is None):
            return 0.0
        if self._cameras.camera(camera).body not in self._scenario.arm.model.frames:
            frame = self._at_target(frame, step)
        x, y, z = product(SCENE_FROM_PANEL_AXES, np.array(self._sticks.in_panel(frame))).T
        right, down, ahead = self._cameras.seen(self._start, self._bodies, camera).axes
        return math.acos(min(1.0, max(-1.0, (float(ahead @ x + right @ y + down @ z) - 1.0) / 2.0)))

    def _at_target(self, frame: Frame, step: TaskStep) -> Frame:
        left = self._aims.remaining(frame, step)
        if left is None or left.pose is None:
            return frame
        return msgspec.structs.replace(frame, orientation=left.pose.orientation)


def turned_pictures(scenario: Scenario) -> Iterator[Problem]:
    """Yield a problem for each camera of a step whose picture is turned by more than `CROSSED` against the sticks."""
    if not any(step.cameras for step in scenario.steps):
        return
    cameras = StepCameras(scenario)
    for i, step in enumerate(scenario.steps):
        for name in step.cameras:
            if (angle := cameras.turned(step, name)) > CROSSED:
                what = f"the picture of camera {name} is turned by {math.degrees(angle):.0f}° against the sticks"
                avoided = f"the station avoids more than {math.degrees(CROSSED):.0f}°"
                yield Problem(("step", i, "cameras"), f"{what}; {avoided}")
