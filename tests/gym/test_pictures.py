"""Pictures of the environments: ``render_mode="rgb_array"``."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
import pytest

import aftdeck.gym  # noqa: F401  (registers the environments)
from aftdeck.errors import InputError
from aftdeck.export.pictures import Pixels
from aftdeck.gym.mission.env import CaptureEnv, DockEnv
from aftdeck.gym.reach.single import ReachEnv

SMALL: dict[str, Any] = {"width": 64, "height": 48}
ALL = ("Reach", "Capture", "Extract", "Dock")


def made(name: str, mode: str = "rgb_array", **keywords: Any) -> gymnasium.Env[Any, Any]:
    env = gymnasium.make(f"aftdeck/{name}-v0", render_mode=mode, **SMALL, **keywords)
    env.reset(seed=0)
    return env


def picture(env: gymnasium.Env[Any, Any]) -> Pixels:
    drawn = env.render()
    assert isinstance(drawn, np.ndarray)
    return drawn


@pytest.mark.parametrize("name", ALL)
def test_picture_shows_the_episode_in_both_looks(name: str) -> None:
    env, old = made(name), made(name, look="1972")
    first = picture(env)
    assert first.shape == (48, 64, 3) and first.dtype == np.uint8 and first.flags.writeable
    assert np.array_equal(first, picture(env)) and not np.shares_memory(first, picture(env))
    grey = picture(old)
    assert (np.ptp(grey.astype(int), axis=2) == 0).all() and np.ptp(grey) > 50
    for _ in range(10):
        env.step(np.full(env.action_space.shape or (), 0.3, dtype=np.float32))
    assert not np.array_equal(first, picture(env))


def test_camera_is_chosen_by_name_and_a_usual_one_exists_in_every_scenario() -> None:
    assert not np.array_equal(picture(made("Dock")), picture(made("Dock", camera="C")))
    own = CaptureEnv("concept-1972", render_mode="rgb_array", **SMALL)  # without the camera of the tutorial
    own.reset(seed=0)
    drawn = own.render()
    assert drawn is not None and np.ptp(drawn) > 100


def test_goal_and_tip_of_reach_are_marked_where_they_are() -> None:
    """The goal's first axis begins at its place in the picture, computed here by the camera's own numbers."""
    env = ReachEnv(render_mode="rgb_array", width=640, height=480)
    env.reset(seed=2)
    drawn, (_, goal) = env.render(), env._reach.now()
    assert drawn is not None and env._pictures is not None
    poses = env._pictures._pictures._placed.poses
    away = np.array(poses.point(goal.position.tolist())) - [-21.0, 20.0, 13.5]
    ahead = np.array([0.61, -0.705, -0.27])
    ahead /= np.linalg.norm(ahead)
    right = np.cross(ahead, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    scale = 320.0 / np.tan(np.radians(15.0)) / (away @ ahead)
    x, y = 320.0 + scale * (away @ right), 240.0 + scale * (away @ np.cross(ahead, right))
    near = drawn[round(y) - 3 : round(y) + 4, round(x) - 3 : round(x) + 4].reshape(-1, 3).tolist()
    assert any(colour in near for colour in ([255, 80, 70], [80, 220, 90], [90, 140, 255]))


def test_batch_draws_each_environment() -> None:
    batch: Any = gymnasium.make_vec("aftdeck/Reach-v0", num_envs=2, render_mode="rgb_array", **SMALL)
    batch.reset(seed=[4, 9])
    drawn = batch.render()
    assert drawn is not None and len(drawn) == 2
    for seed, one in zip((4, 9), drawn, strict=True):
        env = ReachEnv(render_mode="rgb_array", **SMALL)
        env.reset(seed=seed)
        assert np.array_equal(one, picture(env))


def test_sync_vector_draws_each_environment() -> None:
    both = gymnasium.make_vec("aftdeck/Dock-v0", num_envs=2, render_mode="rgb_array", **SMALL)
    both.reset(seed=0)
    drawn = both.render()
    assert drawn is not None
    assert np.array_equal(drawn[0], picture(made("Dock"))) and not np.array_equal(drawn[0], drawn[1])


def test_wrappers_of_gymnasium_collect_and_observe_pictures() -> None:
    collected: Any = made("Extract", "rgb_array_list")
    collected.step(np.zeros(7, dtype=np.float32))
    assert [one.shape for one in collected.render()] == [(48, 64, 3)] * 2
    observed = gymnasium.wrappers.AddRenderObservation(made("Extract"))
    assert observed.reset(seed=0)[0] in observed.observation_space
    assert observed.metadata["render_fps"] == 10


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ({"render_mode": "ansi"}, "render_mode: got 'ansi', expected 'rgb_array', 'human'"),
        ({"camera": "Q"}, "camera: of 'concept-1972': got 'Q', expected 'A', 'B'"),
        ({"look": "shiny"}, "look: got 'shiny', expected 'colour', '1972'"),
        ({"width": 8}, "width: got 8, expected a whole number, 16 or more"),
        ({"height": 5000}, "height: got 5000, expected 16 to 2048 pixels"),
    ],
)
def test_unusable_keyword_values_are_rejected(keywords: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        DockEnv(**({"render_mode": "rgb_array"} | keywords))


def test_render_without_a_mode_is_rejected() -> None:
    for env in (DockEnv(), ReachEnv(), gymnasium.make_vec("aftdeck/Reach-v0")):
        env.reset(seed=0)
        with pytest.raises(InputError, match="made without pictures; make it with render_mode='rgb_array'"):
            env.render()
