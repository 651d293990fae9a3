"""Details: they stand where they are allowed, leave fixtures free, and exist for every payload."""

from __future__ import annotations

from math import pi, tau
from pathlib import Path

import numpy as np
import pytest

from aftdeck.arms.shapes import shapes_of
from aftdeck.arrays import Array
from aftdeck.details.details_of import details_of
from aftdeck.details.fittings import BEYOND
from aftdeck.details.hull import Hull, hull_of
from aftdeck.details.payload import payload_details
from aftdeck.details.satellites import KINDS
from aftdeck.details.skin import CLEAR, PROUD, Skin
from aftdeck.errors import ScenarioError
from aftdeck.frames import endori
from aftdeck.kinematics.linkage import L2
from aftdeck.matrices import product
from aftdeck.scenario.load import built_in, load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.scene.bodies import bodies_of
from aftdeck.scene.mesh import moved
from aftdeck.scene.placed import placed
from aftdeck.scene.solids import solid
from aftdeck.shapes import Axis, Box, Cylinder, Shape, Sphere, switches
from aftdeck.worksite.file.load import load_worksite
from tests import loaded
from tests.each import each, seeds

ROUNDING = 1e-6


def payloads_of(scenario: Scenario) -> dict[str, tuple[tuple[Shape, ...], float]]:
    """Return the drawn shapes and the mass of each payload of a scenario."""
    found = {cargo.name: (cargo.shapes, cargo.mass) for cargo in scenario.payloads}
    if scenario.payload is not None and scenario.payload.shapes:
        found["payload"] = scenario.payload.shapes, scenario.payload.mass
    return found


def own_frame(hull: Hull, points: Array) -> Array:
    return product(points - np.array(hull.position), endori(*hull.rotation))


def vertices(shapes: tuple[Shape, ...]) -> Array:
    return np.concatenate([moved(solid(leaf), pose).vertices for leaf, pose in placed(shapes)])


def away(hull: Hull, points: Array) -> Array:
    """Return the distance of points in the hull's frame from its axis, measured towards the nearest strip [m]."""
    if hull.curved:
        return np.asarray(np.hypot(points[:, 1], points[:, 2]))
    normals = np.array([[np.cos(strip.angle), np.sin(strip.angle)] for strip in hull.strips])
    return np.asarray((points[:, 1:] @ normals.T).max(axis=1))


def assert_in_place(shapes: tuple[Shape, ...], mass: float) -> None:
    """Assert that a payload's details are near its hull, and not over anything else that is drawn on it."""
    hull, details = hull_of(shapes), payload_details(shapes, mass)
    assert hull is not None and details
    points = own_frame(hull, vertices(details))
    assert away(hull, points).max() <= hull.distance + PROUD + ROUNDING
    assert points[:, 0].min() >= hull.ends[0] - BEYOND - ROUNDING
    assert points[:, 0].max() <= hull.ends[1] + BEYOND + ROUNDING
    for low, high in hull.fixtures:
        over = ((points > low + ROUNDING) & (points < high - ROUNDING)).all(axis=1)
        assert not (over & (away(hull, points) > hull.distance - CLEAR)).any(), (low, high)


@pytest.mark.parametrize("name", ["tutorial", "srms-deploy", "concept-1972", "free-flyer", "loaded"])
def test_details_of_built_in_payloads_leave_their_fixtures_free(name: str) -> None:
    for shapes, mass in payloads_of(loaded.scenario(name)).values():
        assert_in_place(shapes, mass)


def test_every_drawn_payload_of_a_built_in_scenario_has_details() -> None:
    for name in built_in():
        scenario = loaded.scenario(name)
        found = dict(zip((body.name for body in bodies_of(scenario)), details_of(scenario), strict=True))
        assert all(found[payload] for payload in payloads_of(scenario)), name


def test_kinds_of_spacecraft_look_different() -> None:
    hull = (Cylinder(material="blanket", length=6.0, radius=1.5),)
    looks = [payload_details(hull, kind.least + 1.0) for kind in KINDS]
    assert len({repr(look) for look in looks}) == len(KINDS) == 3


@each("seed", seeds(20, 2000))
def test_details_leave_random_fixtures_free(seed: int) -> None:
    random = np.random.default_rng(seed)
    length, radius = random.uniform(2.0, 12.0), random.uniform(0.6, 2.3)
    axis: Axis = ("x", "y", "z")[random.integers(3)]
    body: list[Shape] = [Cylinder(material="blanket", axis=axis, length=length, radius=radius)]
    turn = {"x": np.eye(3), "y": endori(0.0, 0.0, pi / 2), "z": endori(0.0, -pi / 2, 0.0)}[axis]
    for _ in range(random.integers(1, 6)):
        angle = random.uniform(0.0, tau)
        at = np.array([random.uniform(-0.45, 0.45) * length, radius * np.cos(angle), radius * np.sin(angle)])
        body.append(Sphere(material="metal", position=tuple((turn @ at).tolist()), radius=random.uniform(0.02, 0.3)))
    assert_in_place(tuple(body), random.uniform(100.0, 20e3))


