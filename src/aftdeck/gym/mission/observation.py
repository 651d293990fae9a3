"""Observation of Capture, Extract and Dock, from frames: numbers that an operator also has."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from aftdeck.arrays import Array
from aftdeck.gym.aligned import AlignedFloats
from aftdeck.gym.mission.definition import observations
from aftdeck.gym.terms import Floats32, observation_space
from aftdeck.law import law
from aftdeck.scenario.model import Scenario
from aftdeck.scene.stick_axes import StickAxes
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.reading import Known, Reading
from aftdeck.simulation.readings.table import named
from aftdeck.task.along_sticks import seen_along
from aftdeck.task.remaining import Remaining


@law
def normalise(values: Array, zero: Array, one: Array, low: Array, high: Array, observation: Floats32) -> None:
    """Write (values - zero) / one, within the limits `low` and `high`, into an observation; all arrays are (n,)."""
    for i in range(len(values)):
        observation[i] = min(max((values[i] - zero[i]) / one[i], low[i]), high[i])


class Observer:
    """Observations of one scenario.

    Args:
        scenario: the scenario.
        frame: a frame with the rate setting coarse; its limits normalise the velocities.
    """

    def __init__(self, scenario: Scenario, frame: Frame) -> None:
        model, (speed, turn) = scenario.arm.model, frame.por_limits
        soft, none = model.limits.soft, (0.0, 1.0)
        zeros_and_ones: dict[str, tuple[Array | float, Array | float]] = {
            "velocity": (0.0, speed),
            "turning": (0.0, turn),
            "angle": (soft.mean(axis=1), 0.5 * (soft[:, 1] - soft[:, 0])),
            "rate": (0.0, model.rates.servo),
        }
        observed = observations(len(scenario.arm.joints))
        scales = [(one.size, *zeros_and_ones.get(one.reading, none)) for one in observed]
        self._zero = np.concatenate([np.broadcast_to(zero, size) for size, zero, _ in scales])
        self._one = np.concatenate([np.broadcast_to(one, size) for size, _, one in scales])
        self._names = [one.reading for one in observed]  # names can be pickled, readings cannot
        self._scenario, self._sticks = scenario, StickAxes(scenario)
        self.space = observation_space(observed)
        self._low, self._high = self.space.low.astype(np.float64), self.space.high.astype(np.float64)
        self._arrays = AlignedFloats(*self.space.shape)

    def of(self, frame: Frame, left: Remaining | None) -> Floats32:
        """Return the observation of a frame, each value within the limits of the space.

        Args:
            frame: the frame.
            left: remaining motion; None if there is no place to move to.
        """
        known = Known(frame, self._scenario, along=seen_along(frame, left, self._sticks.in_l(frame)))
        values = np.array([value for reading in self._readings for value in reading.values(known)], np.float64)
        observation = self._arrays.new()
        normalise(values, self._zero, self._one, self._low, self._high, observation)
        return observation

    @cached_property
    def _readings(self) -> list[Reading]:
        return [named(name) for name in self._names]

    def __getstate__(self) -> dict[str, object]:
        """Return the fields for `pickle`, without the readings, which cannot be pickled."""
        return {name: value for name, value in vars(self).items() if name != "_readings"}
