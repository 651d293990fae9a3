"""Disturbances: impulse and change of momentum, work and energy, times and axes, records and restored states."""

from __future__ import annotations

import itertools
import math
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.bodies.pose import pose_of
from aftdeck.errors import InputError, ScenarioError
from aftdeck.frames import endori
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.recording.run import record
from aftdeck.report.series import series_of
from aftdeck.scenario.disturbance import Disturbance
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Run, Simulation, run
from tests import loaded
from tests.each import each, seeds
from tests.plant.multibody.flights import scenario
from tests.plant.multibody.points import cloud
from tests.plant.multibody.test_payloads import bodies_of

FAR = {"position": [0.0, 0.0, 25.0]}
"""Start of a free payload that touches nothing."""
KINDS = ("tip", "orbiter", "own payload", "worksite's payload")


def given(plant: str, kind: str, lines: str = "", *, period: float = 0.02, orbiter: str = "free") -> Scenario:
    """Return a scenario in which a body of some kind can be disturbed; the arm's servos only hold it."""
    head = f"control_period = {period}\n{lines}"
    if kind == "worksite's payload":
        points = cloud(1).toml()
        text = (
            f"title = 't'\nplant = '{plant}'\nduration = '60 s'\n{head}\n[dynamics]\norbiter = '{orbiter}'\n"
            f"[initial]\njoints = {loaded.scenario('loaded').initial_angles.tolist()}\n"
            f"[[cargo]]\nname = 'payload'\nstart = {{ position = {FAR['position']} }}\n{points}"
        )
        return parse_scenario(text, "disturbed", "disturbed.toml", Path())
    body = f"[payload]\n{cloud(1).toml()}" if kind == "own payload" else ""
    return scenario(plant, body, orbiter=orbiter, worksite="space", head=head)


def planned(on: str, begin: float, duration: float, **fields: object) -> str:
    """Return the value of a scenario's key `disturbance`."""
    table = {"on": on, "begin": begin, "duration": duration, **fields}
    return f"disturbance = [{{ {', '.join(f'{key} = {value!r}' for key, value in table.items())} }}]\n"


def name_of(kind: str) -> str:
    return "payload" if "payload" in kind else kind


