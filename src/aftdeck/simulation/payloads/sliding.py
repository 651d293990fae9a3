"""Which payload slides along walls (Remote Manipulator Simulation, final report, section VII.4)."""

from __future__ import annotations

from aftdeck.simulation.constants.flight import Flight
from aftdeck.steering.mode import MODES


def sliding_payload(flight: Flight, held: int | None, mode: str) -> int | None:
    """Return the payload that slides along walls, if contacts inhibit motion: the held one in modes 1 to 7, else None.

    If contacts do not inhibit motion, the forces of a contact keep the payload out of the walls.
    """
    return held if flight.inhibits and MODES[mode].kind in ("automatic", "manual") else None
