"""Linear models: answers of the nonlinear plant to small inputs, modes, and closed answers."""

from __future__ import annotations

import math
from typing import Any, Literal, get_args

import numpy as np
import pytest

import aftdeck
from aftdeck.analysis.linear_model import LinearModel
from aftdeck.analysis.linearise import Engaged
from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.plant.multibody.build import BRAKE_STIFFNESS
from aftdeck.plant.multibody.frequencies import frequencies
from aftdeck.plant.usual_payload import usual_payload
from benchmarks.plant_answers import PlantAnswers, scenario_of
from tests.analysis.cases import KINDS, random_angles
from tests.each import each, seeds

GROUPS = ["angle.", "rate.", "tip.", "tip.r", "torque."]
BENT = np.array([0.3, 1.0, -1.5, 0.4, 0.2, 0.1])
HEAVY = usual_payload(14_515.0, 1)
SIZES = {"force": 1e-2, "moment": 1e-2, "rate": 1e-5, "hold": 1e-5}
"""Sizes of small inputs [N, N m, rad/s, rad]."""


def close(found: Array, expected: Array, model: LinearModel) -> None:
    """Check that answers differ by less than 1 % of the greatest of the same output, and 0.1 % of the same group."""
    for group in GROUPS:
        columns = [
            i for i, name in enumerate(model.outputs)
            if name.startswith(group) and not (group == "tip." and name.startswith("tip.r"))
        ]  # fmt: skip
        greatest = np.abs(expected[:, columns]).max(axis=0)
        assert greatest.max() > 0.0
        apart = np.abs(found[:, columns] - expected[:, columns]).max(axis=0)
        assert (apart <= 0.01 * greatest + 1e-3 * greatest.max()).all(), (group, apart / greatest)


def random_inputs(model: LinearModel, steps: int, rng: np.random.Generator) -> Array:
    """Return inputs (k, m) that jump to other values from time to time; the first jumps at once."""
    size = np.array([SIZES[name.split(".")[0]] for name in model.inputs])
    inputs = np.empty((steps, len(size)))
    for k in range(steps):
        jumps = rng.random(len(size)) < 0.04 if k else np.ones(len(size), dtype=bool)
        inputs[k] = np.where(jumps, size * rng.normal(size=len(size)), inputs[k - 1])
    return inputs


@pytest.mark.slow
@pytest.mark.parametrize(("name", "flexible"), KINDS)
@pytest.mark.parametrize("engaged", get_args(Engaged))
@each("seed", seeds(3, 60))
def test_plant_answers_small_inputs_as_its_linear_model(name: str, flexible: bool, engaged: Engaged, seed: int) -> None:
    rng = np.random.default_rng(seed)
    payload = [None, usual_payload(float(rng.uniform(200.0, 29e3)), 2).moved(rng.uniform(-1.0, 2.0, 3))][seed % 2]
    orbiter: Literal["free", "fixed"] = "free" if name == "srms" and rng.random() < 0.5 else "fixed"
    period = float(rng.choice([0.005, 0.02, 0.08]))
    found = aftdeck.dynamics(name, payload=payload, orbiter=orbiter, flexible=flexible)
    angles = random_angles(found, rng)
    model = found.linear(angles, engaged, period=period)
    given = scenario_of(name, angles, payload, flexible=flexible, orbiter=orbiter, period=period)
    inputs = random_inputs(model, round(5.0 / period), rng)
    if engaged == "brakes":
        inputs *= 0.05  # their friction damps by the share of its greatest torque that acts
    close(model.response(inputs), PlantAnswers(given).to(inputs, engaged), model)


@pytest.mark.parametrize("period", [0.02, 0.08])
def test_servos_of_single_follow_as_the_model_with_rates_and_angles(period: float) -> None:
    """SINGLE and MASTER command rates, and the plant itself moves the angles to hold along."""
    rng = np.random.default_rng(4)
    model = aftdeck.dynamics("srms", payload=HEAVY, flexible=True).linear(BENT, "hold", period=period)
    inputs = np.zeros((round(6.0 / period), len(model.inputs)))
    inputs[:, 6:12] = 1e-6 * rng.normal(size=6)
    inputs[:, 12:] = period * np.vstack([np.zeros(6), np.cumsum(inputs[:-1, 6:12], axis=0)])
    given = scenario_of("srms", BENT, HEAVY, flexible=True, period=period)
    close(model.response(inputs), PlantAnswers(given).to(inputs, "hold", follow=True), model)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "flexible", "payload", "engaged"),
    [
        ("srms", False, None, "servos"),
        ("srms", True, None, "servos"),
        ("srms", True, HEAVY, "hold"),
        ("concept-1972", False, HEAVY, "servos"),
    ],
)
@each("seed", seeds(2, 12))
def test_bode_is_what_the_plant_answers_to_a_sine(
    name: str, flexible: bool, payload: Any, engaged: Engaged, seed: int
) -> None:
    """The answer without its transient: the part of the last periods at the frequency of the sine."""
    rng = np.random.default_rng(seed)
    found, angles = aftdeck.dynamics(name, payload=payload, flexible=flexible), 0.5 * BENT
    model, joint = found.linear(angles, engaged), str(rng.choice(found.arm.joints))
    decays = -model.poles().s.real
    seconds = max(4.0, 10.0 / float(decays[decays > 1e-6].min()))  # until what begins with the sine has decayed
    steps, period = round(0.5 * seconds / model.period), model.period
    frequency = float(rng.integers(3, 20)) / (steps * period)
    kind = "rate" if engaged == "servos" else "hold"
    inputs = np.zeros((3 * steps, len(model.inputs)))
    wave = np.exp(2j * math.pi * frequency * period * np.arange(3 * steps))
    inputs[:, model.inputs.index(f"{kind}.{joint}")] = 1e-5 * wave.imag
    given = scenario_of(name, angles, payload, flexible=flexible)
    answers = PlantAnswers(given).to(inputs, engaged)[-steps:]
    for measured in (f"angle.{joint}", f"rate.{joint}", f"torque.{joint}"):
        bode = model.bode(f"{kind}.{joint}", measured, [frequency])
        output = answers[:, model.outputs.index(measured)]
        if measured.startswith("angle.") and engaged == "servos":  # it drifts by the sine's beginning
            output = output - output.mean()
        seen = 2j * (output * wave[-steps:].conj()).mean() / 1e-5
        assert seen == pytest.approx(bode.gain[0] * np.exp(1j * bode.phase[0]), rel=0.01)


