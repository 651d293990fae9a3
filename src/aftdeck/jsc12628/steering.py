"""OPERIN and MSTEER: start of a phase in one of the eight modes, and one steering step of a phase."""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array
from aftdeck.elementary import sincos
from aftdeck.errors import InputError
from aftdeck.frames import Pose, endori
from aftdeck.jsc12628.linkage import rmangs
from aftdeck.jsc12628.quantities import (
    Units,
    array,
    limited_rules,
    metres,
    not_negative,
    positive,
    published_links,
    rotation,
)
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.linkage import LINKS
from aftdeck.steering import msteer as laws
from aftdeck.steering.course import start_motion
from aftdeck.steering.layout import (
    AIMS,
    ANGLES,
    ARRIVED,
    COMMAND,
    DRIVE,
    HAND_COSINE,
    HAND_SINE,
    HELD,
    HIGH,
    JOINT,
    KEPT,
    LAW,
    LOW,
    MEASURED,
    MOUNT,
    PLAN,
    PLANNED_END,
    RATE,
    RATE_UP,
    RATES,
    RATIO,
    REMAINING,
    REPORT,
    SPEED,
    SPEED_UP,
    STATE,
    STICKS,
    TARGET,
    TURN,
    TWIST,
)
from aftdeck.steering.layout import DT as PERIOD
from aftdeck.tuples import UNTURNED

_NO_STOP = 1e6
"""Angle of the stops [rad]. The report's joints have no stops, so this angle is too large for any joint to reach."""
_ZERO = (0.0, 0.0, 0.0)
_SAME_TIME = 1e-9
"""Greatest difference of two phase times that count as equal [s]."""
AUTOMATIC = (1, 2, 3)
"""Automatic modes, which compute ETA."""
CLOSED_LOOP = 2
"""Automatic mode that estimates ETA again in each step."""


class Phase:
    """Phase in progress: its limits, its command, and the arm's state after the last step.

    Attributes:
        arm: the arm that the phase moves.
        mode: the report's mode, 1 to 8.
        units: unit of all lengths in arguments and results.
        TP: time since the start of the phase [s].
        ETA: phase time at the end of the phase [s]. It is planned in modes 1 and 3, estimated again in each step of
            mode 2 (infinite before the first one), and given in modes 4 to 8.
    """

    def __init__(
        self, arm: Arm, mode: int, units: Units, rules: Array, command: Array, state: Array, ETA: float
    ) -> None:
        self.arm, self.mode, self.units, self.TP, self.ETA = arm, mode, units, 0.0, ETA
        self._rules, self._command, self._state = rules, command, state

    def _step(self, theta: Array, theta_dot: Array | None) -> Array:
        """Run one step of the steering laws, and return the `report` array (`aftdeck.steering.layout`)."""
        state, report = self._state, np.zeros(REPORT)
        state[ANGLES : ANGLES + 6] = state[AIMS : AIMS + 6] = theta
        state[MEASURED : MEASURED + 6] = state[RATES : RATES + 6] if theta_dot is None else theta_dot
        laws.msteer(self._rules, self._command, state, report)
        self.TP = round(self.TP / self._rules[PERIOD] + 1.0) * float(self._rules[PERIOD])
        return report


class Msteer(NamedTuple):
    """Result of one steering step.

    Attributes:
        theta_dot_C: (6,) commanded joint rates [rad/s].
        omega_C: (3,) the tip's commanded angular velocity [rad/s].
        V_C: (3,) the tip's commanded velocity.
        RATIO: factor by which RATLMT multiplied all joint rates, at most 1.
        ETA: phase time at the end of the phase [s]: computed in the automatic modes (1, 2 and 3), and the one that was
            given in the others.
        done: whether the phase has ended: no joint rates are needed any more.
    """

    theta_dot_C: Array
    omega_C: Array
    V_C: Array
    RATIO: float
    ETA: float
    done: bool


