"""Berths: rejections with their reasons, one payload in each berth, and docking again after undocking."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.errors import ScenarioError
from tests.simulation.concept import AT_PORT, AT_STOWED, ON_BAR, scenario, vec3
from tests.simulation.flights import flown, log_of
from tests.simulation.independent_rules import ANGLE, DISTANCE, FOOT, docking, pose
from tests.simulation.payload_invariants import check_possession

seeds = st.integers(0, 2**32 - 1)
FLYER_AT_PORT = 'name = "payload"\n[[cargo]]\nname = "free flyer"\nstart = { seat = "port" }'
FLYER_IN_BAY = """name = "payload"
start = { position = ["28 ft", "0 ft", "-7.12 ft"] }
[[cargo]]
name = "free flyer"
start = { seat = "bay" }"""


def seated(frame: aftdeck.Frame, k: int = 0) -> str:
    return frame.work.cargo[k].seat


# --- one payload in each berth ------------------------------------------------------------------------------


def test_occupied_port_accepts_no_second_payload() -> None:
    alone = flown(scenario(AT_PORT, held=True), [Inputs()])
    assert seated(alone[0]) == "port"
    frames = flown(scenario(AT_PORT, held=True, cargo=FLYER_AT_PORT), [Inputs()] * 5 + [Inputs(latch="latch")])
    assert [seated(frame) for frame in frames] == [""] * 6 and seated(frames[-1], 1) == "port"
    assert frames[-1].events[-1].kind == "refused" and "Free-flying payload" in frames[-1].events[-1].text
    (full,) = (condition for condition in frames[-1].work.conditions if not condition.holds)
    assert full.name == "seat empty" and full.margin < 0.0


def test_occupied_bay_accepts_no_second_payload() -> None:
    for cargo, kept in (('name = "payload"', "bay"), (FLYER_IN_BAY, "")):
        frames = flown(scenario(ON_BAR, held=True, cargo=cargo), [Inputs(effector="open"), *[Inputs()] * 120])
        assert not frames[-1].work.cargo[0].held and seated(frames[-1]) == kept


def test_berth_that_a_captured_payload_comes_from_is_no_objective() -> None:
    frames = flown(scenario(ON_BAR), [Inputs(effector="close"), *[Inputs()] * 200])
    captured = [frame for frame in frames if frame.work.cargo[0].held]
    assert captured and seated(frames[0]) == "bay" and seated(captured[0]) == ""
    assert {frame.work.objective for frame in captured} == {None}


def test_scenario_with_two_payloads_in_one_berth_is_rejected() -> None:
    with pytest.raises(ScenarioError, match=r"'bay'.* 2 "):
        scenario(cargo='name = "payload"\n[[cargo]]\nname = "free flyer"\nstart = { seat = "bay" }')


def test_script_waits_for_latches_of_the_held_payload() -> None:
    """Another payload, which is fixed in the bay, does not end the phase."""
    cargo = 'name = "free flyer"\nstart = { position = ["28 ft", "0 ft", "-5.82 ft"] }\n[[cargo]]\nname = "payload"'
    phases = '[[phase]]\nmode = "ORB UNL"\nuntil = "latched"\nduration = "0.2 s"'
    made = scenario((28.0, 20.0, -25.0), held=True, cargo=f"{cargo}\n{phases}")
    done = aftdeck.run(made)
    assert done.frames[-1].work.cargo[0].held and done.frames[-1].work.cargo[1].seat == "bay"
    assert done.summary.ended == "fault"
    assert re.search("latched .*0.2 s", log_of(done.frames)[-1])


# --- docking again after undocking ---------------------------------------------------------------------------


@settings(max_examples=4)
@given(seeds)
def test_undocked_payload_docks_again_only_after_leaving_envelope(seed: int) -> None:
    rng = np.random.default_rng(seed)
    made = scenario(AT_PORT, held=True)
    sim = aftdeck.Simulation(made)
    frames = flown(sim, [Inputs(), Inputs(latch="unlatch")])
    assert [seated(frame) for frame in frames] == ["port", ""]
    nudge = vec3(rng.uniform(-1.0, 1.0, 3) * 0.05)
    out = int(rng.integers(60, 150))
    there_and_back = [*[Inputs(nudge)] * 20, *[Inputs((0.6, 0.0, 0.0))] * out, *[Inputs((-0.3, 0.0, 0.0))] * 400]
    left = False
    for inputs in there_and_back:
        frame = sim.step(inputs)
        frames.append(frame)
        margins = docking(frame)
        left = left or bool((margins < 0.0).any())
        if seated(frame):
            assert left and (margins >= -1e-9).all()
            break
        assert not (left and (margins > 1e-9).all())
    check_possession(made, frames)


def test_latch_docks_an_undocked_payload_again_at_once() -> None:
    sim = aftdeck.Simulation(scenario(AT_PORT, held=True))
    frames = flown(sim, [Inputs(), Inputs(latch="unlatch"), *[Inputs()] * 20, Inputs(latch="latch")])
    assert [seated(frame) for frame in frames] == ["port", *[""] * 21, "port"]


# --- rejections give the failed conditions with their values --------------------------------------------------


@pytest.mark.parametrize(
    ("place", "pressed", "line"),
    [
        (AT_PORT, "latch", "LATCH refused: Payload is docked already"),
        (ON_BAR, "latch", "LATCH refused: the Cargo bay fixes the payload on RELEASE"),
        ((28.0, 0.0, -30.0), "unlatch", "UNLATCH refused: no payload is at a berth"),
    ],
)
def test_rejected_latch_gives_the_reason(place: tuple[float, float, float], pressed: str, line: str) -> None:
    sim = aftdeck.Simulation(scenario(place, held=True))
    sim.step(Inputs())
    frame = sim.step(Inputs(latch=pressed))  # type: ignore[arg-type]
    assert log_of([frame]) == [line]


def test_rejected_latch_gives_distance_to_nearest_berth() -> None:
    sim, place = aftdeck.Simulation(scenario((28.0, 0.0, -30.0), held=True)), np.array((28.0, 0.0, -30.0))
    sim.step(Inputs())
    (line,) = log_of([sim.step(Inputs(latch="latch"))])
    found = re.fullmatch(r"LATCH refused: .* Payload is (.*) ft from the .* 9.84 ft .*", line)
    assert found
    away = min(np.linalg.norm(place - there) for there in (AT_PORT, ON_BAR))
    assert float(found[1]) == pytest.approx(away, abs=0.05)


def test_unlatch_is_rejected_in_the_concept_bay() -> None:
    (frame,) = flown(scenario(), [Inputs(latch="unlatch")])
    (event,) = frame.events
    assert event.kind == "refused" and "Cargo bay" in event.text and seated(frame) == "bay"


@settings(max_examples=6)
@given(seeds)
def test_rejected_docking_gives_failed_conditions_with_values(seed: int) -> None:
    rng = np.random.default_rng(seed)
    off, turned = rng.uniform(-1.0, 1.0, 3) * [0.3, 0.8, 0.8] + [0.9, 0.0, 0.0], rng.uniform(-6.0, 6.0, 3)
    frame = flown(scenario(vec3(AT_PORT + off), vec3(turned), held=True), [Inputs(latch="latch")])[0]
    margins = docking(frame)
    before, distance, angle = margins[0] * FOOT, margins[4] * FOOT, margins[5:].min()
    (line,) = (text for text in log_of([frame]) if text.startswith("LATCH refused: "))
    conditions = {condition.name: condition for condition in frame.work.conditions}
    assert conditions["probe before port"].margin == pytest.approx(before, abs=1e-9)
    assert conditions["probe at port"].margin == pytest.approx(distance, abs=1e-9)
    assert conditions["payload's attitude"].margin == pytest.approx(angle, abs=1e-9)
    assert distance < 0.0
    size = DISTANCE * FOOT - distance
    (number, unit) = re.search(r"probe ([\d.]+) (in|ft) from the port, at most 3 in allowed", line).groups()  # type: ignore[union-attr]
    assert float(number) * (FOOT if unit == "ft" else FOOT / 12.0) == pytest.approx(size, rel=6e-3)
    assert ("axis turned" in line) == (angle < 0.0)
    if angle < 0.0:
        (degrees,) = re.search(r"axis turned ([\d.]+)° from the port's", line).groups()  # type: ignore[union-attr]
        assert float(degrees) == pytest.approx(math.degrees(ANGLE - angle), rel=6e-3)


@settings(max_examples=6)
@given(seeds, st.floats(0.0, 1.0))
def test_released_payload_stays_in_bay_exactly_within_tolerances(seed: int, spread: float) -> None:
    rng = np.random.default_rng(seed)
    off, turned = spread * rng.uniform(-0.4, 0.4, 3), spread * rng.uniform(-3.0, 3.0, 3)
    sim = aftdeck.Simulation(scenario(vec3(ON_BAR + off), vec3(turned), held=True))
    frames = flown(sim, [Inputs(effector="open"), *[Inputs()] * 120])
    centre, axes = pose(frames[-1])
    turn = math.acos(min(1.0, max(-1.0, (np.trace(axes @ np.diag([1.0, -1.0, -1.0])) - 1.0) / 2.0)))
    margin = min(DISTANCE - float(np.linalg.norm(centre - AT_STOWED)), ANGLE - turn)
    assert not frames[-1].work.cargo[0].held
    if abs(margin) > 1e-6:
        assert seated(frames[-1]) == ("bay" if margin > 0.0 else "")
    (text,) = (event.text for frame in frames for event in frame.events if event.kind == "released")
    assert "Payload" in text and ("Cargo bay" in text) == bool(seated(frames[-1]))
