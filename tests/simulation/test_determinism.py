"""The same scenario, seed and inputs give the same frames, bit for bit, also after saving and restoring."""

from __future__ import annotations

import hashlib

import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck.errors import InputError
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import SavedSimulation
from tests.each import each, seeds
from tests.scenario.missions import FLOWN, LONG, SCRIPTED
from tests.steering.flying import BAY, fly, scenario
from tests.steering.random_runs import equipped, inputs, start


def bits(frames: list[Frame]) -> bytes:
    return msgspec.msgpack.encode(frames)


@pytest.mark.slow
@pytest.mark.parametrize("name", FLOWN)
def test_two_runs_are_equal_bit_for_bit_and_building_frames_changes_no_state(name: str) -> None:
    one, two, blind = aftdeck.run(name), aftdeck.run(name), aftdeck.run(name, keep_frames=False)
    assert bits(list(one.frames)) == bits(list(two.frames))
    assert one.summary == two.summary == blind.summary
    assert blind.frames == (one.frames[-1],)


def test_summary_digest_covers_the_digests_of_all_frames() -> None:
    done = aftdeck.run("uncradle")
    digest = hashlib.sha256(b"".join(bytes.fromhex(frame.sha256) for frame in done.frames))
    assert done.summary.frames_sha256 == digest.hexdigest()


def test_run_without_digests_has_the_same_frames_and_summary_but_for_the_digests() -> None:
    with_digests, without = aftdeck.run("uncradle"), aftdeck.run("uncradle", digests=False)
    bare = [msgspec.structs.replace(frame, sha256="") for frame in with_digests.frames]
    assert bits(bare) == bits(list(without.frames))
    assert msgspec.structs.replace(with_digests.summary, frames_sha256="") == without.summary
    sim = aftdeck.Simulation("uncradle", digests=False)
    while not sim.ended:
        sim.advance()
    assert sim.seal().hex() == with_digests.frames[-1].sha256


def test_run_equals_simulation_stepped_to_its_end() -> None:
    done = aftdeck.run("uncradle")
    sim = aftdeck.Simulation("uncradle")
    frames = []
    while not sim.ended:
        frames.append(sim.step())
    assert bits(frames) == bits(list(done.frames))


def test_run_that_keeps_only_last_frame_has_same_summary() -> None:
    whole, brief = aftdeck.run("uncradle"), aftdeck.run("uncradle", keep_frames=False)
    assert brief.summary == whole.summary and brief.events == whole.events
    assert bits(list(brief.frames)) == bits([whole.frames[-1]])


def test_two_simulations_are_independent() -> None:
    made = scenario()
    alone = fly(aftdeck.Simulation(made), 2.0, aftdeck.Inputs(translation=(0.5, 0.0, 0.0)))
    one, two = aftdeck.Simulation(made), aftdeck.Simulation(made)
    beside = []
    for _ in alone:
        beside.append(one.step(aftdeck.Inputs(translation=(0.5, 0.0, 0.0))))
        two.step(aftdeck.Inputs(rotation=(0.0, -1.0, 0.3)))
    assert bits(beside) == bits(alone)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "encode"),
    [
        *((name, "as it is") for name in SCRIPTED if name not in LONG),
        ("first-flight", "msgpack"),
        ("uncradle", "json"),
    ],
)
def test_restored_script_continues_bit_for_bit(name: str, encode: str) -> None:
    whole = aftdeck.run(name)
    rng = np.random.default_rng(100)
    for tick in rng.integers(1, len(whole.frames), 1).tolist():
        sim = aftdeck.Simulation(name)
        for _ in range(tick):
            sim.step()
        saved = decoded(sim.save(), encode)
        fly(sim, 1.0, aftdeck.Inputs(rotation=(1.0, 1.0, 1.0)))  # later steps do not change the saved state
        other = aftdeck.Simulation(name)
        other.restore(saved)
        rest = []
        while not other.ended:
            rest.append(other.step())
        assert bits(rest) == bits(list(whole.frames[tick:]))
        assert other.ended == whole.summary.ended


def decoded(saved: SavedSimulation, encode: str) -> SavedSimulation:
    match encode:
        case "msgpack":
            return msgspec.msgpack.decode(msgspec.msgpack.encode(saved), type=SavedSimulation)
        case "json":
            return msgspec.json.decode(msgspec.json.encode(saved), type=SavedSimulation)
    return saved


