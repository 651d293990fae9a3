"""Constants of a run: everything that a step needs and that never changes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import get_args

from aftdeck.arrays import Array
from aftdeck.plant.linear_actuator import Travel, travel_of_prong, travel_of_stand
from aftdeck.plant.plant import Plant
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.camera_drives import Cameras
from aftdeck.simulation.constants.plant import kinematic_plant, plant_of
from aftdeck.simulation.constants.site import Site, site_of
from aftdeck.simulation.row.constants import Packed, packed
from aftdeck.worksite.watch.alarm import Level, unchanged_between

Pair = tuple[float, float]

WATCHED = 0.1
"""Least value of `Flight.within` [m]."""
FAST = 5.0
"""Speed that no part exceeds [m/s]."""


@dataclass(frozen=True, eq=False)
class Flight:
    """Constants of a run.

    Attributes:
        scenario: the scenario.
        plant: model that turns commanded rates into motion.
        site: the worksite.
        cameras: cameras that have a drive.
        telescope: range and rate of the telescope.
        prong: range and rate of the prong.
        within: clearance below which a pair is measured in every step [m]; at least the distance that a part can cover
            in one step.
        reach: reach limits of the joints, as pairs of Python floats [rad].
        hard: hard stops of the joints, as pairs of Python floats [rad].
    """

    scenario: Scenario
    plant: Plant
    site: Site
    cameras: Cameras
    telescope: Travel
    prong: Travel
    within: float
    reach: tuple[Pair, ...]
    hard: tuple[Pair, ...]

    @cached_property
    def inhibits(self) -> bool:
        """Whether a detrimental contact inhibits motion: without contact forces, or if the scenario asks for it."""
        return self.scenario.inhibit or not self.plant.has_contact_forces

    @cached_property
    def same_level(self) -> dict[Level, tuple[float, float]]:
        """Limits of the clearances after which each alarm level remains as it is [m]."""
        caution, warning = self.scenario.caution, self.scenario.warning
        return {level: unchanged_between(level, caution, warning) for level in get_args(Level)}

    @cached_property
    def packed(self) -> Packed:
        """The same constants in flat arrays, for compiled code."""
        return packed(self)

    @cached_property
    def rehearsed(self) -> Flight:
        """The same constants with the kinematic plant, on which CMD CK rehearses."""
        return replace(self, plant=kinematic_plant(self.scenario))


def run_constants(scenario: Scenario, *, gauged: bool = False) -> Flight:
    """Return the constants of a run of a scenario; `gauged`: whether its plant has gauges (`plant.readings`)."""
    model = scenario.arm.model

    def pairs(limits: Array) -> tuple[Pair, ...]:
        return tuple((float(low), float(high)) for low, high in limits)

    site = site_of(scenario)
    return Flight(
        scenario,
        plant_of(scenario, site, gauged=gauged),
        site,
        Cameras(scenario),
        travel_of_stand(model),
        travel_of_prong(model),
        max(WATCHED, FAST * scenario.control_period),
        pairs(model.limits.reach),
        pairs(model.limits.hard),
    )
