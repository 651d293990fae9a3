"""Trees of separating planes, as Figures 15 to 19 of RMS-VS have them: nodes, lists of clusters, special priority."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import TypeAlias


@dataclass(frozen=True)
class Split:
    """Node of a tree: a plane with its two sons.

    Attributes:
        plane: name of the plane. Its normal points to the clusters of `true`.
        true: son on the plane's TRUE side.
        false: son on its FALSE side.
    """

    plane: str
    true: Son
    false: Son


@dataclass(frozen=True)
class Sorted:
    """Special priority: a tree is traced, and one more cluster is sorted into the list that results.

    The cluster begins at the bottom of the list. If the observer is on the TRUE side of a test's plane, which is the
    cluster's own side, the cluster is inserted just ahead of the first of the test's clusters, unless it is there
    already.

    Attributes:
        tree: the tree that is traced first.
        cluster: number of the cluster that is sorted in.
        tests: pairs of a plane's name and the clusters on the plane's FALSE side.
    """

    tree: Son
    cluster: int
    tests: tuple[tuple[str, tuple[int, ...]], ...]


Son: TypeAlias = int | tuple[int, ...] | Split | Sorted
"""Son of a node: a cluster's number; a fixed list of clusters; a node; or a special priority."""


def clusters_in(son: Son) -> tuple[int, ...]:
    """Return the numbers of all clusters of a tree, in the order of its sons."""
    if isinstance(son, int):
        return (son,)
    if isinstance(son, Split):
        return (*clusters_in(son.true), *clusters_in(son.false))
    if isinstance(son, Sorted):
        return (*clusters_in(son.tree), son.cluster)
    return son


def nodes_in(son: Son) -> Iterator[Split | Sorted]:
    """Yield all nodes and special priorities of a tree; a father before its sons."""
    if isinstance(son, Split):
        yield son
        yield from nodes_in(son.true)
        yield from nodes_in(son.false)
    elif isinstance(son, Sorted):
        yield son
        yield from nodes_in(son.tree)


def pruned(son: Son, present: Collection[int]) -> Son:
    """Return a tree without the clusters that are not present; an empty list if none is left."""
    if isinstance(son, int):
        return son if son in present else ()
    if isinstance(son, Split):
        true, false = pruned(son.true, present), pruned(son.false, present)
        if true == () or false == ():
            return false if true == () else true
        return Split(son.plane, true, false)
    if isinstance(son, Sorted):
        tree = pruned(son.tree, present)
        if son.cluster not in present:
            return tree
        tests = tuple((plane, tuple(k for k in others if k in present)) for plane, others in son.tests)
        return Sorted(tree, son.cluster, tuple(test for test in tests if test[1]))
    return tuple(k for k in son if k in present)
