"""Observer of Capture, Extract and Dock: observations of simulations of one scenario."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.gym.aligned import AlignedFloats
from aftdeck.gym.mission.aim import aim_of
from aftdeck.gym.mission.definition import observations
from aftdeck.gym.mission.observe import Scale, observe_one
from aftdeck.gym.terms import Floats32, observation_space
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.task_file import StateSpec
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.row.shown import shown_of
from aftdeck.simulation.run import Simulation


class Scored(NamedTuple):
    """What the reward of a step needs.

    Attributes:
        aims: whether there is a place to move to.
        distance: distance that the tip, or the held payload, still has to move [m].
        angle: remaining rotation [rad].
        above: distance above the capture pose or the seat, along the way out [m].
        met: share of the conditions of capture or docking that hold; 0 without one.
        contact: whether a detrimental contact exists.
    """

    aims: bool
    distance: float
    angle: float
    above: float
    met: float
    contact: bool


class Observer:
    """Observations of one scenario.

    Args:
        scenario: the scenario.
        step: the step of its task that is flown.
        frame: a frame with the rate setting coarse; its limits normalise the velocities.
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

    def of(self, sim: Simulation) -> tuple[Floats32, Scored]:
        """Return the observation after a step, each value within the limits of the space, and what the reward needs."""
        flight, state = sim.parts
        observation = self._arrays.new()
        arrays = state.row.arrays(flight.packed)
        zero, one, low, high = self.scale
        found = observe_one(arrays, shown_of(flight, state), self.aim, (zero, one, low, high), observation)
        return observation, Scored(*found)


def may_be_done(wanted: StateSpec, worksite: WorksiteState, scored: Scored) -> bool:
    """Return False if a step of a task is certainly not done: it takes a frame and microseconds to find out.

    Args:
        wanted: the state that the step names.
        worksite: the worksite's part of the present state.
        scored: what the observer has found.
    """
    held = [payload for payload in worksite.payloads if payload.held]
    return (
        wanted.held in (None, bool(held))
        and (wanted.berth is None or any(payload.berth == wanted.berth for payload in held or worksite.payloads))
        and (wanted.above is None or scored.above >= wanted.above - ROUNDING)
        and (wanted.within is None or scored.distance <= wanted.within + ROUNDING)
        and (wanted.within_angle is None or scored.angle <= wanted.within_angle + ROUNDING)
        and wanted.ready in (None, scored.met == 1.0)
    )


ROUNDING = 1e-6
"""Greatest difference, by rounding, of a distance [m] or an angle [rad] that is computed in two ways."""
