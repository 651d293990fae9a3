"""Pictures against a depth test for each pixel, in states of both worksites.

``python -m tests.visual.test_pictures COUNT`` compares COUNT states of each scenario, each from every camera.
"""

from __future__ import annotations

import sys
from collections import Counter
from typing import NamedTuple

import numpy as np
import pytest

from aftdeck.errors import SimulationError
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.scene.cameras import turn
from aftdeck.visual.scene import Aim, VisualScene
from tests.visual.depth_picture import DepthPictures
from tests.visual.painted_picture import painted
from tests.visual.states import states

WIDTH, HEIGHT = 160, 120
BESIDE = 1e-6
"""Distance by which a ray is moved to find the parts on both sides of an edge [pixels]."""


class Compared(NamedTuple):
    """Result of a comparison.

    Attributes:
        pictures: number of pictures.
        pixels: number of pixels.
        wrong: number of pixels that show another part than the depth test, or none.
        uncertain: number of such pixels in pictures for which an overlap of two parts was reported.
        on_edges: number of pixels left out, because their centre is on the edge between two parts.
        inside: pictures that could not be drawn because the camera is inside a part, by camera.
        cuts: number of cuts.
        overlaps: number of pairs whose order is uncertain.
    """

    pictures: int
    pixels: int
    wrong: int
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
    pictures = wrong = uncertain = on_edges = cuts = overlaps = 0
    inside: Counter[str] = Counter()
    for frame in states(scenario, count, np.random.default_rng(seed)):
        poses = {
            name: (row[:3], row[3:].reshape(3, 3))
            for name, row in zip(scene.clusters.frames, scene.frames_at(frame), strict=True)
        }
        base = scene.bodies_at(frame)[foot]
        poses[foot] = base[:3], np.array(turn(base))
        poses.setdefault("orbiter", (np.zeros(3), np.eye(3)))
        for name in scene.cameras:
            aim = scene.aim(frame, name, WIDTH / HEIGHT)
            absent = aim.hidden | scene.absent(frame)
            try:
                shown = numbers[painted(scene.polygons(frame, aim), WIDTH, HEIGHT)]
            except SimulationError:
                assert witness.distance(poses, aim, absent) < 0.02, f"{name} is not inside a part"
                inside[name] += 1
                continue
            order = scene.order(frame, aim)
            pictures, cuts, overlaps = pictures + 1, cuts + order.cuts, overlaps + order.overlaps
            right = shown == witness.at(poses, aim, absent)
            if right.all():
                continue
            edge = np.zeros_like(right)
            for across, down in ((-1, -1), (-1, 1), (1, -1), (1, 1)):
                edge |= shown == witness.at(poses, _beside(aim, across, down), absent)
            on_edges += int((~right & edge).sum())
            if order.overlaps:
                uncertain += int((~right & ~edge).sum())
            else:
                wrong += int((~right & ~edge).sum())
    return Compared(pictures, pictures * WIDTH * HEIGHT, wrong, uncertain, on_edges, inside, cuts, overlaps)


def _beside(aim: Aim, across: int, down: int) -> Aim:
    """Return a camera whose rays are a little beside those of another camera."""
    turned = aim.axes.copy()
    turned[2] += 2.0 * BESIDE * (across * aim.wide / WIDTH * aim.axes[0] + down * aim.high / HEIGHT * aim.axes[1])
    return aim._replace(axes=turned)


def _check(name: str, count: int, seed: int) -> None:
    found = compare(load_scenario(name), count, seed)
    assert found.pictures > 0
    assert found.wrong == 0, found
    assert found.on_edges <= found.pictures, found
    assert found.inside.total() <= 0.05 * found.pictures, found
    assert found.uncertain <= 0.02 * found.pictures, found
    assert found.overlaps <= 0.02 * found.pictures, found


def test_each_pixel_shows_the_nearest_part() -> None:
    _check("concept-1972-script", 3, 1)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "count"),
    [("concept-1972-script", 20), ("free-flyer", 8), ("srms-berth", 12), ("srms-deploy", 6), ("sts-400-closed", 6)],
)
def test_each_pixel_shows_the_nearest_part_in_many_states(name: str, count: int) -> None:
    _check(name, count, 2)


if __name__ == "__main__":
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    for scenario_name in sys.argv[2:] or ("concept-1972-script", "srms-berth"):
        print(scenario_name, compare(load_scenario(scenario_name), number, 0), flush=True)
