"""LATCH and UNLATCH of a payload that the arm does not hold: conditions, and confirmation."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.arrays import Array
from aftdeck.errors import ScenarioError
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.payloads.latch_command import CONFIRM
from aftdeck.worksite.file.load import load_worksite
from tests.simulation.concept import AT_STOWED, scenario
from tests.simulation.flights import events_of, srms
from tests.simulation.independent_rules import ANGLE, CAE, CAE_APOTHEM, DISTANCE, FOOT, SIZES, docking, pose
from tests.simulation.shuttle_rules import latching

seeds = st.integers(0, 2**32 - 1)
AT_PORT = CAE + np.array([CAE_APOTHEM + SIZES["payload"].length / 2.0 + 1.0, 0.0, 0.0])
"""The docked payload's centre in the scene [ft]."""
IN_BAY = AT_STOWED * [1.0, -1.0, -1.0]
EXACT = 1e-6


def floating(centre: Array, turned: Array) -> str:
    """Return a [[cargo]] table of a payload that floats at a position in the scene [ft], rotated [deg]."""
    (x, y, z), (a, b, c) = centre.tolist(), turned.tolist()
    place = f'position = ["{x!r} ft", "{y!r} ft", "{z!r} ft"], rotation = ["{a!r} deg", "{b!r} deg", "{c!r} deg"]'
    return f'name = "payload"\nstart = {{ {place} }}'


def pressed(made: Scenario) -> tuple[Frame, Frame]:
    """Return the frame before LATCH, and the frame of LATCH."""
    sim = aftdeck.Simulation(made)
    return sim.step(Inputs()), sim.step(Inputs(latch="latch"))


@settings(max_examples=25)
@given(seeds, st.floats(0.0, 1.0))
def test_latch_docks_floating_payload_if_conditions_hold(seed: int, spread: float) -> None:
    rng = np.random.default_rng(seed)
    off = spread * rng.uniform(-0.2, 0.2, 3) + [0.2 * spread, 0.0, 0.0]
    try:
        made = scenario(cargo=floating(AT_PORT + off, spread * rng.uniform(-2.0, 2.0, 3)))
    except ScenarioError:
        assume(False)  # the payload would start inside the element
    before, after = pressed(made)
    margins = docking(before)
    assert not before.work.cargo[0].seat
    if np.abs(margins).min() > EXACT:
        assert (after.work.cargo[0].seat == "port") == bool((margins > 0.0).all())
    assert ("refused" in {kind for kind, _ in events_of([after])}) != (after.work.cargo[0].seat == "port")


@settings(max_examples=25)
@given(seeds, st.floats(0.0, 1.0))
def test_latch_fixes_floating_payload_in_bay_within_tolerances(seed: int, spread: float) -> None:
    rng = np.random.default_rng(seed)
    off, turned = spread * rng.uniform(-0.25, 0.25, 3), spread * rng.uniform(-2.0, 2.0, 3)
    try:
        made = scenario(cargo=floating(IN_BAY + off, turned))
    except ScenarioError:
        assume(False)  # the payload would start inside the bay's floor
    before, after = pressed(made)
    centre, axes = pose(before)
    turn = math.acos(min(1.0, max(-1.0, (np.trace(axes @ np.diag([1.0, -1.0, -1.0])) - 1.0) / 2.0)))
    margin = min(DISTANCE - float(np.linalg.norm(centre - AT_STOWED)), ANGLE - turn)
    if abs(margin) > EXACT:
        assert after.work.cargo[0].seat == ("bay" if margin > 0.0 else "")


@settings(max_examples=15)
@given(seeds, st.floats(0.0, 1.0))
def test_latches_fix_floating_payload_if_trunnions_are_ready(seed: int, spread: float) -> None:
    """Examples that start inside another body are left out, because loading rejects them."""
    rng = np.random.default_rng(seed)
    off = spread * rng.uniform(-0.05, 0.05, 3) * [1.0, 0.4, 0.2] + [0.0, 0.0, 0.04 * spread]
    place = np.array(load_worksite("orbiter").berths[0].pose.position) / FOOT + off / FOOT
    table = floating(place, spread * rng.uniform(-0.2, 0.2, 3))
    text = srms(60.0).text.replace('name = "payload"', table)
    try:
        sim = aftdeck.Simulation(parse_scenario(text, "test", "test.toml", Path(".")))
    except ScenarioError:
        assume(False)
    frame = sim.step(Inputs())
    margins = latching(frame)
    frame = sim.step(Inputs(latch="latch"))
    if np.abs(margins).min() > EXACT:
        assert (frame.work.cargo[0].seat == "bay") == bool((margins > 0.0).all())


