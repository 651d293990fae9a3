"""Random solids on moving frames, and the long way to what is said of them."""

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
    """Two parts a frame, of one to three solids each, all about their frame's origin."""
    shapes = [*boxes(rng, 15), *skewed(rng, 15)]
    turns, found = rotations(rng, 30), []
    for frame, which in product(FRAMES, "ab"):
        for _ in range(rng.integers(1, 4)):
            shape = shapes.pop(rng.integers(len(shapes)))
            found.append(Solid(f"{frame} {which}", frame, shape @ turns[len(shapes)].T + 0.5 * rng.normal(size=3)))
    return found


def scene(rng: np.random.Generator) -> tuple[list[Solid], Layout]:
    """Random solids, every pair of parts of theirs watched that may be."""
    made = solids(rng)
    return made, layout_of(FRAMES, made, part_pairs(made, CHAIN))


def poses(rng: np.random.Generator, spread: float = 2.0) -> Array:
    """(5, 12) random frames; the orbiter's stands in the origin."""
    found = np.empty((len(FRAMES), 12))
    found[:, :3] = spread * rng.normal(size=(len(FRAMES), 3))
    found[:, 3:] = rotations(rng, len(FRAMES)).reshape(-1, 9)
    found[0] = [0.0, 0.0, 0.0, *np.eye(3).ravel()]
    return found


def moved(frames: Array, twists: Array, time: float) -> Array:
    """Frames (F, 12) carried on for a time [s] at constant twists (F, 6) in L: turning, and what is in the origin."""
    found = np.empty_like(frames)
    for row, frame, (wx, wy, wz, vx, vy, vz) in zip(found, frames, twists, strict=True):
        screw = np.array([[0.0, -wz, wy, vx], [wz, 0.0, -wx, vy], [-wy, wx, 0.0, vz], [0.0] * 4])
        step = expm(time * screw)
        row[:3] = step[:3, :3] @ frame[:3] + step[:3, 3]
        row[3:] = (step[:3, :3] @ frame[3:].reshape(3, 3)).ravel()
    return found


def placed(solid: Solid, frames: Array, names: tuple[str, ...] = FRAMES) -> Array:
    """(8, 3) a solid's vertices in L."""
    row = frames[names.index(solid.frame)]
    return np.asarray(solid.vertices @ row[3:].reshape(3, 3).T + row[:3])


def all_pairs(made: list[Solid], layout: Layout, group: int, frames: Array) -> list[Separation]:
    """What `separation` says of every pair of solids of a group."""
    a, b = layout.named(group)
    first, second = ([placed(s, frames, layout.frames) for s in made if s.part == part] for part in (a, b))
    return [separation(p, q) for p, q in product(first, second)]


def clearances(made: list[Solid], layout: Layout, frames: Array) -> Array:
    """(g,) the least clearance of each group, without memory and with nothing passed over [m]."""
    groups = range(len(layout.groups))
    return np.array([min(s.clearance for s in all_pairs(made, layout, g, frames)) for g in groups])
