"""Where a target is that a phase gives by what is there: the hand at a payload, or a held payload at a seat."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.arms.load import ArmModel
from aftdeck.bodies.pose import POSE, compose, inverse, pose_of, row_of
from aftdeck.frames import Pose, rotation_x
from aftdeck.scenario.target import Place, Target, target_at
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.grasp import in_hand
from aftdeck.simulation.state import State
from aftdeck.worksite.model import Cargo

Array = NDArray[np.float64]

_OVER_A_BAR = np.array([[0.0, 0.0, -1.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]])
"""The tip's axes in a cargo's where the hand looks down on its bar, the fixed finger to port."""


def found(flight: Flight, state: State, place: Place) -> Target | str:
    """The target that a place is now, or why there is none."""
    if place.cargo is None:
        return _at_seat(flight, state, place)
    return _at_cargo(flight, state, place.cargo, place.above)


def _at_cargo(flight: Flight, state: State, k: int, above: float) -> Target:
    """The hand where it takes a payload, `above` it [m]."""
    site = flight.site
    tip = np.empty(POSE)
    compose(state.site.frames[site.cargo_row(k)], row_of(_taking(flight.scenario.arm.model, site.cargo[k])), tip)
    tip[:3] -= above * tip[3:].reshape(3, 3)[:, 0]
    return target_at(pose_of(tip))


def _taking(model: ArmModel, cargo: Cargo) -> Pose:
    """The tip in a payload's axes where the hand takes it: the palm on its bar, or at its fixture."""
    if cargo.grapple is not None:
        return Pose(cargo.grapple.position, cargo.grapple.rotation @ rotation_x(-model.end_effector_roll))
    assert cargo.receptacle is not None, "cargo has one or the other"
    low, high = cargo.receptacle.min(axis=0), cargo.receptacle.max(axis=0)
    return Pose(np.array([*(low + high)[:2] / 2.0, high[2]]), _OVER_A_BAR)


def _at_seat(flight: Flight, state: State, place: Place) -> Target | str:
    """The hand where what it holds is in its place in a seat, or short of it."""
    site, things = flight.site, state.site
    k = things.held
    if k is None:
        return "nothing is held that could be brought to a seat"
    berth = site.berth(k, place.seat)
    if berth is None:
        return f"{site.cargo[k].title} has no place in the {site.seat(place.seat).title}"
    body = things.frames[berth.row]
    seated, joint, tip = (np.empty(POSE) for _ in range(3))
    compose(body, berth.place, seated)
    turn = body[3:].reshape(3, 3)
    out = turn[:, 2] if berth.port is None else turn @ berth.port[3:].reshape(3, 3)[:, 0]
    seated[:3] += place.above * out
    compose(seated, inverse(in_hand(flight, state, k)), joint)
    compose(joint, site.hand, tip)
    return target_at(pose_of(tip))
