"""The report's subroutines, one call each, against its formulas in plain NumPy, in metres and in feet."""

# ruff: noqa: SIM300 (the report's symbols are capitals, which look like constants)
from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import Literal, TypedDict

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck import jsc12628
from aftdeck.arrays import Array
from aftdeck.errors import InputError, LimitError, SingularityError, UnreachableError
from tests import loaded

FOOT = 0.3048
BOTH = ("srms", "concept-1972")
E1, E3 = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])


class Limits(TypedDict):
    """Limits of the tip's motion, in metres, radians and seconds."""

    V_L: float
    omega_L: float
    V_L_dot: float
    omega_L_dot: float


class Sticks(TypedDict):
    """The operator's commands in modes 4 to 8."""

    omega_C: Array
    V_C: Array
    joint: int
    theta_dot_C: float


LIMITS: Limits = {"V_L": 0.6, "omega_L": 0.08, "V_L_dot": 0.15, "omega_L_dot": 0.03}
LIMIT_VALUES = (LIMITS["V_L"], LIMITS["omega_L"], LIMITS["V_L_dot"], LIMITS["omega_L_dot"])
SERVO = np.array([0.04, 0.04, 0.06, 0.08, 0.08, 0.08])

poses = st.builds(
    lambda *q: np.array(q),
    st.floats(-2.5, 2.5), st.floats(0.3, 1.8), st.floats(-2.2, -0.5), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0),
    st.floats(-3.0, 3.0),
)  # fmt: skip
sixes = st.lists(st.floats(-0.2, 0.2), min_size=6, max_size=6).map(np.array)
turns = st.lists(st.floats(-3.0, 3.0), min_size=3, max_size=3)
units = st.sampled_from(["m", "ft"])
SOME = settings(max_examples=60)


# the report's own notation: passive matrices, and the mount of the arm
def T1(a: float) -> Array:
    c, s = math.cos(a), math.sin(a)
    return np.array([[1, 0, 0], [0, c, s], [0, -s, c]])


def T2(a: float) -> Array:
    c, s = math.cos(a), math.sin(a)
    return np.array([[c, 0, -s], [0, 1, 0], [s, 0, c]])


def T3(a: float) -> Array:
    c, s = math.cos(a), math.sin(a)
    return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])


@functools.cache
def links() -> tuple[float, ...]:
    """Return the lengths L1 to L5 [m], and the slopes of both booms [rad]."""
    return tuple(float(x) for x in loaded.arm().model.links[:7])


def angles_of(q: Array) -> Array:
    """Return the report's angles, which are for an arm without offsets, from the operator's angles."""
    *_, UPPER, LOWER = links()
    return np.asarray(q + np.array([0.0, UPPER, LOWER - UPPER, -LOWER, 0.0, 0.0]))


def plain_lnkage(q: Array) -> tuple[Array, Array, Array]:
    t1, t2, t3, t4, t5, t6 = angles_of(q)
    mount, (L1, L2, L3, L4, L5, *_) = loaded.arm().model.mount, links()
    T_LB = mount.rotation.T
    r = mount.origin - mount.orbiter_origin - T_LB.T @ E3 * L1
    turn = T_LB.T @ T3(t1).T @ T2(t2).T
    r = r + turn @ E1 * L2
    turn = turn @ T2(t3).T
    r = r + turn @ E1 * L3
    T_B5 = turn @ T2(t4).T
    r = r + T_B5 @ E1 * L4
    turn = T_B5 @ T3(t5).T
    return r + turn @ E1 * L5, turn @ T1(t6).T, T_B5


def plain_jacobi(q: Array) -> Array:
    _, t2, t3, t4, t5, _ = angles_of(q)
    t234, t34 = t2 + t3 + t4, t3 + t4
    s, c = math.sin, math.cos
    _, L2, L3, L4, L5, *_ = links()
    a = np.zeros((6, 6))
    a[0, 0], a[0, 5] = -s(t234), c(t5)
    a[1, 1] = a[1, 2] = a[1, 3] = 1.0
    a[1, 5], a[2, 0], a[2, 4] = s(t5), c(t234), 1.0
    a[3, 0], a[3, 1], a[3, 2], a[3, 4] = -L5 * c(t234) * s(t5), L2 * s(t34) + L3 * s(t4), L3 * s(t4), -L5 * s(t5)
    a[4, 0], a[4, 4] = L2 * c(t2) + L3 * c(t2 + t3) + (L4 + L5 * c(t5)) * c(t234), L5 * c(t5)
    a[5, 0], a[5, 1] = -L5 * s(t234) * s(t5), -L2 * c(t34) - L3 * c(t4) - L4 - L5 * c(t5)
    a[5, 2], a[5, 3] = -L3 * c(t4) - L4 - L5 * c(t5), -(L4 + L5 * c(t5))
    return a


