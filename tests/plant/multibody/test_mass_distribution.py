"""Products of inertia and centres of mass of every kind of payload, against sums over point masses."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import eigh

import aftdeck
from aftdeck.arms.masses import masses_of
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import impossible, joined, tensor
from aftdeck.errors import ScenarioError
from aftdeck.frames import endori
from aftdeck.plant.multibody.frequencies import frequencies
from aftdeck.scenario.load import parse_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.worksite.file.load import worksite_text
from tests.each import each, seeds
from tests.loaded import arm
from tests.plant.multibody.flights import AT_BAY, scenario
from tests.plant.multibody.points import Points, cloud
from tests.plant.multibody.test_payloads import bodies_of

TURN = (0.3, -0.7, 1.9)
"""Roll, pitch and yaw of an attached payload [rad]."""
OFFSET = np.array([1.0, -0.4, 2.0])
"""Vector from the tip to an attached payload's centre, in its axes [m]."""
PLACED = f"position = {OFFSET.tolist()}\nroll = {TURN[0]}\npitch = {TURN[1]}\nyaw = {TURN[2]}\n"


def compiled(model: Any, body: str) -> tuple[float, Array, Array]:
    """Return mass [kg], centre of mass (3,) [m] and tensor about it (3, 3) [kg m2] of a body, in its own axes."""
    k, rows = model.body(body).id, np.empty(9)
    mujoco.mju_quat2Mat(rows, model.body_iquat[k])
    axes = rows.reshape(3, 3)
    return float(model.body_mass[k]), model.body_ipos[k].copy(), axes @ np.diag(model.body_inertia[k]) @ axes.T


def models(sim: Simulation) -> list[Any]:
    """Return the compiled models of a run without solids."""
    plant: Any = sim._flight.plant
    return [one.view.model for one in plant._apart]


def assert_is(found: tuple[float, Array, Array], points: Points) -> None:
    mass, centre, inertia = found
    assert mass == pytest.approx(points.mass)
    assert centre == pytest.approx(points.centre)
    assert inertia == pytest.approx(points.tensor(points.centre), abs=1e-9 * float(np.trace(inertia)))


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize("table", ["[payload]", "[phase.payload]"])
@each("seed", seeds(2, 30))
def test_attached_payload_has_the_given_distribution(plant: str, table: str, seed: int) -> None:
    points = cloud(seed)
    phase = "[[phase]]\nmode = 'ORB UNL'\nduration = '1 s'\n" if "phase" in table else ""
    sim = Simulation(scenario(plant, f"{phase}{table}\n{points.toml()}{PLACED}"))
    rotation = endori(*TURN)
    moved = points._replace(places=(points.places + OFFSET) @ rotation.T)
    assert_is(compiled(models(sim)[1], "payload"), moved)


@pytest.mark.parametrize("source", ["scenario", "worksite"])
@each("seed", seeds(2, 30))
def test_payload_of_a_worksite_has_the_given_distribution(source: str, seed: int, tmp_path: Path) -> None:
    points = cloud(seed)
    listed: dict[str, object] = {"name": "payload"}
    changes: dict[tuple[str | int, ...], object] = {("plant",): "rigid", ("phase",): []}
    if source == "scenario":
        listed |= points.fields()
    else:
        _, text = worksite_text("orbiter")
        before, cargo = text.split("[[cargo]]", 1)
        own, after = cargo.split("[cargo.grapple]", 1)
        lines = [line for line in own.splitlines() if not line.startswith(("mass =", "inertia ="))]
        path = tmp_path / "own.toml"
        path.write_text("\n".join([before, "[[cargo]]", *lines, points.toml(), "[cargo.grapple]", after]))
        changes["worksite",] = str(path)
    sim = Simulation(aftdeck.load_scenario("srms-deploy", changes | {("cargo",): [listed]}))
    assert_is(compiled(models(sim)[0], "cargo.0"), points)


