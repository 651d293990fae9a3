from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.arms.shapes import shapes_of
from aftdeck.scenario.load import load_scenario
from aftdeck.scene.mesh import area, joined, moved, volume
from aftdeck.scene.placed import Leaf, placed
from aftdeck.scene.solids import solid
from aftdeck.shapes import (
    Axis,
    Box,
    Cylinder,
    Group,
    Hexahedron,
    Light,
    Loft,
    Plate,
    Ring,
    Section,
    Shape,
    Shell,
    Sphere,
)
from tests.scene.surfaces import closed

PI = math.pi
HULL = (
    Section(x=0.0, half_width=1.0, top=2.0, middle=0.5, bottom=0.0),
    Section(x=3.0, half_width=1.0, top=2.0, middle=0.5, bottom=0.0),
)
EDGED = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0))
"""Outline of an L, with an area of 4 and a perimeter of 10."""

ROUND: list[tuple[Leaf, float, float]] = [
    (Cylinder(material="metal", length=2.0, radius=0.5), PI * 0.5, PI * 2.5),
    (
        Cylinder(material="metal", axis="z", length=3.0, radius=2.0, radius_end=1.0),
        PI * 7.0,
        PI * (5.0 + 3.0 * math.sqrt(10.0)),
    ),
    (Sphere(material="metal", radius=0.7), 4.0 / 3.0 * PI * 0.343, 4.0 * PI * 0.49),
    (Shell(material="metal", length=2.0, radius=1.5, thickness=0.5), PI * 2.5, PI * 12.5),
    (Shell(material="metal", length=2.0, radius=1.5, thickness=0.5, start=0.4, sweep=2.0), 2.5, 6.0 + 4.0 + 2.5 + 2.0),
    (
        Shell(material="metal", length=0.1, radius=1.5, thickness=1.5, start=0.4, sweep=2.0),
        0.225,
        2.0 * 1.5**2 + 0.3 + 0.3,
    ),
    (Shell(material="metal", length=0.1, radius=1.5, thickness=1.5), PI * 0.225, PI * (4.5 + 0.3)),
    (Ring(material="metal", axis="y", radius=1.2, bar=0.2), 2.0 * PI**2 * 0.048, 4.0 * PI**2 * 0.24),
    (
        Ring(material="metal", radius=1.2, bar=0.2, start=0.4, sweep=2.0),
        2.0 * PI * 0.048,
        2.4 * PI * 0.4 + 2.0 * PI * 0.04,
    ),
    (Loft(material="metal", sections=HULL), 1.5 * PI * 2.0, math.nan),
]
"""Shapes with their volumes [m^3] and areas [m^2] in closed form."""

WEDGE = tuple((x, y * (1.5 if z else 1.0), z) for y in (-0.5, 0.5) for x in (0.0, 1.8) for z in (0.0, 1.0))
"""A wedge 1.8 m long and 1 m high, 1 m wide at the bottom and 1.5 m at the top."""
CORNERED: list[tuple[Leaf, float, float]] = [
    (Box(material="metal", size=(1.0, 2.0, 3.0)), 6.0, 22.0),
    (Hexahedron(material="metal", vertices=WEDGE), 2.25, 7.0 + 3.6 * 1.0625**0.5),
    (Plate(material="metal", normal="x", outline=EDGED, thickness=0.5), 2.0, 13.0),
    (Plate(material="metal", normal="y", outline=EDGED, thickness=0.5), 2.0, 13.0),
    (Plate(material="metal", normal="z", outline=EDGED[::-1], thickness=0.5), 2.0, 13.0),
]


@pytest.mark.parametrize(("shape", "holds", "shows"), ROUND)
def test_round_surface_is_closed_and_converges_with_more_sides(shape: Leaf, holds: float, shows: float) -> None:
    surfaces = [solid(shape, sides) for sides in (32, 256)]
    assert all(closed(surface) for surface in surfaces)
    misses = [abs(volume(surface) - holds) for surface in surfaces]
    assert misses[0] > 40.0 * misses[1], "the error is of second order: it becomes about 64 times smaller"
    assert volume(surfaces[-1]) == pytest.approx(holds, rel=0.002)
    if not math.isnan(shows):
        assert area(surfaces[-1]) == pytest.approx(shows, rel=0.002)


