"""What decides the order of a picture: clusters, permanent list, trees and the order chosen, as plain values."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.bodies.pose import turned_back
from aftdeck.bodies.vector import Vector, dot
from aftdeck.simulation.frame import Frame
from aftdeck.visual.bisectors import bisector
from aftdeck.visual.clusters import Cluster, Clusters
from aftdeck.visual.planes import TOLERANCE, extent
from aftdeck.visual.scene import Aim, Arguments, VisualScene
from aftdeck.visual.trees import NONE, Forest


class Entry(NamedTuple):
    """Entry of the priority output table.

    Attributes:
        cluster: number of the cluster.
        part: its part.
        frame: the frame whose L vector the scene generator uses for it.
        new_frame: whether this frame differs from that of the entry before: the table then has an L instruction.
    """

    cluster: int
    part: str
    frame: str
    new_frame: bool


class ListEntry(NamedTuple):
    """Entry of a camera's permanent priority list: a cluster, or the root of another frame's tree.

    The roots stand together at the place of the report's entry Z. Their clusters are compared with each other, and
    not one tree after the other. The report's mode tests are not needed: clusters that do not exist are not compared.

    Attributes:
        cluster: number of the cluster; None for a root.
        root: number of the root; None for a cluster.
        frame: the frame whose L vector decides: the report's L code.
        new_frame: whether this frame differs from that of the entry before: the report's new-L flag.
    """

    cluster: int | None
    root: int | None
    frame: str
    new_frame: bool


class Node(NamedTuple):
    """Node of a tree of separating planes, with the test for one eye.

    Attributes:
        depth: number of planes between the root and the node.
        plane: number of the plane, counted over all trees; None for a leaf.
        normal: unit normal of the plane, in the frame of the tree.
        distance: distance of the plane from the frame's origin along the normal [m].
        eye: height of the eye over the plane [m]; the side with the eye comes first.
        clusters: clusters of a leaf; more than one if no plane divides them.
    """

    depth: int
    plane: int | None
    normal: tuple[float, float, float]
    distance: float
    eye: float
    clusters: tuple[int, ...]


class Bisector(NamedTuple):
    """Plane through a pin of the arm that bisects two links: SP 11, SP 12.

    Attributes:
        first: part before the pin.
        second: part after the pin.
        bend: angle between the two links [rad].
        valid: whether the plane separates the two parts in this pose.
    """

    first: str
    second: str
    bend: float
    valid: bool


class Explained(NamedTuple):
    """What decides the order of a picture.

    Attributes:
        clusters: part and frame of each cluster.
        solids: number of collision solids from which the clusters were made.
        overlapping_solids: number of pairs of them that overlap in one frame.
        listed: the camera's permanent list; None if it has none for the present position of its eye. It has no roots
            if the clusters of other frames have no common place in it: one of them is hidden by a listed cluster, and
            one hides a listed cluster of the same or a higher priority.
        trees: nodes of each frame's tree, in the order of the trace, by the frame's name.
        bisectors: the planes SP 11 and SP 12.
        table: the priority output table, highest priority first.
        compared: number of pairs of clusters that were compared.
        ranked: how many of them by a list or a tree; the others by a plane between the two.
        cuts: number of cuts.
        overlapping: parts that overlap in space, whose order is uncertain; None if there are none.
    """

    clusters: tuple[tuple[str, str], ...]
    solids: int
    overlapping_solids: int
    listed: tuple[ListEntry, ...] | None
    trees: dict[str, tuple[Node, ...]]
    bisectors: tuple[Bisector, ...]
    table: tuple[Entry, ...]
    compared: int
    ranked: int
    cuts: int
    overlapping: tuple[str, str] | None

    @property
    def row(self) -> tuple[str, ...]:
        """The permanent list with Z in place of the roots, as in TABLE VII; empty if there is no list."""
        texts = ["Z" if entry.cluster is None else str(entry.cluster) for entry in self.listed or ()]
        return tuple(text for k, text in enumerate(texts) if k == 0 or (text, texts[k - 1]) != ("Z", "Z"))

    @property
    def roots(self) -> tuple[ListEntry, ...]:
        """The roots in the permanent list, at the place of Z."""
        return tuple(entry for entry in self.listed or () if entry.root is not None)


def explained(scene: VisualScene, frame: Frame, aim: Aim) -> Explained:
    """Return what decides the order of a picture; errors as for `VisualScene.order`."""
    ours, order = scene.clusters, scene.order(frame, aim)
    names = [(cluster.part, cluster.frame) for cluster in ours.clusters]
    table: list[Entry] = []
    for k in order.clusters:
        part, home = names[k]
        table.append(Entry(k, part, home, not table or table[-1].frame != home))
    given = scene.arguments(frame, aim)
    trees = {name: tuple(_traced(ours.forest, f, given.poses[f])) for f, name in enumerate(ours.frames)}
    listed = scene.permanent_list(aim.name) if given.listed.any() else None
    place = None if listed is None else _place(listed, scene.hidden_pairs())
    return Explained(
        tuple(names),
        ours.solids,
        ours.overlapping,
        None if listed is None else tuple(_entries(ours, listed, place)),
        trees,
        tuple(_bisectors(ours.clusters, given)),
        tuple(table),
        order.compared,
        order.ranked,
        order.cuts,
        order.overlapping,
    )


def _entries(clusters: Clusters, listed: tuple[int, ...], place: int | None) -> Iterator[ListEntry]:
    """Yield the entries of a permanent list.

    Args:
        clusters: the clusters.
        listed: clusters of the list, highest priority first.
        place: number of clusters before the roots; None if the list has no roots.
    """
    home, last = int(clusters.frame[listed[0]]), -1
    roots = [f for f in range(len(clusters.frames)) if f != home and (clusters.frame == f).any()]
    frames = [home] * len(listed)
    if place is not None:
        frames[place:place] = roots
    left = iter(listed)
    for f in frames:
        new, last = f != last, f
        if f == home:
            yield ListEntry(next(left), None, clusters.frames[f], new)
        else:
            yield ListEntry(None, int(clusters.forest.root[f]), clusters.frames[f], new)


def _place(listed: tuple[int, ...], pairs: Iterable[tuple[int, int]]) -> int | None:
    """Return the place of the other clusters in a list, from a picture's pairs (nearer cluster, hidden cluster)."""
    rank = {cluster: k for k, cluster in enumerate(listed)}
    first, last = 0, len(listed)
    for nearer, hidden in pairs:
        if nearer in rank and hidden not in rank:
            first = max(first, rank[nearer] + 1)
        elif hidden in rank and nearer not in rank:
            last = min(last, rank[hidden])
    return first if first <= last else None


