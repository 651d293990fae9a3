"""Benchmark of compiled code for hexahedra near contact, compared with coal and MuJoCo."""

from __future__ import annotations

import math

import coal
import mujoco
import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import BODY, place
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.bodies.pair import CLEARANCE, CONTACT, NORMAL, PAIR
from aftdeck.bodies.pair_check import measure, verdict, verified
from aftdeck.law import law
from benchmarks.measure import SHORT, Figure, Timing, against, microseconds
from benchmarks.plain import projections

FULL, TINY = Timing(), SHORT

COUNT, FRAMES = 128, 40
"""`COUNT`: number of pairs. `FRAMES`: number of frames in which the bodies move."""
DRIFT, SPIN = 0.005, 0.005
"""Translation [m] and rotation [rad] of a body between frames: 0.25 m/s and 0.25 rad/s at 50 frames a second."""
CUBE = np.array([(x, y, z) for y in (-1, 1) for x in (-1, 1) for z in (-1, 1)]) / 2.0
"""Corners of a cube of edge length 1, in the order of a hexahedron."""
RIMS = [(0, 1, 5, 4), (0, 2, 3, 1), (0, 4, 6, 2), (1, 3, 7, 5), (4, 5, 7, 6), (2, 6, 7, 3)]
"""Corners of each face of a hexahedron, counterclockwise as seen from outside."""


@law
def reverify(first: Array, second: Array, pairs: Array) -> int:
    """Return the number of pairs whose last separating plane still separates them."""
    count = 0
    for k in range(len(first)):
        count += verified(first[k], second[k], pairs[k])
    return count


@law
def follow(first: Array, second: Array, pairs: Array) -> float:
    """Return the sum of all clearances while the second bodies move through their frames, forwards then backwards.

    `second` has the shape (frames, n, 48).
    """
    total = 0.0
    for frame in range(2 * len(second)):
        moved = second[min(frame, 2 * len(second) - 1 - frame)]
        for k in range(len(first)):
            total += measure(first[k], moved[k], pairs[k])
    return total


@law
def judge(first: Array, second: Array, pairs: Array) -> int:
    """Return the number of pairs that collide, computed without data of an earlier frame."""
    count = 0
    pairs[:] = 0.0
    for k in range(len(first)):
        count += verdict(first[k], second[k], pairs[k])
    return count


def hexahedra(size: Timing) -> list[Figure]:
    """Measure the times of a pair in compiled loops, and the times of other libraries for the same pairs."""
    rng = np.random.default_rng(1972)
    plain = projections(size)
    figures = [plain]
    for kind, bodies in {"boxes": _boxes(rng), "skewed": _skewed(rng)}.items():
        first = np.array([hexahedron(body) for body in bodies[:COUNT]])
        local = np.array([hexahedron(body) for body in bodies[COUNT:]])
        turns = np.array([_turn(axis, math.pi * rng.random()) for axis in rng.normal(size=(COUNT, 3))])
        middles = _nearby_centres(first, local, turns, rng)
        near, pairs = _placed(local, middles, turns), np.zeros((COUNT, PAIR))
        for k in range(COUNT):
            measure(first[k], near[k], pairs[k])
        assert reverify(first, near, pairs) == COUNT
        collide, distance = _by_coal(kind, bodies, middles, turns, size)
        names = {"a": first, "b": near, "pairs": pairs}
        near_by = "clearances of 1 mm to 0.1 m"
        time = microseconds("f(a, b, pairs)", {"f": reverify, **names}, size) / COUNT
        figures.append(against(plain, 1.8, f"last plane verified, {kind}", time, "us", near_by))
        drift, spin = rng.normal(size=(2, COUNT, 3)) / math.sqrt(3.0)
        frames = np.empty((FRAMES, COUNT, BODY))
        for frame in range(FRAMES):
            spun = np.array([_turn(spin[k], SPIN * frame) @ turns[k] for k in range(COUNT)])
            # The centres of a pair only move apart, so that few pairs overlap. Overlapping pairs are measured below.
            away = drift * np.sign((drift * pairs[:, NORMAL : NORMAL + 3]).sum(axis=1))[:, None]
            frames[frame] = _placed(local, middles + away * DRIFT * frame, spun)
        time = microseconds("f(a, frames, pairs)", {"f": follow, "a": first, "frames": frames, "pairs": pairs}, size)
        moving = f"moving {DRIFT * 1e3:g} mm and {SPIN * 1e3:g} mrad a frame"
        figures.append(against(distance, 0.13, f"clearance, warm, {kind}", time / (2 * FRAMES * COUNT), "us", moving))
        time = microseconds("f(a, b, pairs)", {"f": judge, **names}, size) / COUNT
        figures.append(against(collide, 0.22, f"verdict, cold, {kind}", time, "us", near_by))
        inside = _placed(local, middles - 0.11 * pairs[:, NORMAL : NORMAL + 3], turns)
        measured = np.array([measure(first[k], inside[k], np.zeros(PAIR)) for k in range(COUNT)])
        deep = {"f": judge, "a": first, "b": inside, "pairs": pairs.copy()}
        time = microseconds("f(a, b, pairs)", deep, size) / COUNT
        share = f"{100 * np.mean(measured <= CONTACT):.0f} % collide"
        figures.append(against(collide, 0.6, f"verdict, cold, deep, {kind}", time, "us", share))
        deep = {"f": follow, "a": first, "frames": inside[None], "pairs": np.zeros((COUNT, PAIR))}
        time = microseconds("f(a, frames, pairs)", deep, size) / (2 * COUNT)
        figures.append(Figure(f"depth, {kind}", time, "us", None, f"clearance and closest pair, {share}"))
        figures += [collide, distance]
        if kind == "boxes":
            judge(first, near, pairs)
            alone = {"f": verdict, "a": first[0], "b": near[0], "pair": np.zeros(PAIR), "zero": 0.0}
            time = microseconds("pair[:] = zero; f(a, b, pair)", alone, size)
            figures.append(Figure("verdict from Python, boxes", time, "us", None, "one call, cold"))
            figures.append(_by_mujoco(bodies, first, near, middles, turns, size))
    return figures