@each("seed", seeds(2, 20))
def test_mass_of_a_scenario_scales_the_whole_tensor(seed: int) -> None:
    points, fields = cloud(seed), cloud(seed).fields()
    tripled = {**fields, "mass": 3.0 * points.mass}
    given, heavy = (_deployed([{"name": "payload", **one}]).payloads[0] for one in (fields, tripled))
    assert heavy.inertia == pytest.approx(given.inertia), "a tensor that is given does not change with the mass"
    uniform, double = (_deployed([{"name": "payload", "mass": mass}]).payloads[0] for mass in (500.0, 1000.0))
    assert double.inertia == pytest.approx(2.0 * uniform.inertia)


def _deployed(cargo: list[dict[str, object]]) -> aftdeck.Scenario:
    return aftdeck.load_scenario("srms-deploy", {("plant",): "rigid", ("phase",): [], ("cargo",): cargo})


@each("seed", seeds(2, 20))
def test_free_payload_tumbles_about_its_centre_of_mass(seed: int) -> None:
    """Free flight by Euler's equations: the centre of mass moves straight, and momentum and energy are kept."""
    points, rng = cloud(seed), np.random.default_rng(seed)
    rates, velocity = rng.uniform(-0.06, 0.06, 3), rng.uniform(-0.02, 0.02, 3)
    start = {"position": [0.0, 0.0, 25.0], "rates": rates.tolist(), "velocity": velocity.tolist()}
    sim = Simulation(
        aftdeck.load_scenario(
            "srms-deploy",
            {
                ("plant",): "rigid",
                ("phase",): [],
                ("dynamics",): {"orbiter": "fixed"},
                ("cargo",): [{"name": "payload", **points.fields(), "start": start}],
            },
        )
    )
    inertia, centre = points.tensor(points.centre), points.centre
    first, motion = bodies_of(sim).payloads[0].copy(), bodies_of(sim).motions[0].copy()
    axes, speed = first[3:].reshape(3, 3), motion[3:]
    begin, drift = first[:3] + axes @ centre, speed + axes @ np.cross(rates, centre)
    seconds = 40.0
    for _ in range(round(seconds / sim.scenario.control_period)):
        sim.advance(Inputs())

    def euler(_: float, state: Array) -> Array:
        w, turn = state[:3], state[3:].reshape(3, 3)
        cross = np.array([[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]])
        return np.concatenate((np.linalg.solve(inertia, -np.cross(w, inertia @ w)), (turn @ cross).ravel()))

    solved = solve_ivp(euler, (0.0, seconds), [*rates, *axes.ravel()], rtol=1e-10, atol=1e-12).y[:, -1]
    found, now = bodies_of(sim).motions[0, :3], bodies_of(sim).payloads[0]
    turned = now[3:].reshape(3, 3)
    assert found == pytest.approx(solved[:3], abs=2e-3 * float(np.linalg.norm(rates)))
    assert turned == pytest.approx(solved[3:].reshape(3, 3), abs=5e-3)
    assert now[:3] + turned @ centre == pytest.approx(begin + seconds * drift, abs=2e-4)
    assert turned @ inertia @ found == pytest.approx(
        axes @ inertia @ rates, abs=2e-3 * float(np.linalg.norm(inertia @ rates))
    )
    assert found @ inertia @ found == pytest.approx(rates @ inertia @ rates, rel=2e-3)


