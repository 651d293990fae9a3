"""Mass, centre of mass and inertia of rigid bodies: uniform spheres, cylinders, prisms and boxes, and joined bodies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array

_ORIGIN = (0.0, 0.0, 0.0)


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


def impossible(a: float, b: float, c: float) -> str:
    """Return why no body has these principal moments of inertia; "" if one has."""
    greatest = max(a, b, c)
    if 2.0 * greatest <= a + b + c:
        return ""
    return f"no body has the moments of inertia {a:g}, {b:g}, {c:g} kg m2: the greatest exceeds the sum of the others"


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
        arm = body.centre - centre
        inertia += body.inertia + body.mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    return MassProperties(float(mass), centre, inertia)
