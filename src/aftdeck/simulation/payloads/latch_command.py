"""LATCH and UNLATCH: selection of the payload, and confirmation of an UNLATCH after which the payload would float."""

from __future__ import annotations

import math
from typing import Literal

from aftdeck.arrays import Array
from aftdeck.matrices import distance
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.worksite_state import PayloadState, WorksiteState
from aftdeck.worksite.berths.berth import Fit
from aftdeck.worksite.berths.on_way import NEAR
from aftdeck.worksite.watch.places import nearest_place

Pressed = Literal["latch", "unlatch"]

CONFIRM = 10.0
"""Time within which a second UNLATCH confirms the first [s]; assumed."""


def nearest_berth(site: Site, frames: Array, k: int) -> Fit | None:
    """Return the berth whose final position for payload k is nearest to the payload; None if none is within `NEAR`."""
    nearest = nearest_place(frames, site.payload_rows[k], site.berth_rows[k], site.berth_places[k], NEAR)
    return None if nearest < 0 else site.fits[k][nearest]


def addressed(site: Site, worksite: WorksiteState, pressed: Pressed | None) -> int | None:
    """Return the payload to which LATCH or UNLATCH refers: the held payload, else the one nearest to the end effector.

    Payloads on which the command can act have precedence over nearer payloads. UNLATCH can act on payloads fixed by
    latches or by a port. LATCH can act on unfixed payloads near a berth, and on payloads whose latches are not fully
    closed or are opening.

    Returns:
        The payload; None if the worksite has no payload, or if the grasp is empty and neither switch is pressed.
    """
    if pressed is None or worksite.held is not None:
        return worksite.held
    hand = worksite.frames[site.last_joint, :3]
    candidates = []
    for k, payload in enumerate(worksite.payloads):
        if payload.berth:
            fits = site.berth(payload.berth).closes != "at release" and (
                pressed == "unlatch" or not _is_latched(payload)
            )
        else:
            fits = pressed == "latch" and nearest_berth(site, worksite.frames, k) is not None
        candidates.append((not fits, distance(hand.tolist(), worksite.frames[site.payload_rows[k], :3].tolist()), k))
    return min(candidates)[2] if candidates else None


def _is_latched(payload: PayloadState) -> bool:
    """Return whether a berth fixes a payload firmly: by docking, or by latches that are closed and not opening."""
    return payload.latches.closed == 1.0 and payload.latches.motion != "unlatch"


def confirmed(payload: PayloadState, tick: int, period: float, log: Log, only: str) -> bool:
    """Return whether UNLATCH of a payload may be executed.

    If the end effector does not hold the payload, the first UNLATCH only logs a request for confirmation, and a second
    UNLATCH within `CONFIRM` is executed. A switch that is pressed over several steps is one command.

    Args:
        payload: the payload; the number of the step of an unconfirmed UNLATCH is stored in it.
        tick: number of the control step.
        period: control period [s].
        log: log of the step.
        only: text for the request, which says that nothing but the berth holds the payload.
    """
    if payload.held or payload.latches.motion == "unlatch":
        return True
    steps, payload.unlatch_asked_at = tick - payload.unlatch_asked_at if payload.unlatch_asked_at else math.inf, tick
    if steps == 1:
        return False
    if steps * period <= CONFIRM:
        payload.unlatch_asked_at = 0
        return True
    log.add("unlatch", "caution", f"UNLATCH again within {CONFIRM:g} s to confirm: {only}")
    return False
