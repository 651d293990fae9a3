"""Look ahead: where the arm is in a few seconds if the sticks stay as they are, found by flying there on a copy.

It is the steering's own laws that fly (`steering.rehearsal`), so that what is shown is what would come, but for
contacts: the copy flies through them, and the first is told.
"""

from __future__ import annotations

import math
from typing import Literal, cast

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.simulation.ahead import frames_at
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.frame import Six
from aftdeck.simulation.lined_up import counted
from aftdeck.simulation.look_work import near_of
from aftdeck.simulation.relations import permitted
from aftdeck.simulation.standstill import standing
from aftdeck.simulation.state import State
from aftdeck.steering.layout import ANGLES, DRIVE, GO, LAW, REPORT, RISE, STICKS, TWIST
from aftdeck.steering.mode import MODES
from aftdeck.steering.msteer import measured
from aftdeck.steering.rehearsal import rehearse
from aftdeck.worksite.found import CLEARANCE
from aftdeck.worksite.report import Near, Rows, Vec3

LEAST_S, MOST_S = 2.0, 20.0
"""How far may be looked ahead [s]."""
SAMPLES = 10
"""Places on the way at which clearances are measured."""
CONTACT = 0.0
"""A clearance that counts as a contact on the way [m]."""
DRIVE_AXIS = 6
"""The number of the drive switch among the axes."""
_ORB_UNL = 4.0
"""A law that comes to rest when its sticks are let go."""
_STILL = 1e-6
"""Twist that counts as rest [m/s], [rad/s], and turn that counts as none [rad]."""
_LONGEST_STOP = 60.0
"""Longest way to rest that is followed [s]."""

Axis = tuple[int, Literal[-1, 1]]
"""One of the sticks' six axes, about 1 to 3 and then along them, or 6, the drive switch; and a sign."""


class Ahead(msgspec.Struct, frozen=True, gc=False):
    """What comes of the sticks as they are."""

    seconds: float
    """How far was looked [s]."""
    held: bool
    """The sticks as they stand; False: they rest, and this is what one axis would do at full deflection."""
    moves: bool
    """Whether the arm is then elsewhere than now."""
    angles: Six
    """Joint angles then [rad]."""
    stand: float
    """Height of the shoulder then [m]."""
    cargo: tuple[tuple[Vec3, Rows], ...]
    """Centre and axes (rows) of each payload of the worksite then, in L [m]."""
    nearest: Near | None
    """The watched pair with the least clearance then, of those that count then (`lined_up`)."""
    contact_s: float | None
    """When the first contact is found on the way, to a tenth of `seconds`; None: none is [s]."""
    stopping: float
    """How far the tip goes on if the sticks are let go now [m]."""
    joint: int
    """The joint nearest to a limit then, 0 to 5."""
    room: float
    """How far it is from its reach limit then; negative past it [rad]."""


