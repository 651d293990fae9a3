"""What decides the order of a picture: planes at the pins, the place of the arm in a list, trees."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from pathlib import Path

import msgspec
import numpy as np
import pytest

from aftdeck.arms.load import load_model
from aftdeck.arms.solids import solids_of
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation
from aftdeck.visual.report import explained
from aftdeck.visual.scene import VisualScene
from aftdeck.visual.trees import trace_all
from tests.commands import Run
from tests.visual.states import states


@pytest.fixture(scope="module")
def scene() -> VisualScene:
    return VisualScene(load_scenario("concept-1972"))


@pytest.fixture(scope="module")
def start() -> Frame:
    return Simulation("concept-1972").look()


@pytest.mark.parametrize("bend", [5, 60, 120, 126, 128, 150])
def test_the_plane_at_the_elbow_is_valid_up_to_the_bend_that_the_set_back_permits(
    scene: VisualScene, start: Frame, bend: float
) -> None:
    """Valid if, and only if, the set-back is at least half the width times the tangent of half the bend."""
    ho, po, _, h2, p2, r2 = start.angles
    frame = msgspec.structs.replace(start, angles=(ho, po, -math.radians(bend), h2, p2, r2))
    elbow = next(
        plane
        for plane in explained(scene, frame, scene.aim(frame, "ENG", 4 / 3)).bisectors
        if (plane.first, plane.second) == ("upper boom", "lower boom")
    )
    boom = next(solid for solid in solids_of(load_model("concept-1972")) if solid.part == "lower boom")
    set_back, least_y, _ = boom.vertices.min(axis=0)
    least = -least_y * math.tan(0.5 * elbow.bend)
    assert elbow.bend == pytest.approx(math.radians(bend), abs=1e-9)
    assert elbow.valid == (least <= set_back)
    assert elbow.valid == (bend < 127)


def test_the_other_clusters_stand_as_one_block_in_a_permanent_list(scene: VisualScene) -> None:
    """The report's entry Z. In each state the block's place lets every cluster hide only what comes after it."""
    with_roots = []
    for frame in states(load_scenario("concept-1972-script"), 20, np.random.default_rng(5)):
        for camera in ("A", "C", "D", "I"):
            found = explained(scene, frame, scene.aim(frame, camera, 4 / 3))
            assert found.listed is not None
            with_roots.append(found.roots != ())
            if found.roots:
                assert {root.frame for root in found.roots} == set(scene.clusters.frames) - {"orbiter"}
                rank = {
                    cluster: found.row.index(str(cluster) if str(cluster) in found.row else "Z")
                    for cluster in range(len(scene.clusters.clusters))
                }
                assert all(rank[nearer] <= rank[hidden] for nearer, hidden in scene.hidden_pairs())
    assert np.mean(with_roots) > 0.9


def test_a_list_has_new_l_vectors_where_the_frame_changes(scene: VisualScene) -> None:
    """The report's L codes and new-L flags: before Z, in Z with each tree, and behind Z."""
    between = 0
    for frame in states(load_scenario("concept-1972-script"), 10, np.random.default_rng(6)):
        for camera in ("A", "C", "I"):
            found = explained(scene, frame, scene.aim(frame, camera, 4 / 3))
            assert found.listed is not None
            codes = [entry.frame for entry in found.listed]
            changes = [k == 0 or codes[k] != codes[k - 1] for k in range(len(codes))]
            assert [entry.new_frame for entry in found.listed] == changes
            inside = found.roots != () and 0 < found.row.index("Z") < len(found.row) - 1
            own = [entry.new_frame for entry in found.listed if entry.cluster is not None]
            assert own.count(True) == 1 + inside
            between += inside
    assert between > 0


def test_the_trees_are_listed_in_the_order_of_their_trace(scene: VisualScene, start: Frame) -> None:
    """In the list of a tree, the clusters come in the order of their ranks."""
    aim = scene.aim(start, "F", 4 / 3)
    found, given = explained(scene, start, aim), scene.arguments(start, aim)
    rank = np.zeros(len(found.clusters), np.int64)
    trace_all(given.forest, given.poses, given.listed, rank)
    for name, nodes in found.trees.items():
        clusters = [cluster for node in nodes for cluster in node.clusters]
        members = [k for k, (_, frame) in enumerate(found.clusters) if frame == name]
        assert clusters == sorted(members, key=lambda k: rank[k])
        for node in nodes:
            assert (node.plane is None) == (node.clusters != ())


def test_the_sheet_has_each_cluster_plane_and_entry(scene: VisualScene, run: Run, tmp_path: Path) -> None:
    out = tmp_path / "planes.svg"
    assert run("planes", "concept-1972", "--camera", "A", "-o", str(out))[0] == 0
    root = ET.parse(out).getroot()
    texts = [text.text or "" for text in root.iter("{http://www.w3.org/2000/svg}text")]
    for cluster in range(len(scene.clusters.clusters)):
        assert str(cluster) in texts
    assert sum("L vector of" in text for text in texts) > 3
    assert len(list(root.iter("{http://www.w3.org/2000/svg}path"))) > 2 * len(scene.clusters.clusters)
    assert run("planes", "concept-1972", "--camera", "A", "-o", str(tmp_path / "planes.png"))[0] == 2
