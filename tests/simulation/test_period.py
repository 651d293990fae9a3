"""The compiled part of a step against the same step in Python, with random sticks and switches."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

from aftdeck.arrays import Array
from aftdeck.files import Where
from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.scenario.target import Target
from aftdeck.simulation import fly, step, work
from aftdeck.simulation.command_check import rehearsal
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.log import Log
from aftdeck.simulation.period import quick
from aftdeck.simulation.period.contact import judged, seen
from aftdeck.simulation.period.drive import driven
from aftdeck.simulation.period.period import DRIVEN, JUDGED, OBSERVED, UNCHANGED
from aftdeck.simulation.row.now import Arrays, Flat
from aftdeck.simulation.row.scalars import BEGAN, MADE
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.state import State
from aftdeck.steering.layout import MOTION_ACTIVE
from aftdeck.steering.mode import MODES
from tests.simulation.flights import random_inputs

STEPS = 700
"""Number of steps of each run."""
HANDS = Inputs(translation=(0.1, -0.2, 0.3))
"""Sticks with which a test interrupts a script."""
SWITCHES: tuple[dict[str, bool], ...] = tuple(
    {name: on} for name in ("brakes", "safing", "position_hold", "rate_hold") for on in (True, False)
)
"""Switches that a test turns besides those of `random_inputs`."""
RESTORES = 0.02
"""Share of the steps before which a state is saved and restored."""
LEAVES_SWITCHES = 0.9
"""Share of the steps in which only sticks move, where a test chooses them."""


class InPython:
    """A step that compiled code leaves to Python as early as it can."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self._drifted, self._move_worksite = False, work._move_worksite
        monkeypatch.setattr(fly, "quick_step", self.quick_step)
        monkeypatch.setattr(work, "_move_worksite", self.move_worksite)
        monkeypatch.setattr(quick, "followed", self.followed)

    def quick_step(
        self, flight: Flight, state: State, inputs: Inputs, *, observes: bool, most: int = 1, goes_on: bool = False
    ) -> int:
        """Steer, and move the arm by laws."""
        del observes, most
        assert not goes_on
        began = state.panel.motion_began
        quick.command_motion(flight, state, inputs)
        state.row.scalars[BEGAN], state.row.scalars[MADE] = 0.0, 1.0
        self._drifted = driven(Flat(*state.row.arrays(flight.packed)))
        quick._take_values(flight, state, DRIVEN)
        if self._drifted and state.row.floats:
            quick._take_flights(state)
        assert state.panel.motion_began == began or state.command[MOTION_ACTIVE] != 0.0
        return DRIVEN

    def move_worksite(self, flight: Flight, state: State, log: Log, inputs: Inputs) -> None:
        """Move what floats, unless a law has moved it."""
        if not self._drifted:
            self._move_worksite(flight, state, log, inputs)

    def followed(self, arrays: Arrays, true: Array, pressed: bool, links: Array, sticks: Array, observes: bool) -> int:
        """Measure and judge contacts by laws; captures, pairs that count and limits are left to Python."""
        del links, sticks, observes
        flat = Flat(*arrays)
        seen(flat, true)
        judged(flat, pressed)
        return JUDGED


def digests(name: str, seed: int | None, steps: int) -> list[bytes]:
    """Return the digest of each step: of random sticks, or of the script, if any, with sticks at rest."""
    sim = Simulation(name)
    given = None if seed is None else random_inputs(np.random.default_rng(seed), steps)
    found: list[bytes] = []
    while len(found) < steps and not sim.ended:
        sim.advance(None if given is None else next(given))
        found.append(sim.seal())
    return found


