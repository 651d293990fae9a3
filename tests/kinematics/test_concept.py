"""The concept arm of 1972: rotations and mission of the report, telescope, branches, singularities."""

from __future__ import annotations

import math
from functools import reduce
from itertools import pairwise

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.errors import InputError, SingularityError, UnreachableError
from aftdeck.frames import Pose
from tests.kinematics.poses import apart, legal

FOOT = 0.3048
USUAL = np.radians([20.0, 60.0, -90.0, 10.0, -40.0, 15.0])


@pytest.fixture(scope="module")
def concept() -> aftdeck.Arm:
    return aftdeck.load_arm("concept-1972")


def by_the_report(q: Array) -> Array:
    """Return R(-HO) R(-PO) R(-P1) R(-H2) R(-P2) R(-R2), each as printed in the report, with headings about Z."""

    def heading(x: float) -> Array:
        return np.array([[math.cos(x), -math.sin(x), 0], [math.sin(x), math.cos(x), 0], [0, 0, 1]])

    def pitch(x: float) -> Array:
        return np.array([[math.cos(x), 0, math.sin(x)], [0, 1, 0], [-math.sin(x), 0, math.cos(x)]])

    def roll(x: float) -> Array:
        return np.array([[1, 0, 0], [0, math.cos(x), -math.sin(x)], [0, math.sin(x), math.cos(x)]])

    turns = (heading, pitch, pitch, heading, pitch, roll)
    return reduce(np.matmul, [turn(float(x)) for turn, x in zip(turns, q, strict=True)])


def test_orientation_equals_the_product_of_the_reports_rotations(concept: aftdeck.Arm) -> None:
    for q in legal(concept, 50, 200):
        assert concept.forward(q).rotation == pytest.approx(by_the_report(q), abs=1e-14)


def test_arm_is_stretched_aft_at_telescope_height_at_zero_angles(concept: aftdeck.Arm) -> None:
    pose = concept.forward(np.zeros(6))
    assert pose.position / FOOT == pytest.approx([25 + 25 + 2, 0, -12])
    assert pose.rotation == pytest.approx(np.eye(3))


@pytest.mark.parametrize(
    ("joint", "axis", "sign"),
    [(0, 1, 1), (1, 2, -1), (2, 2, -1), (3, 1, 1), (4, 2, -1)],
    ids=["heading to port", "pitch up", "pitch up", "heading to port", "pitch up"],
)
def test_headings_move_the_stretched_arm_to_port_and_pitches_lift_it(
    concept: aftdeck.Arm, joint: int, axis: int, sign: int
) -> None:
    q = np.zeros(6)
    q[joint] = 0.1
    moved = concept.forward(q).position - concept.forward(np.zeros(6)).position
    assert sign * moved[axis] > 0.0


def test_roll_turns_the_port_side_of_the_end_effector_down(concept: aftdeck.Arm) -> None:
    assert concept.forward([0, 0, 0, 0, 0, 0.1]).rotation[2, 1] > 0.0


def test_end_effector_axes_are_those_of_system_2(concept: aftdeck.Arm) -> None:
    rotation = concept.forward(USUAL).rotation
    assert (concept.end_effector(rotation) == rotation).all()


def test_longer_telescope_lifts_the_arm_and_changes_nothing_else(concept: aftdeck.Arm) -> None:
    tall = concept.at(stand=16 * FOOT)
    assert tall.stand == 16 * FOOT and concept.stand == pytest.approx(12 * FOOT)
    q = legal(concept, 51, 100)
    low, high = concept.forward(q), tall.forward(q)
    assert high.position - low.position == pytest.approx(np.tile([0.0, 0.0, -4 * FOOT], (100, 1)), abs=1e-14)
    assert (high.rotation == low.rotation).all()
    assert (tall.jacobian(q) == concept.jacobian(q)).all()
    assert tall.inverse(tall.forward(USUAL), near=USUAL)[0] == pytest.approx(USUAL, abs=1e-9)


def test_telescope_length_outside_its_limits_is_rejected(concept: aftdeck.Arm) -> None:
    for length in (9.5 * FOOT, 18 * FOOT):
        assert concept.at(stand=length).stand == length
    for length in (9.4 * FOOT, 18.1 * FOOT):
        with pytest.raises(InputError, match=r"concept-1972 .*2\.8956 to 5\.4864 m"):
            concept.at(stand=length)
    for given in (math.nan, [4.0, 5.0]):
        with pytest.raises(InputError, match="stand: "):
            concept.at(stand=given)  # type: ignore[arg-type]


def test_arm_without_a_telescope_rejects_a_telescope_length() -> None:
    srms = aftdeck.load_arm("srms")
    assert srms.stand is None
    with pytest.raises(InputError, match=r"srms .*telescope"):
        srms.at(stand=4.0)


