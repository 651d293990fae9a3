"""LATRAJ, VCLOSE and VTOPEN: direction and speed of the motion to a target."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array
from aftdeck.jsc12628.limits import Vtopen
from aftdeck.jsc12628.quantities import Units, array, limited_rules, metres, not_negative, positive, rotation, tip_of
from aftdeck.steering import aim, profiles
from aftdeck.steering.layout import DT as PERIOD


class Latraj(NamedTuple):
    """Distance, angle and directions to a target.

    Attributes:
        delta_V: distance to the target.
        U_V: (3,) line of sight, a unit vector; zero at the target.
        delta_omega: angle of the rotation to the target [rad], 0 to pi.
        U_omega: (3,) angle of sight: the axis of that rotation, a unit vector; zero if the angle is zero.
    """

    delta_V: float
    U_V: Array
    delta_omega: float
    U_omega: Array


class Vclose(NamedTuple):
    """Command of mode 2 in one step.

    Attributes:
        V_C: speed along U_V.
        omega_C: angular rate about U_omega [rad/s].
        ETA: estimated phase time at the end of the phase [s].
    """

    V_C: float
    omega_C: float
    ETA: float


def latraj(r_6B: ArrayLike, T_B7: ArrayLike, r_6BF: ArrayLike, T_B7F: ArrayLike, units: Units = "m") -> Latraj:
    """Return line of sight and angle of sight to a target (JSC-12628, subroutine LATRAJ, p. 11).

    The source computes the angle by an arc cosine. This function uses an arc tangent, which is more accurate.

    Args:
        r_6B: (3,) tip position.
        T_B7: (3, 3) the end effector's frame.
        r_6BF: (3,) the tip's final position.
        T_B7F: (3, 3) the tip's final orientation.
        units: unit of all lengths in arguments and results.

    Raises:
        InputError: an argument is wrong; `T_B7` or `T_B7F` is not a rotation.
    """
    length = metres(units)
    tip = tip_of(array(r_6B, (3,), "r_6B") * length, rotation(T_B7, "T_B7"))
    target = np.concatenate([array(r_6BF, (3,), "r_6BF") * length, rotation(T_B7F, "T_B7F").ravel()])
    sight = aim.latraj(tip, target)
    return Latraj(
        sight.distance / length,
        np.array([sight.ux, sight.uy, sight.uz]),
        sight.angle,
        np.array([sight.ax, sight.ay, sight.az]),
    )


def vclose(
    delta_V: float, delta_omega: float, *, V_L: float, omega_L: float, V_L_dot: float, omega_L_dot: float,
    DT: float, TP: float = 0.0, units: Units = "m",
) -> Vclose:  # fmt: skip
    """Return the closed-loop rates towards a target, as published (JSC-12628, subroutine VCLOSE, p. 30).

    `DT` replaces the source's small time epsilon.

    Args:
        delta_V: remaining distance, at least 0.
        delta_omega: remaining angle [rad], at least 0.
        V_L: greatest speed.
        omega_L: greatest angular rate [rad/s].
        V_L_dot: greatest acceleration.
        omega_L_dot: greatest angular acceleration [rad/s2].
        DT: control period [s]; if the remaining time is shorter, speed and angular rate are zero.
        TP: time since the start of the phase [s].
        units: unit of all lengths in arguments and results.

    Raises:
        InputError: an argument is wrong; the message names it.
    """
    length = metres(units)
    rules = limited_rules(V_L, omega_L, V_L_dot, omega_L_dot, length)
    rules[PERIOD] = positive(DT, "DT")
    distance, angle = _distance_and_angle(delta_V, delta_omega)
    profile = profiles.vclose(rules, distance * length, angle)
    return Vclose(profile.speed / length, profile.turn, not_negative(TP, "TP") + profile.remaining)


def vtopen(
    delta_V: float, delta_omega: float, *, V_L: float, omega_L: float, V_L_dot: float, omega_L_dot: float,
    units: Units = "m",
) -> Vtopen:  # fmt: skip
    """Return the open-loop profile to a target (JSC-12628, subroutine VTOPEN, p. 36).

    Arguments and errors are as for `vclose`.
    """
    length = metres(units)
    distance, angle = _distance_and_angle(delta_V, delta_omega)
    rules = limited_rules(V_L, omega_L, V_L_dot, omega_L_dot, length)
    profile = profiles.vtopen(rules, distance * length, angle)
    return Vtopen(
        profile.speed / length,
        profile.turn,
        profile.eta,
        profile.t_v1,
        profile.eta - profile.t_v1,
        profile.t_w1,
        profile.eta - profile.t_w1,
    )


def _distance_and_angle(delta_V: float, delta_omega: float) -> tuple[float, float]:
    """Return distance and angle as floats, which are at least zero."""
    return not_negative(delta_V, "delta_V"), not_negative(delta_omega, "delta_omega")
