"""Arm with masses: servos, brakes, momentum, measurements, and states that continue exactly."""

from __future__ import annotations

import math
import subprocess
import sys
from pathlib import Path
from typing import cast

import msgspec
import mujoco
import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.errors import InputError, SimulationError
from aftdeck.plant.multibody.plant import MultibodyPlant
from aftdeck.plant.multibody.view import View
from aftdeck.plant.state import Bodies
from aftdeck.recording.replay import verify
from aftdeck.recording.run import record
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.steering.mode import LawChoice
from benchmarks.stops import stop
from tests.plant.multibody.flights import AT_BAY, flown, ideal, move, scenario

RAISED = "joints = ['0 deg', '30 deg', '-5 deg', '0 deg', '0 deg', '0 deg']"
"""Nearly straight arm, 30 deg up; the direction (0.5, 0, -0.866) of the orbiter's axes is across it."""
STICKS = Inputs(translation=(0.6, -0.4, 0.3), rotation=(0.2, 0.1, -0.5))
STATE = mujoco.mjtState.mjSTATE_INTEGRATION


def parts(sim: Simulation) -> tuple[MultibodyPlant, View, Bodies]:
    """Return plant, workspace and bodies of a simulation without a payload, or with its first one."""
    plant, state = cast(MultibodyPlant, sim._flight.plant), sim._state
    assert state.plant.bodies is not None
    return plant, plant._apart[state.script.attached].view, state.plant.bodies


def push(sim: Simulation, force: Array) -> None:
    """Push the last body of the arm with a force in the world's axes [N], from now on."""
    _, view, bodies = parts(sim)
    mujoco.mj_setState(view.model, view.data, bodies.physics, STATE)
    view.data.xfrc_applied[view.model.body("arm.wrist_roll").id, :3] = force
    mujoco.mj_getState(view.model, view.data, bodies.physics, STATE)


def present(sim: Simulation) -> View:
    """Return the workspace at the present state, with all derived values."""
    _, view, bodies = parts(sim)
    mujoco.mj_setState(view.model, view.data, bodies.physics, STATE)
    mujoco.mj_forward(view.model, view.data)
    return view


@pytest.mark.parametrize("law", ["closed loop", "open loop", "position"])
def test_ideal_servos_follow_the_kinematic_arm(law: LawChoice) -> None:
    given = scenario("kinematic", move((1.5, 1.0, -1.2), law), head="arrive_within = 1e-3\narrive_within_angle = 1e-3")
    _, expected = flown(given)
    _, found = flown(ideal(scenario("rigid", move((1.5, 1.0, -1.2), law), head="arrive_within = 1e-3")))
    steps = min(len(expected), len(found)) - 5  # the ends may differ by a few steps
    assert steps > 300
    assert np.abs(found[:steps] - expected[:steps]).max() < 2e-4


@pytest.mark.parametrize("mode", ["ORB UNL", "END EFF", "ORB LD", "PL", "SINGLE", "DIRECT"])
def test_ideal_servos_follow_the_sticks(mode: str) -> None:
    sticks = "translation = [0.5, -0.3, 0.2]\nrotation = [0.2, 0.3, -0.1]"
    if mode in ("SINGLE", "DIRECT"):
        sticks = "joint = 'elbow_pitch'\ndrive = 0.7"
    body = f"[[phase]]\nmode = '{mode}'\n{sticks}\nduration = '6 s'\n"
    body += "[[phase]]\nmode = 'ORB UNL'\nduration = '4 s'\n"
    pounds = 5000.0 if mode in ("ORB LD", "PL") else 0.0
    _, expected = flown(scenario("kinematic", body, pounds=pounds))
    _, found = flown(ideal(scenario("rigid", body, pounds=pounds)))
    assert np.abs(found - expected).max() < (1e-3 if mode == "DIRECT" else 2e-4)


def test_ideal_servos_follow_the_master_arm() -> None:
    tips = []
    for given in (scenario("kinematic", head="mode = 'MASTER'"), ideal(scenario("rigid", head="mode = 'MASTER'"))):
        sim, found = Simulation(given), []
        for step in range(400):
            turned = tuple((AT_BAY + 0.02 * np.sin(0.01 * step)).tolist())
            frame = sim.step(Inputs(master=turned))
            found.append(frame.position if frame.dynamics is None else frame.dynamics.position)
        tips.append(np.array(found))
    assert np.ptp(tips[0], axis=0).max() > 0.05
    assert np.abs(tips[1] - tips[0]).max() < 1e-3


