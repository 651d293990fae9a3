"""What keeps the arm from moving at all is named: a seat, a contact, BRAKES and SAFING; nothing else is then."""

from __future__ import annotations

import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.simulation.frame import Frame
from tests.simulation.flights import srms
from tests.steering.flying import checked, joint_target

FIXED = "Deployable payload is fixed in the Payload bay latches: UNLATCH"
UP = Inputs(translation=(0.0, 0.0, -1.0))


def limits(frame: Frame) -> list[tuple[str, str]]:
    return [(limit.kind, limit.text) for limit in frame.limits]


@pytest.fixture
def seated() -> aftdeck.Simulation:
    """The payload captured, rigid, and still in its latches."""
    sim = aftdeck.Simulation("srms-deploy")
    for _ in range(20_000):
        frame = sim.step()
        if any(cargo.held and cargo.seat for cargo in frame.work.cargo) and "RIGID" in frame.work.hand.flags:
            return sim
    pytest.fail("the script captured nothing")


def test_a_stick_says_that_the_latches_have_the_payload_and_rest_says_nothing(seated: aftdeck.Simulation) -> None:
    for _ in range(50):
        frame = seated.step(UP)
        assert limits(frame) == [("seat", FIXED)]
        assert max(abs(rate) for rate in frame.rates) == 0.0
    assert limits(seated.step(Inputs())) == []


def test_cmd_ck_fails_while_the_latches_have_it_and_is_made_anew_when_they_let_go(seated: aftdeck.Simulation) -> None:
    seated.step(Inputs(mode="OPR CMD"))
    start = seated.scenario.initial_angles.tolist()
    frame = checked(seated, Inputs(target=joint_target(seated.scenario.arm, start)))[-1]
    assert frame.check is not None and frame.check.text == f"FAIL: {FIXED}"
    frames = [seated.step(Inputs(latch="unlatch"))]
    while any(cargo.seat for cargo in frames[-1].work.cargo):
        frames.append(seated.step(Inputs()))
        assert len(frames) <= 1600
    frames += [seated.step(Inputs()) for _ in range(5)]
    assert frames[-1].sequence == "checking"  # 60 m and more at the payload's speed


def test_a_contact_that_would_be_deepened_is_what_holds_the_arm() -> None:
    sim = aftdeck.Simulation(srms(6.0, 0.0, 7.0))
    frames = [sim.step(Inputs(translation=(0.0, 0.0, 1.0))) for _ in range(600)]
    held = [frame for frame in frames if any(kind == "contact" for kind, _ in limits(frame))]
    assert held and all(frame.work.arm_inhibit and len(frame.limits) == 1 for frame in held)
    assert all(max(abs(rate) for rate in frame.rates) == 0.0 for frame in held)
    assert limits(sim.step(UP)) != limits(held[-1])


@pytest.mark.parametrize(
    ("switch", "text"),
    [(Inputs(brakes=True), "BRAKES are on"), (Inputs(safing=True), "SAFING is on; CANCEL it first")],
    ids=["brakes", "safing"],
)
def test_brakes_and_safing_are_named_where_a_stick_is_moved_alone(switch: Inputs, text: str) -> None:
    sim = aftdeck.Simulation("first-flight")
    for _ in range(50):
        sim.step(UP)
    sim.step(switch)
    assert all(limits(sim.step(Inputs())) == [] for _ in range(50))
    assert limits(sim.step(UP)) == [("switch", text)]
