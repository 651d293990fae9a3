"""A cargo's place in a seat: constants for the laws of docking and berthing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import row_of
from aftdeck.worksite.berthing import Guide, Guides, SeatTolerances, prepare
from aftdeck.worksite.cargo import part_of
from aftdeck.worksite.docking import DockingTolerances
from aftdeck.worksite.model import Cargo, Seat

KEEL = "keel"
"""Name of the trunnion under the cargo."""


@dataclass(frozen=True, eq=False)
class Berth:
    """One cargo's place in one seat.

    Attributes:
        seat: which.
        row: of the frame that the seat is fixed in.
        place: (12,) the seated cargo's pose in that frame.
        port: (12,) the port's pose in that frame; None: it is a place in the bay.
        probe: (n, 3) vertices of the cargo's probe, in the cargo's axes [m].
        tip: (3,) centre of the probe's forward face [m].
        docking: what the port allows.
        guides: of the bay's latches; None: it has none.
        tolerances: of a place in the bay.
    """

    seat: Seat
    row: int
    place: Array
    port: Array | None
    probe: Array
    tip: Array
    docking: DockingTolerances
    guides: Guides | None
    tolerances: SeatTolerances

    @property
    def at_once(self) -> bool:
        """Whether it takes hold by itself as soon as it may: a docking port."""
        return self.port is not None

    @property
    def lies(self) -> bool:
        """Whether a cargo merely lies there: kept where it is let go, and taken along with the arm."""
        return self.port is None and self.seat.latch == "auto"

    @property
    def verb(self) -> str:
        """What is done there."""
        return "dock" if self.at_once else "insert" if self.lies else "berth"


def berth_of(seat: Seat, row: int, cargo: Cargo, axes: str) -> Berth:
    """A cargo's place in a seat that takes it; `axes` says which docking compares."""
    place = seat.seated(cargo.probe)
    probe = [solid.vertices for solid in cargo.solids if solid.part == part_of(cargo.name, "probe")]
    tip = np.zeros(3) if cargo.probe is None else cargo.probe.position
    guides = None
    if seat.guides is not None:
        seats = place.position + cargo.trunnions @ place.rotation.T
        guides = prepare([_guide(seat, name, point) for name, point in zip(cargo.trunnion_names, seats, strict=True)])
    return Berth(
        seat,
        row,
        row_of(place),
        row_of(seat.pose) if seat.kind == "port" else None,
        np.unique(np.concatenate(probe), axis=0) if probe else np.empty((0, 3)),
        tip,
        DockingTolerances(seat.distance, seat.angle, "y" if axes == "y" else "all"),
        guides,
        SeatTolerances(seat.distance, seat.angle),
    )


def _guide(seat: Seat, name: str, point: Array) -> Guide:
    """The guide of a trunnion: the keel's opens across the bay, the others along it."""
    guides = seat.guides
    assert guides is not None, "only seats with guides have them"
    x, y, z = point.tolist()
    return Guide(
        name=name,
        seat=(x, y, z),
        up=(0.0, 0.0, 1.0),
        along=(0.0, 1.0, 0.0) if name == KEEL else (1.0, 0.0, 0.0),
        half_angle=guides.half_angle,
        height=guides.height,
        throat=guides.throat,
        play=guides.play,
    )
