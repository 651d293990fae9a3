"""Compilation of all laws of this package: ``python -m aftdeck.visual.warm`` writes them into the cache on disk."""

from __future__ import annotations

from aftdeck.law import interpreted
from aftdeck.scenario.light import conditions
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.visual.picture import picture_of
from aftdeck.visual.png import pixels
from aftdeck.visual.scene import VisualScene

FILES = 81
"""Number of files with their machine code; `tests/test_law_change.py` counts them."""


def warm_up() -> None:
    """Draw a picture, which calls every law of this package."""
    scenario = load_scenario("concept-1972")
    with interpreted():  # one step
        frame = Simulation(scenario).step(Inputs())
    pixels(picture_of(VisualScene(scenario), frame, "A", (100, 100), "colour", conditions()[0]))


if __name__ == "__main__":
    warm_up()
