"""Bay berth: latches that close on command, with V-guides for trunnions or without, or a passive berth.

A passive berth has no latches: it fixes a payload that the end effector releases in it, and frees it at its capture.
Source: *Remote Manipulator Simulation*, section VII: a payload that is inserted and released stays where it is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.pair import PAIR
from aftdeck.bodies.solid import Solid
from aftdeck.law import law
from aftdeck.matrices import product
from aftdeck.units import Angle, Length
from aftdeck.worksite.berths.berth import Berth, BerthTable, Fit, place_of
from aftdeck.worksite.berths.berthing import (
    OFFSET,
    BerthTolerances,
    Guide,
    Guides,
    in_guides,
    inside,
    offsets,
    prepare,
    ready_to_latch,
    retained,
)
from aftdeck.worksite.body import Body
from aftdeck.worksite.conditions import Condition
from aftdeck.worksite.payload import Payload
from aftdeck.worksite.tables import Table, positive
from aftdeck.worksite.watch.near import touch

KEEL = "keel"
"""Name of the trunnion under the payload."""


class GuidesFile(Table, frozen=True, kw_only=True):
    """V-shaped guides over each longeron latch."""

    height: Length
    """Height of the guides' upper ends above the stowed trunnion."""
    half_angle: Angle
    """Angle between the vertical and each side of the V."""
    throat: Length
    """Half the width of the V at the height of the stowed trunnion, minus the trunnion's radius."""
    play: Length
    """Greatest offset of a trunnion along its own axis, in either direction."""

    def __post_init__(self) -> None:
        """Reject values that are not above zero (ValueError)."""
        positive(height=self.height, half_angle=self.half_angle, throat=self.throat, play=self.play)


class RetentionFile(BerthTable, frozen=True, kw_only=True, tag="retention"):
    """A berth in the bay. Its position and rotation equal those of a payload that is fixed in the berth."""

    latch: Literal["auto", "command"]
    """Event at which the berth fixes a payload that meets the conditions. ``auto``: the end effector releases the
    payload. ``command``: LATCH."""
    guides: GuidesFile | None = None
    """V-guides. A berth with V-guides holds only payloads that have trunnions."""

    def berth(self, body: Body, solids: Sequence[Solid]) -> BayBerth:
        """Return the berth; arguments as for `BerthTable.berth`."""
        del solids
        passive = self.latch == "auto"
        return BayBerth(
            **self.common(body),
            closes="at release" if passive else "on command",
            instant=passive,
            verb="insert" if passive else "berth",
            needs="trunnions" if self.guides else "",
            guides=self.guides,
        )


class BayBerth(Berth, frozen=True, eq=False, kw_only=True):
    """A berth in the bay. Its pose is that of a payload that is fixed in it."""

    out: ClassVar[int] = 2
    away: ClassVar[str] = "above"
    gives: ClassVar[float] = 0.1

    guides: GuidesFile | None
    """V-guides; None if there are none."""

    @property
    def mouth(self) -> float:
        """Distance from the seated position, upwards, at which the V-guides end [m]; 0 without any."""
        return 0.0 if self.guides is None else float(self.guides.height)

    def fit(self, payload: Payload, row: int, axes: str) -> Fit:
        """Return the constants of a payload in this berth; arguments as for `Berth.fit`."""
        del axes
        place, tolerances = place_of(self, payload), BerthTolerances(self.distance, self.angle)
        if self.guides is None:
            return BayFit(self, row, place, tolerances)
        seats = place[:3] + product(payload.trunnions, place[3:].reshape(3, 3).T)
        points = zip(payload.trunnion_names, seats, strict=True)
        guides = prepare([_guide(self.guides, name, point) for name, point in points])
        return GuidedFit(self, row, place, tolerances, guides, payload.trunnions)


@dataclass(frozen=True, eq=False)
class BayFit(Fit):
    """Constants of one payload in one bay berth.

    Attributes:
        tolerances: greatest distance and angle at which the berth fixes the payload.
    """

    tolerances: BerthTolerances

    relation: ClassVar[Literal["guides"] | None] = None

    def conditions(self, frames: Array, payload: int) -> tuple[Condition, ...]:
        """Return the conditions under which the payload stays in the berth."""
        return retained(self.offset(frames, payload), self.tolerances)


@dataclass(frozen=True, eq=False)
class GuidedFit(BayFit):
    """Constants of one payload in one bay berth with V-guides.

    Attributes:
        guides: the V-guides, one for each trunnion.
        trunnions: (n, 3) centres of the trunnions in the payload's frame [m].
    """

    guides: Guides
    trunnions: Array

    relation: ClassVar[Literal["guides"] | None] = "guides"

    def conditions(self, frames: Array, payload: int) -> tuple[Condition, ...]:
        """Return the conditions of latching: trunnions in their guides, and latches ready."""
        off, trunnions = self.offset(frames, payload), self.trunnion_offsets(frames, payload)
        return (*in_guides(trunnions, self.guides), *ready_to_latch(trunnions, off, self.guides, self.tolerances))

    def trunnion_offsets(self, frames: Array, payload: int) -> Array:
        """Return the offsets (n, 4) of the payload's trunnions from their seats (`berthing.offsets`)."""
        found = np.empty((len(self.trunnions), OFFSET))
        offsets(frames[self.row], frames[payload], self.trunnions, self.guides.seats, self.guides.axes, found)
        return found


@law
def guided(
    found: Array,
    opening: Array,
    throat: Array,
    height: Array,
    play: Array,
    placed: Array,
    pairs: Indices,
    trunnions: Indices,
    depth: float,
) -> bool:
    """Return whether every trunnion in contact is inside the mouth of its own V-guide.

    Args:
        found: (n, 4) result of `berthing.offsets`.
        opening: `Guides.opening`.
        throat: `Guides.throat`.
        height: `Guides.height`.
        play: `Guides.play`.
        placed: (s, 52) all solids in L.
        pairs: (m, 2) pairs of solids of trunnions and guides.
        trunnions: (m,) trunnion to which each pair belongs.
        depth: permitted penetration depth [m].
    """
    pair = np.zeros(PAIR)
    for k in range(len(pairs)):
        if inside(trunnions[k], found, opening, throat, height, play) >= -depth:
            continue
        if touch(placed[pairs[k, 0]], placed[pairs[k, 1]], pair):
            return False
    return True


def _guide(guides: GuidesFile, name: str, point: Array) -> Guide:
    """Return the V-guide of a trunnion.

    The V-guide of the keel trunnion centres the payload across the bay. That of each other trunnion centres it along
    the bay.
    """
    x, y, z = point.tolist()
    return Guide(
        name=name,
        seat=(x, y, z),
        up=(0.0, 0.0, 1.0),
        along=(0.0, 1.0, 0.0) if name == KEEL else (1.0, 0.0, 0.0),
        half_angle=float(guides.half_angle),
        height=float(guides.height),
        throat=float(guides.throat),
        play=float(guides.play),
    )
