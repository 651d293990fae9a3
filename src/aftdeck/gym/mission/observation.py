"""Observer of Capture, Extract and Dock: observations of simulations of one scenario."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.gym.aligned import AlignedFloats
from aftdeck.gym.mission.aim import aim_of
from aftdeck.gym.mission.definition import observations
from aftdeck.gym.mission.observe import Scale, observe_one
from aftdeck.gym.mission.score import SCORED
from aftdeck.gym.terms import Floats32, observation_space
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.parts.shown import shown_of, write_effector
from aftdeck.simulation.run import Simulation


class Observer:
    """Observations of one scenario.

    Args:
        scenario: the scenario.
        step: the step of its task that is flown.
        frame: a frame with the rate setting coarse; its limits normalise the velocities.

    Attributes:
        space: space of the observations.
        aim: place of the step (`aim.aim_of`).
        scale: scale of the observations.
    """

    def __init__(self, scenario: Scenario, step: TaskStep, frame: Frame) -> None:
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
        self.space = observation_space(observed)
        self.aim = aim_of(scenario, step)
        self.scale = Scale(
            np.concatenate([np.broadcast_to(zero, size) for size, zero, _ in scales]),
            np.concatenate([np.broadcast_to(one, size) for size, _, one in scales]),
            self.space.low.astype(np.float64),
            self.space.high.astype(np.float64),
        )
        self._arrays = AlignedFloats(*self.space.shape)

    @property
    def arrays(self) -> tuple[Array, Array, Array, Array]:
        """The scale's arrays, as Python passes them to a law."""
        zero, one, low, high = self.scale
        return zero, one, low, high

    def of(self, sim: Simulation) -> tuple[Floats32, Array]:
        """Return the observation after a step, within the limits of the space, and what `score` needs (6,)."""
        flight, state = sim.parts
        observation, scored = self._arrays.new(), np.empty(SCORED)
        arrays = state.row.arrays(flight.packed)
        write_effector(state)
        observe_one(arrays, shown_of(flight, state), self.aim, self.arrays, observation, scored)
        return observation, scored
