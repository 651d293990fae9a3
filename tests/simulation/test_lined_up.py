"""A payload that the hand is lined up with is no alarm; askew, beside it or in touch with it, it is."""

from __future__ import annotations

from itertools import pairwise

import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.simulation.frame import Frame
from aftdeck.worksite.report import Vec3
from tests.simulation.flights import srms
from tests.steering.flying import fly

HAND = {"end effector", "payload"}
FIXTURE = {"end effector", "payload grapple fixture"}
UPRIGHT: Vec3 = (0.0, 0.0, 0.0)


def first(above: float, x: float = 0.0, y: float = 0.0, turned: Vec3 = UPRIGHT) -> Frame:
    """The end effector so far over the pin, off it [in] and turned [deg]."""
    return aftdeck.Simulation(srms(above, x, y, turned)).step(Inputs())


def pair(frame: Frame) -> set[str]:
    assert frame.work.nearest is not None
    return {frame.work.nearest.a, frame.work.nearest.b}


@pytest.mark.parametrize("above", [2.0, 6.0, 20.0])
@pytest.mark.parametrize(("x", "turned"), [(0.0, 0.0), (3.0, 0.0), (7.0, 0.0), (0.0, 9.0), (0.0, 18.0)])
def test_in_line_with_a_pin_the_payload_is_no_alarm(above: float, x: float, turned: float) -> None:
    frame = first(above, x, turned=(turned, 0.0, 0.0))
    assert pair(frame) not in (HAND, FIXTURE)
    assert frame.work.clearance_level == "info"


@pytest.mark.parametrize(
    ("x", "y", "turned"),
    [
        (9.0, 0.0, UPRIGHT),
        (0.0, 9.0, UPRIGHT),
        (6.0, 6.0, UPRIGHT),
        (0.0, 0.0, (22.0, 0.0, 0.0)),
        (0.0, 0.0, (0.0, 22.0, 0.0)),
        (0.0, 0.0, (0.0, 0.0, 22.0)),
    ],
)
def test_beside_the_pin_or_askew_it_is(x: float, y: float, turned: Vec3) -> None:
    frame = first(6.0, x, y, turned)
    assert pair(frame) in (HAND, FIXTURE)
    assert frame.work.clearance_level != "info"


def test_a_capture_alarms_nobody_and_neither_does_backing_off() -> None:
    sim = aftdeck.Simulation(srms(2.0, 0.0, 0.0, UPRIGHT))
    frames = fly(sim, 20.0, Inputs(effector="close"))
    frames += fly(sim, 20.0, Inputs(effector="open"))
    assert {True, False} == {one.held for frame in frames for one in frame.work.cargo}
    assert not frames[-1].work.cargo[0].held
    assert {frame.work.clearance_level for frame in frames} == {"info"}


def test_the_concepts_hand_about_its_bar_is_no_alarm() -> None:
    sim = aftdeck.Simulation("concept-1972-script")
    frames = [sim.step() for _ in range(2000) if not sim.ended]
    before = [frame for frame in frames if not any(one.held for one in frame.work.cargo)]
    assert len(before) < len(frames), "nothing was acquired"
    told = [event.text for frame in before for event in frame.events if event.kind == "clearance"]
    assert not [text for text in told if "finger" in text or "palm" in text], told


def test_what_is_lined_up_and_touched_is_told_and_foreseen() -> None:
    sim = aftdeck.Simulation(srms(6.0, 0.0, 7.0, UPRIGHT))
    on = Inputs(translation=(0.0, 0.0, 1.0), rate="vernier")
    contact: list[float] = []
    for _ in range(120):
        (frame,) = fly(sim, sim.scenario.control_period, on)
        ahead = sim.ahead(5.0)
        if ahead.contact_s is not None and not contact:
            contact.append(frame.time_s)
        if frame.work.contacts:
            break
    assert frame.work.contacts and contact and contact[0] < frame.time_s


def test_a_touch_that_inhibits_the_arm_is_a_warning_until_it_is_relieved() -> None:
    sim = aftdeck.Simulation(srms(6.0, 0.0, 7.0, UPRIGHT))
    frames = fly(sim, 12.0, Inputs(translation=(0.0, 0.0, 1.0)))
    inhibited = [frame for frame in frames if frame.work.arm_inhibit]
    assert inhibited and inhibited[-1] is frames[-1]
    for frame in inhibited[2:]:
        assert pair(frame) <= {*HAND, "payload grapple fixture"}
        assert frame.work.clearance_level == "warning"
        assert frame.work.nearest is not None and frame.work.nearest.clearance <= 0.0
    off = fly(sim, 12.0, Inputs(translation=(0.0, 0.0, -1.0)))[-1]
    assert not off.work.arm_inhibit
    assert off.work.clearance_level == "info"


def test_a_saved_flight_goes_on_with_the_same_nearest_pair() -> None:
    sim = aftdeck.Simulation(srms(6.0, 9.0, 0.0, UPRIGHT))
    back = Inputs(translation=(1.0, 0.0, 0.0))
    for _ in range(60):
        sim.step(back)
        saved, now = sim.save(), sim.step(back)
        sim.restore(saved)
        assert sim.step(back).work.nearest == now.work.nearest


def test_at_its_edge_the_alarm_comes_once() -> None:
    sim = aftdeck.Simulation(srms(6.0, 7.0))
    levels = [sim.step(Inputs()).work.clearance_level]
    for k in range(400):
        side = 0.25 if k // 10 % 2 else -0.25
        levels.append(sim.step(Inputs(translation=(side, 0.0, 0.0), rate="vernier")).work.clearance_level)
    assert set(levels) == {"info"}, "trembling within the room between coming and leaving"
    out = [sim.step(Inputs(translation=(1.0, 0.0, 0.0))).work.clearance_level for _ in range(200)]
    assert sum("info" in (one, other) for one, other in pairwise(out) if one != other) == 1 and out[-1] != "info"
