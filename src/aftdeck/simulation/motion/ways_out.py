"""Escape directions: stick or joint commands that lead away from a singularity, or back inside a joint limit."""

from __future__ import annotations

from typing import Literal

import numpy as np

from aftdeck.kinematics.singular import NAMES
from aftdeck.simulation.constants.flight import Flight, Pair
from aftdeck.simulation.frame import WayOut
from aftdeck.simulation.log import joint_label
from aftdeck.simulation.state import State
from aftdeck.steering.layout import ANGLES, COMMAND, LAW
from aftdeck.steering.mode import MODES
from aftdeck.steering.way_out import DIRECTIONS, joint_out, way_out

LEAST = 1e-3
"""Least rate at which a stick direction must lead away to count as an escape direction.

The rate is the growth of the distance from a singularity [1/s], or the rate of a joint away from its limit [rad/s].
"""
NEARLY = 0.6
"""Fraction of the greatest rate [1]. The previous escape direction is kept if its rate is at least this fraction."""
AXES: tuple[tuple[Literal["rotation", "translation"], str], ...] = (
    ("rotation", "RHC {}roll"),
    ("rotation", "RHC {}pitch"),
    ("rotation", "RHC {}yaw"),
    ("translation", "THC {}X"),
    ("translation", "THC {}Y"),
    ("translation", "THC {}Z"),
)
"""For each axis of the sticks: the stick, and the name of the axis with braces for the sign."""


def ways_out(flight: Flight, state: State, zones: tuple[int, ...], singular: tuple[str, ...]) -> tuple[WayOut, ...]:
    """Return an escape direction for each nearby singularity and each joint past a limit; update `panel.advice`.

    Under ARM INHIBIT, return only the escape direction from the contacts, if there is one (`contact_out`).
    """
    contact = state.worksite.contacts.inhibit.arm
    if contact or (not singular and not any(zones)):
        state.panel.advice.clear()
        return (state.worksite.advice,) if contact and state.worksite.advice is not None else ()
    found = [_from_singularity(flight, state, NAMES.index(name), zones) for name in singular]
    found += [_from_limit(flight, state, joint) for joint, zone in enumerate(zones) if zone]
    return tuple(found)


def _stick_speeds(state: State, singularity: int, joint: int, inward: float) -> np.ndarray:
    """Return the rate (12,) at which each stick direction leads away from a singularity or a limit.

    If the mode is not manual, ORB UNL is assumed. See `steering.way_out.way_out` for the arguments.
    """
    rules, command, steering = steering_of(state)
    speeds = np.zeros(DIRECTIONS)
    way_out(rules, command, steering, singularity, joint, inward, speeds)
    return speeds


def steering_of(state: State) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the rules, the command and the state with which the steering evaluates the stick directions.

    Rules and command are those of the present mode if it is manual, else those of ORB UNL.
    """
    panel = state.panel
    manual = MODES[panel.mode].kind == "manual"
    command = np.zeros(COMMAND)
    command[LAW] = panel.flown if manual else 4
    steering = state.steering.copy()
    steering[ANGLES : ANGLES + len(state.plant.angles)] = state.plant.angles
    return state.rules if manual else state.carried.rules["ORB UNL", panel.rate, 4], command, steering


def by_stick(state: State, cause: str, direction: int) -> WayOut:
    """Return a stick direction, 0 to 11 (axis by axis, + before −), as an escape direction.

    If the present mode is not manual, the operator first has to select ORB UNL.
    """
    (stick, name), sign = AXES[direction // 2], 1 if direction % 2 == 0 else -1
    text, enter = name.format("+" if sign > 0 else "−"), "" if MODES[state.panel.mode].kind == "manual" else "ORB UNL"
    return WayOut(cause, f"{enter}, {text}" if enter else text, stick, direction // 2 % 3, sign, enter)


def by_joint(flight: Flight, position: str, cause: str, joint: int, sign: int) -> WayOut:
    """Return the motion of one joint, in the panel position `position`, as an escape direction."""
    text = f"{position} {joint_label(flight.scenario.arm.joints[joint])} {'+' if sign > 0 else '−'}"
    return WayOut(cause, text, "joint", joint, sign, position)


def _best(state: State, cause: str, speeds: np.ndarray) -> WayOut | None:
    """Return the stick direction that leads away fastest, or the previous direction if it is nearly as fast.

    Returns:
        The escape direction; its number is also stored in `panel.advice` under `cause`. None if every stick direction
        leads away more slowly than `LEAST`.
    """
    advice = state.panel.advice
    best = int(speeds.argmax())
    if speeds[best] < LEAST:
        return None
    before = advice.get(cause, best)
    if speeds[before] >= NEARLY * speeds[best]:
        best = before
    advice[cause] = best
    return by_stick(state, cause, best)


def _from_singularity(flight: Flight, state: State, which: int, zones: tuple[int, ...]) -> WayOut:
    name = NAMES[which]
    if not MODES[state.panel.mode].by_joint and (out := _best(state, name, _stick_speeds(state, which, -1, 0.0))):
        return out
    arm = flight.scenario.arm
    joint, sign = joint_out(arm.model.links, state.plant.angles, arm.limits.reach, which, arm.model.singular)
    if zones[joint]:
        sign = _inward(flight.reach[joint], state.plant.angles[joint])
    return by_joint(flight, _position(state.panel.mode), name, joint, sign)


def _from_limit(flight: Flight, state: State, joint: int) -> WayOut:
    name = flight.scenario.arm.joints[joint]
    inward = _inward(flight.reach[joint], state.plant.angles[joint])
    if not MODES[state.panel.mode].by_joint and (out := _best(state, name, _stick_speeds(state, -1, joint, inward))):
        return out
    return by_joint(flight, _position(state.panel.mode), name, joint, inward)


def _position(mode: str) -> str:
    """Return the panel position for a motion of one joint: the present mode if it moves joints, else SINGLE."""
    return mode if MODES[mode].by_joint else "SINGLE"


def _inward(reach: Pair, angle: float) -> int:
    """Return the direction, +1 or -1, in which a joint moves away from the nearer of its reach limits."""
    low, high = reach
    return 1 if angle < 0.5 * (low + high) else -1
