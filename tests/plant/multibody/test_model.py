"""Model of the arm in MuJoCo: its kinematics are those of the laws, its masses those of the file."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import msgspec
import mujoco
import numpy as np
import pinocchio
import pytest

from aftdeck.arms.load import ArmModel, load_model
from aftdeck.arms.masses import masses_of
from aftdeck.arms.switched import switched_of
from aftdeck.arrays import Array
from aftdeck.errors import ArmError
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.bending import BEND
from aftdeck.kinematics.frames import frames_of, place_frames
from aftdeck.plant.multibody.build import arm_spec
from aftdeck.plant.multibody.view import View

ARMS = [("srms", False), ("srms", True), ("concept-1972", False)]


def view_of(model: ArmModel, *, flexible: bool = False) -> View:
    return View(arm_spec(model, flexible=flexible, orbiter=None).compile(), model)


def place(view: View, angles: Array, height: float) -> None:
    view.set_joints(angles, np.zeros(6), height)
    mujoco.mj_forward(view.model, view.data)


@pytest.mark.parametrize(("name", "flexible"), ARMS)
def test_unbent_arm_is_where_the_laws_place_it(name: str, flexible: bool) -> None:
    model, rng = load_model(name), np.random.default_rng(2)
    view, frames = view_of(model, flexible=flexible), frames_of(model)
    for _ in range(20):
        angles, stand = rng.uniform(-2.0, 2.0, 6), float(model.links[0])
        if model.telescope is not None:
            stand = rng.uniform(model.telescope.least, model.telescope.greatest)
        place(view, angles, stand)
        expected, found, base = frames.rows(), np.empty((view.rows, 12)), np.zeros(12)
        base[[3, 7, 11]] = 1.0
        place_frames(frames.joints, angles, stand, 0.0, expected)
        bends = np.empty((view.flexures, BEND))
        view.write_poses(found, bends, base)
        assert bends == pytest.approx(0.0, abs=1e-12)
        assert found == pytest.approx(expected, abs=1e-12)
        tip = Arm(model.at(stand) if model.telescope else model).forward(angles)
        assert view.data.site("tip").xpos == pytest.approx(tip.position, abs=1e-12)
        assert view.data.site("tip").xmat == pytest.approx(tip.rotation.ravel(), abs=1e-12)
        assert view.height == pytest.approx(stand, abs=1e-12)


def test_bodies_of_the_shuttle_s_arm_have_its_published_mass() -> None:
    masses = masses_of(load_model("srms"))
    total = sum(body.mass for body in masses.bodies.values())
    total += sum(boom.mass + boom.tip.mass for boom in masses.booms)
    assert total == pytest.approx(421.76, abs=1e-9)
    rigid, flexible = (
        view_of(load_model("srms"), flexible=flexible).model.body_mass.sum() for flexible in (False, True)
    )
    assert rigid == pytest.approx(total, abs=1e-9)
    assert flexible == pytest.approx(total, abs=0.02)  # bodies between two joints have 1 g each


def test_mass_matrix_and_inverse_dynamics_agree_with_pinocchio() -> None:
    model, rng = load_model("srms"), np.random.default_rng(4)
    view, (other, armature) = view_of(model), of_pinocchio(model)
    data = other.createData()
    for _ in range(20):
        angles, rates, accelerations = rng.uniform(-2, 2, 6), rng.normal(size=6), rng.normal(size=6)
        view.set_joints(angles, rates, float(model.links[0]))
        view.data.qacc[:] = accelerations
        mujoco.mj_inverse(view.model, view.data)
        friction = view.data.qfrc_constraint
        mass = np.zeros((6, 6))
        mujoco.mj_fullM(view.model, view.data, mass)
        assert mass == pytest.approx(pinocchio.crba(other, data, angles) + np.diag(armature), rel=1e-9, abs=1e-6)
        torques = pinocchio.rnea(other, data, angles, rates, accelerations) + armature * accelerations
        assert view.data.qfrc_inverse + friction == pytest.approx(torques, rel=1e-9, abs=1e-6)


def of_pinocchio(model: ArmModel) -> tuple[Any, Array]:
    """Return the rigid arm for Pinocchio, joint by joint from the numbers of the file, and the motors' inertias."""
    masses, linkage = masses_of(model), model.linkage
    made = pinocchio.Model()
    made.gravity = pinocchio.Motion.Zero()
    joint = 0
    for i, frame in enumerate(linkage.frames[1:]):
        placed = pinocchio.SE3(np.eye(3), np.array(linkage.steps[i]))
        joint = made.addJoint(joint, pinocchio.JointModelRevoluteUnaligned(linkage.axes[i]), placed, model.joints[i])
        parts = [masses.bodies[frame]] if frame in masses.bodies else []
        parts += [boom.whole() for boom in masses.booms if boom.frame == frame]
        for body in parts:
            made.appendBodyToJoint(
                joint, pinocchio.Inertia(body.mass, body.centre, body.inertia), pinocchio.SE3.Identity()
            )
    servo = model.servo
    assert servo is not None
    return made, servo.armature


@pytest.mark.parametrize(("table", "flexible"), [("flexibility", True), ("servo", False)])
def test_arm_without_the_numbers_of_a_plant_says_which_table_is_missing(table: str, flexible: bool) -> None:
    without: dict[str, Any] = {table: None}
    with pytest.raises(ArmError, match=table):
        arm_spec(replace(load_model("srms"), **without), flexible=flexible, orbiter=None)


@pytest.mark.parametrize(
    ("name", "joint", "without"),
    [
        ("srms", "shoulder_yaw", {"link": None}),
        ("srms", "elbow_pitch", {"link": None}),
        ("srms", "wrist_roll", {"link": None}),
        ("concept-1972", "shoulder_pitch", {"link": None}),
        ("concept-1972", "stand", {"gain": None}),
        ("concept-1972", "prong", {"force": None}),
    ],
)
def test_joint_without_mass_or_drive_is_named_for_a_plant_with_masses(
    name: str, joint: str, without: dict[str, Any]
) -> None:
    """What joins two joints with the same centre needs no mass, such as the parts of a wrist whose axes meet."""
    model = load_model(name)
    joints = [msgspec.structs.replace(j, **(without if j.name == joint else {})) for j in model.source.joint]
    source: Any = msgspec.structs.replace(model.source, joint=tuple(joints))
    with pytest.raises(ArmError, match=f"for {joint}$"):
        arm_spec(replace(model, source=source, switched=switched_of(source)), flexible=False, orbiter=None)


@pytest.mark.parametrize("part", ["telescope", "prong", "palm"])
def test_block_without_mass_is_missing(part: str) -> None:
    model = load_model("concept-1972")
    bodies = [body for body in model.source.bodies if body.part not in (part, "stub", "fixed finger")]
    lacking = replace(model, source=msgspec.structs.replace(model.source, bodies=tuple(bodies)))
    with pytest.raises(ArmError, match=r"for (stand|prong|wrist_roll)$"):
        arm_spec(lacking, flexible=False, orbiter=None)


def test_only_the_shuttle_s_arm_is_flexible() -> None:
    with pytest.raises(ArmError, match="flexibility"):
        arm_spec(load_model("concept-1972"), flexible=True, orbiter=None)
