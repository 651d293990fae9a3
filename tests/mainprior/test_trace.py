"""The trace of MAINPRIOR: against a recursion, and the special priority as its flow chart has it."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np
import pytest

from aftdeck.mainprior.tables import CLUSTERS, LISTS, TREES, X1, System, system_of
from aftdeck.mainprior.trace import Aspect, Select, output_table, traced
from aftdeck.mainprior.trees import Son, Sorted, Split
from tests.each import each, seeds

PLANES = ("1", "8", "11", "12", "13", "18")
"""Planes that are tested in five different systems."""


def random_tree(rng: np.random.Generator, leaves: list[int]) -> Son:
    """Return a random tree with these clusters; some leaves are fixed lists."""
    if len(leaves) == 1:
        return leaves[0]
    if len(leaves) < 4 and rng.random() < 0.3:
        return tuple(leaves)
    at = int(rng.integers(1, len(leaves)))
    return Split(str(rng.choice(PLANES)), random_tree(rng, leaves[:at]), random_tree(rng, leaves[at:]))


def recursion(son: Son, is_true: Callable[[str], bool]) -> list[int]:
    """Return the clusters of a tree: those on the observer's side first."""
    if isinstance(son, Split):
        sons = (son.true, son.false) if is_true(son.plane) else (son.false, son.true)
        return [k for part in sons for k in recursion(part, is_true)]
    assert not isinstance(son, Sorted)
    return [son] if isinstance(son, int) else list(son)


@each("seed", seeds(60, 2000))
def test_three_passes_order_a_tree_and_test_each_plane_in_its_system(seed: int) -> None:
    rng = np.random.default_rng(seed)
    tree = random_tree(rng, list(range(1, int(rng.integers(2, 14)))))
    sides = {plane: bool(rng.integers(2)) for plane in PLANES}

    def on_true_side(plane: str, system: System) -> bool:
        assert system == system_of(plane)
        return sides[plane]

    assert traced(("tree",), {"tree": tree}, 1, on_true_side) == recursion(tree, sides.__getitem__)


@each("sides", lambda: product((False, True), repeat=5))
def test_the_bar_is_sorted_into_the_end_effector_as_the_flow_chart_has_it(sides: tuple[bool, ...]) -> None:
    """Figure 19, page 4: 19 at the bottom; ahead of 17 by D1; ahead of 16 by D2 and of 18 by D3, unless it is."""
    palm_first, fixed_first, *lifted = sides
    fingers = [16, 18] if fixed_first else [18, 16]
    hand = [17, *fingers] if palm_first else [*fingers, 17]
    place = min([hand.index(k) for k, lift in zip((17, 16, 18), lifted, strict=True) if lift], default=3)
    on = dict(zip(("14", "15", "D1", "D2", "D3"), sides, strict=True))
    found = traced(("X1",), {"X1": X1}, 1, lambda plane, _: on[plane])
    assert found == [*hand[:place], 19, *hand[place:]]


@pytest.mark.parametrize(
    ("station", "modes"), [("F", (1, 2, 2, 2)), ("G", (1, 2, 2, 2)), ("H", (1, 1, 2, 2)), ("A", (2, 2, 2, 2))]
)
def test_the_mode_test_selects_the_trees_of_table_vii(station: str, modes: tuple[int, ...]) -> None:
    """With the payload in the arm's tree in mode number 2 of Z, and in the shuttle's tree in number 1 of Y."""
    for mode, number in enumerate(modes, 1):
        found = traced(LISTS[station], TREES, mode, lambda *_: True)
        arm = [k for k in found if k in (*range(13, 20), 22, 23, 24)]
        first, last = found.index(arm[0]), found.index(arm[-1])
        assert sorted(found[first : last + 1]) == sorted(arm)  # the arm is one block
        assert found.count(20) == 1
        if station != "A":
            fixed = [found.index(k) for k in (1, 2, 3, 4, 6, 7, 8, 10, 12)]
            assert (min(fixed) < found.index(20) < max(fixed)) == (number == 1)


def test_an_l_vector_is_selected_where_the_system_changes() -> None:
    systems = {number: own.system for number, own in CLUSTERS.items()}
    table = output_table((3, 6, 13, 17, 19, 16, 4), systems)
    assert table == (
        *(Select("LR"), Aspect(3), Aspect(6), Select("L0"), Aspect(13), Select("L2"), Aspect(17)),
        *(Select("LP"), Aspect(19), Select("L2"), Aspect(16), Select("LR"), Aspect(4)),
    )
