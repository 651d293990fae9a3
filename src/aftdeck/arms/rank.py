"""What a chain of joints can do in its best postures: how many independent twists it makes, and how evenly.

It is computed with NumPy and not by the laws, so that loading an arm compiles none of them.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array

POSTURES = 256
"""Number of postures, spread within the joints' limits, of which the best one counts."""
NOTHING = 1e-9
"""Share of the greatest singular value below which a singular value counts as zero [1]."""
_PRIMES = np.array([2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0])


class Joint(NamedTuple):
    """One joint of a chain.

    Attributes:
        step: (3,) vector from the joint before it, or from L's origin, at coordinates 0 [m].
        axis: (3,) unit vector along the joint's axis, at coordinates 0.
        slides: whether the joint slides along its axis; otherwise it turns about it.
        weight: weight in the steering's choice among rates that make the same twist [1].
        limits: least and greatest coordinate [rad or m].
    """

    step: Array
    axis: Array
    slides: bool
    weight: float
    limits: tuple[float, float]


class Best(NamedTuple):
    """Best of a chain's postures.

    Attributes:
        rank: number of independent twists.
        evenness: last singular value of this rank, as a share of the first; two digits, so that it is the same on every
            machine.
    """

    rank: int
    evenness: float


def spread(limits: Array, count: int) -> Array:
    """Return poses (count, n) that are spread between limits (n, 2): the middle, then multiples of roots of primes."""
    shares = (0.5 + np.arange(count)[:, None] * np.sqrt(_PRIMES[: len(limits)])) % 1.0
    return np.asarray(limits[:, 0] + shares * (limits[:, 1] - limits[:, 0]))


def best_of(joints: tuple[Joint, ...], tip: Array, scale: float) -> Best:
    """Return the best of a chain's postures; arguments as in `chain.packed_chain`, `scale` as `chain.SCALE`."""
    follow = np.array([1.0] * 3 + [1.0 / scale] * 3)
    values = np.array(
        [
            np.linalg.svd(follow[:, None] * _jacobian(joints, tip, q), compute_uv=False)
            for q in spread(np.array([joint.limits for joint in joints]), POSTURES)
        ]
    )
    rank = int((values > NOTHING * values[:, :1]).sum(axis=1).max())
    evenness = float((values[:, rank - 1] / values[:, 0]).max())
    return Best(rank, float(f"{evenness:.1e}"))


def _jacobian(joints: tuple[Joint, ...], tip: Array, q: Array) -> Array:
    """Return the Jacobian (6, n) in L at coordinates `q`."""
    at, rotation, axes, centres = np.zeros(3), np.eye(3), [], []
    for joint, coordinate in zip(joints, q, strict=True):
        at = at + rotation @ joint.step
        axes.append(rotation @ joint.axis)
        if joint.slides:
            at = at + coordinate * axes[-1]
        else:
            across = np.cross(np.eye(3), joint.axis)
            turn = np.eye(3) + np.sin(coordinate) * across + (1.0 - np.cos(coordinate)) * across @ across
            rotation = rotation @ turn
        centres.append(at)
    end = at + rotation @ tip
    columns = [
        np.concatenate([np.zeros(3), axis] if joint.slides else [axis, np.cross(axis, end - centre)])
        for joint, axis, centre in zip(joints, axes, centres, strict=True)
    ]
    return np.stack(columns, axis=1)
