"""A rule that flies Capture-v0 from its own observations: the teacher of `clone_capture.py`."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

GAIN = 4.0
"""Deflection for each metre across the end effector's axis, at vernier rates."""
TURN_GAIN = 8.0
"""Deflection for each radian."""
AHEAD_GAIN = 4.0
"""Deflection for each metre along the axis."""
CONE = 4.0
"""The end effector comes closer while its distance is more than this many times the error across its axis..."""
SLACK = 0.01
"""... or the error is less than this [m]."""
ALL, CLOSED = 0.99, 0.05
"""Share of conditions above which all hold; opening of the snares below which they are closed."""


def action(observation: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return an action of Capture-v0: line up, come closer, and close the snares when all conditions hold.

    Args:
        observation: (30,) as in docs/environments.md: distance to go ahead and across, rotation to go, ..., share of
            conditions that hold (26), switch of the end effector (28), opening of the snares (29).
    """
    ahead, across, turn = observation[0], observation[1:3], observation[3:6]
    error = float(np.hypot(*across)) + 0.5 * float(np.linalg.norm(turn))
    may_come_closer = error < SLACK or ahead > CONE * error
    closing = observation[26] > ALL or (observation[28] > 0.0 and observation[29] > CLOSED)
    wanted = np.zeros(8)
    wanted[0] = AHEAD_GAIN * ahead if may_come_closer or ahead < 0.0 else 0.0
    wanted[1:3], wanted[3:6] = GAIN * across, TURN_GAIN * turn
    wanted[6] = -1.0  # vernier
    if closing:
        wanted[:6] = 0.0
    wanted[7] = 1.0 if closing else -1.0
    return np.clip(wanted, -1.0, 1.0).astype(np.float32)