def plain_erates(q: Array, rates: Array) -> tuple[Array, Array]:
    b, (_, _, T_B5) = plain_jacobi(q) @ rates, plain_lnkage(q)
    return T_B5 @ b[:3], T_B5 @ b[3:]


def plain_rmsrat(q: Array, omega: Array, v: Array) -> Array:
    T_B5 = plain_lnkage(q)[2]
    solved: Array = np.linalg.solve(plain_jacobi(q), np.concatenate([T_B5.T @ omega, T_B5.T @ v]))
    return solved


def plain_avclmt(wanted: Array, present: Array, most: float, up: float, dt: float) -> Array:
    change = wanted - present
    if np.linalg.norm(change) > up * dt:
        wanted = present + up * dt * change / np.linalg.norm(change)
    size = np.linalg.norm(wanted)
    return wanted * (most / size) if size > most else wanted


def plain_vclose(
    d: float, w: float, v_l: float, w_l: float, dv: float, dw: float, dt: float
) -> tuple[float, float, float]:
    def alone(left: float, most: float, up: float) -> tuple[float, float]:
        t, eta = most / up, left / most
        if t <= eta:
            return t, eta + t / 2
        t = math.sqrt(2 * left / up)
        return t, t

    (t_v, eta), (t_w, etap) = alone(d, v_l, dv), alone(w, w_l, dw)
    if max(eta, etap) < dt:
        return 0.0, 0.0, 0.0
    if eta >= etap:
        return dv * t_v, w / max(eta - t_w / 2, dt), eta
    return d / max(etap - t_v / 2, dt), dw * t_w, etap


def plain_latraj(r: Array, T: Array, rf: Array, Tf: Array) -> tuple[float, float, Array]:
    B = Tf @ T.T
    skew = np.array([B[2, 1] - B[1, 2], B[0, 2] - B[2, 0], B[1, 0] - B[0, 1]]) / 2
    return float(np.linalg.norm(rf - r)), math.acos(np.clip((np.trace(B) - 1) / 2, -1, 1)), skew


def rotation(a: list[float]) -> Array:
    return T3(a[0]).T @ T2(a[1]).T @ T1(a[2]).T


@SOME
@given(poses, sixes, units)
def test_linkage_jacobian_and_rates_agree_with_the_report(q: Array, rates: Array, unit: jsc12628.Units) -> None:
    foot = FOOT if unit == "ft" else 1.0
    r, T_B7, T_B5 = plain_lnkage(q)
    found = jsc12628.lnkage(loaded.arm(), q, unit)
    np.testing.assert_allclose(found.r_6B, r / foot, atol=1e-11)
    np.testing.assert_allclose(found.T_B7, T_B7, atol=1e-12)
    np.testing.assert_allclose(found.T_B5, T_B5, atol=1e-12)
    a = plain_jacobi(q)
    a[3:] /= foot
    np.testing.assert_allclose(jsc12628.jacobi(loaded.arm(), q, unit), a, atol=1e-11)
    omega, v = plain_erates(q, rates)
    moving = jsc12628.erates(loaded.arm(), q, rates, unit)
    np.testing.assert_allclose(moving.omega, omega, atol=1e-12)
    np.testing.assert_allclose(moving.V, v / foot, atol=1e-11)
    solved = jsc12628.rmsrat(loaded.arm(), q, omega, v / foot, unit)
    np.testing.assert_allclose(solved, plain_rmsrat(q, omega, v), atol=1e-9)
    np.testing.assert_allclose(solved, rates, atol=1e-9)


