"""Scenario of an episode of Capture, Extract or Dock, for a run outside its environment."""

from __future__ import annotations

import time
import tomllib

from aftdeck.files import Where
from aftdeck.recording.bundle import opening, scenario_of
from aftdeck.scenario.model import Scenario, Start
from aftdeck.scenario.task_step import TaskStep


def started(scenario: Scenario, start: Start, step: TaskStep) -> Scenario:
    """Return a scenario that begins at a start at rest, and whose task is one step; its `changes` contain both."""
    telescope = scenario.arm.model.telescope is not None
    initial: dict[str, object] = {"joints": start.angles.tolist()} | ({"stand": start.stand} if telescope else {})
    if (held := start.grasped) is not None:
        grasped = {"cargo": scenario.payloads[held.payload].name, "joints": held.angles.tolist()}
        initial["grasped"] = grasped | ({"stand": held.stand} if telescope else {})
    steps = tomllib.loads(scenario.text)["step"]
    changes: dict[Where, object] = {("initial",): initial, ("step",): [steps[scenario.steps.index(step)]]}
    return scenario_of(opening(scenario, scenario.seed, time.time_ns()), changes)
