"""LeRobot's contract of an environment: ``make_env``, pictures of cameras, and the state and actions of a dataset.

A file ``env.py`` with ``from aftdeck.gym.lerobot import make_env`` is a complete environment of LeRobot's EnvHub. Only
Gymnasium is needed here, not LeRobot itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.vector import AsyncVectorEnv, AutoresetMode, SyncVectorEnv

from aftdeck.errors import InputError
from aftdeck.export.pictures import SIZE, Painter, Pixels, names_of
from aftdeck.export.plan import STICKS
from aftdeck.export.state import StateReader
from aftdeck.gym.choices import one_of, whole
from aftdeck.gym.mission import definition
from aftdeck.gym.mission.env import CaptureEnv, DockEnv, ExtractEnv, MissionEnv
from aftdeck.gym.terms import Floats32, action_space
from aftdeck.scenario.light import condition_named
from aftdeck.scenario.schema import Plant

Observation = dict[str, Any]
"""Observation: ``pixels``, a picture (height, width, 3) of each camera by its name, and ``agent_pos``, the state."""

Vector = SyncVectorEnv | AsyncVectorEnv
"""Vector environment, in one process or in several."""
TASKS: dict[str, type[MissionEnv]] = {env.mission.name: env for env in (CaptureEnv, ExtractEnv, DockEnv)}
"""Environments by their names. Reach is not one of them: no picture shows its goal."""
COLUMNS = (*STICKS, "rate", "effector")
"""Columns of the actions; only Capture has the last one."""

_LIMIT = 1000.0
"""Greatest magnitude of a number of the state; assumed: the arm is 15 m long."""


class LerobotEnv(gymnasium.Env[Observation, Floats32]):
    """Capture, Extract or Dock with pictures.

    An action has the columns of `action_names`, as in an exported dataset. Beyond their travel, sticks and switches are
    at its end. The state is that of an exported dataset too.

    Args:
        task: ``Capture``, ``Extract`` or ``Dock``.
        cameras: cameras of the pictures; None for those of `Mission.cameras`, () for no pictures.
        size: width and height of a picture [pixels].
        scenario: name of a built-in scenario, or path of a scenario file; None for that of the environment.
        plant: ``kinematic``, ``rigid`` or ``flexible``.
        render_mode: ``rgb_array``; `render` returns the picture of the first camera.

    Attributes:
        task: name of the environment.
        task_description: the task, as a sentence.
        action_names: names of the numbers of an action.
        state_names: names of the numbers of the state.
        mission_env: the environment without pictures.

    Raises:
        InputError: an argument is not allowed; the message states what is allowed.
        ScenarioError: there is no such scenario, or its file has errors.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": round(1.0 / definition.PERIOD)}  # noqa: RUF012

    def __init__(
        self,
        task: str = "Capture",
        cameras: Sequence[str] | None = None,
        size: tuple[int, int] = SIZE,
        scenario: str | Path | None = None,
        plant: Plant = "kinematic",
        render_mode: str = "rgb_array",
    ) -> None:
        self.render_mode = one_of("render_mode", render_mode, ["rgb_array"])
        self.task = one_of("task", task, TASKS)
        self.mission_env = TASKS[self.task](scenario, plant, clip_actions=True)
        mission, flown = self.mission_env.mission, self.mission_env.simulation.scenario
        self.task_description = mission.task
        self._max_episode_steps = mission.most_steps
        pictures = names_of(mission.cameras if cameras is None else cameras)
        self._painter = Painter(flown, pictures, size)
        self._light = condition_named(flown.lighting.condition)
        self._reader, self._steps = StateReader(flown), 0
        self.state_names = self._reader.names
        self.action_names = COLUMNS[: len(mission.controls)]
        self.action_space = action_space(mission.controls)
        width, height = size
        pixels: dict[str, spaces.Space[Any]] = {
            name: spaces.Box(0, 255, (height, width, 3), np.uint8) for name in pictures
        }
        state = spaces.Box(-_LIMIT, _LIMIT, (len(self.state_names),), np.float32)
        self.observation_space = spaces.Dict({"agent_pos": state} | ({"pixels": spaces.Dict(pixels)} if pixels else {}))

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Begin an episode at a random start; `options` has no keys."""
        super().reset(seed=seed)
        _, info = self.mission_env.reset(seed=seed, options=options)
        self._steps = 0
        return self._observed(), info | {"task": self.task}

    def step(self, action: Floats32) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Make one step of 0.1 s.

        Args:
            action: one number for each of `action_names`.

        Raises:
            InputError: the action has another shape, or is not finite.
        """
        _, reward, over, _, info = self.mission_env.step(action)
        self._steps += 1
        late = not over and self._steps >= self._max_episode_steps
        return self._observed(), reward, over, late, info | {"task": self.task}

    def render(self) -> Pixels:
        """Return the picture (height, width, 3) of the first camera.

        Raises:
            InputError: the environment has no camera.
        """
        drawn = self._pictures()
        if not drawn:
            raise InputError("render: the environment has no camera; name one in `cameras`")
        return next(iter(drawn.values()))

    def _pictures(self) -> dict[str, Pixels]:
        return self._painter.draw(self.mission_env.simulation.look(), self._light)

    def _observed(self) -> Observation:
        state = self._reader.of(self.mission_env.simulation.look(), self.mission_env.left)
        drawn = self._pictures()
        return {"agent_pos": state} | ({"pixels": drawn} if drawn else {})


def make_env(n_envs: int = 1, use_async_envs: bool = False, cfg: object = None, **keywords: Any) -> Vector:
    """Return a vector environment, as LeRobot's EnvHub asks for.

    At its end, an episode begins again in the same step; ``infos["final_info"]["is_success"]`` then tells its result.

    Args:
        n_envs: number of environments.
        use_async_envs: whether each runs in a process of its own.
        cfg: LeRobot's configuration; its ``task``, if given, names the environment, unless `keywords` does.
        keywords: arguments of `LerobotEnv`.

    Raises:
        InputError: an argument is not allowed; the message states what is allowed.
    """
    count = whole("n_envs", n_envs, 1)
    named = getattr(cfg, "task", None)
    chosen = ({} if named is None else {"task": named}) | keywords
    kind = AsyncVectorEnv if use_async_envs else SyncVectorEnv
    return kind([partial(LerobotEnv, **chosen)] * count, autoreset_mode=AutoresetMode.SAME_STEP)
