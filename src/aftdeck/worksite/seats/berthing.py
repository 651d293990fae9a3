"""Berthing: trunnions in their V-guides and on their seats, and retention of a payload without latches.

A guide is a V that opens upwards from the trunnion's seat, in the plane perpendicular to the trunnion. The guide
centres the trunnion in the direction `Guide.along`. In this direction, it admits offsets up to the V's half width at
the trunnion's height, minus the trunnion's radius. A payload is ready to latch when every trunnion is on its seat, the
payload has its stowed attitude, and both switches of every latch show ready-for-latch. Source: SSV (guides, tolerance,
the dual switches of DISP 97).

Not modelled: the force of a guide on a trunnion. The two switches of a latch differ only if one of them has failed.
"""

from __future__ import annotations

from collections.abc import Sequence, Set
from math import inf
from typing import NamedTuple

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.elementary import sincos
from aftdeck.errors import InputError
from aftdeck.frames import Pose, angle_between
from aftdeck.law import law
from aftdeck.matrices import dots, length, lengths, product
from aftdeck.tuples import Vec3
from aftdeck.worksite.conditions import Condition, within

SWITCHES = ("A", "B")
"""Names of the two ready-for-latch switches of each latch."""
_SQUARE = 1e-9
"""Tolerance in the check that a guide's directions are perpendicular unit vectors [1]."""


class Guide(msgspec.Struct, frozen=True):
    """A V-guide with its latch, in the frame of the body that carries the guide."""

    name: str
    """Name of the guide, for example ``forward port``."""
    seat: Vec3
    """Centre of the stowed trunnion [m]."""
    up: Vec3
    """Unit vector out of the V."""
    along: Vec3
    """Unit vector along which the V centres the trunnion: along the bay for a longeron guide, across the bay for the
    keel guide."""
    half_angle: float
    """Angle between `up` and each side of the V [rad]; assumed, because no figure is published."""
    height: float
    """Height of the guide's top above the seat [m]; SSV gives guides of 22 inches and of 24 inches [S]."""
    throat: float
    """Half the width of the V at the height of the seat, minus the trunnion's radius [m]; assumed."""
    play: float
    """Greatest offset of the trunnion along its own axis, in either direction [m]; assumed."""


class SeatTolerances(msgspec.Struct, frozen=True):
    """Greatest deviations from the stowed pose at which a payload is ready to latch, or stays in its berth."""

    distance: float
    """Distance of each trunnion, or of the payload's centre, from its stowed position [m]; SSV has 0.05 m [I]."""
    angle: float
    """Angle of the rotation from the stowed attitude, about any axis [rad]; SSV has 1 deg [I]."""


class Guides(NamedTuple):
    """Guides of a berth, with their directions and dimensions as arrays.

    Attributes:
        guides: the guides from which the arrays were made.
        seats: (n, 3) `Guide.seat` of each guide [m].
        axes: (n, 3, 3) unit vectors as rows: along, across (the trunnion's axis), up.
        opening: (n,) increase of each V's half width per metre of height: the tangent of `Guide.half_angle` [1].
        throat: (n,) `Guide.throat` of each guide [m].
        height: (n,) `Guide.height` of each guide [m].
        play: (n,) `Guide.play` of each guide [m].
        says: for each guide, three pairs of text templates: for a trunnion's height, for its offset along
            `Guide.along`, and for its offset along its own axis. The first template of a pair is for positive values,
            the second for negative values.
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
    """Return the guides of a berth, with their directions and dimensions as arrays.

    Raises:
        InputError: the directions are not perpendicular unit vectors; the message names the guide.
    """
    axes = np.empty((len(guides), 3, 3))
    for k, guide in enumerate(guides):
        along, up = np.array(guide.along), np.array(guide.up)
        across = np.cross(up, along)
        axes[k] = along, across, up
        if not np.allclose(product(axes[k], axes[k].T), np.eye(3), rtol=0.0, atol=_SQUARE):
            raise InputError(
                f"guide {guide.name!r}: up {guide.up} and along {guide.along} have to be perpendicular unit vectors"
            )
    seats = np.array([guide.seat for guide in guides]).reshape(-1, 3)
    opening = np.array([s / c for s, c in (sincos(guide.half_angle) for guide in guides)])
    throat, height, play = np.array([(guide.throat, guide.height, guide.play) for guide in guides]).reshape(-1, 3).T
    says = tuple(_templates(guide.name) for guide in guides)
    return Guides(tuple(guides), seats, axes, opening, throat, height, play, says)


def _templates(name: str) -> tuple[tuple[str, str], tuple[str, str], tuple[str, str]]:
    """Return the text templates for a trunnion's position in the guide `name`; see `Guides.says`."""
    trunnion = f"{name} trunnion"
    aside = f"{trunnion} {{}} from its guide's middle"
    askew = f"{trunnion} {{}} from its guide, along the trunnion"
    return (f"{trunnion} {{}} above its seat", f"{trunnion} {{}} below its seat"), (aside, aside), (askew, askew)


def places(trunnions: Array, payload: Pose) -> Array:
    """Return the trunnions' centres (n, 3) in the frame in which the payload's pose is given [m].

    Args:
        trunnions: (n, 3) centres in the payload's frame [m].
        payload: pose of the payload.
    """
    return np.asarray(payload.position + product(trunnions, payload.rotation.T))


def inside(trunnions: Array, guides: Guides) -> Array:
    """Return (n,) the distance of each trunnion's centre from the nearest limit of its guide; negative outside [m].

    The distances are measured along the guide's directions: up, along and across.

    Args:
        trunnions: (n, 3) centres, in the frame of the guides and in their order [m].
        guides: guides of the berth.
    """
    along, across, up = _local(trunnions, guides)
    room = guides.throat + np.maximum(up, 0.0) * guides.opening
    return np.asarray(np.min([up, guides.height - up, room - np.abs(along), guides.play - np.abs(across)], axis=0))


