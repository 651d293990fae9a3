"""MODE 3, docking: the payload's probe in the port's envelope, at the port, and turned as the port is.

The port stands in the middle of a side face, c, of the central assembly element (CAE), a regular prism. The *docking
envelope* is what lies before that face and, of the prism's next two sides and its two ends, all extended, inside: a
wedge, which with six sides closes one apothem before the face. Source: the final report of the Remote Manipulator
Simulation, mode 3 (restored).

A port's axes are those of the payload that is docked to it. The report compares the two y axes alone, which leaves a
turn about y free; by default all three are compared.
"""

from __future__ import annotations

from math import atan2, cos, inf, sin, sqrt, tau
from typing import Literal

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.law import law
from aftdeck.worksite.conditions import Condition, Units, within

BEFORE = 0
"""Least height of the probe's vertices over face c [m]."""
INSIDE = 1
"""How far inside the envelope's other planes the vertex nearest to one is; negative outside [m]."""
DISTANCE = 2
"""From the centre of the probe's face to the port's centre [m]."""
TURNED = 3
"""Angles of the payload's x, y and z axes from the port's, three numbers [rad]."""
FOUND = 6
"""Length of what is found."""

FEWEST_SIDES = 4


class DockingTolerances(msgspec.Struct, frozen=True):
    """What docking allows."""

    distance: float
    """From the centre of the probe's forward face to the port's centre [m]; the report has 0.25 ft [S]."""
    angle: float
    """Of each axis compared [rad]; the report has 2 deg 32 min [S]."""
    axes: Literal["all", "y"] = "all"
    """Which axes are compared; the report has y alone [S]."""


def envelope(
    apothem: float,
    length: float,
    *,
    sides: int = 6,
    outward: tuple[float, float, float] = (1.0, 0.0, 0.0),
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0),
    offset: tuple[float, float] = (0.0, 0.0),
) -> Array:
    """The docking envelope of a port on a side of a regular prism, in the port's axes about the port's centre.

    Args:
        apothem: from the prism's axis to its sides [m].
        length: of the prism [m].
        sides: how many, an even number; six is likely what the report had, whose drawings are lost.
        outward: unit vector out of the port's face, square to
        axis: unit vector along the prism.
        offset: the port's centre from that of its face [m]: along axis x outward, and along axis.

    Returns:
        (5, 4) planes, each a unit normal n [1] and a distance d [m]: inside is n·p <= d. The first is that of face c.

    Raises:
        InputError: sizes that make no prism, or vectors that are not square unit vectors.
    """
    if not (0.0 < apothem < inf and 0.0 < length < inf):
        raise InputError(f"the prism's apothem is {apothem:g} m and its length {length:g} m; both have to be above 0")
    if not float(sides).is_integer() or sides < FEWEST_SIDES or sides % 2:
        raise InputError(f"the prism has {sides} sides; an even number, {FEWEST_SIDES} or more, is allowed")
    out, up = np.array(outward, dtype=np.float64), np.array(axis, dtype=np.float64)
    across = np.cross(up, out)
    if not np.allclose([out @ out, up @ up, across @ across], 1.0, rtol=0.0, atol=_SQUARE):
        raise InputError(
            f"the port looks along {outward} and its prism along {axis}; they have to be unit vectors, square to "
            "each other"
        )
    port = apothem * out + offset[0] * across + offset[1] * up
    turn = tau / sides
    planes = np.empty((5, 4))
    planes[0] = *-out, port @ out - apothem
    for k, (normal, distance) in enumerate(
        (
            (cos(turn) * out - sin(turn) * across, apothem),
            (cos(turn) * out + sin(turn) * across, apothem),
            (-up, 0.5 * length),
            (up, 0.5 * length),
        )
    ):
        planes[k + 1] = *normal, distance - normal @ port
    return planes


