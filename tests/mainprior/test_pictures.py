"""Pictures in the order of the report's routine, against ours.

Wherever the planes of the routine separate the clusters of a picture, each pixel is the same. Where a pixel differs,
the routine has named the plane that does not separate the two clusters. ``python -m tests.mainprior.test_pictures
COUNT`` prints the share, for random pan, tilt and zoom, and for the cameras' first settings.
"""

from __future__ import annotations

import sys
from collections import Counter
from typing import NamedTuple

import msgspec
import numpy as np
import pytest

from aftdeck.mainprior.tables import LISTS
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation
from aftdeck.visual.polygons import Polygons
from tests import loaded
from tests.mainprior.flown import SCRIPT, routine, scene
from tests.visual.painted_picture import painted
from tests.visual.states import states

WIDTH, HEIGHT = 160, 120


class Compared(NamedTuple):
    """Result of a comparison.

    Attributes:
        pictures: number of pictures, without the housings of cameras, which the report does not have.
        separated: pictures in which the routine's planes separate all clusters of which one can hide the other.
        differing: pictures with a pixel that differs.
        unexplained: pictures with such a pixel, in which no plane was named for two clusters in the wrong order.
        named: number of pictures in which each plane was named, by plane.
        by_table_vii: pictures with a pixel that differs in the order of TABLE VII's own lists.
    """

    pictures: int
    separated: int
    differing: int
    unexplained: int
    named: Counter[str]
    by_table_vii: int


def compare(count: int, seed: int, *, aimed: bool) -> Compared:
    """Compare the pictures of cameras A to I in `count` states; `aimed`: with random settings of the cameras."""
    pictures = separated = differing = unexplained = by_table_vii = 0
    named: Counter[str] = Counter()
    scenario, numbers = loaded.scenario(SCRIPT), routine().shapes.numbers
    first = Simulation(scenario).look().views
    for state in states(scenario, count, np.random.default_rng(seed)):
        frame: Frame = state if aimed else msgspec.structs.replace(state, views=first)
        for station in LISTS:
            aim = scene().aim(frame, station, WIDTH / HEIGHT)
            aim = aim._replace(hidden=aim.hidden | routine().shapes.left_out)
            polygons = scene().polygons(frame, aim)
            hidden = {(numbers[a], numbers[b]) for a, b in scene().hidden_pairs()}
            found = routine().priority(frame, station)
            unproved = routine().unproved(found, {numbers[k] for k in polygons.owner.tolist()})
            own = routine().priority(frame, station, items=routine().report_items(station))
            ours, theirs, report = (
                painted(drawn, WIDTH, HEIGHT)
                for drawn in (polygons, in_order(polygons, found.clusters), in_order(polygons, own.clusters))
            )
            by_table_vii += bool((ours != report).any())
            differs = bool((ours != theirs).any())
            pictures, separated, differing = pictures + 1, separated + (not unproved), differing + differs
            unexplained += differs and not any((pair.behind, pair.before) in hidden for pair in unproved)
            named.update({pair.plane for pair in unproved})
    return Compared(pictures, separated, differing, unexplained, named, by_table_vii)


def in_order(polygons: Polygons, clusters: tuple[int, ...]) -> Polygons:
    """Return the polygons of a picture in the order of clusters, the last one first."""
    rank = {routine().shapes.index[number]: k for k, number in enumerate(clusters)}
    order = sorted(range(len(polygons.owner)), key=lambda q: -rank[int(polygons.owner[q])])
    parts = [polygons.points[polygons.begins[q] : polygons.begins[q + 1]] for q in order]
    return Polygons(
        np.concatenate([np.empty((0, 2)), *parts]),
        np.cumsum([0, *map(len, parts)]),
        polygons.owner[order],
        polygons.face[order],
        polygons.normal[order],
    )


def _check(count: int, *, aimed: bool) -> None:
    found = compare(count, 1, aimed=aimed)
    assert found.pictures == len(LISTS) * count
    assert found.unexplained == 0, found
    assert found.differing <= found.pictures - found.separated, found
    assert found.separated > 0.7 * found.pictures, found


def test_pixels_equal_ours_wherever_the_planes_of_the_routine_separate() -> None:
    _check(6, aimed=True)


@pytest.mark.slow
@pytest.mark.parametrize("aimed", [True, False])
def test_pixels_equal_ours_wherever_the_planes_separate_in_many_states(*, aimed: bool) -> None:
    _check(60, aimed=aimed)


@pytest.mark.slow
@pytest.mark.long
def test_pixels_equal_ours_wherever_the_planes_separate_in_1000_states() -> None:
    _check(1000, aimed=True)


if __name__ == "__main__":
    for settings in (True, False):
        result = compare(int(sys.argv[1]) if len(sys.argv) > 1 else 1000, 0, aimed=settings)
        print("random settings" if settings else "first settings", result, flush=True)