@SOME
@given(poses, units, st.sampled_from(BOTH))
def test_rmangs_inverts_lnkage_and_rmsist_agrees(q: Array, unit: jsc12628.Units, name: str) -> None:
    arm = loaded.arm(name)
    r, T, _ = jsc12628.lnkage(arm, q, unit)
    try:
        theta = jsc12628.rmangs(arm, r, T, unit)
    except (SingularityError, UnreachableError):  # on the other branch of the concept arm's wrist
        assert name != "srms"
        return
    again = jsc12628.lnkage(arm, theta, unit)
    np.testing.assert_allclose(again.r_6B, r, atol=1e-8)
    np.testing.assert_allclose(again.T_B7, T, atol=1e-9)
    if name == "srms":  # the report's branch: wrist yaw within 90 deg, and the elbow above the shoulder-wrist line
        assert abs(theta[4]) <= math.pi / 2 and angles_of(theta)[2] <= 0.0
        np.testing.assert_allclose(theta, q - math.tau * np.round(q / math.tau), atol=1e-8)
    low, high = arm.limits.hard.T
    if (theta >= low).all() and (theta <= high).all():
        start = jsc12628.rmsist(arm, r_6B=r, T_B7=T, units=unit)
        np.testing.assert_allclose(start.theta, theta, atol=1e-12)
        assert not start.omega.any() and not start.V.any()
    else:
        with pytest.raises(LimitError):
            jsc12628.rmsist(arm, r_6B=r, T_B7=T, units=unit)


@SOME
@given(turns, turns, turns, turns, units)
def test_latraj_agrees_with_the_report(
    r: list[float], a: list[float], rf: list[float], af: list[float], unit: jsc12628.Units
) -> None:
    T, Tf = rotation(a), rotation(af)
    distance, angle, skew = plain_latraj(np.array(r), T, np.array(rf), Tf)
    found = jsc12628.latraj(r, T, rf, Tf, unit)
    assert found.delta_V == pytest.approx(distance) and found.delta_omega == pytest.approx(angle, abs=1e-7)
    np.testing.assert_allclose(found.delta_V * found.U_V, np.array(rf) - r, atol=1e-12)
    np.testing.assert_allclose(math.sin(found.delta_omega) * found.U_omega, skew, atol=1e-9)


@SOME
@given(st.floats(0.0, 20.0), st.floats(0.0, 3.1), st.sampled_from([0.02, 0.08]), st.floats(0.0, 50.0), units)
def test_vclose_and_vtopen_agree_with_the_report(
    d: float, w: float, dt: float, tp: float, unit: jsc12628.Units
) -> None:
    foot = FOOT if unit == "ft" else 1.0
    most: Limits = {**LIMITS, "V_L": LIMITS["V_L"] / foot, "V_L_dot": LIMITS["V_L_dot"] / foot}
    v, o, eta = plain_vclose(d, w, *LIMIT_VALUES, dt)
    found = jsc12628.vclose(d / foot, w, **most, DT=dt, TP=tp, units=unit)
    assert found.V_C == pytest.approx(v / foot, abs=1e-12) and found.omega_C == pytest.approx(o, abs=1e-12)
    assert found.ETA == pytest.approx(tp + eta)
    plan = jsc12628.vtopen(d / foot, w, **most, units=unit)
    assert plan.R_V * (plan.ETA - plan.t_v1) == pytest.approx(d / foot, abs=1e-12)
    assert plan.R_omega * (plan.ETA - plan.t_w1) == pytest.approx(w, abs=1e-12)
    ramps = (LIMITS["V_L"] / LIMITS["V_L_dot"], LIMITS["omega_L"] / LIMITS["omega_L_dot"])
    given = ((d, LIMITS["V_L"], ramps[0], LIMITS["V_L_dot"]), (w, LIMITS["omega_L"], ramps[1], LIMITS["omega_L_dot"]))
    ways = [
        (way / r + t, t) if t <= way / r else (2 * math.sqrt(way / up), math.sqrt(way / up)) for way, r, t, up in given
    ]
    assert plan.ETA == pytest.approx(max(ways)[0]) and (plan.t_v1, plan.t_w1) == pytest.approx((ways[0][1], ways[1][1]))
    assert (plan.t_v2, plan.t_w2) == pytest.approx((plan.ETA - plan.t_v1, plan.ETA - plan.t_w1))