@each("seed", seeds(2, 20))
def test_frequencies_of_a_stiff_arm_are_those_of_one_body_on_the_springs_of_its_base(seed: int) -> None:
    points, model = cloud(seed, mass=9000.0), arm("srms").model
    springs = model.flexibility
    assert springs is not None
    stiff = replace(
        model,
        flexibility=springs._replace(
            gearboxes=np.full(6, 1e9), bending=np.full(2, 1e10), torsion=np.full(2, 1e10), base=1e-3 * springs.base
        ),
    )
    given = scenario("rigid", f"[payload]\n{points.toml()}{PLACED}").payload
    assert given is not None
    sim = Simulation(scenario("rigid"))
    whole = []
    masses, frames = masses_of(model), bodies_of(sim).frames
    for row, frame in enumerate(model.frames[1:], start=1):
        own = [masses.bodies[frame]] if frame in masses.bodies else []
        for body in own + [boom.whole() for boom in masses.booms if boom.frame == frame]:
            turn = frames[row, 3:].reshape(3, 3)
            whole.append(
                body._replace(centre=frames[row, :3] + turn @ body.centre, inertia=turn @ body.inertia @ turn.T)
            )
    tip = arm("srms").forward(AT_BAY)
    places = tip.position + (points.places + OFFSET) @ (tip.rotation @ endori(*TURN)).T
    carried = points._replace(places=places)
    body = joined(whole)
    about = body.inertia + body.mass * (body.centre @ body.centre * np.eye(3) - np.outer(body.centre, body.centre))
    squares = eigh(1e-3 * np.diag(springs.base), about + carried.tensor(np.zeros(3)), eigvals_only=True)
    found = frequencies(stiff, AT_BAY, payload=given.properties)[:3]
    assert found == pytest.approx(np.sqrt(squares) / (2.0 * np.pi), rel=1e-3)


def test_turned_flat_plate_can_be_flown() -> None:
    """A plate is the limit of what a body can be, and its principal moments are known only up to rounding."""
    axes = endori(*TURN)
    i = axes @ np.diag([100.0, 250.0, 350.0]) @ axes.T
    products = [float(i[0, 1]), float(i[0, 2]), float(i[1, 2])]
    body = f"[payload]\nmass = 50\ninertia = {np.diag(i).tolist()}\nproducts = {products}\n{PLACED}"
    sim = Simulation(scenario("rigid", body))
    sim.advance(Inputs())
    assert np.linalg.eigvalsh(compiled(models(sim)[1], "payload")[2]) == pytest.approx([100.0, 250.0, 350.0], rel=1e-6)


@each("seed", seeds(30, 1000))
def test_tensor_is_possible_if_its_principal_moments_are(seed: int) -> None:
    rng = np.random.default_rng(seed)
    principal = rng.uniform(-0.3, 1.0, 3) * 10.0 ** rng.uniform(-3.0, 6.0)
    axes = endori(*rng.uniform(-3.0, 3.0, 3))
    i = axes @ np.diag(principal) @ axes.T
    least, middle, greatest = np.sort(principal)
    found = impossible(tensor(np.diag(i).tolist(), [i[0, 1], i[0, 2], i[1, 2]]))
    assert (found == "") == bool(least > 0.0 and greatest <= least + middle)


@pytest.mark.parametrize(
    ("lines", "where"),
    [
        ("inertia = [100, 200, 250]\nproducts = [150, 0, 0]", "inertia"),
        ("inertia = [100, 200, 250]\nproducts = [80, 60, 0]", "inertia"),
        ("products = [1, 0, 0]", "inertia"),
        ("inertia = [100, 200, 250]\nproducts = [0, 0, '1 kg']", "products"),
        ("centre_of_mass = [0, 2000, 0]", "centre_of_mass"),
    ],
)
@pytest.mark.parametrize("table", ["payload", "cargo"])
def test_impossible_distribution_is_rejected_with_its_place(lines: str, where: str, table: str) -> None:
    head = "[payload]\nmass = 10\n" if table == "payload" else "[[cargo]]\nname = 'payload'\nmass = 10\n"
    text = f"title = 't'\nplant = 'rigid'\n[initial]\njoints = {AT_BAY.tolist()}\n{head}{lines}\n"
    with pytest.raises(ScenarioError, match=rf"a\.toml:\d+: {table}(\[0\])?\.{where}"):
        parse_scenario(text, "a", "a.toml", Path())
