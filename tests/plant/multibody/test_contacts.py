"""Forces between parts in contact: their direction, their impulse, and what they replace."""

from __future__ import annotations

import math

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array, Indices
from aftdeck.bodies.hexahedron import unpack
from aftdeck.bodies.solid import Solid
from aftdeck.plant.multibody.contacts import _as_box
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.groups import layout_of
from aftdeck.worksite.watch.near import near_pairs
from tests.plant.multibody.test_payloads import bodies_of, momentum

MASS = 2000.0
"""Mass of the body that is thrown [kg]."""
OVER_THE_BAY = [7.3, 0.0, 3.7]
"""Place above the payload bay's floor, in the scene [m]."""


def thrown(velocity: list[float], place: list[float] = OVER_THE_BAY, period: float = 0.02) -> Simulation:
    """Return a run in which the concept's payload moves through the bay without rotation.

    Args:
        velocity: its velocity [m/s].
        place: its place at the start [m].
        period: control period [s].
    """
    start = {"position": place, "velocity": velocity}
    changes: dict[tuple[str | int, ...], object] = {
        ("plant",): "rigid",
        ("phase",): [],
        ("initialise",): {},
        ("cargo",): [{"name": "payload", "mass": MASS, "start": start}],
        ("duration",): "300 s",
        ("control_period",): period,
    }
    return Simulation(aftdeck.load_scenario("concept-1972", changes))


@pytest.fixture(scope="module")
def bounce() -> tuple[Simulation, list[Array], list[Array]]:
    """Return a run in which a free flyer falls onto the bay's floor, its momenta, and the contact's forces on it."""
    sim = thrown([0.0, 0.0, -0.2])
    momenta, forces = [MASS * bodies_of(sim).motions[0, 3:]], []
    site = sim._flight.site
    for _ in range(2500):
        sim.step(Inputs())
        total = np.zeros(3)
        for touch in bodies_of(sim).touches:
            first = site.layout.frames[site.layout.between_frames[touch.group, 0]] == "payload"
            total += np.array(touch.force) * (-1.0 if first else 1.0)
        forces.append(total)
        momenta.append(MASS * bodies_of(sim).motions[0, 3:])
    return sim, momenta, forces


def test_change_of_momentum_equals_the_impulse_of_the_reported_forces(
    bounce: tuple[Simulation, list[Array], list[Array]],
) -> None:
    _, momenta, forces = bounce
    change, impulse = momenta[-1] - momenta[0], 0.02 * np.sum(forces, axis=0)
    assert float(np.linalg.norm(change)) > 0.2 * MASS  # it bounced, or at least stopped
    assert impulse == pytest.approx(change, abs=0.01 * float(np.linalg.norm(change)))


def test_contact_takes_energy_and_keeps_the_momentum_of_all_bodies() -> None:
    sim = thrown([0.0, 0.0, -0.2])
    linear, angular = momentum(sim)
    for _ in range(2000):
        sim.step(Inputs())
    after_linear, after_angular = momentum(sim)
    assert bodies_of(sim).motions[0, 5] > -0.2 + 0.05
    assert float(np.linalg.norm(bodies_of(sim).motions[0, 3:])) < 0.2
    assert after_linear == pytest.approx(linear, abs=1e-4 * float(np.linalg.norm(linear)))
    assert after_angular == pytest.approx(angular, abs=1e-3 * float(np.linalg.norm(angular)))


def test_thrown_body_does_not_pass_the_floor_and_its_contact_is_named_with_its_force(
    bounce: tuple[Simulation, list[Array], list[Array]],
) -> None:
    sim = thrown([0.0, 0.0, -0.2])
    deepest, named, lines = math.inf, set(), []
    for _ in range(2500):
        frame = sim.step(Inputs())
        assert frame.dynamics is not None
        named |= {frozenset((force.a, force.b)) for force in frame.dynamics.contacts}
        if frame.work.nearest is not None:
            deepest = min(deepest, frame.work.nearest.clearance)
        lines += [event.text for event in frame.events if event.kind == "contact" and "greatest force" in event.text]
        assert not frame.work.arm_inhibit
    assert deepest > -0.03
    assert any("payload" in pair for pair in named)
    assert lines


def against_the_cabin(inhibit: bool) -> tuple[Simulation, list[float], list[bool]]:
    """Fly the Shuttle's end effector against the orbiter; return the run, the contact's force, and ARM INHIBIT."""
    changes: dict[tuple[str | int, ...], object] = {
        ("plant",): "rigid",
        ("phase",): [],
        ("cargo",): [],
        ("step",): [],
        ("duration",): "300 s",
        ("dynamics", "inhibit"): inhibit,
    }
    sim = Simulation(aftdeck.load_scenario("srms-deploy", changes))
    forces, inhibits = [], []
    for _ in range(1500):
        frame = sim.step(Inputs(mode="ORB UNL", translation=(0.0, 0.0, 1.0)))
        assert frame.dynamics is not None
        forces.append(sum(math.dist(one.force, (0, 0, 0)) for one in frame.dynamics.contacts))
        inhibits.append(frame.work.arm_inhibit)
    return sim, forces, inhibits


@pytest.mark.slow
def test_arm_pushes_with_no_more_than_its_motors_and_is_inhibited_only_if_asked() -> None:
    sim, forces, inhibits = against_the_cabin(inhibit=False)
    assert not any(inhibits)
    assert 20.0 < forces[-1] < 3000.0
    assert sim._state.worksite.watch.found[:, CLEARANCE].min() > -0.05
    _, _, asked = against_the_cabin(inhibit=True)
    assert any(asked)


