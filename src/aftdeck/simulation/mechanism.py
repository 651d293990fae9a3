"""What a mechanism may do to a payload while the arm is inhibited: carriage and latches wait before a contact."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.simulation.flight import Flight
from aftdeck.simulation.state import State
from aftdeck.worksite.restrain import deepened

Array = NDArray[np.float64]


def would_deepen(flight: Flight, state: State, k: int, pose: Array) -> bool:
    """Whether an inhibited arm's contacts would be deepened by putting cargo k to a pose (12,) in L.

    Args:
        flight: what never changes.
        state: after its look.
        k: which cargo, held.
        pose: where the mechanism draws it.
    """
    things = state.site
    if not things.contacts.inhibit.arm:
        return False
    after = things.frames.copy()
    after[flight.site.cargo_row(k)] = pose
    return deepened(things.watch, things.contacts.arm & (1 - things.contacts.essential), things.frames, after) >= 0