@pytest.mark.parametrize(
    ("plant", "pounds", "within", "angle"),
    [("rigid", 0.0, 5e-3, 0.05), ("flexible", 0.0, 25e-3, 0.2), ("rigid", 5000.0, 10e-3, 0.05)],
)
def test_mode_2_reaches_its_target_through_the_servos(plant: str, pounds: float, within: float, angle: float) -> None:
    sim, _ = flown(scenario(plant, move((1.2, 0.8, -0.9)), pounds=pounds))
    frame = sim.look()
    assert sim.ended == "completed"
    assert frame.dynamics is not None and frame.dynamics.miss is not None
    assert frame.dynamics.miss[0] < within
    assert math.degrees(frame.dynamics.miss[1]) < angle
    assert frame.goal is not None and frame.goal.distance < 5e-3  # by encoder


def test_tip_of_a_rigid_arm_is_where_its_encoders_place_it_and_that_of_a_flexible_one_is_not() -> None:
    apart = {}
    for plant in ("rigid", "flexible"):
        sim, most = Simulation(scenario(plant, head="mode = 'ORB UNL'")), 0.0
        for step in range(400):
            frame = sim.step(Inputs(translation=(1.0, 0.5, -0.5)) if step < 250 else Inputs())
            assert frame.dynamics is not None
            most = max(most, math.dist(frame.position, frame.dynamics.position))
        apart[plant] = most
    assert apart["rigid"] < 3e-3  # steps of the encoders
    assert 0.01 < apart["flexible"] < 0.2


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_momentum_of_arm_and_orbiter_stays_zero(plant: str) -> None:
    sim = Simulation(scenario(plant, orbiter="free", pounds=15_000.0))
    translational, angular, of_payload = [], [], []
    for step in range(3000):
        sim.advance(STICKS if step < 2000 else Inputs())
        if step % 20 == 0:
            view = present(sim)
            mujoco.mj_subtreeVel(view.model, view.data)
            translational.append(view.data.subtree_linvel[0] * view.model.body_subtreemass[0])
            angular.append(view.data.subtree_angmom[0].copy())
            of_payload.append(_momentum(view))
    frame = sim.look()
    assert frame.dynamics is not None
    assert math.dist(frame.dynamics.orbiter.position, (0.0, 0.0, 0.0)) > 0.01  # the orbiter reacts
    assert np.abs(translational).max() < 0.02
    assert np.abs(angular).max() < 1e-4 * np.abs(of_payload).max()


def test_exact_integrator_keeps_the_momentum_to_rounding() -> None:
    """Runge-Kutta steps of 1 ms, without dry friction and torque limits: the loss of the live integrator is its own."""
    sim = Simulation(scenario("rigid", orbiter="free", pounds=15_000.0))
    view = present(sim)
    view.model.dof_frictionloss[:], view.model.actuator_forcelimited[:] = 0.0, False
    view.model.opt.integrator, view.model.opt.timestep = mujoco.mjtIntegrator.mjINT_RK4, 1e-3
    largest = 0.0
    for second in range(60):
        for joint, rate in zip("012345", (0.004, -0.005, 0.006, 0.01, -0.01, 0.02), strict=True):
            view.data.ctrl[int(joint)] = rate if second < 40 else 0.0
        mujoco.mj_step(view.model, view.data, nstep=1000)
        mujoco.mj_subtreeVel(view.model, view.data)
        largest = max(largest, float(np.abs(_momentum(view)).max()))
        linear = view.data.subtree_linvel[0] * view.model.body_subtreemass[0]
    assert largest > 100.0
    assert np.abs(view.data.subtree_angmom[0]).max() < 1e-9 * largest
    assert np.abs(linear).max() < 1e-9 * view.model.body_subtreemass[0]


def _momentum(view: View) -> Array:
    """Return the payload's angular momentum about the world's origin [N m s]."""
    data, body = view.data, view.model.body("payload").id
    momentum: Array = view.model.body_mass[body] * np.cross(data.xipos[body], data.subtree_linvel[body])
    return momentum