@SOME
@given(sixes, sixes, st.sampled_from([0.02, 0.08, 1.0]), units)
def test_avclmt_and_ratlmt_agree_with_the_report(
    wanted: Array, present: Array, dt: float, unit: jsc12628.Units
) -> None:
    foot = FOOT if unit == "ft" else 1.0
    most: Limits = {**LIMITS, "V_L": 0.1 / foot, "V_L_dot": LIMITS["V_L_dot"] / foot}
    found = jsc12628.avclmt(
        wanted[:3], wanted[3:] / foot, present[:3], present[3:] / foot, **most, DT=dt, units=unit
    )  # fmt: skip
    omega = plain_avclmt(wanted[:3], present[:3], LIMITS["omega_L"], LIMITS["omega_L_dot"], dt)
    v = plain_avclmt(wanted[3:], present[3:], 0.1, LIMITS["V_L_dot"], dt)
    np.testing.assert_allclose(found.omega_C, omega, atol=1e-14)
    np.testing.assert_allclose(found.V_C, v / foot, atol=1e-13)
    ratio = min(1.0, *(m / abs(r) for m, r in zip(SERVO, wanted, strict=True) if abs(r) > 1e-9), 1.0)
    held = jsc12628.ratlmt(wanted, SERVO)
    assert held.RATIO == pytest.approx(ratio)
    np.testing.assert_allclose(held.theta_dot_C, ratio * wanted, atol=1e-14)


@SOME
@given(turns, turns, turns, turns)
def test_votran_returns_each_modes_command_in_b(w: list[float], v: list[float], a: list[float], b: list[float]) -> None:
    T_B7, T_78 = rotation(a), rotation(b)
    for mode, turn_w, turn_v in ((4, np.eye(3), np.eye(3)), (5, T_B7, T_B7), (6, T_B7 @ T_78, T_B7 @ T_78),
                                 (7, T_B7 @ T_78, np.eye(3))):  # fmt: skip
        found = jsc12628.votran(mode, w, v, T_B7=T_B7, T_78=T_78)  # type: ignore[arg-type]
        np.testing.assert_allclose(found.omega_C, turn_w @ w, atol=1e-12)
        np.testing.assert_allclose(found.V_C, turn_v @ v, atol=1e-12)
    plan = jsc12628.vtopen(10.0, 1.0, **LIMITS)
    for tp in (0.0, 0.5 * plan.t_v1, plan.t_v1, 0.5 * plan.ETA, plan.t_v2 + 0.3, plan.ETA):
        share = tp / plan.t_v1 if tp < plan.t_v1 else (plan.ETA - tp) / plan.t_v1 if tp > plan.t_v2 else 1.0
        found = jsc12628.votran(3, w, v, profile=plan, TP=tp)
        np.testing.assert_allclose(found.V_C, share * np.array(v), atol=1e-12)


@pytest.mark.slow
@settings(max_examples=25)
@given(poses, sixes, st.sampled_from([2, 4, 5, 6, 7]), turns, units)
def test_msteer_agrees_with_the_report_step_by_step(
    q: Array, aim: Array, mode: Literal[2, 4, 5, 6, 7], turn: list[float], unit: jsc12628.Units
) -> None:
    """Compare twenty steps of each mode with plain VOTRAN, AVCLMT, RMSRAT and RATLMT, with feedback by ERATES."""
    foot, dt, T_78 = FOOT if unit == "ft" else 1.0, 0.08, rotation(turn)
    aim = 0.2 * aim  # slow, so that the arm does not come near a singularity
    most: Limits = {**LIMITS, "V_L": LIMITS["V_L"] / foot, "V_L_dot": LIMITS["V_L_dot"] / foot}
    r, T, _ = plain_lnkage(q)
    final, Tf = r + 0.5 * E1, T @ T1(0.05).T
    phase = jsc12628.operin(
        loaded.arm(), mode, q, **most, theta_dot_L=SERVO, DT=dt, r_6BF=final / foot if mode == 2 else None,
        T_B7F=Tf if mode == 2 else None, omega_C=aim[:3], V_C=aim[3:] / foot, T_78=T_78, units=unit,
    )  # fmt: skip
    rates = np.zeros(6)
    for k in range(20):
        step = jsc12628.msteer(phase, q, rates)
        r, T, _ = plain_lnkage(q)
        if mode == 2:
            d, w, skew = plain_latraj(r, T, final, Tf)
            v_c, w_c, eta = plain_vclose(d, w, *LIMIT_VALUES, dt)
            omega, v = w_c * skew / max(float(np.linalg.norm(skew)), 1e-30), v_c * (final - r) / max(d, 1e-30)
            assert step.ETA == pytest.approx(k * dt + eta, abs=1e-6)
        else:
            by = {4: (np.eye(3), np.eye(3)), 5: (T, T), 6: (T @ T_78, T @ T_78), 7: (T @ T_78, np.eye(3))}[mode]
            omega, v = by[0] @ aim[:3], by[1] @ aim[3:]
        present = plain_erates(q, rates)
        omega = plain_avclmt(omega, present[0], LIMITS["omega_L"], LIMITS["omega_L_dot"], dt)
        v = plain_avclmt(v, present[1], LIMITS["V_L"], LIMITS["V_L_dot"], dt)
        wanted = plain_rmsrat(q, omega, v)
        ratio = min(1.0, *(SERVO / np.maximum(np.abs(wanted), 1e-12)))
        np.testing.assert_allclose(step.theta_dot_C, ratio * wanted, atol=2e-7)
        assert step.RATIO == pytest.approx(ratio, abs=1e-6)
        np.testing.assert_allclose(step.V_C * foot, ratio * v, atol=2e-7)
        rates = ratio * wanted
        q = q + rates * dt


