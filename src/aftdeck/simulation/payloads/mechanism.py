"""Contact check for the carriage and the latches: both move a held payload, and stop if it would touch a part."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.worksite.watch.contact_motion import worst_new_contact


def is_blocked(flight: Flight, worksite: WorksiteState, log: Log, k: int, pose: Array, what: str) -> bool:
    """Return whether a mechanism must stop, because moving payload k to `pose` would make or deepen a contact.

    The stop is logged once. Contacts with walls along which the payload can slide count too, because a mechanism does
    not slide the payload. Essential contacts in a permitted relative position do not count.
    False if contacts do not inhibit motion: their forces then act on the payload.

    Args:
        flight: constants of the run.
        worksite: state of the worksite, with contacts that are up to date.
        log: log of the step.
        k: index of the payload, which is held.
        pose: (12,) pose to which the mechanism would draw the payload, in L.
        what: name of the mechanism, for the log.
    """
    if not flight.inhibits:
        return False
    after = worksite.frames.copy()
    after[flight.site.payload_rows[k]] = pose
    group = worst_new_contact(worksite.watch, worksite.contacts.arm & (1 - worksite.permitted), after)
    if group >= 0 and not worksite.waiting:
        a, b = flight.site.layout.named(group)
        text = f"{what} stopped: {a} would penetrate {b} further; move the payload clear"
        log.add("waits", "caution", text)
    worksite.waiting = group >= 0
    return worksite.waiting
