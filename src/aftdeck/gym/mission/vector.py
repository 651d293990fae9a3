"""Batches of Capture, Extract and Dock as vector environments of Gymnasium."""

from __future__ import annotations

from pathlib import Path
from typing import ClassVar

from gymnasium.vector import AutoresetMode

from aftdeck.export.pictures import Pixels
from aftdeck.gym.batch_env import BatchEnv
from aftdeck.gym.choices import not_rendered, whole
from aftdeck.gym.mission import definition
from aftdeck.gym.mission.batch import MissionBatch
from aftdeck.gym.mission.definition import CAPTURE, DOCK, EXTRACT, Mission
from aftdeck.gym.mission.task import MissionTask
from aftdeck.gym.picture import HEIGHT, WIDTH, Pictures
from aftdeck.gym.terms import action_space
from aftdeck.scenario.schema import Plant
from aftdeck.visual.picture import Look


class MissionVectorEnv(BatchEnv):
    """Capture, Extract or Dock on the kinematic plant, many environments that make their steps together.

    Args:
        num_envs: number of environments.
        max_episode_steps: number of steps after which an episode is truncated; None for the usual one.
        autoreset_mode: when an environment whose episode has ended is reset. NEXT_STEP: the next step ignores its
            action, and resets it with the reward 0. SAME_STEP: at once; ``infos["final_obs"]`` has the last
            observation. DISABLED: the caller resets it, with ``options={"reset_mask": mask}``.
        scenario: name of a built-in scenario, or path of a scenario file, whose task has a step of this kind.
        plant: only ``kinematic``; with masses use ``vectorization_mode="sync"`` or ``"async"``.
        render_mode: ``rgb_array``: `render` returns a picture of each environment. None: it returns none.
        clip_actions: whether a stick or a switch beyond [-1, 1] is set to the end of its travel; otherwise it is
            rejected.
        camera: camera of `render`; None for a usual one.
        look: look of its pictures: ``colour``, or ``1972`` for greys and raster lines.
        width: width of its pictures [pixels].
        height: height of its pictures [pixels].

    Raises:
        InputError: an argument is not allowed, or the scenario has no such step; the message states what is allowed.
        ScenarioError: there is no such scenario, or its file has errors.
    """

    metadata = {  # noqa: RUF012  (Gymnasium declares it as a variable of the instance)
        "render_modes": ["rgb_array"],
        "render_fps": round(1.0 / definition.PERIOD),
        "autoreset_mode": AutoresetMode.NEXT_STEP,
    }
    mission: ClassVar[Mission]

    def __init__(
        self,
        num_envs: int = 1,
        max_episode_steps: int | None = None,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
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
        self.choose(num_envs, autoreset_mode, plant, render_mode, clip_actions)
        most = self.mission.most_steps if max_episode_steps is None else max_episode_steps
        task = MissionTask(self.mission, scenario, "kinematic")
        self._missions = MissionBatch(task, self.num_envs, whole("max_episode_steps", most, 1))
        self.prepare(self._missions, task.observer.space, action_space(self.mission.controls))
        self._pictures: Pictures | None = None
        if self.render_mode is not None:
            self._pictures = Pictures(task.scenario, camera, self.mission.cameras[:1], look, width, height)

    def render(self) -> tuple[Pixels, ...]:
        """Return the picture (height, width, 3) of each environment.

        Raises:
            InputError: the environments were made without pictures.
        """
        if self._pictures is None:
            raise not_rendered()
        return tuple(self._pictures.draw(self._missions.simulation(i).look()) for i in range(self.num_envs))


class CaptureVectorEnv(MissionVectorEnv):
    """Many environments of Capture."""

    mission = CAPTURE


class ExtractVectorEnv(MissionVectorEnv):
    """Many environments of Extract."""

    mission = EXTRACT


class DockVectorEnv(MissionVectorEnv):
    """Many environments of Dock."""

    mission = DOCK
