"""Calls of all laws that a session needs."""

from __future__ import annotations

from aftdeck.scenario.model import Scenario
from aftdeck.simulation import warm
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.conversion.frame_of import Displays


def warm_up(scenario: Scenario) -> None:
    """Call every law of a session once: those of a run, and of the conversion of its frames."""
    warm.warm_up(scenario)
    simulation, displays = Simulation(scenario), Displays(scenario)
    frame = simulation.step(Inputs())
    displays.frame(frame, -1)
    displays.ahead(simulation.ahead(), frame)
