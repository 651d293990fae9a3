"""Constants for fixing a payload to a berth, for the laws of docking and berthing."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, relative, row_of
from aftdeck.matrices import product
from aftdeck.worksite.file.cargo import part_of
from aftdeck.worksite.model import Cargo, Seat
from aftdeck.worksite.seats.berthing import OFFSET, Guide, Guides, SeatTolerances, offsets, prepare
from aftdeck.worksite.seats.docking import DockingTolerances
from aftdeck.worksite.seats.on_way import OnWay, on_way, straight_before

KEEL = "keel"
"""Name of the trunnion under the payload."""


@dataclass(frozen=True, eq=False)
class Berth:
    """Pose of one payload in one berth, and the tolerances for fixing it there.

    Attributes:
        seat: the berth.
        row: index of the frame to which the berth is fixed, in the array of all frames.
        place: (12,) pose of the fixed payload in the berth's frame.
        port: (12,) pose of the port in the berth's frame; None for a bay berth.
        probe: (n, 3) vertices of the payload's probe, in the payload's axes [m].
        tip: (3,) centre of the probe's forward face, in the payload's axes [m].
        docking: greatest distance and angle at which a port docks the payload.
        guides: V-guides of the bay's latches; None if the berth has no guides.
        tolerances: greatest distance and angle at which a bay berth fixes the payload.
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

    def trunnion_offsets(self, frames: Array, cargo_row: int, trunnions: Array) -> Array:
        """Return the offsets (n, 4) of a payload's trunnions from their seats (`berthing.offsets`).

        Args:
            frames: (F, 12) poses of all frames in L.
            cargo_row: row of the payload's frame.
            trunnions: (n, 3) centres of the trunnions in the payload's frame [m].
        """
        assert self.guides is not None, "the berth has guides"
        found = np.empty((len(trunnions), OFFSET))
        offsets(frames[self.row], frames[cargo_row], trunnions, self.guides.seats, self.guides.axes, found)
        return found

    @cached_property
    def way_out(self) -> Array:
        """Unit vector (3,) in the payload's axes, along which it leaves the berth: out of the port, or upwards."""
        out = np.array([0.0, 0.0, 1.0])
        if self.port is not None:
            out = -product(self.port[3:].reshape(3, 3), self.seat.envelope[0, :3])
        return product(self.place[3:].reshape(3, 3).T, out)

    def offset(self, frames: Array, cargo_row: int) -> Array:
        """Return a payload's pose (12,) relative to its final pose in the berth.

        Args:
            frames: (F, 12) poses of all frames in L.
            cargo_row: row of the payload's frame.
        """
        place, off = np.empty(POSE), np.empty(POSE)
        compose(frames[self.row], self.place, place)
        relative(place, frames[cargo_row], off)
        return off

    def on_way(self, frames: Array, cargo_row: int) -> OnWay:
        """Return where a payload is on its way into the berth; arguments as for `offset`."""
        return on_way(frames[self.row], self.place, frames[cargo_row], self.way_out)

    def is_straight_ahead(self, frames: Array, cargo_row: int, depth: float, near: float, inside: float) -> bool:
        """Return whether a straight approach would bring a payload's probe to the port, which the berth must have.

        Args:
            frames: (F, 12) poses of all frames in L.
            cargo_row: row of the payload's frame.
            depth: depth behind the port's face up to which the probe counts as in front of it [m].
            near: greatest distance of the probe from the port [m].
            inside: least distance from the limits of the docking conditions after the approach [m].
        """
        assert self.port is not None, "the berth has a port"
        return straight_before(
            self.probe, self.tip, frames[cargo_row], frames[self.row], self.port, self.seat.envelope, depth, near,
            inside, self.docking.distance - inside,
        )  # fmt: skip

    @property
    def latches_automatically(self) -> bool:
        """Whether the berth is a docking port: it fixes a payload without a command if the docking conditions hold."""
        return self.port is not None

    @property
    def is_passive(self) -> bool:
        """Whether the berth fixes a payload at release by the end effector, and frees it at capture."""
        return self.port is None and self.seat.latch == "auto"

    @property
    def verb(self) -> Literal["dock", "insert", "berth"]:
        """Verb for moving a payload into the berth."""
        return "dock" if self.latches_automatically else "insert" if self.is_passive else "berth"


def berth_of(seat: Seat, row: int, cargo: Cargo, axes: str) -> Berth:
    """Return the constants of a payload in a berth that accepts the payload.

    Args:
        seat: the berth.
        row: index of the frame to which the berth is fixed, in the array of all frames.
        cargo: the payload.
        axes: "y" if docking limits only the angle between the y axes of payload and port; any other value if
            docking limits the angles of all three axes.
    """
    place = seat.seated(cargo.probe)
    probe = [solid.vertices for solid in cargo.solids if solid.part == part_of(cargo.name, "probe")]
    tip = np.zeros(3) if cargo.probe is None else cargo.probe.position
    guides = None
    if seat.guides is not None:
        seats = place.position + product(cargo.trunnions, place.rotation.T)
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
    """Return the V-guide of a trunnion.

    The V-guide of the keel trunnion centres the payload across the bay. That of each other trunnion centres it along
    the bay.
    """
    guides = seat.guides
    assert guides is not None, "the berth has guides"
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
