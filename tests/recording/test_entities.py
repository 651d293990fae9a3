"""Bodies as Foxglove's scene entities."""

from __future__ import annotations

import math
from typing import Any

import foxglove
import numpy as np
import pytest
import zstandard
from foxglove import messages as fox
from scipy.spatial.transform import Rotation

from aftdeck.recording.entities import entity, scene_update
from aftdeck.scenario.load import load_scenario
from aftdeck.scene.bodies import bodies_of
from aftdeck.scene.colours import rgb
from aftdeck.scene.mesh import moved
from aftdeck.scene.placed import placed
from aftdeck.scene.solids import solid
from aftdeck.shapes import Box, Cylinder, Group, Plate, Shape, Sphere
from aftdeck.worksite.body import Body
from tests.recording.protobuf import Decoder

SMALL = 150_000
"""Maximum size of a compressed scene [bytes]."""
ROTATED = (0.3, -0.5, 1.1)
PLACED = (1.0, 2.0, 3.0)


def decoded(message: fox.SceneUpdate) -> dict[str, Any]:
    schema = fox.SceneUpdate.get_schema()
    assert isinstance(schema, foxglove.Schema)
    return Decoder(schema.data, schema.name).decode(message.encode())


def entity_of(*shapes: Shape) -> dict[str, Any]:
    update = fox.SceneUpdate(entities=[entity(Body("body", shapes), fox.Timestamp(7, 0))])
    (shown,) = decoded(update)["entities"]
    assert isinstance(shown, dict)
    return shown


def corners(primitive: dict[str, Any], unit: np.ndarray[Any, np.dtype[np.float64]]) -> Any:
    """Return the points of a unit primitive, scaled and moved like the primitive."""
    size = [primitive["size"][k] for k in "xyz"]
    turn = Rotation.from_quat([primitive["pose"]["orientation"][k] for k in "xyzw"])
    return turn.apply(unit * size) + [primitive["pose"]["position"][k] for k in "xyz"]


def rows(points: Any) -> list[tuple[float, ...]]:
    return sorted(tuple(row) for row in np.round(points, 6).tolist())


CUBE = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])


@pytest.mark.parametrize("mirror", [False, True])
def test_boxes_become_cubes_with_the_same_corners(mirror: bool) -> None:
    box = Box(material="foil", size=(1.0, 2.0, 3.0), position=PLACED, rotation=ROTATED)
    group = Group(shapes=(box,), mirror=mirror)
    cubes = entity_of(group)["cubes"]
    meshes = [moved(solid(shape), pose) for shape, pose in placed((group,))]
    assert len(cubes) == len(meshes) == 1 + mirror
    for cube, mesh in zip(cubes, meshes, strict=True):
        assert rows(corners(cube, CUBE)) == rows(mesh.vertices)
        assert [cube["color"][k] for k in "rgba"] == pytest.approx([*rgb("foil"), 1.0])


@pytest.mark.parametrize("mirror", [False, True])
@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_cylinders_become_cylinders_with_the_same_rims(axis: Any, mirror: bool) -> None:
    cone = Cylinder(
        material="metal", axis=axis, length=3.0, radius=0.9, radius_end=0.4, position=PLACED, rotation=ROTATED
    )
    group = Group(shapes=(cone,), mirror=mirror)
    for shown, (_, pose) in zip(entity_of(group)["cylinders"], placed((group,)), strict=True):
        along = pose.rotation[:, "xyz".index(axis)]
        for side, scale, radius in ((-0.5, shown["bottom_scale"], 0.9), (0.5, shown["top_scale"], 0.4)):
            angles = np.arange(8) * math.tau / 8
            rim = np.stack([0.5 * scale * np.cos(angles), 0.5 * scale * np.sin(angles), np.full(8, side)], axis=1)
            around = corners(shown, rim) - pose.position - 2.0 * side * 1.5 * along
            assert np.linalg.norm(around, axis=1) == pytest.approx(np.full(8, radius))
            assert around @ along == pytest.approx(np.zeros(8), abs=1e-9)


def test_spheres_become_spheres() -> None:
    (ball,) = entity_of(Sphere(material="metal", radius=0.4, position=PLACED))["spheres"]
    assert [ball["size"][k] for k in "xyz"] == pytest.approx([0.8] * 3)
    assert [ball["pose"]["position"][k] for k in "xyz"] == pytest.approx(PLACED)


def test_other_shapes_become_one_triangle_list_for_each_material() -> None:
    plate = Plate(material="tiles", normal="z", outline=((0, 0), (1, 0), (0, 1)), thickness=0.5, position=PLACED)
    (shown,) = entity_of(plate, plate)["triangles"]
    mesh = moved(solid(plate), next(placed((plate,)))[1])
    points = np.array([[p[k] for k in "xyz"] for p in shown["points"]])
    assert points == pytest.approx(np.concatenate([mesh.vertices] * 2), abs=1e-3)
    assert shown["indices"] == [*mesh.faces.ravel(), *(mesh.faces.ravel() + len(mesh.vertices))]


@pytest.mark.parametrize("scenario", ["first-flight", "loaded"])
def test_scene_is_small(scenario: str) -> None:
    message = scene_update(bodies_of(load_scenario(scenario)), fox.Timestamp(7, 0))
    assert len(zstandard.ZstdCompressor(1).compress(message.encode())) < SMALL


def test_scene_replaces_the_scene_before() -> None:
    (gone,) = decoded(scene_update((), fox.Timestamp(7, 0)))["deletions"]
    assert gone["type"] == fox.SceneEntityDeletionType.All.value
