"""Arguments of the report's subroutines: units of length, and arrays of a given shape."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.kinematics import solutions
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.linkage import Tip
from aftdeck.matrices import product, reflects
from aftdeck.steering.layout import JOINTS, MOST_UP, RULES, SPEED, SPEED_UP, STRICT, TURN, TURN_UP
from aftdeck.tuples import MOST_JOINTS, UNTURNED
from aftdeck.units import FOOT

Units = Literal["m", "ft"]
"""Unit of every length in a call: metres or feet."""

_METRES: dict[Units, float] = {"m": 1.0, "ft": FOOT}


def metres(units: Units) -> float:
    """Return the size of the unit of length [m].

    Raises:
        InputError: the unit is neither 'm' nor 'ft'.
    """
    if units not in _METRES:
        raise InputError(f"units: got {units!r}, expected 'm' or 'ft'")
    return _METRES[units]


def array(values: ArrayLike, shape: tuple[int, ...], name: str) -> Array:
    """Return an argument as a float64 array, after a check that it consists of finite numbers in the given shape.

    Raises:
        InputError: the check fails; the message names the argument.
    """
    try:
        given = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"{name}: got {values!r}, expected numbers") from None
    if given.shape != shape:
        raise InputError(f"{name}: got shape {given.shape}, expected {shape}")
    if not np.isfinite(given).all():
        raise InputError(f"{name}: got {given}, expected finite numbers")
    return given


def positive(value: float, name: str) -> float:
    """Return an argument as a float, after a check that it is a finite number above zero.

    Raises:
        InputError: the check fails; the message names the argument.
    """
    number = float(array(value, (), name))
    if number <= 0.0:
        raise InputError(f"{name}: got {number:g}, expected a number above 0")
    return number


def not_negative(value: float, name: str) -> float:
    """Return an argument as a float, after a check that it is a finite number of at least zero.

    Raises:
        InputError: the check fails; the message names the argument.
    """
    number = float(array(value, (), name))
    if number < 0.0:
        raise InputError(f"{name}: got {number:g}, expected a number of at least 0")
    return number


def rotation(values: ArrayLike, name: str) -> Array:
    """Return an argument as a (3, 3) array, after a check that it is a rotation.

    Raises:
        InputError: the check fails; the message names the argument.
    """
    given = array(values, (3, 3), name)
    off = float(np.abs(product(given, given.T) - UNTURNED).max())
    if off > solutions.ROTATION_TOLERANCE:
        raise InputError(f"{name}: {solutions.skew_text(off)}")
    if reflects(given):
        raise InputError(f"{name}: {solutions.MIRRORED_TEXT}")
    return given


def published_links(arm: Arm) -> Array:
    """Return the links (8,) of an arm for which the report's subroutines are written.

    Raises:
        InputError: the arm has another chain of joints.
    """
    if not arm.closed_form:
        raise InputError(
            f"{arm.name}: the subroutines of JSC-12628 are written for six joints with one of two wrists, "
            "pitch-yaw-roll or heading-pitch-roll; this arm has another chain"
        )
    return arm.model.links


def strict_rules() -> Array:
    """Return an array `rules` for the steering laws, with only STRICT set, so that the laws run as published."""
    rules = np.zeros(RULES)
    rules[STRICT], rules[JOINTS] = 1.0, 6
    rules[MOST_UP : MOST_UP + MOST_JOINTS] = np.inf
    return rules


def limited_rules(V_L: float, omega_L: float, V_L_dot: float, omega_L_dot: float, length: float) -> Array:
    """Return `strict_rules` with the limits of the tip's motion; `length` is the size of the unit of length [m]."""
    rules = strict_rules()
    rules[SPEED], rules[TURN] = positive(V_L, "V_L") * length, positive(omega_L, "omega_L")
    rules[SPEED_UP], rules[TURN_UP] = positive(V_L_dot, "V_L_dot") * length, positive(omega_L_dot, "omega_L_dot")
    return rules


def tip_of(position: Array, rotation: Array) -> Tip:
    """Return a pose as a `Tip`, the form in which the laws take it: position [m], then the rotation row by row."""
    return Tip(*position.tolist(), *rotation.ravel().tolist())
