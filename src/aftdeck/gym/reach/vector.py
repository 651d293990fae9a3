"""Batch of Reach environments as one compiled vector environment of Gymnasium."""

from __future__ import annotations

from gymnasium.vector import AutoresetMode

from aftdeck.export.pictures import Pixels
from aftdeck.gym.batch_env import BatchEnv
from aftdeck.gym.choices import not_rendered, whole
from aftdeck.gym.picture import HEIGHT, WIDTH
from aftdeck.gym.reach import definition
from aftdeck.gym.reach.batch import ReachBatch
from aftdeck.gym.reach.picture import ReachPictures
from aftdeck.gym.terms import action_space, observation_space
from aftdeck.scenario.schema import Plant
from aftdeck.visual.picture import Look


class ReachVectorEnv(BatchEnv):
    """Reach on the kinematic plant, many environments in one compiled call.

    Environment i of a batch equals the single environment with the seed `seed + i`, bit for bit. All arrays that a
    call returns are new. ``infos["is_success"]`` tells in every step which environments reached their goal in it.

    Args:
        num_envs: number of environments.
        max_episode_steps: number of steps after which an episode is truncated.
        autoreset_mode: when an environment whose episode has ended is reset. NEXT_STEP: the next step ignores its
            action, and resets it with the reward 0. SAME_STEP: at once; ``infos["final_obs"]`` has the last
            observation. DISABLED: the caller resets it, with ``options={"reset_mask": mask}``.
        plant: only ``kinematic``; with masses use ``vectorization_mode="sync"`` or ``"async"``.
        render_mode: ``rgb_array``: `render` returns a picture of each environment. None: it returns none.
        clip_actions: whether a stick beyond [-1, 1] is set to the end of its travel; otherwise it is rejected.
        camera: camera of `render`; None for the engineering view.
        look: look of its pictures: ``colour``, or ``1972`` for greys and raster lines.
        width: width of its pictures [pixels].
        height: height of its pictures [pixels].

    Raises:
        InputError: an argument is not allowed; the message states the allowed values.
    """

    metadata = {  # noqa: RUF012  (Gymnasium declares it as a variable of the instance)
        "render_modes": ["rgb_array"],
        "render_fps": 1.0 / definition.PERIOD,
        "autoreset_mode": AutoresetMode.NEXT_STEP,
    }

    def __init__(
        self,
        num_envs: int = 1,
        max_episode_steps: int = definition.MOST_STEPS,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
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
        batch = ReachBatch(self.num_envs, whole("max_episode_steps", max_episode_steps, 1))
        self.prepare(batch, observation_space(definition.OBSERVATIONS), action_space(definition.CONTROLS))
        self._places = batch
        self._pictures = ReachPictures(camera, look, width, height) if self.render_mode else None

    def render(self) -> tuple[Pixels, ...]:
        """Return the picture (height, width, 3) of each environment.

        Raises:
            InputError: the environments were made without pictures.
        """
        if self._pictures is None:
            raise not_rendered()
        places = zip(self._places.angles(), self._places.goals(), strict=True)
        return tuple(self._pictures.at(angles, goal) for angles, goal in places)
