"""Benchmark of closed-loop steering of many arms, compared with array programs that compute the same step.

An *arm-step* is one control step of one arm.
"""

from __future__ import annotations

import importlib.util
import time
from collections.abc import Callable
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

import aftdeck
from aftdeck.arrays import Array
from aftdeck.steering.batch import steer_batch
from aftdeck.steering.msteer import NEAR_FLOOR
from benchmarks.measure import Figure, absent, against

Fields = tuple[Any, ...]
Peer = Callable[[Array, Array, int], Array]
"""Function from joint angles (n, 6), targets (n, 12) and a number of steps to joint angles (n, 6)."""

START = np.radians([-31.0, 79.0, -103.0, -77.0, 17.0, -128.0])
"""Joint angles [rad] of a pose above the payload bay, far from all limits."""
PERIOD, GAIN = 0.02, 0.5
"""Control period [s], and rate of the tip for each unit of remaining distance or rotation [1/s]."""
FAST, EXACT = 0.08, 0.1
"""Promised processor times of an arm-step, summed over the cores, as shares of NumPy's."""


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        span: time for which each program is repeated [s]; the shortest of its runs is reported.
        arms: number of arms that Aftdeck steers.
        steps: number of their steps in a run.
        numpy: number of arms with which NumPy is fastest.
        jax: number of arms with which JAX is fastest.
    """

    span: float
    arms: int
    steps: int
    numpy: int
    jax: int


FULL, TINY = Size(5.0, 8192, 2000, 2048, 131_072), Size(0.0, 80, 10, 64, 64)


def arm_steps(size: Size) -> list[Figure]:
    """Measure the time of an arm-step on all cores, including the packing and the checks of the arrays."""
    arm = aftdeck.load_arm("srms")

    def exact(start: Array, targets: Array, steps: int) -> Array:
        return steer_batch(arm, start, targets, steps=steps, period=PERIOD, gain=GAIN).angles

    def fast(start: Array, targets: Array, steps: int) -> Array:
        return steer_batch(arm, start, targets, steps=steps, period=PERIOD, gain=GAIN, fast=True).angles

    def by_numpy(start: Array, targets: Array, steps: int) -> Array:
        return _by_numpy(arm, start, targets, steps)

    ours = _random_arms(arm, size.arms)
    quick, right = (_measured(peer, ours, size.steps, size.span) for peer in (fast, exact))
    single, other = _beside("NumPy", by_numpy, exact, _random_arms(arm, size.numpy), size)
    cores = Figure("the same by NumPy, processor time", other, "ns")
    if importlib.util.find_spec("jax"):
        jax, _ = _beside("JAX", _by_jax(arm), exact, _random_arms(arm, size.jax), size)
    else:
        jax = absent("the same by JAX", "ns", "install jax (dependency group `bench`)")
    name, of = "closed loop, an arm-step", "processor time"
    return [
        Figure(f"{name}, fast", quick.wall, "ns", None, _note(quick.wall, size.arms)),
        Figure(f"{name}, exact", right.wall, "ns", None, _note(right.wall, size.arms)),
        single,
        jax,
        cores,
        against(cores, FAST, f"{name}, fast, {of}", quick.processor, "ns", "summed over the cores"),
        against(cores, EXACT, f"{name}, exact, {of}", right.processor, "ns", "summed over the cores"),
    ]


class Times(NamedTuple):
    """Shortest times of an arm-step: by the wall clock, and of the processor, summed over the cores [ns]."""

    wall: float
    processor: float


def _beside(name: str, peer: Peer, ours: Peer, arms: tuple[Array, Array], size: Size) -> tuple[Figure, float]:
    """Check that a library computes the same as Aftdeck; measure its time, and its processor time [ns]."""
    off = np.abs(peer(*arms, 3) - ours(*arms, 3)).max()
    assert off < 1e-9, f"{name} differs by {off:g} rad"
    times = _measured(peer, arms, 20, size.span)
    return Figure(f"the same by {name}", times.wall, "ns", None, _note(times.wall, len(arms[0]))), times.processor


def _note(nanoseconds: float, arms: int) -> str:
    return f"{1e3 / nanoseconds:.1f} million arm-steps/s, {arms} arms"


def _measured(peer: Peer, arms: tuple[Array, Array], steps: int, span: float) -> Times:
    """Return the shortest times of an arm-step."""
    start, targets = arms
    peer(start, targets, steps)  # compiles
    walls: list[float] = []
    processors: list[float] = []
    end = time.perf_counter() + span
    while time.perf_counter() < end or len(walls) < 3:
        begin, used = time.perf_counter(), time.process_time()
        peer(start, targets, steps)
        processors.append(time.process_time() - used)
        walls.append(time.perf_counter() - begin)
    count = steps * len(start)
    return Times(min(walls) / count * 1e9, min(processors) / count * 1e9)


def _random_arms(arm: aftdeck.Arm, count: int) -> tuple[Array, Array]:
    """Return random joint angles (count, 6) and targets (count, 12)."""
    rng = np.random.default_rng(1)
    start = START + rng.uniform(-0.3, 0.3, (count, 6))
    pose = arm.forward(start + rng.uniform(-0.1, 0.1, (count, 6)))
    return start, np.concatenate([pose.position, pose.rotation.reshape(-1, 9)], axis=1)


def _by_numpy(arm: aftdeck.Arm, start: Array, targets: Array, steps: int) -> Array:
    q, target = tuple(np.ascontiguousarray(start.T)), tuple(np.ascontiguousarray(targets.T))
    for _ in range(steps):
        q = _step(np, arm, q, target)
    return np.stack(q, axis=1)


def _by_jax(arm: aftdeck.Arm) -> Peer:
    jax = importlib.import_module("jax")
    jax.config.update("jax_enable_x64", True)
    many = jax.jit(lambda q, target, n: jax.lax.fori_loop(0, n, lambda _, q: _step(jax.numpy, arm, q, target), q))

    def peer(start: Array, targets: Array, steps: int) -> Array:
        return np.stack(many(tuple(start.T), tuple(targets.T), steps), axis=1)

    return peer


def _step(xp: ModuleType, arm: aftdeck.Arm, q: Fields, target: Fields) -> Fields:
    """Compute one step of all arms with the array library `xp`; each array holds one quantity for all arms."""
    l1, l2, l3, l4, l5, upper, lower = (float(x) for x in arm.model.links[:7])
    pitch = q[1] + q[2] + q[3]
    s1, s2, s23, s234, s5, s6 = (xp.sin(x) for x in (q[0], q[1] + upper, q[1] + q[2] + lower, pitch, q[4], q[5]))
    c1, c2, c23, c234, c5, c6 = (xp.cos(x) for x in (q[0], q[1] + upper, q[1] + q[2] + lower, pitch, q[4], q[5]))
    # the tip
    out = l2 * c2 + l3 * c23 + (l4 + l5 * c5) * c234
    side = l5 * s5
    down = -l1 - l2 * s2 - l3 * s23 - (l4 + l5 * c5) * s234
    x = (c1 * c234 * c5 - s1 * s5, s1 * c234 * c5 + c1 * s5, -s234 * c5)
    y0 = (-c1 * c234 * s5 - s1 * c5, -s1 * c234 * s5 + c1 * c5, s234 * s5)
    z0 = (c1 * s234, s1 * s234, c234)
    y = tuple(a * c6 + b * s6 for a, b in zip(y0, z0, strict=True))
    z = tuple(b * c6 - a * s6 for a, b in zip(y0, z0, strict=True))
    # the remaining rotation and distance
    v = (target[0] - c1 * out + s1 * side, target[1] - s1 * out - c1 * side, target[2] - down)
    w = []
    for i, j in ((1, 2), (2, 0), (0, 1)):
        new_i, new_j = target[3 + 3 * i : 6 + 3 * i], target[3 + 3 * j : 6 + 3 * j]
        w.append(0.5 * sum(a[i] * new_j[k] - a[j] * new_i[k] for k, a in enumerate((x, y, z))))
    # in frame 5
    b1, b3 = (c234 * (c1 * w[0] + s1 * w[1]) - s234 * w[2], s234 * (c1 * w[0] + s1 * w[1]) + c234 * w[2])
    b4, b6 = (c234 * (c1 * v[0] + s1 * v[1]) - s234 * v[2], s234 * (c1 * v[0] + s1 * v[1]) + c234 * v[2])
    b2, b5 = -s1 * w[0] + c1 * w[1], -s1 * v[0] + c1 * v[1]
    # closed-form inverse of the Jacobian
    s34, c34 = s234 * c2 - c234 * s2, c234 * c2 + s234 * s2
    s4, c4 = s234 * c23 - c234 * s23, c234 * c23 + s234 * s23
    reach = l2 + l3 + abs(l4)

    def away(value: Any) -> Any:
        return xp.copysign(xp.maximum(xp.abs(value), NEAR_FLOOR), value)

    r1 = (b5 - l5 * c5 * b3) / (away((l2 * c2 + l3 * c23 + l4 * c234) / reach) * reach)
    r5 = b3 - c234 * r1
    r6 = (b1 + s234 * r1) / away(c5)
    k1 = b2 - s5 * r6
    k2 = b4 + l5 * c234 * s5 * r1 + l5 * s5 * r5
    k3 = b6 + l5 * s234 * s5 * r1 + (l4 + l5 * c5) * k1
    a42, a43, a62, a63 = l2 * s34 + l3 * s4, l3 * s4, -l2 * c34 - l3 * c4, -l3 * c4
    per_d = 1.0 / (away(s2 * c23 - c2 * s23) * l2 * l3)
    r2 = (a63 * k2 - a43 * k3) * per_d
    r3 = (a42 * k3 - a62 * k2) * per_d
    rates = (r1, r2, r3, k1 - r2 - r3, r5, r6)
    # one ratio for all joints
    worst = xp.ones_like(r1)
    for rate, limit in zip(rates, arm.rate_limits, strict=True):
        worst = xp.maximum(worst, GAIN / float(limit) * xp.abs(rate))
    scale = GAIN * PERIOD / worst
    return tuple(angle + scale * rate for angle, rate in zip(q, rates, strict=True))
