"""Scenario with goals of Reach as steps of a task, so that a policy or a person can fly them in the station."""

from __future__ import annotations

import math

import numpy as np

from aftdeck.arrays import Array
from aftdeck.files import Changes
from aftdeck.frames import Pose
from aftdeck.gym.reach import definition as task
from aftdeck.gym.reach.batch import ReachBatch
from aftdeck.gym.reach.simulated import SCENARIO
from aftdeck.scenario.load import find_scenario, parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.schema import Plant

GOALS = 20
"""Number of goals in a run."""

_STEP = """
[[step]]
title = "Goal {number}"
text = "Move the end effector to the green ghost: press keys until distance and angle of *to target* are green."
mode = "ORB UNL"
target = {{ frame = "L", position = {position}, matrix = {matrix} }}
done = {{ within = "{near:.9g} m", within_angle = "{turn:.9g} deg" }}
uses = ["-Z: up", "+X: forward", "+Z: down", "-Y: left", "-X: back", "+Y: right"]
groups = ["thc", "rhc"]
"""


def goals_scenario(seed: int, changes: Changes | None = None) -> Scenario:
    """Return the scenario of Reach with the first goals of the environments with the seeds `seed`, `seed` + 1, ...

    Args:
        seed: seed of the first goal.
        changes: new values of the scenario, such as another plant.
    """
    batch = ReachBatch(GOALS)
    batch.seed([seed + i for i in range(GOALS)])
    batch.begin(np.ones(GOALS, dtype=np.bool_))
    steps = [_step(number, goal) for number, goal in enumerate(batch.goals(), 1)]
    source = find_scenario(SCENARIO)
    return parse_scenario(source.text + "".join(steps), "reach", source.file, source.folder, changes)


def episode_scenario(angles: Array, goal: Pose, plant: Plant) -> Scenario:
    """Return the scenario of an episode: it begins at joint angles (6,) [rad], and its task is one goal."""
    source, start = find_scenario(SCENARIO), {"joints": angles.tolist()}
    changes: Changes = {("plant",): plant, ("initial",): start}
    return parse_scenario(source.text + _step(1, goal), "reach", source.file, source.folder, changes)


def _step(number: int, goal: Pose) -> str:
    """Return the step that moves the tip to a goal, as TOML; it is done where an episode of Reach ends."""
    position = [f"{value!r} m" for value in goal.position.tolist()]
    return _STEP.format(
        number=number,
        position=str(position).replace("'", '"'),
        matrix=goal.rotation.tolist(),
        near=task.NEAR,
        turn=math.degrees(task.NEAR_ANGLE),
    )


def has_goals(scenario: Scenario) -> bool:
    """Return whether a scenario is one of `goals_scenario`."""
    return bool(scenario.steps) and scenario.text.startswith(find_scenario(SCENARIO).text)
