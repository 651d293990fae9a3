"""The command delay: what a person does arrives so many steps later."""

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
from tests.steering.test_promises import equipped, inputs

STEPS = 200
NEVER_TOLD = {"tick": 0, "time_s": 0.0, "events": ()}


def flight(delay: int, seed: int) -> tuple[aftdeck.Scenario, list[Inputs]]:
    """A scenario with a delay of some steps, and random sticks, switches, targets and holds."""
    rng = np.random.default_rng(seed)
    extra = equipped(rng, np.array(BAY), "32000 lb" if seed % 2 else "")
    made = scenario(BAY, f"command_delay = {delay * 0.02!r}\n" + extra)
    operator = inputs(rng, aftdeck.Simulation(made))
    return made, [next(operator) for _ in range(STEPS)]


def flown(made: aftdeck.Scenario, given: list[Inputs]) -> list[Frame]:
    sim = aftdeck.Simulation(made)
    return [sim.step(one) for one in given]


def bits(frames: list[Frame]) -> bytes:
    return msgspec.msgpack.encode(frames)


def told(frames: list[Frame]) -> bytes:
    """Frames to the last digit, without the digest, which sees the inputs under way too."""
    return bits([msgspec.structs.replace(frame, sha256="") for frame in frames])


def untimed(frame: Frame) -> tuple[object, list[str]]:
    """A frame without its time, and its log without times."""
    return msgspec.structs.replace(frame, **NEVER_TOLD), [event.text for event in frame.events]


@pytest.mark.parametrize("delay", [1, 25, 150])
@pytest.mark.parametrize("seed", [0, 1])
def test_inputs_arrive_exactly_so_many_steps_late(delay: int, seed: int) -> None:
    made, given = flight(delay, seed)
    late = flown(made, given)
    prompt, _ = flight(0, seed)
    at_once = flown(prompt, [*[Inputs()] * delay, *given[: STEPS - delay]])
    assert told(late) == told(at_once)


def test_hands_off_is_what_arrives_first() -> None:
    made, given = flight(10, 2)
    assert all(frame.translation == (0.0, 0.0, 0.0) for frame in flown(made, given)[:10])


def test_no_delay_changes_nothing() -> None:
    made, given = flight(0, 3)
    without = scenario(BAY, equipped(np.random.default_rng(3), np.array(BAY), "32000 lb"))
    assert made.delay == without.delay == 0
    assert bits(flown(made, given)) == bits(flown(without, given))


@pytest.mark.parametrize("encode", [msgspec.json, msgspec.msgpack])
def test_what_is_under_way_is_saved_and_arrives_bit_for_bit(encode: Any) -> None:
    made, given = flight(20, 5)
    whole = flown(made, given)
    for tick in (1, 19, 20, 21, 100):
        sim = aftdeck.Simulation(made)
        for one in given[:tick]:
            sim.step(one)
        saved = encode.decode(encode.encode(sim.save()), type=SavedSimulation)
        sim.step(Inputs(stop=True))
        other = aftdeck.Simulation(made)
        other.restore(saved)
        assert bits([other.step(one) for one in given[tick:]]) == bits(whole[tick:])


def test_a_saved_state_is_not_touched_by_what_is_given_later() -> None:
    made, given = flight(5, 7)
    sim = aftdeck.Simulation(made)
    saved = sim.save()
    first = [sim.step(one) for one in given[:50]]
    sim.restore(saved)
    assert bits([sim.step(one) for one in given[:50]]) == bits(first)


def first_tick(frames: list[Frame], text: str) -> int:
    return next(f.tick for f in frames if any(text in e.text for e in f.events))


def test_stop_and_rate_hold_take_the_same_way() -> None:
    made = scenario(BAY, "command_delay = 0.5")
    push = Inputs(translation=(0.3, 0.0, 0.0))
    held = flown(made, [msgspec.structs.replace(push, rate_hold=True), *[Inputs()] * 60])
    assert next(f.tick for f in held if f.rate_hold) == 26
    assert held[-1].translation == push.translation
    freed = flown(
        made, [msgspec.structs.replace(push, rate_hold=True), *[Inputs()] * 9, Inputs(stop=True), *[Inputs()] * 60]
    )
    assert [f.tick for f in freed if f.rate_hold] == list(range(26, 36))


def test_a_motion_under_way_is_stopped_no_sooner() -> None:
    rng = np.random.default_rng(9)
    made = scenario(BAY, "command_delay = 1.0\n" + equipped(rng, np.array(BAY), ""))
    frames = flown(made, [Inputs(mode="AUTO 1", proceed=True), *[Inputs()] * 19, Inputs(stop=True), *[Inputs()] * 100])
    assert 51 <= first_tick(frames, "PROCEED") < 71  # CMD CK comes first
    assert first_tick(frames, "STOP") == 71


def test_the_script_is_not_delayed() -> None:
    script = '[[phase]]\nmode = "ORB UNL"\ntranslation = [0.6, 0, 0.2]\nduration = "1 s"'
    prompt, late = (aftdeck.run(scenario(BAY, f"command_delay = {d}\n{script}")) for d in (0.0, 2.0))
    assert told(list(prompt.frames)) == told(list(late.frames))


def test_inputs_that_no_hand_can_give_are_refused_at_once() -> None:
    sim = aftdeck.Simulation(scenario(BAY, "command_delay = 1.0"))
    before = sim.save()
    with pytest.raises(aftdeck.errors.InputError):
        sim.step(Inputs(drive=2.0))
    assert sim.save() == before


@pytest.mark.parametrize(
    ("line", "text"),
    [
        ("command_delay = 0.03", "is a whole number of control periods: 0.03 s is 1.5 of 0.02 s"),
        ('command_delay = "50 ms"', "is a whole number of control periods: 0.05 s is 2.5 of 0.02 s"),
        ("command_delay = -0.02", "lies between 0 and 30 s, got -0.02 s"),
        ("command_delay = 30.02", "lies between 0 and 30 s, got 30.02 s"),
        ("command_delay = nan", "command_delay"),
        ("command_delay = inf", "command_delay"),
        ('command_delay = "3 m"', "command_delay"),
    ],
)
def test_a_delay_that_is_none_is_refused_with_its_line(line: str, text: str) -> None:
    made = f'title = "x"\nduration = 1.0\n{line}\n[initial]\njoints = [0, 0, 0, 0, 0, 0]\n'
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(made, "x", "x.toml", Path("."))
    (problem,) = caught.value.problems
    assert problem.startswith("x.toml:3: command_delay: ") and text in problem


@pytest.mark.parametrize("period", ["1e-320", "0", "-1", "1e300", "nan", "inf"])
def test_a_delay_beside_a_period_that_is_none_is_refused_without_a_crash(period: str) -> None:
    made = f'title = "x"\ncommand_delay = 0.5\ncontrol_period = {period}\n[initial]\njoints = [0, 0, 0, 0, 0, 0]\n'
    with pytest.raises(ScenarioError, match=r"x\.toml:3: control_period: "):
        parse_scenario(made, "x", "x.toml", Path("."))


@pytest.mark.parametrize(("line", "steps"), [("0.5", 25), ('"2.6 s"', 130), ("30", 1500), ("0", 0)])
def test_a_delay_is_counted_in_steps(line: str, steps: int) -> None:
    assert scenario(BAY, f"command_delay = {line}").delay == steps
