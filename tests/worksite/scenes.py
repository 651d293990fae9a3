"""Random solids on moving coordinate frames, and their clearances by exhaustive computation."""

from __future__ import annotations

from itertools import product

import numpy as np
from scipy.linalg import expm

from aftdeck import Separation, separation
from aftdeck.arrays import Array
from aftdeck.bodies.solid import Solid
from aftdeck.worksite.watch.groups import Layout, layout_of
from aftdeck.worksite.watch.pairs import part_pairs
from tests.bodies.shapes import boxes, rotations, skewed

FRAMES = ("orbiter", "arm.upper", "arm.lower", "arm.hand", "can")
CHAIN = FRAMES[1:4]


def solids(rng: np.random.Generator) -> list[Solid]:
    """Return two parts for each coordinate frame, of one to three solids each, near the origin of their frame."""
    shapes = [*boxes(rng, 15), *skewed(rng, 15)]
    turns, found = rotations(rng, 30), []
    for frame, which in product(FRAMES, "ab"):
        for _ in range(rng.integers(1, 4)):
            shape = shapes.pop(rng.integers(len(shapes)))
            found.append(Solid(f"{frame} {which}", frame, shape @ turns[len(shapes)].T + 0.5 * rng.normal(size=3)))
    return found


def scene(rng: np.random.Generator) -> tuple[list[Solid], Layout]:
    """Return random solids and a layout that monitors all possible pairs of their parts."""
    made = solids(rng)
    return made, layout_of(FRAMES, made, part_pairs(made, CHAIN))


def poses(rng: np.random.Generator, spread: float = 2.0) -> Array:
    """Return random coordinate frames (5, 12); the orbiter's is at the origin."""
    found = np.empty((len(FRAMES), 12))
    found[:, :3] = spread * rng.normal(size=(len(FRAMES), 3))
    found[:, 3:] = rotations(rng, len(FRAMES)).reshape(-1, 9)
    found[0] = [0.0, 0.0, 0.0, *np.eye(3).ravel()]
    return found


def moved(frames: Array, twists: Array, time: float) -> Array:
    """Return coordinate frames (F, 12) moved for a time [s] at constant twists (F, 6) in L.

    A twist is the angular velocity, then the velocity of the point at the origin of L.
    """
    found = np.empty_like(frames)
    for row, frame, (wx, wy, wz, vx, vy, vz) in zip(found, frames, twists, strict=True):
        screw = np.array([[0.0, -wz, wy, vx], [wz, 0.0, -wx, vy], [-wy, wx, 0.0, vz], [0.0] * 4])
        step = expm(time * screw)
        row[:3] = step[:3, :3] @ frame[:3] + step[:3, 3]
        row[3:] = (step[:3, :3] @ frame[3:].reshape(3, 3)).ravel()
    return found


def placed(solid: Solid, frames: Array, names: tuple[str, ...] = FRAMES) -> Array:
    """Return a solid's vertices (8, 3) in L."""
    row = frames[names.index(solid.frame)]
    return np.asarray(solid.vertices @ row[3:].reshape(3, 3).T + row[:3])


def all_pairs(made: list[Solid], layout: Layout, group: int, frames: Array) -> list[Separation]:
    """Return the result of `separation` for each pair of solids of a monitored pair of parts."""
    a, b = layout.named(group)
    first, second = ([placed(s, frames, layout.frames) for s in made if s.part == part] for part in (a, b))
    return [separation(p, q) for p, q in product(first, second)]


def clearances(made: list[Solid], layout: Layout, frames: Array) -> Array:
    """Return the minimum clearance (g,) of each monitored pair [m], computed anew from all pairs of solids."""
    groups = range(len(layout.groups))
    return np.array([min(s.clearance for s in all_pairs(made, layout, g, frames)) for g in groups])
