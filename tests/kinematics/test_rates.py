"""RMSRAT: joint rates for a twist, and singular poses."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import ArrayLike

import aftdeck
from aftdeck.arrays import Array
from aftdeck.errors import InputError, SingularityError
from aftdeck.kinematics.jacobian import Twist, jacobi
from aftdeck.kinematics.linkage import sines
from aftdeck.kinematics.rates import rmsrat
from aftdeck.kinematics.singular import distances
from tests.kinematics.poses import legal, singular_poses

AWAY = [0.3, 1.0, -1.3, 0.4, 0.2, 0.1]


def test_rates_times_the_jacobian_give_the_twist(any_arm: aftdeck.Arm) -> None:
    q = legal(any_arm, 20, 20_000)
    near = np.abs(np.stack(any_arm.singularities(q))).min(axis=0)
    q, near = q[near > 1e-3], near[near > 1e-3]
    twist = np.random.default_rng(20).normal(size=(len(q), 6))
    rates = np.asarray(any_arm.joint_rates(q, twist))
    got = np.matvec(any_arm.jacobian(q), rates)
    assert (np.abs(got - twist).max(axis=1) * near).max() < 1e-11


def test_rates_agree_with_a_general_linear_solver(any_arm: aftdeck.Arm) -> None:
    q = legal(any_arm, 21, 3000)
    q = q[np.abs(np.stack(any_arm.singularities(q))).min(axis=0) > 0.02]
    twist = np.random.default_rng(21).normal(size=(len(q), 6))
    expected = np.linalg.solve(any_arm.jacobian(q), twist[:, :, None])[:, :, 0]
    assert np.asarray(any_arm.joint_rates(q, twist)) == pytest.approx(expected, rel=1e-9, abs=1e-9)


def by_the_report(arm: aftdeck.Arm, angles: Array, twist: Array, floor: float) -> Array:
    """Return the joint rates of RMSRAT at one pose, by the report's equations in frame 5.

    Denominators are at least `floor`.
    """
    links = arm.model.links
    _, l2, l3, l4, *_ = (float(x) for x in links)
    a = sines(links, *angles)
    j = jacobi(links, a)
    shoulder, elbow, wrist = (math.copysign(max(abs(d), floor), d) for d in distances(links, a))
    to_5 = np.array(
        [
            [a.c1 * a.cw, a.s1 * a.cw, -a.sw],
            [-a.s1, a.c1, 0.0],
            [a.c1 * a.sw, a.s1 * a.sw, a.cw],
        ]
    )
    b1, b2, b3 = to_5 @ twist[:3]
    b4, b5, b6 = to_5 @ twist[3:]
    r1 = (b5 - j.a55 * b3) / (shoulder * (l2 + l3 + abs(l4)))
    r5 = b3 - j.a31 * r1
    r6 = (b1 - j.a11 * r1) / wrist
    c1, c2, c3 = b2 - j.a26 * r6, b4 - j.a41 * r1 - j.a45 * r5, b6 - j.a61 * r1
    d = elbow * l2 * l3
    r2 = (j.a43 * j.a64 * c1 + (j.a63 - j.a64) * c2 - j.a43 * c3) / d
    r3 = (-j.a42 * j.a64 * c1 + (j.a64 - j.a62) * c2 + j.a42 * c3) / d
    return np.array([r1, r2, r3, c1 - r2 - r3, r5, r6])


@pytest.mark.parametrize("floor", [1e-7, 0.5])
def test_rates_agree_with_the_reports_equations_also_below_the_floor(arm: aftdeck.Arm, floor: float) -> None:
    rng = np.random.default_rng(22)
    for q in [*legal(arm, 22, 300), *singular_poses(arm).values()]:
        twist = rng.normal(size=6)
        expected = by_the_report(arm, q, twist, floor)
        got = rmsrat(arm.model.links, sines(arm.model.links, *q), Twist(*twist), floor)
        assert np.array(got[:6]) == pytest.approx(expected, rel=1e-9, abs=1e-9 * np.abs(expected).max())


@pytest.mark.parametrize("kind", ["shoulder", "elbow", "wrist"])
def test_singular_pose_is_rejected_by_name(arm: aftdeck.Arm, kind: str) -> None:
    with pytest.raises(SingularityError, match=f"{kind} singularity") as caught:
        arm.joint_rates(singular_poses(arm)[kind], np.ones(6))
    assert caught.value.singularity == kind
    assert abs(caught.value.distance) < 1e-7


@pytest.mark.parametrize("kind", ["shoulder", "elbow", "wrist"])
def test_mask_marks_singular_rows_and_leaves_the_others_unchanged(arm: aftdeck.Arm, kind: str) -> None:
    q = np.stack([np.array(AWAY), singular_poses(arm)[kind]]).reshape(2, 1, 6)
    twist = np.array([0.01, -0.02, 0.03, 0.1, 0.2, -0.3])
    rates, mask = arm.joint_rates(q, twist, singular="mask")
    assert mask.shape == (2, 1) and mask.tolist() == [[False], [True]]
    assert np.isfinite(rates).all()
    assert (rates[0, 0] == np.asarray(arm.joint_rates(AWAY, twist))).all()


def test_single_twist_or_single_pose_broadcasts(arm: aftdeck.Arm) -> None:
    q, twist = np.array([AWAY, AWAY]), np.array([[0.0, 0, 0, 0.1, 0, 0], [0.1, 0, 0, 0, 0, 0]])
    assert np.asarray(arm.joint_rates(q, twist[0])).shape == (2, 6)
    assert (np.asarray(arm.joint_rates(AWAY, twist)) == np.asarray(arm.joint_rates(q, twist))).all()


@pytest.mark.parametrize("twist", [0.1, [0.1], [1.0, 2.0, 3.0], [[1.0], [2.0]]])
def test_twist_without_six_components_is_rejected(arm: aftdeck.Arm, twist: ArrayLike) -> None:
    with pytest.raises(InputError, match=r"twist: .*\(\.\.\., 6\)"):
        arm.joint_rates(AWAY, twist)


def test_mismatched_leading_dimensions_are_rejected(arm: aftdeck.Arm) -> None:
    with pytest.raises(InputError, match=r"\(2, 6\).*\(3, 6\)"):
        arm.joint_rates(np.array([AWAY] * 2), np.zeros((3, 6)))


def test_unknown_singular_option_is_rejected(arm: aftdeck.Arm) -> None:
    with pytest.raises(InputError, match=r"singular: .*'raise' or 'mask'.*'ignore'"):
        arm.joint_rates(AWAY, np.zeros(6), singular="ignore")  # type: ignore[arg-type]
