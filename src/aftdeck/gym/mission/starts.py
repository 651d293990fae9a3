"""Random starts of Capture, Extract and Dock: poses of the tip near the place to which a step of the task leads."""

from __future__ import annotations

import numpy as np

from aftdeck.errors import AftdeckError, InputError
from aftdeck.frames import Pose, rotation_x, rotation_y, rotation_z
from aftdeck.gym.mission.definition import Mission, Spread
from aftdeck.matrices import product
from aftdeck.scenario.model import Scenario, Start
from aftdeck.scenario.target import AtBerth, AtPayload
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.frame import Frame
from aftdeck.task.places import Places


def step_of(mission: Mission, scenario: Scenario) -> TaskStep:
    """Return the first step of a scenario's task that an environment flies.

    Raises:
        InputError: there is none; the message lists the steps.
    """
    for step in scenario.steps:
        if mission.is_step(step):
            return step
    titles = ", ".join(repr(step.title) for step in scenario.steps) or "none"
    raise InputError(f"scenario: {scenario.name!r} has no step for {mission.name}; its steps are {titles}")


def base_of(scenario: Scenario, step: TaskStep) -> Start:
    """Return initial conditions of a scenario in which the end effector holds what the step needs.

    Raises:
        InputError: the step needs a held payload, and no initial conditions give one.
    """
    if isinstance(step.target, AtPayload):
        return scenario.start
    for start in (scenario.start, *scenario.parts.values()):
        if start.grasped is not None:
            return start
    raise InputError(
        f"scenario: {scenario.name!r} has no start with a held payload; give `grasped` in [initial] or [initialise.*]"
    )


class Starts:
    """Random starts around the place of a step's target, relative to a frame of the run."""

    def __init__(self, scenario: Scenario, step: TaskStep, base: Start, spread: Spread, frame: Frame) -> None:
        self._step, self._base, self._spread, self._frame = step, base, spread, frame
        model = scenario.arm.model
        self._arm = scenario.arm if base.stand == float(model.links[0]) else scenario.arm.at(stand=base.stand)
        self._places = Places(scenario)
        target = step.target
        self._mouth = self._places.berths[target.berth].mouth if isinstance(target, AtBerth) else 0.0

    def draw(self, random: np.random.Generator) -> Start | None:
        """Return random initial conditions; None if the arm cannot reach them."""
        away = self._mouth + float(random.uniform(self._spread.least, self._spread.greatest))
        across = random.uniform(-self._spread.across, self._spread.across, 2).tolist()
        turn = random.uniform(-self._spread.turn, self._spread.turn, 3).tolist()
        pose = self._places.target(self._frame, self._target(away, across))
        assert pose is not None, "`base_of` gives a held payload to a step that needs one"
        small = product(product(rotation_x(turn[0]), rotation_y(turn[1])), rotation_z(turn[2]))
        try:
            turned = product(np.array(pose.orientation), small)
            angles = self._arm.inverse(Pose(np.array(pose.position), turned), near=self._base.angles)[0]
        except AftdeckError:
            return None
        return Start(angles, np.zeros(len(angles)), self._base.stand, self._base.grasped)

    def _target(self, away: float, across: list[float]) -> AtPayload | AtBerth:
        """Return the step's target, displaced along the way out and across it."""
        a, b = across
        match self._step.target:
            case AtPayload(payload=k):
                return AtPayload(k, away, (a, b, 0.0))
            case AtBerth(berth=name):
                out = self._places.berths[name].out
                return AtBerth(name, away, (0.0, a, b) if out == 0 else (a, b, 0.0))
            case _:
                raise AssertionError("`step_of` chooses steps with a target at a payload or a berth")
