"""LeRobot's contract of an environment."""

from __future__ import annotations

from collections.abc import Iterator
from types import SimpleNamespace

import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

from aftdeck.errors import InputError
from aftdeck.export.columns import Encoding
from aftdeck.export.state import StateReader
from aftdeck.gym.lerobot import TASKS, LerobotEnv, Vector, make_env
from aftdeck.gym.mission.actions import Rate, inputs_of

SMALL = (32, 24)


@pytest.mark.parametrize("task", TASKS)
def test_environment_passes_gymnasiums_checker(task: str) -> None:
    check_env(LerobotEnv(task, size=SMALL), skip_render_check=True)


@pytest.fixture
def batch() -> Iterator[Vector]:
    env = make_env(n_envs=2, size=SMALL)
    yield env
    env.close()


def test_batch_has_pictures_state_task_and_success_in_every_step(batch: Vector) -> None:
    seen, info = batch.reset(seed=4)
    for _ in range(3):
        assert {name: (one.shape, one.dtype) for name, one in seen["pixels"].items()} == dict.fromkeys(
            ("wr", "elb"), ((2, 24, 32, 3), np.dtype(np.uint8))
        )
        assert seen["agent_pos"].shape[0] == 2 and seen["agent_pos"].dtype == np.float32
        assert info["is_success"].tolist() == [False, False]
        seen, _, _, _, info = batch.step(np.zeros((2, 8), dtype=np.float32))
    assert all(text.startswith("Capture the payload") for text in batch.call("task_description"))
    assert batch.call("task") == ("Capture", "Capture")
    assert batch.call("_max_episode_steps") == (900, 900)
    assert batch.unwrapped.metadata["render_fps"] == 10
    assert [one.shape for one in batch.call("render")] == [(24, 32, 3)] * 2


def test_end_of_an_episode_tells_its_success_and_the_next_one_begins() -> None:
    env = make_env(n_envs=2, task="Extract", cameras=())
    env.set_attr("_max_episode_steps", [900, 2])
    env.reset(seed=0)
    still = np.zeros((2, 7), dtype=np.float32)
    env.step(still)
    _, _, _, truncated, info = env.step(still)
    assert truncated.tolist() == [False, True]
    assert info["final_info"]["is_success"].tolist() == [False, False]
    _, _, _, truncated, info = env.step(still)
    assert truncated.tolist() == [False, False] and "final_info" not in info
    env.close()


def test_state_and_columns_are_those_of_a_dataset() -> None:
    env = LerobotEnv(cameras=())
    seen, _ = env.reset(seed=2)
    sim = env.mission_env.simulation
    assert env.state_names == StateReader(sim.scenario).names
    assert seen["agent_pos"].tolist() == StateReader(sim.scenario).of(sim.look(), env.mission_env.left).tolist()
    encoding = Encoding(sim.cameras, len(sim.scenario.arm.joints))
    rng = np.random.default_rng(0)
    for action in rng.uniform(-1.0, 1.0, (50, len(env.action_names))):
        row = encoding.completed(env.action_names, action[None])[0].tolist()
        before: Rate = "vernier" if action[6] > 0.0 else "coarse"
        assert encoding.decode(row) == inputs_of(env.mission_env.mission, action.tolist(), before)


def test_action_beyond_the_travel_is_full_deflection() -> None:
    states = []
    for size in (1.0, 5.0):
        env = LerobotEnv(cameras=())
        env.reset(seed=1)
        env.step(np.full(8, size, dtype=np.float32))
        states.append(env.mission_env.simulation.seal())
    assert states[0] == states[1]
    with pytest.raises(InputError, match="THC X is nan"):
        env.step(np.full(8, np.nan, dtype=np.float32))


@pytest.mark.slow
@pytest.mark.long
def test_environments_in_processes_of_their_own_equal_those_in_one() -> None:
    states = []
    for apart in (False, True):
        env = make_env(n_envs=2, use_async_envs=apart, size=SMALL)
        env.reset(seed=5)
        seen = env.step(np.full((2, 8), 0.5, dtype=np.float32))[0]
        states.append((seen["agent_pos"].tolist(), seen["pixels"]["wr"].tolist()))
        env.close()
    assert states[0] == states[1]


def test_configuration_names_the_task() -> None:
    env = make_env(cfg=SimpleNamespace(task="Dock"), cameras=())
    assert env.call("task") == ("Dock",)
    env.close()


@pytest.mark.parametrize(
    ("keywords", "part"),
    [
        ({"task": "Reach"}, "task: got 'Reach', expected 'Capture', 'Extract', 'Dock'"),
        ({"n_envs": 0}, "n_envs: got 0"),
        ({"cameras": ["Q"]}, "no camera 'Q'; it has "),
        ({"render_mode": "human"}, "render_mode: got 'human'"),
    ],
)
def test_argument_that_is_not_allowed_is_rejected(keywords: dict[str, object], part: str) -> None:
    with pytest.raises(InputError, match=part):
        make_env(**keywords)  # type: ignore[arg-type]
