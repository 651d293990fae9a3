"""Joint rates for a twist of the tip, the motion of redundant joints, and distances from singularities.

The rates are those of least weighted size that make the twist. A chain that cannot make the whole twist follows it as
well as it can: the weighted difference is least. Source: Whitney, "Resolved motion rate control of manipulators and
human prostheses", IEEE Transactions on Man-Machine Systems 10 (1969).

The *rank* of a chain is the number of independent twists that it can make in most postures. At a singularity it makes
fewer.
"""

from __future__ import annotations

from math import sqrt
from typing import NamedTuple

import numpy as np

from aftdeck.arms.chain import SLIDES
from aftdeck.arrays import Array
from aftdeck.kinematics.chain.factors import factorise
from aftdeck.kinematics.chain.posture import axis_of
from aftdeck.kinematics.linkage import Floats
from aftdeck.law import law

FREE = 1e-7
"""Least share of a joint's own rate that does not move the tip, for the joint to count as redundant [1]."""


class Weighted(NamedTuple):
    """Jacobian J with weights, as factors: diag(follow) J diag(sqrt(weights)) = left diag(values) right^T.

    Attributes:
        left: as in `factors.Factors`; right and values likewise.
        right: (n, k).
        values: (k,).
        weights: (n,) weights of the joints: a joint with twice the weight takes twice the share of a motion, and one
            without weight takes none.
        follow: (6,) weights of the twist's components [s/rad, then s/m]; they matter only where not all can be made.
    """

    left: Array
    right: Array
    values: Array
    weights: Array
    follow: Array


@law
def weigh(matrix: Array, weights: Array, follow: Array) -> Weighted:
    """Return a Jacobian (6, n) in L with weights."""
    scaled = np.empty(matrix.shape)
    for j in range(matrix.shape[1]):
        share = sqrt(weights[j])
        for i in range(6):
            scaled[i, j] = follow[i] * matrix[i, j] * share
    f = factorise(scaled)
    return Weighted(f.left, f.right, f.values, weights, follow)


@law
def part_along(w: Weighted, k: int, twist: Floats) -> float:
    """Return the part of a weighted twist, or of a displacement, along column `k` of `w.left`."""
    part = 0.0
    for i in range(6):
        part += w.left[i, k] * w.follow[i] * twist[i]
    return part


@law
def resolve(w: Weighted, rank: int, twist: Floats, floor: float, rates: Array) -> None:
    """Write the joint rates for a twist.

    Args:
        w: Jacobian with weights.
        rank: rank of the chain.
        twist: (6,) angular velocity [rad/s], then translational velocity [m/s] of the tip, in L.
        floor: share of the greatest singular value below which a smaller one counts as this share [1].
        rates: (n,) output [rad/s or m/s].
    """
    for j in range(rates.shape[0]):
        rates[j] = 0.0
    least = floor * w.values[0]
    if least == 0.0:  # no joint moves the tip
        return
    for k in range(rank):
        part = part_along(w, k, twist) / max(w.values[k], least)
        for j in range(rates.shape[0]):
            rates[j] += w.right[j, k] * part
    for j in range(rates.shape[0]):
        rates[j] *= sqrt(w.weights[j])


@law
def swing(w: Weighted, rank: int, joint: int, rates: Array) -> bool:
    """Write the rates that turn one joint by 1 and do not move the tip; return False if there are none.

    Among all such rates, these are of least weighted size. Added to those of `resolve`, a multiple of them holds the
    joint, or turns it at a wanted rate.

    Args:
        w: Jacobian with weights.
        rank: rank of the chain.
        joint: number of the joint.
        rates: (n,) output: 1 for the joint.
    """
    for j in range(rates.shape[0]):
        rates[j] = 1.0 if j == joint else 0.0
    for k in range(rank):  # what remains of the joint's unit rate without the rates that move the tip
        part = w.right[joint, k]
        for j in range(rates.shape[0]):
            rates[j] -= part * w.right[j, k]
    free = rates[joint]
    if free < FREE:
        return False
    for j in range(rates.shape[0]):
        rates[j] *= sqrt(w.weights[j]) / (sqrt(w.weights[joint]) * free)
    return True


@law
def rank_left(w: Weighted, rank: int) -> float:
    """Return how near a chain is to a singularity: the last singular value of its rank, as a share of the first [1]."""
    return float(w.values[rank - 1] / w.values[0]) if w.values[0] > 0.0 else 0.0


@law
def freeing_joint(chain: Array, joints: Array, tip: Array, w: Weighted, rank: int) -> int:
    """Return the joint whose motion changes the last singular value of the rank most: at a singularity, it frees it.

    Args:
        chain: (n, 16) the chain.
        joints: (n, 12) poses of the joints in L.
        tip: (12,) pose of the tip in L.
        w: Jacobian with weights, in this posture.
        rank: rank of the chain.
    """
    best, found = -1.0, 0
    for k in range(chain.shape[0]):
        slope = abs(slope_of(chain, joints, tip, w, rank - 1, k))
        if slope > best:
            best, found = slope, k
    return found


@law
def slope_of(chain: Array, joints: Array, tip: Array, w: Weighted, value: int, k: int) -> float:
    """Return the derivative of a singular value with respect to the coordinate of joint `k`.

    Arguments as in `freeing_joint`; `value` is the number of the singular value.
    """
    slope, change = 0.0, np.empty(6)
    for j in range(chain.shape[0]):
        _column_change(chain, joints, tip, j, k, change)
        slope += part_along(w, value, change) * sqrt(w.weights[j]) * w.right[j, value]
    return slope


@law
def _column_change(chain: Array, joints: Array, tip: Array, j: int, k: int, change: Array) -> None:
    """Write the derivative (6,) of column `j` of the Jacobian with respect to the coordinate of joint `k`."""
    for i in range(6):
        change[i] = 0.0
    ax, ay, az = axis_of(chain, joints, j)
    bx, by, bz = axis_of(chain, joints, k)
    if chain[k, SLIDES] != 0.0:
        if k > j and chain[j, SLIDES] == 0.0:  # it moves the tip away from the axis
            change[3], change[4], change[5] = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
        return
    if k >= j:  # it turns what is beyond it: the tip, as seen from the axis
        if chain[j, SLIDES] == 0.0:
            x, y, z = tip[0] - joints[k, 0], tip[1] - joints[k, 1], tip[2] - joints[k, 2]
            vx, vy, vz = by * z - bz * y, bz * x - bx * z, bx * y - by * x
            change[3], change[4], change[5] = ay * vz - az * vy, az * vx - ax * vz, ax * vy - ay * vx
        return
    cx, cy, cz = by * az - bz * ay, bz * ax - bx * az, bx * ay - by * ax  # it turns the axis
    if chain[j, SLIDES] != 0.0:
        change[3], change[4], change[5] = cx, cy, cz
        return
    change[0], change[1], change[2] = cx, cy, cz
    x, y, z = tip[0] - joints[j, 0], tip[1] - joints[j, 1], tip[2] - joints[j, 2]
    vx, vy, vz = ay * z - az * y, az * x - ax * z, ax * y - ay * x
    change[3], change[4], change[5] = by * vz - bz * vy, bz * vx - bx * vz, bx * vy - by * vx