@SOME
@given(poses, turns, turns, units, st.sampled_from(BOTH))
def test_lnkage_gives_the_pose_of_an_attached_payload(
    q: Array, turn: list[float], offset: list[float], unit: jsc12628.Units, name: str
) -> None:
    arm, T_78 = loaded.arm(name), rotation(turn)
    found = jsc12628.lnkage(arm, q, unit, PA=1, T_78=T_78, r_87=offset)
    empty = jsc12628.lnkage(arm, q, unit)
    for mine, plain in zip(found[:3], empty, strict=True):
        np.testing.assert_array_equal(mine, plain)
    np.testing.assert_allclose(found.T_B8, empty.T_B7 @ T_78, atol=1e-12)
    np.testing.assert_allclose(found.r_7B, empty.r_6B + empty.T_B7 @ T_78 @ offset, atol=1e-12)
    at_tip = jsc12628.lnkage(arm, q, unit, PA=1)
    np.testing.assert_allclose(at_tip.r_7B, at_tip.r_6B, atol=1e-12)
    np.testing.assert_allclose(at_tip.T_B8, at_tip.T_B7, atol=1e-12)


Q = np.array([0.2, 1.0, -1.4, 0.3, 0.2, 0.4])
"""Joint angles of the Shuttle's arm, far from every singularity [rad]."""
near = st.lists(st.floats(-0.05, 0.05), min_size=6, max_size=6).map(np.array)


def flown(phase: jsc12628.Phase, q: Array, dt: float) -> tuple[list[jsc12628.Msteer], Array]:
    """Return all steps of a phase whose joints follow the commanded rates exactly, and the last joint angles."""
    steps: list[jsc12628.Msteer] = []
    while not (steps and steps[-1].done):
        steps.append(jsc12628.msteer(phase, q))
        q = q if steps[-1].done else q + dt * steps[-1].theta_dot_C
        assert len(steps) < 5000
    return steps, q


@settings(max_examples=20)
@given(near, st.sampled_from([1, 3]), st.sampled_from([0.02, 0.08]))
def test_phases_of_modes_1_and_3_end_at_their_eta(way: Array, mode: Literal[1, 3], dt: float) -> None:
    r, T, _ = plain_lnkage(Q + way)
    phase = jsc12628.operin(loaded.arm(), mode, Q, **LIMITS, theta_dot_L=SERVO, DT=dt, r_6BF=r, T_B7F=T)
    planned = phase.ETA
    steps, _ = flown(phase, Q, dt)
    assert {step.ETA for step in steps} == {planned}
    last = (len(steps) - 1) * dt
    assert planned - 1e-6 <= last < planned + dt + 1e-6


@settings(max_examples=40)
@given(st.sampled_from([4, 5, 6, 7, 8]), st.floats(0.0, 3.0), st.sampled_from([0.02, 0.08, 0.1]), sixes)
def test_phases_of_modes_4_to_8_end_at_the_given_eta(
    mode: Literal[4, 5, 6, 7, 8], eta: float, dt: float, aim: Array
) -> None:
    given: Sticks = {"omega_C": 0.1 * aim[:3], "V_C": aim[3:], "joint": 3, "theta_dot_C": float(aim[0])}
    phase = jsc12628.operin(loaded.arm(), mode, Q, **LIMITS, theta_dot_L=SERVO, DT=dt, ETA=eta, **given)
    steps, _ = flown(phase, Q, dt)
    assert len(steps) - 1 == max(0, math.ceil((eta - 1e-9) / dt))
    assert {step.ETA for step in steps} == {eta}
    endless = jsc12628.operin(loaded.arm(), mode, Q, **LIMITS, theta_dot_L=SERVO, DT=dt, **given)
    step = jsc12628.msteer(endless, Q)
    assert (step.ETA, step.done) == (math.inf, False)