def operin(
    arm: Arm, mode: Literal[1, 2, 3, 4, 5, 6, 7, 8], theta_0: ArrayLike, *, V_L: float, omega_L: float,
    V_L_dot: float, omega_L_dot: float, theta_dot_L: ArrayLike, DT: float, theta_F: ArrayLike | None = None,
    r_6BF: ArrayLike | None = None, T_B7F: ArrayLike | None = None, xi_F: ArrayLike | None = None,
    omega_C: ArrayLike = _ZERO, V_C: ArrayLike = _ZERO, T_78: ArrayLike = UNTURNED, joint: int = 0,
    theta_dot_C: float = 0.0, ETA: float | None = None, units: Units = "m",
) -> Phase:  # fmt: skip
    """Begin a phase (JSC-12628, subroutine OPERIN, p. 19).

    Args:
        arm: as for `lnkage`.
        mode: 1 automatic position, 2 closed loop, 3 open loop, 4 orbiter, 5 end effector, 6 payload, 7 mixed, 8 single
            joint.
        theta_0: (6,) joint angles [rad].
        V_L: greatest speed of the tip.
        omega_L: greatest angular rate of the tip [rad/s].
        V_L_dot: greatest acceleration of the tip.
        omega_L_dot: greatest angular acceleration of the tip [rad/s2].
        theta_dot_L: (6,) greatest joint rates [rad/s].
        DT: control period [s].
        theta_F: (6,) final joint angles [rad], for mode 1; None to compute them by RMANGS from the final pose. RMANGS
            returns angles within +-180 deg, so a joint may take the long way to them.
        r_6BF: (3,) the tip's final position, for modes 1, 2 and 3.
        T_B7F: (3, 3) the tip's final orientation, for modes 1, 2 and 3.
        xi_F: (3,) Euler angles in place of `T_B7F` [rad]: roll, elevation and azimuth, the arguments of ENDORI. The
            report's flag S_I is 1 if they are given.
        omega_C: (3,) the report's omega_C', the angular velocity that the operator commands in the mode's frame
            [rad/s], for modes 4 to 7.
        V_C: (3,) the report's V_C', the velocity that the operator commands in the mode's frame, for modes 4 to 7.
        T_78: (3, 3) the payload's axes in frame 7, for modes 6 and 7.
        joint: index of the joint that moves, 0 to 5, for mode 8.
        theta_dot_C: the report's theta_dot_C', the rate of that joint [rad/s], for mode 8.
        ETA: phase time at which the phase ends [s], for modes 4 to 8; None for a phase without an end. The automatic
            modes compute it.
        units: unit of all lengths given here, and of all lengths that `msteer` returns.

    Raises:
        InputError: an argument is wrong, an argument that the mode needs is missing, or one is given twice. The message
            names the argument.
        SingularityError: RMANGS raises it; see `rmangs`.
        UnreachableError: RMANGS raises it; see `rmangs`.
    """
    if mode not in range(1, 9):
        raise InputError(f"mode: got {mode!r}, expected 1 to 8")
    length, command, state = metres(units), np.zeros(COMMAND), np.zeros(STATE)
    rules = limited_rules(V_L, omega_L, V_L_dot, omega_L_dot, length)
    rules[:LINKS] = published_links(arm)
    rules[PERIOD] = positive(DT, "DT")
    rules[RATE : RATE + 6] = [positive(rate, "theta_dot_L") for rate in array(theta_dot_L, (6,), "theta_dot_L")]
    rules[RATE_UP : RATE_UP + 6] = rules[RATE : RATE + 6] * (rules[SPEED_UP] / rules[SPEED])
    rules[LOW : LOW + 6], rules[HIGH : HIGH + 6] = -_NO_STOP, _NO_STOP
    rules[MOUNT : MOUNT + 9] = arm.model.mount.rotation.T.ravel()
    rules[HAND_SINE], rules[HAND_COSINE] = sincos(arm.model.end_effector_roll)
    rules[HELD : HELD + 9] = rotation(T_78, "T_78").ravel()
    command[LAW] = mode
    state[ANGLES : ANGLES + 6] = command[KEPT : KEPT + 6] = array(theta_0, (6,), "theta_0")
    _reject_unused(mode, theta_F=theta_F, r_6BF=r_6BF, T_B7F=T_B7F, xi_F=xi_F)
    if mode == 1:
        command[PLAN : PLAN + 6] = _final_angles(arm, theta_F, r_6BF, T_B7F, xi_F, units)
    elif mode in (2, 3):
        final = arm.model.mount.from_("orbiter", _final_pose(mode, r_6BF, T_B7F, xi_F, length))
        command[TARGET : TARGET + 12] = [*final.position, *final.rotation.ravel()]
    command[STICKS : STICKS + 3] = array(omega_C, (3,), "omega_C") / rules[TURN]
    command[STICKS + 3 : STICKS + 6] = array(V_C, (3,), "V_C") * length / rules[SPEED]
    if joint not in range(6):
        raise InputError(f"joint: got {joint!r}, expected 0 to 5")
    command[JOINT] = joint
    command[DRIVE] = float(array(theta_dot_C, (), "theta_dot_C")) / rules[RATE + joint]
    if mode in AUTOMATIC:
        if ETA is not None:
            raise InputError(f"ETA: got {ETA!r}, expected None; mode {mode} computes it")
        start_motion(rules, command, state)
        end = math.inf if mode == CLOSED_LOOP else float(command[PLANNED_END])
    else:
        end = math.inf if ETA is None else not_negative(ETA, "ETA")
    return Phase(arm, mode, units, rules, command, state, end)


