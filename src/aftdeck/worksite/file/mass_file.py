"""Distribution of a payload's mass in a file: one table for every kind of payload, of worksites and of scenarios."""

from __future__ import annotations

from typing import Annotated

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import impossible, tensor
from aftdeck.bounds import Bounds
from aftdeck.units import MomentOfInertia
from aftdeck.worksite.tables import Point, Table

_Moment = Annotated[MomentOfInertia, Bounds(1e-9, 1e10, "the ISS has about 1e8 kg m2")]
_Product = Annotated[MomentOfInertia, Bounds(-1e10, 1e10, "the ISS has moments of about 1e8 kg m2")]


class MassTable(Table, frozen=True, kw_only=True):
    """Distribution of a payload's mass. Without these fields, the payload is uniform (docs/dynamics.md).

    `inertia` has the moments Ixx, Iyy, Izz about the centre of mass, along the payload's axes, and `products` Ixy, Ixz,
    Iyz: the elements of the tensor off its diagonal, so that Ixy is minus the integral of x y dm. `centre_of_mass` is
    the vector from the payload's centre to its centre of mass, in the payload's axes.
    """

    inertia: tuple[_Moment, _Moment, _Moment] | None = None
    products: tuple[_Product, _Product, _Product] | None = None
    centre_of_mass: Point | None = None

    def tensor_problem(self) -> str:
        """Return why no body has the given moments and products of inertia; "" if one has, or if none are given."""
        if self.inertia is None:
            return "" if self.products is None else "products of inertia need the moments: give inertia too"
        return impossible(tensor(self.inertia, self.products or (0.0, 0.0, 0.0)))

    def tensor(self) -> Array | None:
        """Return the tensor of inertia (3, 3) [kg m2]; None if the file gives none."""
        return None if self.inertia is None else tensor(self.inertia, self.products or (0.0, 0.0, 0.0))

    def mass_centre(self) -> Array | None:
        """Return the centre of mass (3,) from the payload's centre [m]; None if the file gives none."""
        return None if self.centre_of_mass is None else np.array(self.centre_of_mass, dtype=np.float64)
