"""Telescope of the concept arm on a plant with masses: at the end of its range it passes the end by millimetres."""

from __future__ import annotations

from aftdeck import Inputs
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.run import Simulation
from aftdeck.station.conversion.frame_of import Displays


def test_telescope_past_the_end_of_its_range_ends_no_run() -> None:
    scenario = load_scenario("concept-1972", {("plant",): "rigid"})
    telescope = scenario.arm.model.telescope
    assert telescope is not None
    sim, displays = Simulation(scenario), Displays(scenario)
    lengths = []
    for _ in range(1000):
        frame = sim.step(Inputs(telescope=1.0))
        assert frame.work.stand is not None
        lengths.append(frame.work.stand)
        displays.frame(frame, -1)
    assert telescope.greatest < max(lengths) < telescope.greatest + 0.01
