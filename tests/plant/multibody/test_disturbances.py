"""What disturbances do: impulse and change of momentum, work and energy, places, axes, closed answers."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from aftdeck.arrays import Array
from aftdeck.bodies.pose import pose_of
from aftdeck.frames import endori
from aftdeck.scenario.disturbance import Disturbance
from aftdeck.scenario.load import parse_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests import loaded
from tests.each import each, seeds
from tests.plant.multibody.disturbed import FAR, KINDS, given, momentum, name_of, planned
from tests.plant.multibody.points import cloud
from tests.plant.multibody.test_payloads import bodies_of


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize("kind", KINDS)
@each("seed", seeds(2, 30))
def test_impulse_is_the_change_of_momentum(plant: str, kind: str, seed: int) -> None:
    """All bodies together feel nothing else: the orbiter is free, and the arm acts inside."""
    rng = np.random.default_rng(seed)
    force, torque, at = (rng.uniform(-1.0, 1.0, 3) * size for size in (60.0, 80.0, 2.0))
    begin, duration = float(rng.uniform(0.0, 0.3)), float(rng.uniform(0.2, 0.9))
    if kind == "tip":
        force, torque = 0.3 * force, 0.3 * torque
    fields = {"force": force.tolist(), "torque": torque.tolist(), "frame": "space", "at": at.tolist()}
    sim = Simulation(given(plant, kind, planned(name_of(kind), begin, duration, **fields)))
    start = momentum(sim)
    impulse, turn = np.zeros(3), np.zeros(3)
    for _ in range(70):
        base = pose_of(sim._state.plant.base.copy())
        frame = sim.step(Inputs(brakes=True))
        assert frame.dynamics is not None
        for one in frame.dynamics.disturbances:
            now = base.rotation @ one.force
            impulse += 0.02 * now
            place = base.position + base.rotation @ one.position
            turn += 0.02 * (base.rotation @ one.torque + np.cross(place, now))
    end = momentum(sim)
    size, arm = float(np.linalg.norm(force)), 30.0
    assert impulse == pytest.approx(force * duration, abs=1e-9 * size)
    assert end[0] - start[0] == pytest.approx(impulse, abs=2e-5 * size * duration + 1e-4)
    # the body moves by a few millimetres within a control period, in which the torque about its centre is constant
    assert end[1] - start[1] == pytest.approx(turn, abs=2e-3 * size * duration * arm)


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@each("seed", seeds(2, 30))
def test_free_payload_moves_by_the_closed_solution(plant: str, seed: int) -> None:
    """A constant force at the centre of mass accelerates it; a constant torque about a principal axis turns it."""
    rng, mass = np.random.default_rng(seed), 1500.0
    force, torque = rng.uniform(-1.0, 1.0, 3) * 200.0, float(rng.uniform(-1.0, 1.0)) * 150.0
    moments, turn, centre = [2000.0, 3000.0, 4000.0], rng.uniform(-3.0, 3.0, 3), rng.uniform(-1.0, 1.0, 3)
    axes = endori(*turn)
    tensor = axes @ np.diag(moments) @ axes.T
    k = int(rng.integers(3))
    text = (
        f"title = 't'\nplant = '{plant}'\n[dynamics]\norbiter = 'fixed'\n"
        f"[initial]\njoints = {loaded.scenario('loaded').initial_angles.tolist()}\n"
        f"[[cargo]]\nname = 'payload'\nmass = {mass}\nstart = {{ position = {FAR['position']} }}\n"
        f"inertia = {np.diag(tensor).tolist()}\ncentre_of_mass = {centre.tolist()}\n"
        f"products = {[float(tensor[0, 1]), float(tensor[0, 2]), float(tensor[1, 2])]}\n"
        f"[[disturbance]]\non = 'payload'\nbegin = 0.4\nduration = 1.5\nframe = 'space'\nforce = {force.tolist()}\n"
        f"[[disturbance]]\non = 'payload'\nbegin = 0.1\nduration = 2.0\nframe = 'payload'\n"
        f"torque = {(torque * axes[:, k]).tolist()}\n"
    )
    sim = Simulation(parse_scenario(text, "a", "a.toml", Path()))
    first = pose_of(bodies_of(sim).payloads[0].copy())
    for _ in range(round(5.0 / 0.02)):
        sim.advance(Inputs())
    now = pose_of(bodies_of(sim).payloads[0])
    moved = now.position + now.rotation @ centre - first.position - first.rotation @ centre
    gain = force / mass
    assert moved == pytest.approx(gain * (0.5 * 1.5**2 + 1.5 * 3.1), rel=2e-3, abs=1e-4)
    rate, angle = torque / moments[k] * 2.0, torque / moments[k] * (0.5 * 2.0**2 + 2.0 * 2.9)
    assert bodies_of(sim).motions[0, :3] == pytest.approx(rate * axes[:, k], rel=1e-6, abs=1e-9)
    turned = first.rotation.T @ now.rotation
    about = np.array([turned[2, 1] - turned[1, 2], turned[0, 2] - turned[2, 0], turned[1, 0] - turned[0, 1]])
    assert about == pytest.approx(2.0 * math.sin(angle) * axes[:, k], rel=3e-3, abs=1e-5)


@pytest.mark.parametrize("kind", ["orbiter", "worksite's payload"])
@each("seed", seeds(2, 30))
def test_work_of_the_force_is_the_change_of_energy(kind: str, seed: int) -> None:
    """Of a body that starts at rest, whose arm the brakes hold: nothing else takes or gives energy."""
    rng = np.random.default_rng(seed)
    force, torque = rng.uniform(-1.0, 1.0, 3) * 400.0, rng.uniform(-1.0, 1.0, 3) * 300.0
    fields = {"force": force.tolist(), "torque": torque.tolist(), "frame": "space"}
    sim = Simulation(given("rigid", kind, planned(name_of(kind), 0.0, 8.0, **fields)))
    work, start = 0.0, momentum(sim)[2]
    for _ in range(400):
        before = _centre(sim, kind)
        frame = sim.step(Inputs(brakes=True))
        after = _centre(sim, kind)
        assert frame.dynamics is not None
        turned = after[1] @ before[1].T
        about = 0.5 * np.array([turned[2, 1] - turned[1, 2], turned[0, 2] - turned[2, 0], turned[1, 0] - turned[0, 1]])
        work += float(force @ (after[0] - before[0]) + torque @ about)
    gained = momentum(sim)[2] - start
    assert gained > 0.05
    assert gained == pytest.approx(work, rel=0.02)


def _centre(sim: Simulation, kind: str) -> tuple[Array, Array]:
    """Return centre of mass (3,) and attitude (3, 3) of the orbiter or of the payload in space."""
    if kind == "orbiter":
        base, mass = pose_of(sim._state.plant.base.copy()), sim.scenario.worksite.orbiter
        assert mass is not None
        return base.position + base.rotation @ mass.in_l(sim.scenario.arm.model.mount).centre, base.rotation
    pose = pose_of(bodies_of(sim).payloads[0].copy())
    return pose.position + pose.rotation @ sim.scenario.payloads[0].centre_of_mass, pose.rotation


@pytest.mark.parametrize("period", [0.005, 0.02, 0.08, 0.2])
@each("seed", seeds(4, 40))
def test_impulse_does_not_depend_on_the_control_period(period: float, seed: int) -> None:
    """Neither on where in a period the disturbance begins and ends, nor on whether it is shorter than a period."""
    rng = np.random.default_rng(seed)
    begin, duration = float(rng.uniform(0.0, 0.5)), float(10.0 ** rng.uniform(-3.0, -0.3))
    lines = planned("payload", begin, duration, force=[50.0, 0.0, 0.0], frame="space")
    sim = Simulation(given("rigid", "worksite's payload", lines, period=period))
    for _ in range(math.ceil(1.2 / period)):
        sim.advance(Inputs())
    body = bodies_of(sim)
    pose, cargo = pose_of(body.payloads[0]), sim.scenario.payloads[0]
    velocity = body.motions[0, 3:] + pose.rotation @ np.cross(body.motions[0, :3], cargo.centre_of_mass)
    assert cargo.mass * velocity == pytest.approx([50.0 * duration, 0.0, 0.0], rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("frame", ["orbiter", "panel", "L", "space", "tip", "payload"])
@each("seed", seeds(2, 10))
def test_axes_are_those_of_the_named_frame_at_the_beginning_of_the_step(frame: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    kind = "own payload" if seed % 2 else "worksite's payload"
    sim = Simulation(given("rigid", kind))
    force = tuple((10.0 * rng.uniform(-1.0, 1.0, 3)).tolist())
    stick: Any = tuple(rng.uniform(-1.0, 1.0, 3).tolist())
    for _ in range(100):
        sim.advance(Inputs(mode="ORB UNL", translation=stick, disturbances=(Disturbance("payload", torque=force),)))
    before, base = sim.look(), sim._state.plant.base[3:].reshape(3, 3).copy()
    shown = sim.step(Inputs(disturbances=(Disturbance("tip", force, frame=frame),))).dynamics
    assert before.dynamics is not None and shown is not None
    mount = sim.scenario.arm.model.mount.rotation
    if frame == "payload":
        held = before.work.cargo[0] if before.work.cargo else None
        own = sim.scenario.own_payloads[0].rotation if held is None else np.eye(3)
        axes = np.array(before.dynamics.orientation) @ own if held is None else np.array(held.orientation)
    else:
        axes = {
            "orbiter": mount.T, "panel": mount.T, "L": np.eye(3), "space": base.T,
            "tip": np.array(before.dynamics.orientation),
        }[frame]  # fmt: skip
    assert shown.disturbances[0].force == pytest.approx(axes @ force, abs=1e-9)
    assert shown.disturbances[0].position == pytest.approx(before.dynamics.position, abs=1e-9)


@pytest.mark.parametrize("kind", KINDS)
def test_force_without_a_point_acts_at_the_centre_of_mass_or_the_tip(kind: str) -> None:
    sim = Simulation(given("rigid", kind))
    mount = sim.scenario.arm.model.mount
    before = sim.step(Inputs())
    shown = sim.step(Inputs(disturbances=(Disturbance(name_of(kind), (1.0, 0.0, 0.0)),))).dynamics
    assert before.dynamics is not None and shown is not None
    tip, turn = np.array(before.dynamics.position), np.array(before.dynamics.orientation)
    if kind == "orbiter":
        expected = mount.rotation.T @ (mount.orbiter_origin - mount.origin)
    elif kind == "tip":
        expected = tip
    elif kind == "own payload":
        expected = tip + turn @ cloud(1).centre
    else:
        cargo = before.work.cargo[0]
        expected = np.array(cargo.position) + np.array(cargo.orientation) @ cloud(1).centre
    assert shown.disturbances[0].position == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_constant_force_at_the_tip_bends_the_arm_by_its_stiffness(plant: str) -> None:
    """A braked arm on a fixed orbiter comes to rest where its springs balance the force; a rigid one does not move."""
    force = (0.0, 0.0, 4.0)
    sim = Simulation(given(plant, "tip", planned("tip", 0.0, 60.0, force=list(force), frame="L"), orbiter="fixed"))
    start = sim.step(Inputs(brakes=True)).dynamics
    places = []
    for _ in range(2000):
        shown = sim.step(Inputs(brakes=True)).dynamics
        assert shown is not None
        places.append(shown.position)
    assert start is not None
    moved = np.mean(places[-1000:], axis=0) - np.array(start.position)
    bent = float(moved @ force) / 4.0
    assert bent > 1e-4 if plant == "flexible" else abs(bent) < 1e-4
    double = Simulation(
        given(plant, "tip", planned("tip", 0.0, 60.0, force=[0.0, 0.0, -4.0], frame="L"), orbiter="fixed")
    )
    other = [np.array(double.step(Inputs(brakes=True)).dynamics.position) for _ in range(2000)]  # type: ignore[union-attr]
    back = np.mean(other[-1000:], axis=0) - np.array(start.position)
    assert back == pytest.approx(-moved, abs=0.1 * bent + 5e-4)


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_disturbance_that_has_ended_leaves_nothing_behind(plant: str) -> None:
    sim = Simulation(given(plant, "own payload"))
    push = (
        Disturbance("tip", (3.0, 0.0, 0.0)),
        Disturbance("payload", torque=(0.0, 2.0, 0.0)),
        Disturbance("orbiter", (9.0, 0.0, 0.0)),
    )
    for _ in range(10):
        sim.advance(Inputs(disturbances=push))
    linear, angular, _ = momentum(sim)
    for _ in range(50):
        frame = sim.step(Inputs())
        assert frame.dynamics is not None and frame.dynamics.disturbances == ()
    later = momentum(sim)
    assert later[0] == pytest.approx(linear, abs=1e-6) and later[1] == pytest.approx(angular, abs=1e-3)


@pytest.mark.parametrize("name", ["srms", "concept-1972"])
@pytest.mark.parametrize("orbiter", ["free", "held", "fixed"])
@each("mode", ["ORB UNL", "END EFF", "SINGLE", "DIRECT", "MASTER", "TEST", "brakes"])
def test_random_disturbances_are_flown_in_every_mode_on_every_arm(name: str, orbiter: str, mode: str) -> None:
    """Random forces on every body: the run stays finite, repeats exactly, and a free system gains their impulse."""
    rng = np.random.default_rng(sum(map(ord, name + orbiter + mode)))
    arm = loaded.arm(name)
    joints = arm.model.limits.hard.mean(axis=1).tolist()
    text = (
        f"title = 't'\narm = '{name}'\nworksite = 'space'\nplant = 'rigid'\nduration = '60 s'\n"
        f"[initial]\njoints = {joints}\n[dynamics]\norbiter = '{orbiter}'\n[payload]\n{cloud(2, 200.0).toml()}"
    )
    made = parse_scenario(text, "a", "a.toml", Path())

    def push(body: str) -> Disturbance:
        force, torque = (tuple(rng.uniform(-size, size, 3).tolist()) for size in (20.0, 9.0))
        return Disturbance(body, force, torque, "space")

    pushes = [tuple(push(body) for body in made.disturbable.movable if rng.random() < 0.5) for _ in range(25)]
    ends = []
    for _ in range(2):
        sim = Simulation(made)
        for n, acting in enumerate(pushes):
            sim.advance(
                Inputs(
                    mode=mode if n == 0 and mode != "brakes" else None,
                    brakes=True if mode == "brakes" else None,
                    drive=0.3 if mode in ("SINGLE", "DIRECT") else 0.0,
                    translation=(0.2, -0.1, 0.3),
                    disturbances=acting,
                )
            )
        ends.append(sim.save())
        if orbiter == "free":
            impulse = 0.02 * sum((np.array(one.force) for acting in pushes for one in acting), np.zeros(3))
            assert momentum(sim)[0] == pytest.approx(impulse, abs=0.01)
    assert ends[0] == ends[1]
