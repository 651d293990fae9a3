"""A scenario made ready to fly: everything a step needs that never changes."""

from __future__ import annotations

from dataclasses import dataclass

from aftdeck.arrays import Array
from aftdeck.plant.slide import Travel, travel_of_prong, travel_of_stand
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.cameras import Cameras
from aftdeck.simulation.site import Site, site_of

Pair = tuple[float, float]

WATCHED = 0.1
"""What is nearer than this [m], or than what comes nearer at `FAST`, is measured in every step."""
FAST = 5.0
"""More than anything moves at [m/s]."""


@dataclass(frozen=True, eq=False)
class Flight:
    """The constants of a flight.

    Attributes:
        scenario: what is flown.
        site: the worksite.
        cameras: those that can be turned.
        telescope: where the stand can go, and
        prong: where the prong can.
        within: what is nearer than this is measured in every step [m].
        reach: joint limits as plain pairs [rad], as `soft` and `hard`, for the zones.
    """

    scenario: Scenario
    site: Site
    cameras: Cameras
    telescope: Travel
    prong: Travel
    within: float
    reach: tuple[Pair, ...]
    soft: tuple[Pair, ...]
    hard: tuple[Pair, ...]


def prepare(scenario: Scenario) -> Flight:
    """The flight of a scenario."""
    model = scenario.arm.model

    def pairs(limits: Array) -> tuple[Pair, ...]:
        return tuple((float(low), float(high)) for low, high in limits)

    return Flight(
        scenario,
        site_of(scenario),
        Cameras(scenario),
        travel_of_stand(model),
        travel_of_prong(model.equipment.prong),
        max(WATCHED, FAST * scenario.control_period),
        pairs(model.limits.reach),
        pairs(model.limits.soft),
        pairs(model.limits.hard),
    )
