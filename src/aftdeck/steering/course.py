"""OPERIN's start of an automatic motion: from rest in modes 1 and 3, whose plans begin there; in mode 2 at once.

JSC-12628, subroutine OPERIN, plans from wherever the arm is, as if it stood; `strict` leaves it so. Mended, modes 1
and 3 first bring the arm to rest by their own ramps, and plan from there.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.law import law
from aftdeck.steering.layout import GO, LAW, RATES, STRICT
from aftdeck.steering.modes import open_loop, position

Array = NDArray[np.float64]

AT_REST = 1e-9
"""Joint rate under which a joint stands [rad/s]: a rounding error's worth."""


@law
def may_start(rules: Array, command: Array, state: Array) -> bool:
    """Whether the law may start from how the arm moves: modes 1 and 3 wait until no joint is commanded to move."""
    fastest = 0.0
    for i in range(6):
        fastest = max(fastest, abs(state[RATES + i]))
    return bool(command[LAW] == 2.0 or rules[STRICT] != 0.0 or fastest <= AT_REST)


@law
def set_off(rules: Array, command: Array, state: Array) -> None:
    """Plan and go, if the arm may start; called before each step until `command` says GO.

    `command` holds the law's number, the target and, in mode 1, the final joint angles where its plan will stand.
    """
    if not may_start(rules, command, state):
        return
    if command[LAW] == 1.0:
        position.plan(rules, command, state)
    elif command[LAW] == 3.0:
        open_loop.plan(rules, command, state)
    command[GO] = 1.0
