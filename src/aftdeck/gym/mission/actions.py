"""Actions of Capture, Extract and Dock as inputs of the simulation."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal

from aftdeck.errors import InputError
from aftdeck.gym.mission import definition
from aftdeck.gym.mission.definition import EFFECTOR, SWITCHED, Mission
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs

Rate = Literal["coarse", "vernier"]


def inputs_of(mission: Mission, values: Sequence[float], before: Rate) -> Inputs:
    """Return the hand controllers and switches of an action; a switch between its positions keeps its position.

    Args:
        mission: the environment.
        values: one number in [-1, 1] for each of its controls.
        before: rate setting that was commanded last. The switch moves only if the action changes it: a step in which
            nothing but the sticks moves takes a third less time.
    """
    x, y, z, roll, pitch, yaw, rate = values[:7]
    wanted: Rate = "coarse" if rate > SWITCHED else "vernier" if rate < -SWITCHED else before
    setting = None if wanted == before else wanted
    effector: Literal["close", "open"] | None = None
    if EFFECTOR in mission.controls and abs(values[7]) > SWITCHED:
        effector = "close" if values[7] > 0.0 else "open"
    return Inputs(translation=(x, y, z), rotation=(roll, pitch, yaw), rate=setting, effector=effector)


def repeats_of(scenario: Scenario) -> int:
    """Return the number of control steps in a step of an environment.

    Raises:
        InputError: the control period does not divide the duration of a step.
    """
    steps = definition.PERIOD / scenario.control_period
    if not math.isclose(steps, round(steps)) or round(steps) < 1:
        raise InputError(
            f"scenario: control_period is {scenario.control_period:g} s, expected a whole number of control steps in "
            f"{definition.PERIOD:g} s"
        )
    return round(steps)
