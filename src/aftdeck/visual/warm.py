"""Compilation of all laws of this package: ``python -m aftdeck.visual.warm`` writes them into the cache on disk."""

from __future__ import annotations

from aftdeck.law import interpreted
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.visual.scene import VisualScene

FILES = 73
"""Number of files with their machine code; `tests/test_law_change.py` counts them."""


def warm_up() -> None:
    """Draw a picture, which calls every law of this package."""
    scenario = load_scenario("concept-1972")
    with interpreted():  # one step
        frame = Simulation(scenario).step(Inputs())
    scene = VisualScene(scenario)
    scene.polygons(frame, scene.aim(frame, "A", 1.0))


if __name__ == "__main__":
    warm_up()
