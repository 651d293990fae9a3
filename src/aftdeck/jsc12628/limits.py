"""VOTRAN, AVCLMT and RATLMT: conversion of a mode's commands to frame B, reduction of velocities and joint rates."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.jsc12628.quantities import (
    Units,
    array,
    limited_rules,
    metres,
    not_negative,
    positive,
    rotation,
    strict_rules,
    tip_of,
)
from aftdeck.kinematics.jacobian import Twist
from aftdeck.steering import limiters
from aftdeck.steering.layout import DT as PERIOD
from aftdeck.steering.layout import HELD, RATE, RATES, STATE
from aftdeck.steering.modes import open_loop
from aftdeck.steering.turn import from_hand, from_payload
from aftdeck.tuples import UNTURNED

_NONE = np.zeros(3)


class Wanted(NamedTuple):
    """Commanded velocities of the tip.

    Attributes:
        omega_C: (3,) angular velocity [rad/s].
        V_C: (3,) velocity.
    """

    omega_C: Array
    V_C: Array


class Vtopen(NamedTuple):
    """Open-loop profile of mode 3.

    Attributes:
        R_V: greatest speed of the motion.
        R_omega: greatest angular rate of the motion [rad/s].
        ETA: end of the phase [s].
        t_v1: end of the translation's acceleration [s].
        t_v2: beginning of the translation's deceleration [s].
        t_w1: end of the rotation's acceleration [s].
        t_w2: beginning of the rotation's deceleration [s].
    """

    R_V: float
    R_omega: float
    ETA: float
    t_v1: float
    t_v2: float
    t_w1: float
    t_w2: float


class Ratlmt(NamedTuple):
    """Result of RATLMT: joint rates within their limits.

    Attributes:
        RATIO: factor by which RATLMT multiplied all joint rates, at most 1.
        theta_dot_C: (6,) returned joint rates [rad/s].
    """

    RATIO: float
    theta_dot_C: Array


def votran(
    mode: Literal[2, 3, 4, 5, 6, 7], omega_C: ArrayLike, V_C: ArrayLike, *, T_B7: ArrayLike = UNTURNED,
    T_78: ArrayLike = UNTURNED, profile: Vtopen | None = None, TP: float = 0.0,
) -> Wanted:  # fmt: skip
    """Return a mode's commanded velocities in B (JSC-12628, subroutine VOTRAN, p. 33).

    Args:
        mode: the report's mode. The mode determines the frame of the two commands. Modes 2 and 4: frame B. Mode 5: the
            end effector's frame 7. Mode 6: the payload's frame 8. Mode 7: `omega_C` in frame 8, `V_C` in B. In mode 3
            the commands are R_omega U_omega and R_V U_V in B, and the profile's ramps scale them.
        omega_C: (3,) the report's omega_C', the mode's angular velocity [rad/s].
        V_C: (3,) the report's V_C', the mode's velocity, in any unit of length.
        T_B7: (3, 3) the end effector's frame, for modes 5 to 7.
        T_78: (3, 3) the payload's axes in frame 7, for modes 6 and 7.
        profile: result of VTOPEN, for mode 3.
        TP: time since the start of the phase [s], for mode 3.

    Raises:
        InputError: the mode is not 2 to 7, mode 3 has no profile, or another argument is wrong.
    """
    omega, v = array(omega_C, (3,), "omega_C"), array(V_C, (3,), "V_C")
    tip, rules = tip_of(_NONE, rotation(T_B7, "T_B7")), strict_rules()
    rules[HELD : HELD + 9] = rotation(T_78, "T_78").ravel()
    match mode:
        case 2 | 4:
            return Wanted(omega, v)
        case 3 if profile is not None:
            time = not_negative(TP, "TP")
            turn, go = (open_loop._share(time, profile.ETA, ramp) for ramp in (profile.t_w1, profile.t_v1))
            return Wanted(turn * omega, go * v)
        case 3:
            raise InputError("votran: mode 3 needs the profile of VTOPEN")
        case 5:
            return Wanted(np.array(from_hand(tip, *omega.tolist())), np.array(from_hand(tip, *v.tolist())))
        case 6:
            turned = (np.array(from_payload(rules, tip, *vector.tolist())) for vector in (omega, v))
            return Wanted(*turned)
        case 7:
            return Wanted(np.array(from_payload(rules, tip, *omega.tolist())), v)
    raise InputError(f"mode: got {mode!r}, expected 2 to 7; 1 and 8 command joints, not the tip")


def avclmt(
    omega_C: ArrayLike, V_C: ArrayLike, omega: ArrayLike, V: ArrayLike, *, V_L: float, omega_L: float,
    V_L_dot: float, omega_L_dot: float, DT: float, units: Units = "m",
) -> Wanted:  # fmt: skip
    """Return commanded velocities, reduced to the tip's limits (JSC-12628, subroutine AVCLMT, p. 6).

    The acceleration limits are applied first, the limits of speed and angular rate last.

    Args:
        omega_C: (3,) commanded angular velocity [rad/s].
        V_C: (3,) commanded velocity.
        omega: (3,) present angular velocity [rad/s].
        V: (3,) present velocity.
        V_L: greatest speed.
        omega_L: greatest angular rate [rad/s].
        V_L_dot: greatest acceleration.
        omega_L_dot: greatest angular acceleration [rad/s2].
        DT: control period [s].
        units: unit of all lengths in arguments and results.
    """
    length = metres(units)
    rules = limited_rules(V_L, omega_L, V_L_dot, omega_L_dot, length)
    rules[PERIOD] = positive(DT, "DT")
    wanted = Twist(*array(omega_C, (3,), "omega_C").tolist(), *(array(V_C, (3,), "V_C") * length).tolist())
    present = Twist(*array(omega, (3,), "omega").tolist(), *(array(V, (3,), "V") * length).tolist())
    allowed = np.array(limiters.avclmt(rules, wanted, present)[0])
    return Wanted(allowed[:3], allowed[3:] / length)


def ratlmt(theta_dot_C: ArrayLike, theta_dot_L: ArrayLike) -> Ratlmt:
    """Scale all joint rates by one ratio, so that each is within its limit (JSC-12628, subroutine RATLMT, p. 24).

    The simulation's RATLMT also limits the approach to stops and singularities; this function ignores them.

    Args:
        theta_dot_C: (6,) commanded joint rates [rad/s].
        theta_dot_L: (6,) greatest joint rates [rad/s].
    """
    rates, most = array(theta_dot_C, (6,), "theta_dot_C"), array(theta_dot_L, (6,), "theta_dot_L")
    if (most <= 0.0).any():
        raise InputError(f"theta_dot_L: got {most}, expected numbers above 0")
    rules, state = strict_rules(), np.zeros(STATE)
    rules[RATE : RATE + 6], state[RATES : RATES + 6] = most, rates
    ratio = 1.0 / max(limiters.rate_ratio(rules, state), 1.0)
    return Ratlmt(ratio, ratio * rates)
