"""Environment that flies one step of a scenario's task in a `Simulation`, through `Inputs` as a person does."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from aftdeck.errors import InputError
from aftdeck.export.pictures import Pixels
from aftdeck.gym.actions import checked, clipped
from aftdeck.gym.choices import no_options
from aftdeck.gym.mission import definition
from aftdeck.gym.mission.actions import Rate, inputs_of
from aftdeck.gym.mission.definition import CAPTURE, DOCK, EXTRACT, Mission
from aftdeck.gym.mission.episode import started
from aftdeck.gym.mission.score import CONTACT, SCORED, reward
from aftdeck.gym.mission.task import MissionTask
from aftdeck.gym.picture import HEIGHT, MODES, WIDTH, Pictures
from aftdeck.gym.shown import ShownEnv
from aftdeck.gym.terms import Floats32, action_space
from aftdeck.scenario.model import Start
from aftdeck.scenario.schema import Plant
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.task.reached import Since
from aftdeck.task.remaining import Remaining
from aftdeck.visual.picture import Look


class MissionEnv(ShownEnv):
    """One step of a scenario's task, from a random start near the place to which it leads.

    A step of the environment makes several control steps with the same sticks. ``info["is_success"]`` tells in every
    step whether the task is complete.

    Args:
        scenario: name of a built-in scenario, or path of a scenario file, whose task has a step of this kind.
        plant: ``kinematic``, ``rigid`` or ``flexible``.
        render_mode: ``rgb_array``: `render` returns the picture of a camera. ``human``: pages of the station show the
            episode, in real time. None: neither.
        clip_actions: whether a stick or a switch beyond [-1, 1] is set to the end of its travel; otherwise it is
            rejected.
        camera: camera of `render`; None for a usual one.
        look: look of its pictures: ``colour``, or ``1972`` for greys and raster lines.
        width: width of its pictures [pixels].
        height: height of its pictures [pixels].

    Attributes:
        start: random start of the present episode; None before the first.
        stepped: function that is called with the simulation after each control step of `step`; None for none.

    Raises:
        InputError: an argument is not allowed, or the scenario has no such step; the message states what is allowed.
        ScenarioError: there is no such scenario, or its file has errors.
    """

    # Gymnasium declares it as a variable of the instance
    metadata = {"render_modes": list(MODES), "render_fps": round(1.0 / definition.PERIOD)}  # noqa: RUF012
    mission: ClassVar[Mission]

    def __init__(
        self,
        scenario: str | Path | None = None,
        plant: Plant = "kinematic",
        render_mode: str | None = None,
        *,
        clip_actions: bool = False,
        camera: str | None = None,
        look: Look = "colour",
        width: int = WIDTH,
        height: int = HEIGHT,
    ) -> None:
        super().__init__(render_mode)
        self._clips = clip_actions
        self._task = MissionTask(self.mission, scenario, plant)
        self._sim, self._observer = self._task.simulation(), self._task.observer
        self.observation_space, self.action_space = self._observer.space, action_space(self.mission.controls)
        self._since: Since | None = None
        self._scored = np.zeros(SCORED)
        self._rate: Rate = "coarse"
        self.start: Start | None = None
        self.stepped: Callable[[Simulation], None] | None = None
        self._pictures: Pictures | None = None
        if self.render_mode == "rgb_array":
            loaded = self._task.scenario
            self._pictures = Pictures(loaded, camera, self.mission.cameras[:1], look, width, height)

    @property
    def simulation(self) -> Simulation:
        """Simulation of the present episode."""
        return self._sim

    @property
    def task_step(self) -> TaskStep:
        """Step of the scenario's task that is flown."""
        return self._task.step

    @property
    def left(self) -> Remaining | None:
        """Remaining motion to the place of the task; None if there is no place to move to."""
        return self._task.aims.remaining(self._sim.look(), self._task.step)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Floats32, dict[str, Any]]:
        """Begin an episode at a random start; `options` has no keys.

        Raises:
            InputError: there are options, or no random start is free of contacts.
        """
        super().reset(seed=seed)
        no_options(options)
        self.start, self._since, observation, self._scored = self._task.begin(self._sim, self.np_random)
        self._rate = "coarse"
        if self.station is not None:
            self.station.begin(started(self._sim.scenario, self.start, self._task.step))
            self.station.step(self._task.first)
        return observation, {"is_success": False}

    def step(self, action: Floats32) -> tuple[Floats32, float, bool, bool, dict[str, Any]]:
        """Make one step.

        Args:
            action: one number in [-1, 1] for each control.

        Raises:
            InputError: the action has another shape, or a control is not a number in [-1, 1]; nothing has changed.
            SimulationError: the state is no longer finite.
        """
        if self._since is None:
            raise InputError("step: got a call before the first reset, expected reset() first")
        values = checked(clipped(action) if self._clips else action, self.mission.controls)
        inputs = inputs_of(self.mission, values, self._rate)
        self._rate = inputs.rate or self._rate
        if self.station is None and self.stepped is None:
            self._sim.hold(inputs, self._task.repeats)
        else:
            self._each(inputs)
        before = self._scored
        observation, self._scored = self._observer.of(self._sim)
        success = self._task.may_be_complete(self._sim, self._scored) and self._task.is_complete(
            self._sim, self._since, self._scored
        )
        over = success or bool(self.mission.contact_ends and self._scored[CONTACT])
        return observation, reward(before, self._scored, float(success)), over, False, {"is_success": success}

    def _each(self, inputs: Inputs) -> None:
        """Make the control steps of a step, and show each of them."""
        for _ in range(self._task.repeats):
            self._sim.advance(inputs)
            if self.station is not None:
                self.station.step(inputs)
            if self.stepped is not None:
                self.stepped(self._sim)

    def _picture(self) -> Pixels:
        assert self._pictures is not None, "the mode is rgb_array"
        return self._pictures.draw(self._sim.look())


class CaptureEnv(MissionEnv):
    """Capture the payload in the bay; the end effector is above its fixture."""

    mission = CAPTURE


class ExtractEnv(MissionEnv):
    """Lift the held payload out of its berth, without a detrimental contact."""

    mission = EXTRACT


class DockEnv(MissionEnv):
    """Bring the held payload from in front of the docking port into the port."""

    mission = DOCK
