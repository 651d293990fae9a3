"""LATCH and UNLATCH: choice of the payload, and confirmation before releasing a payload that nothing else holds."""

from __future__ import annotations

import math
from typing import Literal

from aftdeck.simulation.constants.berths import Berth
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.log import log
from aftdeck.simulation.state import State
from aftdeck.worksite.watch.contact_update import nearest_place

Pressed = Literal["latch", "unlatch"]

NEAR = 3.0
"""Distance of a cargo from its place in a seat beyond which the cargo is not yet being brought there [m]."""
CONFIRM = 10.0
"""Time within which a second UNLATCH confirms the first, for a cargo that nothing else holds [s]; assumed."""


def nearest_berth(flight: Flight, state: State, k: int) -> Berth | None:
    """Return the place in a seat that is nearest to a cargo; None if none is within `NEAR`."""
    site = flight.site
    nearest = nearest_place(state.worksite.frames, site.cargo_row(k), site.berth_rows[k], site.berth_places[k], NEAR)
    return None if nearest < 0 else site.berths[k][nearest]


def meant(flight: Flight, state: State, pressed: Pressed | None) -> int | None:
    """Return the payload that LATCH or UNLATCH is for: the one in the grasp, else the one nearest to the hand.

    Payloads on which the command can act come first. UNLATCH acts on payloads that latches or a port hold. LATCH acts
    on payloads that are near their place in a seat, and that latches or a port do not hold firmly.

    Returns:
        The payload; None if there is none, or if the grasp is empty and nothing is pressed.
    """
    site, worksite = flight.site, state.worksite
    if pressed is None or worksite.held is not None:
        return worksite.held
    hand = worksite.frames[site.last_joint, :3]
    ways = []
    for k, thing in enumerate(worksite.cargo):
        if thing.seat:
            fits = not site.is_passive_berth(thing.seat) and (pressed == "unlatch" or not _latched(flight, state, k))
        else:
            fits = pressed == "latch" and nearest_berth(flight, state, k) is not None
        ways.append((not fits, math.dist(hand.tolist(), worksite.frames[site.cargo_row(k), :3].tolist()), k))
    return min(ways)[2] if ways else None


def _latched(flight: Flight, state: State, k: int) -> bool:
    """Return whether a seat holds a cargo firmly: by docking, or by latches that are closed and not opening."""
    thing = state.worksite.cargo[k]
    return thing.latches.closed == 1.0 and thing.latches.motion != "unlatch"


def confirmed(flight: Flight, state: State, k: int, title: str) -> bool:
    """Return whether UNLATCH of a cargo may be executed; ask for confirmation if nothing but its seat holds the cargo.

    The question is a log line, and a second UNLATCH within `CONFIRM` confirms. A switch that is held over several steps
    is one command.
    """
    thing, tick = state.worksite.cargo[k], state.tick
    if thing.held or thing.latches.motion == "unlatch":
        return True
    steps, thing.unlatch_asked_at = tick - thing.unlatch_asked_at if thing.unlatch_asked_at else math.inf, tick
    if steps == 1:
        return False
    if steps * flight.scenario.control_period <= CONFIRM:
        thing.unlatch_asked_at = 0
        return True
    name = flight.site.cargo[k].title
    text = f"UNLATCH again within {CONFIRM:g} s to confirm: nothing but the {title} holds {name}"
    log(flight, state, "unlatch", "caution", text)
    return False
