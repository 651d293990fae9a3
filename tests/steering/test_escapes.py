"""At singularities and joint limits, angles and rates stay finite, and the frame's escape direction leads away."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.simulation.frame import Frame, WayOut
from aftdeck.simulation.motion.ways_out import by_stick
from tests import loaded
from tests.each import each, seeds
from tests.kinematics.poses import STRAIGHT
from tests.reference.tables import table
from tests.steering.flying import PAYLOAD, fly, scenario
from tests.steering.random_runs import flight

LIMITS = table("srms-limits")
HARD, SOFT = np.array(LIMITS["hard"], dtype=np.float64), np.array(LIMITS["soft"], dtype=np.float64)
REACH = SOFT + np.array([1.0, -1.0]) * LIMITS["reach_inside_soft"]
KINDS = ("shoulder", "elbow", "wrist", "reach", "soft", "hard")
MODES = ("ORB UNL", "END EFF", "ORB LD", "PL")
ZERO = (0.0, 0.0, 0.0)


def anywhere(rng: np.random.Generator) -> Array:
    """Return random angles [deg] inside the reach limits, within 180 deg."""
    return np.asarray(rng.uniform(np.maximum(REACH[:, 0], -180.0), np.minimum(REACH[:, 1], 180.0)))


def near(kind: str, rng: np.random.Generator) -> Array:
    """Return random angles [deg] at or near a singularity, or at or just past a limit of one joint."""
    q = anywhere(rng)
    off = float(np.clip(rng.normal() * rng.choice([0.0, 0.01, 1.0, 5.0]), -8.0, 8.0))
    match kind:
        case "shoulder":
            while abs(float(loaded.arm().singularities(np.radians(q))[0])) > 0.1:
                q = anywhere(rng)
        case "elbow":
            q[2] = min(math.degrees(STRAIGHT) + off, HARD[2, 1])
        case "wrist":
            q[4] = float(rng.choice([-90.0, 90.0])) + off
        case _:
            joint, side = int(rng.integers(6)), int(rng.integers(2))
            q[joint] = {"reach": REACH, "soft": SOFT, "hard": HARD}[kind][joint, side]
            if kind != "hard":
                q[joint] += rng.uniform(0.0, 1.0) * (1.0 if side else -1.0)
    return np.asarray(np.clip(q, HARD[:, 0] + 1e-9, HARD[:, 1] - 1e-9))


def escape_inputs(escape: WayOut, mode: str) -> aftdeck.Inputs:
    """Return the inputs of an escape direction, in the panel position that it names, or in `mode` if it names none."""
    position = escape.position or mode
    if escape.stick == "joint":
        return aftdeck.Inputs(mode=position, joint=escape.axis, drive=float(escape.sign))
    x, y, z = (float(escape.sign) if k == escape.axis else 0.0 for k in range(3))
    if escape.stick == "translation":
        return aftdeck.Inputs((x, y, z), mode=position)
    return aftdeck.Inputs(rotation=(x, y, z), mode=position)


def clear(cause: str, frame: Frame) -> bool:
    """Return whether a singularity is no longer near, or a joint is back inside its reach limits."""
    if cause in ("shoulder", "elbow", "wrist"):
        return abs(frame.singularity[("shoulder", "elbow", "wrist").index(cause)]) >= 0.2
    joint = loaded.arm().joints.index(cause)
    return bool(REACH[joint, 0] <= math.degrees(frame.angles[joint]) <= REACH[joint, 1])


def follow(start: Array, mode: str, extra: str, seconds: float) -> None:
    """For each singularity and limit, follow the frame's escape direction, read every 2 s, until the arm is clear."""
    made = scenario(start.tolist(), f"control_period = 0.08\nduration = 80\n{extra}")
    first = aftdeck.Simulation(made).step(aftdeck.Inputs(mode=mode))
    causes = [*first.singular, *(loaded.arm().joints[joint] for joint, zone in enumerate(first.zones) if zone)]
    assert causes, start
    assert [escape.cause for escape in first.ways_out] == (["contact"] if first.work.arm_inhibit else causes)
    for cause in causes:
        sim = aftdeck.Simulation(made)
        frame, texts = sim.step(aftdeck.Inputs(mode=mode)), []
        while not clear(cause, frame):
            if frame.work.arm_inhibit:
                (contact,) = frame.ways_out
                assert contact.cause == "contact"
                assert frame.time_s < seconds, (start.tolist(), mode, extra, cause, frame.work.inhibits)
                frame = fly(sim, 2.0, escape_inputs(contact, mode))[-1]
                continue
            advice = next(escape for escape in frame.ways_out if escape.cause == cause)
            texts.append(advice.text)
            assert frame.time_s < seconds, (start.tolist(), mode, extra, cause, texts)
            if "as-flown" in extra and 2 in frame.zones:
                assert advice.stick == "joint", frame.zones  # as flown, only SINGLE leads back
            frame = fly(sim, 2.0, escape_inputs(advice, mode))[-1]
            assert np.isfinite([*frame.angles, *frame.rates]).all()


@pytest.mark.slow
@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("kind", KINDS)
def test_escape_of_the_frame_leads_out(kind: str, mode: str) -> None:
    rng = np.random.default_rng([220, KINDS.index(kind)])
    payload = PAYLOAD.format(mass="100 lb") if mode in ("ORB LD", "PL") else ""
    for soft_stops in ("mended", "as-flown"):
        follow(near(kind, rng), mode, f'soft_stops = "{soft_stops}"\n{payload}', 62.0)


