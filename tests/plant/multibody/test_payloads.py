"""Payloads of the worksite on plants with masses: capture, release, berths, free flight and their forces."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from typing import cast

import mujoco
import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import prism
from aftdeck.bodies.pose import POSE, compose, inverse, pose_of, relative, row_of
from aftdeck.errors import ScenarioError
from aftdeck.frames import Pose, oriend
from aftdeck.plant.multibody.plant import MultibodyPlant
from aftdeck.plant.state import Bodies
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.worksite.capture.snares import Snares

STRETCHED = ["0 deg", "90 deg", "-10 deg", "-90 deg", "0 deg", "0 deg"]
"""Arm up and nearly straight, with the end effector at right angles: a force along its axis acts on the whole arm."""
APPROACH, TUMBLE = 0.03, math.radians(0.1)
"""Speed [m/s] and rate [rad/s] of a free flyer at its capture."""
STATE = mujoco.mjtState.mjSTATE_INTEGRATION
BOTH = pytest.mark.parametrize("plant", ["rigid", "flexible"])


def scenario(plant: str, cargo: list[dict[str, object]] | None = None, **dynamics: object) -> Scenario:
    """Return ``srms-deploy`` without its script, with a stretched arm."""
    changes: dict[tuple[str | int, ...], object] = {
        ("plant",): plant, ("phase",): [], ("duration",): "900 s", ("initial",): {"joints": STRETCHED},
    }  # fmt: skip
    if cargo is not None:
        changes["cargo",] = cargo
    return aftdeck.load_scenario("srms-deploy", changes | {("dynamics", key): value for key, value in dynamics.items()})


def free_flyer(plant: str, mass: float = 15_000.0, ahead: float = 0.09) -> Simulation:
    """Return a run with a payload that floats towards the end effector.

    Its pin is `ahead` [m] of its place in the end effector and 2 cm off in both directions across.
    """
    first = Simulation(scenario(plant))
    site, frames = first._flight.site, first._state.worksite.frames
    snares = site.capture
    assert isinstance(snares, Snares)
    fixture = snares.fixtures[0]
    assert fixture is not None
    effector, pin, payload, scene = (np.empty(POSE) for _ in range(4))
    compose(frames[site.last_joint], site.effector, effector)
    compose(effector, row_of(Pose(np.array([ahead, 0.02, -0.02]), np.eye(3))), pin)
    compose(pin, inverse(fixture), payload)
    relative(site.scene, payload, scene)
    at = pose_of(scene)
    along = site.scene[3:].reshape(3, 3).T @ effector[3:].reshape(3, 3) @ [-APPROACH, 0.0, 0.0]
    start = {
        "position": at.position.tolist(),
        "rotation": list(oriend(at.rotation)),
        "velocity": along.tolist(),
        "rates": [0.0, TUMBLE, 0.0],
    }
    return Simulation(scenario(plant, [{"name": "payload", "mass": mass, "start": start}]))


def bodies_of(sim: Simulation) -> Bodies:
    assert sim._state.plant.bodies is not None
    return sim._state.plant.bodies


def momentum(sim: Simulation) -> tuple[Array, Array]:
    """Return momentum [N s] and angular momentum about the common centre of mass [N m s] of all bodies."""
    view = cast(MultibodyPlant, sim._flight.plant)._apart[0].view
    mujoco.mj_setState(view.model, view.data, bodies_of(sim).physics, STATE)
    mujoco.mj_forward(view.model, view.data)
    mujoco.mj_subtreeVel(view.model, view.data)
    linear = view.data.subtree_linvel[0] * view.model.body_subtreemass[0]
    return linear, view.data.subtree_angmom[0].copy()


def close_snares(sim: Simulation, steps: int) -> list[str]:
    """Close the snares, and fly for a number of steps; return the kinds of all log lines."""
    kinds = [event.kind for event in sim.step(Inputs(effector="close")).events]
    for _ in range(steps - 1):
        kinds += [event.kind for event in sim.step(Inputs()).events]
    return kinds


@pytest.mark.slow
@BOTH
def test_capture_of_a_free_flyer_is_soft_has_no_jump_and_keeps_momentum(plant: str) -> None:
    sim = free_flyer(plant)
    linear, angular = momentum(sim)
    relative_speed, force, jumps = [], [], []
    frame = sim.step(Inputs(effector="close"))
    for _ in range(3000):
        before = bodies_of(sim).motions[0].copy(), bodies_of(sim).payloads[0].copy()
        frame = sim.step(Inputs())
        bodies = bodies_of(sim)
        force.append(float(bodies.held[0, 0]))
        jumps.append(np.abs(bodies.motions[0] - before[0]).max())
        relative_speed.append(float(np.linalg.norm(bodies.motions[0, 3:])))
    assert frame.work.cargo[0].held
    assert max(force) < 150.0
    assert max(jumps) < 0.02 * 150.0 / 15_000.0 + 0.02 * 150.0 * 3.0 / 40_000.0  # one step's force and torque
    after_linear, after_angular = momentum(sim)
    assert np.abs(after_linear - linear).max() < max(0.02, 1e-4 * float(np.linalg.norm(linear)))
    assert np.abs(after_angular - angular).max() < 1e-4 * float(np.linalg.norm(angular))
    assert relative_speed[-1] < APPROACH / 2  # the arm has stopped most of the motion


@BOTH
def test_arm_gives_the_payload_the_momentum_that_the_hold_reports(plant: str) -> None:
    sim = free_flyer(plant)
    before = bodies_of(sim).motions[0, 3:].copy()
    impulse = 0.0
    for n in range(400):
        sim.step(Inputs(effector="close") if n == 0 else Inputs())
        impulse += 0.02 * float(bodies_of(sim).held[0, 0])
    change = 15_000.0 * float(np.linalg.norm(bodies_of(sim).motions[0, 3:] - before))
    assert impulse == pytest.approx(change, rel=0.15)  # the force is sampled, and its direction varies


def test_release_changes_no_velocity() -> None:
    sim = free_flyer("rigid")
    assert "acquired" in close_snares(sim, 1000)
    sim.step(Inputs(effector="open"))
    while bodies_of(sim).held[0, 0] > 0.0 or sim._state.worksite.held is not None:
        before = bodies_of(sim).motions[0].copy()
        force = float(bodies_of(sim).held[0, 0])
        sim.step(Inputs())
    after = bodies_of(sim).motions[0].copy()
    assert np.abs(after - before).max() < 0.02 * (force + 1.0) / 15_000.0 + 1e-6
    impulse = 0.0
    for _ in range(50):
        frame = sim.step(Inputs())
        assert frame.dynamics is not None
        impulse += 0.02 * sum(math.hypot(*contact.force) for contact in frame.dynamics.contacts)
    assert np.linalg.norm(bodies_of(sim).motions[0, 3:] - after[3:]) <= 1e-12 + 1.01 * impulse / 15_000.0
    assert bodies_of(sim).motions[0, :3] == pytest.approx(after[:3], abs=1e-6)  # it tumbles by its inertia


@pytest.mark.slow
@pytest.mark.parametrize("at", [60, 100, 140, 400])
def test_saved_run_continues_to_the_last_bit_during_a_capture(at: int) -> None:
    sim = free_flyer("flexible")
    close_snares(sim, at)
    saved, other = sim.save(), Simulation(sim.scenario)
    other.restore(saved)
    for _ in range(100):
        assert sim.step(Inputs()) == other.step(Inputs())
    assert sim.save() == other.save()


def test_payload_in_its_berth_stays_there_and_moves_with_the_orbiter() -> None:
    sim = Simulation(scenario("rigid"))
    start = sim.step(Inputs()).work.cargo[0].position
    for n in range(500):
        frame = sim.step(Inputs(mode="ORB UNL", translation=(0.5, 0.0, -0.5)) if n < 200 else Inputs())
    assert frame.dynamics is not None
    assert math.dist(frame.dynamics.orbiter.position, (0.0, 0.0, 0.0)) > 3e-4  # the orbiter has moved
    assert frame.work.cargo[0].position == pytest.approx(start, abs=1e-4)


def test_body_without_forces_keeps_its_motion_beside_a_turning_orbiter() -> None:
    """The payload's pose in L follows from its own motion in space, and from that of the orbiter."""
    sim = free_flyer("rigid", ahead=3.0)
    bodies = bodies_of(sim)
    start, motion = bodies.payloads[0].copy(), bodies.motions[0].copy()
    for _ in range(500):
        frame = sim.step(Inputs(mode="ORB UNL", translation=(0.0, 0.0, 1.0)))
    bodies = bodies_of(sim)
    assert bodies.motions[0, 3:] == pytest.approx(motion[3:], abs=1e-12)
    assert bodies.payloads[0, :3] == pytest.approx(start[:3] + 500 * 0.02 * motion[3:], abs=1e-6)
    seen = np.empty(POSE)
    relative(sim._state.plant.base, bodies.payloads[0], seen)
    assert frame.work.cargo[0].position == pytest.approx(tuple(seen[:3]), abs=1e-9)