@each("seed", seeds(6, 60))
def test_restored_manual_run_continues_bit_for_bit(seed: int) -> None:
    rng = np.random.default_rng(seed)
    first = start(rng)
    made = scenario(first.tolist(), equipped(rng, first, "32000 lb" if seed % 2 else ""))
    sim = aftdeck.Simulation(made)
    operator = inputs(rng, sim)
    given, frames, states = [], [], []
    for _ in range(300):
        states.append(sim.save())
        given.append(next(operator))
        frames.append(sim.step(given[-1]))
    for tick in rng.integers(0, 300, 3):
        other = aftdeck.Simulation(made)
        other.restore(decoded(states[tick], "msgpack"))
        assert bits([other.step(i) for i in given[tick:]]) == bits(frames[tick:])


TOUR = aftdeck.Inputs(mode="AUTO 1", proceed=True)
PUSH = aftdeck.Inputs((0.4, -0.2, 0.1), (0.0, 0.3, 0.0))
BEGINNINGS = {
    **{f"AUTO 1, {law}": [msgspec.structs.replace(TOUR, law=law)] for law in ("position", "closed loop", "open loop")},
    **{
        f"AUTO 1, {law}, coming to rest first": [*[PUSH] * 200, msgspec.structs.replace(TOUR, law=law)]
        for law in ("position", "open loop")
    },
    "stopped in mid-leg": [TOUR, *[aftdeck.Inputs()] * 100, aftdeck.Inputs(stop=True)],
    "RATE HOLD": [msgspec.structs.replace(PUSH, rate_hold=True)],
    "POSITION HOLD": [aftdeck.Inputs(position_hold=True), *[PUSH] * 50],
    **{mode: [msgspec.structs.replace(PUSH, mode=mode)] for mode in ("ORB LD", "PL", "END EFF")},
    "mode 7": [msgspec.structs.replace(PUSH, mode="ORB LD", payload_axes=True)],
    **{mode: [aftdeck.Inputs(mode=mode, joint=3, drive=1.0)] for mode in ("SINGLE", "DIRECT", "TEST")},
}


@pytest.mark.slow
@pytest.mark.parametrize("beginning", BEGINNINGS.values(), ids=BEGINNINGS.keys())
@pytest.mark.parametrize("mass", ["", "32000 lb"])
def test_restored_modes_holds_and_sequences_continue_bit_for_bit(beginning: list[aftdeck.Inputs], mass: str) -> None:
    rng = np.random.default_rng(111)
    made = scenario(BAY, equipped(rng, np.array(BAY), mass))
    sim = aftdeck.Simulation(made)
    for given in beginning:
        sim.step(given)
    later = [aftdeck.Inputs(proceed=bool(k % 150 == 149), drive=1.0) for k in range(400)]
    frames, states = [], []
    for given in later:
        states.append(sim.save())
        frames.append(sim.step(given))
    for tick in rng.integers(0, len(later), 2):
        other = aftdeck.Simulation(made)
        other.restore(decoded(states[tick], "json"))
        assert bits([other.step(given) for given in later[tick:]]) == bits(frames[tick:])


def test_simulation_restores_its_own_saved_state() -> None:
    sim = aftdeck.Simulation(scenario())
    push = aftdeck.Inputs(translation=(0.2, 0.0, -0.5))
    fly(sim, 1.0, push)
    saved = sim.save()
    first = fly(sim, 1.0, push)
    sim.restore(saved)
    assert bits(fly(sim, 1.0, push)) == bits(first)


def test_state_of_another_scenario_is_rejected_without_effect() -> None:
    sim = aftdeck.Simulation(scenario())
    fly(sim, 0.5, aftdeck.Inputs(translation=(1.0, 0.0, 0.0)))
    before = sim.save()
    with pytest.raises(
        InputError, match=r"belongs to a scenario with digest [0-9a-f]{12}; the scenario of this .* 'test'"
    ):
        sim.restore(aftdeck.Simulation("uncradle").save())
    assert sim.save() == before


def test_frame_is_not_changed_by_later_steps() -> None:
    sim = aftdeck.Simulation(scenario(BAY))
    frame = sim.step(aftdeck.Inputs(translation=(1.0, 0.0, 0.0)))
    kept = bits([frame])
    fly(sim, 0.5, aftdeck.Inputs(rotation=(1.0, 0.0, 0.0)))
    assert bits([frame]) == kept


def test_given_seed_replaces_the_scenarios_seed() -> None:
    made = scenario(extra="seed = 7")
    assert aftdeck.Simulation(made).seed == 7
    assert aftdeck.Simulation(made, seed=3).seed == 3
    assert aftdeck.run("uncradle", seed=3).summary.seed == 3
