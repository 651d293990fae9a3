"""Compilation of the laws that a run with the priority routine calls."""

from __future__ import annotations

from aftdeck.law_change import FILES as RUN_FILES
from aftdeck.scenario.model import Scenario
from aftdeck.simulation import warm as simulation
from aftdeck.visual import warm as visual

FILES = RUN_FILES + visual.FILES
"""Number of files with their machine code."""


def warm_up(scenario: Scenario) -> None:
    """Call every law of a run and of a picture."""
    simulation.warm_up(scenario)
    visual.warm_up()
