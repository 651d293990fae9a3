"""Mass, centre of mass and inertia of rigid bodies: uniform spheres, cylinders, prisms and boxes, and joined bodies."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array

_ORIGIN = (0.0, 0.0, 0.0)
ROUNDING = 1e-9
"""Rounding of a principal moment, as a share of the greatest one [1]."""


class MassProperties(NamedTuple):
    """Mass properties of a rigid body in some frame.

    Attributes:
        mass: mass [kg].
        centre: (3,) centre of mass [m].
        inertia: (3, 3) moments of inertia about the centre of mass, along the frame's axes [kg m2].
    """

    mass: float
    centre: Array
    inertia: Array

    def moved(self, by: ArrayLike) -> MassProperties:
        """Return the same body, moved by a vector (3,) [m]."""
        return self._replace(centre=self.centre + np.asarray(by))


def tensor(moments: Sequence[float], products: Sequence[float] = _ORIGIN) -> Array:
    """Return a tensor of inertia (3, 3) [kg m2].

    Args:
        moments: Ixx, Iyy, Izz [kg m2].
        products: Ixy, Ixz, Iyz, the tensor's elements off the diagonal: Ixy is minus the integral of x y dm [kg m2].
    """
    (a, b, c), (d, e, f) = moments, products
    return np.array([[a, d, e], [d, b, f], [e, f, c]], dtype=np.float64)


def impossible(inertia: Array) -> str:
    """Return why no body has this tensor of inertia (3, 3) [kg m2]; "" if one has.

    The principal moments have to be above zero, and none may exceed the sum of the others.
    """
    least, middle, greatest = principal = np.linalg.eigvalsh(inertia).tolist()
    if least > 0.0 and greatest <= (least + middle) * (1.0 + ROUNDING):
        return ""
    given = _listed(inertia[k, k] for k in range(3))
    if products := [inertia[i, j] for i, j in ((0, 1), (0, 2), (1, 2)) if np.triu(inertia, 1).any()]:
        given += f" and the products {_listed(products)} kg m2: its principal moments would be {_listed(principal)}"
    rule = "the greatest exceeds the sum of the others" if least > 0.0 else "each has to be above 0"
    return f"no body has the moments of inertia {given} kg m2: {rule}"


def _listed(values: Iterable[float]) -> str:
    return ", ".join(f"{value:g}" for value in values)


def about(mass: float, place: Array) -> Array:
    """Return the inertia (3, 3) of a mass at a place (3,) [m] about the origin [kg m2]: the parallel-axis theorem."""
    inertia: Array = mass * (place @ place * np.eye(3) - np.outer(place, place))
    return inertia


def sphere(mass: float, radius: float, centre: ArrayLike = _ORIGIN) -> MassProperties:
    """Return a uniform sphere; its centre is in the frame of the result [m]."""
    return MassProperties(mass, np.array(centre, dtype=np.float64), 0.4 * mass * radius**2 * np.eye(3))


def cylinder(mass: float, radius: float, begin: ArrayLike, end: ArrayLike) -> MassProperties:
    """Return a uniform cylinder whose axis extends from one point (3,) to another [m]."""
    a, b = np.array(begin, dtype=np.float64), np.array(end, dtype=np.float64)
    length = float(np.linalg.norm(b - a))
    axis = (b - a) / length
    across = mass * (3.0 * radius**2 + length**2) / 12.0
    along = 0.5 * mass * radius**2
    return MassProperties(mass, 0.5 * (a + b), across * np.eye(3) + (along - across) * np.outer(axis, axis))


def prism(mass: float, across: float, sides: int, begin: ArrayLike, end: ArrayLike) -> MassProperties:
    """Return a uniform regular prism whose axis extends from one point (3,) to another [m].

    `across` is the distance between opposite corners [m]. The moments of inertia are those of the cylinder with
    the same polar moment of the cross-section.
    """
    square = (0.5 * across) ** 2 * (2.0 + np.cos(2.0 * np.pi / sides)) / 3.0
    return cylinder(mass, float(np.sqrt(square)), begin, end)


def box(mass: float, low: ArrayLike, high: ArrayLike) -> MassProperties:
    """Return a uniform box with edges along the frame's axes, from its least and greatest corner (3,) [m]."""
    a, b = np.array(low, dtype=np.float64), np.array(high, dtype=np.float64)
    squares = (b - a) ** 2
    return MassProperties(mass, 0.5 * (a + b), np.diag(mass * (squares.sum() - squares) / 12.0))


def joined(bodies: Sequence[MassProperties]) -> MassProperties:
    """Return the mass properties of one or more bodies that are fixed to each other."""
    mass = sum(body.mass for body in bodies)
    centre = sum((body.mass * body.centre for body in bodies), np.zeros(3)) / mass
    inertia = np.zeros((3, 3))
    for body in bodies:
        inertia += body.inertia + about(body.mass, body.centre - centre)
    return MassProperties(float(mass), centre, inertia)
