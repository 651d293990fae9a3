"""Reach as a `Simulation`, for plants with masses; its episodes are those of the compiled environment."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import Pose
from aftdeck.gym.actions import checked
from aftdeck.gym.reach import definition as task
from aftdeck.gym.reach.batch import ReachBatch
from aftdeck.gym.reach.observer import Observer
from aftdeck.gym.terms import Floats32
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Start
from aftdeck.scenario.schema import Plant
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation

SCENARIO = Path(__file__).with_name("scenario.toml")
"""Scenario of Reach: the arm in empty space."""


class SimulatedReach:
    """Reach on any plant."""

    def __init__(self, plant: Plant) -> None:
        scenario = load_scenario(SCENARIO, {("plant",): plant})
        self._sim, self._model = Simulation(scenario, digests=False), scenario.arm.model
        self._episodes, self._all = ReachBatch(1), np.ones(1, dtype=np.bool_)
        self._observer = Observer(self._model)
        self._goal = Pose(np.zeros(3), np.eye(3))
        self._distance = self._chord = 0.0

    def begin(self, key: int | None) -> Floats32:
        """Begin an episode and return the observation (24,); a key begins with episode 0, None with the next one."""
        self._episodes.seed([key])
        self._episodes.begin(self._all)
        angles, self._goal = self._episodes.angles()[0], self._episodes.goals()[0]
        self._sim.restart(Start(angles, np.zeros(6), float(self._model.links[0]), None))
        tip = self._sim.scenario.arm.forward(angles)
        observation, self._distance, self._chord = self._observer.of(self._goal, tip, angles, np.zeros(6), np.zeros(6))
        return observation

    def now(self) -> tuple[Array, Pose]:
        """As in `Reach`."""
        return np.array(self._sim.look().angles), self._goal

    def step(self, action: object) -> tuple[Floats32, float, bool]:
        """Make one step with the sticks (6,); return the observation, the reward, and whether the goal is reached."""
        sticks = checked(action, task.CONTROLS)
        self._sim.advance(
            Inputs(translation=(sticks[0], sticks[1], sticks[2]), rotation=(sticks[3], sticks[4], sticks[5]))
        )
        observation, distance, chord = self._observer.in_frame(self._goal, self._sim.look())
        reached = distance <= task.NEAR and chord <= task.chord(task.NEAR_ANGLE)
        reward = (
            task.DISTANCE.weight * (self._distance - distance)
            + task.ROTATION.weight * (self._chord - chord)
            + (task.SUCCESS.weight * reached + task.TIME.weight * task.PERIOD)
        )
        self._distance, self._chord = distance, chord
        return observation, reward, reached
