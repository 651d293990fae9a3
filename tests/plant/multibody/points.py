"""Clouds of point masses: bodies of any shape, whose mass properties follow from sums alone."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array


class Points(NamedTuple):
    """Point masses.

    Attributes:
        masses: (n,) masses [kg].
        places: (n, 3) places, from the payload's centre in its axes [m].
    """

    masses: Array
    places: Array

    @property
    def mass(self) -> float:
        """Mass of the cloud [kg]."""
        return float(self.masses.sum())

    @property
    def centre(self) -> Array:
        """Centre of mass (3,) [m]."""
        centre: Array = self.masses @ self.places / self.mass
        return centre

    def tensor(self, about: Array) -> Array:
        """Return the tensor of inertia (3, 3) about a point (3,), from the integral that defines each element."""
        x, y, z = (self.places - about).T
        integrals = [[y * y + z * z, -x * y, -x * z], [-x * y, x * x + z * z, -y * z], [-x * z, -y * z, x * x + y * y]]
        found: Array = np.array(integrals) @ self.masses
        return found

    def fields(self) -> dict[str, object]:
        """Return the fields of a payload's table."""
        i = self.tensor(self.centre)
        return {
            "mass": self.mass,
            "inertia": np.diag(i).tolist(),
            "products": [float(i[0, 1]), float(i[0, 2]), float(i[1, 2])],
            "centre_of_mass": self.centre.tolist(),
        }

    def toml(self) -> str:
        """Return these fields as lines of a file."""
        return "".join(f"{name} = {value}\n" for name, value in self.fields().items())


def cloud(seed: int, mass: float = 2000.0) -> Points:
    """Return a random cloud of a mass [kg] that is a few metres long."""
    rng = np.random.default_rng(seed)
    shares = rng.uniform(0.2, 1.0, 6)
    return Points(mass * shares / shares.sum(), rng.uniform(-1.0, 1.0, (6, 3)) * [3.0, 1.5, 1.0] + [0.5, -0.2, 0.1])
