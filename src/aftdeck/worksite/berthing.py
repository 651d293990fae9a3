"""Berthing: trunnions in their V-guides and on their seats, and the retention of a payload that needs no latch.

A guide is a V that opens upwards from the seat, in the plane square to its trunnion: it funnels the trunnion one way,
as far aside as the V is wide at that height. A payload is ready to latch when every trunnion is on its seat, the
payload is turned as it will be stowed, and both switches of every latch show it. Source: SSV (guides, tolerance, the
dual switches of DISP 97).

Not modelled: a guide's force on a trunnion; the two switches of a latch see the same.
"""

from __future__ import annotations

import math
from collections.abc import Sequence, Set
from math import inf
from typing import NamedTuple

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.frames import Pose, angle_between
from aftdeck.law import law
from aftdeck.worksite.conditions import Condition, Units, within

Vec3 = tuple[float, float, float]

SWITCHES = ("A", "B")
"""Each latch has two that show ready-for-latch."""
_SQUARE = 1e-9
"""How exactly a guide's directions have to be square and of unit length [1]."""


class Guide(msgspec.Struct, frozen=True):
    """A V-guide with its latch, in the frame of the body that it stands on."""

    name: str
    """``forward port``."""
    seat: Vec3
    """The trunnion's centre when it is stowed [m]."""
    up: Vec3
    """Unit vector out of the V."""
    along: Vec3
    """Unit vector in which the V funnels: along the bay for a longeron's, across it for the keel's."""
    half_angle: float
    """Of the V's opening, from `up` [rad]; assumed, no figure published."""
    height: float
    """From the seat to the guide's top [m]; SSV has models of 22 in and 24 in [S]."""
    throat: float
    """Half the width of the V at its seat, less the trunnion's radius [m]; assumed."""
    play: float
    """How far the trunnion may stand either way along its own axis [m]; assumed."""


class SeatTolerances(msgspec.Struct, frozen=True):
    """How near to its stowed pose a payload has to be for its latches, or to be retained."""

    distance: float
    """Of each trunnion, or of the centre [m]; SSV has 0.05 m [I]."""
    angle: float
    """Of the whole turn [rad]; SSV has 1 deg [I]."""


class Guides(NamedTuple):
    """Guides with their directions as arrays.

    Attributes:
        guides: as they were given.
        seats: (n, 3) [m].
        axes: (n, 3, 3) unit vectors as rows: along, across (the trunnion's axis), up.
        opening: (n,) of each V, its half width by its height [1].
        throat: (n,) of each, as of `Guide`, and so are
        height: (n,) and
        play: (n,).
        says: of each, how a trunnion's place is told: its height, how far it is aside, how far askew.
    """

    guides: tuple[Guide, ...]
    seats: Array
    axes: Array
    opening: Array
    throat: Array
    height: Array
    play: Array
    says: tuple[tuple[tuple[str, str], tuple[str, str], tuple[str, str]], ...]


def prepare(guides: Sequence[Guide]) -> Guides:
    """The guides of a seat.

    Raises:
        InputError: directions that are not unit vectors square to each other; names the guide.
    """
    axes = np.empty((len(guides), 3, 3))
    for k, guide in enumerate(guides):
        along, up = np.array(guide.along), np.array(guide.up)
        across = np.cross(up, along)
        axes[k] = along, across, up
        if not np.allclose(axes[k] @ axes[k].T, np.eye(3), rtol=0.0, atol=_SQUARE):
            raise InputError(
                f"guide {guide.name!r}: up {guide.up} and along {guide.along} have to be unit vectors, square to each "
                "other"
            )
    seats = np.array([guide.seat for guide in guides]).reshape(-1, 3)
    opening = np.tan([guide.half_angle for guide in guides])
    throat, height, play = np.array([(guide.throat, guide.height, guide.play) for guide in guides]).reshape(-1, 3).T
    says = tuple(_said(guide.name) for guide in guides)
    return Guides(tuple(guides), seats, axes, opening, throat, height, play, says)


