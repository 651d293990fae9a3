"""Command delay: manual inputs act after a given number of steps."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck.errors import ScenarioError
from aftdeck.scenario.load import parse_scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import SavedSimulation
from tests.steering.flying import BAY, scenario
from tests.steering.random_runs import equipped, inputs

STEPS = 200


def flight(delay: int, seed: int) -> tuple[aftdeck.Scenario, list[Inputs]]:
    """Return a scenario with a delay [steps], and random inputs: sticks, switches, targets and holds."""
    rng = np.random.default_rng(seed)
    extra = equipped(rng, np.array(BAY), "32000 lb" if seed % 2 else "")
    made = scenario(BAY, f"command_delay = {delay * 0.02!r}\n" + extra)
    operator = inputs(rng, aftdeck.Simulation(made))
    return made, [next(operator) for _ in range(STEPS)]


def flown(made: aftdeck.Scenario, given: list[Inputs]) -> list[Frame]:
    sim = aftdeck.Simulation(made)
    return [sim.step(inputs_) for inputs_ in given]


def bits(frames: list[Frame]) -> bytes:
    return msgspec.msgpack.encode(frames)


def without_digest(frames: list[Frame]) -> bytes:
    """Return the encoded frames without their digests, which also contain the delayed inputs."""
    return bits([msgspec.structs.replace(frame, sha256="") for frame in frames])


@pytest.mark.slow
@pytest.mark.parametrize("delay", [1, 25, 150])
@pytest.mark.parametrize("seed", [0, 1])
def test_inputs_act_exactly_after_the_delay(delay: int, seed: int) -> None:
    made, given = flight(delay, seed)
    late = flown(made, given)
    prompt, _ = flight(0, seed)
    at_once = flown(prompt, [*[Inputs()] * delay, *given[: STEPS - delay]])
    assert without_digest(late) == without_digest(at_once)


def test_sticks_are_centred_until_first_delayed_input() -> None:
    made, given = flight(10, 2)
    assert all(frame.translation == (0.0, 0.0, 0.0) for frame in flown(made, given)[:10])


def test_zero_delay_changes_nothing() -> None:
    made, given = flight(0, 3)
    without = scenario(BAY, equipped(np.random.default_rng(3), np.array(BAY), "32000 lb"))
    assert made.delay == without.delay == 0
    assert bits(flown(made, given)) == bits(flown(without, given))


@pytest.mark.parametrize("encode", [msgspec.json, msgspec.msgpack])
def test_saved_state_contains_delayed_inputs(encode: Any) -> None:
    made, given = flight(20, 5)
    whole = flown(made, given)
    for tick in (1, 19, 20, 21, 100):
        sim = aftdeck.Simulation(made)
        for inputs_ in given[:tick]:
            sim.step(inputs_)
        saved = encode.decode(encode.encode(sim.save()), type=SavedSimulation)
        sim.step(Inputs(stop=True))
        other = aftdeck.Simulation(made)
        other.restore(saved)
        assert bits([other.step(inputs_) for inputs_ in given[tick:]]) == bits(whole[tick:])


def test_saved_state_is_independent_of_later_inputs() -> None:
    made, given = flight(5, 7)
    sim = aftdeck.Simulation(made)
    saved = sim.save()
    first = [sim.step(inputs_) for inputs_ in given[:50]]
    sim.restore(saved)
    assert bits([sim.step(inputs_) for inputs_ in given[:50]]) == bits(first)


def first_tick(frames: list[Frame], kind: str) -> int:
    """Return the tick of the first log line of a kind."""
    return next(f.tick for f in frames if any(e.kind == kind for e in f.events))


def test_stop_and_rate_hold_are_delayed() -> None:
    made = scenario(BAY, "command_delay = 0.5")
    push = Inputs(translation=(0.3, 0.0, 0.0))
    held = flown(made, [msgspec.structs.replace(push, rate_hold=True), *[Inputs()] * 60])
    assert next(f.tick for f in held if f.rate_hold) == 26
    assert held[-1].translation == push.translation
    freed = flown(
        made, [msgspec.structs.replace(push, rate_hold=True), *[Inputs()] * 9, Inputs(stop=True), *[Inputs()] * 60]
    )
    assert [f.tick for f in freed if f.rate_hold] == list(range(26, 36))


def test_stop_of_automatic_motion_is_delayed() -> None:
    rng = np.random.default_rng(9)
    made = scenario(BAY, "command_delay = 1.0\n" + equipped(rng, np.array(BAY), ""))
    frames = flown(made, [Inputs(mode="AUTO 1", proceed=True), *[Inputs()] * 19, Inputs(stop=True), *[Inputs()] * 100])
    assert 51 <= first_tick(frames, "proceed") < 71  # after CMD CK
    assert first_tick(frames, "stop") == 71


def test_script_is_not_delayed() -> None:
    script = '[[phase]]\nmode = "ORB UNL"\ntranslation = [0.6, 0, 0.2]\nduration = "1 s"'
    prompt, late = (aftdeck.run(scenario(BAY, f"command_delay = {d}\n{script}")) for d in (0.0, 2.0))
    assert without_digest(list(prompt.frames)) == without_digest(list(late.frames))


def test_invalid_inputs_are_rejected_before_the_delay() -> None:
    sim = aftdeck.Simulation(scenario(BAY, "command_delay = 1.0"))
    before = sim.save()
    with pytest.raises(aftdeck.errors.InputError):
        sim.step(Inputs(drive=2.0))
    assert sim.save() == before


@pytest.mark.parametrize(
    ("line", "text"),
    [
        ("command_delay = 0.03", "1.5 of 0.02 s"),
        ('command_delay = "50 ms"', "2.5 of 0.02 s"),
        ("command_delay = -0.02", "-0.02 s"),
        ("command_delay = 30.02", "30.02 s"),
        ("command_delay = nan", "command_delay"),
        ("command_delay = inf", "command_delay"),
        ('command_delay = "3 m"', "command_delay"),
    ],
)
def test_invalid_delay_is_rejected_with_its_line(line: str, text: str) -> None:
    made = f'title = "x"\nduration = 1.0\n{line}\n[initial]\njoints = [0, 0, 0, 0, 0, 0]\n'
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(made, "x", "x.toml", Path("."))
    (problem,) = caught.value.problems
    assert problem.startswith("x.toml:3: command_delay: ") and text in problem


@pytest.mark.parametrize("period", ["1e-320", "0", "-1", "1e300", "nan", "inf"])
def test_delay_with_invalid_period_is_rejected(period: str) -> None:
    made = f'title = "x"\ncommand_delay = 0.5\ncontrol_period = {period}\n[initial]\njoints = [0, 0, 0, 0, 0, 0]\n'
    with pytest.raises(ScenarioError, match=r"x\.toml:3: control_period: "):
        parse_scenario(made, "x", "x.toml", Path("."))


@pytest.mark.parametrize(("line", "steps"), [("0.5", 25), ('"2.6 s"', 130), ("30", 1500), ("0", 0)])
def test_delay_is_converted_to_steps(line: str, steps: int) -> None:
    assert scenario(BAY, f"command_delay = {line}").delay == steps
