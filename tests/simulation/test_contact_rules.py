"""What an inhibit lets through, where essential contacts end, and what a free body meets: cases with known figures."""

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
from tests.simulation.sat import Witness

INCH = 0.0254
ROUNDING = 1e-6
"""[m]"""
ABOVE_BAR = (28.0, 0.0, 0.6)
"""The palm 0.14 ft over the bar [ft]."""
Vec3 = tuple[float, float, float]


def flown(made: Scenario, given: Iterable[Inputs]) -> tuple[Witness, list[Frame]]:
    """What an outside witness saw of a flight, and its frames."""
    sim = aftdeck.Simulation(made)
    witness, frames = Witness(sim), []
    for inputs in given:
        frames.append(sim.step(inputs))
        witness.look()
    return witness, frames


@pytest.mark.parametrize("push", [(-1.0, 0.0, 0.0), (0.0, 1.0, 0.0)], ids=["along the bay", "across it"])
def test_an_inhibited_arm_does_not_slide_along_what_it_is_in(push: Vec3) -> None:
    """Before: 130 in along the bay from a palm 0.26 in deep, and 70 in across it."""
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


def test_an_arm_whose_prong_alone_touches_does_not_fly_it_through_a_wall() -> None:
    """Before: the prong's contact left the arm free in mode 1, and the prong went 3.7 in into the payload and on."""
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
def test_a_finger_does_not_sweep_through_the_bar(side: float) -> None:
    """Before: 4.4 in deep. At 1 ft/s a step is 0.24 in long."""
    witness, frames = flown(scenario((28.0, 1.5 * side, 0.71)), [Inputs((0.0, 0.5 * side, 0.0))] * 200)
    assert max(witness.worst.values()) <= ROUNDING
    assert any(not contact.essential for contact in frames[-1].work.contacts)


def test_a_prong_closes_no_deeper_into_an_offset_bar_than_its_relation_permits() -> None:
    """Before: 0.9 in, which is 0.075 ft. One step of the prong is 0.06 in."""
    witness, frames = flown(scenario((28.0, 0.2, 0.71)), [Inputs(effector="close"), *[Inputs()] * 250])
    assert not frames[-1].work.cargo[0].held and frames[-1].work.finger_inhibit
    assert witness.deepest["prong", "payload receptacle"] <= 0.01 * FOOT + 2.0 * 0.06 * INCH


@pytest.mark.parametrize("aside", [(1.5, 0.0), (0.0, 1.5), (0.3, 0.0)])
def test_a_probe_does_not_enter_the_element_beside_the_port(aside: tuple[float, float]) -> None:
    """Before: 12.3 in deep beside the port, which is 1.02 ft. A step is 0.1 in long."""
    x, y, z = AT_PORT
    made = scenario((x + 0.5, y + aside[0], z + aside[1]), held=True)
    witness, frames = flown(made, [Inputs((0.3, 0.0, 0.0))] * 300)
    (contact,) = frames[-1].work.contacts
    assert (contact.a, contact.b, contact.essential) == ("payload probe", "CAE", False)
    assert frames[-1].work.arm_inhibit and not frames[-1].work.cargo[0].seat
    assert witness.deepest["payload probe", "CAE"] <= 0.25 * INCH


@pytest.mark.parametrize("mode", ["ORB LD", "ORB UNL"])
def test_trunnions_that_are_lowered_in_coarse_come_to_rest_on_their_seats(mode: str) -> None:
    """Before: 0.77 in under them."""
    made = srms(2.0, held=True)
    witness, frames = flown(made, [Inputs(mode=mode, rate="coarse"), *[Inputs((0.0, 0.0, 1.0))] * 500])
    assert max(witness.deepest.values()) <= ROUNDING
    assert not frames[-1].work.arm_inhibit
    touched = {frozenset((contact.a, contact.b)) for contact in frames[-1].work.contacts}
    assert touched & {frozenset(("payload trunnions", f"latches {side}")) for side in ("port", "starboard")}


WAYS: list[Vec3] = [(0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)]


@pytest.mark.parametrize("how", ["stop", "reflect"])
@pytest.mark.parametrize("way", WAYS, ids=["starboard", "port", "forward", "down"])
def test_a_payload_let_go_at_a_speed_meets_what_is_there_and_leaves_the_arm_free(way: Vec3, how: str) -> None:
    """Before: 74 in through the boom, 40 in through the floor, and the arm inhibited meanwhile."""
    made = scenario((28.0, 0.0, -12.0), held=True, extra=f'free_contact = "{how}"')
    let_go = [*[Inputs(way)] * 150, Inputs(way, effector="open"), *[Inputs(way)] * 10]
    witness, frames = flown(made, [*let_go, *[Inputs()] * 1000, *[Inputs((0.0, 0.0, -1.0))] * 100])
    assert max(witness.worst.values(), default=0.0) <= ROUNDING
    assert not any(frame.work.arm_inhibit for frame in frames)
    assert frames[-1].position[2] < frames[-101].position[2] - FOOT  # the arm leaves
    bumps = [event for frame in frames for event in frame.events if event.kind == "bump"]
    assert all("impulse unknown" in event.text for event in bumps)
    if bumps and how == "stop":
        assert len(bumps) < 20 and not np.any(frames[-1].work.cargo[0].velocity)
    assert bumps


def test_a_reflected_body_keeps_its_speed_and_goes_back() -> None:
    start = 'position = ["40 ft", "0 ft", "9 ft"], velocity = ["0 ft/s", "0 ft/s", "-1 ft/s"]'
    cargo = f'name = "free flyer"\nstart = {{ {start} }}'
    frames = {}
    for how in ("stop", "reflect"):
        made = scenario((28.0, 0.0, -20.0), cargo=cargo, extra=f'free_contact = "{how}"')
        witness, seen = flown(made, [Inputs()] * 1300)
        assert max(witness.deepest.values(), default=0.0) <= ROUNDING
        frames[how] = seen
    assert np.linalg.norm(frames["stop"][-1].work.cargo[0].velocity) == pytest.approx(0.0, abs=1e-9)
    down = frames["reflect"][0].work.cargo[0].velocity
    assert frames["reflect"][-1].work.cargo[0].velocity == pytest.approx(np.negative(down), abs=1e-3)


def test_a_body_that_the_arm_flies_into_is_told_with_the_speed_of_both() -> None:
    """Before: 0.047 in/s for an arm that came at 5.9 in/s."""
    along: Vec3 = (1.0, 0.0, 0.0)
    given = [Inputs(along)] * 600 + [Inputs(along, effector="open")] + [Inputs(along)] * 300
    text = Path("src/aftdeck/scenario/builtin/srms-berth.toml").read_text().split("[[phase]]")[0]
    frames = flown(parse_scenario(text, "test", "test.toml", Path(".")), [*given, *[Inputs((-1.0, 0.0, 0.0))] * 2000])[
        1
    ]
    met = next(k for k, frame in enumerate(frames) if any(event.kind == "bump" for event in frame.events))
    (told,) = (event.text for event in frames[met].events if event.kind == "bump")
    speed = float(re.search(r"([\d.]+) in/s", told)[1]) * INCH  # type: ignore[index]
    assert speed > 0.05 and speed == pytest.approx(
        max(contact.closing for contact in frames[met].work.contacts), rel=0.05
    )
