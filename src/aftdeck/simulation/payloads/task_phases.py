"""Task phases, the report's modes 1 to 4: acquisition, extraction, manoeuvring, docked.

The task phase follows from the state of the payloads, not from an operator's command.
"""

from __future__ import annotations

from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.worksite.watch.bay import any_inside
from aftdeck.worksite.watch.groups import Placing

ACQUISITION, EXTRACTION, MANOEUVRING, DOCKED = 1, 2, 3, 4
TASKS = {ACQUISITION: "acquisition", EXTRACTION: "extraction", MANOEUVRING: "manoeuvring", DOCKED: "docked"}


def change_task(worksite: WorksiteState, now: int, log: Log) -> None:
    """Set the task phase, and log its change."""
    if now != worksite.task:
        worksite.task = now
        log.add("task", "info", f"MODE {now}: {TASKS[now]}")


def task_of(site: Site, worksite: WorksiteState) -> int:
    """Return the task phase of the present state.

    ACQUISITION: no payload of the worksite is held. DOCKED: a held payload is fixed to a port. EXTRACTION: a held
    payload has a vertex inside the bay. MANOEUVRING: a held payload is elsewhere.
    """
    held = worksite.held
    if held is None:
        return ACQUISITION
    berth = worksite.payloads[held].berth
    if berth and site.berth(berth).docks:
        return DOCKED
    return EXTRACTION if in_bay(site, worksite.watch.place, held) else MANOEUVRING


def in_bay(site: Site, place: Placing, k: int) -> bool:
    """Return whether a vertex of a payload is inside the bay: below its top, between its walls. False without a bay."""
    if site.bay is None:
        return False
    return any_inside(place(site.bodies[k]), site.bodies[k], site.scene, site.bay[0], site.bay[1])