@pytest.mark.parametrize(("engaged", "kind", "measured"), [("servos", "rate", "rate"), ("hold", "hold", "angle")])
@pytest.mark.parametrize(("name", "flexible"), KINDS)
def test_slow_commands_are_followed_exactly(
    name: str, flexible: bool, engaged: Engaged, kind: str, measured: str
) -> None:
    found = aftdeck.dynamics(name, flexible=flexible)
    model = found.linear(BENT, engaged)
    for joint in found.arm.joints:
        slow = model.bode(f"{kind}.{joint}", f"{measured}.{joint}", [1e-5])
        assert slow.gain[0] == pytest.approx(1.0, abs=1e-4)
        assert slow.phase[0] == pytest.approx(0.0, abs=1e-3)


def test_steady_force_bends_the_braked_arm_by_its_springs() -> None:
    found = aftdeck.dynamics("srms", payload=HEAVY, flexible=True)
    model = found.linear(BENT, "brakes")
    springs = np.diag(found.stiffness).copy()
    springs[springs == 0.0] = BRAKE_STIFFNESS
    jacobian = found.tip_jacobian(BENT)
    expected = jacobian @ (jacobian / springs).T  # the joints' springs are in series
    inputs = ("force.x", "force.y", "force.z", "moment.x", "moment.y", "moment.z")
    outputs = ("tip.x", "tip.y", "tip.z", "tip.rx", "tip.ry", "tip.rz")
    for column, given in enumerate(inputs):
        for row, measured in enumerate(outputs):
            slow = model.bode(given, measured, [1e-4])
            answer = slow.gain[0] * math.cos(slow.phase[0])
            scale = math.sqrt(expected[row, row] * expected[column, column])
            assert answer == pytest.approx(expected[row, column], abs=1e-3 * scale)


@pytest.mark.parametrize("payload", [None, HEAVY])
@pytest.mark.parametrize("orbiter", ["fixed", "free"])
def test_modes_solve_the_equations_of_the_braked_arm(payload: Any, orbiter: Any) -> None:
    found = aftdeck.dynamics("srms", payload=payload, orbiter=orbiter, flexible=True)
    modes, mass = found.modes(BENT), found.mass_matrix(BENT)
    free = [k for k, name in enumerate(found.coordinates) if not name.startswith("motor.")]
    squares = (2.0 * math.pi * modes.frequencies) ** 2
    low = squares < 1e4
    for shape, square in zip(modes.shapes[low], squares[low], strict=True):
        residual = (found.stiffness - square * mass) @ shape
        assert residual[free] == pytest.approx(0.0 * residual[free], abs=1e-6 * np.abs(found.stiffness @ shape).max())
    assert modes.shapes @ mass @ modes.shapes.T == pytest.approx(np.eye(len(squares)), abs=1e-6)
    assert (modes.shapes[:, [k for k in range(len(mass)) if k not in free]] == 0.0).all()
    relative = found.tip_jacobian(BENT).copy()
    relative[:, [k for k, name in enumerate(found.coordinates) if name.startswith("orbiter.")]] = 0.0
    assert modes.tip == pytest.approx(modes.shapes @ relative.T, abs=1e-9)
    assert modes.frequencies == pytest.approx(
        frequencies(found.arm.model, BENT, payload=found.payload, orbiter=found.orbiter), rel=1e-9
    )
    inner, damper = np.linalg.inv(mass[np.ix_(free, free)]), found.damping[np.ix_(free, free)]
    state = np.block([
        [np.zeros_like(inner), np.eye(len(free))],
        [-inner @ found.stiffness[np.ix_(free, free)], -inner @ damper],
    ])  # fmt: skip
    poles = np.linalg.eigvals(state)
    for frequency, damping in zip(modes.frequencies[:6], modes.damping[:6], strict=True):
        expected = 2.0 * math.pi * frequency * complex(-damping, math.sqrt(1.0 - damping**2))
        assert np.abs(poles - expected).min() < 1e-4 * abs(expected)


