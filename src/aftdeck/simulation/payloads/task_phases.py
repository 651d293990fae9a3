"""Task phases, the report's modes 1 to 4: acquisition, extraction, manoeuvring, docked.

The task phase follows from the state of the payloads, not from an operator's command.
"""

from __future__ import annotations

from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.log import log
from aftdeck.simulation.state import State
from aftdeck.worksite.watch.bay import any_inside

ACQUISITION, EXTRACTION, MANOEUVRING, DOCKED = 1, 2, 3, 4
TASKS = {ACQUISITION: "acquisition", EXTRACTION: "extraction", MANOEUVRING: "manoeuvring", DOCKED: "docked"}


def change_task(flight: Flight, state: State) -> None:
    """Set the task phase from the present state, and log its change."""
    worksite = state.worksite
    now = _task(flight, state)
    if now != worksite.task:
        worksite.task = now
        log(flight, state, "task", "info", f"MODE {now}: {TASKS[now]}")


def _task(flight: Flight, state: State) -> int:
    """Return the task phase of the present state.

    ACQUISITION: no payload of the worksite is held. DOCKED: a held payload is fixed to a port. EXTRACTION: a held
    payload has a vertex inside the bay. MANOEUVRING: a held payload is elsewhere.
    """
    site, worksite = flight.site, state.worksite
    held = worksite.held
    if held is None:
        return ACQUISITION
    seat = worksite.cargo[held].seat
    if seat and site.seat(seat).kind == "port":
        return DOCKED
    return EXTRACTION if in_bay(flight, state, held) else MANOEUVRING


def in_bay(flight: Flight, state: State, k: int) -> bool:
    """Return whether a vertex of a payload is inside the bay: below its top, between its walls. False without a bay."""
    site = flight.site
    if site.bay is None:
        return False
    return any_inside(state.worksite.watch.placed, site.bodies[k], site.scene, site.bay[0], site.bay[1])
