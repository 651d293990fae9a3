"""Single Reach environment: a batch of one on the kinematic plant, or a simulation on a plant with masses."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.export.pictures import Pixels
from aftdeck.frames import Pose
from aftdeck.gym.actions import checked, clipped
from aftdeck.gym.batch_step import DISABLED
from aftdeck.gym.choices import PLANTS, no_options, one_of
from aftdeck.gym.picture import HEIGHT, MODES, WIDTH
from aftdeck.gym.reach import definition
from aftdeck.gym.reach.batch import ReachBatch
from aftdeck.gym.reach.goals import episode_scenario
from aftdeck.gym.reach.picture import ReachPictures
from aftdeck.gym.reach.simulated import SimulatedReach
from aftdeck.gym.shown import ShownEnv
from aftdeck.gym.terms import Floats32, action_space, observation_space
from aftdeck.scenario.schema import Plant
from aftdeck.simulation.inputs import Inputs
from aftdeck.visual.picture import Look


class Reach(Protocol):
    """One environment, on any plant."""

    def begin(self, key: int | None) -> Floats32:
        """Begin an episode and return the observation (24,); a key begins with episode 0, None with the next one."""

    def step(self, action: object) -> tuple[Floats32, float, bool]:
        """Make one step with the sticks (6,); return the observation, the reward, and whether the goal is reached."""

    def now(self) -> tuple[Array, Pose]:
        """Return the joint angles (6,) [rad], and the pose in L that the tip has to reach."""


def row(observations: Floats32) -> Floats32:
    """Return the observation of the only environment of a batch."""
    return observations.reshape(-1)


class KinematicReach:
    """The compiled batch with one environment."""

    def __init__(self) -> None:
        self._batch, self._all = ReachBatch(1), np.ones(1, dtype=np.bool_)

    def begin(self, key: int | None) -> Floats32:
        """As in `Reach`."""
        self._batch.seed([key])
        return row(self._batch.begin(self._all))

    def step(self, action: object) -> tuple[Floats32, float, bool]:
        """As in `Reach`."""
        done = self._batch.step(action, DISABLED)
        return row(done.observations), float(done.rewards[0]), bool(done.terminated[0])

    def now(self) -> tuple[Array, Pose]:
        """As in `Reach`."""
        return self._batch.angles()[0], self._batch.goals()[0]


class ReachEnv(ShownEnv):
    """Move the tip of the Shuttle's arm to a random pose with the hand controllers, in the mode ORB UNL.

    Args:
        plant: ``kinematic``, ``rigid`` or ``flexible``.
        render_mode: ``rgb_array``: `render` returns the picture of a camera, with the axes of goal and tip. ``human``:
            pages of the station show the episode, in real time. None: neither.
        clip_actions: whether a stick beyond [-1, 1] is set to the end of its travel; otherwise it is rejected.
        camera: camera of `render`; None for the engineering view.
        look: look of its pictures: ``colour``, or ``1972`` for greys and raster lines.
        width: width of its pictures [pixels].
        height: height of its pictures [pixels].

    Raises:
        InputError: an argument is not allowed; the message states the allowed values.
    """

    # Gymnasium declares it as a variable of the instance
    metadata = {"render_modes": list(MODES), "render_fps": 1.0 / definition.PERIOD}  # noqa: RUF012

    def __init__(
        self,
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
        self.observation_space = observation_space(definition.OBSERVATIONS)
        self.action_space = action_space(definition.CONTROLS)
        self._plant = one_of("plant", plant, PLANTS)
        self._reach: Reach = KinematicReach() if self._plant == "kinematic" else SimulatedReach(self._plant)
        self._begun = False
        self._pictures: ReachPictures | None = None
        if self.render_mode == "rgb_array":
            self._pictures = ReachPictures(camera, look, width, height)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Floats32, dict[str, Any]]:
        """Begin an episode; with a seed, begin the episodes of this seed again. `options` has no keys."""
        super().reset(seed=seed)
        no_options(options)
        key = self.np_random_seed if seed is not None or not self._begun else None
        self._begun = True
        observation = self._reach.begin(key)
        if self.station is not None:
            self.station.begin(episode_scenario(*self._reach.now(), self._plant))
        return observation, {"is_success": False}

    def step(self, action: Floats32) -> tuple[Floats32, float, bool, bool, dict[str, Any]]:
        """Make one step with the sticks (6,), each in [-1, 1].

        Raises:
            InputError: the action has another shape, or a stick is not a number in [-1, 1]; nothing has changed.
        """
        if not self._begun:
            raise InputError("step: got a call before the first reset, expected reset() first")
        sticks = clipped(action) if self._clips else action
        observation, reward, reached = self._reach.step(sticks)
        if self.station is not None:
            x, y, z, roll, pitch, yaw = checked(sticks, definition.CONTROLS)
            self.station.step(Inputs(translation=(x, y, z), rotation=(roll, pitch, yaw)))
        return observation, reward, reached, False, {"is_success": reached}

    def _picture(self) -> Pixels:
        assert self._pictures is not None, "the mode is rgb_array"
        return self._pictures.at(*self._reach.now())
