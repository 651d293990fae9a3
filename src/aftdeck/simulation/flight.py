"""A scenario made ready to fly: everything a step needs that never changes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from aftdeck.kinematics.observe import OBSERVED, observe
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.state import State
from aftdeck.steering.rules import Rate, rules_of

Array = NDArray[np.float64]
Pair = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Flight:
    """The constants of a flight.

    Attributes:
        scenario: what is flown.
        rules: the steering's rules by panel position and rate setting.
        reach: joint limits as plain pairs [rad], as `soft` and `hard`, for the zones.
    """

    scenario: Scenario
    rules: dict[tuple[str, Rate], Array]
    reach: tuple[Pair, ...]
    soft: tuple[Pair, ...]
    hard: tuple[Pair, ...]


def prepare(scenario: Scenario) -> Flight:
    """The flight of a scenario."""
    model = scenario.arm.model

    def pairs(limits: Array) -> tuple[Pair, ...]:
        return tuple((float(low), float(high)) for low, high in limits)

    return Flight(
        scenario,
        rules_of(
            model,
            scenario.por,
            scenario.control_period,
            scenario.payload,
            strict=scenario.strict,
            as_flown=scenario.as_flown,
            near=scenario.near,
            near_turn=scenario.near_turn,
        ),
        pairs(model.limits.reach),
        pairs(model.limits.soft),
        pairs(model.limits.hard),
    )


def first_state(scenario: Scenario) -> State:
    """The state at the scenario's first instant."""
    seen = np.empty(OBSERVED)
    observe(scenario.arm.model.links, scenario.initial_angles, scenario.initial_rates, seen)
    return State(scenario, seen[12:18])