@pytest.mark.parametrize("payload", [None, HEAVY])
def test_braked_arm_has_the_poles_of_its_modes(payload: Any) -> None:
    """A period of one step of MuJoCo, in which no vibration has an alias."""
    found = aftdeck.dynamics("srms", payload=payload, flexible=True)
    modes, poles = found.modes(BENT), found.linear(BENT, "brakes", period=0.002).poles()
    for frequency, damping in zip(modes.frequencies[:4], modes.damping[:4], strict=True):
        nearest = int(np.abs(poles.frequencies - frequency).argmin())
        assert poles.frequencies[nearest] == pytest.approx(frequency, rel=0.01)
        assert poles.damping[nearest] == pytest.approx(damping, rel=0.05)


@pytest.mark.parametrize(
    ("name", "flexible", "payload"),
    [("srms", False, HEAVY), ("srms", True, None), ("srms", True, HEAVY), ("concept-1972", False, HEAVY)],
)
def test_slow_poles_are_those_of_the_equations_in_continuous_time(name: str, flexible: bool, payload: Any) -> None:
    """Rate servos add their gain to the damping of the motors; MuJoCo's integrator tells as well what is slow."""
    found = aftdeck.dynamics(name, payload=payload, flexible=flexible)
    n, servo = len(found.coordinates), found.arm.model.servo
    assert servo is not None
    damper, inner = found.damping.copy(), np.linalg.inv(found.mass_matrix(BENT))
    slides = [k for k, one in enumerate(found.coordinates) if one in ("telescope", "prong")]
    for turn, gain in zip(found.arm.joints, servo.gain, strict=True):
        at = found.coordinates.index(f"motor.{turn}")
        damper[at, at] += gain
    for at, joint in zip(slides, found.arm.model.switched, strict=True):
        assert joint.drive is not None
        damper[at, at] += joint.drive.gain
    state = np.block([[np.zeros((n, n)), np.eye(n)], [-inner @ found.stiffness, -inner @ damper]])
    poles = np.linalg.eigvals(state)
    expected = poles[(np.abs(poles) < 10.0) & (np.abs(poles) > 1e-3)]
    sampled = found.linear(BENT, "servos", period=0.001).poles().s
    assert len(expected) >= 3
    for pole in expected:
        assert np.abs(sampled - pole).min() < 0.01 * abs(pole)


def test_poles_of_what_stays_and_of_what_is_gone_have_numbers() -> None:
    z = np.diag([1.0, 1.0 + 1e-9, 0.0, 0.5])
    model = LinearModel(
        z, np.zeros((4, 1)), np.zeros((1, 4)), np.zeros((1, 1)), ("a", "b", "c", "d"), ("u",), ("y",), 0.1
    )
    poles = model.poles()
    assert poles.z[:2] == pytest.approx(1.0) and (poles.s[:2] == 0.0).all() and np.isnan(poles.damping[:2]).all()
    assert poles.s[2].real == pytest.approx(math.log(0.5) / 0.1) and poles.damping[2] == pytest.approx(1.0)
    assert poles.s[3].real < -200.0 and np.isfinite(poles.frequencies).all()


def test_model_names_what_it_has_and_rejects_what_it_has_not() -> None:
    found = aftdeck.dynamics("srms")
    model = found.linear(BENT)
    assert model.A.shape == (len(model.states), len(model.states))
    assert model.B.shape == (len(model.states), len(model.inputs))
    assert model.C.shape == (len(model.outputs), len(model.states)) and not model.A.flags.writeable
    assert model.response(np.zeros((3, len(model.inputs)))).shape == (3, len(model.outputs))
    for ask, named in (
        (lambda: model.bode("rate.elbow", "rate.elbow_pitch", [0.1]), "rate.elbow_pitch"),
        (lambda: model.bode("rate.elbow_pitch", "speed", [0.1]), "angle.elbow_pitch"),
        (lambda: model.bode("rate.elbow_pitch", "rate.elbow_pitch", [0.0]), "25 Hz"),
        (lambda: model.bode("rate.elbow_pitch", "rate.elbow_pitch", [26.0]), "25 Hz"),
        (lambda: model.bode("rate.elbow_pitch", "rate.elbow_pitch", [2.0, 1.0]), "ascending"),
        (lambda: model.response(np.zeros((3, 1))), "inputs"),
        (lambda: model.response(np.full((3, 12), np.nan)), "finite"),
        (lambda: model.response(np.zeros((3, 12)), np.zeros(3)), "state"),
        (lambda: found.linear(BENT, "clutch"), "brakes"),  # type: ignore[arg-type]
        (lambda: found.linear(BENT, period=0.0), "period"),
        (lambda: found.linear(np.zeros(5)), "joint angles"),
    ):
        with pytest.raises(InputError, match=named):
            ask()