@BOTH
def test_greatest_force_of_a_capture_is_logged(plant: str) -> None:
    sim = free_flyer(plant)
    greatest, lines = 0.0, []
    for n in range(500):
        frame = sim.step(Inputs(effector="close") if n == 0 else Inputs())
        lines += [event.text for event in frame.events if event.kind == "force"]
        if not lines:
            greatest = max(greatest, float(bodies_of(sim).held[0, 0]))
    assert len(lines) == 1
    assert f"{greatest:.0f} N" in lines[0]


def test_mass_of_a_scenario_scales_the_inertia_and_inertia_replaces_it() -> None:
    own, heavy = (scenario("rigid", [{"name": "payload", "mass": mass}]).payloads[0] for mass in (1000.0, 3000.0))
    assert heavy.inertia == pytest.approx(3.0 * own.inertia)
    given = scenario("rigid", [{"name": "payload", "inertia": [100.0, 200.0, 250.0]}]).payloads[0]
    assert given.inertia == pytest.approx(np.diag([100.0, 200.0, 250.0]))
    with pytest.raises(ScenarioError, match=r"cargo\[0\].inertia"):
        scenario("rigid", [{"name": "payload", "inertia": [100.0, 200.0, 350.0]}])


def test_inertia_of_a_uniform_prism_equals_that_of_its_triangles() -> None:
    sides, across, length, mass = 6, 3.0, 7.0, 900.0
    found = prism(mass, across, sides, [-length / 2, 0.0, 0.0], [length / 2, 0.0, 0.0]).inertia
    corners = np.exp(2j * np.pi * np.arange(sides + 1) / sides) * across / 2
    square = area = 0.0
    for a, b in itertools.pairwise(corners):  # each triangle with the centre as its third corner
        own = 0.5 * abs((a.conjugate() * b).imag)
        area += own
        square += own * (abs(a) ** 2 + abs(b) ** 2 + (a.conjugate() * b).real) / 6.0
    polar = mass * square / area
    assert found == pytest.approx(np.diag([polar, *[polar / 2 + mass * length**2 / 12] * 2]))


@BOTH
def test_payload_that_starts_inside_the_arm_is_rejected(plant: str) -> None:
    inside = ((-1.0, "payload"), (-3.0, "payload"))
    for ahead, name in inside:
        with pytest.raises(ScenarioError) as error:
            free_flyer(plant, ahead=ahead)
        assert name in str(error.value) and "initial" in str(error.value)
    sim = free_flyer(plant, ahead=0.5)
    with pytest.raises(ScenarioError):  # at a start other than the scenario's
        sim.restart(replace(sim.scenario.start, angles=at_the_payload(sim)))
    assert not sim.step().work.contacts


def at_the_payload(sim: Simulation) -> Array:
    """Return joint angles with which the end effector is inside the free flyer."""
    arm, start = sim.scenario.arm, sim.scenario.start
    tip = arm.forward(start.angles)
    angles: Array = arm.inverse(Pose(tip.position + tip.rotation @ [1.5, 0.0, 0.0], tip.rotation), near=start.angles)[0]
    return angles
