"""RELEASE of a payload that only the end effector holds, in a session: when it must be confirmed."""

from __future__ import annotations

import dataclasses

import msgspec
import pytest

from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.payloads.latch_command import CONFIRM
from aftdeck.simulation.run import Simulation
from aftdeck.station.core.release import ReleaseQuestion
from aftdeck.station.messages import from_page
from aftdeck.station.messages.kinds import EffectorSwitch
from aftdeck.station.session.session import Session
from aftdeck.worksite.conditions import Condition
from aftdeck.worksite.report import Objective
from tests.loaded import scenario
from tests.station.flying import flying, shown, step_until, steps

PERIOD_S = 0.02


def release(session: Session, switch: EffectorSwitch = "open") -> str:
    """Press RELEASE, and return the position of the end effector's switch after it."""
    session.accept(from_page.SetEffector(0, switch))
    return steps(session, 2).work.hand.switch


def questions(session: Session) -> int:
    return sum(event.kind == "release" and event.level == "caution" for event in session.log.since(0))


def test_release_over_a_berth_asks_once_and_a_second_one_is_executed() -> None:
    with flying(made=scenario("srms-berth")) as session:
        before = shown(session).work.hand.switch
        assert release(session) == before
        assert questions(session) == 1
        assert release(session) == "open"
        step_until(session, lambda frame: not any(payload.held for payload in frame.work.cargo), "the release")
        assert questions(session) == 1


def test_release_asks_again_after_the_time_to_confirm() -> None:
    with flying(made=scenario("srms-berth")) as session:
        release(session)
        steps(session, round(CONFIRM / PERIOD_S) + 2)
        assert release(session) != "open"
        assert questions(session) == 2


def test_restart_forgets_the_question() -> None:
    with flying(made=scenario("srms-berth")) as session:
        release(session)
        session.accept(from_page.Restart(0))
        steps(session, 2)
        assert release(session) != "open"


@pytest.mark.parametrize("switch", ["close", "stop"])
def test_other_positions_of_the_switch_are_set_at_once(switch: EffectorSwitch) -> None:
    with flying(made=scenario("srms-berth")) as session:
        assert release(session, switch) == switch
        assert questions(session) == 0


def test_release_in_the_step_of_the_release_does_not_ask() -> None:
    deploy = scenario("srms-deploy")
    at = next(i for i, step in enumerate(deploy.steps) if step.done.held is False and step.done.fixed is False)
    with flying(made=dataclasses.replace(scenario("srms-berth"), steps=(deploy.steps[at],))) as session:
        assert release(session) == "open"
        assert questions(session) == 0


def test_release_in_a_step_that_ends_in_the_berth_asks() -> None:
    berth = scenario("srms-berth")
    at = next(i for i, step in enumerate(berth.steps) if step.done.held is False and step.done.fixed)
    with flying(made=dataclasses.replace(berth, steps=(berth.steps[at],))) as session:
        release(session)
        assert questions(session) == 1


def test_empty_end_effector_opens_without_a_question() -> None:
    with flying(made=scenario("srms-deploy")) as session:
        release(session)
        assert questions(session) == 0


@pytest.mark.parametrize("holds", [True, False])
def test_release_asks_unless_the_berth_takes_the_payload(holds: bool) -> None:
    frame = Simulation(scenario("srms-berth")).step(Inputs())
    condition = Condition("centred", holds, 0.0, 0.1, "m", 0.1 if holds else -0.1, "")
    work = msgspec.structs.replace(frame.work, objective=Objective("insert", "insert"), conditions=(condition,))
    command = from_page.SetEffector(0, "open")
    question = ReleaseQuestion().question(command, msgspec.structs.replace(frame, work=work), None)
    assert (question == "") is holds
