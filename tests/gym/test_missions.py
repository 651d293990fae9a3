"""Capture, Extract and Dock: the environments that fly a step of a scenario's task."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import aftdeck.gym
from aftdeck.errors import InputError, ScenarioError
from aftdeck.gym.mission.definition import observations
from aftdeck.gym.mission.env import CaptureEnv, DockEnv, ExtractEnv, MissionEnv
from aftdeck.gym.mission.score import AIMS, ANGLE, DISTANCE
from aftdeck.gym.terms import Floats32
from tests.each import number

ALL = (CaptureEnv, ExtractEnv, DockEnv)
GROUPS = observations(6)
"""What is observed of the built-in arms."""
CONDITIONS = sum(group.size for group in GROUPS[: [group.name for group in GROUPS].index("conditions")])
"""Index of the share of conditions that hold."""


def careful(env: MissionEnv, seen: Floats32) -> Floats32:
    """Return an action in proportion to the motion left; the end effector closes once it is ready."""
    action = np.zeros(len(env.mission.controls), dtype=np.float32)
    distance = float(np.linalg.norm(seen[:3]))
    action[:3], action[3:6] = np.clip(2.0 * seen[:3], -1.0, 1.0), np.clip(3.0 * seen[3:6], -1.0, 1.0)
    action[6] = 1.0 if distance > 0.3 else -1.0
    if isinstance(env, CaptureEnv):
        concept = env._sim.scenario.name == "concept-1972"
        away = 2 if concept else 0
        if distance > 0.1 and float(np.linalg.norm(np.delete(seen[:3], away))) > 0.02:
            action[away] = 0.0  # first align, then approach
        if seen[CONDITIONS] >= (0.8 if concept else 1.0):  # the concept's sixth condition is the closed prong
            action[:6], action[7] = 0.0, 1.0
    return action


def berthing(_env: MissionEnv, seen: Floats32) -> Floats32:
    """Return an action that aligns the payload above its berth in the bay, and then lowers it."""
    action = np.zeros(7, dtype=np.float32)
    action[:3], action[3:6], action[6] = np.clip(12.0 * seen[:3], -1.0, 1.0), np.clip(40.0 * seen[3:6], -1.0, 1.0), 1.0
    aligned = float(np.hypot(seen[0], seen[1])) <= 0.01 and float(np.abs(seen[3:6]).max()) <= 0.004
    if not aligned and seen[2] > 0.52:
        action[2] = 0.0
    return action


def flown(
    env: MissionEnv, seed: int, steps: int = 900, policy: Callable[[MissionEnv, Floats32], Floats32] = careful
) -> tuple[list[float], list[Floats32], bool]:
    """Return rewards, observations and success of an episode."""
    seen, _ = env.reset(seed=seed)
    rewards: list[float] = []
    observations, over, success = [seen], False, False
    while not over and len(rewards) < steps:
        seen, reward, over, _, info = env.step(policy(env, seen))
        rewards.append(reward)
        observations.append(seen)
        success = info["is_success"]
    return rewards, observations, success


@pytest.mark.parametrize("name", ["Capture", "Extract", "Dock"])
def test_environment_passes_gymnasiums_checker(name: str) -> None:
    check_env(gymnasium.make(f"aftdeck/{name}-v0").unwrapped)


def test_environment_on_a_plant_with_masses_passes_gymnasiums_checker() -> None:
    check_env(gymnasium.make("aftdeck/Dock-v0", plant="rigid").unwrapped)


@pytest.mark.parametrize("kind", ALL)
def test_careful_policy_completes_the_task(kind: type[MissionEnv]) -> None:
    env = kind()
    for seed in range(3):
        rewards, observations, success = flown(env, seed)
        assert success
        assert sum(rewards) > 0.0
        assert rewards[-1] > 9.0
        assert all(env.observation_space.contains(seen) for seen in observations)


@pytest.mark.parametrize(
    ("kind", "scenario"),
    [*((kind, name) for kind in ALL for name in ("concept-1972", "free-flyer")), (CaptureEnv, "tutorial")],
)
def test_a_step_is_the_same_if_each_of_its_control_steps_is_observed(kind: type[MissionEnv], scenario: str) -> None:
    """A step without an observer is one compiled call as long as nothing happens in it."""
    random = np.random.default_rng(3)
    one, observed = kind(scenario), kind(scenario)
    observed.stepped = lambda sim: None
    for episode in range(3):
        pair = [env.reset(seed=episode)[0] for env in (one, observed)]
        over, steps = False, 0
        while not over and steps < 150:
            if steps % 8 == 0:
                action = random.uniform(-1.0, 1.0, len(one.mission.controls)).astype(np.float32)
            given = careful(one, pair[0]) if episode == 2 else action
            (seen, *rest), (other, *same) = one.step(given), observed.step(given)
            assert rest == same and np.array_equal(seen, other) and one.simulation.seal() == observed.simulation.seal()
            pair, over, steps = [seen, other], bool(rest[1]), steps + 1


def test_careful_policy_acquires_with_the_concept_arm_and_docks_with_masses() -> None:
    assert flown(CaptureEnv("concept-1972"), 1)[2]
    assert flown(DockEnv(plant="rigid"), 1)[2]


def test_payload_is_berthed_in_the_bay() -> None:
    env = DockEnv("srms-berth")
    assert all(flown(env, seed, policy=berthing)[2] for seed in range(number(2, 20)))


def test_rewards_of_an_episode_add_up_to_the_motion_made_and_the_time() -> None:
    env = DockEnv()
    env.reset(seed=2)
    first = env.left
    rewards, _, success = flown(env, 2)
    last = env.left
    assert first is not None and last is not None and success
    motion = 5.0 * (first.distance - last.distance) + 5.0 * (first.angle - last.angle)
    assert sum(rewards) == pytest.approx(motion - 0.05 * 0.1 * len(rewards) + 10.0, abs=1e-9)


def test_place_that_appears_is_neither_rewarded_nor_punished() -> None:
    env = DockEnv()
    env.reset(seed=2)
    env._scored[[AIMS, DISTANCE, ANGLE]] = 0.0, 100.0, 3.0
    _, reward, *_ = env.step(np.zeros(len(env.mission.controls), dtype=np.float32))
    assert reward == pytest.approx(-0.05 * 0.1)


def test_episode_repeats_bit_for_bit_with_its_seed_and_differs_with_another() -> None:
    env, other = DockEnv(), DockEnv()
    one, again, different = flown(env, 3, 40), flown(other, 3, 40), flown(env, 4, 40)
    assert one[0] == again[0]
    assert all((a == b).all() for a, b in zip(one[1], again[1], strict=True))
    assert not (one[1][0] == different[1][0]).all()


def test_episode_equals_the_same_inputs_in_a_simulation_from_the_same_state() -> None:
    env = CaptureEnv()
    env.reset(seed=0)
    sim = aftdeck.Simulation(env._sim.scenario)
    sim.restore(env._sim.save())
    action = np.array([0.2, -0.1, 0.3, 0.1, 0.0, -0.2, -1.0, 0.0], dtype=np.float32)
    env.step(action)
    x, y, z, roll, pitch, yaw, *_ = action.tolist()
    for _ in range(5):
        sim.advance(aftdeck.Inputs(translation=(x, y, z), rotation=(roll, pitch, yaw), rate="vernier"))
    assert sim.seal() == env._sim.seal()


def test_detrimental_contact_ends_extract_without_success() -> None:
    env = ExtractEnv()
    env.reset(seed=0)
    rolling = np.array([0, 0, 0, 1, 0, 0, 0], dtype=np.float32)
    for _ in range(200):
        _, reward, over, _, info = env.step(rolling)
        if over:
            break
    assert over
    assert info == {"is_success": False}
    assert reward < -0.2
    assert env._sim.look().work.contacts


@pytest.mark.slow
@pytest.mark.parametrize("kind", ALL)
def test_random_policy_runs_for_many_steps_without_a_broken_episode(kind: type[MissionEnv]) -> None:
    env = gymnasium.wrappers.TimeLimit(kind(), 300)
    rng, steps, episodes, least = np.random.default_rng(0), 0, 0, number(5_000, 100_000)
    size = len(kind.mission.controls)
    while steps < least:  # 5 control steps each
        seen, _ = env.reset(seed=episodes)
        episodes, over = episodes + 1, False
        assert env.observation_space.contains(seen)
        while not over:
            if steps % 10 == 0:
                action = rng.uniform(-1.0, 1.0, size).astype(np.float32)
            seen, reward, terminated, truncated, info = env.step(action)
            steps, over = steps + 1, terminated or truncated
            assert np.isfinite(seen).all()
            assert env.observation_space.contains(seen)
            assert math.isfinite(float(reward))
            assert terminated or not info["is_success"]
    assert episodes > least / 330


@pytest.mark.parametrize(
    ("kind", "keywords", "message"),
    [
        (CaptureEnv, {"plant": "soft"}, "plant: got 'soft', expected 'kinematic', 'rigid', 'flexible'"),
        (CaptureEnv, {"scenario": "first-flight"}, "has no step for Capture; its steps are 'Move', 'Turn', 'Go home'"),
        (DockEnv, {"scenario": "tutorial"}, "scenario: 'tutorial' has no step for Dock; its steps are 'Look around'"),
    ],
)
def test_unusable_keyword_values_are_rejected(kind: type[MissionEnv], keywords: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        kind(**keywords)


def test_unknown_scenario_is_rejected_with_the_names_of_all() -> None:
    with pytest.raises(ScenarioError, match="no scenario 'moon'; the built-in scenarios are concept-1972"):
        CaptureEnv("moon")


def test_scenario_whose_control_period_does_not_divide_the_step_is_rejected(tmp_path: Path) -> None:
    text = aftdeck.load_scenario("tutorial").text.replace('arm = "srms"', 'arm = "srms"\ncontrol_period = "0.08 s"')
    (tmp_path / "own.toml").write_text(text, encoding="utf-8")
    with pytest.raises(
        InputError, match=r"control_period is 0\.08 s, expected a whole number of control steps in 0\.1 s"
    ):
        CaptureEnv(tmp_path / "own.toml")


@pytest.mark.parametrize("delay", ["0 s", "0.3 s"])
def test_rate_setting_is_that_of_the_last_action_beyond_half(tmp_path: Path, delay: str) -> None:
    text, file = aftdeck.load_scenario("tutorial").text, tmp_path / "own.toml"
    file.write_text(f'command_delay = "{delay}"\n{text}', encoding="utf-8")
    env, action = CaptureEnv(file), np.zeros(8, np.float32)
    for settings, rate in (((-1.0, 1.0), "coarse"), ((1.0, -1.0), "vernier")):
        env.reset(seed=1)
        for setting in (*settings, 0.4, -0.4, 0.0, 0.0, 0.0):
            action[6] = setting
            env.step(action)
        assert env.simulation.look().rate == rate


def test_disturbances_of_a_scenario_act_in_every_episode(tmp_path: Path) -> None:
    """At their time of the episode, and with the same steps if nothing disturbs."""
    text, file = aftdeck.load_scenario("tutorial").text, tmp_path / "own.toml"
    file.write_text(f"{text}\n[[disturbance]]\non = 'tip'\nbegin = 0.3\nduration = 0.4\nforce = [40, 0, 0]\n", "utf-8")
    calm, pushed = CaptureEnv(plant="rigid"), CaptureEnv(file, plant="rigid")
    for seed in (0, 1):
        seen = [env.reset(seed=seed)[0] for env in (calm, pushed)]
        assert np.array_equal(seen[0], seen[1])
        acting = []
        for _ in range(12):
            steps = [env.step(np.zeros(len(env.mission.controls), dtype=np.float32))[0] for env in (calm, pushed)]
            dynamics = pushed._sim.look().dynamics
            assert dynamics is not None
            acting.append(bool(dynamics.disturbances))
        assert any(acting) and not acting[-1] and sum(acting) == 4
        assert not np.array_equal(steps[0], steps[1])


def test_impossible_action_is_rejected_and_changes_nothing() -> None:
    env = DockEnv()
    env.reset(seed=0)
    before = env._sim.seal()
    action = np.zeros(7, dtype=np.float32)
    action[6] = 1.5
    with pytest.raises(InputError, match=r"action: rate is 1.5, expected a number in \[-1, 1\]"):
        env.step(action)
    with pytest.raises(InputError, match=r"action: got shape \(6,\), expected \(7,\)"):
        env.step(action[:6])
    assert env._sim.seal() == before


def test_step_before_the_first_reset_is_rejected() -> None:
    with pytest.raises(InputError, match="before the first reset"):
        DockEnv().step(np.zeros(7, dtype=np.float32))


@pytest.mark.parametrize("joints", [1, 5, 7, 8])
def test_observation_has_an_angle_and_a_rate_for_each_joint(joints: int) -> None:
    found = {group.name: group.size for group in observations(joints)}
    assert found == {group.name: group.size for group in GROUPS} | {"angle": joints, "rate": joints}