@pytest.mark.parametrize(("shape", "holds", "shows"), CORNERED)
def test_cornered_surface_is_closed_and_exact(shape: Leaf, holds: float, shows: float) -> None:
    surface = solid(shape)
    assert closed(surface)
    assert volume(surface) == pytest.approx(holds)
    assert area(surface) == pytest.approx(shows)


@pytest.mark.parametrize(
    ("shape", "low", "high"),
    [
        (Box(material="metal", size=(1.0, 2.0, 3.0)), (-0.5, -1.0, -1.5), (0.5, 1.0, 1.5)),
        (Cylinder(material="metal", axis="y", length=2.0, radius=0.5), (-0.5, -1.0, -0.5), (0.5, 1.0, 0.5)),
        (Sphere(material="metal", radius=2.0), (-2.0, -2.0, -2.0), (2.0, 2.0, 2.0)),
        (Ring(material="metal", axis="z", radius=1.0, bar=0.2), (-1.2, -1.2, -0.2), (1.2, 1.2, 0.2)),
        (
            Shell(material="metal", axis="x", length=2.0, radius=1.0, thickness=0.1, sweep=PI),
            (-1.0, -1.0, 0.0),
            (1.0, 1.0, 1.0),
        ),
        (Plate(material="metal", normal="x", outline=EDGED, thickness=0.5), (-0.25, 0.0, 0.0), (0.25, 2.0, 3.0)),
        (Plate(material="metal", normal="y", outline=EDGED, thickness=0.5), (0.0, -0.25, 0.0), (2.0, 0.25, 3.0)),
        (Plate(material="metal", normal="z", outline=EDGED, thickness=0.5, bevel=0.1), (0, 0, -0.25), (2, 3, 0.25)),
        (Loft(material="metal", sections=HULL), (0.0, -1.0, 0.0), (3.0, 1.0, 2.0)),
        (Light(radius=0.2, cone=1.0, reach=1.0, intensity=1.0), (0.0, -0.2, -0.2), (0.0, 0.2, 0.2)),
    ],
)
def test_surface_fills_its_bounding_box(shape: Leaf, low: tuple[float, ...], high: tuple[float, ...]) -> None:
    vertices = solid(shape, 32).vertices
    assert vertices.min(axis=0) == pytest.approx(low, abs=0.01)
    assert vertices.max(axis=0) == pytest.approx(high, abs=0.01)


@pytest.mark.parametrize(("axis", "first", "second"), [("x", 1, 2), ("y", 2, 0), ("z", 0, 1)])
def test_angles_increase_from_one_axis_to_the_next(axis: Axis, first: int, second: int) -> None:
    piece = Shell(material="metal", axis=axis, length=0.2, radius=1.0, thickness=0.1, sweep=PI / 2.0)
    middle = solid(piece, 64).vertices.mean(axis=0)
    assert middle[first] > 0.4
    assert middle[second] > 0.4
    assert middle[3 - first - second] == pytest.approx(0.0, abs=1e-12)


def test_lamp_face_points_along_its_x_axis() -> None:
    face = solid(Light(radius=0.2, cone=1.0, reach=1.0, intensity=1.0), 64)
    a, b, c = (face.vertices[face.faces[:, k]] for k in range(3))
    assert (np.cross(b - a, c - a)[:, 0] > 0.0).all()
    assert area(face) == pytest.approx(PI * 0.04, rel=0.01)


@pytest.mark.parametrize("bevel", [0.1, 0.25])
def test_bevel_removes_a_rounded_corner_from_every_rim(bevel: float) -> None:
    square = ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0))
    surface = solid(Plate(material="metal", normal="z", outline=square, thickness=0.5, bevel=bevel))
    assert closed(surface)
    # two chords replace the quarter circle, so the removed volume lies between these bounds
    off = 2.0 - volume(surface)
    rims = 2 * 8.0 * bevel**2
    assert rims * (1.0 - PI / 4.0) * 0.8 < off < rims * 0.5
    assert surface.vertices.max() == pytest.approx(2.0)


outlines = st.lists(st.floats(0.3, 3.0), min_size=3, max_size=14).map(
    lambda radii: tuple(
        (r * math.cos(math.tau * k / len(radii)), r * math.sin(math.tau * k / len(radii))) for k, r in enumerate(radii)
    )
)
"""Star-shaped outlines, with concave corners."""


