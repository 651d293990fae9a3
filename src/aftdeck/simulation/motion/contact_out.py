"""Escape direction from the contacts that inhibit the arm: a motion by a stick, one joint or the telescope."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame import WayOut
from aftdeck.simulation.motion.ways_out import by_joint, by_stick, steering_of
from aftdeck.simulation.period.inhibit import ways_out
from aftdeck.simulation.state import State
from aftdeck.steering.mode import MODES
from aftdeck.steering.way_out import DIRECTIONS, stick_rates

SEARCH_EVERY = 10
"""Number of control steps from one search to the next."""
CONTACT = "contact"
"""Value of `WayOut.cause` for an escape direction from contacts."""
SLOWLY = 0.02
"""Fraction of the full rates at which motions are evaluated [1]. An arm that starts from rest has about these rates."""


class _Motion(NamedTuple):
    """Motion that the operator can command.

    Attributes:
        command: the operator's command for this motion.
        rates: (n,) joint rates [rad/s].
        telescope: drive of the telescope, -1 to 1.
    """

    command: WayOut
    rates: Array
    telescope: float


def way_out_of_contact(flight: Flight, state: State) -> None:
    """Find the motion that leads out of the contacts fastest, and store its command in `worksite.advice`.

    Motions of single joints and of the telescope are tried only if no stick direction leads out of the contacts. If no
    motion at all leads out of them, `advice` is None. The search runs every `SEARCH_EVERY` steps, and in every step
    while `advice` is None.
    """
    worksite = state.worksite
    if worksite.advice and state.tick % SEARCH_EVERY:
        return
    for motions, slides in ((_sticks(state), True), (_joints(flight, state.panel.mode), False)):
        rates, drives = np.array([own.rates for own in motions]), np.array([own.telescope for own in motions])
        gains = np.empty(len(motions))
        ways_out(state.row.arrays(flight.packed), rates, drives, SLOWLY, slides, gains)
        if gains.max() > 0.0:
            worksite.advice = motions[int(gains.argmax())].command
            return
    worksite.advice = None


def _sticks(state: State) -> list[_Motion]:
    """Return the motion of each stick direction, in the present mode if it is manual, else in ORB UNL."""
    rates = np.zeros((DIRECTIONS, len(state.plant.angles)))
    stick_rates(*steering_of(state), rates)
    return [_Motion(by_stick(state, CONTACT, k), own, 0.0) for k, own in enumerate(rates)]


def _joints(flight: Flight, present: str) -> list[_Motion]:
    """Return the motions of each single joint, and of the telescope if the arm has one; `present`: the present mode."""
    mode = present if MODES[present].kind == "single" else "SINGLE"
    found, joints = [], len(flight.scenario.arm.joints)
    for joint, limit in enumerate(flight.scenario.arm.rate_limits):
        for sign in (1, -1):
            rates = np.zeros(joints)
            rates[joint] = sign * limit
            found.append(_Motion(by_joint(flight, mode, CONTACT, joint, sign), rates, 0.0))
    if flight.telescope.rate:
        for sign, text in ((1, "telescope longer"), (-1, "telescope shorter")):
            found.append(_Motion(WayOut(CONTACT, text, "telescope", 0, sign), np.zeros(joints), float(sign)))
    return found