@settings(max_examples=20)
@given(near, st.sampled_from([1, 2, 3]), units)
def test_final_pose_may_be_given_by_euler_angles_and_mode_1_takes_a_pose(
    way: Array, mode: Literal[1, 2, 3], unit: jsc12628.Units
) -> None:
    foot = FOOT if unit == "ft" else 1.0
    most: Limits = {**LIMITS, "V_L": LIMITS["V_L"] / foot, "V_L_dot": LIMITS["V_L_dot"] / foot}
    way = way + 0.06  # every joint moves: a plan without a motion has no end time to compare
    r, T, _ = plain_lnkage(Q + way)
    start = functools.partial(
        jsc12628.operin, loaded.arm(), mode, Q, **most, theta_dot_L=SERVO, DT=0.08, units=unit
    )  # fmt: skip
    phases = [start(r_6BF=r / foot, T_B7F=T), start(r_6BF=r / foot, xi_F=jsc12628.oriend(T))]
    if mode == 1:
        phases.append(start(theta_F=Q + way))
    for _ in range(5):
        first, *others = [jsc12628.msteer(phase, Q) for phase in phases]
        for other in others:
            np.testing.assert_allclose(other.theta_dot_C, first.theta_dot_C, atol=1e-7)
            assert other.ETA == pytest.approx(first.ETA, abs=1e-6)


SKEW = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.01], [0.0, 0.0, 1.0]])
MIRRORED = np.diag([1.0, 1.0, -1.0])
ZERO = np.zeros(3)


@pytest.mark.parametrize("wrong", [SKEW, MIRRORED, 2.0 * np.eye(3), np.zeros((3, 3))])
def test_what_is_no_rotation_is_rejected_by_name(wrong: Array) -> None:
    good, arm = np.eye(3), loaded.arm()
    phase = functools.partial(jsc12628.operin, arm, theta_0=Q, **LIMITS, theta_dot_L=SERVO, DT=0.08)
    calls: list[tuple[str, Callable[[], object]]] = [
        ("rotation", lambda: jsc12628.oriend(wrong)),
        ("T_B7", lambda: jsc12628.latraj(ZERO, wrong, ZERO, good)),
        ("T_B7F", lambda: jsc12628.latraj(ZERO, good, ZERO, wrong)),
        ("T_B7", lambda: jsc12628.votran(5, ZERO, ZERO, T_B7=wrong)),
        ("T_78", lambda: jsc12628.votran(6, ZERO, ZERO, T_78=wrong)),
        ("T_B7", lambda: jsc12628.rmangs(arm, [5.0, 0.0, 0.0], wrong)),
        ("T_B7", lambda: jsc12628.rmsist(arm, r_6B=[5.0, 0.0, 0.0], T_B7=wrong)),
        ("T_78", lambda: jsc12628.lnkage(arm, Q, PA=1, T_78=wrong)),
        ("T_78", lambda: phase(mode=6, T_78=wrong)),
        *(("T_B7F", functools.partial(phase, mode=mode, r_6BF=ZERO, T_B7F=wrong)) for mode in (1, 2, 3)),
    ]
    for name, call in calls:
        with pytest.raises(InputError, match=f"^{name}: "):
            call()


@pytest.mark.parametrize("wrong", [-1.0, -1e-12, math.nan, math.inf])
@pytest.mark.parametrize("function", [functools.partial(jsc12628.vclose, DT=0.02), jsc12628.vtopen])
def test_distance_and_angle_are_finite_and_not_negative(function: Callable[..., object], wrong: float) -> None:
    with pytest.raises(InputError, match="delta_V"):
        function(wrong, 1.0, **LIMITS)
    with pytest.raises(InputError, match="delta_omega"):
        function(1.0, wrong, **LIMITS)
    function(0.0, 0.0, **LIMITS)


