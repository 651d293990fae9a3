"""Targets that a phase gives relative to a cargo, a seat or a body; they are resolved when the phase begins."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, inverse, pose_of, row_of
from aftdeck.scenario.relative import at_cargo, at_seat
from aftdeck.scenario.target import AtCargo, AtSeat, InFrame, RelativeTarget, Target, target_at
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.payloads.grasp import in_hand
from aftdeck.simulation.state import State


def found(flight: Flight, state: State, place: RelativeTarget) -> Target | str:
    """Return the target that a place stands for at present, or a text that says why it has none."""
    site, frames = flight.site, state.worksite.frames
    match place:
        case AtSeat():
            return _at_seat(flight, state, place)
        case AtCargo(cargo=k):
            over = row_of(at_cargo(flight.scenario.arm.model, site.cargo[k], place))
            return target_at(pose_of(_composed(frames[site.cargo_row(k)], over)))
        case InFrame():
            carrier = frames[site.layout.frames.index(place.frame)]
            return target_at(pose_of(_composed(carrier, row_of(place.pose))))


def _at_seat(flight: Flight, state: State, place: AtSeat) -> Target | str:
    """Return the tip pose that puts the held cargo into its place in a seat, or short of that place.

    Returns:
        The target, or the reason as text if nothing is held or the seat does not take the cargo.
    """
    site, worksite = flight.site, state.worksite
    k = worksite.held
    if k is None:
        return "nothing is held that could be brought to a seat"
    berth = site.berth(k, place.seat)
    if berth is None:
        return f"{site.cargo[k].title} has no place in the {site.seat(place.seat).title}"
    seated = _composed(worksite.frames[berth.row], row_of(at_seat(berth.seat, site.cargo[k], place)))
    joint = _composed(seated, inverse(in_hand(flight, state, k)))
    return target_at(pose_of(_composed(joint, site.hand)))


def _composed(outer: Array, inner: Array) -> Array:
    out = np.empty(POSE)
    compose(outer, inner, out)
    return out