# --- inverse ----------------------------------------------------------------------------------------------


def test_pose_inside_reach_has_two_shoulders_elbows_and_wrists(concept: aftdeck.Arm) -> None:
    found = concept.inverse(concept.forward(USUAL), limits=False)
    assert len(found) == 8
    turned = np.abs(apart(found[:, 0], USUAL[0])) > 1.0
    up = found[:, 2] < 0.0
    flipped = np.cos(found[:, 4]) < 0.0
    assert len(set(zip(turned, up, flipped, strict=True))) == 8
    assert np.abs(found[:, 2]) == pytest.approx(np.full(8, math.radians(90)))
    # for each shoulder and elbow, flipping the wrist adds 180 deg to heading and roll; pitch p becomes 180 deg - p
    for one in found[~flipped]:
        other = np.array([*one[:3], one[3] + math.pi, math.pi - one[4], one[5] + math.pi])
        assert min(np.abs(apart(row, other)).max() for row in found[flipped]) < 1e-9


def test_stretched_arm_is_within_reach_and_its_elbows_coincide(concept: aftdeck.Arm) -> None:
    found = concept.inverse(concept.forward([0.3, 0.5, 0.0, 0.2, -0.4, 0.1]), limits=False)
    assert np.abs(found[:, 2]).max() < 1e-7


def test_limits_exclude_exactly_the_solutions_outside_the_hard_stops(concept: aftdeck.Arm) -> None:
    low, high = concept.limits.hard.T
    counts = set()
    for q in legal(concept, 52, 300):
        if np.abs(np.stack(concept.singularities(q))).min() < 1e-3 or np.abs(q[:5]).max() > math.pi - 1e-6:
            continue
        pose = concept.forward(q)
        held = concept.inverse(pose, near=q)
        turns = concept.inverse(pose, limits=False)[:, None, :] + math.tau * np.array([-1, 0, 1])[:, None]
        inside = ((turns >= low - 1e-9) & (turns <= high + 1e-9)).any(axis=1).all(axis=1)
        assert len(held) == inside.sum()
        counts.add(len(held))
    assert {1, 2} <= counts


@pytest.mark.parametrize("beyond", [1e-3, 0.25, 20.0])
def test_pose_out_of_reach_is_rejected_with_its_excess(concept: aftdeck.Arm, beyond: float) -> None:
    pose = concept.forward([0.4, 0.7, 0.0, -0.1, 0.15, 0.3])
    along = by_the_report(np.array([0.4, 0.7, 0, 0, 0, 0]))[:, 0]
    with pytest.raises(UnreachableError) as caught:
        concept.inverse(Pose(pose.position + beyond * along, pose.rotation))
    assert caught.value.excess == pytest.approx(beyond, abs=1e-9)


def test_every_branch_near_the_wrist_singularity_maps_back(concept: aftdeck.Arm) -> None:
    for off in (1e-3, 1e-5, 1e-7, 1e-8):
        for sign in (1.0, -1.0):
            q = np.array([0.2, 1.0, -1.0, 0.3, sign * (math.pi / 2 - off), 0.2])
            pose = concept.forward(q)
            for row in concept.inverse(pose, near=q, limits=False):
                back = concept.forward(row)
                assert back.position == pytest.approx(pose.position, abs=1e-12)
                assert back.rotation == pytest.approx(pose.rotation, abs=1e-12)


# --- singularities ----------------------------------------------------------------------------------------

SINGULAR = {
    "shoulder": np.radians([20.0, 110.0, -40.0, 10.0, -40.0, 15.0]),  # equal booms: the wrist is over the axis
    "elbow": np.radians([20.0, 60.0, 0.0, 10.0, -40.0, 15.0]),
    "wrist": np.radians([20.0, 60.0, -90.0, 10.0, 90.0, 15.0]),
    "wrist, down": np.radians([20.0, 60.0, -90.0, 10.0, -90.0, 15.0]),
}


@pytest.mark.parametrize("name", SINGULAR)
def test_distance_is_zero_only_at_its_own_singularity(concept: aftdeck.Arm, name: str) -> None:
    found = concept.singularities(SINGULAR[name])._asdict()
    assert abs(float(found.pop(name.partition(",")[0]))) < 1e-15
    assert min(abs(float(d)) for d in found.values()) > 0.1


