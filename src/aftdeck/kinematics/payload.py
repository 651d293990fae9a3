"""LNKAGE with a payload attached: computes the payload's centre and axes from the tip's pose.

Source: JSC-12628, subroutine LNKAGE, the part for PA = 1.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.frames import Pose
from aftdeck.matrices import product
from aftdeck.shapes import Shape

PACKED = 15
"""Number of values in a packed payload."""


@dataclass(frozen=True, eq=False)
class HeldPayload:
    """Payload that the end effector holds.

    Attributes:
        mass: mass [kg]; the limits of the point of resolution depend on it.
        rotation: (3, 3) T_78: payload axes as columns, in frame 7.
        centre: (3,) r_87: vector from the tip to the payload's centre, in payload axes [m].
        por: (3,) vector from the payload's centre to its point of resolution, in payload axes [m].
        shapes: drawn shapes, in payload axes about the payload's centre.
        solids: solids, each with (8, 3) vertices in payload axes about the payload's centre [m].
        inertia: (3, 3) tensor of inertia about the centre of mass, in payload axes [kg m2]; zero if only the mass
            matters.
        centre_of_mass: (3,) vector from the payload's centre to its centre of mass, in payload axes [m].
    """

    mass: float
    rotation: Array
    centre: Array
    por: Array
    shapes: tuple[Shape, ...] = ()
    solids: tuple[Array, ...] = ()
    inertia: Array = field(default_factory=lambda: np.zeros((3, 3)))
    centre_of_mass: Array = field(default_factory=lambda: np.zeros(3))

    @cached_property
    def packed(self) -> Array:
        """Array (15,) for the laws: rotation row by row, then centre, then point of resolution."""
        return np.concatenate((self.rotation.ravel(), self.centre, self.por))

    @property
    def properties(self) -> MassProperties:
        """Mass properties in frame 7, with the tip as origin."""
        turned = product(product(self.rotation, self.inertia), self.rotation.T)
        return MassProperties(self.mass, product(self.rotation, self.centre + self.centre_of_mass), turned)

    def pose(self, tip: Pose) -> Pose:
        """Return the payload's centre and axes (T_B8 = T_B7 T_78, r_7B = r_6B + T_B8 r_87) for tip poses (...)."""
        rotation = product(tip.rotation, self.rotation)
        return Pose(tip.position + product(rotation, self.centre), rotation)

    def resolution(self, tip: Pose) -> Array:
        """Return the payload's point of resolution (..., 3) [m] for tip poses (...)."""
        return np.asarray(tip.position + product(tip.rotation, product(self.rotation, self.centre + self.por)))