class Over(NamedTuple):
    """Position of a payload's trunnions relative to their guides.

    Attributes:
        least: height of the lowest trunnion above its seat [m].
        most: height of the highest trunnion above its seat [m].
        room: least distance of a trunnion from the sides of its guide; negative outside [m]. It is measured at the
            trunnion's height. For a trunnion above its guide it is measured at the guide's top, as if the trunnion
            were lowered straight down.
    """

    least: float
    most: float
    room: float


@law
def over(
    seat: Array, payload: Array, trunnions: Array, seats: Array, axes: Array, opening: Array, throat: Array,
    height: Array, play: Array,
) -> Over:  # fmt: skip
    """Return the position of a payload's trunnions relative to the guides of a berth.

    Args:
        seat: (12,) pose in L of the frame in which the guides are given.
        payload: (12,) pose of the payload's frame in L.
        trunnions: (n, 3) centres of the trunnions in the payload's frame, in the order of the guides [m].
        seats: `Guides.seats`.
        axes: `Guides.axes`: along, across and up.
        opening: `Guides.opening`.
        throat: `Guides.throat`.
        height: `Guides.height`.
        play: `Guides.play`.
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
    """Return the trunnions' offsets (3, n) from their seats in the guides' axes: along, across, up [m]."""
    return dots(guides.axes, (trunnions - guides.seats)[:, None]).T


def in_guides(trunnions: Array, guides: Guides) -> tuple[Condition, ...]:
    """Return for each trunnion the condition that it is inside its guide.

    Each condition reports the trunnion's height or one of its two offsets: the value with the least margin.

    Args:
        trunnions: (n, 3) centres, in the frame of the guides and in their order [m].
        guides: guides of the berth.
    """
    local, opened = _local(trunnions, guides).T.tolist(), guides.opening.tolist()
    found = []
    for guide, opening, says, (along, across, up) in zip(guides.guides, opened, guides.says, local, strict=True):
        room = guide.throat + max(up, 0.0) * opening
        height, aside, askew = min(up, guide.height - up), room - abs(along), guide.play - abs(across)
        name = f"{guide.name} trunnion in guide"
        if height <= aside and height <= askew:
            found.append(within(name, up, 0.0, guide.height, "m", says[0]))
        elif aside <= askew:
            found.append(within(name, along, -room, room, "m", says[1]))
        else:
            found.append(within(name, across, -guide.play, guide.play, "m", says[2]))
    return tuple(found)


def ready_to_latch(
    trunnions: Array,
    payload: Pose,
    guides: Guides,
    tolerances: SeatTolerances,
    failed: Set[str] = frozenset(),
) -> tuple[Condition, ...]:
    """Return the conditions of latching: one for each latch, and one for the payload's attitude.

    A latch's condition reports the trunnion's distance from its seat. If this distance is within the tolerance, but a
    switch of the latch has failed, the condition reports the failed switch instead.

    Args:
        trunnions: (n, 3) centres, in the frame of the guides and in their order [m].
        payload: the payload's remaining offset and rotation, as a pose relative to its seated pose.
        guides: guides of the berth.
        tolerances: tolerances of the berth.
        failed: names of failed switches, for example ``forward port B``.
    """
    off = lengths(trunnions - guides.seats).tolist()
    found = []
    for guide, distance in zip(guides.guides, off, strict=True):
        name, says = f"{guide.name} latch ready", f"{guide.name} trunnion {{}} from its seat"
        seated = within(name, distance, -inf, tolerances.distance, "m", (says, ""))
        if seated.holds and (dark := [switch for switch in SWITCHES if f"{guide.name} {switch}" in failed]):
            text = f"{guide.name} latch: switch {' and '.join(dark)} shows nothing"
            shows, needed = float(len(SWITCHES) - len(dark)), float(len(SWITCHES))
            found.append(Condition(name, False, shows, needed, "", shows - needed, text))
        else:
            found.append(seated)
    return (*found, _turn(payload, tolerances))


def switches(
    trunnions: Array, guides: Guides, tolerances: SeatTolerances, failed: Set[str] = frozenset()
) -> tuple[tuple[bool, bool], ...]:
    """Return for each latch whether its switches A and B show ready-for-latch, as on DISP 97.

    The arguments are those of `ready_to_latch`.
    """
    off = lengths(trunnions - guides.seats).tolist()
    return tuple(
        (
            distance <= tolerances.distance and f"{guide.name} {SWITCHES[0]}" not in failed,
            distance <= tolerances.distance and f"{guide.name} {SWITCHES[1]}" not in failed,
        )
        for guide, distance in zip(guides.guides, off, strict=True)
    )


def retained(payload: Pose, tolerances: SeatTolerances) -> tuple[Condition, ...]:
    """Return the conditions under which a payload that is released in a bay berth stays in the berth.

    Args:
        payload: the offset of the payload's centre and its rotation, as a pose relative to its seated pose.
        tolerances: tolerances of the berth.
    """
    distance = length(payload.position.tolist())
    return (
        within("payload stowed", distance, -inf, tolerances.distance, "m", _PLACE_SAYS),
        _turn(payload, tolerances),
    )


def _turn(payload: Pose, tolerances: SeatTolerances) -> Condition:
    angle = angle_between(payload.rotation.tolist(), _STOWED)
    return within("payload's attitude", angle, -inf, tolerances.angle, "rad", _TURN_SAYS)


_STOWED = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_PLACE_SAYS = ("payload {} from its stowed place", "")
_TURN_SAYS = ("payload turned {} from its stowed attitude", "")
