"""The pair of parts that the present step of the task brings together."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
import pytest

from aftdeck.arms.solids import solids_of
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.target import AtBerth, AtPayload
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.task.pair import TaskPairs
from aftdeck.task.remaining import Aims
from aftdeck.worksite.report import Near
from tests.loaded import scenario


def found(
    made: Scenario, at: int | None, inputs: Inputs | None = None, number: int = 1
) -> tuple[Near | None, Simulation]:
    """Return the pair of a step after some control steps, and the simulation."""
    sim = Simulation(made)
    for _ in range(number):
        frame = sim.step(inputs or Inputs())
    return TaskPairs(made).nearest(sim.watched, frame, None if at is None else made.steps[at]), sim


def step_to(made: Scenario, kind: type[AtPayload] | type[AtBerth]) -> int:
    return next(i for i, step in enumerate(made.steps) if isinstance(step.target, kind))


@pytest.mark.parametrize("name", ["concept-1972", "srms-deploy", "free-flyer"])
def test_pair_on_the_way_to_a_payload_is_a_part_of_the_arm_and_a_part_of_the_payload(name: str) -> None:
    made = scenario(name)
    pair, sim = found(made, step_to(made, AtPayload))
    assert pair is not None
    target = Aims(made).target(sim.look(), made.steps[step_to(made, AtPayload)])
    assert isinstance(target, AtPayload)
    own = {solid.part for solid in made.payloads[target.payload].solids}
    assert (pair.a in own) != (pair.b in own)


def test_pair_on_the_way_to_a_berth_is_a_part_of_the_payload_and_a_part_beside_the_berth() -> None:
    made = scenario("srms-berth")
    pair, _ = found(made, step_to(made, AtBerth))
    assert pair is not None
    own = {solid.part for solid in made.payloads[0].solids}
    beside = {solid.part for solid in made.worksite.solids}
    assert {pair.a, pair.b} & own and {pair.a, pair.b} & beside


def test_no_monitored_pair_of_arm_and_payload_is_nearer() -> None:
    made = scenario("concept-1972")
    pair, sim = found(made, step_to(made, AtPayload))
    own = {solid.part for solid in made.payloads[0].solids}
    arm = {solid.part for solid in solids_of(made.arm.model)}
    assert pair is not None
    assert pair.clearance == min(
        near.clearance for near in sim.watched() if {near.a, near.b} & own and {near.a, near.b} & arm
    )


def test_clearance_of_the_pair_falls_by_the_motion_towards_the_bar() -> None:
    made = scenario("concept-1972")
    at = step_to(made, AtPayload)
    down = Inputs(translation=(0.0, 0.0, 1.0))
    pairs = [found(made, at, down, number) for number in (1, 60)]
    heights = [np.array(sim.look().position)[2] for _, sim in pairs]
    clearances = [pair.clearance for pair, _ in pairs if pair is not None]
    assert abs(clearances[0] - clearances[1]) == pytest.approx(abs(heights[0] - heights[1]), rel=0.02)
    assert clearances[1] < clearances[0]


@pytest.mark.parametrize("name", ["uncradle", "first-flight", "singular"])
def test_task_without_a_payload_or_a_berth_has_no_pair_and_measures_none(name: str) -> None:
    made = scenario(name)
    sim = Simulation(made)
    frame = sim.step(Inputs())

    def never() -> Sequence[Near]:
        pytest.fail("the pairs were measured in vain")

    finder = TaskPairs(made)
    for step in itertools.chain(made.steps, [None] if not made.payloads else []):
        if step is None or not isinstance(step.target, AtPayload | AtBerth):
            assert finder.nearest(never, frame, step) is None
