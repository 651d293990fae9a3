"""Jets on plants with masses: the orbiter holds its attitude and translates; free flyers stay in their deadbands."""

from __future__ import annotations

import math
from pathlib import Path
from typing import cast

import mujoco
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import aftdeck
from aftdeck.arrays import Array
from aftdeck.errors import ScenarioError
from aftdeck.frames import oriend
from aftdeck.plant.multibody.jets import _pulse, _switch
from aftdeck.plant.multibody.plant import MultibodyPlant
from aftdeck.scenario.load import parse_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.payloads.jets import attitude_torques
from aftdeck.simulation.run import Simulation
from aftdeck.worksite.file.load import worksite_text
from tests.each import each, seeds
from tests.loaded import arm
from tests.plant.multibody.flights import scenario
from tests.plant.multibody.points import cloud
from tests.plant.multibody.test_payloads import bodies_of

DEADBAND, RATE = math.radians(1.0), math.radians(0.02)
"""Deadband of the built-in worksites [rad, rad/s]."""


def flyer(orbiter: str, **start: object) -> Simulation:
    """Return a run of the concept's free flyer without its script, far from everything."""
    changes: dict[tuple[str | int, ...], object] = {
        ("plant",): "rigid",
        ("phase",): [],
        ("initialise",): {},
        ("dynamics",): {"orbiter": orbiter},
        ("cargo",): [{"name": "free flyer", "start": {"position": [7.3, 0.0, 12.0], **start}}],
        ("duration",): "900 s",
    }
    return Simulation(aftdeck.load_scenario("free-flyer", changes))


def attitude(sim: Simulation) -> float:
    """Return the greatest angle about an axis by which the orbiter has turned [rad]."""
    roll, pitch, yaw = oriend(sim._state.plant.base[3:].reshape(3, 3))
    return max(abs(roll), abs(pitch), abs(yaw))


def moved(orbiter: str) -> tuple[Simulation, float]:
    """Move 32,000 lb with the Shuttle's arm; return the run and the orbiter's greatest angle [rad]."""
    body = "[[phase]]\nmode = 'ORB UNL'\ntranslation = [0.6, -0.4, 0.3]\nduration = '60 s'\n"
    sim, greatest = Simulation(scenario("rigid", body, pounds=32_000.0, orbiter=orbiter)), 0.0
    while not sim.ended:
        sim.advance()
        greatest = max(greatest, attitude(sim))
    return sim, greatest


@pytest.mark.slow
def test_held_orbiter_turns_less_than_a_free_one_and_stays_in_its_deadband() -> None:
    _, free = moved("free")
    held_run, held = moved("held")
    assert held < 1.3 * DEADBAND < free
    assert bodies_of(held_run).fired[:3].sum() > 0.0


@pytest.mark.slow
def test_limit_cycle_of_the_attitude_needs_little_firing() -> None:
    sim, greatest = Simulation(scenario("rigid", orbiter="held")), 0.0
    for _ in range(500):
        sim.advance(Inputs(mode="ORB UNL", translation=(0.0, 1.0, 0.5)))
    for _ in range(30_000):
        sim.advance(Inputs())
        greatest = max(greatest, attitude(sim))
    assert greatest < 1.02 * DEADBAND
    assert bodies_of(sim).fired[:3].sum() < 20.0


@pytest.mark.parametrize("start", [0.1, -0.25, 0.9, -3.0])
def test_axis_that_drifts_stays_in_its_deadband(start: float) -> None:
    """A rigid body about one axis: a least pulse changes its rate by a fifth of the rate's deadband."""
    least, period, acceleration = 0.08, 0.02, 0.2 * RATE / 0.08
    angle, rate, greatest = 0.0, start * RATE, 0.0
    pulses, fired = np.zeros(6), np.zeros(6)
    for _ in range(100_000):
        wanted = _switch(angle, rate, DEADBAND, RATE, float(pulses[0]))
        rate += acceleration * period * _pulse(wanted, 0, least, period, pulses, fired)
        angle += rate * period
        greatest = max(greatest, abs(angle))
    assert 0.9 * DEADBAND < greatest < 1.01 * DEADBAND
    assert fired[0] > 0.0 and not fired[1:].any()


