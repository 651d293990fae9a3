"""Look-ahead: prediction of the arm's pose after some seconds with the present stick command.

The steering laws move a copy of the arm (`steering.rehearsal`). The prediction is exact except for contacts: contacts
do not stop the copy, but the first contact is reported.
"""

from __future__ import annotations

import contextlib
from typing import Literal, cast

import msgspec
import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.matrices import lengths
from aftdeck.plain_values import items, number, whole_number
from aftdeck.simulation.constants.flight import Flight, Pair
from aftdeck.simulation.frame_poses import frames_at
from aftdeck.simulation.motion.standstill import joint_lock_reason
from aftdeck.simulation.observe.look_work import near_of
from aftdeck.simulation.payloads.alignment import alarm_pairs
from aftdeck.simulation.payloads.relations import permitted
from aftdeck.simulation.state import State
from aftdeck.steering.layout import ANGLES, DRIVE, LAW, MOTION_ACTIVE, REPORT, SHOULDER_OFFSET, STICKS, TWIST
from aftdeck.steering.mode import MODES
from aftdeck.steering.msteer import measured
from aftdeck.steering.rehearsal import rehearse
from aftdeck.tuples import Joints, Rows, Vec3
from aftdeck.units import short
from aftdeck.worksite.report import Near
from aftdeck.worksite.watch.found import CLEARANCE

LEAST_S, MOST_S = 2.0, 20.0
"""Shortest and longest look-ahead [s]."""
SAMPLES = 10
"""Number of poses along the predicted motion at which clearances are measured."""
CONTACT = 0.0
"""Largest clearance that counts as a contact [m]."""
DRIVE_AXIS = 6
"""Axis number of the drive switch."""
_ORB_UNL = 4.0
"""Steering law that brings the arm to rest with the sticks centred."""
_STILL = 1e-6
"""Twist up to which the arm counts as at rest [m/s], [rad/s], and joint motion up to which the pose counts as
unchanged [rad]."""
_LONGEST_STOP = 60.0
"""Greatest duration of the computed deceleration [s]."""

Axis = tuple[int, Literal[-1, 1]]
"""Axis number and sign. 0 to 2: rotation about axes 1 to 3; 3 to 5: translation along them; 6: the drive switch."""


class Ahead(msgspec.Struct, frozen=True, gc=False):
    """Prediction of the arm's motion with the present stick command."""

    seconds: float
    """Prediction time [s]."""
    held: bool
    """Whether the prediction uses the present stick command.

    False under BRAKES or SAFING, and if the sticks are centred. With centred sticks, the prediction may assume full
    deflection of one axis (`last`).
    """
    moves: bool
    """Whether the arm's pose at that time differs from the present one."""
    angles: Joints
    """Joint angles at that time [rad]."""
    stand: float
    """Height of the shoulder at that time [m]."""
    payloads: tuple[tuple[Vec3, Rows], ...]
    """Centre and axes (rows) of each payload of the worksite at that time, in L [m]."""
    nearest: Near | None
    """Pair with the minimum clearance among those that count for CLEARANCE at that time; None if no pair counts."""
    contact_s: float | None
    """Time of the first contact, rounded up to a multiple of `seconds` / 10 [s]; None if no contact is found."""
    stopping: float
    """Distance between the tip's positions now and at rest, if the sticks are centred now [m]."""
    joint: int
    """Joint nearest to a reach limit at that time, from 0."""
    room: float
    """Distance of that joint from its reach limit at that time; negative past the limit [rad or m].

    Joints that turn and joints that slide are compared by these numbers.
    """


def look_ahead(flight: Flight, state: State, seconds: float, last: Axis | None = None) -> Ahead:
    """Return a prediction of the arm's motion with the present stick command.

    Args:
        flight: constants of the run.
        state: the state after a step; not changed.
        seconds: prediction time, `LEAST_S` to `MOST_S` [s].
        last: if the sticks are centred, axis to deflect fully, and sign of the deflection; None deflects no axis.

    Raises:
        InputError: `seconds` is outside its range, or `last` is not an axis with a sign.
    """
    seconds, last = _seconds(seconds), None if last is None else _axis(last)
    command, steering, held = _initial_command(state, last)
    rules, report = state.rules, np.zeros(REPORT)
    site, worksite, stand, travel = flight.site, state.worksite, state.plant.stand, flight.telescope
    driven = stand.velocity / travel.rate if travel.rate else 0.0
    outside = alarm_pairs(flight, state, worksite.watch, worksite.frames, worksite.permitted)[0]
    port = [meeting.group for meeting in site.meetings if meeting.relation == "docking" and not outside[meeting.group]]
    joints = len(state.plant.angles)
    watch, height, contact, docked, period = worksite.watch.copied(), stand.position, None, False, seconds / SAMPLES
    for sample in range(1, SAMPLES + 1):
        rehearse(rules, command, steering, report, period)
        height = stand.after(travel, driven, sample * period)
        steering[SHOULDER_OFFSET] += height - stand.after(travel, driven, (sample - 1) * period)
        angles = steering[ANGLES : ANGLES + joints]
        frames = frames_at(site, worksite, state.plant, angles, height, worksite.prong.position)
        watch.look_near(frames, site.detrimental, 0.0)
        may = permitted(flight, state, watch, frames)
        # a pair that is aligned now is not tested: its parts will be docked or latched before they penetrate deeply;
        # a payload that is docked moves no further
        docked = docked or bool((watch.found[port, CLEARANCE] <= CONTACT).any())
        touching = watch.nearest(site.detrimental | (outside & (1 - may)))
        if contact is None and not docked and touching >= 0 and watch.found[touching, CLEARANCE] <= CONTACT:
            contact = sample * period
    counts = alarm_pairs(flight, state, watch, frames, may)[0]
    watch.look_near(frames, counts, 0.0)
    group = watch.nearest(counts)
    predicted = tuple(angles.tolist())
    joint, room = _room(flight.reach, predicted)
    return Ahead(
        seconds=seconds,
        held=held,
        moves=bool(np.abs(angles - state.plant.angles).max() > _STILL or height != stand.position),
        angles=predicted,
        stand=height,
        payloads=tuple(_placed(row) for row in frames[len(frames) - len(site.payloads) :].tolist()),
        nearest=None if group < 0 else near_of(site.layout, worksite.contacts.essential, watch, group, frames, period),
        contact_s=contact,
        stopping=_stopping(state),
        joint=joint,
        room=room,
    )