def momentum(sim: Simulation) -> tuple[Array, Array, float]:
    """Return momentum [N s], angular momentum about space's origin [N m s] and energy [J] of all bodies."""
    plant: Any = sim._flight.plant
    view = plant._apart[sim._state.script.attached].view
    model, data = view.model, mujoco.MjData(view.model)
    mujoco.mj_setState(model, data, bodies_of(sim).physics, mujoco.mjtState.mjSTATE_INTEGRATION)
    mujoco.mj_forward(model, data)
    mujoco.mj_energyVel(model, data)
    linear, angular, velocity = np.zeros(3), np.zeros(3), np.zeros(6)
    for body in range(1, model.nbody):
        mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_BODY, body, velocity, 0)
        place, axes = data.xipos[body], data.ximat[body].reshape(3, 3)
        spin, own = velocity[:3], model.body_mass[body] * velocity[3:]  # of the centre of mass
        linear += own
        angular += np.cross(place, own) + axes @ np.diag(model.body_inertia[body]) @ axes.T @ spin
    return linear, angular, float(data.energy[1])


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
    return pose.position + pose.rotation @ sim.scenario.cargo[0].centre_of_mass, pose.rotation


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
    pose, cargo = pose_of(body.payloads[0]), sim.scenario.cargo[0]
    velocity = body.motions[0, 3:] + pose.rotation @ np.cross(body.motions[0, :3], cargo.centre_of_mass)
    assert cargo.mass * velocity == pytest.approx([50.0 * duration, 0.0, 0.0], rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("by", ["script", "hand", "inputs"])
def test_disturbance_acts_whoever_flies_and_is_the_same_as_an_input(kind: str, by: str) -> None:
    one = Disturbance(name_of(kind), (5.0, -8.0, 3.0), (1.0, 2.0, 3.0), "L", (0.1, 0.2, 0.3))
    lines = planned(one.on, 0.2, 0.3, force=list(one.force), torque=list(one.torque), frame="L", at=list(one.at or ()))
    plain = Simulation(given("flexible", kind, lines))
    other = Simulation(given("flexible", kind, "" if by == "inputs" else lines))
    for n in range(40):
        plain.advance(Inputs())
        if by == "script":
            other.advance()
        else:
            other.advance(Inputs(disturbances=(one,) if by == "inputs" and 10 <= n < 25 else ()))
        a, b = plain.look().dynamics, other.look().dynamics
        assert a is not None and b is not None
        assert a.disturbances == b.disturbances and bool(a.disturbances) == (10 <= n < 25)
        assert np.array_equal(bodies_of(plain).physics, bodies_of(other).physics) or by == "script"


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
@pytest.mark.parametrize("kind", KINDS)
def test_state_saved_during_a_disturbance_continues_to_the_last_bit(plant: str, kind: str) -> None:
    fields = {"force": [3.0, 4.0, -5.0], "torque": [1.0, 0.0, 2.0], "at": [0.1, 0.0, 0.0]}
    sim = Simulation(given(plant, kind, planned(name_of(kind), 0.1, 0.517, **fields)))
    extra = Disturbance("tip", (0.0, 2.0, 0.0), frame="tip")
    for n in range(20):
        sim.advance(Inputs(disturbances=(extra,) if n > 10 else ()))
    other = Simulation(sim.scenario)
    for _ in range(7):  # its workspace is elsewhere
        other.advance(Inputs(mode="ORB UNL", translation=(1.0, 0.0, 0.0)))
    other.restore(sim.save())
    for n in range(30):
        inputs = Inputs(disturbances=(extra,) if n % 3 else ())
        assert sim.step(inputs) == other.step(inputs)
    assert sim.save() == other.save()


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


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize("kind", KINDS)
@each("seed", seeds(1, 10))
def test_recorded_run_with_disturbances_repeats_exactly(plant: str, kind: str, seed: int, tmp_path: Path) -> None:
    rng = np.random.default_rng(seed)
    lines = planned(name_of(kind), 0.11, 0.77, force=(10.0 * rng.uniform(-1.0, 1.0, 3)).tolist(), frame="tip")
    noise = rng.uniform(-3.0, 3.0, (60, 6))

    def hand(sim: Simulation) -> Inputs | None:
        n = 0 if sim.frame is None else sim.frame.tick
        if n >= len(noise):
            return None
        force, torque = tuple(noise[n, :3].tolist()), tuple(noise[n, 3:].tolist())
        return Inputs(disturbances=(Disturbance("tip", force, torque, "space", (0.1, 0.0, 0.0)),) if n > 5 else ())

    file = tmp_path / "run.mcap"
    made = given(plant, kind, lines)
    record(made, file, inputs=hand)
    verdict = verify(file)
    assert verdict.equal and verdict.whole and verdict.frames == len(noise), verdict
    table, recorded = run(made, inputs=hand).table("disturbances"), series_of(Recording(file), ("disturbances",))
    assert list(table) == list(recorded)
    for column in table:
        assert np.asarray(recorded[column]) == pytest.approx(np.asarray(table[column]), abs=1.1e-3)
    assert np.abs(table["tip_disturbing_torque_x_n_m"]).max() > 0.1


def test_history_adds_up_what_acts_on_a_body() -> None:
    text = planned("payload", 0.0, 1.0, force=[1.0, 2.0, 3.0], torque=[4.0, 0.0, 0.0], frame="L")
    sim = Simulation(given("rigid", "worksite's payload", text))

    def hand(now: Simulation) -> Inputs | None:
        tick = 0 if now.frame is None else now.frame.tick
        return Inputs(disturbances=(Disturbance("payload", (10.0, 0.0, 0.0), frame="L"),)) if tick < 5 else None

    table = run(sim.scenario, inputs=hand).table("disturbances")
    assert np.asarray(table["payload_1_disturbing_force_x_n"]) == pytest.approx(11.0)
    assert np.asarray(table["payload_1_disturbing_force_y_n"]) == pytest.approx(2.0)
    assert np.asarray(table["payload_1_disturbing_torque_x_n_m"]) == pytest.approx(4.0)
    assert not np.any(table["tip_disturbing_force_x_n"])


def test_log_says_when_a_disturbance_begins_and_ends() -> None:
    done = _flown(given("rigid", "tip", planned("tip", 0.1, 0.2, force=[30.0, 0.0, 40.0])), 40)
    lines = [(event.time_s, event.text) for event in done.events if event.kind == "disturbance"]
    assert [round(time, 6) for time, _ in lines] == [0.12, 0.32]
    assert "tip" in lines[0][1] and "50 N" in lines[0][1]


def _flown(made: Scenario, steps: int) -> Run:
    def hand(sim: Simulation) -> Inputs | None:
        return Inputs() if sim.frame is None or sim.frame.tick < steps else None

    return run(made, inputs=hand)


def test_command_delay_does_not_delay_disturbances() -> None:
    push = (Disturbance("tip", (1.0, 0.0, 0.0)),)
    sim = Simulation(given("rigid", "tip", "command_delay = '0.2 s'\n"))
    shown = [sim.step(Inputs(disturbances=push if n == 3 else ())).dynamics for n in range(20)]
    assert [n for n, dynamics in enumerate(shown) if dynamics is not None and dynamics.disturbances] == [3]


@pytest.mark.parametrize(
    ("fields", "key"),
    [
        ("on = 'nothing'\nduration = 1\nforce = [1, 0, 0]", "on"),
        ("on = 'payload'\nduration = 1\nforce = [1, 0, 0]", "on"),
        ("on = 'orbiter'\nduration = 1\nforce = [1, 0, 0]", "on"),
        ("on = 'tip'\nduration = 1\nforce = [1, 0, 0]\nframe = 'scene'", "frame"),
        ("on = 'tip'\nduration = 0\nforce = [1, 0, 0]", "duration"),
        ("on = 'tip'\nduration = 1\nforce = [1e9, 0, 0]", "force"),
        ("on = 'tip'\nduration = 1\nforce = ['1 m', 0, 0]", "force"),
        ("on = 'tip'\nduration = 1", ""),
    ],
)
def test_impossible_disturbance_of_a_scenario_is_rejected_with_its_place(fields: str, key: str) -> None:
    with pytest.raises(ScenarioError, match=rf"flight\.toml:\d+: disturbance\[0\]{'.' if key else ''}{key}"):
        scenario("rigid", f"[[disturbance]]\n{fields}\n")


@pytest.mark.parametrize("name", ["loaded", "srms-berth", "concept-1972-script"])
def test_plant_without_forces_rejects_disturbances(name: str) -> None:
    one = {"on": "tip", "duration": 1.0, "force": [1.0, 0.0, 0.0]}
    changes: dict[tuple[str | int, ...], object] = {("plant",): "kinematic", ("disturbance",): [one]}
    with pytest.raises(ScenarioError, match=r"disturbance\[0\]"):
        aftdeck.load_scenario(name, changes)
    sim = Simulation(aftdeck.load_scenario(name, {("plant",): "kinematic"}))
    before = sim.save()
    with pytest.raises(InputError, match=r"^disturbances: "):
        sim.advance(Inputs(disturbances=(Disturbance("tip", (1.0, 0.0, 0.0)),)))
    assert sim.save() == before


WRONG: list[Any] = [
    Disturbance("nothing"),
    Disturbance("tip", frame="scene"),
    Disturbance("tip", (math.nan, 0.0, 0.0)),
    Disturbance("tip", torque=(1e9, 0.0, 0.0)),
    Disturbance("tip", at=(1e9, 0.0, 0.0)),
    Disturbance("tip", ("1", 0.0, 0.0)),  # type: ignore[arg-type]
    Disturbance("tip", (1.0, 0.0)),  # type: ignore[arg-type]
    Disturbance(3),  # type: ignore[arg-type]
    "tip",
]


@pytest.mark.parametrize("wrong", WRONG)
def test_wrong_disturbance_of_the_inputs_is_rejected_and_changes_nothing(wrong: Any) -> None:
    sim = Simulation(given("rigid", "tip"))
    before = sim.save()
    with pytest.raises(InputError, match=r"^disturbances: "):
        sim.advance(Inputs(disturbances=(wrong,)))
    assert sim.save() == before


def test_numbers_of_any_type_are_flown_as_plain_ones() -> None:
    one, other = (Simulation(given("rigid", "tip")) for _ in range(2))
    odd: Any = [Disturbance(np.str_("tip"), np.array([1, 2, 3]), [0, np.float32(0.5), 0], at=np.zeros(3))]  # type: ignore[arg-type]
    plain = Inputs(disturbances=(Disturbance("tip", (1.0, 2.0, 3.0), (0.0, 0.5, 0.0), at=(0.0, 0.0, 0.0)),))
    assert one.step(Inputs(disturbances=odd)) == other.step(plain)
    assert one.given == plain


def test_own_payload_is_disturbed_only_while_it_is_attached() -> None:
    phases = "".join(
        f"[[phase]]\nmode = 'ORB UNL'\nduration = '0.2 s'\n{fields}"
        for fields in ("", "[phase.payload]\nmass = 500\n", "detached = true\n")
    )
    made = scenario("rigid", phases, head=planned("payload", 0.0, 1.0, force=[2.0, 0.0, 0.0]))
    shown = [frame.dynamics.disturbances for frame in run(made).frames if frame.dynamics]
    acts = [key for key, _ in itertools.groupby(bool(one) for one in shown)]
    assert acts == [False, True, False] and sum(map(bool, shown)) == 10
    sim = Simulation(made)
    with pytest.raises(InputError, match=r"^disturbances: .*attached"):
        sim.advance(Inputs(disturbances=(Disturbance("payload", (1.0, 0.0, 0.0)),)))


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