def _boxes(rng: np.random.Generator) -> Array:
    return np.asarray(CUBE * np.exp(rng.uniform(math.log(0.05), math.log(2.0), (2 * COUNT, 1, 3))))


def _skewed(rng: np.random.Generator) -> Array:
    """Return boxes, each with its top face reduced and shifted sideways."""
    bodies = _boxes(rng)
    rise = 0.5 - bodies[..., 2:] / np.ptp(bodies[..., 2:], axis=1, keepdims=True)
    lean = rng.uniform(-0.3, 0.3, (2 * COUNT, 1, 2)) * np.ptp(bodies[..., :2], axis=1, keepdims=True)
    bodies[..., :2] = bodies[..., :2] * (1.0 - rng.uniform(0.0, 0.5, (2 * COUNT, 1, 1)) * rise) + lean * rise
    return bodies


def _turn(axis: Array, angle: float) -> Array:
    """Return the rotation matrix about an axis by an angle [rad] (Rodrigues)."""
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([(0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0)])
    return np.asarray(np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross)


def _placed(local: Array, middles: Array, turns: Array) -> Array:
    placed = np.empty_like(local)
    for k in range(len(local)):
        place(local[k], middles[k], turns[k], placed[k])
    return placed


def _nearby_centres(first: Array, local: Array, turns: Array, rng: np.random.Generator) -> Array:
    """Return a centre for each second body, with a clearance of 1 mm to 0.1 m from the first body.

    Each body starts far away, in a random direction, and moves along the normal of its separating plane.
    """
    directions = rng.normal(size=(COUNT, 3))
    middles = 6.0 * directions / np.linalg.norm(directions, axis=1, keepdims=True)
    for k, body in enumerate(_placed(local, middles, turns)):
        pair = np.zeros(PAIR)
        measure(first[k], body, pair)
        middles[k] -= (pair[CLEARANCE] - rng.uniform(0.001, 0.1)) * pair[NORMAL : NORMAL + 3]
    return np.asarray(middles)


def _by_coal(kind: str, bodies: Array, middles: Array, turns: Array, size: Timing) -> tuple[Figure, Figure]:
    """Measure coal's verdict and coal's distance, with one call from Python for each pair."""
    hulls = [_hull(body) for body in bodies]
    identity = coal.Transform3s.Identity()
    placements = [coal.Transform3s(turn, middle) for turn, middle in zip(turns, middles, strict=True)]
    request, result = coal.CollisionRequest(), coal.CollisionResult()
    request.gjk_tolerance = request.epa_tolerance = 1e-12
    request.enable_contact = False
    asked, answer = coal.DistanceRequest(), coal.DistanceResult()
    asked.gjk_tolerance = asked.epa_tolerance = 1e-12

    def collide() -> int:
        count = 0
        for k in range(COUNT):
            result.clear()
            count += coal.collide(hulls[k], identity, hulls[COUNT + k], placements[k], request, result) > 0
        return count

    def distance() -> float:
        least = math.inf
        for k in range(COUNT):
            answer.clear()
            least = min(least, coal.distance(hulls[k], identity, hulls[COUNT + k], placements[k], asked, answer))
        return least

    assert collide() == 0
    assert 0.0 < distance() < 0.1
    how = "one call a pair from Python"
    verdicts, distances = (microseconds("f()", {"f": peer}, size) / COUNT for peer in (collide, distance))
    return (
        Figure(f"coal, collide, {kind}", verdicts, "us", None, how),
        Figure(f"coal, distance, {kind}", distances, "us", None, how),
    )


def _by_mujoco(bodies: Array, first: Array, near: Array, middles: Array, turns: Array, size: Timing) -> Figure:
    """Measure MuJoCo's distance, with one call from Python for each pair; check the least distance."""
    spec = mujoco.MjSpec()
    for body, turn, middle in zip(
        bodies, [np.eye(3)] * COUNT + list(turns), [np.zeros(3)] * COUNT + list(middles), strict=True
    ):
        quaternion = np.empty(4)
        mujoco.mju_mat2Quat(quaternion, turn.ravel())
        spec.worldbody.add_geom(
            type=mujoco.mjtGeom.mjGEOM_BOX, size=np.ptp(body, axis=0) / 2.0, pos=middle, quat=quaternion
        )
    model = spec.compile()
    data, ends = mujoco.MjData(model), np.empty(6)
    mujoco.mj_forward(model, data)

    def distance() -> float:
        return min(float(mujoco.mj_geomDistance(model, data, k, COUNT + k, 1.0, ends)) for k in range(COUNT))

    pairs = np.zeros((COUNT, PAIR))
    ours = min(measure(first[k], near[k], pairs[k]) for k in range(COUNT))
    assert abs(distance() - ours) < 1e-5, f"MuJoCo's least distance is {distance()}, ours {ours}"
    time = microseconds("f()", {"f": distance}, size) / COUNT
    return Figure("MuJoCo, mj_geomDistance, boxes", time, "us", None, "one call a pair from Python")


def _hull(body: Array) -> object:
    points, triangles = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
    for point in body:
        points.append(point)
    for p, q, r, s in RIMS:
        triangles.append(coal.Triangle(p, q, r))
        triangles.append(coal.Triangle(p, r, s))
    return coal.Convex(points, triangles)
