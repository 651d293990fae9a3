"""TABLE II of runs: each word decodes to the frame's value within half a last bit, in all task phases.

The bits of the switches are those of the inputs, also under an inhibit.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.historical.frame_words import decode_control, encode_block, number
from aftdeck.historical.rms_vs_output import block_of, places_of
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.units import FOOT
from tests.simulation import concept
from tests.simulation.flights import random_inputs
from tests.simulation.master_inputs import random_master_inputs

HALF_B0, HALF_B1, HALF_B11 = 2.0**-24, 2.0**-23, 2.0**-13 * FOOT
"""Half a last bit of a word at these scales: [1], [1], [m]."""
GREATEST = 1.0 - 2.0**-23
"""Greatest value of a word at B0, the report's scale for normals; no word at B0 represents 1."""
FINGERS = ("palm", "fixed finger", "prong")


class StepWords(NamedTuple):
    """A step of a run: the previous frame, the frame and words of the step, the simulation, and what is unsaid."""

    before: Frame
    frame: Frame
    words: tuple[int, ...]
    sim: aftdeck.Simulation
    unsaid: tuple[str, ...]


def sampled_steps(made: Scenario, given: Iterable[Inputs | None], every: int) -> Iterator[StepWords]:
    """Yield every `every`-th step of a run."""
    sim = aftdeck.Simulation(made)
    last, before = sim.step(Inputs()), places_of(sim._state)
    for k, inputs in enumerate(given):
        if sim.ended:
            return
        sampled = k % every == 0
        if sampled:
            last, before = sim.look(), places_of(sim._state)
        sim.advance(inputs)
        if sampled:
            block, unsaid = block_of(sim._flight, sim._state, sim.flown, before)
            yield StepWords(last, sim.look(), encode_block(block), sim, unsaid)


def check(
    before: Frame, frame: Frame, words: tuple[int, ...], sim: aftdeck.Simulation, unsaid: tuple[str, ...]
) -> None:
    """Compare the words of a step with its frame, by computations that are independent of the encoder."""
    work, was, control = frame.work, before.work, decode_control(words[0])
    initialised = any(event.kind == "initialise" for event in frame.events)
    assert (control.mode, control.initialise) == (work.task, initialised)
    assert (control.finger_inhibited, control.arm_inhibited) == (work.finger_inhibit, work.arm_inhibit)
    switch = {"close": 1, "open": -1, "stop": 0}[work.hand.switch]
    lifted = 0.0 if initialised else (work.stand or 0.0) - (was.stand or 0.0)
    closed = 0.0 if initialised else round((was.hand.spacing or 0.0) - (work.hand.spacing or 0.0), 12)
    switched = [
        (np.sign(sim.flown.telescope), lifted, work.arm_inhibit, control.telescope),
        (switch, closed, work.finger_inhibit, control.prong),
    ]
    for on, moved, inhibited, bits in switched:
        assert bits == (on if inhibited or moved else 0)
    drive = sim.flown.camera
    if drive is not None:
        assert drive.camera == control.station
        signs = np.sign([drive.pan, drive.tilt, drive.zoom])
        assert "tilt" in unsaid or [control.pan, control.tilt, control.zoom] == signs.tolist()
    else:
        assert (control.pan, control.tilt, control.zoom) == (0, 0, 0)
    for angle, s, c in zip(frame.angles, words[1:13:2], words[2:13:2], strict=True):
        assert abs(number(s, 1) - math.sin(angle)) <= HALF_B1 and abs(number(c, 1) - math.cos(angle)) <= HALF_B1
    for k, plane in enumerate(planes(frame, sim)):
        *normal, distance = words[13 + 4 * k : 17 + 4 * k]
        if plane is None:
            assert not any((*normal, distance))
            continue
        for word, value in zip(normal, plane[:3], strict=True):
            assert abs(number(word, 0) - min(value, GREATEST)) <= HALF_B0
        assert abs(number(distance, 11) * FOOT - plane[3]) <= HALF_B11
    assert not any(words[25:])


def planes(frame: Frame, sim: aftdeck.Simulation) -> list[tuple[float, ...] | None]:
    """Return normal and distance of each of the planes D1, D2 and D3; None for a plane that does not exist.

    They are faces of the end effector while it holds a payload, otherwise separating planes of the collision test.
    """
    if any(cargo.held for cargo in frame.work.cargo):
        tip, (x2, y2, _) = np.array(frame.position), np.array(frame.orientation).T
        prong = sim.scenario.arm.model.prong
        assert prong is not None and frame.work.hand.spacing is not None
        finger = prong.facing
        inner = ((x2, 0.0 * x2), (-y2, finger * y2), (y2, (finger - frame.work.hand.spacing) * y2))
        return [(*n.tolist(), float(n @ (tip + at))) for n, at in inner]
    near = [pair for pair in sim.watched() if pair.b.endswith("receptacle")]
    bar = next((pair.b for pair in near if pair.a == "palm"), "")
    found = {pair.a: (*pair.normal, pair.distance) for pair in near if pair.b == bar and any(pair.normal)}
    return [found.get(name) for name in FINGERS]


def manual_inputs(rng: np.random.Generator, scenario: Scenario) -> Iterator[Inputs]:
    yield from random_master_inputs(rng, scenario, 300)
    yield from random_inputs(rng, 300, switches=0.3)


@pytest.mark.parametrize(
    "name",
    ["concept-1972-script", *(pytest.param(name, marks=pytest.mark.slow) for name in ("concept-1972", "free-flyer"))],
)
def test_words_of_random_run_decode_to_its_frames(name: str) -> None:
    scenario = load_scenario(name)
    for step in sampled_steps(scenario, manual_inputs(np.random.default_rng(19), scenario), 3):
        check(*step)


@pytest.mark.parametrize("held_at", [concept.ON_BAR, (28.0, 0.0, -25.0)])
def test_words_with_held_payload_decode_to_its_frames(held_at: concept.Vec3) -> None:
    scenario = concept.scenario(held_at, held=True)
    given = list(random_inputs(np.random.default_rng(7), 300, 0.3, without=("effector",)))
    for step in sampled_steps(scenario, given, 3):
        assert step.frame.work.task in (2, 3)
        check(*step)


@pytest.mark.slow
def test_words_of_full_problem_decode_to_its_frames() -> None:
    scenario = load_scenario("concept-1972-script")
    tasks = set()
    for step in sampled_steps(scenario, iter(lambda: None, 0), 15):
        tasks.add(step.frame.work.task)
        check(*step)
    assert tasks == {1, 2, 3, 4}