def test_jets_change_the_angular_momentum_by_their_impulse() -> None:
    sim = Simulation(scenario("rigid", pounds=32_000.0, orbiter="held"))
    view = cast(MultibodyPlant, sim._flight.plant)._apart[1].view
    body, impulse, size = view.model.body("orbiter").id, np.zeros(3), 0.0
    before = spin(sim)
    for _ in range(3000):
        sim.advance(Inputs(mode="ORB UNL", translation=(0.6, -0.4, 0.3)))
        impulse += 0.02 * view.data.xfrc_applied[body, 3:]
        size += 0.02 * float(np.linalg.norm(view.data.xfrc_applied[body, 3:]))
    assert size > 100.0
    assert spin(sim) - before == pytest.approx(impulse, abs=1e-3 * size + 0.1)


def spin(sim: Simulation) -> Array:
    """Return the angular momentum of all bodies about their common centre of mass [N m s]."""
    view = cast(MultibodyPlant, sim._flight.plant)._apart[1].view
    mujoco.mj_setState(view.model, view.data, bodies_of(sim).physics, mujoco.mjtState.mjSTATE_INTEGRATION)
    mujoco.mj_forward(view.model, view.data)
    mujoco.mj_subtreeVel(view.model, view.data)
    found: Array = view.data.subtree_angmom[0].copy()
    return found


@pytest.mark.parametrize("orbiter", ["free", "held"])
def test_orbiter_reaches_the_commanded_speed_and_comes_to_rest(orbiter: str) -> None:
    sim = flyer(orbiter)
    step = 0.03048 * 0.08  # change of velocity by a least pulse
    for _ in range(250):
        frame = sim.step(Inputs(orbiter=(1.0, 0.0, 0.0)))
    assert float(np.linalg.norm(frame.work.orbiter_velocity)) == pytest.approx(0.06096, abs=step)
    for _ in range(250):
        frame = sim.step(Inputs())
    assert float(np.linalg.norm(frame.work.orbiter_velocity)) < step
    assert float(np.linalg.norm(frame.work.orbiter)) == pytest.approx(0.06096 * 5.0, rel=0.1)


def test_translation_of_a_fixed_orbiter_is_rejected() -> None:
    sim = flyer("fixed")
    frame = sim.step(Inputs(orbiter=(1.0, 0.0, 0.0)))
    assert any(event.kind == "refused" for event in frame.events)
    assert frame.work.orbiter == (0.0, 0.0, 0.0)


@pytest.mark.slow
def test_free_flyer_with_attitude_control_stays_in_its_deadband() -> None:
    sim = flyer("fixed")
    cycle = sim._flight.site.payloads[0].limit_cycle
    assert cycle is not None
    reference = bodies_of(sim).payloads[0, 3:].reshape(3, 3).copy()
    greatest, speeds = np.zeros(3), np.zeros(3)
    for _ in range(20_000):
        sim.advance(Inputs())
        angles = np.abs(oriend(reference.T @ bodies_of(sim).payloads[0, 3:].reshape(3, 3)))
        greatest, speeds = np.maximum(greatest, angles), np.maximum(speeds, np.abs(bodies_of(sim).motions[0, :3]))
    assert np.all(greatest < 2.0 * cycle.deadband + 1e-3)
    assert np.all(speeds < 1.5 * np.abs(cycle.rate) + 1e-6)


def test_saved_run_continues_to_the_last_bit_when_a_payloads_jets_fire() -> None:
    """The payload's own axes are those of the restored state, not those where the other simulation was."""
    sim, fired = flyer("fixed"), 0
    cargo, period = sim._flight.site.payloads, sim.scenario.control_period
    for _ in range(4000):
        if attitude_torques(cargo, sim._state.worksite.floating, bodies_of(sim), period):
            fired += 1
            other = Simulation(sim.scenario)
            other.restore(sim.save())
            sim.advance(Inputs())
            other.advance(Inputs())
            assert other.save() == sim.save()
            if fired == 3:
                return
        else:
            sim.advance(Inputs())
    raise AssertionError("the jets did not fire three times")


def test_tumbling_body_follows_eulers_equations() -> None:
    start, inertia = [0.02, 0.05, -0.03], (3000.0, 9000.0, 10_500.0)
    given = aftdeck.load_scenario(
        "srms-deploy",
        {
            ("plant",): "rigid",
            ("phase",): [],
            ("dynamics",): {"orbiter": "fixed"},
            ("cargo",): [
                {"name": "payload", "inertia": list(inertia), "start": {"position": [0.0, 0.0, 20.0], "rates": start}}
            ],
        },
    )
    assert given.payloads[0].limit_cycle is None
    sim = Simulation(given)
    for _ in range(3000):
        sim.advance(Inputs())
    a, b, c = inertia

    def euler(_: float, w: np.ndarray) -> list[float]:
        return [(b - c) / a * w[1] * w[2], (c - a) / b * w[2] * w[0], (a - b) / c * w[0] * w[1]]

    expected = solve_ivp(euler, (0.0, 60.0), start, rtol=1e-11, atol=1e-14).y[:, -1]
    found = bodies_of(sim).motions[0, :3]
    assert found == pytest.approx(expected, abs=1e-3 * float(np.linalg.norm(start)))
    assert inertia @ found**2 == pytest.approx(inertia @ np.array(start) ** 2, rel=1e-3)