def look_ahead(flight: Flight, state: State, seconds: float, last: Axis | None = None) -> Ahead:
    """Fly a copy of the arm for some seconds with the sticks as they stand.

    Args:
        flight: what never changes.
        state: after a step; it is not changed.
        seconds: how far, `LEAST_S` to `MOST_S`.
        last: the axis that is deflected in full where the sticks rest; None: none.

    Raises:
        InputError: seconds or an axis that are none of these.
    """
    if not LEAST_S <= seconds <= MOST_S:
        raise InputError(f"one looks {LEAST_S:g} to {MOST_S:g} s ahead, got {seconds:g}")
    if last is not None and not (last[0] in range(DRIVE_AXIS + 1) and last[1] in (-1, 1)):
        raise InputError(f"axes are numbered 0 to {DRIVE_AXIS}, their signs are -1 and 1, got {last}")
    seconds, last = float(seconds), None if last is None else (int(last[0]), cast("Literal[-1, 1]", int(last[1])))
    command, steering, held = _asked(state, last)
    rules, report = state.rules, np.zeros(REPORT)
    site, things, stand, travel = flight.site, state.site, state.plant.stand, flight.telescope
    driven = stand.velocity / travel.rate if travel.rate else 0.0
    outside = counted(
        flight, things.held, things.watch, things.frames, things.lined_up, things.nearest, things.contacts,
        things.permitted,
    )[0]  # fmt: skip
    watch, height, contact, period = things.watch.copied(), stand.position, None, seconds / SAMPLES
    for sample in range(1, SAMPLES + 1):
        rehearse(rules, command, steering, report, period)
        height = stand.after(travel, driven, sample * period)
        steering[RISE] += height - stand.after(travel, driven, (sample - 1) * period)
        angles = steering[ANGLES : ANGLES + 6]
        frames = frames_at(flight, state, angles, height, things.prong.position)
        watch.look_near(frames, frames, period, site.detrimental, 0.0)
        may = permitted(site, watch, frames)
        # what is lined up now is docked or latched before it gets deep
        touching = watch.nearest(site.detrimental | (outside & (1 - may)))
        if contact is None and touching >= 0 and watch.found[touching, CLEARANCE] <= CONTACT:
            contact = sample * period
    counts = counted(flight, things.held, watch, frames, things.lined_up, things.nearest, things.contacts, may)[0]
    watch.look_near(frames, frames, period, counts, 0.0)
    group = watch.nearest(counts)
    a, b, c, d, e, f = angles.tolist()
    joint, room = _room(flight, (a, b, c, d, e, f))
    return Ahead(
        seconds=seconds,
        held=held,
        moves=bool(np.abs(angles - state.plant.angles).max() > _STILL or height != stand.position),
        angles=(a, b, c, d, e, f),
        stand=height,
        cargo=tuple(_placed(row) for row in frames[len(frames) - len(site.cargo) :].tolist()),
        nearest=None if group < 0 else near_of(flight, state, watch.found, group),
        contact_s=contact,
        stopping=_stopping(state),
        joint=joint,
        room=room,
    )


def _placed(row: list[float]) -> tuple[Vec3, Rows]:
    x, y, z, a, b, c, d, e, f, g, h, i = row
    return (x, y, z), ((a, b, c), (d, e, f), (g, h, i))


def _copies(state: State) -> tuple[Array, Array]:
    """What the steering is told, and how the arm moves, as measured now: to be flown on."""
    steering = state.steering.copy()
    measured(state.plant.angles, state.plant.rates, state.rise, steering)
    return state.command.copy(), steering


def _asked(state: State, last: Axis | None) -> tuple[Array, Array, bool]:
    """Command and steering to fly on, and whether it is the sticks as they stand."""
    command, steering = _copies(state)
    held = bool(command[STICKS : STICKS + 6].any() or command[DRIVE])
    if standing(state.panel):
        command[STICKS : STICKS + 6] = command[DRIVE] = 0.0
        command[LAW], command[GO] = _ORB_UNL, 0.0
        return command, steering, False
    if not held and last is not None and MODES[state.panel.mode].kind in ("manual", "single"):
        axis, sign = last
        command[DRIVE if axis == DRIVE_AXIS else STICKS + axis] = sign
        command[LAW], command[GO] = state.panel.flown, 0.0  # POSITION HOLD gives way to a stick
    if MODES[state.panel.mode].kind == "automatic" and state.panel.sequence != "in progress":
        command[LAW], command[GO] = _ORB_UNL, 0.0  # it waits for PROCEED, and rests
    return command, steering, held


def _stopping(state: State) -> float:
    """How far the tip goes from here until the arm rests, with nothing asked [m]."""
    (command, steering), report = _copies(state), np.zeros(REPORT)
    command[STICKS : STICKS + 6] = 0.0
    command[DRIVE] = command[GO] = 0.0
    if MODES[state.panel.mode].kind != "single":
        command[LAW] = _ORB_UNL
    rules, gone = state.rules, 0.0
    while np.abs(steering[TWIST : TWIST + 6]).max() > _STILL and gone < _LONGEST_STOP:
        rehearse(rules, command, steering, report, 0.5)
        command[GO] = 0.0
        gone += 0.5
    here, there = (state.arm.forward(angles).position for angles in (state.plant.angles, steering[ANGLES : ANGLES + 6]))
    return math.dist(here, there)


def _room(flight: Flight, angles: Six) -> tuple[int, float]:
    """The joint that is nearest to a reach limit, and how far it is from that; negative past it [rad]."""
    rooms = [min(q - low, high - q) for q, (low, high) in zip(angles, flight.reach, strict=True)]
    joint = min(range(len(rooms)), key=rooms.__getitem__)
    return joint, rooms[joint]