@pytest.mark.parametrize("name", built_in())
@pytest.mark.parametrize("seed", [None, 1, 2])
def test_compiled_steps_change_the_state_as_steps_in_python_do(
    name: str, seed: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    compiled = digests(name, seed, STEPS)
    InPython(monkeypatch)
    monkeypatch.setattr(rehearsal, "_COMMANDED", STEPS * 1000)
    assert digests(name, seed, STEPS) == compiled


@pytest.mark.parametrize("name", ["srms-berth", "concept-1972-script", "sequence", "first-flight"])
def test_most_steps_are_compiled_as_a_whole(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    reached: Counter[int] = Counter()
    own = quick.quick_step

    def counted(
        flight: Flight, state: State, inputs: Inputs, *, observes: bool, most: int = 1, goes_on: bool = False
    ) -> int:
        found = own(flight, state, inputs, observes=observes, most=most, goes_on=goes_on)
        reached[found] += observes
        return found

    monkeypatch.setattr(fly, "quick_step", counted)
    digests(name, None if load_scenario(name).phases else 1, 2000)
    assert reached[OBSERVED] + reached[UNCHANGED] > 0.5 * reached.total(), reached


@pytest.mark.parametrize("name", built_in())
@pytest.mark.parametrize("seed", [1, 2])
def test_steps_with_sticks_alone_are_as_steps_that_do_everything(name: str, seed: int) -> None:
    random = np.random.default_rng(seed)
    brief, whole = Simulation(name), Simulation(name)
    alone, went_on, turn = random_inputs(random, STEPS), 0, Inputs()
    for switched in alone:
        turn = switched
        if random.random() < LEAVES_SWITCHES:
            turn = Inputs(switched.translation, switched.rotation, switched.drive, telescope=switched.telescope)
        elif random.random() < LEAVES_SWITCHES:
            turn = replace(turn, **SWITCHES[random.integers(len(SWITCHES))])
        if random.random() < RESTORES:
            brief.restore(brief.save())
        brief.advance(turn)
        whole._state.row.goes_on = False
        whole.advance(turn)
        went_on += brief._state.row.goes_on
        assert brief.seal() == whole.seal() and brief.look() == whole.look()
    begins = brief.scenario
    assert went_on > 0 or begins.plant != "kinematic" or MODES[begins.mode].kind == "automatic"


def test_after_an_interrupted_step_the_next_one_does_everything(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    sim = Simulation("first-flight")
    for _ in range(30):
        sim.advance(HANDS)
    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr(step, "check", interrupted)
        sim.advance(Inputs(brakes=True))
    for _ in range(5):
        sim.advance(HANDS)
    assert sim.look().brakes and not any(sim.look().rates)


@pytest.mark.parametrize("name", built_in())
def test_steps_of_a_script_are_as_steps_that_do_everything(name: str) -> None:
    delay: dict[Where, object] = {("command_delay",): "0.2 s"}
    for changes in ({}, delay):
        brief, whole = (Simulation(load_scenario(name, changes)) for _ in range(2))
        went_on = 0
        for k in range(STEPS):
            inputs = HANDS if k % 200 > 150 or not brief.scenario.phases else None
            brief.advance(inputs)
            whole._state.row.goes_on = False
            whole.advance(inputs)
            went_on += brief._state.row.goes_on
            assert brief.seal() == whole.seal() and brief.look() == whole.look()
        first = brief.scenario.phases[0].mode if brief.scenario.phases else brief.scenario.mode
        assert went_on > 0 or brief.scenario.plant != "kinematic" or MODES[first].kind == "automatic"


@pytest.mark.parametrize("name", built_in())
@pytest.mark.parametrize("seed", [1, 2])
def test_held_inputs_are_as_many_steps(name: str, seed: int) -> None:
    random = np.random.default_rng(seed)
    one, many = Simulation(name), Simulation(name)
    for inputs in random_inputs(random, STEPS // 4):
        steps = int(random.integers(1, 9))
        for _ in range(steps):
            one.advance(inputs)
        many.hold(inputs, steps)
        assert one.seal() == many.seal() and one.look() == many.look()


@pytest.mark.parametrize("before", [0, 20, 22, 24, 25, 26])
def test_held_inputs_are_as_many_steps_when_the_scenario_changes_something(before: int, tmp_path: Path) -> None:
    file, text = tmp_path / "changes.toml", load_scenario("concept-1972-script").text
    event = '\n[[event]]\nat = "0.5 s"\nset = { limits.por.translation = "0.25 m/s" }\n'
    file.write_text(text + event, encoding="utf-8")
    one, many = (Simulation(file) for _ in range(2))
    for sim in (one, many):
        for _ in range(before):
            sim.advance(HANDS)
    for _ in range(5):
        one.advance(HANDS)
    many.hold(HANDS, 5)
    assert one.seal() == many.seal() and one.look() == many.look()


@pytest.mark.parametrize("turns", [0.0, 0.05])
def test_payload_that_floats_moves_in_a_rehearsal_as_in_single_steps(
    turns: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    poses = []
    for commanded in (1, 10_000):  # a loop in compiled code, and single steps
        monkeypatch.setattr(rehearsal, "_COMMANDED", commanded)
        sim = Simulation("free-flyer")
        payload = sim._state.worksite.floating[0]
        assert payload is not None
        payload.motion[2] = turns
        frame = sim.step(Inputs(mode="OPR CMD"))
        x, y, z = frame.position
        sim.advance(Inputs(target=Target((x, y, z - 0.5), frame.orientation)))
        seen_poses = []
        while (checking := sim._state.checking) is not None:
            if (motion := checking.rehearsal.motion) is not None:
                floating = motion._copy.worksite.floating[0]
                assert floating is not None
                seen_poses.append((motion.steps, floating.pose.tolist(), motion._copy.worksite.frames.tolist()))
            sim.advance(Inputs())
        poses.append(seen_poses)
    assert poses[0] == poses[1] and poses[0][-1][0] > 50