def _said(name: str) -> tuple[tuple[str, str], tuple[str, str], tuple[str, str]]:
    """How a trunnion's place in the guide of that name is told."""
    who = f"{name} trunnion"
    aside = f"{who} {{}} from its guide's middle"
    askew = f"{who} {{}} from its guide, along the trunnion"
    return (f"{who} {{}} above its seat", f"{who} {{}} below its seat"), (aside, aside), (askew, askew)


def places(trunnions: Array, payload: Pose) -> Array:
    """Where trunnions are, (n, 3) [m], in the frame that the payload's pose is given in.

    Args:
        trunnions: (n, 3) their centres in the payload's frame [m].
        payload: its pose.
    """
    return np.asarray(payload.position + trunnions @ payload.rotation.T)


def inside(trunnions: Array, guides: Guides) -> Array:
    """Return how far inside its guide's mouth each trunnion's centre is, (n,), negative outside [m].

    Args:
        trunnions: (n, 3) centres, in the frame of the guides and in their order [m].
        guides: of the seat.
    """
    along, across, up = _local(trunnions, guides)
    room = guides.throat + np.maximum(up, 0.0) * guides.opening
    return np.asarray(np.min([up, guides.height - up, room - np.abs(along), guides.play - np.abs(across)], axis=0))


class Over(NamedTuple):
    """How trunnions stand over their guides.

    Attributes:
        least: height of the lowest over its seat [m].
        most: height of the highest [m].
        room: to the guides' sides, for the one with the least, where it enters the mouth, or where it is in it when it
            is lowered straight; negative outside [m].
    """

    least: float
    most: float
    room: float


@law
def over(
    seat: Array, payload: Array, trunnions: Array, seats: Array, axes: Array, opening: Array, throat: Array,
    height: Array, play: Array,
) -> Over:  # fmt: skip
    """Return how a payload's trunnions stand over the guides of a seat.

    Args:
        seat: (12,) the frame of the guides, in L.
        payload: (12,) its frame, in L.
        trunnions: (n, 3) their centres in the payload's frame, in the order of the guides [m].
        seats: of the guides, as of `Guides`, and so are
        axes: along, across and up.
        opening: of each V.
        throat: of each.
        height: of each.
        play: of each.
    """
    least, most, room = np.inf, -np.inf, np.inf
    place, local = np.empty(3), np.empty(3)
    for n in range(len(trunnions)):
        for i in range(3):
            place[i] = payload[i] - seat[i]
            for j in range(3):
                place[i] += payload[3 + 3 * i + j] * trunnions[n, j]
        for i in range(3):
            local[i] = seat[3 + i] * place[0] + seat[6 + i] * place[1] + seat[9 + i] * place[2] - seats[n, i]
        along, across, up = 0.0, 0.0, 0.0
        for i in range(3):
            along += axes[n, 0, i] * local[i]
            across += axes[n, 1, i] * local[i]
            up += axes[n, 2, i] * local[i]
        wide = throat[n] + min(max(up, 0.0), height[n]) * opening[n]
        least, most = min(least, up), max(most, up)
        room = min(room, wide - abs(along), play[n] - abs(across))
    return Over(least, most, room)


def _local(trunnions: Array, guides: Guides) -> Array:
    """(3, n) where trunnions are in the axes of their guides: along, across, up from the seat [m]."""
    return np.asarray((guides.axes @ (trunnions - guides.seats)[:, :, None])[:, :, 0].T)


