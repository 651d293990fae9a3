"""Trees and lists for our shapes: planes that divide, and rays from the station points."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from aftdeck.mainprior.fixed import FixedBodies
from aftdeck.mainprior.shapes import Stage
from aftdeck.mainprior.tables import BESIDE, LISTS, TREES, Item
from aftdeck.mainprior.trees import Sorted, Split, clusters_in, nodes_in, pruned
from aftdeck.simulation.run import Simulation
from aftdeck.visual.store import Polyhedron
from tests import loaded
from tests.each import each, number
from tests.mainprior.flown import SCRIPT, routine
from tests.visual.order_witness import first_hit

SHARED = {k: place for place, own in BESIDE.items() for k in own}
"""Number of the report's cluster whose place a cluster of ours shares."""


def places(items: tuple[Item, ...]) -> set[Item]:
    """Return the entries of a list, with the report's cluster in place of ours that share its place."""
    return {SHARED.get(k, k) if isinstance(k, int) else k for k in items}


def start() -> Stage:
    """Return the scenario's start in R."""
    return routine().shapes.stage(Simulation(loaded.scenario(SCRIPT)).look())


def test_each_plane_divides_the_clusters_that_are_fixed_in_its_system() -> None:
    fit, bodies, tested = routine().fit, FixedBodies(loaded.scenario(SCRIPT), routine().shapes, start()), 0
    for tree in fit.trees.values():
        for node in nodes_in(tree):
            sides = [(node.plane, clusters_in(node.true), clusters_in(node.false))] if isinstance(node, Split) else []
            sides += (
                [(plane, (node.cluster,), others) for plane, others in node.tests] if isinstance(node, Sorted) else []
            )
            for name, true, false in sides:
                if name not in fit.planes:
                    assert name in ("11", "12", "D1", "D2", "D3")
                    continue
                plane = fit.planes[name]
                for sign, side in ((1.0, true), (-1.0, false)):
                    for body in bodies.within(plane.system, side):
                        assert (sign * (body.points @ plane.normal - plane.distance)).min() > -1e-9, name
                        tested += 1
    assert tested > 60


def test_our_trees_have_the_clusters_of_figure_19_and_its_planes_where_these_divide() -> None:
    fit = routine().fit
    for name, tree in TREES.items():
        assert {SHARED.get(k, k) for k in clusters_in(fit.trees[name])} == set(clusters_in(tree))
        assert len(set(clusters_in(fit.trees[name]))) == len(clusters_in(fit.trees[name]))
    z2 = fit.trees["Z2"]
    assert any(node == fit.trees["Z1"] for node in nodes_in(z2))  # Z1 is a proper subtree of Z2
    kept = {node.plane for tree in fit.trees.values() for node in nodes_in(tree) if isinstance(node, Split)}
    assert {"1", "4", "8", "9", "11", "12", "13", "14", "15", "16"} <= kept
    assert not set(fit.replaced) & kept


def test_a_tree_without_a_cluster_loses_the_planes_that_only_this_cluster_needs() -> None:
    assert pruned(TREES["Z2"], {13, 14}) == Split("11", 14, 13)
    assert pruned(TREES["Z2"], {13}) == 13
    assert pruned(TREES["W1"], {1, 10, 12}) == Split("16", (12, 1), (10,))


def test_our_lists_have_the_entries_of_table_vii() -> None:
    for station, row in LISTS.items():
        ours = routine().items(station)
        assert places(ours) == places(row)
        assert len(set(ours)) == len(ours)
        if "Z2" in row:
            assert places(ours[: ours.index("Z2")]) == places(row[: row.index("Z2")])


@each("seed", range(number(3, 100)))
def test_a_ray_meets_fixed_clusters_in_the_order_of_the_list(seed: int) -> None:
    rng, bodies, stage, met = np.random.default_rng(seed), {}, start(), 0
    for k, body in stage.bodies.items():
        bodies[k] = Polyhedron(body.points, body.faces, ())
    first = Simulation(loaded.scenario(SCRIPT)).look()
    for station in ("A", "B", "C", "D", "E", "I"):
        eye = -routine().priority(first, station).vectors.eye["LR"]
        fixed = [k for k in routine().items(station) if isinstance(k, int)]
        for direction in rng.normal(size=(150, 3)):
            distances = [first_hit(bodies[k], eye, direction) for k in fixed]
            hit = [d for d in distances if 0.0 < d < np.inf]
            met += len(hit) > 1
            assert all(a <= b + 1e-9 for a, b in pairwise(hit)), station
    assert met > 20
