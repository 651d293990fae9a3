"""What keeps the arm from moving at all, in words."""

from __future__ import annotations

from aftdeck.simulation.flight import Flight
from aftdeck.simulation.state import Panel, State


def standing(panel: Panel) -> str:
    """What keeps the joints from moving, whatever is commanded; empty: nothing does."""
    if panel.brakes:
        return "BRAKES are on"
    return "SAFING is on; CANCEL it first" if panel.safing else ""


def held_fast(flight: Flight, state: State) -> str:
    """What of the worksite has what the arm holds, so that the arm cannot move; empty: nothing has."""
    where = fixed_in(flight, state)
    return f"{where}: UNLATCH" if where else ""


def fixed_in(flight: Flight, state: State) -> str:
    """Which payload of the arm's is fixed in which seat, for people; empty: none is."""
    site, things = flight.site, state.site
    if things.held is None or not things.fast:
        return ""
    return f"{site.cargo[things.held].title} is fixed in the {site.seat(things.cargo[things.held].seat).title}"