def test_saved_run_continues_to_the_last_bit_in_contact() -> None:
    sim = thrown([0.0, 0.0, -0.2])
    while not bodies_of(sim).touches:
        sim.step(Inputs())
    other = Simulation(sim.scenario)
    other.restore(sim.save())
    for _ in range(150):
        assert sim.step(Inputs()) == other.step(Inputs())
    assert sim.save() == other.save()


def test_mean_force_of_each_step_is_its_change_of_momentum() -> None:
    sim = thrown([0.05, 0.03, -0.2])
    while not bodies_of(sim).touches:
        before = MASS * bodies_of(sim).motions[0, 3:]
        sim.step(Inputs())
    site, greatest = sim._flight.site, 0.0
    for _ in range(40):
        found = np.zeros(3)
        for touch in bodies_of(sim).touches:
            first = site.layout.frames[site.layout.between_frames[touch.group, 0]] == "payload"
            found += np.array(touch.force) * (-1.0 if first else 1.0)
            assert np.linalg.norm(touch.force) <= touch.greatest * (1.0 + 1e-9)
            greatest = max(greatest, touch.greatest)
        after = MASS * bodies_of(sim).motions[0, 3:]
        impulse = 0.02 * sim._state.plant.base[3:].reshape(3, 3) @ found
        assert impulse == pytest.approx(after - before, abs=1e-6 * MASS * 0.2)
        before = after
        sim.step(Inputs())
    assert greatest > 1000.0


def test_near_pairs_are_those_of_a_plain_search() -> None:
    rng = np.random.default_rng(4)
    cube = np.array([(v >> 1 & 1, v >> 2 & 1, v & 1) for v in range(8)]) - 0.5
    for _ in range(20):
        frames = ("orbiter", "a", "b")
        solids = [Solid(f"part {k}", frames[k % 3], cube + rng.uniform(-3, 3, 3)) for k in range(9)]
        pairs = [(f"part {i}", f"part {j}") for i in range(9) for j in range(i) if i % 3 != j % 3]
        layout = layout_of(frames, solids, pairs)
        watch = ClearanceMonitor(layout)
        poses = np.tile([0.0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], (3, 1))
        watch.update(poses)
        watch.active[rng.integers(len(layout.groups))] = 0
        near = np.zeros((200, 3), dtype=np.int64)
        count = near_of(watch, poses, poses, near)
        expected = set()
        for g in range(len(layout.groups)):
            if watch.active[g] and watch.found[g, CLEARANCE] < 0.3:
                for i, j in layout.pairs[layout.begins[g] : layout.begins[g + 1]].tolist():
                    if _gap(unpack(layout.solids[i]), unpack(layout.solids[j])) < 0.3:
                        expected.add((g, i, j))
        assert {tuple(row) for row in near[:count].tolist()} == expected
        assert near_of(watch, poses, poses, near[:1]) == count


def near_of(watch: ClearanceMonitor, before: Array, now: Array, near: Indices, period: float = 0.02) -> int:
    """Find the pairs that are nearer than 0.3 m and their way in one period."""
    layout = watch.layout
    return near_pairs(
        watch.active, watch.found, 0.3, period, before, now, layout.reach, layout.frame,
        layout.begins, layout.pairs, watch.placed, near,
    )  # fmt: skip


def test_pairs_are_near_if_they_cover_their_distance_in_one_step() -> None:
    rng = np.random.default_rng(5)
    cube = np.array([(v >> 1 & 1, v >> 2 & 1, v & 1) for v in range(8)]) - 0.5
    layout = layout_of(("orbiter", "a", "b"), [Solid(n, n, cube) for n in ("a", "b")], [("a", "b")])
    here = np.array([0.0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1])
    for _ in range(50):
        gap, way, shared, period = (
            rng.uniform(0.31, 2.0),
            rng.uniform(-2.0, 2.0),
            rng.normal(size=3),
            rng.uniform(0.01, 1),
        )
        now, before = np.tile(here, (3, 1)), np.tile(here, (3, 1))
        now[2, 0] = 1.0 + gap
        before[1:, :3] = now[1:, :3] - shared  # a motion of both parts together does not bring them nearer
        before[2, 0] -= way
        watch = ClearanceMonitor(layout)
        watch.update(now)
        near = np.zeros((1, 3), dtype=np.int64)
        assert near_of(watch, before, now, near, period) == (gap < 0.3 + abs(way))


def _gap(a: Array, b: Array) -> float:
    """Return the distance of two boxes along the same axes, from their vertices [m]."""
    apart = np.maximum(np.maximum(a.min(axis=0) - b.max(axis=0), b.min(axis=0) - a.max(axis=0)), 0.0)
    return float(np.linalg.norm(apart))


def test_boxes_are_recognised_and_other_hexahedra_are_not() -> None:
    rng = np.random.default_rng(7)
    numbers = np.arange(8)
    corners = np.stack([numbers >> 1 & 1, numbers >> 2 & 1, numbers & 1], axis=1) - 0.5
    for _ in range(20):
        turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        size, place = rng.uniform(0.1, 5.0, 3), rng.normal(size=3)
        box = _as_box((corners * size) @ turn.T + place)
        assert box is not None
        assert box["pos"] == pytest.approx(place)
        assert sorted(box["size"]) == pytest.approx(sorted(size / 2))
        assert _as_box((corners * size * (1.0 + 0.1 * corners[:, :1])) @ turn.T) is None
