"""Escape directions: stick or joint commands that lead away from a singularity, or back inside a joint limit."""

from __future__ import annotations

from typing import Literal

import numpy as np

from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame import WayOut
from aftdeck.simulation.log import joint_label
from aftdeck.simulation.period.quick import take_advice
from aftdeck.simulation.period.ways import BY_ONE_JOINT, BY_STICK
from aftdeck.simulation.state import State
from aftdeck.steering.layout import ANGLES, COMMAND, LAW
from aftdeck.steering.mode import MODES

AXES: tuple[tuple[Literal["rotation", "translation"], str], ...] = (
    ("rotation", "RHC {}roll"),
    ("rotation", "RHC {}pitch"),
    ("rotation", "RHC {}yaw"),
    ("translation", "THC {}X"),
    ("translation", "THC {}Y"),
    ("translation", "THC {}Z"),
)
"""For each axis of the sticks: the stick, and the name of the axis with braces for the sign."""


def ways_out(flight: Flight, state: State) -> tuple[WayOut, ...]:
    """Return the escape directions that the laws have found in this step (`period.ways`); update `panel.advice`.

    Under ARM INHIBIT, return only the escape direction from the contacts, if there is one (`contact_out`).
    """
    panel, contact = state.panel, state.worksite.contacts.inhibit.arm
    if contact or (not panel.singular and not any(panel.zones)):
        panel.advice.clear()
        return (state.worksite.advice,) if contact and state.worksite.advice is not None else ()
    model, found = flight.scenario.arm.model, list[WayOut]()
    take_advice(flight, state)
    names, ways = (*model.singularities, *flight.scenario.arm.joints), state.row.limits.ways.tolist()
    for name, (how, which, sign) in zip(names, ways, strict=True):
        if how == BY_STICK:
            found.append(by_stick(state, name, which))
        elif how == BY_ONE_JOINT:
            found.append(by_joint(flight, _position(panel.mode), name, which, sign))
    return tuple(found)


def steering_of(state: State) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the rules, the command and the state with which the steering evaluates the stick directions.

    Rules and command are those of the present mode if it is manual, else those of ORB UNL.
    """
    panel, angles = state.panel, state.plant.angles
    command, steering = np.zeros(COMMAND), state.steering.copy()
    command[LAW] = panel.stick_law
    steering[ANGLES : ANGLES + len(angles)] = angles
    return state.stick_rules, command, steering


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


def _position(mode: str) -> str:
    """Return the panel position for a motion of one joint: the present mode if it moves joints, else SINGLE."""
    return mode if MODES[mode].by_joint else "SINGLE"
