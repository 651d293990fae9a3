"""Marks on the faces of clusters: what is drawn, where, and what is not drawn.

The pixels of pictures with marks are compared in `test_pictures.py`.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from aftdeck.arrays import Array
from aftdeck.scenario.load import built_in
from aftdeck.scenario.model import Scenario
from aftdeck.scene.colours import material_of, rgb
from aftdeck.shapes import Hexahedron, Loft, Ring
from aftdeck.simulation.constants.site import all_solids
from aftdeck.visual.clusters import Clusters, clusters_of
from aftdeck.visual.drawn import Drawn, drawn_shapes
from aftdeck.visual.marking import DEEP, Painted, painted
from aftdeck.visual.paint import surfaces_of
from tests import loaded

DOCUMENT = Path(__file__).parents[2] / "docs" / "visual-scene.md"


def marks(scenario: Scenario) -> tuple[Clusters, tuple[Drawn, ...], Painted]:
    """Return the clusters of a scenario, its drawn shapes, and their marks."""
    clusters, drawn = clusters_of(scenario), tuple(drawn_shapes(scenario))
    surfaces = surfaces_of(drawn)
    bodies = [(cluster.frame, cluster.body) for cluster in clusters.clusters]
    materials = [m for frame, body in bodies for m in surfaces.of(frame, body.planes)]
    return clusters, drawn, painted(bodies, materials, drawn)


def flat_area(points: Array) -> float:
    """Return the area of a flat polygon (n, 3) [m^2]."""
    return 0.5 * float(np.linalg.norm(np.cross(points[1:-1] - points[0], points[2:] - points[0]).sum(axis=0)))


def test_the_docking_port_is_a_disc_on_the_face_of_its_body() -> None:
    clusters, drawn, found = marks(loaded.scenario("concept-1972"))
    dark = [k for k, one in enumerate(drawn) if (one.body, material_of(one.shape)) == ("cae", "dark")]
    port = max(dark, key=lambda k: float(np.ptp(drawn[k].surface.vertices, axis=0).max()))  # the others are lenses
    [mark] = [m for m, shape in enumerate(found.shapes) if shape == port]
    points = found.marks.points[found.marks.begins[mark] : found.marks.begins[mark + 1]]
    [seat] = [seat for seat in loaded.scenario("concept-1972").worksite.berths if seat.name == "port"]
    radius = 0.3048
    assert np.abs(points.mean(axis=0) - seat.pose.position).max() < 1e-6
    assert np.abs(np.linalg.norm(points - seat.pose.position, axis=1) - radius).max() < 1e-6
    sides = len(points)
    assert sides >= 16
    assert flat_area(points) == pytest.approx(0.5 * sides * radius**2 * math.sin(math.tau / sides))
    assert clusters.colours[len(clusters.store.planes) + mark].tolist() == list(rgb("dark"))


@pytest.mark.slow
def test_the_marks_of_a_target_are_on_the_face_of_its_plate() -> None:
    """Of the grapple fixture's target: white ring and cross, dark centre, all on the face towards the end effector."""
    scenario = loaded.scenario("srms-berth")
    clusters, drawn, found = marks(scenario)
    face_of = np.repeat(np.arange(len(found.marks.first) - 1), np.diff(found.marks.first))
    rings = [k for k, one in enumerate(drawn) if one.body == "payload" and isinstance(one.shape, Ring)]
    target = next(k for k in rings if material_of(drawn[k].shape) == "padding" and not drawn[k].is_detail)
    plate = Counter(int(face_of[m]) for m, shape in enumerate(found.shapes) if shape == target)
    [(face, pieces)] = plate.most_common(1)
    assert pieces >= 8  # a ring has a hole: it is no single polygon
    on_it = [found.materials[m] for m in range(len(found.shapes)) if face_of[m] == face]
    assert {"padding", "dark"} <= set(on_it)
    cluster = int(np.searchsorted(clusters.store.first_face, face, side="right")) - 1
    assert clusters.clusters[cluster].part == "payload grapple fixture"


def _listed(text: str) -> dict[str, int]:
    """Return the rows of the document's table of shapes that have no face."""
    section = text.partition("## What the pictures do not show")[2]
    return {body: int(count) for body, count in re.findall(r"^\| `([a-z_.]+)` \| (\d+) \|", section, re.MULTILINE)}


def _check(name: str) -> None:
    """Check that each drawn shape outside all solids has a mark, or is documented, or lies on its own material."""
    scenario = loaded.scenario(name)
    _, drawn, found = marks(scenario)
    solids: dict[str, list[Array]] = {}
    for cluster in clusters_of(scenario).clusters:
        solids.setdefault(cluster.frame, []).append(cluster.body.planes)
    without = Counter(one.body for one, outcome in zip(drawn, found.outcomes, strict=True) if outcome == "no face")
    listed = _listed(DOCUMENT.read_text())
    assert all(listed.get(body) == count for body, count in without.items()), without
    marked = set(found.shapes)
    for k, (one, outcome) in enumerate(zip(drawn, found.outcomes, strict=True)):
        assert (outcome == "mark") == (k in marked)
        corners = one.surface.vertices[one.surface.faces]
        inside = np.zeros(len(corners), bool)
        for planes in solids.get(one.frame, []):
            inside |= (corners.mean(axis=1) @ planes[:, :3].T - planes[:, 3]).max(axis=1) <= -DEEP
        if outcome == "inside":
            assert inside.all(), (one.body, one.shape)
        elif outcome == "hull":
            assert isinstance(one.shape, Loft)


def test_what_has_no_solid_is_a_mark_or_is_documented() -> None:
    _check("concept-1972")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["free-flyer", "srms-berth", "srms-deploy", "loaded"])
def test_what_has_no_solid_is_a_mark_or_is_documented_in_other_scenarios(name: str) -> None:
    assert name in built_in()
    _check(name)


def test_marks_lie_inside_their_faces() -> None:
    clusters, _, found = marks(loaded.scenario("concept-1972"))
    assert len(found.shapes) > 100
    assert np.array_equal(found.marks.points, clusters.marks.points)
    face_of = np.repeat(np.arange(len(found.marks.first) - 1), np.diff(found.marks.first))
    for m, face in enumerate(face_of.tolist()):
        cluster = int(np.searchsorted(clusters.store.first_face, face, side="right")) - 1
        planes = clusters.clusters[cluster].body.planes
        points = found.marks.points[found.marks.begins[m] : found.marks.begins[m + 1]]
        heights = points @ planes[:, :3].T - planes[:, 3]
        assert heights.max() < 1e-9
        assert np.abs(points @ clusters.store.planes[face, :3] - clusters.store.planes[face, 3]).max() < 1e-9


def test_a_solid_alone_has_no_marks() -> None:
    """A body that is drawn as its solids, with one material, has no marks of these on its faces."""
    scenario = loaded.scenario("concept-1972")
    clusters, drawn, found = marks(scenario)
    assert len(all_solids(scenario)) > 20
    hulls = [k for k, one in enumerate(drawn) if one.body == "cae" and isinstance(one.shape, Hexahedron)]
    assert hulls
    assert {found.outcomes[k] for k in hulls} <= {"like its face", "mark"}
    face_of = np.repeat(np.arange(len(found.marks.first) - 1), np.diff(found.marks.first))
    faces = [face_of[m] for m, shape in enumerate(found.shapes) if shape in hulls]
    on = np.searchsorted(clusters.store.first_face, faces, side="right") - 1
    # the body is seen on what touches it: the housings of its cameras
    assert {clusters.clusters[k].part for k in on} <= {camera.housing for camera in scenario.worksite.cameras}
