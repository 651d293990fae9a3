"""Policies outside their environments: goals of Reach as a task, and the pilots that fly a run."""

from __future__ import annotations

from pathlib import Path

import gymnasium
import numpy as np
import pytest

import aftdeck
import aftdeck.gym
from aftdeck.errors import InputError
from aftdeck.gym.flight import pilot_of_policy, scenario_of_policy
from aftdeck.gym.policy import SIZES, Layer, Policy
from aftdeck.gym.policy_file import load_policy
from aftdeck.gym.reach.definition import ID as REACH
from aftdeck.gym.reach.goals import GOALS, goals_scenario
from aftdeck.gym.reach.pilot import ReachPilot
from aftdeck.scenario.target import Target
from aftdeck.simulation.run import Simulation

SHIPPED = Path(__file__).resolve().parents[2] / "examples" / "learn"


def proportional(environment: str, gain: float, joints: int = 6) -> Policy:
    """Return a policy whose sticks are `gain` times the motion to go, both translation and rotation."""
    sizes, actions = SIZES[environment]
    observations = sizes[0] if environment == REACH else sizes[joints - 1]
    weight = np.zeros((actions, observations))
    weight[range(6), range(6)] = gain
    return Policy(
        environment, "relu", np.zeros(observations), np.ones(observations), (Layer(weight, np.zeros(actions)),)
    )


def test_goals_are_those_of_the_environments_with_the_next_seeds() -> None:
    scenario = goals_scenario(7)
    assert len(scenario.steps) == GOALS
    env = gymnasium.make(REACH)
    for seed, step in enumerate(scenario.steps[:3], 7):
        seen, _ = env.reset(seed=seed)
        goal = env.unwrapped._reach._batch.goals()[0]  # type: ignore[attr-defined]
        assert isinstance(step.target, Target)
        assert step.target.pose.position == pytest.approx(goal.position, abs=1e-12)
        assert step.target.pose.rotation == pytest.approx(goal.rotation, abs=1e-12)
        assert np.abs(seen).max() > 0.0


def test_pilot_sees_what_the_environment_observes() -> None:
    seen: list[np.ndarray[tuple[int, ...], np.dtype[np.float32]]] = []

    class Watched(Policy):
        def act(self, observation: object) -> np.ndarray[tuple[int, ...], np.dtype[np.float32]]:
            seen.append(np.asarray(observation, dtype=np.float32))
            return super().act(seen[-1])

    rule, scenario = proportional(REACH, 3.0), goals_scenario(0)
    watched = Watched(rule.environment, rule.activation, rule.mean, rule.std, rule.layers)
    pilot, sim = ReachPilot(scenario, watched), Simulation(scenario)
    for _ in range(5):
        inputs = pilot(sim)
        assert inputs is not None
        sim.step(inputs)
    goal, frame = scenario.steps[0].target, sim.look()
    assert isinstance(goal, Target)
    pilot(sim)
    shift = scenario.arm.model.mount.rotation @ (np.array(goal.position) - np.array(frame.position))
    assert seen[-1][:3] == pytest.approx(shift / 2.0, abs=1e-6)


def test_proportional_policy_reaches_all_goals() -> None:
    scenario = goals_scenario(1)
    pilot = ReachPilot(scenario, proportional(REACH, 3.0))
    aftdeck.run(scenario, inputs=pilot, keep_frames=False)
    assert pilot.progress.present is None
    assert pilot.progress.skipped == ()


def test_policy_of_capture_takes_over_from_the_operator_near_the_payload() -> None:
    policy = proportional("aftdeck/Capture-v0", 1.0)
    scenario = scenario_of_policy(policy, None, 0, None)
    pilot, sim = pilot_of_policy(policy, scenario)(), Simulation(scenario)
    while not pilot.flying:  # type: ignore[attr-defined]
        inputs = pilot(sim)
        assert inputs is not None
        sim.advance(inputs)
    assert scenario.name == "tutorial"
    assert 0.3 < sim.look().time_s < 60.0


def test_policy_flies_only_scenarios_that_suit_it() -> None:
    reach, dock = proportional(REACH, 1.0), proportional("aftdeck/Dock-v0", 1.0)
    with pytest.raises(InputError, match="scenario: got 'tutorial', expected none"):
        scenario_of_policy(reach, "tutorial", 0, None)
    with pytest.raises(InputError, match="'first-flight' has no goals of aftdeck/Reach-v0"):
        pilot_of_policy(reach, aftdeck.load_scenario("first-flight"))
    with pytest.raises(InputError, match="'tutorial' has no step for Dock"):
        pilot_of_policy(dock, aftdeck.load_scenario("tutorial"))
    with pytest.raises(InputError, match="takes 32 observations; aftdeck/Capture-v0 has 30 for the 6 joints of 'srms'"):
        pilot_of_policy(proportional("aftdeck/Capture-v0", 1.0, joints=7), aftdeck.load_scenario("tutorial"))


def test_shipped_policy_of_reach_succeeds_in_95_percent_of_episodes() -> None:
    policy = load_policy(SHIPPED / "reach.npz")
    reach = gymnasium.make_vec(REACH, num_envs=200, autoreset_mode="SameStep")
    seen, _ = reach.reset(seed=5_000_000)
    over, succeeded = np.zeros(200, dtype=bool), np.zeros(200, dtype=bool)
    while not over.all():
        seen, _, terminated, truncated, _ = reach.step(policy.act(seen))
        succeeded |= terminated & ~over
        over |= terminated | truncated
    assert succeeded.mean() >= 0.95


@pytest.mark.slow
@pytest.mark.parametrize("name", ["capture", "capture_ppo", "extract", "dock"])
def test_shipped_policy_flies_its_step_of_the_scenario(name: str) -> None:
    policy = load_policy(SHIPPED / f"{name}.npz")
    scenario = scenario_of_policy(policy, None, 0, None)
    done = aftdeck.run(scenario, inputs=pilot_of_policy(policy, scenario)(), keep_frames=True)
    assert done.frames is not None
    (cargo,) = done.frames[-1].work.cargo
    assert cargo.held
    assert cargo.seat == ("port" if name == "dock" else "" if name == "extract" else "bay")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["capture_ppo", "extract", "dock"])
def test_shipped_policy_succeeds_in_95_percent_of_episodes(name: str) -> None:
    policy, episodes = load_policy(SHIPPED / f"{name}.npz"), 40
    env = gymnasium.make(policy.environment)
    succeeded = 0
    for episode in range(episodes):
        observation, info = env.reset(seed=5_000_000 + episode)
        over = False
        while not over:
            observation, _, terminated, truncated, info = env.step(policy.act(observation))
            over = terminated or truncated
        succeeded += info["is_success"]
    assert succeeded >= 0.95 * episodes
