"""OPERIN's start of an automatic motion from rest, as in the rehearsal of CMD CK.

JSC-12628, subroutine OPERIN, plans from the arm's present pose as if the arm were at rest; `strict` does the same.
Corrected, the arm first comes to rest, and the motion is planned from there.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.steering.layout import LAW, MEASURED, MOTION_ACTIVE, STRICT
from aftdeck.steering.modes import open_loop, position

AT_REST = 1e-6
"""Joint rate below which a joint is at rest [rad/s]: in 0.2 s the tip moves by less than 0.01 mm (assumed)."""


@law
def may_start(rules: Array, state: Array) -> bool:
    """Return whether an automatic motion may start: when no joint moves; under `strict` at once."""
    fastest = 0.0
    for i in range(6):
        fastest = max(fastest, abs(state[MEASURED + i]))
    return bool(rules[STRICT] != 0.0 or fastest <= AT_REST)


@law
def start_motion(rules: Array, command: Array, state: Array) -> None:
    """Plan and start the motion if the arm may start; call this before each step until MOTION_ACTIVE is 1.

    `command` holds the law's number and the target. In mode 1 it also holds the final joint angles, at the index of
    the plan that replaces them.
    """
    if not may_start(rules, state):
        return
    if command[LAW] == 1.0:
        position.plan(rules, command, state)
    elif command[LAW] == 3.0:
        open_loop.plan(rules, command, state)
    command[MOTION_ACTIVE] = 1.0