def test_mode_8_ramps_one_joint_to_its_rate() -> None:
    q = np.array([0.2, 1.0, -1.4, 0.3, 0.2, 0.4])
    phase = jsc12628.operin(loaded.arm(), 8, q, **LIMITS, theta_dot_L=SERVO, DT=0.1, joint=3, theta_dot_C=-0.05)
    rates = [jsc12628.msteer(phase, q).theta_dot_C for _ in range(60)]
    up = SERVO[3] * LIMITS["V_L_dot"] / LIMITS["V_L"]
    for k, rate in enumerate(rates, 1):
        np.testing.assert_allclose(rate, np.eye(6)[3] * -min(0.05, k * up * 0.1), atol=1e-12)


def test_invalid_argument_is_rejected_by_name() -> None:
    q = [0.2, 1.0, -1.4, 0.3, 0.2, 0.4]
    start = functools.partial(jsc12628.operin, loaded.arm(), theta_0=q, **LIMITS, theta_dot_L=SERVO, DT=0.02)
    for call, name in (
        (lambda: jsc12628.lnkage(loaded.arm(), q, "in"), "units"),  # type: ignore[call-overload]
        (lambda: jsc12628.lnkage(loaded.arm(), q[:5]), "theta"),
        (lambda: jsc12628.lnkage(loaded.arm(), [math.nan] * 6), "theta"),
        (lambda: jsc12628.rmsrat(loaded.arm(), q, [0, 0], [0, 0, 0]), "omega_C"),
        (lambda: jsc12628.vclose(1.0, 1.0, V_L=0.0, omega_L=1.0, V_L_dot=1.0, omega_L_dot=1.0, DT=0.02), "V_L"),
        (lambda: jsc12628.ratlmt(q, np.zeros(6)), "theta_dot_L"),
        (lambda: jsc12628.votran(8, [0, 0, 0], [0, 0, 0]), "mode"),  # type: ignore[arg-type]
        (lambda: jsc12628.operin(loaded.arm(), 1, q, **LIMITS, theta_dot_L=SERVO, DT=0.02), "theta_F"),
        (lambda: jsc12628.rmsist(loaded.arm()), "rmsist"),
        (lambda: start(mode=1, theta_F=q, r_6BF=ZERO), "theta_F"),
        (lambda: start(mode=2, r_6BF=ZERO, T_B7F=np.eye(3), xi_F=ZERO), "xi_F"),
        (lambda: start(mode=2, r_6BF=ZERO), "T_B7F"),
        (lambda: start(mode=1, r_6BF=ZERO), "T_B7F"),
        (lambda: start(mode=3, r_6BF=ZERO, T_B7F=np.eye(3), ETA=5.0), "ETA"),
        (lambda: start(mode=4, ETA=-1.0), "ETA"),
        (lambda: start(mode=2, theta_F=q, r_6BF=ZERO, T_B7F=np.eye(3)), "theta_F"),
        (lambda: start(mode=4, r_6BF=ZERO), "r_6BF"),
        (lambda: start(mode=8, xi_F=ZERO), "xi_F"),
        (lambda: jsc12628.lnkage(loaded.arm(), q, r_87=ZERO), "r_87"),  # type: ignore[call-overload]
        (lambda: jsc12628.lnkage(loaded.arm(), q, PA=2), "PA"),  # type: ignore[call-overload]
        (lambda: jsc12628.vclose(1.0, 1.0, **LIMITS, DT=0.02, TP=-1.0), "TP"),
    ):
        with pytest.raises(InputError, match=name):
            call()
    with pytest.raises(SingularityError):
        jsc12628.rmsrat(loaded.arm(), [0, 1, -1, 0, math.pi / 2, 0], [1, 0, 0], [0, 0, 0])
    with pytest.raises(UnreachableError):
        jsc12628.rmangs(loaded.arm(), [90.0, 0.0, 0.0], np.eye(3))


def test_result_does_not_depend_on_the_number_type() -> None:
    q = np.array([0.25, 1.0, -1.5, 0.5, 0.25, 0.5])
    one = jsc12628.lnkage(loaded.arm(), q)
    for other in (q.astype(np.float32), q.tolist(), tuple(np.float64(x) for x in q), np.array(q, dtype=object)):
        np.testing.assert_array_equal(jsc12628.lnkage(loaded.arm(), other).r_6B, one.r_6B)
    profile = jsc12628.vclose(np.float64(2.0), np.float32(0.5), **LIMITS, DT=np.float64(0.02))  # type: ignore[arg-type]
    assert profile == jsc12628.vclose(2.0, 0.5, **LIMITS, DT=0.02)
