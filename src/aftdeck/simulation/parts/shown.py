"""Values of panel, end effector and berths that compiled code needs to observe a task, and that are not in the row.

They change only in steps that Python code completes, but for `COARSE` and `SWITCH`: in a batch, its caller sets these
two. An array has them in this order, then a mark for each berth.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from aftdeck.arrays import Array
from aftdeck.simulation.parts.worksite_state import DRIVES
from aftdeck.simulation.row.scalars import PRONG_AT
from aftdeck.steering.mode import MODES, ORB_LD_TURNING

if TYPE_CHECKING:
    from aftdeck.simulation.constants.flight import Flight
    from aftdeck.simulation.state import State

AXES = 0
"""Axes of the sticks: one of the four that follow."""
ORBITER, EFFECTOR, PAYLOAD, MIXED = range(4)
"""Those of the orbiter, of the end effector, of the payload in the grasp; or the THC's of the orbiter, the RHC's of the
payload."""
LOADED = 1
"""1 if the sticks move the payload's point of resolution, 0 if they move the tip."""
COARSE = 2
"""Rate setting: 1 coarse, -1 vernier."""
SWITCH = 3
"""End effector switch: 1 close, 0 stop, -1 open."""
HELD = 4
"""Index of the worksite's payload in the grasp; -1 for none."""
FIXED = 5
"""1 if a berth fixes this payload."""
RELEASED = 6
"""Number of the berth that has just released this payload, numbered as in `World.berths`; -1 for none."""
ATTACHED = 7
"""1 if the scenario's own payload is attached to the end effector."""
LOGGED = 8
"""1 if a contact is in the log that has not ended: one of two parts that are still monitored."""
PACKED = 9
"""`HeldPayload.packed` of the attached payload (15)."""
TAKEN = 24
"""First of the marks of all berths: 1 if another payload is fixed there."""


def shown_of(flight: Flight, state: State) -> Array:
    """Return the values after a step."""
    panel, worksite, mode = state.panel, state.worksite, MODES[state.panel.mode]
    held, own = worksite.held, state.carried.payload if state.script.attached else None
    loaded, axes = held is not None or own is not None, ORBITER
    if mode.axes == "end effector axes":
        axes = EFFECTOR
    elif loaded and (mode.axes == "payload axes" or panel.flown == ORB_LD_TURNING):
        axes = PAYLOAD if mode.axes == "payload axes" else MIXED
    fits = flight.site.numbered
    shown = np.zeros(TAKEN + len(fits))
    shown[:PACKED] = (
        axes,
        loaded and mode.loaded and not flight.scenario.strict,
        1.0 if panel.rate == "coarse" else -1.0,
        DRIVES[worksite.switch],
        -1 if held is None else held,
        worksite.arm_fixed,
        -1 if held is None else flight.site.number(held, worksite.payloads[held].released_from),
        own is not None,
        bool(worksite.logged_contacts),
    )
    if own is not None:
        shown[PACKED:TAKEN] = own.packed
    seats = [payload.berth for payload in worksite.payloads]
    if any(seats):
        shown[TAKEN:] = [any(seat == name for i, seat in enumerate(seats) if i != k) for k, name in fits]
    return shown


def write_effector(state: State) -> None:
    """Write prong and snares as they are after a step that Python code has completed into the state's row."""
    state.row.scalars[PRONG_AT] = state.worksite.prong.position
    state.row.snare[:] = state.worksite.snare.packed
