"""Plant of a run, made from the scenario."""

from __future__ import annotations

from aftdeck.plant.kinematic import KinematicPlant
from aftdeck.plant.linear_actuator import travel_of_stand
from aftdeck.plant.plant import Plant
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.constants.site import Site


def plant_of(scenario: Scenario, site: Site, *, gauged: bool = False) -> Plant:
    """Return the plant that the scenario names, with gauges if it has masses and `gauged` is true.

    Only a plant with masses imports MuJoCo.
    """
    if scenario.plant == "kinematic":
        return kinematic_plant(scenario)
    from aftdeck.simulation.constants.multibody import multibody_plant

    return multibody_plant(scenario, site, gauged=gauged)


def kinematic_plant(scenario: Scenario) -> KinematicPlant:
    """Return the kinematic plant, on which CMD CK rehearses in every run."""
    model = scenario.arm.model
    return KinematicPlant(model.limits.hard, travel_of_stand(model), scenario.control_period)
