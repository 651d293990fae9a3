"""Bends of base and booms: with them, the laws place a bent arm where MuJoCo's bodies are."""

from __future__ import annotations

import msgspec
import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from aftdeck.arms.flexures import flexures_of
from aftdeck.arms.load import load_model
from aftdeck.arrays import Array
from aftdeck.bodies.pose import HERE
from aftdeck.kinematics.bending import BEND, bend_frames, motion_of
from aftdeck.kinematics.frames import frames_of, place_frames
from aftdeck.plant.multibody.build import arm_spec
from aftdeck.plant.multibody.view import View
from aftdeck.scene.everything import ScenePoses
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation
from tests import loaded
from tests.plant.multibody.flights import ideal, move, scenario


@pytest.mark.parametrize("name", ["srms", str(loaded.CHAINS / "seven.toml")])
def test_laws_place_a_bent_arm_where_its_bodies_are(name: str) -> None:
    model, rng = load_model(name), np.random.default_rng(3)
    view, frames = View(arm_spec(model, flexible=True, orbiter=None).compile(), model), frames_of(model)
    parts = flexures_of(model)
    carriers, ends = np.array([part.frame for part in parts]), np.array([part.end for part in parts])
    for _ in range(20):
        view.qpos[:] = rng.uniform(-0.1, 0.1, len(view.qpos))
        view.qpos[view.motors] = rng.uniform(-2.0, 2.0, len(view.motors))
        mujoco.mj_kinematics(view.model, view.data)
        found, bends, base = np.empty((view.rows, 12)), np.empty((view.flexures, BEND)), np.array(HERE)
        view.write_poses(found, bends, base)
        placed = frames.rows()
        angles = view.qpos[view.motors] + view.qpos[view.gearboxes]
        place_frames(frames.joints, angles, float(model.links[0]), 0.0, placed)
        assert np.abs(placed - found).max() > 0.1
        bend_frames(carriers, ends, bends, placed, -1)
        assert placed == pytest.approx(found, abs=1e-12)


def test_rotation_vectors_are_those_of_scipy() -> None:
    rng, motion = np.random.default_rng(4), np.empty(12)
    for _ in range(50):
        bend, end = rng.normal(size=BEND), rng.normal(size=3)
        motion_of(bend, end, motion)
        turn = Rotation.from_rotvec(bend[3:]).as_matrix()
        assert motion[3:].reshape(3, 3) == pytest.approx(turn, abs=1e-12)
        assert motion[:3] + turn @ end == pytest.approx(end + bend[:3], abs=1e-12)


def test_boom_pressed_at_its_end_bends_like_a_cantilever() -> None:
    # Euler-Bernoulli: force F at the end gives the deflection F L^3 / 3EI and the slope F L^2 / 2EI.
    model = load_model("srms")
    view, (_, upper, _) = View(arm_spec(model, flexible=True, orbiter=None).compile(), model), flexures_of(model)
    length, slope = float(np.linalg.norm(upper.end)), 1e-3
    for hinge, share in (("upper_boom.1.pitch", 0.7886751), ("upper_boom.2.pitch", 0.2113249)):
        # a hinge's moment is F times the rest of the boom; its stiffness is 2 EI / L
        view.data.joint(hinge).qpos[0] = share * slope
    mujoco.mj_kinematics(view.model, view.data)
    bends, base = np.empty((view.flexures, BEND)), np.array(HERE)
    view.write_poses(np.empty((view.rows, 12)), bends, base)
    displacement, turn = np.linalg.norm(bends[1, :3]), np.linalg.norm(bends[1, 3:])
    assert turn == pytest.approx(slope, rel=1e-6)
    assert displacement == pytest.approx(2.0 / 3.0 * length * turn, rel=1e-4)


def test_frame_s_bends_lead_to_the_true_tip() -> None:
    given = ideal(scenario("flexible", move((1.0, 0.0, 0.5)), pounds=32000.0), gain=1.0)  # its encoders are exact
    sim, poses = Simulation(given), ScenePoses(given)
    for _ in range(500):
        sim.advance()
    frame = sim.look()
    assert frame.dynamics is not None
    assert [bend.part for bend in frame.dynamics.bends] == ["base", "upper_boom", "lower_boom"]
    link = float(loaded.arm().model.links[4])  # distance of the tip from the wrist yaw joint [m]
    tip = np.array(frame.dynamics.position) - link * np.array(frame.dynamics.orientation)[:, 0]
    assert hand_of(poses, frame) == pytest.approx(poses.point(tuple(tip.tolist())), abs=1e-9)
    straight = msgspec.structs.replace(frame, dynamics=msgspec.structs.replace(frame.dynamics, bends=()))
    assert np.linalg.norm(hand_of(poses, straight) - hand_of(poses, frame)) > 1e-3


def hand_of(poses: ScenePoses, frame: Frame) -> Array:
    """Return the place of the last joint's frame in the scene [m]; nothing else is in the scene."""
    return np.array(poses.at(frame)).reshape(-1, 7)[6, :3]
