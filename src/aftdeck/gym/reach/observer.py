"""Observation of Reach from a simulation's numbers: the same as `observe.py` computes for the compiled batch."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array
from aftdeck.frames import Pose
from aftdeck.gym.aligned import AlignedFloats
from aftdeck.gym.reach import definition as task
from aftdeck.gym.terms import Floats32, observation_space
from aftdeck.simulation.frame import Frame


class Observation(NamedTuple):
    """Observation with the remaining motion.

    Attributes:
        values: (24,) the observation.
        distance: distance to the goal [m].
        chord: size of the rotation to the goal's attitude, 2 sin(angle / 2).
    """

    values: Floats32
    distance: float
    chord: float


class Observer:
    """Observations of one arm.

    A value beyond the limits of the observation space is set to the limit: a joint with a mass can overshoot its
    greatest rate.
    """

    def __init__(self, model: ArmModel) -> None:
        own = model.por_limits(0.0)
        self._to_orbiter, self._space = model.mount.rotation, observation_space(task.OBSERVATIONS)
        self._arrays = AlignedFloats(*self._space.shape)
        self._middle, self._one = task.scales(
            float(own.translation[0]), float(own.rotation[0]), model.limits.soft, model.rates.servo
        )

    def of(self, goal: Pose, tip: Pose, angles: Array, rates: Array, twist: Array) -> Observation:
        """Return the observation.

        Args:
            goal: pose in L that the tip has to reach.
            tip: pose of the tip in L.
            angles: (6,) joint angles [rad].
            rates: (6,) joint rates [rad/s].
            twist: (6,) angular velocity and velocity of the tip in L.
        """
        turn = goal.rotation @ tip.rotation.T
        shift = goal.position - tip.position
        skew = 0.5 * np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
        trace = float(np.trace(turn))
        vector = skew / max(0.5 * math.sqrt(max(1.0 + trace, 0.0)), 1e-6)
        to_orbiter = self._to_orbiter
        values = np.concatenate(
            [to_orbiter @ shift, to_orbiter @ vector, to_orbiter @ twist[3:], to_orbiter @ twist[:3], angles, rates]
        )
        normalised = (values - self._middle) / self._one
        observation = self._arrays.new()
        observation[:] = np.clip(normalised, self._space.low, self._space.high)
        return Observation(observation, float(np.linalg.norm(shift)), math.sqrt(max(3.0 - trace, 0.0)))

    def in_frame(self, goal: Pose, frame: Frame) -> Observation:
        """Return the observation of a frame; `goal` is the pose in L that the tip has to reach."""
        tip = Pose(np.array(frame.position), np.array(frame.orientation))
        return self.of(goal, tip, np.array(frame.angles), np.array(frame.rates), np.array(frame.twist))
