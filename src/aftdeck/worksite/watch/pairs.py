"""Monitored pairs of parts, and the selection of the pairs that are measured at present."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from itertools import combinations

import numpy as np

from aftdeck.arrays import Mask
from aftdeck.bodies.solid import Solid
from aftdeck.errors import InputError
from aftdeck.worksite.watch.groups import Layout, PartPair

STILL = ("space", "orbiter")
"""Frames of the bodies around the arm. In a pair, a part in one of these frames comes after a part of the arm or of a
payload; a part in ``orbiter`` also comes after a part in ``space``."""


def part_pairs(solids: Sequence[Solid], chain: Sequence[str], apart: Iterable[PartPair] = ()) -> tuple[PartPair, ...]:
    """Return all pairs of parts that can touch, among the parts of the arm, of the payloads and of the bodies.

    Two parts in one frame are not a pair. Two parts of the arm in successive frames of the chain are not a pair either,
    because a joint connects them; frames without solids are skipped in the chain. A stationary part of the arm cannot
    move relative to the structure that carries the arm: the caller has to list these pairs in `apart`.

    Args:
        solids: all solids of the run.
        chain: the arm's frames from its base to its tip, then a frame that moves relative to the tip, if there is one.
        apart: further pairs to leave out (parts that are joined or never touch), with their parts in either order.

    Returns:
        The pairs. The order within a pair is: parts of the arm first, then parts of payloads, then parts of bodies.

    Raises:
        InputError: `apart` names a part that has no solid.
    """
    home = {solid.part: solid.frame for solid in solids}
    left_out = {frozenset(pair) for pair in apart}
    for name in sorted({name for pair in left_out for name in pair} - set(home)):
        raise InputError(f"a pair to leave out names {name!r}; parts are {', '.join(home)}")
    used = set(home.values())
    link = {frame: k for k, frame in enumerate(frame for frame in chain if frame in used)}

    def rank(part: str) -> int:
        frame = home[part]
        return 0 if frame in link else 2 + STILL.index(frame) if frame in STILL else 1

    found = []
    for a, b in combinations(sorted(home, key=rank), 2):
        frame_a, frame_b = home[a], home[b]
        joined = frame_a in link and frame_b in link and abs(link[frame_a] - link[frame_b]) == 1
        if frame_a != frame_b and not joined and frozenset((a, b)) not in left_out:
            found.append((a, b))
    return tuple(found)


def counting(
    layout: Layout,
    holder: Collection[str] = (),
    held: Collection[str] = (),
    seated: Mapping[str, Collection[str]] | None = None,
) -> Mask:
    """Return a mask (g,): 1 for each group that is measured, 0 for each group of a payload and its carrier.

    The held payload is carried by the end effector. A payload in a berth is carried by the berth's body.

    Args:
        layout: the layout with the groups.
        holder: the parts of the arm that hold a payload.
        held: the parts of the held payload.
        seated: the parts of each payload that is in a berth and not held; for each part, the parts of the berth's body.
    """
    active = np.ones(len(layout.groups), np.uint8)
    active &= 1 - layout.between(holder, held)
    for part, body_parts in (seated or {}).items():
        active &= 1 - layout.between((part,), body_parts)
    return active


def among(layout: Layout, pairs: Iterable[PartPair]) -> Mask:
    """Return a mask (g,): 1 for each group that is one of these pairs of parts, in either order.

    Pairs that are not monitored are ignored.

    Raises:
        InputError: a name does not belong to a part.
    """
    found = np.zeros(len(layout.groups), np.uint8)
    for a, b in pairs:
        found |= layout.between((a,), (b,))
    return found