def test_hull_of_a_box_has_four_strips_along_its_longest_edge() -> None:
    hull = hull_of((Box(material="foil", size=(2.0, 2.0, 5.0), position=(1.0, 2.0, 3.0)),))
    assert hull is not None and not hull.curved
    assert hull.length == pytest.approx(5.0) and hull.distance == pytest.approx(1.0)
    assert hull.position == pytest.approx((1.0, 2.0, 3.0))
    assert sorted(strip.angle % tau for strip in hull.strips) == pytest.approx([0.0, pi / 2, pi, 3 * pi / 2], abs=1e-9)
    assert [strip.half_width for strip in hull.strips] == pytest.approx([1.0] * 4)


@pytest.mark.parametrize(
    "shapes",
    [
        (),
        (Sphere(material="foil", radius=2.0),),
        (Cylinder(material="foil", length=3.0, radius=1.0, radius_end=0.5),),
        (Box(material="foil", size=(4.0, 2.0, 1.0)),),  # its sides are not equally far from its axis
        (Cylinder(material="foil", length=1.0, radius=0.3),),
    ],
)
def test_payload_of_another_form_has_no_details(shapes: tuple[Shape, ...]) -> None:
    assert payload_details(shapes, 1000.0) == ()


def test_patch_with_a_fixture_is_divided_around_it() -> None:
    fixture = Sphere(material="metal", position=(0.0, 0.0, 1.0), radius=0.1)
    hull = hull_of((Box(material="foil", size=(6.0, 2.0, 2.0)), fixture))
    assert hull is not None
    skin = Skin(hull)
    top = skin.strip(pi / 2)
    patches = list(skin.cover(top, (-2.0, 2.0), (-0.9, 0.9), "solar"))
    sizes = np.array([patch.size for patch in patches if isinstance(patch, Box)])
    area, hole = float((sizes[:, 0] * sizes[:, 1]).sum()), (2 * (0.1 + CLEAR)) ** 2
    assert 4.0 * 1.8 - 8 * hole < area <= 4.0 * 1.8 - hole
    assert len(list(skin.cover(skin.strip(-pi / 2), (-2.0, 2.0), (-0.9, 0.9), "solar"))) == 1


def test_fairings_close_the_gaps_between_the_boxes_at_every_joint() -> None:
    model = loaded.scenario("concept-1972").arm.model
    fairings = shapes_of(model).details
    for frame in model.linkage.frames[2:4]:
        reach = vertices(fairings[frame])[:, 0]
        assert reach.min() <= 0.0 and reach.max() >= model.links[L2]  # from pin to pin
    hand = vertices(fairings[model.linkage.frames[6]])[:, 0]
    assert hand.min() <= 0.0 and hand.max() <= model.linkage.tip[0] + ROUNDING


def test_fairings_leave_the_tip_and_the_fingers_free() -> None:
    model = loaded.scenario("concept-1972").arm.model
    fairings = shapes_of(model).details
    assert not fairings["arm.prong"]
    assert vertices(fairings[model.linkage.frames[6]])[:, 0].max() < model.linkage.tip[0]


def test_lamp_among_details_is_rejected_with_its_place(tmp_path: Path) -> None:
    lamp = 'details = [{ kind = "light", radius = 0.1, cone = 1.0, reach = 2.0, intensity = 3.0 }]'
    text = f'name = "s"\ntitle = "S"\norigin = [0, 0, 0]\n[[body]]\nname = "b"\nsource = "none"\n{lamp}\n'
    file = tmp_path / "s.toml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(ScenarioError, match=r"s\.toml:\d+: .*lamp"):
        load_worksite(file)


def test_details_have_no_lamps_and_are_not_among_the_shapes() -> None:
    for name in ("srms-deploy", "concept-1972"):
        scenario = load_scenario(name)
        for body, details in zip(bodies_of(scenario), details_of(scenario), strict=True):
            assert switches(details) == ()
            assert not set(map(repr, details)) & set(map(repr, body.shapes))


def test_details_are_closed_with_outward_faces() -> None:
    for shapes in details_of(loaded.scenario("srms-deploy")):
        for leaf, pose in placed(shapes):
            surface = moved(solid(leaf), pose)
            assert np.isfinite(surface.vertices).all() and len(surface.faces) > 3, leaf
