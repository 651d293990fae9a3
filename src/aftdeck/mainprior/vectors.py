"""L and P vectors of a station point, chained from system to system (chapter V.B and Figures 12 and 13).

An L vector leads from the eye to the origin of a system, in that system's axes. The P vectors are the display plane: PC
from the eye to its centre, PE along a raster line to the right, PL across the lines, downwards. The unit of length of P
vectors is half the width of the picture, so that zoom changes PC only (the report's PCX, at scale B3: 4.5 at a field of
view of 25 deg). That PL and PE are unit vectors is assumed.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.elementary import sincos
from aftdeck.mainprior.systems import Placed
from aftdeck.mainprior.tables import System
from aftdeck.matrices import product
from aftdeck.simulation.payloads.task_phases import ACQUISITION

DISPLAY = ("PC", "PL", "PE")
"""P vectors of a system, in the order of their rows."""
_Y, _Z, _X = 1, 2, 0


class Station(NamedTuple):
    """Station point in the system of the body that carries it.

    Attributes:
        system: LR, L0 or L1.
        point: (3,) the eye, SP [m].
        display: (3, 3) rows PC, PL, PE.
    """

    system: System
    point: Array
    display: Array


class Links(NamedTuple):
    """What the L and P vectors depend on besides the station.

    Attributes:
        angles: HO, PO, P1, H2, P2, R2 [rad].
        shoulder: (3,) TR, the shoulder in R [m].
        elbow: (3,) T0, the elbow in system 0 [m].
        wrist: (3,) T1, the wrist in system 1 [m].
        payload: pose of P in R in mode 1, and in system 2 in other modes; None if there is no payload.
        space: (3,) origin of S in R [m].
    """

    angles: tuple[float, ...]
    shoulder: Array
    elbow: Array
    wrist: Array
    payload: Placed | None
    space: Array


class Vectors(NamedTuple):
    """L and P vectors, by system.

    Attributes:
        eye: (3,) L vectors [m].
        display: (3, 3) P vectors, rows PC, PL, PE [half the width of the picture].
    """

    eye: dict[System, Array]
    display: dict[System, Array]


def vectors(station: Station, links: Links, mode: int) -> Vectors:
    """Return the L and P vectors of a station point in a mode.

    In mode 1, acquisition, the payload is at rest in R, and LP = LR + TP; in other modes, LP comes from L2 + T2. The
    report has two rotations from system 2 to P, for a payload that was acquired exactly in line (chosen by the sign of
    cos R2); here it is the rotation at the acquisition.
    """
    ho, po, p1, h2, p2, r2 = links.angles
    to_0 = product(_into(_Y, po), _into(_Z, ho))
    to_1 = _into(_Y, p1)
    to_w = _into(_Z, h2)
    to_2 = product(product(_into(_X, r2), _into(_Y, p2)), to_w)
    eye: dict[System, Array] = {station.system: -station.point}
    display: dict[System, Array] = {station.system: station.display}
    steps: list[tuple[System, System, Array, Array]] = [
        ("LR", "L0", to_0, links.shoulder),
        ("L0", "L1", to_1, links.elbow),
        ("L1", "LW", to_w, links.wrist),
        ("L1", "L2", to_2, links.wrist),
        ("LR", "LS", np.eye(3), links.space),
    ]
    if links.payload is not None:
        carrier: System = "LR" if mode == ACQUISITION else "L2"
        steps.append((carrier, "LP", links.payload.axes.T, links.payload.origin))
    for inner, outer, turn, origin in reversed(steps):  # towards R: L0 = -T0 + (-theta1)(L1)
        if outer in eye and inner not in eye:
            eye[inner] = product(turn.T, eye[outer]) - origin
            display[inner] = product(display[outer], turn)
    for inner, outer, turn, origin in steps:  # away from R: L1 = (theta1)(T0 + L0)
        if outer not in eye:
            eye[outer] = product(turn, origin + eye[inner])
            display[outer] = product(display[inner], turn.T)
    return Vectors(eye, display)


def _into(axis: int, angle: float) -> Array:
    """Return the matrix that resolves a vector into axes that are turned by an angle about an axis."""
    s, c = sincos(angle)
    found = np.eye(3)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    found[i, i], found[i, j], found[j, i], found[j, j] = c, s, -s, c
    return found
