"""Task phases 1 to 4: each begins exactly when its conditions, computed independently, hold."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.simulation.frame import Frame
from aftdeck.worksite.report import Objective
from tests.simulation.concept import ABOVE, AT_PORT, ON_BAR, flown, scenario, vec3
from tests.simulation.independent_rules import acquisition, depth_in_bay, docking

ROUNDING = 1e-9
"""Smallest compared margin [ft], [rad]; the two computations may round a smaller margin differently."""
FIRST, EXTRACTION, MANOEUVRING, DOCKED = 1, 2, 3, 4
AT_RIM = (28.0, 0.0, -12.04)
"""Position of the palm at which the held payload leaves the bay [ft]."""
seeds = st.integers(0, 2**32 - 1)


def random_deflections(rng: np.random.Generator, steps: int, deflection: float, **first: str) -> Iterator[Inputs]:
    """Yield random deflections in all directions, changed every half second; switches act in the first step."""
    inputs = Inputs()
    for k in range(steps):
        if k % 25 == 0:
            translation, rotation = (vec3(deflection * rng.uniform(-1.0, 1.0, 3)) for _ in range(2))
            inputs = Inputs(translation, rotation)
        yield Inputs(inputs.translation, inputs.rotation, **first) if k == 0 else inputs  # type: ignore[arg-type]


def agrees(margins: np.ndarray, verdict: bool) -> bool:
    """Return whether a verdict agrees with the margins of the conditions."""
    return bool((margins >= -ROUNDING).all() if verdict else not (margins > ROUNDING).all())


def check_entries(frames: Sequence[Frame]) -> None:
    """Check the conditions at each entry into a task phase, and the task phase of each frame."""
    for before, now in pairwise(frames):
        cargo, was = now.work.cargo[0], before.work.cargo[0]
        if cargo.held and not was.held:
            assert agrees(acquisition(now), True), now.time_s
        if cargo.seat == "port" and not was.seat:
            assert agrees(docking(now), True), now.time_s
        if not cargo.held:
            assert now.work.task == FIRST
        elif cargo.seat == "port":
            assert now.work.task == DOCKED
        elif abs(depth := depth_in_bay(now)) > ROUNDING:
            assert now.work.task == (EXTRACTION if depth > 0.0 else MANOEUVRING), now.time_s
        texts = [event.text for event in now.events if event.kind == "task"]
        assert bool(texts) == (now.work.task != before.work.task)
        assert all(f"MODE {now.work.task}" in text for text in texts)


@settings(max_examples=15)
@given(seeds, st.floats(0.0, 1.0))
def test_payload_is_captured_exactly_when_six_conditions_hold(seed: int, spread: float) -> None:
    rng = np.random.default_rng(seed)
    off = spread * rng.uniform(-1.0, 1.0, 3) * [1.3, 0.15, 0.05] - [0.0, 0.0, 0.02]
    turned = spread * rng.uniform(-1.0, 1.0, 3) * [1.5, 1.2, 4.0]
    sim = aftdeck.Simulation(scenario(vec3(ON_BAR + off), vec3(turned)))
    frames = flown(sim, random_deflections(rng, 200, 0.05, rate="vernier", effector="close"))
    check_entries(frames)
    for before, now in pairwise(frames):
        if not before.work.cargo[0].held:
            assert agrees(acquisition(now), now.work.cargo[0].held), now.time_s


def test_prong_closed_above_the_bar_captures_nothing() -> None:
    sim = aftdeck.Simulation(scenario((ON_BAR[0], ON_BAR[1], ON_BAR[2] - 0.1)))
    frames = flown(sim, [Inputs(effector="close"), *[Inputs()] * 220])
    assert frames[-1].work.hand.opening == 0.0
    assert not any(frame.work.cargo[0].held for frame in frames)
    failing = [condition.name for condition in frames[-1].work.conditions if not condition.holds]
    assert failing == ["palm height"]
    assert frames[-1].work.objective == Objective("acquire", "acquire Payload")


@settings(max_examples=12)
@given(seeds, st.floats(0.0, 1.0), st.sampled_from(["all axes", "y axis"]))
def test_payload_docks_exactly_when_all_conditions_hold(seed: int, spread: float, axes: str) -> None:
    rng = np.random.default_rng(seed)
    off = spread * rng.uniform(-1.0, 1.0, 3) * [0.3, 0.3, 0.3] + [0.3, 0.0, 0.0]
    turned = spread * rng.uniform(-1.0, 1.0, 3) * (6.0 if axes == "y axis" else 2.5)
    made = scenario(vec3(AT_PORT + off), vec3(turned), held=True, extra=f'docking = "{axes}"')
    sim = aftdeck.Simulation(made)
    inward = Inputs(translation=(0.3, 0.0, 0.0))
    frames = flown(sim, [*random_deflections(rng, 50, 0.2), *[inward] * 150])
    compared = "y" if axes == "y axis" else "xyz"
    for before, now in pairwise(frames):
        if not before.work.cargo[0].seat:
            assert agrees(docking(now, axes=compared), now.work.cargo[0].seat == "port"), now.time_s
    if axes == "all axes":
        check_entries(frames)


@settings(max_examples=8)
@given(seeds)
def test_held_payload_is_in_extraction_exactly_inside_the_bay(seed: int) -> None:
    rng = np.random.default_rng(seed)
    at = np.array(AT_RIM) + rng.uniform(-1.0, 1.0, 3) * [0.5, 0.4, 0.3]
    sim = aftdeck.Simulation(scenario(vec3(at), held=True))
    frames = flown(sim, random_deflections(rng, 250, 0.5))
    check_entries(frames)


def test_payload_beside_the_orbiter_is_not_in_the_bay() -> None:
    sim = aftdeck.Simulation(scenario((28.0, 20.0, -8.0), held=True))
    assert sim.step(Inputs()).work.task == MANOEUVRING


@pytest.mark.slow
def test_full_problem_enters_every_task_phase_by_its_conditions() -> None:
    run = aftdeck.run("concept-1972-script")
    assert run.summary.ended == "completed"
    check_entries(run.frames)
    modes = [frame.work.task for frame in run.frames]
    entered = [modes[0], *(now for before, now in pairwise(modes) if now != before)]
    assert entered == [1, 2, 3, 4, 1, 4, 3, 2, 1]


def test_run_begins_in_task_phase_1_above_the_bar() -> None:
    frame = aftdeck.Simulation(scenario(ABOVE)).step(Inputs())
    assert frame.work.task == FIRST
    assert (acquisition(frame)[:3] > 0.0).all()