def in_guides(trunnions: Array, guides: Guides, units: Units) -> tuple[Condition, ...]:
    """Whether each trunnion is in the capture region of its guide: a condition for each, told by what is tightest.

    Args:
        trunnions: (n, 3) centres, in the frame of the guides and in their order [m].
        guides: of the seat.
        units: the operator's.
    """
    local, opened = _local(trunnions, guides).T.tolist(), guides.opening.tolist()
    found = []
    for guide, opening, says, (along, across, up) in zip(guides.guides, opened, guides.says, local, strict=True):
        room = guide.throat + max(up, 0.0) * opening
        height, aside, askew = min(up, guide.height - up), room - abs(along), guide.play - abs(across)
        name = f"{guide.name} trunnion in guide"
        if height <= aside and height <= askew:
            found.append(within(name, up, 0.0, guide.height, "m", units, says[0]))
        elif aside <= askew:
            found.append(within(name, along, -room, room, "m", units, says[1]))
        else:
            found.append(within(name, across, -guide.play, guide.play, "m", units, says[2]))
    return tuple(found)


def ready_to_latch(
    trunnions: Array,
    payload: Pose,
    guides: Guides,
    tolerances: SeatTolerances,
    units: Units,
    failed: Set[str] = frozenset(),
) -> tuple[Condition, ...]:
    """The conditions of latching: one for each latch, told by what is wrong with it, and the attitude.

    Args:
        trunnions: (n, 3) centres, in the frame of the guides and in their order [m].
        payload: its pose in the seat's frame: what is left of position and turn.
        guides: of the seat.
        tolerances: of the seat.
        units: the operator's.
        failed: switches that show nothing, ``forward port B``.
    """
    off = [math.hypot(x, y, z) for x, y, z in (trunnions - guides.seats).tolist()]
    found = []
    for guide, distance in zip(guides.guides, off, strict=True):
        name, says = f"{guide.name} latch ready", f"{guide.name} trunnion {{}} from its seat"
        seated = within(name, distance, -inf, tolerances.distance, "m", units, (says, ""))
        if seated.holds and (dark := [switch for switch in SWITCHES if f"{guide.name} {switch}" in failed]):
            text = f"{guide.name} latch: switch {' and '.join(dark)} shows nothing"
            shows, needed = float(len(SWITCHES) - len(dark)), float(len(SWITCHES))
            found.append(Condition(name, False, shows, needed, "", shows - needed, text))
        else:
            found.append(seated)
    return (*found, _turn(payload, tolerances, units))


def switches(
    trunnions: Array, guides: Guides, tolerances: SeatTolerances, failed: Set[str] = frozenset()
) -> tuple[tuple[bool, bool], ...]:
    """Ready-for-latch switches A and B of each latch, as DISP 97 shows them; arguments as of `ready_to_latch`."""
    off = np.linalg.norm(trunnions - guides.seats, axis=1).tolist()
    return tuple(
        (
            distance <= tolerances.distance and f"{guide.name} {SWITCHES[0]}" not in failed,
            distance <= tolerances.distance and f"{guide.name} {SWITCHES[1]}" not in failed,
        )
        for guide, distance in zip(guides.guides, off, strict=True)
    )


def retained(payload: Pose, tolerances: SeatTolerances, units: Units) -> tuple[Condition, ...]:
    """The conditions under which a payload that is let go stays where it is, in the concept's bay.

    Args:
        payload: its pose in the seat's frame: how far its centre is from the stowed place, and its turn.
        tolerances: of the seat.
        units: the operator's.
    """
    distance = math.hypot(*payload.position.tolist())
    return (
        within("payload stowed", distance, -inf, tolerances.distance, "m", units, _PLACE_SAYS),
        _turn(payload, tolerances, units),
    )


def _turn(payload: Pose, tolerances: SeatTolerances, units: Units) -> Condition:
    angle = angle_between(payload.rotation.tolist(), _STOWED)
    return within("payload's attitude", angle, -inf, tolerances.angle, "rad", units, _TURN_SAYS)


_STOWED = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_PLACE_SAYS = ("payload {} from its stowed place", "")
_TURN_SAYS = ("payload turned {} from its stowed attitude", "")
