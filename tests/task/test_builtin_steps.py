"""Steps of the built-in scenarios: the script of each scenario completes every step by itself, and in order."""

from __future__ import annotations

from dataclasses import replace

import pytest

from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation
from aftdeck.task.progress import Progress

QUICK = ["sts-400-closed", "uncradle", "first-flight", "sequence"]
SLOW = ["tutorial", "srms-deploy", "srms-berth", "loaded", "singular", "free-flyer", "sts-400-open", "sts-400-position"]
LOOK = 5
"""Control step at which the test changes a camera, which no script can do."""


@pytest.mark.parametrize("name", [*QUICK, *(pytest.param(name, marks=pytest.mark.slow) for name in SLOW)])
def test_script_completes_every_step_of_its_scenario(name: str) -> None:
    complete(Simulation(load_scenario(name)))


def test_script_of_the_whole_problem_completes_the_steps_of_the_concept() -> None:
    script, steps = load_scenario("concept-1972-script"), load_scenario("concept-1972").steps
    complete(Simulation(replace(script, steps=steps)))


def complete(sim: Simulation) -> None:
    """Run the script; fail unless it completes all steps, each in a step of its own."""
    progress, found = Progress(sim.scenario), []
    while not sim.ended:
        frame = sim.step()
        if frame.tick == LOOK:
            progress.look()
        if done := progress.see(frame):
            found.append(done)
    assert found == [(i,) for i in range(len(sim.scenario.steps))]
    times = [time for time in progress.done_s if time is not None]
    assert times == sorted(times)
    assert len(times) == len(sim.scenario.steps) > 0
    assert progress.present is None
    assert progress.skipped == ()
