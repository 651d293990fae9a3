"""Rank of a chain of joints: the number of independent twists that it can make in most postures."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array

_POSTURES = 5
"""Number of postures in which the rank is computed; the greatest one counts."""


class Joint(NamedTuple):
    """One joint of a chain.

    Attributes:
        step: (3,) vector from the joint before it, or from L's origin, at coordinates 0 [m].
        axis: (3,) unit vector along the joint's axis, at coordinates 0.
        slides: whether the joint slides along its axis; otherwise it turns about it.
        weight: weight in the steering's choice among rates that make the same twist [1].
    """

    step: Array
    axis: Array
    slides: bool
    weight: float


def rank_of(joints: tuple[Joint, ...], tip: Array) -> int:
    """Return the greatest rank of the Jacobian in some postures without symmetry."""
    coordinates = np.arange(1.0, 1.0 + _POSTURES * len(joints)).reshape(_POSTURES, -1) ** 2 * 0.7
    return max(int(np.linalg.matrix_rank(_jacobian(joints, tip, q), tol=1e-9)) for q in coordinates)


def _jacobian(joints: tuple[Joint, ...], tip: Array, q: Array) -> Array:
    """Return the Jacobian (6, n) about the tip, up to the unit of length: the chain's greatest distance is 1."""
    unit = max(1e-9, *(float(np.abs(joint.step).max()) for joint in joints[1:]), float(np.abs(tip).max()))
    at, rotation, axes, centres = np.zeros(3), np.eye(3), [], []
    for joint, coordinate in zip(joints, q, strict=True):
        at = at + rotation @ (joint.step / unit)
        axes.append(rotation @ joint.axis)
        if joint.slides:
            at = at + coordinate * axes[-1]
        else:
            across = np.cross(np.eye(3), joint.axis)
            rotation = rotation @ (
                np.eye(3) + np.sin(coordinate) * across + (1.0 - np.cos(coordinate)) * across @ across
            )
        centres.append(at)
    end = at + rotation @ (tip / unit)
    columns = [
        np.concatenate([np.zeros(3), axis] if joint.slides else [axis, np.cross(axis, end - centre)])
        for joint, axis, centre in zip(joints, axes, centres, strict=True)
    ]
    return np.stack(columns, axis=1)
