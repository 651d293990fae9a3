"""CLEARANCE during capture: an aligned payload raises no alarm, a misaligned or touching one does."""

from __future__ import annotations

from itertools import pairwise

import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.simulation.frame import Frame
from aftdeck.tuples import Vec3
from tests.simulation.flights import srms
from tests.steering.flying import fly

HAND = {"end effector", "payload"}
FIXTURE = {"end effector", "payload grapple fixture"}
UPRIGHT: Vec3 = (0.0, 0.0, 0.0)


def first(above: float, x: float = 0.0, y: float = 0.0, turned: Vec3 = UPRIGHT) -> Frame:
    """Return the first frame of a run that starts above the pin, offset from it [in] and rotated [deg]."""
    return aftdeck.Simulation(srms(above, x, y, turned)).step(Inputs())


def pair(frame: Frame) -> set[str]:
    assert frame.work.nearest is not None
    return {frame.work.nearest.a, frame.work.nearest.b}


@pytest.mark.parametrize("above", [2.0, 6.0, 20.0])
@pytest.mark.parametrize(("x", "turned"), [(0.0, 0.0), (3.0, 0.0), (7.0, 0.0), (0.0, 9.0), (0.0, 18.0)])
def test_aligned_payload_raises_no_alarm(above: float, x: float, turned: float) -> None:
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
def test_misaligned_payload_raises_alarm(x: float, y: float, turned: Vec3) -> None:
    frame = first(6.0, x, y, turned)
    assert pair(frame) in (HAND, FIXTURE)
    assert frame.work.clearance_level != "info"


def test_capture_and_release_raise_no_alarm() -> None:
    sim = aftdeck.Simulation(srms(2.0, 0.0, 0.0, UPRIGHT))
    frames = fly(sim, 20.0, Inputs(effector="close"))
    frames += fly(sim, 20.0, Inputs(effector="open"))
    assert {True, False} == {payload.held for frame in frames for payload in frame.work.cargo}
    assert not frames[-1].work.cargo[0].held
    assert {frame.work.clearance_level for frame in frames} == {"info"}


def test_concept_arm_about_its_bar_raises_no_alarm() -> None:
    sim = aftdeck.Simulation("concept-1972-script")
    frames = [sim.step() for _ in range(2000) if not sim.ended]
    before = [frame for frame in frames if not any(payload.held for payload in frame.work.cargo)]
    assert len(before) < len(frames), "no payload was captured"
    texts = [event.text for frame in before for event in frame.events if event.kind == "clearance"]
    assert not [text for text in texts if "finger" in text or "palm" in text], texts


def test_contact_of_aligned_payload_is_predicted_and_reported() -> None:
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


def test_contact_that_inhibits_the_arm_is_a_warning() -> None:
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


def test_restored_run_has_same_minimum_clearance_pair() -> None:
    sim = aftdeck.Simulation(srms(6.0, 9.0, 0.0, UPRIGHT))
    back = Inputs(translation=(1.0, 0.0, 0.0))
    for _ in range(60):
        sim.step(back)
        saved, now = sim.save(), sim.step(back)
        sim.restore(saved)
        assert sim.step(back).work.nearest == now.work.nearest


def test_alarm_at_alignment_limit_occurs_once() -> None:
    sim = aftdeck.Simulation(srms(6.0, 7.0))
    levels = [sim.step(Inputs()).work.clearance_level]
    for k in range(400):
        side = 0.25 if k // 10 % 2 else -0.25
        levels.append(sim.step(Inputs(translation=(side, 0.0, 0.0), rate="vernier")).work.clearance_level)
    assert set(levels) == {"info"}, "small motion inside the hysteresis changes the level"
    out = [sim.step(Inputs(translation=(1.0, 0.0, 0.0))).work.clearance_level for _ in range(200)]
    changes = [(before, now) for before, now in pairwise(out) if before != now]
    assert sum("info" in change for change in changes) == 1 and out[-1] != "info"
