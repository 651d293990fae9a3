"""Observation of Capture, Extract and Dock, from frames: numbers that an operator also has."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.gym.mission.definition import observations
from aftdeck.gym.terms import Floats32, observation_space
from aftdeck.scenario.model import Scenario
from aftdeck.scene.stick_axes import StickAxes
from aftdeck.simulation.frame import Frame
from aftdeck.task.along_sticks import seen_along
from aftdeck.task.readings import clearance_share, conditions_share, effector_switch
from aftdeck.task.remaining import Remaining


class Observer:
    """Observations of one scenario.

    Args:
        scenario: the scenario.
        frame: a frame with the rate setting coarse; its limits normalise the velocities.
    """

    def __init__(self, scenario: Scenario, frame: Frame) -> None:
        model = scenario.arm.model
        self._sticks = StickAxes(scenario)
        soft = model.limits.soft
        self._middle, self._half = soft.mean(axis=1), 0.5 * (soft[:, 1] - soft[:, 0])
        self._servo, (self._speed, self._turn) = model.rates.servo, frame.por_limits
        self.space = observation_space(observations(len(scenario.arm.joints)))

    def of(self, frame: Frame, left: Remaining | None) -> Floats32:
        """Return the observation of a frame, each value within the limits of the space.

        Args:
            frame: the frame.
            left: remaining motion; None if there is no place to move to.
        """
        seen = seen_along(frame, left, self._sticks.in_l(frame))
        values: Array = np.concatenate(
            [
                seen.to_go,
                seen.rotation_to_go,
                seen.velocity / self._speed,
                seen.turning / self._turn,
                (np.array(frame.angles) - self._middle) / self._half,
                np.array(frame.rates) / self._servo,
                [
                    clearance_share(frame),
                    float(frame.work.arm_inhibit),
                    conditions_share(frame),
                    1.0 if frame.rate == "coarse" else -1.0,
                    effector_switch(frame),
                    frame.work.hand.opening,
                ],
            ]
        )
        return np.clip(values, self.space.low, self.space.high).astype(np.float32)