def test_product_of_distances_is_proportional_to_the_determinant(concept: aftdeck.Arm) -> None:
    q = legal(concept, 53, 5000)
    boom = 25 * FOOT
    product = np.prod(np.stack(concept.singularities(q)), axis=0) * boom * boom * (boom + boom)
    determinant = np.linalg.det(concept.jacobian(q))
    assert np.abs(determinant) == pytest.approx(np.abs(product), abs=1e-9)
    sign = np.sign(determinant * product)[np.abs(product) > 1e-6]
    assert abs(sign.sum()) == len(sign)


@pytest.mark.parametrize("name", SINGULAR)
def test_singular_pose_raises_or_gives_finite_rates_under_mask(concept: aftdeck.Arm, name: str) -> None:
    kind = name.partition(",")[0]
    with pytest.raises(SingularityError, match=f"{kind} singularity") as caught:
        concept.joint_rates(SINGULAR[name], np.ones(6))
    assert caught.value.singularity == kind
    rates, mask = concept.joint_rates([SINGULAR[name], USUAL], np.ones(6), singular="mask")
    assert mask.tolist() == [True, False] and np.isfinite(rates).all()


def test_wrist_over_the_heading_axis_raises_the_shoulder_singularity(concept: aftdeck.Arm) -> None:
    with pytest.raises(SingularityError, match="shoulder heading axis: shoulder singularity") as caught:
        concept.inverse(concept.forward(SINGULAR["shoulder"]))
    assert caught.value.singularity == "shoulder"


def test_singular_wrist_is_rejected_only_among_returned_solutions(
    concept: aftdeck.Arm,
) -> None:
    # in the elbow-down branch of this pose, the end effector is perpendicular to the lower arm
    q = np.radians([20.0, 60.0, -60.0, 0.0, -30.0, 0.0])
    pose = concept.forward(q)
    assert concept.inverse(pose) == pytest.approx(q[None, :], abs=1e-9)
    with pytest.raises(SingularityError, match=r"wrist pitch .*\+-90 deg") as caught:
        concept.inverse(pose, limits=False)
    assert caught.value.singularity == "wrist"


# --- the mission ------------------------------------------------------------------------------------------

BAR = np.array([28.0, 0.0, 0.74])
"""Centre of the bar's upper side, with the payload in the bay [ft]. The payload is a prism, 11.26 ft across flats.
Its centre is at a depth of 7.12 ft, and its bar is 0.75 ft high."""
DOCKED = np.array([-4.0 + 16.0, 16.0, -22.0 - (7.12 - 0.74)])
"""Centre of the bar's upper side, with the payload docked [ft]. The forward face of the probe, 16 ft from the centre of
the payload, is in the port at (-4, 16, -22)."""
DOWN = by_the_report(np.radians([0, 0, 0, 0, -90, 0]))
"""Orientation of the end effector that points straight down, with a finger on each side of a bar along the bay."""
PATH: list[Array] = [
    BAR - [0, 0, 4.0],
    BAR - [0, 0, 0.03],
    np.array([BAR[0], BAR[1], DOCKED[2]]),
    np.array([26.0, 0.0, DOCKED[2]]),
    np.array([26.0, 16.0, DOCKED[2]]),
    DOCKED,
]
"""Tip positions [ft]: acquire, extract and lift, move forward, move sideways, dock."""


def path_angles(arm: aftdeck.Arm) -> Array:
    """Return angles (n, 6) [rad] along the path with a level payload, each nearest to the previous solution."""
    legs = [np.linspace(a, b, 50) for a, b in pairwise(PATH)]
    near, found = np.radians([0.0, 40.0, -100.0, 0.0, -30.0, 0.0]), []
    for place in np.concatenate(legs):
        near = arm.inverse(Pose(place * FOOT, DOWN), near=near)[0]
        found.append(near)
    return np.array(found)


@pytest.mark.parametrize("height", [9.5, 12.0, 16.0, 18.0])
def test_mission_stays_within_the_limits_on_one_branch_at_each_height(concept: aftdeck.Arm, height: float) -> None:
    arm = concept.at(stand=height * FOOT)
    q = path_angles(arm)
    low, high = arm.limits.soft.T
    assert (q >= low).all() and (q <= high).all()
    assert np.degrees(np.abs(np.diff(q, axis=0)).max()) < 5.0
    assert (q[:, 2] < 0.0).all() and (np.cos(q[:, 4]) > 0.0).all()
    assert np.abs(np.stack(arm.singularities(q))).min() > 0.1


def test_mission_at_16_ft_has_the_known_angle_ranges(concept: aftdeck.Arm) -> None:
    q = np.degrees(path_angles(concept.at(stand=16 * FOOT)))
    expected = [(0, 53), (23, 96), (-121, -95), (0, 0), (-68, -11), (-53, 0)]
    assert np.stack([q.min(axis=0), q.max(axis=0)], axis=1) == pytest.approx(np.array(expected), abs=1.0)
