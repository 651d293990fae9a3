"""Motion under an inhibit, limits of essential contacts, and contacts of free bodies: cases with known figures."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.worksite.watch.contact_motion import ESCAPE
from tests.simulation.concept import AT_PORT, FOOT, scenario
from tests.simulation.flights import srms
from tests.simulation.sat import DepthMeter

INCH = 0.0254
ROUNDING = 1e-6
"""Allowed rounding error of a depth [m]."""
ABOVE_BAR = (28.0, 0.0, 0.6)
"""Start position of the palm, 0.14 ft above the bar [ft]."""
Vec3 = tuple[float, float, float]


def flown(made: Scenario, given: Iterable[Inputs]) -> tuple[DepthMeter, list[Frame]]:
    """Run with manual inputs; return the measured depths and the frames."""
    sim = aftdeck.Simulation(made)
    meter, frames = DepthMeter(sim), []
    for inputs in given:
        frames.append(sim.step(inputs))
        meter.measure()
    return meter, frames


@pytest.mark.parametrize("push", [(-1.0, 0.0, 0.0), (0.0, 1.0, 0.0)], ids=["along the bay", "across it"])
def test_inhibited_arm_does_not_slide_along_a_contact(push: Vec3) -> None:
    """Previously the arm, at a depth of 0.26 inches, slid 130 inches along the bay and 70 inches across it."""
    sim = aftdeck.Simulation(scenario(ABOVE_BAR))
    frame = sim.step(Inputs())
    while not frame.work.arm_inhibit:
        frame = sim.step(Inputs((0.0, 0.0, 0.3)))
    deep = -min(contact.clearance for contact in frame.work.contacts)
    begin = np.array(frame.position)
    for _ in range(300):
        frame = sim.step(Inputs(push))
    assert deep > 0.2 * INCH
    assert np.linalg.norm(np.array(frame.position) - begin) <= deep / ESCAPE


def test_contact_of_prong_alone_inhibits_the_arm() -> None:
    """Previously contact did not inhibit the arm in task phase 1: the prong penetrated the payload by 3.7 inches."""
    sim = aftdeck.Simulation(scenario((28.0, -2.7, 0.95), (-20.0, 0.0, 0.0)))
    frame = sim.step(Inputs(effector="close"))
    while not frame.work.finger_inhibit:
        frame = sim.step(Inputs())
    assert {(contact.a, contact.b) for contact in frame.work.contacts} == {("prong", "payload")}
    assert frame.work.arm_inhibit
    begin = frame.position
    for _ in range(100):
        frame = sim.step(Inputs((0.0, 0.0, 1.0)))
    assert np.linalg.norm(np.subtract(frame.position, begin)) < INCH


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_finger_does_not_pass_through_the_bar(side: float) -> None:
    """Previously the finger penetrated the bar by 4.4 inches. At 1 ft/s, it moves 0.24 inches in a control step."""
    meter, frames = flown(scenario((28.0, 1.5 * side, 0.71)), [Inputs((0.0, 0.5 * side, 0.0))] * 200)
    assert max(meter.worst.values()) <= ROUNDING
    assert any(not contact.essential for contact in frames[-1].work.contacts)


def test_prong_penetrates_offset_bar_only_to_permitted_depth() -> None:
    """Previously the prong penetrated the bar by 0.9 inches. It moves 0.06 inches in a control step."""
    meter, frames = flown(scenario((28.0, 0.2, 0.71)), [Inputs(effector="close"), *[Inputs()] * 250])
    assert not frames[-1].work.cargo[0].held and frames[-1].work.finger_inhibit
    assert meter.deepest["prong", "payload receptacle"] <= 0.01 * FOOT + 2.0 * 0.06 * INCH


@pytest.mark.parametrize("aside", [(1.5, 0.0), (0.0, 1.5), (0.3, 0.0)])
def test_probe_does_not_enter_the_element_beside_the_port(aside: tuple[float, float]) -> None:
    """Previously the probe penetrated the element by 12.3 inches. It moves 0.1 inches in a control step."""
    x, y, z = AT_PORT
    made = scenario((x + 0.5, y + aside[0], z + aside[1]), held=True)
    meter, frames = flown(made, [Inputs((0.3, 0.0, 0.0))] * 300)
    (contact,) = frames[-1].work.contacts
    assert (contact.a, contact.b, contact.essential) == ("payload probe", "CAE", False)
    assert frames[-1].work.arm_inhibit and not frames[-1].work.cargo[0].seat
    assert meter.deepest["payload probe", "CAE"] <= 0.25 * INCH


@pytest.mark.parametrize("mode", ["ORB LD", "ORB UNL"])
def test_trunnions_lowered_in_coarse_stop_on_their_seats(mode: str) -> None:
    """Previously the trunnions stopped 0.77 inches below their seats."""
    made = srms(2.0, held=True)
    meter, frames = flown(made, [Inputs(mode=mode, rate="coarse"), *[Inputs((0.0, 0.0, 1.0))] * 500])
    assert max(meter.deepest.values()) <= ROUNDING
    assert not frames[-1].work.arm_inhibit
    touched = {frozenset((contact.a, contact.b)) for contact in frames[-1].work.contacts}
    assert touched & {frozenset(("payload trunnions", f"latches {side}")) for side in ("port", "starboard")}


WAYS: list[Vec3] = [(0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)]


@pytest.mark.slow
@pytest.mark.parametrize("how", ["stop", "reflect"])
@pytest.mark.parametrize("way", WAYS, ids=["starboard", "port", "forward", "down"])
def test_released_moving_payload_stops_and_leaves_arm_free(way: Vec3, how: str) -> None:
    """Previously the payload penetrated the boom by 74 inches and the floor by 40 inches, and inhibited the arm."""
    made = scenario((28.0, 0.0, -12.0), held=True, extra=f'free_contact = "{how}"')
    let_go = [*[Inputs(way)] * 150, Inputs(way, effector="open"), *[Inputs(way)] * 10]
    meter, frames = flown(made, [*let_go, *[Inputs()] * 1000, *[Inputs((0.0, 0.0, -1.0))] * 100])
    assert max(meter.worst.values(), default=0.0) <= ROUNDING
    assert not any(frame.work.arm_inhibit for frame in frames)
    assert frames[-1].position[2] < frames[-101].position[2] - FOOT  # the arm moves away
    bumps = [event for frame in frames for event in frame.events if event.kind == "bump"]

    if bumps and how == "stop":
        assert len(bumps) < 20 and not np.any(frames[-1].work.cargo[0].velocity)
    assert bumps


def test_reflected_body_keeps_its_speed() -> None:
    start = 'position = ["40 ft", "0 ft", "9 ft"], velocity = ["0 ft/s", "0 ft/s", "-1 ft/s"]'
    cargo = f'name = "free flyer"\nstart = {{ {start} }}'
    frames = {}
    for how in ("stop", "reflect"):
        made = scenario((28.0, 0.0, -20.0), cargo=cargo, extra=f'free_contact = "{how}"')
        meter, seen = flown(made, [Inputs()] * 1300)
        assert max(meter.deepest.values(), default=0.0) <= ROUNDING
        frames[how] = seen
    assert np.linalg.norm(frames["stop"][-1].work.cargo[0].velocity) == pytest.approx(0.0, abs=1e-9)
    down = frames["reflect"][0].work.cargo[0].velocity
    assert frames["reflect"][-1].work.cargo[0].velocity == pytest.approx(np.negative(down), abs=1e-3)


def test_contact_of_free_body_is_logged_with_closing_speed() -> None:
    """Previously the log gave 0.047 in/s for an arm that moved at 5.9 in/s."""
    along: Vec3 = (1.0, 0.0, 0.0)
    given = [Inputs(along)] * 600 + [Inputs(along, effector="open")] + [Inputs(along)] * 300
    text = Path("src/aftdeck/scenario/builtin/srms-berth.toml").read_text().split("[[phase]]")[0]
    frames = flown(parse_scenario(text, "test", "test.toml", Path(".")), [*given, *[Inputs((-1.0, 0.0, 0.0))] * 2000])[
        1
    ]
    first = next(frame for frame in frames if any(event.kind == "bump" for event in frame.events))
    (text,) = (event.text for event in first.events if event.kind == "bump")
    speed = float(re.search(r"([\d.]+) in/s", text)[1]) * INCH  # type: ignore[index]
    assert speed > 0.05 and speed == pytest.approx(max(contact.closing for contact in first.work.contacts), rel=0.05)
