"""Reach: the single environment."""

from __future__ import annotations

import math

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import aftdeck.gym
from aftdeck.errors import InputError
from aftdeck.gym.reach import definition
from aftdeck.gym.reach.simulated import SimulatedReach
from aftdeck.gym.reach.single import KinematicReach, ReachEnv
from aftdeck.gym.terms import Floats32

STICKS = np.zeros(6, dtype=np.float32)


def towards(observation: Floats32) -> Floats32:
    """Return sticks in proportion to the remaining motion."""
    gains = np.array([2.0, 2.0, 2.0, 4.0, 4.0, 4.0], dtype=np.float32)
    sticks: Floats32 = np.clip(gains * observation[:6], -1.0, 1.0)
    return sticks


@pytest.mark.parametrize("plant", ["kinematic", "rigid"])
def test_environment_passes_gymnasiums_checker(plant: str) -> None:
    check_env(gymnasium.make("aftdeck/Reach-v0", plant=plant).unwrapped)


def test_compiled_environment_equals_a_simulation_with_the_same_sticks() -> None:
    compiled, simulated = KinematicReach(), SimulatedReach("kinematic")
    rng = np.random.default_rng(0)
    for key in (5, None):
        assert (compiled.begin(key) == simulated.begin(key)).all()
        sticks = STICKS
        for step in range(200):
            if step % 20 == 0:
                sticks = rng.uniform(-1.0, 1.0, 6).astype(np.float32)
            (seen, reward, reached), (other, reward_2, reached_2) = compiled.step(sticks), simulated.step(sticks)
            assert (seen == other).all()
            assert reached == reached_2
            assert reward == pytest.approx(reward_2, abs=1e-12)


@pytest.mark.parametrize("plant", ["kinematic", "rigid"])
def test_sticks_in_proportion_to_the_motion_left_reach_the_goal(plant: str) -> None:
    env = gymnasium.make("aftdeck/Reach-v0", plant=plant)
    observation, info = env.reset(seed=0)
    assert info == {"is_success": False}
    rewards, over = 0.0, False
    while not over:
        observation, reward, terminated, truncated, info = env.step(towards(observation))
        rewards, over = rewards + float(reward), terminated or truncated
    assert info["is_success"] is True
    assert terminated
    assert np.linalg.norm(observation[:3]) * 2.0 <= definition.NEAR + 1e-6
    assert np.linalg.norm(observation[3:6]) <= definition.chord(definition.NEAR_ANGLE) + 1e-6


def test_rewards_of_an_episode_add_up_to_the_motion_made_and_the_time() -> None:
    env = ReachEnv()
    first, _ = env.reset(seed=4)
    total, observation, steps, reached = 0.0, first, 0, False
    while not reached:
        observation, reward, reached, _, _ = env.step(towards(observation))
        total, steps = total + reward, steps + 1
    distance = 2.0 * (np.linalg.norm(first[:3]) - np.linalg.norm(observation[:3]))
    rotation = np.linalg.norm(first[3:6]) - np.linalg.norm(observation[3:6])
    expected = distance + 2.0 * rotation - 0.05 * 0.08 * steps + 10.0
    assert total == pytest.approx(expected, abs=1e-5)


def test_rotation_to_go_is_the_axis_times_twice_the_sine_of_half_the_angle() -> None:
    env = KinematicReach()
    arm, mount = aftdeck.load_arm("srms"), aftdeck.load_arm("srms").model.mount.rotation
    for key in range(20):
        observation = env.begin(key)
        goal = env._batch.goals()[0]
        tip = arm.forward(env._batch.angles()[0])
        axis_angle = observation[3:6].astype(float)
        angle = 2.0 * math.asin(0.5 * float(np.linalg.norm(axis_angle)))
        axis = mount.T @ (axis_angle / np.linalg.norm(axis_angle))
        cross = np.array([[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]])
        turn = np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * (cross @ cross)  # Rodrigues
        assert turn @ tip.rotation == pytest.approx(goal.rotation, abs=1e-5)
        assert mount.T @ observation[:3] * 2.0 == pytest.approx(goal.position - tip.position, abs=1e-5)


def test_starts_and_goals_are_far_from_limits_and_singularities_and_apart() -> None:
    env, arm = KinematicReach(), aftdeck.load_arm("srms")
    env.begin(11)
    for _ in range(300):
        env.begin(None)
        start, goal = env._batch.angles()[0], env._batch.goals()[0]
        for angles in (start, arm.inverse(goal, near=start)[0]):
            assert np.abs(np.stack(arm.singularities(angles))).min() > 0.2
            assert (angles > arm.limits.reach[:, 0]).all()
            assert (angles < arm.limits.reach[:, 1]).all()
        assert np.linalg.norm(goal.position - arm.forward(start).position) >= definition.APART


def test_each_seed_has_its_own_episodes() -> None:
    env = ReachEnv()
    first, second = env.reset(seed=1)[0], env.reset()[0]
    other = env.reset(seed=2)[0]
    assert (env.reset(seed=1)[0] == first).all()
    assert (env.reset()[0] == second).all()
    assert not (first == second).any(where=np.arange(24) < 6)
    assert not (first == other).any(where=np.arange(24) < 6)


@pytest.mark.parametrize(
    ("action", "message"),
    [
        (np.full(6, 1.2, dtype=np.float32), r"action: THC X is 1.2, expected a number in \[-1, 1\]"),
        (np.array([0, 0, 0, 0, 0, math.nan], dtype=np.float32), "action: RHC yaw is nan"),
        (np.zeros(5, dtype=np.float32), r"action: got shape \(5,\), expected \(6,\)"),
    ],
)
@pytest.mark.parametrize("plant", ["kinematic", "rigid"])
def test_impossible_sticks_are_rejected_and_change_nothing(plant: str, action: Floats32, message: str) -> None:
    env, same = ReachEnv(plant), ReachEnv(plant)  # type: ignore[arg-type]
    env.reset(seed=0), same.reset(seed=0)
    with pytest.raises(InputError, match=message):
        env.step(action)
    assert (env.step(STICKS)[0] == same.step(STICKS)[0]).all()


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ({"plant": "magic"}, "plant: got 'magic', expected 'kinematic', 'rigid', 'flexible'"),
        ({"render_mode": "ansi"}, "render_mode: got 'ansi', expected 'rgb_array', 'human'"),
    ],
)
def test_unknown_keyword_values_are_rejected(keywords: dict[str, str], message: str) -> None:
    with pytest.raises(InputError, match=message):
        ReachEnv(**keywords)  # type: ignore[arg-type]


def test_step_before_the_first_reset_and_unknown_options_are_rejected() -> None:
    with pytest.raises(InputError, match="before the first reset"):
        ReachEnv().step(STICKS)
    with pytest.raises(InputError, match="options: got 'wind', expected no options"):
        ReachEnv().reset(options={"wind": 3})
