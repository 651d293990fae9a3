"""Gauges: loads inside the arm against the momentum of what is beyond the cut, and their indifference to the run."""

from __future__ import annotations

from typing import cast

import numpy as np
import pytest

import aftdeck
from aftdeck.arms.load import ArmModel
from aftdeck.arms.masses import masses_of
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties, joined
from aftdeck.plant.multibody import plant as plant_module
from aftdeck.plant.readings import CUTS, Cut, Readings
from aftdeck.plant.state import Bodies
from aftdeck.scenario.disturbance import Disturbance
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.plant.multibody.flights import scenario
from tests.plant.multibody.points import cloud

PERIOD = 0.002
"""Control period of one step of MuJoCo [s]: every step is then seen."""
BOTH = pytest.mark.parametrize("plant", ["rigid", "flexible"])
PUSH = Inputs(mode="ORB UNL", translation=(1.0, -0.5, 0.7), rotation=(0.3, 0.5, -0.4))


def bodies_of(sim: Simulation) -> Bodies:
    return cast("Bodies", sim._state.plant.bodies)


def readings_of(sim: Simulation) -> Readings:
    assert sim.readings is not None
    return sim.readings


def load(sim: Simulation, cut: Cut) -> tuple[Array, Array]:
    """Return force and moment at a cut, in the axes in which the gauges give them."""
    found = readings_of(sim).loads[CUTS.index(cut)]
    return np.array(found.force), np.array(found.moment)


def momenta(parts: list[tuple[MassProperties, Array]], before: list[Array]) -> tuple[Array, Array]:
    """Return momentum and angular momentum about the world's origin of bodies between two poses, `PERIOD` apart."""
    linear, angular = np.zeros(3), np.zeros(3)
    for (body, pose), old in zip(parts, before, strict=True):
        rotation, was = pose[3:].reshape(3, 3), old[3:].reshape(3, 3)
        place, place_was = pose[:3] + rotation @ body.centre, old[:3] + was @ body.centre
        velocity = (place - place_was) / PERIOD
        spin = (rotation - was) @ (0.5 * (rotation + was)).T / PERIOD
        rate = 0.5 * np.array([spin[2, 1] - spin[1, 2], spin[0, 2] - spin[2, 0], spin[1, 0] - spin[0, 1]])
        linear += body.mass * velocity
        angular += (
            np.cross(0.5 * (place + place_was), body.mass * velocity) + rotation @ body.inertia @ rotation.T @ rate
        )
    return linear, angular


def rigid_bodies(model: ArmModel, first: int) -> list[tuple[int, MassProperties]]:
    """Return the bodies of a rigid arm from a frame on, each with the row of its frame."""
    masses = masses_of(model)
    found = []
    for row, frame in enumerate(model.frames):
        own = [masses.bodies[frame]] if frame in masses.bodies else []
        own += [boom.whole() for boom in masses.booms if boom.frame == frame]
        if row >= first and own:
            found.append((row, joined(own)))
    return found


@BOTH
def test_gauges_do_not_change_the_run(plant: str) -> None:
    given = scenario(plant, pounds=8000.0, orbiter="free")
    runs = [Simulation(given), Simulation(given, gauged=True)]
    for step in range(60):
        for sim in runs:
            sim.advance(PUSH if step < 40 else Inputs(brakes=True))
        assert runs[0].seal() == runs[1].seal()
    assert runs[0].readings is None and runs[1].readings is not None


@pytest.mark.parametrize("cut", CUTS)
@pytest.mark.parametrize("body", ["", "[payload]\nmass = '8000 lb'\n", f"[payload]\n{cloud(3).toml()}"])
def test_load_is_the_rate_of_the_momentum_beyond_the_cut(cut: Cut, body: str) -> None:
    sim = Simulation(scenario("rigid", body, head=f"control_period = {PERIOD}"), gauged=True)
    model = sim.scenario.arm.model
    first = {"upper_boom": 2, "lower_boom": 3, "end_effector": len(model.frames)}[cut]
    parts = rigid_bodies(model, first)
    payload = sim.scenario.payload
    tip = np.array([float(model.links[4]), 0.0, 0.0])
    if payload is not None:
        parts.append((len(model.frames) - 1, payload.properties.moved(tip)))
    poses, were, earlier, errors, sizes = [], None, None, [], []
    for step in range(150):
        sim.advance(PUSH)
        frames = bodies_of(sim).frames
        poses = [frames[row].copy() for row, _ in parts]
        if were is not None:
            now = momenta([(body, pose) for (_, body), pose in zip(parts, poses, strict=True)], were)
            if earlier is not None and step > 20:
                force, torque = ((a - b) / PERIOD for a, b in zip(now, earlier, strict=True))
                row = frames[min(first, len(model.frames) - 1)]
                axes = row[3:].reshape(3, 3)
                place = row[:3] + (axes @ tip if cut == "end_effector" else 0.0)
                expected = np.concatenate([axes.T @ force, axes.T @ (torque - np.cross(place, force))])
                errors.append(np.concatenate(load(sim, cut)) - expected)
                sizes.append(expected)
            earlier = now
        were = poses
    for half in (slice(0, 3), slice(3, 6)):
        size = np.abs(np.array(sizes)[:, half]).max()
        assert np.abs(np.array(errors)[:, half]).max() <= 0.02 * size + 1e-6, (size, cut)
        assert size > 1.0 or (cut == "end_effector" and not body)


