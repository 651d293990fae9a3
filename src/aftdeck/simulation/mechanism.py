"""What a mechanism may do to what the arm holds: carriage and latches wait before a contact."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.log import log
from aftdeck.simulation.state import State
from aftdeck.worksite.restrain import worsened


def waits(flight: Flight, state: State, k: int, pose: Array, what: str) -> bool:
    """Whether a mechanism may not draw cargo k on, since that would deepen or make a contact; told once.

    Walls along which it slides count: a mechanism does not slide.

    Args:
        flight: what never changes.
        state: after its look.
        k: which cargo, held.
        pose: (12,) where the mechanism draws it, in L.
        what: the mechanism, for people.
    """
    site, things = flight.site, state.site
    after = things.frames.copy()
    after[site.cargo_row(k)] = pose
    group = worsened(things.watch, things.contacts.arm & (1 - things.permitted), after)
    if group >= 0 and not things.waiting:
        a, b = site.layout.named(group)
        log(flight, state, "waits", "caution", f"the {what} waits: it would bring {a} deeper into {b}")
    things.waiting = group >= 0
    return things.waiting
