"""MAINPRIOR: the trace of lists and trees that makes the priority output table (POT), as chapter V.C.1 describes it.

Each node is passed three times. Its indicator (Figure 17) has two fields: F, the son that the plane's test did not
select, and S, which is set from the second pass to the third. A node whose plane is tested in another system than the
planes above it has a new-L flag: its first pass puts this system on the pushdown stack of L vectors, and its third pass
removes it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple, TypeAlias

from aftdeck.mainprior.tables import Item, System, system_of, tree_name
from aftdeck.mainprior.trees import Son, Sorted, Split

OnTrueSide = Callable[[str, System], bool]
"""Test of the observer against a plane, given its name, with the L vector of a system: True on the plane's TRUE
side."""


class _Node:
    """Node of a tree during a trace (Figure 16), with the fields of its indicator (Figure 17).

    Attributes:
        plane: name of the plane.
        sons: TRUE son and FALSE son.
        father: the node above; None for the root.
        new_system: the system of the new-L flag; None if the plane is tested in the system of the planes above it.
        other: F: the son that the test did not select; None before the test, and after the second pass.
        third: S: whether the next pass is the third one.
    """

    __slots__ = ("father", "new_system", "other", "plane", "sons", "third")

    def __init__(self, split: Split, father: _Node | None, system: System) -> None:
        """Link a node and all nodes below it; `system` is the L vector in force above it."""
        self.plane, self.father = split.plane, father
        own = system_of(split.plane)
        self.new_system = own if own != system else None
        self.sons: tuple[_Son, _Son] = self._linked(split.true, own), self._linked(split.false, own)
        self.other: _Son | None = None
        self.third = False

    def _linked(self, son: Son, system: System) -> _Son:
        return _Node(son, self, system) if isinstance(son, Split) else son


_Son: TypeAlias = "_Node | int | tuple[int, ...] | Sorted"


class Select(NamedTuple):
    """Instruction of the POT: the system whose L vector is used for the aspect tests that follow."""

    system: System


class Aspect(NamedTuple):
    """Instruction of the POT: the aspect test (AXT) and the display of a cluster."""

    cluster: int


Instruction = Select | Aspect


def traced(items: Sequence[Item], trees: Mapping[str, Son], mode: int, on_true_side: OnTrueSide) -> list[int]:
    """Return the clusters of a permanent list, highest priority first.

    Args:
        items: the list.
        trees: the trees, by name.
        mode: the task phase, for the mode tests.
        on_true_side: tests the observer against a plane.
    """
    found: list[int] = []
    for item in items:
        if isinstance(item, int):
            found.append(item)
        else:
            tree = trees[tree_name(item, mode)]
            found += _clusters(tree, first_system(tree), on_true_side)
    return found


def output_table(clusters: Sequence[int], system_of: Mapping[int, System]) -> tuple[Instruction, ...]:
    """Return the POT of clusters: an L vector is selected wherever the system differs from that of the cluster before.

    In the report, flags of list entries and sons have this effect.
    """
    found: list[Instruction] = []
    last: System | None = None
    for cluster in clusters:
        if system_of[cluster] != last:
            last = system_of[cluster]
            found.append(Select(last))
        found.append(Aspect(cluster))
    return tuple(found)


def first_system(son: Son) -> System:
    """Return the system of the first plane of a tree: the L vector select code of the entry that refers to the tree."""
    while isinstance(son, Sorted):
        son = son.tree
    return system_of(son.plane) if isinstance(son, Split) else "LR"


def _clusters(son: Son, system: System, on_true_side: OnTrueSide) -> list[int]:
    """Return the clusters of a son; `system` is the L vector in force."""
    if isinstance(son, Split):
        return _trace(son, system, on_true_side)
    if isinstance(son, Sorted):
        return _special_priority(son, system, on_true_side)
    return [son] if isinstance(son, int) else list(son)


def _trace(root: Split, system: System, on_true_side: OnTrueSide) -> list[int]:
    """Return the clusters of a tree; `system` is at the bottom of the pushdown stack."""
    found: list[int] = []
    stack = [system]
    node: _Node | None = _Node(root, None, system)
    while node is not None:
        if node.third:
            node.third = False
            if node.new_system is not None:
                stack.pop()
            node = node.father
            continue
        if node.other is None:
            if node.new_system is not None:
                stack.append(node.new_system)
            true, false = node.sons
            won, node.other = (true, false) if on_true_side(node.plane, stack[-1]) else (false, true)
        else:
            won, node.other, node.third = node.other, None, True
        if isinstance(won, _Node):
            node = won
        else:
            found += _clusters(won, stack[-1], on_true_side)
    return found


def _special_priority(special: Sorted, system: System, on_true_side: OnTrueSide) -> list[int]:
    """Return the clusters of a special priority: the list of its tree, with one more cluster sorted in."""
    found = [*_clusters(special.tree, system, on_true_side), special.cluster]
    for plane, others in special.tests:
        first = min(found.index(k) for k in others)
        now = found.index(special.cluster)
        if now > first and on_true_side(plane, system_of(plane)):
            found.insert(first, found.pop(now))
    return found
