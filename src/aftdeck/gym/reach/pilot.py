"""Pilot that flies the goals of `goals.py` with a policy of Reach."""

from __future__ import annotations

import numpy as np

from aftdeck.frames import Pose
from aftdeck.gym.policy import Policy
from aftdeck.gym.reach.observer import Observer
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.task.progress import Progress


class ReachPilot:
    """A policy of Reach in one run of a scenario of `goals_scenario`; the present step's target is its goal.

    Attributes:
        progress: progress through the goals.
    """

    def __init__(self, scenario: Scenario, policy: Policy) -> None:
        self.progress = Progress(scenario)
        self._policy, self._observer = policy, Observer(scenario.arm.model)

    def __call__(self, sim: Simulation) -> Inputs | None:
        """Return the inputs of the next step; None if all goals are reached."""
        frame = sim.frame
        if frame is None:
            return Inputs()
        self.progress.see(frame)
        left = self.progress.remaining()
        if self.progress.present is None or left is None or left.pose is None:
            return None
        goal = Pose(np.array(left.pose.position), np.array(left.pose.orientation))
        x, y, z, roll, pitch, yaw = self._policy.act(self._observer.in_frame(goal, frame).values).tolist()
        return Inputs(translation=(x, y, z), rotation=(roll, pitch, yaw))
