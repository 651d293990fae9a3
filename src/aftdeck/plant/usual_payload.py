"""Mass properties of a payload of which only the mass is known."""

from __future__ import annotations

import numpy as np

from aftdeck.bodies.mass_properties import MassProperties, cylinder
from aftdeck.bounds import Bounds
from aftdeck.units import FOOT, POUND, Mass

HEAVIEST = 65_000 * POUND
"""Mass of the heaviest payload of the Shuttle [kg] (firm)."""
LONGEST, WIDEST = 60 * FOOT, 15 * FOOT
"""Length and diameter of the heaviest payload, a cylinder that fills the payload bay [m] (firm)."""

PAYLOAD_MASS = Bounds(
    1e-3, Mass.bounds.greatest, "lighter payloads do not act on an arm, and heavier ones do not exist", Mass.unit
)
"""Masses of payloads that a plant with masses can move [kg]."""


def usual_payload(mass: float, axis: int = 0) -> MassProperties:
    """Return a uniform cylinder with the proportions and the density of the heaviest payload, about its centre.

    Args:
        mass: mass [kg].
        axis: number, from 0, of the axis along which the cylinder lies.
    """
    scale = float(np.cbrt(mass / HEAVIEST))
    end = np.zeros(3)
    end[axis] = 0.5 * scale * LONGEST
    return cylinder(mass, 0.5 * scale * WIDEST, -end, end)