def _bisectors(clusters: tuple[Cluster, ...], given: Arguments) -> Iterator[Bisector]:
    """Yield the planes SP 11 and SP 12 of the last picture, with the parts that each may separate."""
    for i, j in given.bisected.tolist():
        f, g = given.frame[i], given.frame[j]
        n = bisector(given.poses, f, g)
        along = extent(given.placed.points, given.placed.first_point, i, j, n)
        cosine = float(given.poses[f, 3::3] @ given.poses[g, 3::3])
        valid = bool(dot(n, n) > 0.0 and along.b - along.a >= -TOLERANCE)
        yield Bisector(clusters[i].part, clusters[j].part, math.acos(max(-1.0, min(1.0, cosine))), valid)


def _traced(forest: Forest, f: int, pose: Array) -> list[Node]:
    """Return the nodes of a frame's tree in the order of the trace: a node, its nearer son, its farther son.

    `pose` (12,) is the pose of the frame in the coordinates of the camera.
    """
    tree, eye = forest.tree, turned_back(pose, Vector(-pose[0], -pose[1], -pose[2]))
    found: list[Node] = []
    waiting = [(int(forest.root[f]), 0)]
    while waiting:
        node, depth = waiting.pop()
        leaf = tree.above[node] == NONE
        x, y, z, distance = tree.plane[node].tolist()
        height = x * float(eye.x) + y * float(eye.y) + z * float(eye.z) - distance
        own = tuple(tree.clusters[tree.first[node] : tree.first[node + 1]].tolist())
        found.append(Node(depth, None if leaf else node, (x, y, z), distance, 0.0 if leaf else height, own))
        if not leaf:
            sons = [int(tree.above[node]), int(tree.below[node])]
            waiting += [(son, depth + 1) for son in (sons[::-1] if height > 0.0 else sons)]
    return found
