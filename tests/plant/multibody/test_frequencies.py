"""Natural frequencies: the published ones, a beam's closed solution, and the flexibility of the tip summed by hand."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np
import pytest
import scipy.linalg
import scipy.optimize

from aftdeck.arms.dynamics import Flexibility
from aftdeck.arms.load import ArmModel, load_model
from aftdeck.arms.masses import masses_of
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties, joined
from aftdeck.frames import Pose
from aftdeck.plant.multibody.build import arm_spec
from aftdeck.plant.multibody.frequencies import frequencies, matrices
from aftdeck.plant.multibody.view import View
from aftdeck.plant.usual_payload import HEAVIEST, usual_payload
from aftdeck.simulation.run import Simulation
from aftdeck.units import POUND
from aftdeck.worksite.model import OrbiterMass
from tests.commands import Run
from tests.loaded import arm
from tests.plant.multibody.flights import AT_BAY
from tests.plant.multibody.points import cloud

STRAIGHT, FORWARD = np.zeros(6), np.array([math.pi, 0.0, 0.0, 0.0, 0.0, 0.0])
EMPTY = OrbiterMass(85e3, (1.02e6, 7.82e6, 8.16e6), (1097 * 0.0254, 0.0, 375 * 0.0254))
"""Empty orbiter, with the inertia of `orbiter.toml` in proportion to its mass."""
PITCH = 1
HEAVY = 45_000 * POUND
"""Mass of the heavy payload [kg], which the published table does not give (derived, `scripts/fit_springs.py`)."""


@pytest.fixture
def aftdeck(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Run:
    return Run(capsys, monkeypatch)


@pytest.fixture(scope="module")
def srms() -> ArmModel:
    return load_model("srms")


def test_straight_arm_has_the_published_frequencies(srms: ArmModel) -> None:
    heavy, empty = usual_payload(HEAVY, PITCH), EMPTY.in_l(srms.mount)
    errors = []
    for angles, payload, orbiter, published in (
        (STRAIGHT, None, None, (0.346, 0.461, 3.554, 4.228, 14.98, 15.14)),
        (FORWARD, None, empty, (0.355, 0.463, 3.557, 4.230, 15.00, 15.14)),
        (STRAIGHT, heavy, None, (0.0274, 0.0329, 0.0578, 0.1399, 0.4383, 2.976)),
        (FORWARD, heavy, empty, (0.0439, 0.0591, 0.0719, 0.1431, 0.4405, 3.499)),
    ):
        errors += (frequencies(srms, angles, payload=payload, orbiter=orbiter)[:6] / published - 1.0).tolist()
    assert math.sqrt(np.mean(np.square(errors))) < 0.035
    assert max(map(abs, errors)) < 0.12


def test_frequencies_agree_with_another_solver(srms: ArmModel) -> None:
    rng = np.random.default_rng(8)
    view = View(arm_spec(srms, flexible=True, orbiter=None).compile(), srms)
    for _ in range(5):
        angles = rng.uniform(-1.5, 1.5, 6)
        view.set_joints(angles, np.zeros(6), float(srms.links[0]))
        mujoco.mj_forward(view.model, view.data)
        mass, stiffness = matrices(view)
        squares = scipy.linalg.eigh(stiffness, mass, eigvals_only=True)
        assert frequencies(srms, angles) == pytest.approx(np.sqrt(squares) / (2.0 * math.pi), rel=1e-6)


def test_free_orbiter_of_great_mass_is_a_fixed_one(srms: ArmModel) -> None:
    heavy = OrbiterMass(1e12, (1e14, 1e14, 1e14), EMPTY.centre)
    free = frequencies(srms, FORWARD, orbiter=heavy.in_l(srms.mount))
    assert free == pytest.approx(frequencies(srms, FORWARD), rel=1e-4)


def test_tip_is_as_flexible_as_the_sum_of_all_springs(srms: ArmModel) -> None:
    """Straight arm; each spring moves the tip by its lever arm squared, and a beam by the integral along its length."""
    springs, steps = srms.flexibility, srms.linkage.steps
    assert springs is not None
    joints = np.cumsum(steps, axis=0)
    tip = joints[5] + [float(srms.links[4]), 0.0, 0.0]

    def compliance(force: Array) -> float:
        def of_spring(at: Array, axis: Array, stiffness: float) -> float:
            return float(np.cross(axis, tip - at) @ force) ** 2 / stiffness

        total = sum(of_spring(np.zeros(3), axis, k) for axis, k in zip(np.eye(3), springs.base, strict=True))
        for at, along, k in zip(joints, srms.linkage.axes, springs.gearboxes, strict=True):
            total += of_spring(at, along, k)
        for which, boom in enumerate((1, 2)):
            begin, end = joints[boom], joints[boom + 1]
            length = float(np.linalg.norm(end - begin))
            along = (end - begin) / length
            for axis in (np.array([0.0, 1.0, 0.0]), np.cross(along, [0.0, 1.0, 0.0])):
                places = [begin + s * along for s in np.linspace(0.0, length, 2001)]
                values = [of_spring(at, axis, float(springs.bending[which])) for at in places]
                total += float(np.trapezoid(values, dx=length / 2000))
            total += of_spring(begin, along, float(springs.torsion[which]) / length)
        return total

    view = View(arm_spec(srms, flexible=True, orbiter=None).compile(), srms)
    mujoco.mj_forward(view.model, view.data)
    _, stiffness = matrices(view)
    jacobian = np.zeros((3, view.model.nv))
    mujoco.mj_jacSite(view.model, view.data, jacobian, None, view.model.site("tip").id)
    free = np.setdiff1d(np.arange(view.model.nv), view.motor_rates)
    for force in (np.array([0.0, 0.0, 1.0]), np.array([0.0, 1.0, 0.0])):
        lever = force @ jacobian[:, free]
        found = float(lever @ np.linalg.solve(stiffness, lever))
        assert found == pytest.approx(compliance(force), rel=1e-6)


def test_boom_vibrates_as_a_beam_with_a_body_at_its_end(srms: ArmModel) -> None:
    """Euler-Bernoulli cantilever whose end carries the rest of the arm as a rigid body, in the pitch plane."""
    springs, masses = srms.flexibility, masses_of(srms)
    assert springs is not None
    stiff = 1e13
    rigid = Flexibility(
        np.full(6, stiff),
        np.array([springs.bending[0], stiff]),
        np.full(2, stiff),
        np.full(3, stiff),
        np.zeros(6),
        0.0,
    )
    boom = masses.booms[0]
    length, mass, rigidity = float(np.linalg.norm(boom.end)), boom.mass, float(springs.bending[0])
    joints = np.cumsum(srms.linkage.steps, axis=0)
    origins = dict(zip(srms.linkage.frames[1:], joints, strict=True))
    rest = [body.moved(origins[frame]) for frame, body in masses.bodies.items() if frame in srms.linkage.frames[3:]]
    lower = masses.booms[1]
    end = joints[2]
    rest += [lower.whole().moved(origins[lower.frame]), boom.tip.moved(end)]
    body = joined(rest)
    along = boom.end / length
    ahead = float((body.centre - end) @ along)
    aside = float((body.centre - end) @ np.cross([0.0, 1.0, 0.0], along))
    turning = float(body.inertia[1, 1]) + body.mass * aside**2

    def determinant(frequency: float) -> float:
        w2 = (2.0 * math.pi * frequency) ** 2
        k = (mass / length * w2 / rigidity) ** 0.25
        c, s, ch, sh = math.cos(k * length), math.sin(k * length), math.cosh(k * length), math.sinh(k * length)
        rows = []
        for w, d1, d2, d3 in (
            (c - ch, -s - sh, -c - ch, s - sh),
            (s - sh, c - ch, -s - sh, -c - ch),
        ):
            slope, bend, shear = k * d1, rigidity * k**2 * d2, rigidity * k**3 * d3
            moment = bend - w2 * ((turning + body.mass * ahead**2) * slope + body.mass * ahead * w)
            force = shear + w2 * body.mass * (w + ahead * slope)
            rows.append((moment, force))
        found: float = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]
        return found

    expected = scipy.optimize.brentq(determinant, 0.3, 1.5)
    found = frequencies(replace(srms, flexibility=rigid), STRAIGHT)[:2]  # pitch plane, yaw plane
    assert min(abs(found / expected - 1.0)) < 0.005


def test_command_prints_the_frequencies(srms: ArmModel, aftdeck: Run) -> None:
    given = ("--payload-mass", "65000 lb", "--payload-axis", "yaw")
    printed = aftdeck.json("arm", "srms", "frequencies", *given)["frequencies_hz"]
    assert printed == pytest.approx(frequencies(srms, STRAIGHT, payload=usual_payload(HEAVIEST, 2)))


def test_command_takes_the_payload_that_a_scenario_attaches_or_grasps(
    srms: ArmModel, aftdeck: Run, tmp_path: Path
) -> None:
    """The grasped payload is placed by the capture; its mass and its tensor are those of the file."""
    points = cloud(5)
    path = tmp_path / "attached.toml"
    path.write_text(f"title = 't'\n[initial]\njoints = {AT_BAY.tolist()}\n[payload]\n{points.toml()}")
    own = MassProperties(points.mass, points.centre, points.tensor(points.centre))
    printed = aftdeck.json("arm", "srms", "frequencies", "--payload", str(path))["frequencies_hz"]
    assert printed == pytest.approx(frequencies(srms, STRAIGHT, payload=own))

    sim = Simulation("srms-berth")
    held = sim.look().payload
    assert held is not None
    tip, pose = arm("srms").forward(sim.scenario.initial_angles), Pose(*map(np.array, held))
    cargo, turn = sim.scenario.payloads[0], tip.rotation.T @ pose.rotation
    grasped = MassProperties(cargo.mass, tip.rotation.T @ (pose.position - tip.position), turn @ cargo.inertia @ turn.T)
    printed = aftdeck.json("arm", "srms", "frequencies", "--payload", "srms-berth")["frequencies_hz"]
    assert printed == pytest.approx(frequencies(srms, STRAIGHT, payload=grasped))


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        (("concept-1972", "frequencies"), "flexibility"),
        (("srms", "frequencies", "--payload-mass", "heavy"), "--payload-mass"),
        (("srms", "frequencies", "--payload-mass", "-1 lb"), "--payload-mass"),
        (("srms", "frequencies", "--payload-mass", "1e-300"), "--payload-mass"),
        (("srms", "frequencies", "--payload-mass", "1e300"), "--payload-mass"),
        (("srms", "frequencies", "--free", "--orbiter-mass", "1 g"), "--orbiter-mass"),
        (("srms", "frequencies", "--orbiter-mass", "1000 kg"), "--free"),
        (("srms", "frequencies", "--payload-axis", "yaw"), "--payload-mass"),
        (("srms", "frequencies", "--payload", "srms-deploy"), "--payload"),
        (("srms", "frequencies", "--payload", "loaded", "--payload-mass", "1 kg"), "--payload-mass"),
        (("srms", "frequencies", "0", "0", "0", "0", "0", "inf"), "finite"),
        (("srms", "frequencies", "0", "0", "0", "0", "0"), "6 numbers"),
        (("srms", "limits", "--free"), "--free"),
    ],
)
def test_command_rejects_what_it_cannot_compute(arguments: tuple[str, ...], named: str, aftdeck: Run) -> None:
    code, _, error = aftdeck("arm", *arguments)
    assert code == 2
    assert named in error


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        (("900", "0", "0", "0", "0", "0", "--deg"), "shoulder_yaw"),
        (("0", "0", "0.1", "0", "0", "0"), "elbow_pitch"),
        (("--free", "--orbiter-mass", "1"), "--orbiter-mass"),
        (("--free", "--orbiter-mass", "1e6"), ""),
        (("--payload-mass", "70000 lb"), "--payload-mass"),
        (("--payload-mass", "65000 lb", "--free", "--orbiter-mass", "85000"), ""),
        (("180", "0", "0", "0", "0", "0", "--deg"), ""),
    ],
)
def test_command_cautions_of_strange_arguments(arguments: tuple[str, ...], named: str, aftdeck: Run) -> None:
    code, out, err = aftdeck("arm", "srms", "frequencies", *arguments, "--json")
    cautions = json.loads(out)["cautions"]
    assert code == 0
    assert len(cautions) == bool(named) and all(named in caution for caution in cautions)
    assert [line.removeprefix("caution: ") for line in err.splitlines()] == cautions