def test_centre_of_mass_of_the_whole_system_does_not_move() -> None:
    sim = Simulation(scenario("rigid", orbiter="free"))
    before = present(sim).data.subtree_com[0].copy()
    for _ in range(1000):
        sim.advance(STICKS)
    assert np.abs(present(sim).data.subtree_com[0] - before).max() < 1e-4


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_brakes_hold_up_to_their_torque_and_slip_above_it(plant: str) -> None:
    sim = Simulation(scenario(plant, initial=RAISED))
    sim.step(Inputs(brakes=True))
    angles = np.array(sim.step().angles)
    push(sim, np.array([0.0, 40.0, 0.0]))
    for _ in range(500):
        frame = sim.step(Inputs())
    held = np.abs(np.array(frame.angles) - angles)
    assert held.max() < math.radians(0.1)
    assert frame.dynamics is not None and frame.dynamics.overdriven == ()
    push(sim, np.array([0.0, 400.0, 0.0]))
    slipped = False
    for _ in range(100):
        frame = sim.step(Inputs())
        assert frame.dynamics is not None
        slipped = slipped or 0 in frame.dynamics.overdriven
    assert slipped
    assert abs(frame.angles[0] - angles[0]) > math.radians(1.0)


def test_energy_never_grows_with_the_brakes_on() -> None:
    sim = Simulation(scenario("flexible", initial=RAISED, pounds=32_000.0))
    sim.step(Inputs(brakes=True))
    push(sim, np.array([0.0, 30.0, 30.0]))
    for _ in range(100):
        sim.step(Inputs())
    push(sim, np.zeros(3))
    energy = [_energy(sim)]
    for _ in range(500):
        sim.step(Inputs())
        energy.append(_energy(sim))
    assert energy[0] > 0.1
    assert np.diff(energy).max() < 1e-6 * energy[0]


def _energy(sim: Simulation) -> float:
    """Return kinetic energy, and potential energy of springs, brakes and the friction that does not slip [J]."""
    view = present(sim)
    model, data = view.model, view.data
    mass = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, mass)
    springs = 0.5 * float((model.jnt_stiffness.reshape(model.njnt, -1)[:, 0] * data.qpos**2).sum())
    deflected = model.actuator_actadr >= 0
    stiffness, deflection = model.actuator_dynprm[deflected, 5], data.act[model.actuator_actadr[deflected]]
    return 0.5 * float(data.qvel @ mass @ data.qvel) + springs + 0.5 * float(stiffness @ deflection**2)


def test_joint_gives_way_where_its_load_exceeds_the_torque_limit() -> None:
    turned = {}
    for share in (0.9, 1.2):
        sim = Simulation(scenario("rigid", initial=RAISED))
        sim.step()
        _, view, _ = parts(sim)
        lever = float(np.linalg.norm(view.data.xipos[view.model.body("arm.wrist_roll").id][:2]))
        servo = sim.scenario.arm.model.servo
        assert servo is not None
        before = sim.step().angles[0]
        push(sim, np.array([0.0, share * float(servo.torque_limit[0] + servo.friction[0]) / lever, 0.0]))
        driven = False
        for _ in range(250):
            frame = sim.step(Inputs())
            assert frame.dynamics is not None
            driven = driven or 0 in frame.dynamics.overdriven
        turned[share] = (driven, abs(frame.angles[0] - before))
    assert turned[0.9][0] is False
    assert turned[1.2][0] is True
    assert turned[1.2][1] > 3 * turned[0.9][1]


@pytest.mark.slow
@pytest.mark.parametrize("pounds", [5_000.0, 15_000.0, 32_000.0, 65_000.0])
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_loaded_arm_stops_within_two_feet_from_its_permitted_rate(plant: str, pounds: float) -> None:
    assert 0.2 < stop(plant, pounds, "stretched", 0.0) < 2 * 0.3048


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_saved_state_continues_exactly(plant: str) -> None:
    given = scenario(plant, move((1.0, 0.5, -0.5)), pounds=5000.0, orbiter="free")
    sim = Simulation(given)
    for _ in range(200):
        sim.advance()
    saved = sim.save()
    expected = [sim.step().sha256 for _ in range(200)]
    other = Simulation(given)
    other.restore(saved)
    assert [other.step().sha256 for _ in range(200)] == expected
    again = Simulation(given)
    assert [again.step().sha256 for _ in range(400)][200:] == expected


