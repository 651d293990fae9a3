"""Aim of Capture, Extract and Dock for compiled code: where a step of the task leads the tip or the held payload.

`task.remaining` computes the same from frames, for every kind of step.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.placed import Place, carried, composed, motion_left
from aftdeck.bodies.pose import POSE, row_of, rows, vec3
from aftdeck.frames import rotation_x
from aftdeck.law import law
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import at_berth, at_payload
from aftdeck.scenario.target import AtBerth, AtPayload
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.constants.site import ORBITER, site_of
from aftdeck.tuples import UNTURNED, Vec3

MOUNT = 0
"""Rotation from L to the orbiter's body axes, row by row."""
HAND = 9
"""Rotation of the end effector's axes, in which the sticks act, from the tip's."""
OUT = 18
"""Direction out of the berth, in the frame of the places; 0 if the place is at a payload."""
ABOVE = 21
"""Distance of the places from the capture pose or from the seat, along the way out [m]."""
ROW = 22
"""Row of the frame of the places: the payload's, or that to which the berth is fixed."""
AT_BERTH = 23
"""1 if the held payload has to reach its place; 0 if the tip has to."""
PLACES = 24
"""First of the places (12): of the tip; or of each payload, one after the other."""


class Left(NamedTuple):
    """Remaining motion.

    Attributes:
        known: whether there is a place to move to; without one, the tip is infinitely far from it, and below it.
        motion: motion x to R x + p in L that puts the tip or the payload at its place.
        distance: distance that the tip, or the payload, has to move [m].
        angle: remaining rotation [rad].
        above: distance above the capture pose or the seat, along the way out [m].
    """

    known: bool
    motion: Place
    distance: float
    angle: float
    above: float


def aim_of(scenario: Scenario, step: TaskStep) -> Array:
    """Return the packed aim of a step whose target is at a payload or at a berth."""
    site, target, model = site_of(scenario), step.target, scenario.arm.model
    hand = np.eye(3) if scenario.strict else rotation_x(model.end_effector_roll)
    aim = np.zeros(PLACES)
    aim[MOUNT:HAND], aim[HAND:OUT] = model.mount.rotation.ravel(), hand.ravel()
    match target:
        case AtPayload(payload=k, above=above):
            aim[ABOVE:AT_BERTH] = above, site.payload_rows[k]
            places = [at_payload(model, scenario.payloads[k], target)]
        case AtBerth(berth=name, above=above):
            berth = site.berth(name)
            aim[OUT:ABOVE] = berth.pose.rotation[:, berth.out]
            aim[ABOVE:PLACES] = above, ORBITER if berth.frame == "orbiter" else site.space_row, 1.0
            places = [at_berth(berth, payload, target) for payload in scenario.payloads]
        case _:
            raise AssertionError("`step_of` chooses steps with a target at a payload or a berth")
    return np.concatenate([aim, *map(row_of, places)])


@law
def left(aim: Array, frames: Array, tip: Place, payload: Place, held: int) -> Left:
    """Return the remaining motion.

    Args:
        aim: result of `aim_of`.
        frames: (F, 12) poses of all frames in L.
        tip: pose of the tip in L.
        payload: pose in L of the held payload; that of the tip if none is held.
        held: index of the held payload; -1 for none.
    """
    (at, turn), (payload_at, payload_turn) = tip, payload
    carrier, by_payload = frames[int(aim[ROW])], aim[AT_BERTH] != 0.0
    begin = PLACES + POSE * held if by_payload else PLACES
    if by_payload and held < 0:
        return Left(False, (_ZERO, UNTURNED), np.inf, np.inf, -np.inf)
    place_at, place = composed(vec3(carrier, 0), rows(carrier, 3), vec3(aim, begin), rows(aim, begin + 3))
    if by_payload:
        out = vec3(aim, OUT)
        a, b, c = rows(carrier, 3)
        way = _dot(a, out), _dot(b, out), _dot(c, out)
        above = aim[ABOVE] + _along(way, payload_at, place_at)
        place_at, place = carried(place_at, place, payload_at, payload_turn, at, turn)
    else:
        above = aim[ABOVE] - _along((place[0][0], place[1][0], place[2][0]), at, place_at)
    motion, distance, angle = motion_left(place_at, place, at, turn, payload_at)
    return Left(True, motion, distance, angle, above)


_ZERO: Vec3 = (0.0, 0.0, 0.0)


@law
def _dot(a: Vec3, b: Vec3) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@law
def _along(axis: Vec3, at: Vec3, origin: Vec3) -> float:
    """Return how far a point is from an origin, along an axis [m]."""
    return axis[0] * (at[0] - origin[0]) + axis[1] * (at[1] - origin[1]) + axis[2] * (at[2] - origin[2])
