"""Values of the arrays of `steering.layout`, as named tuples, for use inside the laws.

Compiled code makes these tuples without cost. To pass such a tuple from Python to a law would take microseconds.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates, Twist
from aftdeck.kinematics.solver import Posture, posture
from aftdeck.law import law
from aftdeck.steering.layout import ANGLES, SPEED, STICKS, TURN


@law
def rates_at(values: Array, at: int) -> Rates:
    """Return the values of the joints that begin at index `at` of an array."""
    return Rates(
        values[at], values[at + 1], values[at + 2], values[at + 3],
        values[at + 4], values[at + 5], values[at + 6], values[at + 7],
    )  # fmt: skip


@law
def put_rates(values: Array, at: int, r: Rates) -> None:
    """Write the values of the joints into an array, from index `at` on."""
    values[at], values[at + 1], values[at + 2], values[at + 3] = r.r1, r.r2, r.r3, r.r4
    values[at + 4], values[at + 5], values[at + 6], values[at + 7] = r.r5, r.r6, r.r7, r.r8


@law
def twist_at(values: Array, at: int) -> Twist:
    """Return the twist that begins at index `at` of an array."""
    return Twist(values[at], values[at + 1], values[at + 2], values[at + 3], values[at + 4], values[at + 5])


@law
def put_twist(values: Array, at: int, t: Twist) -> None:
    """Write a twist into an array, from index `at` on."""
    values[at], values[at + 1], values[at + 2] = t.wx, t.wy, t.wz
    values[at + 3], values[at + 4], values[at + 5] = t.vx, t.vy, t.vz


@law
def stick_twist(rules: Array, command: Array) -> Twist:
    """Return the twist that the sticks command, in the mode's axes; full deflection commands the POR limits."""
    w, v, s = rules[TURN], rules[SPEED], twist_at(command, STICKS)
    return Twist(w * s.wx, w * s.wy, w * s.wz, v * s.vx, v * s.vy, v * s.vz)


@law
def posture_now(rules: Array, state: Array) -> Posture:
    """Return the arm's posture at the measured joint angles."""
    return posture(rules, rates_at(state, ANGLES))
