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
from math import inf, sqrt
from typing import NamedTuple

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, relative, rows
from aftdeck.elementary import sincos
from aftdeck.errors import InputError
from aftdeck.frames import angle_between
from aftdeck.law import law
from aftdeck.matrices import product
from aftdeck.tuples import UNTURNED, Vec3
from aftdeck.worksite.conditions import Condition, within
from aftdeck.worksite.within import Within, holds

SWITCHES = ("A", "B")
"""Names of the two ready-for-latch switches of each latch."""
_SEATED = 1e-6
"""A trunnion that is less than this above its seat is at its seat [m]: a rounding error is no failure."""
_GIVES = 2e-3
"""A trunnion that is less than this below its seat is at its seat [m]: on a plant with contact forces, guides give
under a load (assumed; 0.4 mm were seen at 400 N)."""
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


class BerthTolerances(msgspec.Struct, frozen=True):
    """Greatest deviations from the stowed pose at which a payload is ready to latch, or stays in its berth."""

    distance: float
    """Distance of each trunnion, or of the payload's centre, from its stowed position [m]; SSV has 0.05 m [I]."""
    angle: float
    """Angle of the rotation from the stowed attitude, about any axis [rad]; SSV has 1 deg [I]."""


class Says(NamedTuple):
    """Texts about a trunnion and its guide.

    The last four are pairs of templates: the first of a pair is for positive values, the second for negative ones.

    Attributes:
        in_guide: name of the condition that the trunnion is in its guide.
        ready: name of the condition that the latch is ready.
        height: for the trunnion's height.
        aside: for its offset along `Guide.along`.
        askew: for its offset along its own axis.
        seat: for its distance from its seat.
    """

    in_guide: str
    ready: str
    height: tuple[str, str]
    aside: tuple[str, str]
    askew: tuple[str, str]
    seat: tuple[str, str]


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
        says: for each guide, its texts.
    """

    guides: tuple[Guide, ...]
    seats: Array
    axes: Array
    opening: Array
    throat: Array
    height: Array
    play: Array
    says: tuple[Says, ...]


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


def _templates(name: str) -> Says:
    """Return the texts about the guide `name`."""
    trunnion = f"{name} trunnion"
    aside = f"{trunnion} {{}} from its guide's middle"
    askew = f"{trunnion} {{}} from its guide, along the trunnion"
    return Says(
        f"{trunnion} in guide",
        f"{name} latch ready",
        (f"{trunnion} {{}} above its seat", f"{trunnion} {{}} below its seat"),
        (aside, aside),
        (askew, askew),
        (f"{trunnion} {{}} from its seat", ""),
    )


ALONG, ACROSS, UP, AWAY, OFFSET = range(5)
"""Columns of a trunnion's offset from its seat: along, across and up in the guide's axes, and the distance [m]; then
their number."""


@law
def offsets(seat: Array, payload: Array, trunnions: Array, seats: Array, axes: Array, found: Array) -> None:
    """Write the offset of each trunnion from its seat.

    Args:
        seat: (12,) pose in L of the frame in which the guides are given.
        payload: (12,) pose of the payload's frame in L.
        trunnions: (n, 3) centres of the trunnions in the payload's frame, in the order of the guides [m].
        seats: `Guides.seats`.
        axes: `Guides.axes`.
        found: (n, 4) output.
    """
    at, off = np.empty(POSE), np.empty(3)
    relative(seat, payload, at)
    for n in range(len(trunnions)):
        for i in range(3):
            row = 3 + 3 * i
            turned = at[row] * trunnions[n, 0] + at[row + 1] * trunnions[n, 1] + at[row + 2] * trunnions[n, 2]
            off[i] = at[i] + turned - seats[n, i]
        for i in range(3):
            found[n, i] = axes[n, i, 0] * off[0] + axes[n, i, 1] * off[1] + axes[n, i, 2] * off[2]
        found[n, AWAY] = sqrt(off[0] * off[0] + off[1] * off[1] + off[2] * off[2])


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
def over(found: Array, opening: Array, throat: Array, height: Array, play: Array) -> Over:
    """Return the position of a payload's trunnions relative to the guides of a berth.

    Args:
        found: (n, 4) result of `offsets`.
        opening: `Guides.opening`.
        throat: `Guides.throat`.
        height: `Guides.height`.
        play: `Guides.play`.
    """
    least, most, room = np.inf, -np.inf, np.inf
    for n in range(len(found)):
        up = found[n, UP]
        least, most = min(least, up), max(most, up)
        wide = throat[n] + min(max(up, 0.0), height[n]) * opening[n]
        room = min(room, wide - abs(found[n, ALONG]), play[n] - abs(found[n, ACROSS]))
    return Over(least, most, room)


@law
def inside(n: int, found: Array, opening: Array, throat: Array, height: Array, play: Array) -> float:
    """Return the distance of trunnion n from the nearest limit of its guide; negative outside [m].

    The distance is measured along the guide's directions: up, along and across. The arguments are those of `over`.
    """
    up = found[n, UP]
    room = throat[n] + max(up, 0.0) * opening[n] - abs(found[n, ALONG])
    least: float = min(up, height[n] - up, room, play[n] - abs(found[n, ACROSS]))
    return least


def in_guides(found: Array, guides: Guides) -> tuple[Condition, ...]:
    """Return for each trunnion the condition that it is inside its guide.

    Each condition reports the trunnion's height or one of its two offsets: the value with the least margin.

    Args:
        found: (n, 4) result of `offsets`.
        guides: guides of the berth.
    """
    wanted = np.empty((len(found), GUIDED))
    guides_wanted(found, guides.opening, guides.throat, guides.height, guides.play, wanted)
    return tuple(
        within(says.in_guide, value, least, greatest, "m", (says.height, says.aside, says.askew)[int(which)])
        for says, (which, value, least, greatest) in zip(guides.says, wanted.tolist(), strict=True)
    )


GUIDED = 4
"""Length of a row of `guides_wanted`."""


@law
def guides_wanted(found: Array, opening: Array, throat: Array, height: Array, play: Array, wanted: Array) -> None:
    """Write what each trunnion needs to be inside its guide: of its three values the one with the least margin.

    Args:
        found: (n, 4) result of `offsets`.
        opening: `Guides.opening`.
        throat: `Guides.throat`.
        height: `Guides.height`.
        play: `Guides.play`.
        wanted: (n, 4) output: 0 for the height, 1 for the offset along the guide, 2 for that along the trunnion; the
            value, and its range [m].
    """
    for n in range(len(found)):
        along, across, up = found[n, ALONG], found[n, ACROSS], found[n, UP]
        room = throat[n] + max(up, 0.0) * opening[n]
        seated = 0.0 if -_GIVES < up < _SEATED else up
        upright, aside, askew = min(seated, height[n] - up), room - abs(along), play[n] - abs(across)
        if upright <= aside and upright <= askew:
            which, value, least, greatest = 0.0, seated, 0.0, height[n]
        elif aside <= askew:
            which, value, least, greatest = 1.0, along, -room, room
        else:
            which, value, least, greatest = 2.0, across, -play[n], play[n]
        wanted[n, 0], wanted[n, 1], wanted[n, 2], wanted[n, 3] = which, value, least, greatest


@law
def guides_met(
    found: Array, opening: Array, throat: Array, height: Array, play: Array, left: Array, distance: float, angle: float
) -> int:
    """Return how many conditions of `in_guides` and `ready_to_latch` hold, without failed switches.

    Args:
        found: (n, 4) result of `offsets`.
        opening: `Guides.opening`.
        throat: `Guides.throat`.
        height: `Guides.height`.
        play: `Guides.play`.
        left: (12,) as for `ready_to_latch`.
        distance: `BerthTolerances.distance`.
        angle: `BerthTolerances.angle`.
    """
    wanted, number = np.empty((len(found), GUIDED)), 0
    guides_wanted(found, opening, throat, height, play, wanted)
    for n in range(len(found)):
        number += holds(wanted[n, 1], wanted[n, 2], wanted[n, 3])
        number += holds(found[n, AWAY], -inf, distance)
    return number + holds(turn_left(left), -inf, angle)


def ready_to_latch(
    found: Array,
    left: Array,
    guides: Guides,
    tolerances: BerthTolerances,
    failed: Set[str] = frozenset(),
) -> tuple[Condition, ...]:
    """Return the conditions of latching: one for each latch, and one for the payload's attitude.

    A latch's condition reports the trunnion's distance from its seat. If this distance is within the tolerance, but a
    switch of the latch has failed, the condition reports the failed switch instead.

    Args:
        found: (n, 4) result of `offsets`.
        left: (12,) the payload's remaining offset and rotation, as a pose relative to its seated pose.
        guides: guides of the berth.
        tolerances: tolerances of the berth.
        failed: names of failed switches, for example ``forward port B``.
    """
    conditions = []
    for guide, says, distance in zip(guides.guides, guides.says, found[:, AWAY].tolist(), strict=True):
        seated = within(says.ready, distance, -inf, tolerances.distance, "m", says.seat)
        if failed and seated.holds and (dark := [switch for switch in SWITCHES if f"{guide.name} {switch}" in failed]):
            text = f"{guide.name} latch: switch {' and '.join(dark)} shows nothing"
            shows, needed = float(len(SWITCHES) - len(dark)), float(len(SWITCHES))
            conditions.append(Condition(says.ready, False, shows, needed, "", shows - needed, text))
        else:
            conditions.append(seated)
    return (*conditions, _turn(left, tolerances))


def switches(
    found: Array, guides: Guides, tolerances: BerthTolerances, failed: Set[str] = frozenset()
) -> tuple[tuple[bool, bool], ...]:
    """Return for each latch whether its switches A and B show ready-for-latch, as on DISP 97.

    The arguments are those of `ready_to_latch`.
    """
    return tuple(
        (
            distance <= tolerances.distance and f"{guide.name} {SWITCHES[0]}" not in failed,
            distance <= tolerances.distance and f"{guide.name} {SWITCHES[1]}" not in failed,
        )
        for guide, distance in zip(guides.guides, found[:, AWAY].tolist(), strict=True)
    )


def retained(left: Array, tolerances: BerthTolerances) -> tuple[Condition, ...]:
    """Return the conditions under which a payload that is released in a bay berth stays in the berth.

    Args:
        left: (12,) the offset of the payload's centre and its rotation, as a pose relative to its seated pose.
        tolerances: tolerances of the berth.
    """
    place, turn = retained_values(left, tolerances.distance, tolerances.angle)
    return within("payload stowed", *place, "m", _PLACE_SAYS), within(_ATTITUDE, *turn, "rad", _TURN_SAYS)


@law
def retained_values(left: Array, distance: float, angle: float) -> tuple[Within, Within]:
    """Return the values of the conditions of `retained` with their ranges; the limits as in `BerthTolerances`."""
    away = sqrt(left[0] * left[0] + left[1] * left[1] + left[2] * left[2])
    return (away, -inf, distance), (turn_left(left), -inf, angle)


def _turn(left: Array, tolerances: BerthTolerances) -> Condition:
    return within(_ATTITUDE, turn_left(left), -inf, tolerances.angle, "rad", _TURN_SAYS)


@law
def turn_left(left: Array) -> float:
    """Return the angle of a payload's remaining rotation [rad]; `left` (12,) as for `retained`."""
    return angle_between(rows(left, 3), UNTURNED)


_ATTITUDE = "payload's attitude"
"""Name of the condition for the rotation that is left."""
_PLACE_SAYS = ("payload {} from its stowed place", "")
_TURN_SAYS = ("payload turned {} from its stowed attitude", "")
