"""Clusters of a scenario: convex bodies for drawing that do not overlap, made from the collision solids.

A *cluster* is a convex body. Its front faces need no order among themselves, so the picture of a cluster is a list of
faces that is fixed for every view. Source: Remote Manipulator Simulation, final report, chapter V, where clusters were
made by hand.

Collision solids may overlap. Two solids of one part whose union is convex become one cluster. A cluster that is
inside another one of the same frame is left out. Of two clusters of one frame that overlap, one is removed from the
other, and the rest is cut into convex pieces. The union of all clusters is the union of all solids.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from operator import le
from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.errors import InputError
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import inverted, scene_in_l
from aftdeck.scene.colours import rgb
from aftdeck.simulation.constants.site import all_solids, site_of
from aftdeck.visual.bisectors import bisected_pairs
from aftdeck.visual.drawn import drawn_shapes
from aftdeck.visual.marking import painted
from aftdeck.visual.marks import Marks
from aftdeck.visual.paint import surfaces_of
from aftdeck.visual.placing import find_overlaps
from aftdeck.visual.planes import TOLERANCE
from aftdeck.visual.samples import sampled_poses
from aftdeck.visual.solids import apart, difference, moved, union
from aftdeck.visual.store import Polyhedron, Store, of_hexahedron, store_of, volume
from aftdeck.visual.trees import Forest, forest_of

MOST_CLUSTERS = 256
"""Greatest number of clusters of a scenario: more are not ordered in the time between two pictures."""


class Cluster(NamedTuple):
    """Convex body for drawing.

    Attributes:
        part: name that the operator reads: "upper boom", "bay wall port".
        frame: name of the frame that carries the cluster.
        body: its surface, in that frame.
    """

    part: str
    frame: str
    body: Polyhedron


class Clusters(NamedTuple):
    """All clusters of a scenario.

    Attributes:
        frames: names of the frames that carry clusters.
        clusters: the clusters.
        store: the clusters' surfaces, each in its own frame.
        frame: (N,) frame of each cluster.
        forest: trees of separating planes, one for each frame.
        trims: (T, 2) pairs of clusters in different frames that can overlap in flight, because a joint or a grasp
            connects them: in each picture, the second is removed from the first.
        bisected: (B, 2) pairs of clusters that SP 11 and SP 12 may separate.
        marks: the marks of the faces.
        colours: (F + M, 3) sRGB colour of each face, then of each mark, 0 to 1.
        solids: number of collision solids from which the clusters were made.
        overlapping: number of pairs of solids in one frame that overlap.
    """

    frames: tuple[str, ...]
    clusters: tuple[Cluster, ...]
    store: Store
    frame: Indices
    forest: Forest
    trims: Indices
    bisected: Indices
    marks: Marks
    colours: Array
    solids: int
    overlapping: int


@lru_cache(maxsize=4)
def clusters_of(scenario: Scenario) -> Clusters:
    """Return the clusters of a scenario.

    Raises:
        InputError: the scenario has more than MOST_CLUSTERS clusters.
    """
    made, near = _solids(scenario), _Near()
    merged = _merged(made, near)
    overlapping = sum(
        a.frame == b.frame and apart(a.body, b.body) < -TOLERANCE
        for i, a in enumerate(made)
        for b in made[:i]
        if near(a.body, b.body)
    )
    clusters = _merged(_apart(merged, near), near)
    if len(clusters) > MOST_CLUSTERS:
        raise InputError(
            f"{scenario.name} has {len(clusters)} convex bodies to draw; at most {MOST_CLUSTERS} can be put in order"
        )
    frames = tuple(dict.fromkeys(cluster.frame for cluster in clusters))
    store = store_of([cluster.body for cluster in clusters])
    frame = np.array([frames.index(cluster.frame) for cluster in clusters], dtype=np.int64)
    drawn = tuple(drawn_shapes(scenario))
    surfaces = surfaces_of(drawn)
    materials = [m for cluster in clusters for m in surfaces.of(cluster.frame, cluster.body.planes)]
    marked = painted([(cluster.frame, cluster.body) for cluster in clusters], materials, drawn)
    return Clusters(
        frames,
        tuple(clusters),
        store,
        frame,
        forest_of(store, frame, len(frames)),
        _trims(scenario, clusters, frames, store, frame),
        bisected_pairs(
            scenario.arm.model,
            [cluster.frame for cluster in clusters],
            [volume(cluster.body) for cluster in clusters],
        ),
        marked.marks,
        np.array([rgb(material) for material in (*materials, *marked.materials)]),
        len(made),
        overlapping,
    )


def _solids(scenario: Scenario) -> list[Cluster]:
    """Return each collision solid as a cluster. What is fixed to the orbiter is in the frame ``orbiter``."""
    model = scenario.arm.model
    foot = model.linkage.frames[0]
    mount = inverted(scene_in_l(model.mount, scenario.worksite.origin))
    found = []
    for solid in all_solids(scenario):
        body, frame = of_hexahedron(hexahedron(solid.vertices, solid.part)), solid.frame
        if frame == foot:
            body, frame = moved(body, mount), "orbiter"
        found.append(Cluster(solid.part, frame, body))
    return found


def _merged(clusters: Sequence[Cluster], near: _Near) -> list[Cluster]:
    """Return clusters in which any two of one part whose union is convex are one cluster."""
    found: list[Cluster] = []
    for cluster in clusters:
        joined = cluster
        while True:
            for k, other in enumerate(found):
                if (other.part, other.frame) == (joined.part, joined.frame) and near(other.body, joined.body):
                    both = union(other.body, joined.body)
                    if both is not None:
                        joined = Cluster(joined.part, joined.frame, both)
                        del found[k]
                        break
            else:
                break
        found.append(joined)
    return found


def _apart(clusters: Sequence[Cluster], near: _Near) -> list[Cluster]:
    """Return clusters of which no two in one frame overlap; their union is unchanged."""
    found: list[Cluster] = []
    waiting = sorted(clusters, key=lambda cluster: volume(cluster.body))
    while waiting:
        cluster = waiting.pop()
        for k, other in enumerate(found):
            if other.frame != cluster.frame or not near(other.body, cluster.body):
                continue
            if apart(other.body, cluster.body) >= -TOLERANCE:
                continue
            rest, others = difference(cluster.body, other.body), difference(other.body, cluster.body)
            if len(others) < len(rest):
                found[k : k + 1] = [Cluster(other.part, other.frame, body) for body in others]
                waiting.append(cluster)
            else:
                waiting += [Cluster(cluster.part, cluster.frame, body) for body in rest]
            break
        else:
            found.append(cluster)
    return found


class _Near:
    """Test of bounding boxes. It remembers the box of each polyhedron, and the polyhedron itself."""

    def __init__(self) -> None:
        self._boxes: dict[int, tuple[Polyhedron, Sequence[float], Sequence[float]]] = {}

    def __call__(self, a: Polyhedron, b: Polyhedron) -> bool:
        """Return whether the bounding boxes of two polyhedra touch or overlap."""
        _, a_low, a_high = self._box(a)
        _, b_low, b_high = self._box(b)
        return all(map(le, a_low, b_high)) and all(map(le, b_low, a_high))

    def _box(self, body: Polyhedron) -> tuple[Polyhedron, Sequence[float], Sequence[float]]:
        """Return a polyhedron, its least coordinates, and its greatest ones with the tolerance [m]."""
        if id(body) not in self._boxes:
            low, high = body.points.min(axis=0), body.points.max(axis=0) + TOLERANCE
            self._boxes[id(body)] = body, low.tolist(), high.tolist()
        return self._boxes[id(body)]


def _trims(
    scenario: Scenario, clusters: Sequence[Cluster], frames: tuple[str, ...], store: Store, frame: Indices
) -> Indices:
    """Return the pairs (T, 2) of clusters that overlap in flight because they are connected; the smaller one first.

    They are connected by a joint, a mount or a berth, and overlap in sampled poses; the collision program does not
    monitor such a pair, or permits its contact. Or a grasp connects them: the end effector, and a payload's fitting.
    """
    layout = site_of(scenario).layout
    watched = {frozenset(layout.named(group)) for group in range(len(layout.groups))}
    watched -= {frozenset(pair.parts) for pair in scenario.worksite.essential}
    grasps = {frozenset(pair.parts) for pair in scenario.worksite.essential if pair.relation == "capture"}
    order = sorted(range(len(clusters)), key=lambda k: (volume(clusters[k].body), k))
    pairs, certain = [], []
    for n, i in enumerate(order):
        for j in order[n + 1 :]:
            a, b = clusters[i], clusters[j]
            pair = frozenset((a.part, b.part))
            if a.frame == b.frame:
                continue
            if pair in grasps:
                certain.append((i, j))
            elif pair not in watched:
                pairs.append((i, j))
    unmonitored = np.array(pairs, dtype=np.int64).reshape(-1, 2)
    found = np.zeros(len(pairs), np.uint8)
    find_overlaps(
        store,
        frame,
        sampled_poses(scenario, frames),
        unmonitored,
        store_of([cluster.body for cluster in clusters]),
        found,
    )
    chosen = [*certain, *map(tuple, unmonitored[found == 1].tolist())]
    return np.array(sorted(chosen), dtype=np.int64).reshape(-1, 2)