def _seconds(given: object) -> float:
    """Return the prediction time [s]; raise InputError if it is not a number in its range."""
    with contextlib.suppress(Exception):  # methods of a foreign object may raise anything
        if LEAST_S <= (seconds := number(given)) <= MOST_S:
            return seconds
    raise InputError(f"seconds: got {short(given)}, expected {LEAST_S:g} to {MOST_S:g}")


def _axis(given: object) -> Axis:
    """Return an axis and the sign of its deflection; raise InputError if they are anything else."""
    with contextlib.suppress(Exception):  # methods of a foreign object may raise anything
        axis, sign = map(whole_number, items(given, (2,)))
        if 0 <= axis <= DRIVE_AXIS and sign in (-1, 1):
            return axis, cast("Literal[-1, 1]", sign)
    raise InputError(f"last: got {short(given)}, expected an axis from 0 to {DRIVE_AXIS} and a sign, -1 or 1")


def _placed(row: list[float]) -> tuple[Vec3, Rows]:
    x, y, z, a, b, c, d, e, f, g, h, i = row
    return (x, y, z), ((a, b, c), (d, e, f), (g, h, i))


def _copies(state: State) -> tuple[Array, Array]:
    """Return copies of the command and of the steering's state, with the present measurements, for a prediction."""
    steering = state.steering.copy()
    measured(state.plant.angles, state.plant.rates, state.plant.angles, state.shoulder_offset, steering)
    return state.command.copy(), steering


def _initial_command(state: State, last: Axis | None) -> tuple[Array, Array, bool]:
    """Return the prediction's command and initial steering state, and whether it uses the present stick command."""
    command, steering = _copies(state)
    held = bool(command[STICKS : STICKS + 6].any() or command[DRIVE])
    if joint_lock_reason(state.panel):
        command[STICKS : STICKS + 6] = command[DRIVE] = 0.0
        command[LAW], command[MOTION_ACTIVE] = _ORB_UNL, 0.0
        return command, steering, False
    if not held and last is not None and MODES[state.panel.mode].kind in ("manual", "single"):
        axis, sign = last
        command[DRIVE if axis == DRIVE_AXIS else STICKS + axis] = sign
        command[LAW], command[MOTION_ACTIVE] = state.panel.flown, 0.0  # a stick overrides POSITION HOLD
    if MODES[state.panel.mode].kind == "automatic" and state.panel.sequence != "in progress":
        command[LAW], command[MOTION_ACTIVE] = _ORB_UNL, 0.0  # the arm stays at rest until PROCEED
    return command, steering, held


def _stopping(state: State) -> float:
    """Return the distance between the tip's positions now and at rest, if the sticks are centred now [m]."""
    (command, steering), report = _copies(state), np.zeros(REPORT)
    command[STICKS : STICKS + 6] = 0.0
    command[DRIVE] = command[MOTION_ACTIVE] = 0.0
    if MODES[state.panel.mode].kind != "single":
        command[LAW] = _ORB_UNL
    rules, elapsed = state.rules, 0.0
    while np.abs(steering[TWIST : TWIST + 6]).max() > _STILL and elapsed < _LONGEST_STOP:
        rehearse(rules, command, steering, report, 0.5)
        command[MOTION_ACTIVE] = 0.0
        elapsed += 0.5
    now = state.plant.angles
    here, there = (state.arm.forward(angles).position for angles in (now, steering[ANGLES : ANGLES + len(now)]))
    return float(lengths(here - there))


def _room(reach: tuple[Pair, ...], angles: Joints) -> tuple[int, float]:
    """Return the joint nearest to a reach limit, and its distance from that limit; negative past the limit [rad]."""
    rooms = [min(q - low, high - q) for q, (low, high) in zip(angles, reach, strict=True)]
    joint = min(range(len(rooms)), key=rooms.__getitem__)
    return joint, rooms[joint]
