"""Values of the arrays of `steering.layout`, as named tuples, for use inside the laws.

Compiled code makes these tuples without cost. To pass such a tuple from Python to a law would take microseconds.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates, Twist
from aftdeck.kinematics.linkage import Sines, sines
from aftdeck.law import law
from aftdeck.steering.layout import ANGLES, SPEED, STICKS, TURN


@law
def rates_at(values: Array, at: int) -> Rates:
    """Return the values of the six joints that begin at index `at` of an array."""
    return Rates(values[at], values[at + 1], values[at + 2], values[at + 3], values[at + 4], values[at + 5])


@law
def put_rates(values: Array, at: int, r: Rates) -> None:
    """Write the values of the six joints into an array, from index `at` on."""
    values[at], values[at + 1], values[at + 2] = r.r1, r.r2, r.r3
    values[at + 3], values[at + 4], values[at + 5] = r.r4, r.r5, r.r6


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
def sines_of(rules: Array, state: Array) -> Sines:
    """Return the sines and cosines of the measured joint angles."""
    q = rates_at(state, ANGLES)
    return sines(rules, q.r1, q.r2, q.r3, q.r4, q.r5, q.r6)