@BOTH
def test_load_at_the_tip_moves_a_held_payload_of_the_worksite(plant: str) -> None:
    given = aftdeck.load_scenario("srms-berth", {"plant": plant, "control_period": PERIOD, "phase": []})
    sim, places = Simulation(given, gauged=True), []
    (mass,) = [cargo.mass for cargo in given.payloads]
    forces = []
    for _ in range(400):
        sim.advance(Inputs(mode="ORB LD", translation=(0.0, 0.0, -1.0)))
        bodies = bodies_of(sim)
        places.append(bodies.payloads[0, :3].copy())
        axes = sim._state.plant.base[3:].reshape(3, 3) @ bodies.frames[-1, 3:].reshape(3, 3)
        forces.append(axes @ load(sim, "end_effector")[0])
    expected = mass * np.diff(places, 2, axis=0) / PERIOD**2
    found = np.array(forces)[2:]
    assert np.abs(expected).max() > 0.5
    assert np.abs(found - expected)[20:].max() <= 0.02 * np.abs(expected).max()


@pytest.mark.slow
def test_loads_of_the_flexible_arm_are_those_of_fine_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    def history(given: Scenario) -> Array:
        sim, rows = Simulation(given, gauged=True), []
        for step in range(500):
            sim.advance(Inputs(mode="ORB UNL", translation=(1.0 if step < 150 else 0.0, 0.0, 0.0)))
            rows.append([load.peak_moment for load in readings_of(sim).loads])
        return np.array(rows)

    given = scenario("flexible", pounds=8000.0)
    coarse = history(given)
    monkeypatch.setattr(plant_module, "STEP", 0.00025)
    fine = history(given)
    assert (np.abs(coarse.max(axis=0) - fine.max(axis=0)) <= 0.03 * fine.max(axis=0)).all()
    assert (np.abs(coarse - fine).max(axis=0) <= 0.1 * fine.max(axis=0)).all()


@BOTH
@pytest.mark.parametrize("on", ["tip", "payload"])
@pytest.mark.parametrize("held", ["own", "worksite"])
def test_static_loads_balance_a_constant_disturbance(plant: str, on: str, held: str) -> None:
    """Of the braked arm on a fixed orbiter, after its swing has been averaged: sums of forces and moments are zero."""
    force, torque, at = np.array([3.0, -2.0, 4.0]), np.array([5.0, 1.0, -6.0]), np.array([0.4, -0.3, 0.2])
    if held == "own":
        given = scenario(plant, f"[payload]\n{cloud(4, 300.0).toml()}")
    else:
        changes: dict[tuple[str | int, ...], object] = {
            ("plant",): plant, ("phase",): [], ("dynamics",): {"orbiter": "fixed"}, ("step",): [],
            ("cargo",): [{"name": "payload", **cloud(4, 300.0).fields()}],
        }  # fmt: skip
        given = aftdeck.load_scenario("srms-berth", changes)
    push = Disturbance(on, tuple(force.tolist()), tuple(torque.tolist()), "L", tuple(at.tolist()))
    sim = Simulation(given, gauged=True)
    steps, last = 1700, 1200
    sums = {cut: np.zeros(6) for cut in CUTS}
    expected = {cut: np.zeros(6) for cut in CUTS}
    links = given.arm.model.linkage.frames
    for step in range(steps):
        frame = sim.step(Inputs(brakes=True, disturbances=(push,)))
        if step < steps - last:
            continue
        assert frame.dynamics is not None
        place, frames = np.array(frame.dynamics.disturbances[0].position), bodies_of(sim).frames
        for cut, row in zip(CUTS, (2, 3, len(links) - 1), strict=True):
            own = frames[given.arm.model.frames.index(links[row])]
            axes, origin = own[3:].reshape(3, 3), own[:3]
            if cut == "end_effector":
                origin = np.array(frame.dynamics.position)
            moment = torque + np.cross(place - origin, force)
            sums[cut] += np.concatenate(load(sim, cut)) / last
            if not (cut == "end_effector" and on == "tip"):
                expected[cut] -= np.concatenate([axes.T @ force, axes.T @ moment]) / last
    for cut in CUTS:
        size = float(np.abs(expected[cut][3:]).max())
        assert sums[cut][:3] == pytest.approx(expected[cut][:3], abs=0.15), cut
        assert sums[cut][3:] == pytest.approx(expected[cut][3:], abs=0.04 * size + 0.6), cut
