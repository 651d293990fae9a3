"""Random runs of the steering, and the invariants that hold in every step."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

import aftdeck
from aftdeck.arrays import Array
from aftdeck.simulation.frame import Frame
from aftdeck.steering.mode import LawChoice
from aftdeck.units import POUND
from tests import loaded
from tests.reference.tables import table
from tests.steering.flying import PAYLOAD, at_rate, joint_target, kinds, scenario, target

LIMITS = table("srms-limits")
HARD, SOFT = np.radians(LIMITS["hard"]), np.radians(LIMITS["soft"])
MODES = (
    "OPR CMD", "AUTO 1", "AUTO 2", "TEST", "ORB UNL", "ORB UNL",
    "END EFF", "ORB LD", "ORB LD", "PL", "SINGLE", "DIRECT",
)  # fmt: skip
JOINT_MODES = {"SINGLE", "DIRECT"}
LAWS: tuple[LawChoice, ...] = ("position", "closed loop", "open loop")
STEPS = 400
POUNDS = (0.0, 32_000.0)
"""Masses of the payload [lb]; 0 for none."""
GRAIN = 1e-9
"""Tolerance for rounding of an angle at a stop [rad]."""


def start(rng: np.random.Generator) -> Array:
    """Return joint angles inside the hard stops [deg]: random, at stops, near singularities, or in the cradle."""
    low, high = np.array(LIMITS["hard"], dtype=np.float64).T
    q: Array = rng.uniform(np.maximum(low, -180), np.minimum(high, 180))
    match rng.integers(5):
        case 0:
            return np.zeros(6)
        case 1:
            which = rng.random(6) < 0.5
            return np.asarray(np.where(which, np.where(rng.random(6) < 0.5, low, high), q))
        case 2:
            low, high = np.array(LIMITS["soft"], dtype=np.float64).T
            return np.asarray(rng.uniform(np.maximum(low, -180), np.minimum(high, 180)))
        case 3:
            q[2] = -2.606 + rng.normal() * 0.5
            q[4] = rng.choice([-90.0, 90.0]) + rng.normal() * 0.5
            return np.asarray(np.clip(q, low, high))
        case _:
            return np.asarray(q)


def equipped(rng: np.random.Generator, first: Array, mass: str) -> str:
    """Return TOML lines: a payload, if a mass is given; for AUTO 1 and 2, random points near the first pose."""
    low, high = np.array(LIMITS["hard"], dtype=np.float64).T
    lines = ["", PAYLOAD.format(mass=mass) if mass else ""]
    for slot in (1, 2):
        lines.append(f"[[sequence]]\nslot = {slot}")
        for _ in range(rng.integers(1, 4)):
            joints = np.clip(first + rng.uniform(-10, 10, 6), low, high).tolist()
            pause = "true" if rng.random() < 0.5 else "false"
            there = f"{{ joints = {[f'{q!r} deg' for q in joints]} }}"
            lines.append(f"[[sequence.point]]\ntarget = {there}\npause = {pause}")
    return "\n".join(lines)


def inputs(rng: np.random.Generator, sim: aftdeck.Simulation) -> Iterator[aftdeck.Inputs]:
    """Yield random inputs that change about every half second."""
    held = aftdeck.Inputs()
    while True:
        if rng.random() < 0.05:
            t, r = (rng.uniform(-1, 1, 3) * (rng.random(3) < 0.6) for _ in range(2))
            full = rng.random() < 0.3
            if full:
                t, r = np.sign(t), np.sign(r)
            drive = float(rng.choice([-1.0, 0.0, 1.0, 0.3]))
            (t1, t2, t3), (r1, r2, r3) = t.tolist(), r.tolist()
            held = aftdeck.Inputs((t1, t2, t3), (r1, r2, r3), drive)
            goal = None
            if rng.random() < 0.3:
                now = np.degrees(sim.frame.angles if sim.frame else sim.scenario.initial_angles)
                near = (now + rng.uniform(-40, 40, 6)).tolist()
                goal = (joint_target if rng.random() < 0.5 else target)(sim.scenario.arm, near)
            yield aftdeck.Inputs(
                held.translation,
                held.rotation,
                drive,
                mode=str(rng.choice(MODES)) if rng.random() < 0.4 else None,
                law=LAWS[rng.integers(3)] if rng.random() < 0.3 else None,
                payload_axes=bool(rng.random() < 0.5),
                rate_hold=bool(rng.random() < 0.15),
                position_hold=bool(rng.random() < 0.4),
                joint=int(rng.integers(6)),
                rate="vernier" if rng.random() < 0.3 else "coarse",
                target=goal,
                proceed=bool(rng.random() < 0.5),
                stop=bool(rng.random() < 0.1),
            )
        yield held


def outside(angles: Array, stops: Array) -> Array:
    """Return the distance of each joint past its stops [rad]; 0 inside them."""
    return np.maximum(np.maximum(stops[:, 0] - angles, angles - stops[:, 1]), 0.0)


def check(
    before: Frame | None, first: Array, frame: Frame, period: float, mended: bool, up: tuple[float, float]
) -> None:
    """Check the invariants of a step."""
    where = f"{frame.time_s} s, {frame.mode}, {frame.limits}"
    was = np.array(before.angles) if before else first
    now = np.array(frame.angles)
    assert np.isfinite([*frame.angles, *frame.rates, *frame.twist, *frame.twist_commanded, frame.ratio]).all(), where
    assert np.isfinite([*frame.twist_demanded, *frame.resolution, *frame.singularity]).all(), where
    held_by = [*frame.singular, *(name for name, zone in zip(loaded.arm().joints, frame.zones, strict=True) if zone)]
    causes = [way.cause for way in frame.ways_out]
    assert causes in ([], ["contact"]) if frame.work.arm_inhibit else causes == held_by, where
    assert all(abs(r) <= m for r, m in zip(frame.rates_commanded, frame.rate_limits, strict=True)), where
    assert (outside(now, HARD) <= outside(was, HARD) + GRAIN).all(), where
    if frame.mode not in JOINT_MODES and mended:
        assert (outside(now, SOFT) <= outside(was, SOFT) + GRAIN).all(), where
    if not mended or by_joints(frame) or (before is not None and by_joints(before)):
        return
    if before is not None and before.payload is not None and by_point(before) != by_point(frame):
        return  # the commanded twist is now that of another point
    if at_rate(frame) or kinds(frame) & {"soft stop", "hard stop", "singularity", "joint acceleration", "contact"}:
        return
    last = np.array(before.twist_commanded if before else (0.0,) * 6)
    change = np.array(frame.twist_commanded) - last
    # mode 3 predicts half a step with the previous clock rate; while this rate rises, mode 3 brakes a little harder
    more = 0.05 if frame.law == 3 else 1e-6
    assert np.linalg.norm(change[3:]) <= up[0] * period * (1 + more) + 1e-12, where
    assert np.linalg.norm(change[:3]) <= up[1] * period * (1 + more) + 1e-12, where


def by_joints(frame: Frame) -> bool:
    """Return whether the mode commands joint rates; the POR limits then do not act."""
    return frame.mode in JOINT_MODES or frame.law == 1


def by_point(frame: Frame) -> bool:
    """Return whether the commanded twist is that of the payload's point of resolution."""
    return frame.law in {6, 7} or (frame.mode == "ORB LD" and frame.law == 4)


def flight(seed: int, extra: str = "", mended: bool = True, first: Array | None = None) -> None:
    """Make a random run from given joint angles [deg] or from random ones, and check every step."""
    rng = np.random.default_rng(seed)
    period = float(rng.choice([0.02, 0.02, 0.005, 0.08, 0.2]))
    pounds = float(rng.choice(POUNDS))
    up = loaded.arm().model.por_limits(pounds * POUND)
    mass = f"{pounds:g} lb" if pounds else ""
    first = start(rng) if first is None else first
    mode = "AUTO 1" if rng.random() < 0.2 else "ORB UNL"
    lines = f"control_period = {period}\nduration = {period * 1000}\nmode = {mode!r}\n{extra}"
    sim = aftdeck.Simulation(scenario(first.tolist(), lines + equipped(rng, first, mass)))
    before: Frame | None = None
    operator = inputs(rng, sim)
    for _ in range(STEPS):
        frame = sim.step(next(operator))
        check(before, sim.scenario.initial_angles, frame, period, mended, (up.acceleration, up.angular_acceleration))
        before = frame