@pytest.mark.slow
@pytest.mark.parametrize("mode", MODES)
@each("seed", seeds(4, 40))
def test_escapes_lead_out_from_many_poses(seed: int, mode: str) -> None:
    rng = np.random.default_rng([221, seed])
    payload = PAYLOAD.format(mass="1000 lb") if mode in ("ORB LD", "PL") else ""
    for kind in KINDS:
        soft_stops = "as-flown" if rng.random() < 0.3 else "mended"
        follow(near(kind, rng), mode, f'soft_stops = "{soft_stops}"\n{payload}', 120.0)


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["ORB LD", "PL"])
@each("seed", seeds(2, 6))
def test_escapes_lead_out_with_a_heavy_payload(seed: int, mode: str) -> None:
    rng = np.random.default_rng([222, seed])
    for kind in KINDS:
        follow(near(kind, rng), mode, PAYLOAD.format(mass="32000 lb"), 1200.0)


@pytest.mark.slow
@pytest.mark.parametrize(
    "start",
    [
        # shoulder pitch alone is no escape direction here: the joint reaches its stop, or the folded arm is too short
        (115.469, 88.788, -158.281, -96.997, -106.507, -89.65),
        (-107.884, 130.465, -70.984, -73.09, -90.0, 50.966),
        (26.557, 135.806, -85.422, 77.213, -101.794, -41.189),
        # the elbow is between straight and its upper stop; the stop is too near for an escape direction
        (142.0, 5.872, -1.589, -39.584, 98.826, 104.884),
        (0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    ],
)
@pytest.mark.parametrize("soft_stops", ["mended", "as-flown"])
def test_escape_does_not_end_at_a_stop(start: tuple[float, ...], soft_stops: str) -> None:
    for mode in ("ORB UNL", "END EFF"):
        follow(np.array(start), mode, f'soft_stops = "{soft_stops}"', 62.0)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
@each("seed", seeds(2, 4))
def test_invariants_hold_near_singularities_and_limits(kind: str, seed: int) -> None:
    flight(seed, first=near(kind, np.random.default_rng([223, KINDS.index(kind), seed])))


@pytest.mark.parametrize("kind", KINDS)
def test_strict_run_is_bounded_near_singularities_and_limits(kind: str) -> None:
    first = near(kind, np.random.default_rng([224, KINDS.index(kind)]))
    flight(7, "strict = true\n", mended=False, first=first)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
@each("seed", seeds(4, 40, first=100))
def test_invariants_hold_from_many_poses_near_singularities(kind: str, seed: int) -> None:
    flight(seed, first=near(kind, np.random.default_rng([225, KINDS.index(kind), seed])))


def test_escape_in_joint_modes_is_a_joint_in_the_present_mode() -> None:
    sim = aftdeck.Simulation(scenario((0, 60, -80, 20, 85, 0)))
    for mode in ("SINGLE", "DIRECT", "MASTER"):
        (escape,) = sim.step(aftdeck.Inputs(mode=mode)).ways_out
        assert (escape.cause, escape.stick, escape.axis, escape.sign, escape.position) == (
            "wrist",
            "joint",
            4,
            -1,
            mode,
        )
        assert escape.text == f"{mode} wrist yaw −"


def test_escape_in_automatic_mode_names_orb_unl() -> None:
    sim = aftdeck.Simulation(scenario((0, 60, -80, 20, 85, 0)))
    (by_hand,) = sim.step(aftdeck.Inputs(mode="ORB UNL")).ways_out
    (escape,) = sim.step(aftdeck.Inputs(mode="OPR CMD")).ways_out
    assert (by_hand.position, escape.position) == ("", "ORB UNL")
    assert (escape.stick, escape.axis, escape.sign) == (by_hand.stick, by_hand.axis, by_hand.sign)
    assert escape.text == f"ORB UNL, {by_hand.text}"


def test_escape_text_names_stick_axis_and_sign() -> None:
    state = aftdeck.Simulation(scenario())._state
    for k in range(12):
        escape = by_stick(state, "contact", k)
        stick, direction = escape.text.split(" ")
        names = ("X", "Y", "Z") if escape.stick == "translation" else ("roll", "pitch", "yaw")
        assert stick == ("THC" if escape.stick == "translation" else "RHC")
        assert direction == ("+" if escape.sign > 0 else "−") + names[escape.axis]


def test_no_escape_far_from_limits() -> None:
    assert aftdeck.Simulation(scenario()).step(aftdeck.Inputs()).ways_out == ()


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["shoulder", "elbow", "wrist"])
def test_escape_joint_needs_the_least_rotation(kind: str) -> None:
    rng = np.random.default_rng([226, KINDS.index(kind)])
    which, leavers = KINDS.index(kind), {"shoulder": (1, 2, 3), "elbow": (2,), "wrist": (4,)}[kind]
    rotations = np.radians(np.arange(0.25, 320.0, 0.25))
    tested = 0
    while tested < 15:
        q = np.clip(near(kind, rng), REACH[:, 0], REACH[:, 1])
        ways_out = aftdeck.Simulation(scenario(q.tolist())).step(aftdeck.Inputs(mode="SINGLE")).ways_out
        for escape in ways_out:
            if escape.cause != kind:
                continue
            tested += 1
            least = {}
            for joint in leavers:
                for sign in (-1, 1):
                    angles = np.tile(np.radians(q), (len(rotations), 1))
                    angles[:, joint] += sign * rotations
                    inside = (angles[:, joint] > np.radians(REACH[joint, 0])) & (
                        angles[:, joint] < np.radians(REACH[joint, 1])
                    )
                    clear = np.flatnonzero((np.abs(loaded.arm().singularities(angles)[which]) > 0.2) & inside)
                    least[joint, sign] = rotations[clear[0]] if len(clear) else math.inf
            # the simulation searches in steps of half a degree
            assert least[escape.axis, escape.sign] <= min(least.values()) + math.radians(0.8), (
                q.tolist(),
                escape,
                least,
            )
