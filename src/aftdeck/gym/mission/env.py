"""Environment that flies one step of a scenario's task in a `Simulation`, through `Inputs` as a person does."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import Any, ClassVar

from aftdeck.errors import InputError, ScenarioError
from aftdeck.export.pictures import Pixels
from aftdeck.files import Where
from aftdeck.gym.actions import checked, clipped
from aftdeck.gym.choices import PLANTS, no_options, one_of
from aftdeck.gym.mission import definition
from aftdeck.gym.mission.actions import Rate, inputs_of, repeats_of
from aftdeck.gym.mission.definition import CAPTURE, DOCK, EXTRACT, Mission
from aftdeck.gym.mission.episode import started
from aftdeck.gym.mission.observation import Observer, Scored, may_be_done
from aftdeck.gym.mission.starts import Starts, base_of, step_of
from aftdeck.gym.picture import HEIGHT, MODES, WIDTH, Pictures
from aftdeck.gym.shown import ShownEnv
from aftdeck.gym.terms import Floats32, action_space
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario, Start
from aftdeck.scenario.schema import Plant
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.task.reached import Since, reached
from aftdeck.task.remaining import Aims, Remaining
from aftdeck.visual.picture import Look

_TRIES = 100
"""Greatest number of random starts that are tried until one has no contact."""


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
        one_of("plant", plant, PLANTS)
        loaded = _built_in(self.mission.scenario, plant) if scenario is None else _loaded(scenario, plant)
        self._repeats = repeats_of(loaded)
        self._step = step_of(self.mission, loaded)
        base = base_of(loaded, self._step)
        self._sim, self._aims = Simulation(loaded, digests=False), Aims(loaded)
        self._sim.restart(base)
        frame = self._sim.step(self._first_inputs())
        self._starts = Starts(loaded, self._step, base, self.mission.spread, frame)
        self._observer = Observer(loaded, self._step, frame)
        self.observation_space, self.action_space = self._observer.space, action_space(self.mission.controls)
        self._since = Since(frame.position, frame.orientation)
        self._scored: Scored | None = None
        self._begun = False
        self._rate: Rate = "coarse"
        self.start: Start | None = None
        self.stepped: Callable[[Simulation], None] | None = None
        self._pictures: Pictures | None = None
        if self.render_mode == "rgb_array":
            self._pictures = Pictures(loaded, camera, self.mission.cameras[:1], look, width, height)

    @property
    def simulation(self) -> Simulation:
        """Simulation of the present episode."""
        return self._sim

    @property
    def task_step(self) -> TaskStep:
        """Step of the scenario's task that is flown."""
        return self._step

    @property
    def left(self) -> Remaining | None:
        """Remaining motion to the place of the task; None if there is no place to move to."""
        return self._aims.remaining(self._sim.look(), self._step)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Floats32, dict[str, Any]]:
        """Begin an episode at a random start; `options` has no keys.

        Raises:
            InputError: there are options, or no random start is free of contacts.
        """
        super().reset(seed=seed)
        no_options(options)
        frame = self._begin()
        self._since = Since(frame.position, frame.orientation)
        observation, self._scored = self._observer.of(self._sim)
        self._begun, self._rate = True, "coarse"
        if self.station is not None and self.start is not None:
            self.station.begin(started(self._sim.scenario, self.start, self._step))
            self.station.step(self._first_inputs())
        return observation, {"is_success": False}

    def step(self, action: Floats32) -> tuple[Floats32, float, bool, bool, dict[str, Any]]:
        """Make one step.

        Args:
            action: one number in [-1, 1] for each control.

        Raises:
            InputError: the action has another shape, or a control is not a number in [-1, 1]; nothing has changed.
            SimulationError: the state is no longer finite.
        """
        if not self._begun:
            raise InputError("step: got a call before the first reset, expected reset() first")
        values = checked(clipped(action) if self._clips else action, self.mission.controls)
        inputs = inputs_of(self.mission, values, self._rate)
        self._rate = inputs.rate or self._rate
        if self.station is None and self.stepped is None:
            self._sim.hold(inputs, self._repeats)
        else:
            self._each(inputs)
        before = self._scored
        observation, self._scored = self._observer.of(self._sim)
        success = self._succeeds(self._scored)
        over = success or (self._scored.contact and self.mission.contact_ends)
        return observation, _reward(before, self._scored, success), over, False, {"is_success": success}

    def _succeeds(self, scored: Scored) -> bool:
        """Return whether the last step has completed the task."""
        if not may_be_done(self._step.done, self._sim.parts[1].worksite, scored):
            return False
        done = reached(self._aims, self._step, self._step.done, self._sim.look(), self._since)
        return done and not (scored.contact and self.mission.contact_ends)

    def _each(self, inputs: Inputs) -> None:
        """Make the control steps of a step, and show each of them."""
        for _ in range(self._repeats):
            self._sim.advance(inputs)
            if self.station is not None:
                self.station.step(inputs)
            if self.stepped is not None:
                self.stepped(self._sim)

    def _picture(self) -> Pixels:
        assert self._pictures is not None, "the mode is rgb_array"
        return self._pictures.draw(self._sim.look())

    def _begin(self) -> Frame:
        """Restart the simulation at a random start without a contact, and return its first frame."""
        for _ in range(_TRIES):
            start = self._starts.draw(self.np_random)
            if start is None:
                continue
            try:
                self._sim.restart(start)
            except ScenarioError:
                continue
            frame = self._sim.step(self._first_inputs())
            if not frame.work.contacts or not _detrimental(frame):
                self.start = start
                return frame
        raise InputError(
            f"scenario: {self._sim.scenario.name!r} has no start without a contact in {_TRIES} random starts near the "
            f"place of step {self._step.title!r}"
        )

    def _first_inputs(self) -> Inputs:
        """Return the inputs of the first control step: sticks centred, mode of the task's step, rate setting coarse."""
        return Inputs(mode=self._step.mode, rate="coarse")


def _loaded(scenario: str | Path, plant: Plant) -> Scenario:
    changes: dict[Where, object] = {("plant",): plant}
    return load_scenario(scenario, changes)


@lru_cache(maxsize=4)
def _built_in(name: str, plant: Plant) -> Scenario:
    """Return a built-in scenario, the same for all environments of a process: its picture takes seconds to prepare."""
    return _loaded(name, plant)


def _detrimental(frame: Frame) -> bool:
    """Return whether a detrimental contact exists."""
    return any(not contact.essential for contact in frame.work.contacts)


def _reward(before: Scored | None, after: Scored, success: bool) -> float:
    """Return the reward of a step, from the motion that was left and that is left."""
    reward = definition.TIME.weight * definition.PERIOD + definition.SUCCESS.weight * success
    reward += definition.CONTACT.weight * definition.PERIOD * after.contact
    if before is not None and before.aims and after.aims:
        reward += definition.DISTANCE.weight * (before.distance - after.distance)
        reward += definition.ROTATION.weight * (before.angle - after.angle)
    return reward


class CaptureEnv(MissionEnv):
    """Capture the payload in the bay; the end effector is above its fixture."""

    mission = CAPTURE


class ExtractEnv(MissionEnv):
    """Lift the held payload out of its berth, without a detrimental contact."""

    mission = EXTRACT


class DockEnv(MissionEnv):
    """Bring the held payload from in front of the docking port into the port."""

    mission = DOCK
