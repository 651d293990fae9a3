"""Forward kinematics and Jacobian against MuJoCo and Pinocchio, each with its own model of the arm."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from tests.kinematics.engines import Chain, Solver, in_mujoco, in_pinocchio
from tests.kinematics.poses import AXES, CENTRES, INCH, legal, structural, turned

MADE_UP = Path(__file__).parents[1] / "arms" / "made-up.toml"
X, Y, Z = AXES.T
SHUTTLE = Chain(
    np.array(
        [
            CENTRES[name]
            for name in (
                "shoulder_yaw", "shoulder_pitch", "elbow_pitch", "wrist_pitch", "wrist_yaw", "wrist_yaw", "tip",
            )
        ]
    )
    * INCH,
    np.array([Z, Y, Y, Y, Z, X]),
    AXES,
)  # fmt: skip
"""The Shuttle's arm in structural coordinates, built from the published joint centres."""
OTHER = Chain(
    np.array(
        [
            [0.0, 0.0, 0.0],
            [0.0, 0.0, -0.4],
            [3.0, 0.0, -0.65],
            [5.5, 0.0, -0.55],
            [5.8, 0.0, -0.55],
            [5.8, 0.0, -0.55],
            [6.6, 0.0, -0.55],
        ]
    ),
    np.array([[0, 0, 1], [0, 1, 0], [0, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 0]], dtype=np.float64),
    np.eye(3),
)
"""The arm of made-up.toml in L, built from the lengths in this file."""


def concept(height: float) -> Chain:
    """Return the concept arm in R with its shoulder at a height [m]; each boom is 25 ft long, the wrist 2 ft."""
    along = np.array([0.0, 0.0, 25.0, 50.0, 50.0, 50.0, 52.0]) * 12.0 * INCH
    down = np.array([0.0, *[-height] * 6])
    return Chain(np.stack([along, np.zeros(7), down], axis=1), np.eye(3)[[2, 1, 1, 2, 1, 0]], np.eye(3))


engines = pytest.mark.parametrize("engine", [in_mujoco, in_pinocchio])


@engines
def test_srms_agrees_with_a_model_built_from_its_joint_centres(
    arm: aftdeck.Arm, engine: Callable[[Chain], Solver]
) -> None:
    # seven printed centres; each of their three coordinates has an error of up to 0.0005 inches
    most = 7 * 3**0.5 * CENTRES["tolerance"] * INCH
    solve = engine(SHUTTLE)
    for q in legal(arm, 6, 300):
        ours, theirs = arm.forward(q), solve(q)
        assert np.linalg.norm(structural(ours.position) - theirs.position) < most
        assert np.abs(turned(AXES @ ours.rotation, theirs.rotation)).max() < 1e-12
        turn = np.kron(np.eye(2), AXES)
        assert np.abs(turn @ arm.jacobian(q) - theirs.jacobian).max() < most


@engines
def test_made_up_arm_agrees_with_a_model_built_from_its_lengths(engine: Callable[[Chain], Solver]) -> None:
    other = aftdeck.load_arm(MADE_UP)
    solve = engine(OTHER)
    for q in legal(other, 7, 300):
        ours, theirs = other.forward(q), solve(q)
        assert ours.position == pytest.approx(theirs.position, abs=1e-12)
        assert ours.rotation == pytest.approx(theirs.rotation, abs=1e-12)
        assert other.jacobian(q) == pytest.approx(theirs.jacobian, abs=1e-12)


@engines
@pytest.mark.parametrize("height", [3.6576, 5.0])
def test_concept_arm_agrees_with_a_model_built_from_its_lengths(
    height: float, engine: Callable[[Chain], Solver]
) -> None:
    ours = aftdeck.load_arm("concept-1972").at(stand=height)
    solve = engine(concept(height))
    for q in legal(ours, 8, 300):
        pose, theirs = ours.forward(q), solve(q)
        assert pose.position == pytest.approx(theirs.position, abs=1e-12)
        assert pose.rotation == pytest.approx(theirs.rotation, abs=1e-12)
        assert ours.jacobian(q) == pytest.approx(theirs.jacobian, abs=1e-12)
