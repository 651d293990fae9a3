"""MODE 3, docking: the conditions that the probe is in the docking envelope and at the port, and the axes are aligned.

The port is in the middle of a side face, c, of the central assembly element (CAE), a regular prism. The *docking
envelope* is the space in front of that face, between the extended planes of the two adjacent sides and of the two ends
of the prism. For a prism with six sides, this space is a wedge, whose edge is one apothem in front of the face.
Source: the final report of the Remote Manipulator Simulation, mode 3 (restored).

A port's axes coincide with those of a docked payload. The report compares only the two y axes, so that any rotation
about y is allowed. By default, all three axes are compared here.
"""

from __future__ import annotations

from math import inf, sqrt, tau
from typing import Literal

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, moved, relative
from aftdeck.bodies.vector import Vector, dot, vector_at
from aftdeck.elementary import atan2, sincos
from aftdeck.errors import InputError
from aftdeck.law import law
from aftdeck.matrices import dots, product
from aftdeck.worksite.conditions import Condition, within
from aftdeck.worksite.within import Within

BEFORE = 0
"""Least height of the probe's vertices above face c [m]."""
INSIDE = 1
"""Least distance of the probe's vertices from the envelope's other four planes [m]; positive inside the envelope."""
DISTANCE = 2
"""Distance from the centre of the probe's face to the port's centre [m]."""
TURNED = 3
"""First of three angles between payload and port [rad]: between their x axes, their y axes and their z axes."""
FOUND = 6
"""Length of the array of results."""

FEWEST_SIDES = 4


class DockingTolerances(msgspec.Struct, frozen=True):
    """Tolerances of docking."""

    distance: float
    """Greatest distance from the centre of the probe's forward face to the port's centre [m]; report: 0.25 ft [S]."""
    angle: float
    """Greatest angle between an axis of the payload and the same axis of the port [rad]; report: 2 deg 32 min [S]."""
    axes: Literal["all", "y"] = "all"
    """Axes that are compared: all three, or only y as in the report [S]."""


def envelope(
    apothem: float,
    length: float,
    *,
    sides: int = 6,
    outward: tuple[float, float, float] = (1.0, 0.0, 0.0),
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0),
    offset: tuple[float, float] = (0.0, 0.0),
) -> Array:
    """Return the docking envelope of a port on a side of a regular prism.

    The envelope is given in the port's axes, with the port's centre as origin.

    Args:
        apothem: distance from the prism's axis to its sides [m].
        length: length of the prism [m].
        sides: number of sides, an even number; the report's prism probably had six (its drawings are lost).
        outward: unit vector out of the port's face, perpendicular to `axis`.
        axis: unit vector along the prism.
        offset: offset of the port's centre from the centre of its face [m]: along the cross product of `axis` and
            `outward`, and along `axis`.

    Returns:
        (5, 4) planes, each with a unit normal n [1] and a distance d [m]. A point p is inside if n·p <= d for all
        planes. The first plane is that of face c.

    Raises:
        InputError: the sizes do not make a prism, or the vectors are not perpendicular unit vectors.
    """
    if not (0.0 < apothem < inf and 0.0 < length < inf):
        raise InputError(f"the prism's apothem is {apothem:g} m and its length {length:g} m; both have to be above 0")
    if not float(sides).is_integer() or sides < FEWEST_SIDES or sides % 2:
        raise InputError(f"the prism has {sides} sides; an even number, {FEWEST_SIDES} or more, is allowed")
    out, up = np.array(outward, dtype=np.float64), np.array(axis, dtype=np.float64)
    across = np.cross(up, out)
    axes = np.array([out, up, across])
    if not np.allclose(dots(axes, axes), 1.0, rtol=0.0, atol=_SQUARE):
        raise InputError(
            f"the port faces along {outward} and its prism extends along {axis}; these have to be perpendicular unit "
            "vectors"
        )
    port = apothem * out + offset[0] * across + offset[1] * up
    s, c = sincos(tau / sides)
    planes = np.empty((5, 4))
    planes[0] = *-out, float(product(port, out)) - apothem
    for k, (normal, distance) in enumerate(
        (
            (c * out - s * across, apothem),
            (c * out + s * across, apothem),
            (-up, 0.5 * length),
            (up, 0.5 * length),
        )
    ):
        planes[k + 1] = *normal, distance - float(product(normal, port))
    return planes


