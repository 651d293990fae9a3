"""Limits that block the arm completely: a berth, a contact, BRAKES and SAFING; no other limit is then active."""

from __future__ import annotations

import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.operator.sequence import finish
from aftdeck.steering.layout import RATIO
from aftdeck.steering.rehearsal import MAX_STOPPED_TIME
from tests.simulation.flights import srms
from tests.steering.flying import BAY, checked, joint_target, scenario

UP = Inputs(translation=(0.0, 0.0, -1.0))


def limits(frame: Frame) -> list[str]:
    """Return the kinds of the active limits."""
    return [limit.kind for limit in frame.limits]


@pytest.fixture
def seated() -> aftdeck.Simulation:
    """Return a simulation with the payload captured, rigid, and still in its latches."""
    sim = aftdeck.Simulation("srms-deploy")
    for _ in range(20_000):
        frame = sim.step()
        if any(cargo.held and cargo.seat for cargo in frame.work.cargo) and "RIGID" in frame.work.hand.flags:
            return sim
    pytest.fail("the script captured no payload")


def test_stick_input_reports_latches_that_hold_the_payload(seated: aftdeck.Simulation) -> None:
    for _ in range(50):
        frame = seated.step(UP)
        assert limits(frame) == ["seat"] and "Deployable payload" in frame.limits[0].text
        assert max(abs(rate) for rate in frame.rates) == 0.0
    assert limits(seated.step(Inputs())) == []


def test_check_fails_while_latched_and_repeats_after_unlatch(seated: aftdeck.Simulation) -> None:
    seated.step(Inputs(mode="OPR CMD"))
    start = seated.scenario.initial_angles.tolist()
    frame = checked(seated, Inputs(target=joint_target(seated.scenario.arm, start)))[-1]
    assert frame.check is not None and frame.check.cause == "seat"
    frames = [seated.step(Inputs(latch="unlatch"))]
    while any(cargo.seat for cargo in frames[-1].work.cargo):
        frames.append(seated.step(Inputs()))
        assert len(frames) <= 1600
    frames += [seated.step(Inputs()) for _ in range(5)]
    assert frames[-1].sequence == "checking"  # the checked motion is 60 m or longer, at the speed limit of the payload


def test_contact_limit_is_active_if_motion_would_deepen_it() -> None:
    sim = aftdeck.Simulation(srms(6.0, 0.0, 7.0))
    frames = [sim.step(Inputs(translation=(0.0, 0.0, 1.0))) for _ in range(600)]
    held = [frame for frame in frames if "contact" in limits(frame)]
    assert held and all(frame.work.arm_inhibit and len(frame.limits) == 1 for frame in held)
    assert all(max(abs(rate) for rate in frame.rates) == 0.0 for frame in held)
    assert limits(sim.step(UP)) != limits(held[-1])


def test_only_one_long_standstill_abandons_a_motion_not_many_short_ones() -> None:
    sim = aftdeck.Simulation(scenario(BAY, 'mode = "OPR CMD"'))
    checked(sim, Inputs(target=joint_target(sim.scenario.arm, (20.0, *BAY[1:]))))
    sim.step(Inputs(proceed=True))
    flight, state = sim._flight, sim._state
    longest = round(MAX_STOPPED_TIME / sim.scenario.control_period)

    def stand_still(steps: int) -> str:
        for _ in range(steps):
            state.report[RATIO] = 0.0
            finish(flight, state, state.log(sim.scenario.control_period))
        return state.panel.sequence

    for _ in range(3):
        assert stand_still(longest - 1) == "in progress"
        state.report[RATIO] = 1.0
        finish(flight, state, state.log(sim.scenario.control_period))
    assert stand_still(longest) == "ready" and state.panel.ending == "given up"


@pytest.mark.parametrize(
    ("switch", "name"), [(Inputs(brakes=True), "BRAKES"), (Inputs(safing=True), "SAFING")], ids=["brakes", "safing"]
)
def test_switch_limit_is_active_only_with_stick_input(switch: Inputs, name: str) -> None:
    sim = aftdeck.Simulation("first-flight")
    for _ in range(50):
        sim.step(UP)
    sim.step(switch)
    assert all(limits(sim.step(Inputs())) == [] for _ in range(50))
    frame = sim.step(UP)
    assert limits(frame) == ["switch"] and name in frame.limits[0].text
