"""Which parts are watched against which, and which of these pairs count at the moment."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import combinations

import numpy as np

from aftdeck.arrays import Mask
from aftdeck.bodies.solid import Solid
from aftdeck.errors import InputError
from aftdeck.worksite.layout import Layout, PartPair

STILL = ("space", "orbiter")
"""Frames of the bodies around, which are named after what moves against them."""


def part_pairs(solids: Sequence[Solid], chain: Sequence[str], apart: Iterable[PartPair] = ()) -> tuple[PartPair, ...]:
    """Every pair of parts that can meet: the arm against all else, cargoes and the bodies around against each other.

    Parts of one frame are no pair, nor are parts of the arm whose frames follow each other in the chain (frames
    without solids do not count): a joint holds them together. That a part of the arm and what the arm is mounted on
    are no pair either, only the caller can know.

    Args:
        solids: of the whole flight.
        chain: the arm's frames from its base to its tip; what moves on the tip comes last.
        apart: pairs left out besides, in either order: joined, or never to meet.

    Returns:
        The pairs; of the two parts, the arm's comes first, then a cargo's, then a body's.

    Raises:
        InputError: `apart` names a part that has no solid.
    """
    home = {solid.part: solid.frame for solid in solids}
    left_out = {frozenset(pair) for pair in apart}
    for name in sorted({name for pair in left_out for name in pair} - set(home)):
        raise InputError(f"a pair to leave out names {name!r}; there are {', '.join(home)}")
    used = set(home.values())
    link = {frame: k for k, frame in enumerate(frame for frame in chain if frame in used)}

    def place(part: str) -> int:
        frame = home[part]
        return 0 if frame in link else 2 + STILL.index(frame) if frame in STILL else 1

    found = []
    for a, b in combinations(sorted(home, key=place), 2):
        one, other = home[a], home[b]
        joined = one in link and other in link and abs(link[one] - link[other]) == 1
        if one != other and not joined and frozenset((a, b)) not in left_out:
            found.append((a, b))
    return tuple(found)


def counting(
    layout: Layout,
    holder: Collection[str] = (),
    held: Collection[str] = (),
    seated: Mapping[str, Collection[str]] | None = None,
) -> Mask:
    """(g,) 1 for each group that is looked at: all but what holds a cargo, or what a cargo rests in.

    Args:
        layout: the groups.
        holder: the parts of the arm that hold a cargo.
        held: the parts of the cargo that they hold.
        seated: by part of a cargo that lies in its seat and is not held, the parts of that seat's body.
    """
    active = np.ones(len(layout.groups), np.uint8)
    active &= 1 - layout.between(holder, held)
    for part, seat in (seated or {}).items():
        active &= 1 - layout.between((part,), seat)
    return active


def among(layout: Layout, pairs: Iterable[PartPair]) -> Mask:
    """(g,) 1 for each group that is one of these pairs of parts, in either order; pairs not watched are passed over.

    Raises:
        InputError: no part of such a name.
    """
    found = np.zeros(len(layout.groups), np.uint8)
    for a, b in pairs:
        found |= layout.between((a,), (b,))
    return found