def port_scenario() -> Scenario:
    return scenario(cargo='name = "payload"\nstart = { seat = "port" }')


@settings(max_examples=25)
@given(st.lists(st.integers(1, int(1.4 * CONFIRM / 0.02)), min_size=1, max_size=3))
def test_port_releases_unheld_payload_only_after_second_unlatch(gaps: list[int]) -> None:
    """A switch that is held, or pressed in successive steps, is one command."""
    sim, tick, first, is_free = aftdeck.Simulation(port_scenario()), 0, -math.inf, False
    for gap in [1, *gaps]:
        frame = sim.step(Inputs())
        for _ in range(gap - 1):
            frame = sim.step(Inputs())
        frame = sim.step(Inputs(latch="unlatch"))
        tick += gap + 1
        is_free = (tick - first) * 0.02 <= CONFIRM
        first = tick
        assert (frame.work.cargo[0].seat == "") == is_free
        assert any(event.level == "caution" for event in frame.events)
        if is_free:
            return


def test_held_unlatch_switch_is_one_command() -> None:
    sim = aftdeck.Simulation(port_scenario())
    frames = [sim.step(Inputs(latch="unlatch")) for _ in range(100)]
    assert {frame.work.cargo[0].seat for frame in frames} == {"port"}
    assert events_of(frames) == [("unlatch", "caution")]


def test_shuttle_latches_need_confirmation_for_unheld_payload() -> None:
    sim = aftdeck.Simulation(srms(60.0, head="control_period = 0.08"))
    frames = [sim.step(Inputs(latch="unlatch")), *[sim.step(Inputs()) for _ in range(400)]]
    assert frames[-1].work.cargo[0].seat == "bay"
    again = [
        sim.step(Inputs()),
        sim.step(Inputs(latch="unlatch")),
        sim.step(Inputs()),
        sim.step(Inputs(latch="unlatch")),
    ]
    later = again + [sim.step(Inputs()) for _ in range(400)]
    assert not later[-1].work.cargo[0].seat
    (freed,) = (event for frame in later for event in frame.events if event.kind == "unseated")
    assert freed.level == "caution"
    closed = [sim.step(Inputs(latch="latch")), *[sim.step(Inputs()) for _ in range(400)]]
    assert closed[-1].work.cargo[0].seat == "bay" and ("latched", "info") in events_of(closed)


def test_unlatch_acts_only_on_the_held_payload() -> None:
    """Previously UNLATCH opened every berth."""
    docked = 'name = "payload"\n[[cargo]]\nname = "free flyer"\nstart = { seat = "port" }'
    sim = aftdeck.Simulation(scenario((28.0, 0.0, -20.0), held=True, cargo=docked))
    frames = [sim.step(Inputs(latch="unlatch")) for _ in range(3)] + [
        sim.step(Inputs()),
        sim.step(Inputs(latch="unlatch")),
    ]
    assert {frame.work.cargo[1].seat for frame in frames} == {"port"}
    assert "refused" in {kind for kind, _ in events_of(frames)}


@pytest.mark.parametrize("name", ["srms-deploy", "tutorial"])
def test_payload_can_be_unlatched_and_latched_at_its_start(name: str) -> None:
    """A payload that was fixed in a berth is within the envelope of the berth."""
    sim = aftdeck.Simulation(name)
    start = sim.step(Inputs()).work.cargo[0].seat
    assert start
    period = sim.scenario.control_period
    for inputs in (Inputs(latch="unlatch"), Inputs(), Inputs(latch="unlatch")):
        sim.step(inputs)
    frames = [sim.step(Inputs()) for _ in range(round(31.0 / period))]
    assert not frames[-1].work.cargo[0].seat
    assert sim.step(Inputs(latch="latch")).work.cargo[0].seat == start
