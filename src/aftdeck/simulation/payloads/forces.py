"""Forces of captures, berths and contacts, on a plant with masses: the greatest ones, and the log lines of holds."""

from __future__ import annotations

from msgspec.structs import replace

from aftdeck.matrices import length
from aftdeck.plant.state import Bodies, ContactForce
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.worksite_state import PayloadState, WorksiteState

REPORTED_AFTER = 5.0
"""Time after the beginning of a hold, in which its greatest force is found [s] (assumed)."""
ENDED_AFTER = 2.0
"""Time without a touch after which a contact has ended [s]: a part that bounces between the sides of a guide returns
sooner (assumed)."""


def held_by(site: Site, payload: PayloadState) -> tuple[bool, bool, bool]:
    """Return whether the end effector, the orbiter and space hold a payload."""
    in_space = bool(payload.berth) and site.in_space(payload.berth)
    return payload.held, bool(payload.berth) and not in_space, in_space


def watch_forces(site: Site, worksite: WorksiteState, bodies: Bodies, log: Log, period: float) -> None:
    """Update the greatest forces of holds and contacts; log the force of a capture, of a docking or of latches.

    The force of a hold is logged once, when the hold has lasted for `REPORTED_AFTER` and no latch moves.
    `period` is the control period [s].
    """
    for k, payload in enumerate(worksite.payloads):
        for holder, holds in enumerate(held_by(site, payload)):
            force = float(bodies.held_greatest[k, holder])
            if not (holds or force > 0.0):
                bodies.held_peaks[k, holder] = bodies.held_for[k, holder] = 0.0
                continue
            bodies.held_peaks[k, holder] = max(float(bodies.held_peaks[k, holder]), force)
            if not holds or payload.latches.motion:
                continue
            before = float(bodies.held_for[k, holder])
            bodies.held_for[k, holder] = before + period
            if before < REPORTED_AFTER <= before + period:
                by, peak = _holder(site, payload, holder), float(bodies.held_peaks[k, holder])
                log.add("force", "info", f"{by} holds {site.payloads[k].title}: greatest force {peak:.0f} N")
    if bodies.touches or bodies.contacts:
        _count_contacts(bodies, worksite.logged_contacts, period)


def _count_contacts(bodies: Bodies, logged: tuple[int, ...], period: float) -> None:
    """Update the force of each contact; forget contacts that have ended and are not in `logged`."""
    contacts = bodies.contacts
    before = dict(contacts)
    for touch in bodies.touches:
        so_far = before.pop(touch.group, ContactForce())
        contacts[touch.group] = ContactForce(
            max(so_far.greatest, touch.greatest), so_far.impulse + length(touch.force) * period
        )
    for group, so_far in before.items():
        if so_far.apart_for > ENDED_AFTER and group not in logged:
            del contacts[group]
        else:
            contacts[group] = replace(so_far, apart_for=so_far.apart_for + period)


def _holder(site: Site, payload: PayloadState, holder: int) -> str:
    """Return the name of what holds a payload; `holder`: its index in the result of `held_by`."""
    return "end effector" if holder == 0 else site.berth(payload.berth).title
