"""Commands of jets on a plant with masses: translation of the orbiter, and attitude control of free flyers."""

from __future__ import annotations

from math import nan

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import oriend_rows
from aftdeck.matrices import product
from aftdeck.plant.plant import NO_COMMAND, Push
from aftdeck.plant.state import Bodies
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.parts.free_flight import Floating
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.tuples import Rows, Vec3
from aftdeck.worksite.payload import Payload

BAND, RATE = slice(0, 3), slice(3, 6)
"""Parts of a packed limit cycle (`worksite.free_flight.LimitCycle`)."""


def translation_rejection(flight: Flight, worksite: WorksiteState, bodies: Bodies | None) -> str:
    """Return why the orbiter cannot translate; "" if it can."""
    site = flight.site
    if site.worksite.translation is None:
        return "orbiter translation refused: this worksite has none"
    if bodies is not None and flight.scenario.orbiter == "fixed":
        return "orbiter translation refused: the scenario fixes the orbiter (dynamics.orbiter)"
    held = worksite.held
    if held is not None and worksite.payloads[held].berth and site.in_space(worksite.payloads[held].berth):
        return "orbiter translation refused: the arm holds a docked payload; RELEASE or UNLATCH it"
    return ""


def translation_command(flight: Flight, worksite: WorksiteState, bodies: Bodies, given: Vec3) -> Array:
    """Return the commanded velocity of the orbiter along its axes (3,) [m/s]; NaN for an axis that is not commanded.

    After a command, an axis stays commanded to rest until it has come to rest.
    `given` is the operator's command along each axis, in [-1, 1].
    """
    rule, braking = flight.site.worksite.translation, worksite.orbiter_velocity
    if not any(given) and not any(braking.tolist()):
        return NO_COMMAND
    if rule is None or translation_rejection(flight, worksite, bodies):
        braking[:] = 0.0
        return NO_COMMAND
    return np.array(
        [
            along * rule.speed if along else (0.0 if moves else nan)
            for along, moves in zip(given, braking.tolist(), strict=True)
        ]
    )


def attitude_torques(
    payloads: tuple[Payload, ...], flights: list[Floating | None], bodies: Bodies, period: float
) -> list[Push]:
    """Return the torques of free flyers with attitude control.

    When an angle leaves its deadband, the jets turn the rate of this axis around within one control period.

    Args:
        payloads: the payloads.
        flights: free flight of each payload; None for a payload that does not float.
        bodies: the plant's bodies.
        period: control period [s].
    """
    found = []
    for k, floating in enumerate(flights):
        if floating is None or floating.cycle is None:
            continue
        turned = product(floating.reference.T, bodies.payloads[k, 3:].reshape(3, 3)).tolist()
        rows: Rows = (tuple(turned[0]), tuple(turned[1]), tuple(turned[2]))
        rates, change = bodies.motions[k, :3].tolist(), np.zeros(3)
        cycle = floating.cycle
        for axis, angle in enumerate(oriend_rows(rows)):
            band, rate = float(cycle[BAND][axis]), abs(float(cycle[RATE][axis]))
            wanted = -rate if angle > band else rate if angle < -band else rates[axis]
            if (angle > band and rates[axis] > wanted) or (angle < -band and rates[axis] < wanted):
                change[axis] = wanted - rates[axis]
        if any(change.tolist()):
            torque = product(payloads[k].inertia, change) / period
            turned = product(bodies.payloads[k, 3:].reshape(3, 3), torque)
            found.append(Push(k, np.zeros(3), turned, bodies.payloads[k, :3]))
    return found
