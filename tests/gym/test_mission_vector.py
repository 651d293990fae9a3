"""Batches of Capture, Extract and Dock: each environment equals the single one, bit for bit."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode, SyncVectorEnv

import aftdeck
from aftdeck.errors import InputError
from aftdeck.gym.mission.env import CaptureEnv, DockEnv, ExtractEnv, MissionEnv
from aftdeck.gym.mission.starts import Starts
from aftdeck.gym.mission.vector import CaptureVectorEnv, DockVectorEnv, ExtractVectorEnv, MissionVectorEnv
from aftdeck.gym.policy_file import load_policy
from aftdeck.gym.terms import Floats32
from aftdeck.simulation.batch import Batch
from tests.each import number
from tests.gym.test_missions import careful
from tests.gym.test_reach_vector import compare

KINDS: list[tuple[type[MissionEnv], type[MissionVectorEnv], str]] = [
    (CaptureEnv, CaptureVectorEnv, "tutorial"),
    (CaptureEnv, CaptureVectorEnv, "concept-1972"),
    (ExtractEnv, ExtractVectorEnv, "concept-1972"),
    (DockEnv, DockVectorEnv, "concept-1972"),
    (DockEnv, DockVectorEnv, "free-flyer"),
    (DockEnv, DockVectorEnv, "srms-berth"),
]
LEARN = Path(__file__).parents[2] / "examples" / "learn"
MODES = (AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP, AutoresetMode.DISABLED)


def actions_for(env: MissionEnv, seen: Floats32, rng: np.random.Generator) -> Floats32:
    """Return actions for n environments: those of a careful policy, random ones, and ones with single switches."""
    size = len(env.mission.controls)
    actions = np.array([careful(env, row) for row in seen])
    for i in range(len(seen)):
        match i % 4:
            case 1:
                actions[i] = rng.uniform(-1.0, 1.0, size)
            case 2:
                actions[i, :6] = np.round(rng.uniform(-0.6, 0.6, 6), 1)
            case _:
                pass
    return actions


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize(("kind", "batch", "scenario"), KINDS)
def test_batch_equals_gymnasiums_vector_of_single_environments(
    kind: type[MissionEnv], batch: type[MissionVectorEnv], scenario: str, mode: AutoresetMode
) -> None:
    count, steps = 4, 25
    ours = batch(count, steps, mode, scenario)
    theirs = SyncVectorEnv([lambda: gymnasium.wrappers.TimeLimit(kind(scenario), steps)] * count, autoreset_mode=mode)
    one: Any = theirs.envs[0].unwrapped
    assert ours.single_observation_space == theirs.single_observation_space
    assert ours.action_space == theirs.action_space
    rng = np.random.default_rng(1)
    seen = ours.reset(seed=5)
    compare(seen, theirs.reset(seed=5))
    rows = seen[0]
    for _ in range(number(70, 600)):
        actions = actions_for(one, rows, rng)
        got, expected = ours.step(actions), theirs.step(actions)
        compare(got, expected)
        rows, over = got[0], got[2] | got[3]
        if mode is AutoresetMode.DISABLED and over.any():
            again = ours.reset(options={"reset_mask": over})
            compare(again, theirs.reset(options={"reset_mask": over}))
            rows = again[0]


@pytest.mark.parametrize(("kind", "batch", "scenario"), KINDS)
def test_states_and_frames_of_a_batch_are_those_of_single_environments(
    kind: type[MissionEnv], batch: type[MissionVectorEnv], scenario: str
) -> None:
    ours, singles = batch(3, scenario=scenario), [kind(scenario) for _ in range(3)]
    rows = ours.reset(seed=20)[0]
    for i, env in enumerate(singles):
        assert (env.reset(seed=20 + i)[0] == rows[i]).all()
    rng, over = np.random.default_rng(4), np.zeros(3, np.bool_)
    for step in range(40):
        actions = actions_for(singles[0], rows, rng)
        rows, _, ended, *_ = ours.step(actions)
        for i, env in enumerate(singles):
            if over[i]:  # the next step of the batch begins the next episode
                continue
            env.step(actions[i])
            over[i] = ended[i]
            if step % 7 == i:
                sim = ours._missions.simulation(i)
                assert sim.seal() == env.simulation.seal()
                assert sim.look() == env.simulation.look()
                assert sim.watched() == env.simulation.watched()


def test_environment_of_a_batch_does_not_depend_on_the_others() -> None:
    many, few = DockVectorEnv(18), DockVectorEnv(1)
    rng = np.random.default_rng(0)
    assert (many.reset(seed=40)[0][17] == few.reset(seed=57)[0][0]).all()
    for _ in range(60):
        actions = rng.uniform(-1.0, 1.0, (18, 7)).astype(np.float32)
        got, expected = many.step(actions), few.step(actions[17:])
        assert (got[0][17] == expected[0][0]).all() and got[1][17] == expected[1][0]


def test_batch_of_a_scenario_with_a_command_delay_equals_single_environments(tmp_path: Path) -> None:
    file = tmp_path / "own.toml"
    file.write_text(f'command_delay = "0.3 s"\n{aftdeck.load_scenario("concept-1972").text}', encoding="utf-8")
    ours, env = DockVectorEnv(1, scenario=file), DockEnv(file)
    assert (ours.reset(seed=1)[0][0] == env.reset(seed=1)[0]).all()
    rng = np.random.default_rng(2)
    for _ in range(60):
        action = rng.uniform(-1.0, 1.0, 7).astype(np.float32)
        assert (ours.step(action[None])[0][0] == env.step(action)[0]).all()


def test_scenario_that_plans_changes_in_flight_is_rejected_with_the_way_to_fly_it(tmp_path: Path) -> None:
    file, change = tmp_path / "own.toml", '[[event]]\nat = "1 s"\nset = { "clearance.warning" = "0.02 m" }\n'
    file.write_text(f"{aftdeck.load_scenario('concept-1972').text}\n{change}", encoding="utf-8")
    DockEnv(file).reset(seed=0)
    with pytest.raises(InputError, match=r"plans changes in flight .*, which no batch can make; use make_vec"):
        DockVectorEnv(2, scenario=file)


def test_captures_and_their_next_episodes_equal_those_of_single_environments() -> None:
    """The snares close in 2.5 s, which no short episode reaches."""
    count, done = 3, 0
    ours = CaptureVectorEnv(count, 150, AutoresetMode.SAME_STEP)
    theirs = SyncVectorEnv(
        [lambda: gymnasium.wrappers.TimeLimit(CaptureEnv(), 150)] * count, autoreset_mode=AutoresetMode.SAME_STEP
    )
    policy = load_policy(LEARN / "capture_ppo.npz")
    rows = ours.reset(seed=3)[0]
    assert (rows == theirs.reset(seed=3)[0]).all()
    rng = np.random.default_rng(0)
    for _ in range(220):
        actions = policy.act(rows)
        actions[1] = np.clip(actions[1] + 0.3 * rng.standard_normal(8), -1.0, 1.0)
        got = ours.step(actions)
        compare(got, theirs.step(actions))
        rows, done = got[0], done + int(got[2].sum())
    assert done >= 3


@pytest.mark.parametrize("kind", [CaptureVectorEnv, DockVectorEnv])
def test_copy_of_a_batch_goes_its_own_way(kind: type[MissionVectorEnv]) -> None:
    env, rng = kind(2), np.random.default_rng(0)
    env.reset(seed=4)
    shape = env.action_space.shape
    assert shape is not None
    for _ in range(15):
        env.step(rng.uniform(-1.0, 1.0, shape).astype(np.float32))
    twin = pickle.loads(pickle.dumps(copy.deepcopy(env)))
    for _ in range(30):
        actions = rng.uniform(-1.0, 1.0, shape).astype(np.float32)
        compare(env.step(actions), twin.step(actions))


def test_payload_that_is_released_in_its_own_axes_is_steered_on_as_alone() -> None:
    """The release selects ORB UNL, with another law."""
    alone = aftdeck.Simulation("concept-1972", digests=False)
    alone.restart(next(start for start in alone.scenario.parts.values() if start.grasped is not None))
    saved = aftdeck.Simulation("concept-1972", digests=False)
    saved.restore(alone.save())
    batch = Batch(saved, 1)
    for sim in (alone, saved):
        sim.advance(aftdeck.Inputs(mode="PL"))
    batch.place(0)
    none = np.zeros(1, np.bool_)
    for step in range(30):
        inputs = aftdeck.Inputs(translation=(0.0, 0.0, -0.1), effector="open" if step < 20 else None)
        alone.hold(inputs, 10)
        switch = np.array([-1.0 if step < 20 else 0.0])
        sticks = np.array([[0.0, 0.0, 0.0, 0.0, 0.0, -0.1]])
        batch.hold(sticks, batch.rates.copy(), switch, 10, none, lambda _, given=inputs: given)  # type: ignore[misc]
        batch.catch_up(0)
        assert saved.seal() == alone.seal()
    assert alone.look().mode == "ORB UNL"


def test_environments_without_a_start_have_to_be_reset(monkeypatch: pytest.MonkeyPatch) -> None:
    env = DockVectorEnv(2, 1)
    monkeypatch.setattr(Starts, "draw", lambda *_: None)
    for _ in range(2):
        with pytest.raises(InputError, match="has no start without a contact"):
            env.reset(seed=0)
        with pytest.raises(InputError, match="before the first reset"):
            env.step(np.zeros((2, 7), np.float32))
    monkeypatch.undo()
    env.reset(seed=0)
    env.step(np.zeros((2, 7), np.float32))
    monkeypatch.setattr(Starts, "draw", lambda *_: None)
    with pytest.raises(InputError, match="has no start without a contact"):
        env.step(np.zeros((2, 7), np.float32))
    with pytest.raises(InputError, match="before the first reset"):
        env.step(np.zeros((2, 7), np.float32))


def test_impossible_action_of_one_environment_is_rejected_and_moves_none() -> None:
    env = DockVectorEnv(3)
    env.reset(seed=0)
    before = [env._missions.simulation(i).seal() for i in range(3)]
    actions = np.zeros((3, 7), np.float32)
    actions[2, 1] = 1.5
    with pytest.raises(InputError, match=r"action: THC Y is 1\.5 in environment 2, expected a number in \[-1, 1\]"):
        env.step(actions)
    assert before == [env._missions.simulation(i).seal() for i in range(3)]


def test_plant_with_masses_is_rejected_with_the_way_to_fly_it() -> None:
    with pytest.raises(InputError, match="expected 'kinematic' for the compiled batch; with masses use"):
        DockVectorEnv(2, plant="rigid")
