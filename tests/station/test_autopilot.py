"""Autopilots of a session: a function flies until a stick moves, and its inputs are recorded as inputs."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from aftdeck.cli.autopilots import operator_flight
from aftdeck.errors import CommandError, InputError
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import Input
from aftdeck.recording.replay import verify
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.core.autopilot import Autopilot, Autopilots, Pilot
from aftdeck.station.messages import from_page
from tests.loaded import scenario
from tests.station.flying import flying, shown, step_until, steps

STILL = (0.0, 0.0, 0.0)
FORWARD = Inputs(translation=(0.5, 0.0, 0.0))


def sticks(seq: int, forward: float) -> from_page.Sticks:
    return from_page.Sticks(seq, (forward, 0.0, 0.0), STILL, 0.0)


def forward_for(number: int) -> Autopilots:
    """Return an autopilot of ``first-flight`` that moves forward for `number` steps of each run, then ends."""

    def begin() -> Pilot:
        left = iter(range(number))
        return lambda _: FORWARD if next(left, None) is not None else None

    return lambda made: Autopilot("policy", begin) if made.name == "first-flight" else None


def test_autopilot_flies_until_a_stick_moves() -> None:
    with flying(autopilots=forward_for(1000)) as session:
        frame = steps(session, 5)
        assert (frame.display.autopilot, frame.by, frame.translation[0]) == ("policy", "hand", 0.5)
        session.accept(sticks(1, forward=0.0005))
        assert steps(session, 2).display.autopilot == "policy"
        session.accept(sticks(2, forward=-0.25))
        frame = steps(session, 1)
        assert (frame.display.autopilot, frame.display.flown_seq, frame.translation[0]) == (None, 2, -0.25)
        assert session.log.since(0)[-1].text == "manual control: the policy has stopped"


def test_command_of_the_page_takes_over_from_an_autopilot() -> None:
    with flying(autopilots=forward_for(1000)) as session:
        session.accept(from_page.LookAhead(1, 10.0))
        assert steps(session, 2).display.autopilot == "policy"
        session.accept(from_page.SelectRate(2, "vernier"))
        frame = step_until(session, lambda frame: frame.rate == "vernier", "the command")
        assert (frame.display.autopilot, frame.translation[0]) == (None, 0.0)


def test_autopilot_that_ends_leaves_centred_sticks_to_the_operator() -> None:
    with flying(autopilots=forward_for(10)) as session:
        frame = step_until(session, lambda frame: frame.display.autopilot is None, "the end of the autopilot")
        assert (frame.tick, frame.translation[0]) == (11, 0.0)


def _failing(_: object) -> Inputs:
    raise InputError("no action")


WRONG: dict[str, Callable[[object], Any]] = {
    "not a number": lambda _: Inputs(translation=(math.nan, 0.0, 0.0)),
    "infinite": lambda _: Inputs(rotation=(0.0, math.inf, 0.0)),
    "beyond full deflection": lambda _: Inputs(translation=(0.0, 1.5, 0.0)),
    "another type": lambda _: "forward",
    "a joint that does not exist": lambda _: Inputs(joint=9, drive=0.1),
    "an error": _failing,
}


@pytest.mark.parametrize("wrong", WRONG)
def test_autopilot_without_possible_inputs_leaves_centred_sticks_to_the_operator(wrong: str) -> None:
    given = iter([FORWARD] * 5)

    def pilot(sim: Simulation) -> Inputs | None:
        return next(given, None) or WRONG[wrong](sim)

    with flying(autopilots=lambda _: Autopilot("policy", lambda: pilot)) as session:
        assert shown(session).display.autopilot == "policy"
        frame = step_until(session, lambda frame: frame.display.autopilot is None, "the end of the autopilot")
        assert (frame.display.autopilot, frame.translation, frame.rotation, frame.drive) == (None, STILL, STILL, 0.0)
        line = session.log.since(0)[-1]
        assert line.level == "caution" and line.text.startswith("manual control: the policy has stopped: ")
        session.accept(sticks(2, forward=-0.25))
        assert steps(session, 1).translation[0] == -0.25


def test_autopilot_flies_again_after_a_restart() -> None:
    with flying(autopilots=forward_for(10)) as session:
        assert steps(session, 20).display.autopilot is None
        session.accept(from_page.Restart(1))
        assert steps(session, 1).display.autopilot == "policy"
        assert steps(session, 20).display.autopilot is None


def test_autopilot_of_another_scenario_does_not_fly() -> None:
    with flying(autopilots=forward_for(10), name="loaded") as session:
        assert shown(session).display.autopilot is None


def test_camera_does_not_move_while_an_autopilot_flies() -> None:
    refused = pytest.raises(CommandError, match="the policy is in control: move a stick to take over")
    with flying(autopilots=forward_for(10)) as session, refused:
        session.accept(from_page.DriveCamera(1, "B", 1.0, 0.0, 0.0, slow=False))


def test_synthetic_operator_flies_scenarios_that_have_steps() -> None:
    operator = operator_flight("perfect", None)
    assert operator(scenario("concept-1972-script")) is None
    with flying(autopilots=operator, name="srms-berth") as session:
        frame = step_until(session, lambda frame: any(frame.translation), "the operator moves a stick")
        assert frame.display.autopilot == "synthetic operator"


def test_inputs_of_an_autopilot_are_recorded_and_replay_exactly(tmp_path: Path) -> None:
    with flying(autopilots=forward_for(30), record=tmp_path) as session:
        steps(session, 20)
        session.accept(sticks(1, forward=-0.5))
        steps(session, 20)
    (file,) = tmp_path.glob("*.mcap")
    assert verify(file).equal
    inputs = [m for m in Recording(file).messages() if isinstance(m, Input)]
    assert not any(m.script for m in inputs)
    assert [m.translation[0] for m in inputs[:25]] == [0.5] * 21 + [-0.5] * 4
