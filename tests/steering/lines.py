"""Random straight moves; Pinocchio alone computes the joint angles along their lines."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

import aftdeck
from aftdeck.arrays import Array
from tests.kinematics.engines import Chain, Solver, in_pinocchio

CLEAR = 0.05
"""Normalised distance from a singularity; at a greater distance, a pose is clear of the singularity."""
SAMPLES = 120
"""Number of poses on a line for which joint angles are computed."""
FURTHEST = math.radians(10.0)
"""Greatest rotation of a joint between two samples [rad]; more means a change of the branch, or a singularity."""


class Move(NamedTuple):
    """Straight move: joint angles at its start and at its end, on one branch [rad]."""

    start: Array
    end: Array


def chain_of(arm: aftdeck.Arm) -> Chain:
    """Return the joint centres and axes of an arm in L, from the lengths in its file."""
    length = {name: value for name, value in zip(("l1", "l2", "l3", "l4", "l5"), arm.model.links[:5], strict=True)}
    upper, lower = arm.model.linkage.links[5:7]
    up = np.array([0.0, 0.0, -length["l1"]])
    elbow = up + length["l2"] * np.array([math.cos(upper), 0.0, -math.sin(upper)])
    wrist = elbow + length["l3"] * np.array([math.cos(lower), 0.0, -math.sin(lower)])
    bent = wrist + np.array([length["l4"], 0.0, 0.0])
    tip = bent + np.array([length["l5"], 0.0, 0.0])
    x, y, z = np.eye(3)
    axes = np.array([z, y, y, z, y, x] if length["l4"] == 0.0 else [z, y, y, y, z, x])
    return Chain(np.array([np.zeros(3), up, elbow, wrist, bent, bent, tip]), axes, np.eye(3))


def distances(chain: Chain, q: Array) -> Array:
    """Return normalised distances from the shoulder, elbow and wrist singularities, computed from joint positions."""

    def pitched(v: Array, slope: float) -> Array:
        return np.array(
            [v[0] * math.cos(slope) + v[2] * math.sin(slope), v[2] * math.cos(slope) - v[0] * math.sin(slope)]
        )

    c = chain.centres
    pitches = np.cumsum(q[1:4] if (chain.axes[3] == chain.axes[2]).all() else [q[1], q[2], 0.0])
    upper, lower, wrist_link = (pitched(b - a, s) for a, b, s in zip(c[1:4], c[2:5], pitches, strict=True))
    out = abs(upper[0] + lower[0] + wrist_link[0])
    reach = np.linalg.norm(upper) + np.linalg.norm(lower) + np.linalg.norm(wrist_link)
    bend = abs(upper[0] * lower[1] - upper[1] * lower[0]) / (np.linalg.norm(upper) * np.linalg.norm(lower))
    return np.array([out / reach, bend, abs(math.cos(q[4]))])


def along(solve: Solver, arm: aftdeck.Arm, move: Move, clear: float, samples: int) -> Array | None:
    """Return joint angles (samples + 1, 6) along the line of a move, with rotation in proportion to translation.

    Returns:
        The angles. None if the line passes a soft stop or a singularity, changes the branch, or ends at other angles
        than the move.
    """
    chain, soft = chain_of(arm), arm.limits.soft
    a, b = solve(move.start), solve(move.end)
    turn = Rotation.from_matrix(b.rotation @ a.rotation.T).as_rotvec()
    displacement = b.position - a.position
    shares = np.linspace(0.0, 1.0, samples + 1)
    orientations = Rotation.from_rotvec(shares[:, None] * turn).as_matrix() @ a.rotation
    positions = a.position + shares[:, None] * displacement
    q, found = move.start, [move.start]
    for position, matrix in zip(positions[1:], orientations[1:], strict=True):
        before, q = q, _solved(solve, q, position, matrix)
        if not ((q >= soft[:, 0]) & (q <= soft[:, 1])).all() or np.abs(q - before).max() > FURTHEST * SAMPLES / samples:
            return None
        if (distances(chain, q) < clear).any():
            return None
        found.append(q)
    return np.array(found) if np.abs(q - move.end).max() < 1e-6 else None


def _solved(solve: Solver, q: Array, position: Array, orientations: Array) -> Array:
    """Return the joint angles at a pose, near to `q`, by Newton's method; NaN if it does not converge."""
    for _ in range(12):
        now = solve(q)
        rest = 0.5 * sum(np.cross(now.rotation[:, k], orientations[:, k]) for k in range(3))
        error = np.concatenate([rest, position - now.position])
        if np.abs(error).max() < 1e-9:
            return q
        try:
            q = q + np.linalg.solve(now.jacobian, error)
        except np.linalg.LinAlgError:
            break
    return np.full(6, np.nan)


def random_moves(arm: aftdeck.Arm, seed: int) -> Iterator[Move]:
    """Yield short and long moves between joint angles inside the soft stops, without end."""
    rng = np.random.default_rng(seed)
    low, high = np.maximum(arm.limits.soft[:, 0], -math.pi), np.minimum(arm.limits.soft[:, 1], math.pi)
    while True:
        start = rng.uniform(low, high)
        reach = rng.choice([0.2, 0.5, 1.5])
        end = np.clip(start + reach * rng.uniform(-1.0, 1.0, 6), low, high)
        yield Move(start, end)


def clear_moves(arm: aftdeck.Arm, seed: int, count: int, clear: float = CLEAR) -> list[Move]:
    """Return `count` random moves whose lines Pinocchio finds inside the soft stops and clear of singularities."""
    found: list[Move] = []
    solve = in_pinocchio(chain_of(arm))
    for move in random_moves(arm, seed):
        if len(found) == count:
            break
        if all(along(solve, arm, move, clear, samples) is not None for samples in (SAMPLES // 12, SAMPLES)):
            found.append(move)
    return found