@law
def approach(probe: Array, face: Array, payload: Array, port: Array, planes: Array, found: Array) -> None:
    """Measure how a probe stands to a port; fills `found` (6,).

    Args:
        probe: (n, 3) vertices in the payload's frame [m].
        face: (3,) centre of the probe's forward face, in the payload's frame [m].
        payload: (12,) pose of the payload: position [m], then its rotation row by row; in one frame with
        port: (12,) pose of the port.
        planes: (k, 4) the envelope in the port's frame, face c's first.
        found: (6,) what is measured.
    """
    x, y, z = payload[0] - port[0], payload[1] - port[1], payload[2] - port[2]
    px = port[3] * x + port[6] * y + port[9] * z
    py = port[4] * x + port[7] * y + port[10] * z
    pz = port[5] * x + port[8] * y + port[11] * z
    turn = np.empty((3, 3))  # the payload's axes in the port's, as columns
    for i in range(3):
        for j in range(3):
            turn[i, j] = port[3 + i] * payload[3 + j] + port[6 + i] * payload[6 + j] + port[9 + i] * payload[9 + j]
    before = inside = np.inf
    for v in range(len(probe)):
        a, b, c = probe[v, 0], probe[v, 1], probe[v, 2]
        x = px + turn[0, 0] * a + turn[0, 1] * b + turn[0, 2] * c
        y = py + turn[1, 0] * a + turn[1, 1] * b + turn[1, 2] * c
        z = pz + turn[2, 0] * a + turn[2, 1] * b + turn[2, 2] * c
        before = min(before, planes[0, 3] - planes[0, 0] * x - planes[0, 1] * y - planes[0, 2] * z)
        for k in range(1, len(planes)):
            inside = min(inside, planes[k, 3] - planes[k, 0] * x - planes[k, 1] * y - planes[k, 2] * z)
    found[BEFORE], found[INSIDE] = before, inside
    a, b, c = face[0], face[1], face[2]
    x = px + turn[0, 0] * a + turn[0, 1] * b + turn[0, 2] * c
    y = py + turn[1, 0] * a + turn[1, 1] * b + turn[1, 2] * c
    z = pz + turn[2, 0] * a + turn[2, 1] * b + turn[2, 2] * c
    found[DISTANCE] = sqrt(x * x + y * y + z * z)
    found[TURNED] = atan2(sqrt(turn[1, 0] ** 2 + turn[2, 0] ** 2), turn[0, 0])
    found[TURNED + 1] = atan2(sqrt(turn[0, 1] ** 2 + turn[2, 1] ** 2), turn[1, 1])
    found[TURNED + 2] = atan2(sqrt(turn[0, 2] ** 2 + turn[1, 2] ** 2), turn[2, 2])


def docking(found: Array, tolerances: DockingTolerances, units: Units) -> tuple[Condition, ...]:
    """The conditions of docking from what the law found (6,)."""
    value = found.tolist()
    if tolerances.axes == "y":
        letter, angle = "y", value[TURNED + 1]
    else:
        angle, letter = max(zip(value[TURNED:], "xyz", strict=True))
    says = f"payload's {letter} axis turned {{}} from the port's"
    return (
        within("probe before port", value[BEFORE], 0.0, inf, "m", units, _BEFORE_SAYS),
        within("probe in envelope", value[INSIDE], 0.0, inf, "m", units, _INSIDE_SAYS),
        within("probe at port", value[DISTANCE], -inf, tolerances.distance, "m", units, _DISTANCE_SAYS),
        within("payload's attitude", angle, -inf, tolerances.angle, "rad", units, (says, says)),
    )


_BEFORE_SAYS = ("probe {} before the port's face", "probe {} behind the port's face")
_INSIDE_SAYS = ("probe {} inside the docking envelope", "probe {} outside the docking envelope")
_DISTANCE_SAYS = ("probe {} from the port", "")
_SQUARE = 1e-9
"""How exactly a port's directions have to be square and of unit length [1]."""
