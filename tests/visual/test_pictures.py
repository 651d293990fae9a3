"""Pictures against a depth test for each pixel, in states of both worksites.

``python -m tests.visual.test_pictures COUNT`` compares COUNT states of each scenario, each from every camera.
"""

from __future__ import annotations

import sys
from collections import Counter
from typing import NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

from aftdeck.arrays import Array, Indices
from aftdeck.errors import SimulationError
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.scene.cameras import turn
from aftdeck.visual.polygons import Polygons
from aftdeck.visual.scene import Aim, VisualScene
from tests.visual.depth_picture import DepthPictures
from tests.visual.mark_witness import marks_at
from tests.visual.painted_picture import painted
from tests.visual.states import states

WIDTH, HEIGHT = 160, 120
BESIDE = 1e-6
"""Distance by which a ray is moved to find the parts on both sides of an edge [pixels]."""


_DIRECTIONS = ((0, 0), (-1, -1), (-1, 1), (1, -1), (1, 1))


class Compared(NamedTuple):
    """Result of a comparison.

    Attributes:
        pictures: number of pictures.
        pixels: number of pixels.
        wrong: number of pixels that show another part or another mark than the depth test, or none.
        marked: number of pixels that show a mark.
        uncertain: number of such pixels in pictures for which an overlap of two parts was reported.
        on_edges: number of pixels left out, because their centre is on the edge between two parts.
        inside: pictures that could not be drawn because the camera is inside a part, by camera.
        cuts: number of cuts.
        overlaps: number of pairs whose order is uncertain.
    """

    pictures: int
    pixels: int
    wrong: int
    marked: int
    uncertain: int
    on_edges: int
    inside: Counter[str]
    cuts: int
    overlaps: int


def compare(scenario: Scenario, count: int, seed: int) -> Compared:
    """Compare the pictures of all cameras in `count` states with the depth test."""
    scene, witness = VisualScene(scenario), DepthPictures(scenario, WIDTH, HEIGHT)
    numbers = np.array([*(witness.parts.index(cluster.part) for cluster in scene.clusters.clusters), -1])
    foot = scenario.arm.model.linkage.frames[0]
    faces = len(scene.clusters.marks.first) - 1
    pictures = wrong = marked = uncertain = on_edges = cuts = overlaps = 0
    inside: Counter[str] = Counter()
    for frame in states(scenario, count, np.random.default_rng(seed)):
        poses = {
            name: (row[:3], row[3:].reshape(3, 3))
            for name, row in zip(scene.clusters.frames, scene.frames_at(frame), strict=True)
        }
        base = scene.bodies_at(frame)[foot]
        poses[foot] = base[:3], np.array(turn(base))
        poses.setdefault("orbiter", (np.zeros(3), np.eye(3)))
        rows = scene.frames_at(frame)
        for name in scene.cameras:
            aim = scene.aim(frame, name, WIDTH / HEIGHT)
            absent = aim.hidden | scene.absent(frame)
            try:
                drawn = scene.polygons(frame, aim)
            except SimulationError:
                assert witness.distance(poses, aim, absent) < 0.02, f"{name} is not inside a part"
                inside[name] += 1
                continue
            order = scene.order(frame, aim)
            pictures, cuts, overlaps = pictures + 1, cuts + order.cuts, overlaps + order.overlaps
            part, mark = _shown(drawn, numbers, faces)
            marked += int((mark >= 0).sum())
            right, *beside = (
                _equal(part, mark, witness, scene, poses, rows, _beside(aim, *to), absent) for to in _DIRECTIONS
            )
            if right.all():
                continue
            edge = np.logical_or.reduce(beside)
            on_edges += int((~right & edge).sum())
            if order.overlaps:
                uncertain += int((~right & ~edge).sum())
            else:
                wrong += int((~right & ~edge).sum())
    return Compared(pictures, pictures * WIDTH * HEIGHT, wrong, marked, uncertain, on_edges, inside, cuts, overlaps)


def _shown(drawn: Polygons, numbers: Indices, faces: int) -> tuple[Indices, Indices]:
    """Return the part and the mark (height, width) that each pixel shows, -1 for none."""
    top = painted(drawn._replace(owner=np.arange(len(drawn.owner))), WIDTH, HEIGHT)
    owner, face = np.append(drawn.owner, -1)[top], np.append(drawn.face, -1)[top]
    return numbers[owner], np.maximum(face - faces, -1)


def _equal(
    part: Indices,
    mark: Indices,
    witness: DepthPictures,
    scene: VisualScene,
    poses: dict[str, tuple[Array, Array]],
    rows: Array,
    aim: Aim,
    absent: frozenset[str],
) -> NDArray[np.bool_]:
    """Return where the pixels of a picture show the same part and the same mark as the depth test."""
    nearest, depth = witness.at(poses, aim, absent)
    return np.asarray((part == nearest) & (mark == marks_at(scene.clusters, rows, aim, absent, depth)))


def _beside(aim: Aim, across: int, down: int) -> Aim:
    """Return a camera whose rays are a little beside those of another camera."""
    turned = aim.axes.copy()
    turned[2] += 2.0 * BESIDE * (across * aim.wide / WIDTH * aim.axes[0] + down * aim.high / HEIGHT * aim.axes[1])
    return aim._replace(axes=turned)


def _check(name: str, count: int, seed: int) -> None:
    found = compare(load_scenario(name), count, seed)
    assert found.pictures > 0
    assert found.wrong == 0, found
    assert found.marked > 0.001 * found.pixels, found
    assert found.on_edges <= found.pictures, found
    assert found.inside.total() <= 0.05 * found.pictures, found
    assert found.uncertain <= 0.02 * found.pictures, found
    assert found.overlaps <= 0.02 * found.pictures, found


def test_each_pixel_shows_the_nearest_part() -> None:
    _check("concept-1972-script", 3, 1)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "count"),
    [
        ("concept-1972-script", 20),
        ("free-flyer", 8),
        ("srms-berth", 3),
        *(
            pytest.param(name, count, marks=pytest.mark.long)
            for name, count in (("srms-berth", 12), ("srms-deploy", 6), ("sts-400-closed", 6))
        ),
    ],
)
def test_each_pixel_shows_the_nearest_part_in_many_states(name: str, count: int) -> None:
    _check(name, count, 2)


if __name__ == "__main__":
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    for scenario_name in sys.argv[2:] or ("concept-1972-script", "srms-berth"):
        print(scenario_name, compare(load_scenario(scenario_name), number, 0), flush=True)
