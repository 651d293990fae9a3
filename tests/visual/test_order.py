"""Order of clusters: lists and trees against planes, cycles, cameras inside bodies."""

from __future__ import annotations

import numpy as np
import pytest

from aftdeck.errors import InputError, SimulationError
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.visual.clusters import clusters_of
from aftdeck.visual.lists import hidden, permanent_list
from aftdeck.visual.scene import VisualScene
from aftdeck.visual.store import box, store_of
from aftdeck.visual.trees import NONE, trace_all
from tests.visual.order_witness import Bodies, first_hit, random_bars

CAMERAS_IN_R = ("A", "B", "C", "D", "I", "W")


@pytest.mark.parametrize("camera", CAMERAS_IN_R)
def test_a_permanent_list_agrees_with_rays_in_all_directions(camera: str) -> None:
    """A ray that meets two clusters meets the one first that comes first in the list."""
    scene = VisualScene(load_scenario("concept-1972"))
    found = scene.permanent_list(camera)
    assert found is not None
    assert sorted(found) == np.flatnonzero(scene.clusters.frame == scene.clusters.frames.index("orbiter")).tolist()
    aim = scene.aim(Simulation("concept-1972").look(), camera, 4 / 3)
    bodies = [scene.clusters.clusters[k].body for k in found]
    met = 0
    for direction in np.random.default_rng(1).normal(size=(2000, 3)):
        enters = np.array([first_hit(body, aim.position, direction) for body in bodies])
        hit = np.flatnonzero(np.isfinite(enters))
        assert (np.diff(enters[hit]) > -1e-9).all()
        met += len(hit) > 1
    assert met > 20


@pytest.mark.slow
def test_an_aimed_camera_uses_its_list_at_the_start() -> None:
    """The lens of this camera is ahead of the axes of its drive, so that aiming the camera moves the eye."""
    for changes in ({}, {"cameras.B": {"pan": -0.5, "tilt": 0.7}}):
        scenario = load_scenario("srms-deploy", changes)
        scene, frame = VisualScene(scenario), Simulation(scenario).step(Inputs())
        assert scene.arguments(frame, scene.aim(frame, "B", 4 / 3)).listed.any()


@pytest.mark.parametrize("name", ["concept-1972", pytest.param("srms-berth", marks=pytest.mark.slow)])
def test_trees_have_each_cluster_once_and_agree_with_planes(name: str) -> None:
    """The ranks of a tree never contradict the comparison of two clusters, from random eyes."""
    clusters = clusters_of(load_scenario(name))
    forest = clusters.forest
    assert sorted(forest.tree.clusters.tolist()) == list(range(len(clusters.clusters)))
    rng, rank = np.random.default_rng(2), np.zeros(len(clusters.clusters), np.int64)
    decided = 0
    for _ in range(10):
        eye = rng.uniform(-15.0, 15.0, 3)
        poses = np.tile(np.concatenate([-eye, np.eye(3).ravel()]), (len(clusters.frames), 1))
        trace_all(forest, poses, np.zeros(len(clusters.frames), np.uint8), rank)
        for f in range(len(clusters.frames)):
            members = np.flatnonzero(clusters.frame == f)
            for a, b in np.argwhere(hidden(clusters.store, members, eye)).tolist():
                assert rank[members[a]] <= rank[members[b]]
                decided += rank[members[a]] < rank[members[b]]
    assert decided > 100


def test_the_concepts_trees_need_no_cut() -> None:
    tree = clusters_of(load_scenario("concept-1972")).forest.tree
    assert (np.diff(tree.first) <= 1).all()
    assert ((tree.above == NONE) == (np.diff(tree.first) == 1)).all()


def test_three_interlocked_bars_need_one_cut() -> None:
    bars = [box(*ends) for ends in (((-3, -1, 0), (3, 0, 1)), ((0, -3, -1), (1, 3, 0)), ((-1, 0, -3), (0, 1, 3)))]
    eye = np.array([20.0, 20.0, 20.0])
    assert permanent_list(store_of(bars), np.arange(3), eye) is None
    bodies = Bodies(bars)
    order = bodies.order(eye, np.zeros(3))
    assert order.cuts == 1
    assert bodies.wrong_pixels(order) == 0


@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(1, 6))])
def test_random_bars_with_cycles_are_drawn_as_rays_meet_them(seed: int) -> None:
    bodies = Bodies(random_bars(np.random.default_rng(seed), 24))
    order = bodies.order(np.array([9.0, 1.0, 2.0]), np.zeros(3))
    assert order.cuts > 0
    assert bodies.wrong_pixels(order) == 0


def test_the_order_does_not_depend_on_the_memory_of_planes() -> None:
    scenario = load_scenario("concept-1972-script")
    scene, simulation = VisualScene(scenario), Simulation(scenario)
    for _ in range(6):
        for _ in range(100):
            simulation.advance()
        frame = simulation.look()
        for camera in ("A", "F", "P2", "ENG"):
            used = scene.order(frame, scene.aim(frame, camera, 4 / 3))
            fresh = VisualScene(scenario)
            assert fresh.order(frame, fresh.aim(frame, camera, 4 / 3)) == used


def test_a_camera_inside_a_body_is_an_error() -> None:
    scene, frame = VisualScene(load_scenario("concept-1972")), Simulation("concept-1972").look()
    aim = scene.aim(frame, "A", 4 / 3)
    inside = scene.clusters.clusters[0]
    with pytest.raises(SimulationError, match=f"camera A at 0 s is inside {inside.part}"):
        scene.order(frame, aim._replace(position=inside.body.points.mean(axis=0)))


def _in_housings(*names: str) -> dict[str, set[str]]:
    return {name: {f"camera {name}"} for name in names}


HIDDEN = {
    "concept-1972": {
        "AFT": {"cabin"},
        **_in_housings("A", "B", "C", "D", "E", "F", "G", "H", "I", "P1", "P2", "CAE2", "W"),
    },
    "srms-berth": {
        **_in_housings("A", "B", "C", "D", "KEEL"),
        "AFT P": {"cabin"},
        "AFT S": {"cabin"},
        "OVH P": {"cabin"},
        "OVH S": {"cabin"},
    },
}
"""Parts that are not in the pictures of a camera, because they are around its eye; no parts for the other cameras."""


@pytest.mark.slow
@pytest.mark.parametrize("name", HIDDEN)
def test_only_the_parts_around_an_eye_are_hidden(name: str) -> None:
    scene, frame = VisualScene(load_scenario(name)), Simulation(name).look()
    assert {camera: scene.aim(frame, camera, 4 / 3).hidden for camera in scene.cameras} == {
        camera: HIDDEN[name].get(camera, set()) for camera in scene.cameras
    }


def test_a_camera_that_does_not_exist_is_an_error() -> None:
    scene, frame = VisualScene(load_scenario("concept-1972")), Simulation("concept-1972").look()
    with pytest.raises(InputError, match="no camera is called 'Q'; cameras are A, B"):
        scene.aim(frame, "Q", 4 / 3)
