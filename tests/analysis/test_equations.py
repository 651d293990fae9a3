"""Equations of motion: Lagrange's by other means, energy, momentum, and errors for people."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import aftdeck
from aftdeck.analysis.dynamics import Dynamics
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.errors import ArmError, InputError, LimitError
from aftdeck.kinematics.arm import load_arm
from tests.analysis import lagrange
from tests.analysis.cases import KINDS, random_angles, random_dynamics
from tests.each import each, seeds


def random_state(found: Dynamics, rng: np.random.Generator) -> tuple[Array, Array]:
    """Return positions and rates of all coordinates; springs are bent a little."""
    n = len(found.coordinates)
    q = 0.05 * rng.normal(size=n)
    q[[name.startswith("motor.") for name in found.coordinates]] = random_angles(found, rng)
    return q, rng.normal(size=n)


@pytest.mark.parametrize("name", ["srms", "concept-1972"])
@each("seed", seeds(6, 200))
def test_rigid_arm_obeys_lagrange_s_equations(name: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    found = random_dynamics(rng, name, flexible=False, free=False)
    model, q, v = found.arm.model, *random_state(found, rng)
    a = rng.normal(size=len(q))
    given = (model, found.payload, found.coordinates, q)
    matrix, expected = lagrange.mass_matrix(*given), lagrange.forces(*given, v, a)
    within = 1e-7 * np.abs(expected).max()
    assert found.mass_matrix(q) == pytest.approx(matrix, abs=1e-9 * np.abs(matrix).max())
    assert found.inverse(q, v, a) == pytest.approx(expected, abs=within)
    assert found.bias(q, v) == pytest.approx(lagrange.forces(*given, v, 0.0 * a), abs=within)
    assert matrix @ found.forward(q, v, expected) == pytest.approx(matrix @ a, abs=2.0 * within)


@pytest.mark.parametrize(("name", "flexible"), KINDS)
@each("seed", seeds(4, 100))
def test_forces_change_the_energy_by_their_power(name: str, flexible: bool, seed: int) -> None:
    rng = np.random.default_rng(seed)
    found = random_dynamics(rng, name, flexible=flexible)
    q, v = random_state(found, rng)
    q[[one.startswith("orbiter.") for one in found.coordinates]] = 0.0  # its rates are then those of its coordinates
    f = np.abs(found.bias(q, v)).max() * rng.normal(size=len(q))
    a, step = found.forward(q, v, f), 1e-6

    def kinetic(time: float) -> float:
        w = v + time * a
        return float(0.5 * w @ found.mass_matrix(q + time * v) @ w)

    slope = (kinetic(step) - kinetic(-step)) / (2.0 * step)
    stored, lost = float(v @ found.stiffness @ q), float(v @ found.damping @ v)
    scale = float(np.abs(f) @ np.abs(v)) + abs(stored) + abs(lost)
    assert slope + stored == pytest.approx(f @ v - lost, abs=1e-5 * scale)


@pytest.mark.parametrize(("name", "flexible"), KINDS)
@each("seed", seeds(4, 100))
def test_forward_dynamics_undo_inverse_dynamics(name: str, flexible: bool, seed: int) -> None:
    rng = np.random.default_rng(seed)
    found = random_dynamics(rng, name, flexible=flexible)
    q, v = random_state(found, rng)
    a = rng.normal(size=len(q))
    f = found.inverse(q, v, a)
    sum_of_parts = found.mass_matrix(q) @ a + found.bias(q, v) + found.damping @ v + found.stiffness @ q
    assert f == pytest.approx(sum_of_parts, abs=1e-9 * np.abs(f).max())
    assert found.mass_matrix(q) @ found.forward(q, v, f) == pytest.approx(
        found.mass_matrix(q) @ a, abs=1e-7 * np.abs(f).max()
    )


@pytest.mark.parametrize(("name", "flexible"), KINDS)
@each("seed", seeds(4, 100))
def test_motors_do_not_change_the_momentum_of_arm_and_free_orbiter(name: str, flexible: bool, seed: int) -> None:
    rng = np.random.default_rng(seed)
    found = random_dynamics(rng, name, flexible=flexible, free=True)
    q, v = random_state(found, rng)
    q[:6] = 0.0
    matrix = found.mass_matrix(q)
    assert matrix[:3, :3] == pytest.approx(matrix[0, 0] * np.eye(3), rel=1e-9, abs=1e-6)
    assert found.orbiter is not None and matrix[0, 0] > found.orbiter.mass
    a, step = found.forward(q, v, 100.0 * rng.normal(size=6)), 1e-6
    before, after = (found.mass_matrix(q + t * v)[:3] @ (v + t * a) for t in (-step, step))
    scale = float(np.abs(matrix[:3]).max() * np.abs(a).max())
    assert (after - before) / (2.0 * step) == pytest.approx(np.zeros(3), abs=1e-5 * scale)


@pytest.mark.parametrize(("name", "flexible"), KINDS)
def test_jacobian_of_the_tip_is_that_of_the_laws(name: str, flexible: bool) -> None:
    rng = np.random.default_rng(3)
    found = aftdeck.dynamics(name, flexible=flexible)
    angles = np.array([random_angles(found, rng) for _ in range(5)])
    motors = [found.coordinates.index(f"motor.{joint}") for joint in found.arm.joints]
    law = found.arm.jacobian(angles)  # angular, then translational
    assert found.tip_jacobian(angles)[:, :3][..., motors] == pytest.approx(law[:, 3:], abs=1e-9)
    assert found.tip_jacobian(angles)[:, 3:][..., motors] == pytest.approx(law[:, :3], abs=1e-9)


def test_batches_are_the_single_results() -> None:
    rng, found = np.random.default_rng(5), aftdeck.dynamics("srms", payload=2e3, flexible=True)
    q = np.array([[random_angles(found, rng) for _ in range(3)] for _ in range(2)])
    v, a = rng.normal(size=6), rng.normal(size=(3, len(found.coordinates)))
    whole = found.inverse(q, v, a)
    assert whole.shape == (2, 3, len(found.coordinates))
    assert found.mass_matrix(q).shape == (2, 3, *2 * (len(found.coordinates),))
    for at in np.ndindex(2, 3):
        assert whole[at] == pytest.approx(found.inverse(q[at], v, a[at[1]]))


def test_payload_of_which_only_the_mass_is_given_lies_across_the_arm() -> None:
    found = aftdeck.dynamics("srms", payload=1e4).payload
    assert found is not None and found.mass == 1e4
    assert np.argmin(np.diag(found.inertia)) == 1 and not found.centre.any()
    given = aftdeck.dynamics("srms", payload=found)
    assert given.mass_matrix(np.zeros(6)) == pytest.approx(
        aftdeck.dynamics("srms", payload=1e4).mass_matrix(np.zeros(6))
    )


def test_motor_s_inertia_and_friction_are_not_mixed_up() -> None:
    """Friction is left out; without it, the torque of a slow joint is its inertia times its acceleration."""
    arm, q = load_arm("srms"), np.zeros(6)
    found = aftdeck.dynamics(arm)
    assert found.inverse(q, 1e-9 * np.ones(6), np.zeros(6)) == pytest.approx(np.zeros(6), abs=1e-9)
    assert arm.model.servo is not None
    assert (np.diag(found.mass_matrix(q)) > arm.model.servo.armature).all()


BODY = MassProperties(100.0, np.zeros(3), np.diag([10.0, 10.0, 10.0]))


@pytest.mark.parametrize(
    ("arguments", "kind", "named"),
    [
        ({"arm": "canadarm9"}, ArmError, "canadarm9"),
        ({"arm": "concept-1972", "flexible": True}, ArmError, "flexibility"),
        ({"payload": 0.0}, InputError, "payload's mass"),
        ({"payload": -5.0}, InputError, "payload's mass"),
        ({"payload": np.nan}, InputError, "payload's mass"),
        ({"payload": "heavy"}, InputError, "payload's mass"),
        ({"payload": (100.0, [0, 0, 0], np.eye(3))}, InputError, "aftdeck.MassProperties"),
        ({"payload": BODY._replace(mass=0.0)}, InputError, "payload's mass"),
        ({"payload": BODY._replace(centre=np.zeros(2))}, InputError, "centre"),
        ({"payload": BODY._replace(centre=np.array([0.0, 0.0, 1e9]))}, InputError, "centre"),
        ({"payload": BODY._replace(inertia=np.zeros((3, 3)))}, InputError, "inertia"),
        ({"payload": BODY._replace(inertia=np.triu(np.ones((3, 3))))}, InputError, "symmetric"),
        ({"payload": BODY._replace(inertia=np.diag([1.0, 1.0, 3.0]))}, InputError, "inertia"),
        ({"payload": BODY._replace(inertia=np.full((3, 3), np.inf))}, InputError, "inertia"),
        ({"orbiter": "held"}, InputError, "orbiter"),
        ({"orbiter": BODY._replace(mass=1e-9)}, InputError, "orbiter's mass"),
    ],
)
def test_impossible_arguments_are_rejected(arguments: dict[str, Any], kind: type[Exception], named: str) -> None:
    with pytest.raises(kind, match=named):
        aftdeck.dynamics(**{"arm": "srms", **arguments})


def test_values_of_wrong_shapes_and_angles_beyond_the_stops_are_rejected() -> None:
    found, zero = aftdeck.dynamics("srms", flexible=True), np.zeros(6)
    with pytest.raises(InputError, match="positions"):
        found.mass_matrix(np.zeros(7))
    with pytest.raises(InputError, match="rates"):
        found.bias(zero, np.full(6, np.inf))
    with pytest.raises(InputError, match="broadcast"):
        found.bias(np.zeros((2, 6)), np.zeros((3, 6)))
    with pytest.raises(InputError, match="rigid"):
        aftdeck.dynamics("srms").modes(zero)
    beyond = zero.copy()
    beyond[2] = found.arm.limits.hard[2, 1] + 0.1
    for ask in (found.mass_matrix, found.modes, found.linear):
        with pytest.raises(LimitError) as caught:
            ask(beyond)
        assert caught.value.joint == "elbow_pitch" and caught.value.angle == beyond[2]
