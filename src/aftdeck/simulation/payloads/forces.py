"""Forces of captures, berths and contacts, on a plant with masses: the greatest ones, and their log lines."""

from __future__ import annotations

from aftdeck.matrices import length
from aftdeck.plant.state import Bodies
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.log import log
from aftdeck.simulation.parts.worksite_state import PayloadState
from aftdeck.simulation.state import State

REPORTED_AFTER = 5.0
"""Time after the beginning of a hold, in which its greatest force is found [s] (assumed)."""


def held_by(site: Site, payload: PayloadState) -> tuple[bool, bool, bool]:
    """Return whether the end effector, the orbiter and space hold a payload."""
    in_space = bool(payload.seat) and site.in_space(payload.seat)
    return payload.held, bool(payload.seat) and not in_space, in_space


def watch_forces(flight: Flight, state: State, bodies: Bodies) -> None:
    """Update the greatest forces of holds and contacts; log the force of a capture, of a docking or of latches.

    The force of a hold is logged once, when the hold has lasted for `REPORTED_AFTER` and no latch moves.
    """
    period = flight.scenario.control_period
    for k, payload in enumerate(state.worksite.cargo):
        for holder, holds in enumerate(held_by(flight.site, payload)):
            force = float(bodies.held[k, holder])
            if not (holds or force > 0.0):
                bodies.held_peaks[k, holder] = bodies.held_for[k, holder] = 0.0
                continue
            bodies.held_peaks[k, holder] = max(float(bodies.held_peaks[k, holder]), force)
            if not holds or payload.latches.motion:
                continue
            before = float(bodies.held_for[k, holder])
            bodies.held_for[k, holder] = before + period
            if before < REPORTED_AFTER <= before + period:
                _report(flight, state, k, holder, float(bodies.held_peaks[k, holder]))
    if not (bodies.touches or bodies.touch_peaks):
        return
    peaks, touching = bodies.touch_peaks, {touch.group for touch in bodies.touches}
    for touch in bodies.touches:
        peaks[touch.group] = max(peaks.get(touch.group, 0.0), length(touch.force))
    for group in peaks.keys() - touching - set(state.worksite.logged_contacts):
        del peaks[group]  # a contact that was too short for a log line


def _report(flight: Flight, state: State, k: int, holder: int, force: float) -> None:
    """Log the greatest force of a hold [N]."""
    payload, title = state.worksite.cargo[k], flight.site.cargo[k].title
    by = "end effector" if holder == 0 else flight.site.seat(payload.seat).title
    log(flight, state, "force", "info", f"{by} holds {title}: greatest force {force:.0f} N")


def peak_text(bodies: Bodies | None, group: int) -> str:
    """Return the text of a contact's greatest force, and forget it; "" on a plant without contact forces."""
    if bodies is None or (peak := bodies.touch_peaks.pop(group, None)) is None:
        return ""
    return f"; greatest force {peak:.0f} N"