def test_script_attaches_and_detaches_a_payload() -> None:
    up = "translation = [0.0, 0.0, -1.0]\nduration = '10 s'\n"
    given = scenario(
        "flexible",
        f"[[phase]]\nmode = 'ORB UNL'\n{up}[[phase]]\nmode = 'ORB UNL'\npayload = {{ mass = '15000 lb' }}\n{up}"
        f"[[phase]]\nmode = 'ORB UNL'\ndetached = true\n{up}",
    )
    sim, _ = flown(given)
    assert sim.ended == "completed"
    plant = parts(sim)[0]
    views = [one.view for one in (*plant._apart, *plant._near)]
    masses = [view.model.body_mass[view.model.body("payload").id] for view in views]
    assert masses == pytest.approx(2 * [0.0, 15_000 * 0.45359237])
    assert len({view.model.nv for view in views}) == 1


def test_state_with_other_bodies_is_rejected() -> None:
    given = scenario("rigid")
    sim = Simulation(given)
    sim.step()
    saved = sim.save()
    _, _, bodies = parts(sim)
    bodies.physics = bodies.physics[:-1].copy()
    with pytest.raises(InputError, match="size"):
        Simulation(given).restore(msgspec.structs.replace(saved, state=sim.save().state))
    sim._state.plant.bodies = None
    with pytest.raises(InputError, match="size"):
        Simulation(given).restore(sim.save())
    Simulation(given).restore(saved)


@pytest.mark.slow
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_recording_is_replayed_to_the_last_bit(plant: str, tmp_path: Path) -> None:
    given = aftdeck.load_scenario("loaded", {("plant",): plant, ("duration",): 12.0, ("phase",): []})
    flown_steps = 0

    def sticks(_: Simulation) -> Inputs | None:
        nonlocal flown_steps
        flown_steps += 1
        return Inputs(translation=(0.0, 0.0, -1.0), brakes=flown_steps > 300) if flown_steps <= 400 else None

    record(given, tmp_path / "a.mcap", inputs=sticks)
    verdict = verify(tmp_path / "a.mcap")
    assert verdict.equal and verdict.whole
    assert verdict.frames == 400


def test_diverging_model_ends_a_script_with_a_fault_and_is_an_error_for_an_operator(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    given = scenario("flexible", move((1.0, 0.5, -0.5)))
    done = None
    for operated in (False, True):
        sim = _diverging(given)
        if operated:
            with pytest.raises(SimulationError, match="diverged"):
                for _ in range(500):
                    sim.advance(STICKS)
        else:
            while not sim.ended:
                done = sim.step()
    assert done is not None
    assert sim.ended == "" and done.events[-1].kind == "fault"
    assert all(map(math.isfinite, done.angles))
    assert list(tmp_path.iterdir()) == []


def _diverging(given: Scenario) -> Simulation:
    """Return a simulation whose flexible model is not stable: its springs are too stiff for its steps."""
    sim = Simulation(given)
    _, view, _ = parts(sim)
    view.model.jnt_stiffness[:] *= 1e4
    return sim


def test_kinematic_run_and_its_station_import_no_mujoco() -> None:
    code = (
        "import sys, aftdeck, aftdeck.station.server.serve, aftdeck.recording.replay\n"
        "aftdeck.Simulation('first-flight').step()\nassert 'mujoco' not in sys.modules"
    )
    done = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr


def test_concept_arm_and_its_telescope_move(tmp_path: Path) -> None:
    text = (
        "title = 'concept'\narm = 'concept-1972'\nworksite = 'concept-1972'\nplant = 'rigid'\nduration = '60 s'\n"
        "[initial]\njoints = [0.0, 0.6, -1.0, 0.0, 0.0, 0.0]\n"
    )
    path = tmp_path / "concept.toml"
    path.write_text(text)
    sim = Simulation(path)
    before = sim.step().work.stand
    for _ in range(200):
        frame = sim.step(Inputs(telescope=1.0, mode="ORB UNL", translation=(0.3, 0.0, 0.0)))
    assert before is not None and frame.work.stand is not None
    assert frame.work.stand - before == pytest.approx(200 * 0.02 * 0.3048, rel=0.05)
    assert frame.dynamics is not None
    assert math.dist(frame.position, frame.dynamics.position) < 5e-3
    assert not np.allclose(frame.angles, AT_BAY)
    for _ in range(200):
        sim.advance(Inputs(effector="close"))
    site, worksite = sim._flight.site, sim._state.worksite
    hand, prong = (worksite.frames[1 + site.arm.names.index(name)] for name in ("arm.wrist_roll", "arm.prong"))
    assert worksite.prong.position == pytest.approx(sim._flight.prong.high)
    assert prong[:3] - hand[:3] == pytest.approx(worksite.prong.position * hand[[4, 7, 10]])
