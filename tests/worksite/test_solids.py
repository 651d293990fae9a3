"""Solids from files: convex, mirrored, and drawn from the same vertices."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aftdeck import separation
from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.scene.mesh import volume
from aftdeck.scene.solids import solid
from aftdeck.schema_check import convert
from aftdeck.shapes import Hexahedron
from aftdeck.worksite.file.check import distance
from aftdeck.worksite.file.solid_file import SolidFile
from aftdeck.worksite.file.solids import CORNERS, drawn, solids_of

CORNERED = [[0.0, 0.0], [2.0, 0.0], [1.5, 1.0], [0.25, 1.0]]
KINDS: list[tuple[dict[str, object], float]] = [
    ({"kind": "block", "x": ["1 ft", "3 ft"], "y": ["0 ft", "1 ft"], "z": ["-1 ft", "1 ft"]}, 4.0 * 0.3048**3),
    ({"kind": "block", "x": [0, 3], "y": [1, 3], "z": [0, 2], "y_end": [1, 2], "z_end": [0, 1]}, 7.0),
    ({"kind": "box", "size": [1, 2, 3]}, 6.0),
    *(
        ({"kind": "plate", "normal": normal, "outline": outline, "thickness": 0.5}, 0.8125)
        for normal in "xyz"
        for outline in (CORNERED, CORNERED[::-1], CORNERED[2:] + CORNERED[:2])
    ),
    ({"kind": "hexahedron", "vertices": (2.0 * CORNERS).tolist()}, 8.0),
    ({"kind": "prism", "sides": 6, "radius": 1, "length": 2}, 4.0 * math.sqrt(3.0)),
    (
        {"kind": "tube_wall", "radius": 1, "thickness": 0.2, "length": 2, "sweep": math.pi, "count": 64},
        0.36 * math.pi,
    ),
]


def made(table: dict[str, object], **more: object) -> dict[str, Array]:
    return solids_of(convert({"part": "wall", **table, **more}, SolidFile))  # type: ignore[arg-type]


@pytest.mark.parametrize(("table", "holds"), KINDS)
def test_solid_is_convex_and_drawn_from_its_vertices(table: dict[str, object], holds: float) -> None:
    bodies = made(table)["wall"]
    for body in bodies:
        hexahedron(body)
    shapes = drawn(bodies, "metal")
    assert [shape.vertices for shape in shapes if isinstance(shape, Hexahedron)] == [
        tuple(map(tuple, body)) for body in bodies.tolist()
    ]
    assert sum(volume(solid(shape)) for shape in shapes if isinstance(shape, Hexahedron)) == pytest.approx(
        holds, rel=0.01
    )


@settings(deadline=None, max_examples=30)
@given(
    table=st.sampled_from([table for table, _ in KINDS]),
    place=st.tuples(*[st.floats(-9.0, 9.0)] * 3).filter(lambda place: abs(place[1]) > 4.0),
    turn=st.tuples(*[st.floats(-3.0, 3.0)] * 3),
)
def test_mirrored_solids_are_reflections_named_after_their_side(
    table: dict[str, object], place: tuple[float, float, float], turn: tuple[float, float, float]
) -> None:
    one = made(table, position=place, rotation=turn)["wall"]
    both = made(table, position=place, rotation=turn, mirror=True)
    assert both["wall port"][..., 1].max() < 0.0 < both["wall starboard"][..., 1].min()
    mine, other = ("wall port", "wall starboard") if place[1] < 0.0 else ("wall starboard", "wall port")
    assert (both[mine] == one).all()
    for body, reflected in zip(one, both[other], strict=True):
        hexahedron(reflected)
        assert {tuple(v) for v in (reflected * [1.0, -1.0, 1.0]).tolist()} == {tuple(v) for v in body.tolist()}


@settings(deadline=None)
@given(
    point=st.tuples(*[st.floats(-3.0, 4.0)] * 3),
    table=st.sampled_from([table for table, _ in KINDS[:6]]),
)
def test_point_distance_equals_the_clearance_of_a_tiny_cube(
    point: tuple[float, float, float], table: dict[str, object]
) -> None:
    (body,) = made(table)["wall"]
    cube = np.array(point) + 2e-5 * (CORNERS - 0.5)
    assert distance(np.array(point), body) == pytest.approx(max(0.0, separation(cube, body).clearance), abs=4e-5)


def test_prism_slices_touch_without_overlap() -> None:
    slices = made({"kind": "prism", "sides": 12, "radius": 1, "length": 2})["wall"]
    for a, b in pairwise(slices):
        assert separation(a, b).clearance == pytest.approx(0.0, abs=1e-12)
