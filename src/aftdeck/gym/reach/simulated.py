"""Reach as a `Simulation`, for plants with masses; its episodes are those of the compiled environment."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import Pose
from aftdeck.gym.actions import checked
from aftdeck.gym.choices import Plant
from aftdeck.gym.reach import definition as task
from aftdeck.gym.reach.batch import ReachBatch
from aftdeck.gym.terms import Floats32, observation_space
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Start
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation

_SCENARIO = Path(__file__).with_name("scenario.toml")


class SimulatedReach:
    """Reach on any plant.

    An observation beyond the limits of the observation space is set to the limit: a joint with a mass can overshoot its
    greatest rate.
    """

    def __init__(self, plant: Plant) -> None:
        scenario = load_scenario(_SCENARIO, {("plant",): plant})
        self._sim, self._model = Simulation(scenario), scenario.arm.model
        self._episodes, self._all = ReachBatch(1), np.ones(1, dtype=np.bool_)
        self._space = observation_space(task.OBSERVATIONS)
        own = self._model.por_limits(0.0)
        self._middle, self._one = task.scales(
            float(own.translation[0]), float(own.rotation[0]), self._model.limits.soft, self._model.rates.servo
        )
        self._goal = Pose(np.zeros(3), np.eye(3))
        self._distance = self._chord = 0.0

    def begin(self, key: int | None) -> Floats32:
        """Begin an episode and return the observation (24,); a key begins with episode 0, None with the next one."""
        self._episodes.seed([key])
        self._episodes.begin(self._all)
        angles, self._goal = self._episodes.angles()[0], self._episodes.goals()[0]
        self._sim.restart(Start(angles, np.zeros(6), float(self._model.links[0]), None))
        tip = self._sim.scenario.arm.forward(angles)
        observation, self._distance, self._chord = self._observe(tip, angles, np.zeros(6), np.zeros(6))
        return observation

    def step(self, action: object) -> tuple[Floats32, float, bool]:
        """Make one step with the sticks (6,); return the observation, the reward, and whether the goal is reached."""
        sticks = checked(action, task.CONTROLS)
        self._sim.advance(
            Inputs(translation=(sticks[0], sticks[1], sticks[2]), rotation=(sticks[3], sticks[4], sticks[5]))
        )
        frame: Frame = self._sim.look()
        tip = Pose(np.array(frame.position), np.array(frame.orientation))
        observation, distance, chord = self._observe(
            tip, np.array(frame.angles), np.array(frame.rates), np.array(frame.twist)
        )
        reached = distance <= task.NEAR and chord <= task.chord(task.NEAR_ANGLE)
        reward = (
            task.DISTANCE.weight * (self._distance - distance)
            + task.ROTATION.weight * (self._chord - chord)
            + (task.SUCCESS.weight * reached + task.TIME.weight * task.PERIOD)
        )
        self._distance, self._chord = distance, chord
        return observation, reward, reached

    def _observe(self, tip: Pose, angles: Array, rates: Array, twist: Array) -> tuple[Floats32, float, float]:
        """Return the observation (24,), the distance that is left [m], and the size of the rotation that is left.

        Args:
            tip: pose of the tip in L.
            angles: (6,) joint angles [rad].
            rates: (6,) joint rates [rad/s].
            twist: (6,) angular velocity and velocity of the tip in L.
        """
        turn = self._goal.rotation @ tip.rotation.T
        shift = self._goal.position - tip.position
        skew = 0.5 * np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
        trace = float(np.trace(turn))
        vector = skew / max(0.5 * math.sqrt(max(1.0 + trace, 0.0)), 1e-6)
        to_orbiter = self._model.mount.rotation
        values = np.concatenate(
            [to_orbiter @ shift, to_orbiter @ vector, to_orbiter @ twist[3:], to_orbiter @ twist[:3], angles, rates]
        )
        normalised = (values - self._middle) / self._one
        observation = np.clip(normalised, self._space.low, self._space.high).astype(np.float32)
        return observation, float(np.linalg.norm(shift)), math.sqrt(max(3.0 - trace, 0.0))