@given(outline=outlines, normal=st.sampled_from(["x", "y", "z"]), clockwise=st.booleans())
def test_plate_of_any_outline_is_closed_with_exact_volume_and_area(
    outline: tuple[tuple[float, float], ...], normal: Axis, clockwise: bool
) -> None:
    x, y = np.array(outline).T
    inside = 0.5 * abs(float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)))
    given_outline = outline[::-1] if clockwise else outline
    surface = solid(Plate(material="metal", normal=normal, outline=given_outline, thickness=0.4))
    assert closed(surface)
    assert volume(surface) == pytest.approx(0.4 * inside)
    assert area(surface) == pytest.approx(2.0 * inside + 0.4 * np.hypot(x - np.roll(x, 1), y - np.roll(y, 1)).sum())


@pytest.mark.parametrize(
    "outline",
    [
        ((0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (0.0, 1.0)),
        ((0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)),
        ((0.0, 0.0), (1.0, 0.0), (2.0, 0.0)),
        ((0.0, 0.0), (0.0, 0.0), (1.0, 0.0), (0.0, 1.0)),
    ],
    ids=["corners on a line", "crossing itself", "flat", "a corner twice"],
)
@pytest.mark.parametrize("bevel", [0.0, 0.05])
def test_degenerate_outline_gives_finite_vertices(outline: tuple[tuple[float, float], ...], bevel: float) -> None:
    surface = solid(Plate(material="metal", normal="z", outline=outline, thickness=0.2, bevel=bevel))
    assert np.isfinite(surface.vertices).all()
    assert len(surface.faces) >= 2 * (len(outline) - 2)


SIDED = Group(
    shapes=(
        Box(material="metal", size=(1.0, 0.5, 0.2), position=(0.0, 2.0, 0.0), rotation=(0.1, 0.2, 0.3)),
        Plate(material="metal", normal="z", outline=EDGED, thickness=0.1, position=(0.0, 4.0, 0.0)),
        Shell(material="metal", length=1.0, radius=1.0, thickness=0.1, sweep=1.0, position=(0.0, 6.0, 0.0)),
    ),
    mirror=True,
    rotation=(0.0, 0.0, 0.1),
)


def test_mirrored_group_is_drawn_on_both_sides_with_outward_faces() -> None:
    surfaces = [moved(solid(shape), pose) for shape, pose in placed((SIDED,))]
    assert len(surfaces) == 6
    for one, other in zip(surfaces[:3], surfaces[3:], strict=True):
        assert other.vertices == pytest.approx(one.vertices * [1.0, -1.0, 1.0])
        assert volume(one) == pytest.approx(volume(other))
        assert volume(one) > 0.0


def test_group_copies_are_evenly_spaced_along_the_groups_axes() -> None:
    ball = Sphere(material="metal", radius=0.1)
    row = Group(shapes=(ball,), count=4, step=(1.0, 0.0, 0.0), position=(5.0, 0.0, 0.0), rotation=(0.0, 0.0, PI / 2))
    places = [pose.position for _, pose in placed((row,))]
    assert places == pytest.approx(np.array([[5.0, k, 0.0] for k in range(4)]), abs=1e-12)
    wheel = Group(
        shapes=(Sphere(material="metal", radius=0.1, position=(2.0, 0.0, 0.0)),), count=4, turn=(0, 0, PI / 2)
    )
    places = [pose.position for _, pose in placed((wheel,))]
    assert places == pytest.approx(np.array([[2, 0, 0], [0, 2, 0], [-2, 0, 0], [0, -2, 0]]), abs=1e-12)


def drawn() -> list[Shape]:
    scenario = load_scenario("loaded")
    assert scenario.payload is not None
    bodies = [body.shapes for body in scenario.worksite.bodies]
    bodies += [
        *shapes_of(scenario.arm.model).bodies.values(),
        scenario.payload.shapes,
    ]
    return [shape for shapes in bodies for shape in shapes]


def test_built_in_shapes_are_closed_with_outward_faces() -> None:
    for shape, pose in placed(drawn()):
        if not isinstance(shape, Light):
            surface = moved(solid(shape), pose)
            assert closed(surface), shape
            assert volume(surface) > 0.0, shape


def test_joined_surfaces_have_the_sum_of_the_volumes() -> None:
    parts: list[Any] = [moved(solid(shape), pose) for shape, pose in placed((SIDED,))]
    whole = joined(parts)
    assert closed(whole)
    assert volume(whole) == pytest.approx(sum(volume(part) for part in parts))
    assert len(joined([]).faces) == 0
