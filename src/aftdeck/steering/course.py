"""OPERIN's start of an automatic motion, in a run and in the rehearsal of CMD CK.

JSC-12628, subroutine OPERIN, plans from the arm's present pose as if the arm were at rest; `strict` does the same.
Without `strict`, the arm first comes to rest, and the motion is planned from the pose at rest.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.steering.layout import JOINTS, LAW, MEASURED, MOTION_ACTIVE, STRICT
from aftdeck.steering.modes import open_loop, position

AT_REST = 1e-6
"""Joint rate up to which a joint counts as at rest [rad/s]; at this rate the tip moves less than 0.01 mm in 0.2 s
(assumed)."""


@law
def may_start(rules: Array, state: Array) -> bool:
    """Return whether an automatic motion may start: under `strict` always, otherwise only if all joints are at rest."""
    fastest = 0.0
    for i in range(int(rules[JOINTS])):
        fastest = max(fastest, abs(state[MEASURED + i]))
    return bool(rules[STRICT] != 0.0 or fastest <= AT_REST)


@law
def start_motion(rules: Array, command: Array, state: Array) -> None:
    """Plan and start the motion if it may start. Call this function before each step until MOTION_ACTIVE is 1.

    `command` holds the law's number and the target. In mode 1 it also holds the final joint angles, from index PLAN on;
    the plan replaces these angles.
    """
    if not may_start(rules, state):
        return
    if command[LAW] == 1.0:
        position.plan(rules, command, state)
    elif command[LAW] == 3.0:
        open_loop.plan(rules, command, state)
    command[MOTION_ACTIVE] = 1.0