def msteer(phase: Phase, theta: ArrayLike, theta_dot: ArrayLike | None = None) -> Msteer:
    """Run one steering step of a phase (JSC-12628, subroutine MSTEER, p. 16), and advance its phase time by DT.

    In modes 4 to 8, the phase ends at the first step whose phase time has reached the given ETA.

    Args:
        phase: result of `operin`, changed in place.
        theta: (6,) actual joint angles [rad].
        theta_dot: (6,) actual joint rates [rad/s]; None to use the rates that the last step commanded.

    Raises:
        InputError: `theta` or `theta_dot` is wrong.
    """
    rates = None if theta_dot is None else array(theta_dot, (6,), "theta_dot")
    before = phase.TP
    report = phase._step(array(theta, (6,), "theta"), rates)
    state, to_b = phase._state, phase.arm.model.mount.rotation
    if phase.mode == CLOSED_LOOP:
        phase.ETA = before + float(report[REMAINING])
    return Msteer(
        state[RATES : RATES + 6].copy(),
        to_b @ state[TWIST : TWIST + 3],
        to_b @ state[TWIST + 3 : TWIST + 6] / metres(phase.units),
        float(report[RATIO]),
        phase.ETA,
        bool(report[ARRIVED]) if phase.mode in AUTOMATIC else before >= phase.ETA - _SAME_TIME,
    )


def _reject_unused(mode: int, theta_F: ArrayLike | None, **pose: ArrayLike | None) -> None:
    """Reject a final position that the mode does not use.

    Raises:
        InputError: the mode has no final joint angles, or no final pose.
    """
    given = {} if mode == 1 else {"theta_F": theta_F}
    given |= {} if mode in AUTOMATIC else pose
    for name, value in given.items():
        if value is not None:
            raise InputError(f"{name}: got {value!r}, expected None; mode {mode} does not use it")


def _final_pose(
    mode: int, r_6BF: ArrayLike | None, T_B7F: ArrayLike | None, xi_F: ArrayLike | None, length: float
) -> Pose:
    """Return the final pose in B [m], whose orientation is a rotation or Euler angles (the report's S_I)."""
    position = array(_needed(r_6BF, "r_6BF", mode), (3,), "r_6BF") * length
    if xi_F is None:
        return Pose(position, rotation(_needed(T_B7F, "T_B7F", mode), "T_B7F"))
    if T_B7F is not None:
        raise InputError("xi_F: got Euler angles and T_B7F, expected one of them")
    return Pose(position, endori(*array(xi_F, (3,), "xi_F").tolist()))


def _final_angles(
    arm: Arm,
    theta_F: ArrayLike | None,
    r_6BF: ArrayLike | None,
    T_B7F: ArrayLike | None,
    xi_F: ArrayLike | None,
    units: Units,
) -> Array:
    """Return the final joint angles of mode 1 [rad]: the given ones, or those of RMANGS for a final pose."""
    posed = [name for name, value in (("r_6BF", r_6BF), ("T_B7F", T_B7F), ("xi_F", xi_F)) if value is not None]
    if theta_F is not None:
        if posed:
            raise InputError(f"theta_F: got joint angles and {' and '.join(posed)}, expected angles or a pose")
        return array(theta_F, (6,), "theta_F")
    if not posed:
        raise InputError("theta_F: got None; mode 1 needs it, or r_6BF with T_B7F or xi_F")
    pose = _final_pose(1, r_6BF, T_B7F, xi_F, metres(units))
    return rmangs(arm, pose.position, pose.rotation)


def _needed(value: ArrayLike | None, name: str, mode: int) -> ArrayLike:
    """Return an argument that a mode needs.

    Raises:
        InputError: the argument is None.
    """
    if value is None:
        raise InputError(f"{name}: got None; mode {mode} needs a value")
    return value
