"""The report's modes: 1 acquisition, 2 extraction, 3 manoeuvring, 4 docked; they change by themselves."""

from __future__ import annotations

import numpy as np

from aftdeck.bodies.hexahedron import VERTICES, X
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.log import log
from aftdeck.simulation.state import State

ACQUISITION, EXTRACTION, MANOEUVRING, DOCKED = 1, 2, 3, 4
TASKS = {ACQUISITION: "acquisition", EXTRACTION: "extraction", MANOEUVRING: "manoeuvring", DOCKED: "docked"}


def change_task(flight: Flight, state: State) -> None:
    """Which of the report's modes it is now."""
    things = state.site
    now = _task(flight, state)
    if now != things.task:
        things.task = now
        log(flight, state, "task", "info", f"MODE {now}: {TASKS[now]}")


def _task(flight: Flight, state: State) -> int:
    """Nothing held; held at a port; held with a part of it in the bay; held above it."""
    site, things = flight.site, state.site
    held = things.held
    if held is None:
        return ACQUISITION
    seat = things.cargo[held].seat
    if seat and site.seat(seat).kind == "port":
        return DOCKED
    return EXTRACTION if in_bay(flight, state, held) else MANOEUVRING


def in_bay(flight: Flight, state: State, k: int) -> bool:
    """Whether a vertex of a cargo is below the bay's top and between its walls."""
    site, bay = flight.site, flight.site.worksite.bay
    if bay is None:
        return False
    mine = site.layout.frame == site.cargo_row(k)
    points = state.site.watch.placed[mine, X : X + 3 * VERTICES].reshape(-1, 3, VERTICES).transpose(0, 2, 1)
    scene = site.scene
    local = (points.reshape(-1, 3) - scene[:3]) @ scene[3:].reshape(3, 3)
    low, high = np.array(bay.low), np.array(bay.high)
    inside = (local[:, :2] > low[:2]).all(axis=1) & (local[:, :2] < high[:2]).all(axis=1)
    return bool((inside & (local[:, 2] < high[2])).any())
