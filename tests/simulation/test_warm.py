"""No law is compiled during a run, because `warm_up` calls every law before the run."""

from __future__ import annotations

import subprocess
import sys

import pytest

COUNT = """
import gc, sys
from numba.core.dispatcher import Dispatcher
import aftdeck
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.warm import warm_up

def compiled():
    laws = (law for law in gc.get_objects() if isinstance(law, Dispatcher))
    return {(law.py_func.__module__, law.py_func.__qualname__, len(law.signatures)) for law in laws}

scenario = load_scenario(sys.argv[1])
warm_up(scenario)
before = compiled()
sim = aftdeck.Simulation(scenario)
down = aftdeck.Inputs(translation=(0.0, 0.0, 1.0))
for _ in range(int(sys.argv[2])):
    sim.step(down if sys.argv[3] == "down" else None)
for module, name, _ in sorted(compiled() - before):
    print(module, name)
"""
"""Program that prints each law that a run compiles for new argument types."""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("scenario", "steps", "by"),
    [("concept-1972", 400, "down"), ("concept-1972-script", 2600, "script"), ("srms-deploy", 1500, "script")],
    ids=["palm in contact", "acquisition, sliding and docking", "capture"],
)
def test_no_law_is_compiled_during_a_run(scenario: str, steps: int, by: str) -> None:
    command = [sys.executable, "-c", COUNT, scenario, str(steps), by]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout == ""
