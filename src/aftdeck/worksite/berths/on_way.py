"""A payload on its way into a berth: how far it is from its final pose, and whether a port is straight ahead."""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, relative, turned
from aftdeck.bodies.vector import Vector, dot, minus, plus, put_vector, times, vector_at
from aftdeck.elementary import atan2
from aftdeck.law import law
from aftdeck.worksite.berths.docking import BEFORE, DISTANCE, FOUND, INSIDE, approach

NEAR = 3.0
"""Greatest distance between a payload and its final pose in a berth at which the payload counts as at the berth [m]."""


class OnWay(NamedTuple):
    """Position of a payload relative to its final pose in a berth.

    Attributes:
        along: distance along the straight way into the berth [m].
        aside: distance from this way [m].
        tilt: angle to its attitude in the berth [rad].
    """

    along: float
    aside: float
    tilt: float


@law
def on_way(berth: Array, place: Array, payload: Array, out: Array) -> OnWay:
    """Return where a payload is on its way into a berth.

    Args:
        berth: (12,) pose of the berth's frame in L.
        place: (12,) final pose of the payload in the berth's frame.
        payload: (12,) pose of the payload in L.
        out: (3,) unit vector in the payload's axes, along which it leaves the berth.
    """
    final, off = np.empty(POSE), np.empty(POSE)
    compose(berth, place, final)
    relative(final, payload, off)
    away, outwards = vector_at(off, 0), vector_at(out, 0)
    along = dot(away, outwards)
    beside = minus(away, times(along, outwards))
    axis = Vector(off[10] - off[8], off[5] - off[9], off[6] - off[4])  # of the rotation, with the length 2 sin(angle)
    tilt = atan2(0.5 * sqrt(dot(axis, axis)), 0.5 * (off[3] + off[7] + off[11] - 1.0))
    return OnWay(along, sqrt(dot(beside, beside)), tilt)


@law
def straight_before(
    probe: Array,
    face: Array,
    payload: Array,
    berth: Array,
    port: Array,
    planes: Array,
    depth: float,
    near: float,
    inside: float,
    distance: float,
) -> bool:
    """Return whether a probe is in front of a port's face, and a straight approach would bring it to the port.

    Args:
        probe: (n, 3) vertices of the probe in the payload's frame [m].
        face: (3,) centre of the probe's forward face, in the payload's frame [m].
        payload: (12,) pose of the payload in L.
        berth: (12,) pose of the berth's frame in L.
        port: (12,) pose of the port in the berth's frame.
        planes: (k, 4) docking envelope in the port's frame, the plane of the port's face first.
        depth: depth behind the face up to which the probe counts as in front of it [m].
        near: greatest distance of the probe from the port [m].
        inside: least distance of the probe from the other planes of the envelope after the approach [m].
        distance: greatest distance of the probe from the port after the approach [m].
    """
    found, at, there = np.empty(FOUND), np.empty(POSE), np.empty(POSE)
    compose(berth, port, at)
    approach(probe, face, payload, at, planes, found)
    if found[BEFORE] < -depth or found[DISTANCE] > near:
        return False
    inward = turned(at, vector_at(planes[0], 0))
    there[:] = payload
    put_vector(there, 0, plus(vector_at(payload, 0), times(found[BEFORE], inward)))
    approach(probe, face, there, at, planes, found)
    return bool(found[INSIDE] >= inside and found[DISTANCE] <= distance)
