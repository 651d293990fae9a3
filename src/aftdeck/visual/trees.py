"""Trees of separating planes: the order of clusters in one frame, for an eye at any position.

A node has a plane that cuts no cluster; the clusters on the eye's side of it hide those on the other side. A leaf is a
single cluster, or several that no plane divides without a cut: these are compared with each other in each picture. A
tree is never made finer by cuts: random layouts need cuts more often than their pictures have cycles.

Each node is passed three times: for the test, after the first son, and after the second son. An indicator counts the
sons that are done, so that the trace needs no stack (MAINPRIOR). Source: Remote Manipulator Simulation,
final report, chapter V, Figures 17 to 19.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pose import turned_back
from aftdeck.bodies.vector import Vector
from aftdeck.law import law
from aftdeck.visual.cutting import ON
from aftdeck.visual.planes import plane_of
from aftdeck.visual.store import Store

SONS = 2
"""Number of sons of a node that is no leaf."""
NONE = -1
"""Number in place of a node that does not exist."""


class Tree(NamedTuple):
    """Tree of separating planes.

    Attributes:
        father: (n,) father of each node; NONE for the root.
        above: (n,) son on the side of the plane's normal; NONE for a leaf.
        below: (n,) son on the other side; NONE for a leaf.
        plane: (n, 4) unit normal N and distance D of each node's plane [m]; zero for a leaf.
        first: (n + 1,) first of each leaf's clusters in `clusters`; nodes that are no leaves have none.
        clusters: (m,) clusters of all leaves.
    """

    father: Indices
    above: Indices
    below: Indices
    plane: Array
    first: Indices
    clusters: Indices


class _Node(NamedTuple):
    father: int
    plane: Array
    clusters: tuple[int, ...]


def tree_of(store: Store, members: Indices) -> Tree:
    """Return a tree of clusters that are in one frame.

    At each node, of all planes of faces and all planes between two clusters, the plane that cuts no cluster and divides
    them most evenly is used.

    Args:
        store: the clusters, each in its own frame.
        members: numbers of clusters in one frame.
    """
    planes = _candidates(store, members)
    sides = _sides(store, members, planes)
    nodes: list[_Node] = []
    sons: list[list[int]] = []

    def add(own: Indices, father: int) -> int:
        """Add the node of some members, given by their indices in `members`, and its descendants."""
        number = len(nodes)
        sons.append([NONE, NONE])
        above, below = (sides[:, own] > 0).sum(axis=1), (sides[:, own] < 0).sum(axis=1)
        free = (above + below == len(own)) & (above > 0) & (below > 0)
        if len(own) == 1 or not free.any():
            nodes.append(_Node(father, np.zeros(4), tuple(int(members[k]) for k in own)))
            return number
        uneven = np.where(free, np.abs(above - below), len(own))
        best = int(uneven.argmin())
        nodes.append(_Node(father, planes[best], ()))
        sons[number] = [add(own[sides[best, own] > 0], number), add(own[sides[best, own] < 0], number)]
        return number

    add(np.arange(len(members)), NONE)
    counts = [len(node.clusters) for node in nodes]
    return Tree(
        np.array([node.father for node in nodes], dtype=np.int64),
        np.array([above for above, _ in sons], dtype=np.int64),
        np.array([below for _, below in sons], dtype=np.int64),
        np.array([node.plane for node in nodes]),
        np.cumsum([0, *counts]),
        np.array([cluster for node in nodes for cluster in node.clusters], dtype=np.int64),
    )


def _candidates(store: Store, members: Indices) -> Array:
    """Return the planes (c, 4) of all faces of the members, and a plane between each two of them."""
    faces = [store.planes[store.first_face[k] : store.first_face[k + 1]] for k in members.tolist()]
    between = []
    for n, i in enumerate(members.tolist()):
        for j in members[:n].tolist():
            plane = np.empty(4)
            if plane_of(store, i, j, plane) >= -ON:
                between.append(plane)
    return np.concatenate([*faces, np.array(between).reshape(-1, 4)])


def _sides(store: Store, members: Indices, planes: Array) -> Indices:
    """Return for each plane and member (c, m): 1 above the plane, -1 below it, 0 if the plane cuts the member."""
    found = np.zeros((len(planes), len(members)), np.int64)
    for n, k in enumerate(members.tolist()):
        points = store.points[store.first_point[k] : store.first_point[k + 1]]
        heights = planes[:, :3] @ points.T - planes[:, 3:]
        found[:, n] = (heights.min(axis=1) >= -ON).astype(int) - (heights.max(axis=1) <= ON).astype(int)
    return found


class Forest(NamedTuple):
    """The trees of all frames, in one set of arrays.

    Attributes:
        root: (F,) root of each frame's tree.
        tree: the nodes of all trees; their clusters are counted over all frames.
    """

    root: Indices
    tree: Tree


def forest_of(store: Store, frame: Indices, frames: int) -> Forest:
    """Return the trees of all frames; `frame` (N,) is the frame of each cluster."""
    trees = [tree_of(store, np.flatnonzero(frame == f)) for f in range(frames)]
    roots = np.cumsum([0, *(len(tree.father) for tree in trees)])
    firsts = np.cumsum([0, *(len(tree.clusters) for tree in trees)])

    def nodes(parts: list[Indices]) -> Indices:
        """Join arrays of numbers of nodes."""
        moved = [np.where(part == NONE, NONE, part + root) for part, root in zip(parts, roots[:-1], strict=True)]
        return np.concatenate(moved)

    joined = Tree(
        nodes([tree.father for tree in trees]),
        nodes([tree.above for tree in trees]),
        nodes([tree.below for tree in trees]),
        np.concatenate([tree.plane for tree in trees]),
        np.concatenate(
            [*(tree.first[:-1] + first for tree, first in zip(trees, firsts[:-1], strict=True)), firsts[-1:]]
        ),
        np.concatenate([tree.clusters for tree in trees]),
    )
    return Forest(roots[:-1], joined)


@law
def trace(tree: Tree, root: int, eye: Vector, indicator: Indices, rank: Indices) -> None:
    """Write the ranks of a tree's clusters: 0 for the highest priority; clusters of one leaf have the same rank.

    Args:
        tree: the tree.
        root: the node at which the trace begins.
        eye: position of the eye in the frame of the tree [m] (the frame's L vector).
        indicator: (n,) number of sons of each node that are done; 0 before and after the trace.
        rank: (N,) output: rank of each cluster.
    """
    node, count = root, 0
    father, above, below, plane = tree.father, tree.above, tree.below, tree.plane
    while node != NONE:
        if above[node] == NONE:
            for k in range(tree.first[node], tree.first[node + 1]):
                rank[tree.clusters[k]] = count
            count += 1
            node = father[node]
            continue
        done = indicator[node]
        if done == SONS:  # third pass
            indicator[node] = 0
            node = father[node]
            continue
        indicator[node] = done + 1
        on_top = plane[node, 0] * eye.x + plane[node, 1] * eye.y + plane[node, 2] * eye.z > plane[node, 3]
        # the son on the eye's side comes first
        node = above[node] if on_top == (done == 0) else below[node]


@law
def trace_all(forest: Forest, poses: Array, listed: Mask, rank: Indices) -> None:
    """Write the ranks of all clusters among those of the same frame.

    Args:
        forest: the trees.
        poses: (F, 12) poses of the frames in the coordinates of the camera.
        listed: (F,) 1 for each frame whose clusters already have their ranks, from a permanent list.
        rank: (N,) output.
    """
    indicator = np.zeros(len(forest.tree.father), np.int64)
    for f in range(len(forest.root)):
        if not listed[f]:
            away = Vector(-poses[f, 0], -poses[f, 1], -poses[f, 2])
            trace(forest.tree, forest.root[f], turned_back(poses[f], away), indicator, rank)