@law
def approach(probe: Array, face: Array, payload: Array, port: Array, planes: Array, found: Array) -> None:
    """Measure the position of a probe relative to a port and fill `found` (6,).

    Args:
        probe: (n, 3) vertices in the payload's frame [m].
        face: (3,) centre of the probe's forward face, in the payload's frame [m].
        payload: (12,) pose of the payload: position [m], then its rotation row by row.
        port: (12,) pose of the port, given in the same frame as the payload's pose.
        planes: (k, 4) the envelope in the port's frame, the plane of face c first.
        found: (6,) output, with the indices `BEFORE`, `INSIDE`, `DISTANCE` and `TURNED`.
    """
    pose = np.empty(POSE)  # the payload's pose in the port's frame
    relative(port, payload, pose)
    before = inside = np.inf
    for v in range(len(probe)):
        p = moved(pose, vector_at(probe[v], 0))
        before = min(before, _below(planes[0], p))
        for k in range(1, len(planes)):
            inside = min(inside, _below(planes[k], p))
    found[BEFORE], found[INSIDE] = before, inside
    centre = moved(pose, vector_at(face, 0))
    found[DISTANCE] = sqrt(dot(centre, centre))
    turn = pose[3:].reshape(3, 3)  # columns: the payload's axes in the port's frame
    found[TURNED] = _angle(turn[1, 0], turn[2, 0], turn[0, 0])
    found[TURNED + 1] = _angle(turn[0, 1], turn[2, 1], turn[1, 1])
    found[TURNED + 2] = _angle(turn[0, 2], turn[1, 2], turn[2, 2])


@law
def _angle(a: float, b: float, along: float) -> float:
    """Return the angle [rad] between an axis and a unit vector, whose components are `along` it and a, b across it."""
    return atan2(sqrt(a * a + b * b), along)


@law
def _below(plane: Array, p: Vector) -> float:
    """Return the distance of a point from a plane of the envelope [m]: positive inside, negative outside."""
    inside: float = plane[3] - plane[0] * p.x - plane[1] * p.y - plane[2] * p.z
    return inside


@law
def docking_values(found: Array, distance: float, angle: float, only_y: bool) -> tuple[Within, Within, Within, Within]:
    """Return the values of the conditions with their ranges: heights [m], distance [m], and greatest angle [rad].

    Args:
        found: (6,) output of `approach`.
        distance: `DockingTolerances.distance`.
        angle: `DockingTolerances.angle`.
        only_y: whether only the y axes are compared.
    """
    y = found[TURNED + 1]
    turn = y if only_y else max(found[TURNED], y, found[TURNED + 2])
    return (found[BEFORE], 0.0, inf), (found[INSIDE], 0.0, inf), (found[DISTANCE], -inf, distance), (turn, -inf, angle)


def docking(found: Array, tolerances: DockingTolerances) -> tuple[Condition, ...]:
    """Return the conditions of docking from the output (6,) of `approach`."""
    only_y = tolerances.axes == "y"
    letter = "y" if only_y else max(zip(found[TURNED:].tolist(), "xyz", strict=True))[1]
    says = f"payload's {letter} axis turned {{}} from the port's"
    before, inside, at, turned = docking_values(found, tolerances.distance, tolerances.angle, only_y)
    return (
        within("probe before port", *before, "m", _BEFORE_SAYS),
        within("probe in envelope", *inside, "m", _INSIDE_SAYS),
        within("probe at port", *at, "m", _DISTANCE_SAYS),
        within("payload's attitude", *turned, "rad", (says, says)),
    )


_BEFORE_SAYS = ("probe {} before the port's face", "probe {} behind the port's face")
_INSIDE_SAYS = ("probe {} inside the docking envelope", "probe {} outside the docking envelope")
_DISTANCE_SAYS = ("probe {} from the port", "")
_SQUARE = 1e-9
"""Tolerance in the check that a port's directions are perpendicular unit vectors [1]."""
