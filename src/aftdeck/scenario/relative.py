"""Tip poses relative to objects: over a payload, with a held payload at a seat, in a body's frame.

The same functions serve the start of a run, when all objects are where the files say, and a phase as it begins.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.frames import SCENE_FROM_PANEL_AXES, Mount, Pose, rotation_x
from aftdeck.scenario.target import AtCargo, AtSeat, InFrame
from aftdeck.worksite.model import Cargo, Seat, Worksite

_OVER_A_BAR = np.array([[0.0, 0.0, -1.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]])
"""The tip's axes in a cargo's axes when the hand points down at its bar, with the fixed finger to port."""


def scene_in_l(mount: Mount, origin: tuple[float, float, float]) -> Pose:
    """Return the pose in L of a scene whose origin has the given structural coordinates [m]."""
    turn = mount.rotation.T @ SCENE_FROM_PANEL_AXES
    return Pose(turn @ np.array(origin) - mount.rotation.T @ mount.origin, turn)


def composed(outer: Pose, inner: Pose) -> Pose:
    """Return the pose `inner`, given in a frame, in the frame in which that one has the pose `outer`."""
    return Pose(outer.position + outer.rotation @ inner.position, outer.rotation @ inner.rotation)


def inverted(pose: Pose) -> Pose:
    """Return the pose of the outer frame in the inner one."""
    return Pose(-(pose.rotation.T @ pose.position), pose.rotation.T)


def takes(model: ArmModel, cargo: Cargo) -> bool:
    """Return whether a payload has what this arm's hand captures: a bar, or a grapple fixture."""
    return (cargo.grapple if model.equipment.prong is None else cargo.receptacle) is not None


def at_cargo(model: ArmModel, cargo: Cargo, place: AtCargo) -> Pose:
    """Return the tip's pose in a payload's axes where the hand takes it, displaced as the place says."""
    if cargo.grapple is not None:
        there = Pose(cargo.grapple.position, cargo.grapple.rotation @ rotation_x(-model.end_effector_roll))
    else:
        assert cargo.receptacle is not None, "cargo has one or the other"
        low, high = cargo.receptacle.min(axis=0), cargo.receptacle.max(axis=0)
        there = Pose(np.array([*(low + high)[:2] / 2.0, high[2]]), _OVER_A_BAR)
    return Pose(there.position - place.above * there.rotation[:, 0] + np.array(place.offset), there.rotation)


def at_seat(seat: Seat, cargo: Cargo, place: AtSeat) -> Pose:
    """Return the pose of a payload in its seat, in the seat's frame, displaced as the place says."""
    seated, turn = seat.seated(cargo.probe), seat.pose.rotation
    out = turn[:, 0] if seat.kind == "port" else turn[:, 2]
    return Pose(seated.position + place.above * out + turn @ np.array(place.offset), seated.rotation)


def in_frame(worksite: Worksite, cargo: tuple[Cargo, ...], name: str, pose: Pose) -> InFrame | None:
    """Return the place of a pose in the axes of a body, a seat or a payload; None if none has that name."""
    carriers: dict[str, tuple[str, Pose]] = {body.name: (body.fixed_to, body.pose) for body in worksite.bodies}
    carriers |= {one.name: (one.name, Pose(np.zeros(3), np.eye(3))) for one in cargo}
    carriers |= {seat.name: (seat.frame, seat.pose) for seat in worksite.seats}
    if name not in carriers:
        return None
    frame, own = carriers[name]
    there = composed(own, pose)
    x, y, z = there.position.tolist()
    a, b, c = (tuple(row) for row in there.rotation.tolist())
    return InFrame(frame, (x, y, z), (a, b, c))
