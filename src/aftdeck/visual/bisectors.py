"""Planes SP 11 and SP 12: each passes through a pin of the arm and bisects the angle of the two links.

The first separates ARM 0 and ARM 1 (upper and lower boom), the second ARM 1 and ARM 2 (the end effector). Such a plane
is valid only if the links end short of the pin: with w half the width of a link and a bend of the angle theta about a
face's axis, by at least w tan(theta / 2) (`arms/bodies.py` checks this for the concept arm). It is therefore used only
where it separates the two bodies in the present pose; elsewhere the last plane is tried, and then all planes. Source:
Remote Manipulator Simulation, final report, chapter V.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array, Indices
from aftdeck.bodies.pose import turned_back
from aftdeck.bodies.vector import Vector, dot, times
from aftdeck.law import law
from aftdeck.visual.planes import TOLERANCE, extent
from aftdeck.visual.store import Store

_FOLDED = 1e-6
"""Length of the sum of two links' directions below which the links are folded back, so that no plane bisects them."""


def bisected_pairs(model: ArmModel, frames: Sequence[str], volumes: Sequence[float]) -> Indices:
    """Return the pairs (B, 2) of clusters that the two planes separate: a boom, and the boom or the hand after it.

    A plane bisects the x axes of two frames; for links along other axes, it separates nothing and is not used.

    Args:
        model: the arm.
        frames: name of the frame of each cluster.
        volumes: volume of each cluster; a boom is the largest cluster of its frame.
    """
    *links, hand = (
        [k for k, frame in enumerate(frames) if frame == model.linkage.frames[number]] for number in model.linkage.arms
    )
    booms = [max(own, key=lambda k: volumes[k]) for own in links if own]
    pairs = [tuple(booms)] if len(booms) > 1 else []
    if links and links[-1]:
        pairs += [(booms[-1], k) for k in hand]
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)


@law
def bisector(poses: Array, f: int, g: int) -> Vector:
    """Return the unit normal of the plane that bisects the links of two frames; zero if they are folded back.

    `poses` (F, 12) are the poses of the frames; the normal is in the same coordinates, from the first to the second.
    """
    n = Vector(poses[f, 3] + poses[g, 3], poses[f, 6] + poses[g, 6], poses[f, 9] + poses[g, 9])
    size = np.sqrt(dot(n, n))
    return times(1.0 / size if size > _FOLDED else 0.0, n)


@law
def remember_bisectors(pairs: Indices, placed: Store, frame: Indices, poses: Array, memory: Array) -> None:
    """Write the bisecting planes that separate their two clusters into the memory of planes."""
    for k in range(len(pairs)):
        i, j = pairs[k, 0], pairs[k, 1]
        n = bisector(poses, frame[i], frame[j])
        along = extent(placed.points, placed.first_point, i, j, n)
        if dot(n, n) > 0.0 and along.b - along.a >= -TOLERANCE:
            a, b = min(i, j), max(i, j)
            own = turned_back(poses[frame[a]], times(1.0 if a == i else -1.0, n))
            memory[a, b, 0], memory[a, b, 1], memory[a, b, 2] = own.x, own.y, own.z