def test_saved_run_continues_to_the_last_bit_during_a_pulse() -> None:
    sim = flyer("held")
    while not bodies_of(sim).pulses.any():
        sim.step(Inputs(orbiter=(0.0, 1.0, 0.0)))
    other = Simulation(sim.scenario)
    other.restore(sim.save())
    for n in range(200):
        inputs = Inputs(orbiter=(0.0, float(n < 50), 0.0))
        assert sim.step(inputs) == other.step(inputs)
    assert sim.save() == other.save()


@pytest.mark.parametrize("orbiter", ["free", "held"])
def test_worksite_without_an_orbiter_rejects_its_motion(orbiter: str, tmp_path: Path) -> None:
    path = tmp_path / "bare.toml"
    path.write_text(worksite_text("space").text.split("[orbiter]")[0])
    changes: dict[tuple[str | int, ...], object] = {("plant",): "rigid", ("worksite",): str(path)}
    with pytest.raises(ScenarioError, match=r"dynamics.orbiter.*\[orbiter\]"):
        aftdeck.load_scenario("uncradle", changes | {("dynamics",): {"orbiter": orbiter}})
    assert aftdeck.load_scenario("uncradle", changes).orbiter == "fixed"


def test_orbiter_is_fixed_in_empty_space_unless_the_scenario_frees_it() -> None:
    changes: dict[tuple[str | int, ...], object] = {("plant",): "rigid", ("worksite",): "space"}
    assert aftdeck.load_scenario("uncradle", changes).orbiter == "fixed"
    for motion in ("free", "held"):
        assert aftdeck.load_scenario("uncradle", changes | {("dynamics",): {"orbiter": motion}}).orbiter == motion


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize("orbiter", ["free", "held"])
@each("seed", seeds(1, 20))
def test_orbiter_moves_in_empty_space_as_at_its_own_worksite(plant: str, orbiter: str, seed: int) -> None:
    """The Shuttle's arm and orbiter are the same in both worksites; nothing is near the arm."""
    rng = np.random.default_rng(seed)
    body = f"[payload]\n{cloud(seed).toml()}"
    runs = [Simulation(scenario(plant, body, orbiter=orbiter, worksite=site)) for site in ("orbiter", "space")]
    sticks = [tuple(rng.uniform(-1.0, 1.0, 3).tolist()) for _ in range(3)]
    for n in range(200):
        inputs = Inputs(translation=sticks[0], rotation=sticks[1], orbiter=sticks[2] if n < 120 else (0.0, 0.0, 0.0))
        for sim in runs:
            sim.advance(inputs)
    near, empty = (bodies_of(sim) for sim in runs)
    assert np.array_equal(near.physics, empty.physics)
    assert near.fired[3:].any() and np.array_equal(near.fired, empty.fired)
    assert float(np.linalg.norm(runs[1]._state.plant.base[:3])) > 0.05


@pytest.mark.parametrize("orbiter", ["free", "held"])
def test_orbiter_in_empty_space_carries_every_arm(orbiter: str) -> None:
    """Translation by jets, of the concept's arm: its orbiter's centre of mass is the origin of its orbiter frame."""
    joints = arm("concept-1972").model.limits.hard.mean(axis=1).tolist()
    given = parse_scenario(
        "title = 't'\narm = 'concept-1972'\nworksite = 'space'\nplant = 'rigid'\n"
        f"[initial]\njoints = {joints}\n[dynamics]\norbiter = '{orbiter}'\n",
        "a", "a.toml", Path(),
    )  # fmt: skip
    sim, mount = Simulation(given), given.arm.model.mount
    assert given.worksite.orbiter is not None
    body = given.worksite.orbiter.in_l(mount)
    assert mount.rotation @ body.centre + mount.origin == pytest.approx(mount.orbiter_origin)
    for _ in range(200):
        frame = sim.step(Inputs(orbiter=(0.0, 1.0, 0.0)))
    assert float(np.linalg.norm(frame.work.orbiter_velocity)) == pytest.approx(0.06096, abs=0.003)
