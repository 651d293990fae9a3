"""A payload that the scenario fixes in the grasp is monitored like a captured payload: it stops at the bay."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import NX, D, pack
from aftdeck.errors import ScenarioError
from aftdeck.scenario.load import load_scenario, parse_scenario
from aftdeck.scene.mesh import moved
from aftdeck.scene.placed import placed
from aftdeck.scene.solids import solid
from aftdeck.shapes import Light
from aftdeck.worksite.report import Near
from tests.simulation.flights import log_of


def heights_over(points: Array, solids: Sequence[Array]) -> Array:
    """Return the height (n,) of each point over the nearest face of the nearest solid [m]; negative inside a solid."""
    packed = np.array([pack(vertices) for vertices in solids])
    normals = packed[:, NX:D].reshape(-1, 3, 6).transpose(0, 2, 1)
    heights = np.einsum("sfk,vk->vsf", normals, points) - packed[:, D:]
    return np.asarray(heights.max(axis=2).min(axis=1))


def test_solids_enclose_drawn_payload_except_fixture() -> None:
    payload = load_scenario("loaded").payload
    assert payload is not None
    for shape, pose in placed(payload.shapes):
        if not isinstance(shape, Light) and shape.material != "metal":
            assert heights_over(moved(solid(shape, 24), pose).vertices, payload.solids).max() < 1e-9, shape


def test_monitored_solids_are_at_the_drawn_payload() -> None:
    sim = aftdeck.Simulation("loaded")
    payload = sim.scenario.payload
    assert payload is not None
    for inputs in (Inputs(), Inputs(translation=(0.0, 0.2, -1.0)), Inputs(rotation=(0.0, 0.5, 0.5))):
        for _ in range(400):
            sim.advance(inputs)
        frame = sim.look()
        assert frame.payload is not None
        centre, axes = (np.array(part) for part in frame.payload)
        points = np.array([near.point_a if near.a == "payload" else near.point_b for near in pairs(sim)])
        assert len(points) > 10
        assert heights_over((points - centre) @ axes, payload.solids) == pytest.approx(np.zeros(len(points)), abs=1e-9)


def pairs(sim: aftdeck.Simulation) -> list[Near]:
    """Return the monitored pairs of the payload; check that none of them contains the end effector that holds it."""
    found = [near for near in sim.watched() if "payload" in (near.a, near.b)]
    assert not any("end effector" in (near.a, near.b) for near in found)
    return found


def test_bay_stops_the_payload_and_lets_it_leave() -> None:
    sim = aftdeck.Simulation("loaded")
    for _ in range(15000):
        frame = sim.step(Inputs(translation=(0.0, 0.3, 1.0)))
        if frame.work.arm_inhibit:
            break
    assert frame.work.arm_inhibit and any(near.a == "payload" for near in frame.work.contacts)
    depth = min(near.clearance for near in frame.work.contacts)
    for _ in range(200):
        frame = sim.step(Inputs(translation=(0.0, 0.3, 1.0)))
        assert min(near.clearance for near in frame.work.contacts) >= depth - 1e-9
    out = [sim.step(Inputs(translation=(0.0, 0.0, -1.0))) for _ in range(300)]
    assert not out[-1].work.arm_inhibit and "ARM INHIBIT off" in log_of(out)


def test_invalid_payload_body_is_rejected_with_its_location() -> None:
    text = load_scenario("loaded").text.replace("sides = 12", "sides = 3")
    with pytest.raises(ScenarioError, match=r"payload\.body\[0\]"):
        parse_scenario(text, "test", "test.toml", Path("."))
