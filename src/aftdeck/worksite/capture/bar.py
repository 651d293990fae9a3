"""Prong end effector of the concept arm: it acquires a payload when the prong encloses the payload's bar (MODE 1)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np

from aftdeck.arms.switched import SwitchedJoint
from aftdeck.arrays import Array, Indices
from aftdeck.units import Length
from aftdeck.worksite.capture.acquisition import (
    AWAY,
    MEASURED,
    Tolerances,
    acquire,
    acquired_bar,
    acquisition,
)
from aftdeck.worksite.capture.effector import CaptureTable, Controls, EndEffector, MadeFor, Moved, Nearest
from aftdeck.worksite.conditions import Condition, Units
from aftdeck.worksite.payload import part_of
from aftdeck.worksite.report import Hand
from aftdeck.worksite.tables import positive
from aftdeck.worksite.watch.groups import Placing

HEXES = ("palm", "fixed finger", "prong")
"""Parts of the end effector: HEX 1 to 3."""


class BarFile(CaptureTable, frozen=True, kw_only=True, tag="bar"):
    """Conditions for the concept's end effector to acquire a bar; the report's names are in brackets."""

    prong_spacing: Length
    """Greatest distance of the prong's inner face from the palm's centre line at which the prong counts as closed
    (PRGSPC)."""
    window: Length
    """Greatest height of the palm above the bar's top (TOPB)."""
    front: Length
    """Least distance of the palm's centre from the bar's forward end, inwards along the bar (FRONT)."""
    rear: Length
    """Least distance of the palm's centre from the bar's aft end, inwards along the bar (REAR)."""
    fingers_within: Length
    """Greatest distance between palm and bar at which conditions 2 and 3 (bar beside the fingers) are tested. At a
    greater distance, both conditions fail."""

    def __post_init__(self) -> None:
        """Reject a `prong_spacing`, `window` or `fingers_within` that is not above zero (ValueError)."""
        positive(prong_spacing=self.prong_spacing, window=self.window, fingers_within=self.fingers_within)

    def effector(self, site: MadeFor) -> EndEffector | None:
        """Return the constants of capture by a prong; None if the arm has no prong."""
        prong = site.model.prong
        if prong is None:
            return None
        spacing = float(self.prong_spacing) + prong.facing
        tolerances = Tolerances(spacing, *map(float, (self.window, self.front, self.rear, self.fingers_within)))
        bars = np.full((len(site.payloads), len(HEXES) + 1), -1, dtype=np.int64)
        for row, payload in zip(bars, site.payloads, strict=True):
            if payload.receptacle is not None:
                row[:] = [site.parts.index(name) for name in (*HEXES, part_of(payload.name, "receptacle"))]
        return Bar(site.hand, site.rows, tolerances, tolerances.packed(), bars, prong.facing)


@dataclass(frozen=True, eq=False)
class Bar(EndEffector):
    """Constants of capture by a prong about a bar.

    Attributes:
        tolerances: tolerances of acquisition.
        packed: (5,) `tolerances` as an array for the law.
        bars: (c, 4) for each payload, the indices of four solids in the layout: HEX 1, HEX 2, HEX 3 and the payload's
            bar; -1 for a payload without a bar.
        fixed_finger: y2 of the fixed finger's inner face [m].
    """

    tolerances: Tolerances
    packed: Array
    bars: Indices
    fixed_finger: float

    action: ClassVar[Literal["acquire", "capture"]] = "acquire"

    def solids(self, payload: int) -> Indices | None:
        """Return the payload's row of `bars`; None if the payload has no bar."""
        solids: Indices = self.bars[payload]
        return None if solids[0] < 0 else solids

    def measured(self, place: Placing, payload: int) -> Array | None:
        """Return the measures (9,) of `acquire` for a payload; None without a bar."""
        if (solids := self.solids(payload)) is None:
            return None
        found = np.empty(MEASURED)
        acquire(place(solids), solids, self.packed, found)
        return found

    def nearest(self, frames: Array, place: Placing, within: float) -> Nearest | None:
        """Return the payload whose bar is nearest to the palm; None if no bar is nearer than `within` [m]."""
        del frames
        best = None
        for payload in range(len(self.bars)):
            found = self.measured(place, payload)
            if found is not None and found[AWAY] < within:
                best, within = (payload, found), float(found[AWAY])
        return None if best is None else Nearest(best[0], acquisition(best[1], self.packed))

    def conditions(self, frames: Array, place: Placing, payload: int) -> tuple[Condition, ...]:
        """Return the conditions of acquisition; () for a payload without a bar."""
        del frames
        found = self.measured(place, payload)
        return () if found is None else acquisition(found, self.packed)

    def step(
        self, controls: Controls, held: int | None, frames: Array, place: Placing, period: float, units: Units
    ) -> Moved | None:
        """Return the payload that the fingers now capture or release.

        They capture a payload if the six conditions of acquisition hold, and release it if they are too far apart. The
        prong itself has moved before.
        """
        del frames, period, units
        if held is not None:
            apart = self.fixed_finger - controls.prong > self.tolerances.spacing
            return Moved(held, controls.snare) if apart else None
        payload = acquired_bar(place(self.bars[self.bars >= 0]), self.bars, self.packed)
        return None if payload < 0 else Moved(payload, controls.snare)


def status(switch: Literal["stop", "close", "open"], prong: float, sizes: SwitchedJoint, *, holds: bool) -> Hand:
    """Return the record of a prong end effector.

    Args:
        switch: position of the end effector's switch.
        prong: y2 of the prong's inner face [m].
        sizes: range of the prong.
        holds: whether a payload is in the grasp.
    """
    opening = (sizes.greatest - prong) / (sizes.greatest - sizes.least)
    shows = (("CAPTURE", holds), ("CLOSE", opening == 0.0), ("OPEN", opening == 1.0))
    lit = tuple(name for name, on in shows if on)
    return Hand(switch, opening, sizes.facing - prong, None, lit)
