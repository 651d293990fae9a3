"""LNKAGE, JACOBI, ERATES, RMSRAT, RMANGS and RMSIST: the arm's geometry."""

from __future__ import annotations

from typing import Literal, NamedTuple, overload

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array
from aftdeck.errors import InputError, LimitError, UnreachableError
from aftdeck.frames import Pose
from aftdeck.jsc12628.quantities import Units, array, metres, published_links, rotation
from aftdeck.kinematics import inverse, jacobian
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.linkage import sines
from aftdeck.kinematics.observe import observe_link
from aftdeck.matrices import product
from aftdeck.tuples import UNTURNED


class Lnkage(NamedTuple):
    """Tip position, and frames of the arm.

    Attributes:
        r_6B: (3,) tip position.
        T_B7: (3, 3) the end effector's frame.
        T_B5: (3, 3) the wrist-pitch frame, in which JACOBI's matrix is given; for the concept arm the lower arm's
            frame.
    """

    r_6B: Array
    T_B7: Array
    T_B5: Array


class LnkagePayload(NamedTuple):
    """Tip position, frames of the arm, and pose of the attached payload.

    Attributes:
        r_6B: (3,) tip position.
        T_B7: (3, 3) the end effector's frame.
        T_B5: (3, 3) as in `Lnkage`.
        T_B8: (3, 3) the payload's frame.
        r_7B: (3,) position of the payload's centre of mass.
    """

    r_6B: Array
    T_B7: Array
    T_B5: Array
    T_B8: Array
    r_7B: Array


class Erates(NamedTuple):
    """Velocities of the tip.

    Attributes:
        omega: (3,) angular velocity [rad/s].
        V: (3,) velocity.
    """

    omega: Array
    V: Array


class Rmsist(NamedTuple):
    """State of the arm at the start of a case.

    Attributes:
        theta: (6,) joint angles [rad].
        theta_dot: (6,) joint rates [rad/s].
        r_6B: (3,) tip position.
        T_B7: (3, 3) the end effector's frame.
        omega: (3,) the tip's angular velocity [rad/s].
        V: (3,) the tip's velocity.
    """

    theta: Array
    theta_dot: Array
    r_6B: Array
    T_B7: Array
    omega: Array
    V: Array


@overload
def lnkage(arm: Arm, theta: ArrayLike, units: Units = "m", *, PA: Literal[0] = 0) -> Lnkage: ...


@overload
def lnkage(
    arm: Arm, theta: ArrayLike, units: Units = "m", *, PA: Literal[1], T_78: ArrayLike = ..., r_87: ArrayLike = ...
) -> LnkagePayload: ...


def lnkage(
    arm: Arm,
    theta: ArrayLike,
    units: Units = "m",
    *,
    PA: Literal[0, 1] = 0,
    T_78: ArrayLike | None = None,
    r_87: ArrayLike | None = None,
) -> Lnkage | LnkagePayload:
    """Return tip position and orientation, and the pose of an attached payload (JSC-12628, subroutine LNKAGE, p. 14).

    Args:
        arm: the arm. `Arm.at` sets the length of its telescope.
        theta: (6,) joint angles [rad].
        units: unit of all lengths in arguments and results.
        PA: 1 if a payload is attached.
        T_78: (3, 3) the payload's axes in frame 7, if PA is 1; None for parallel axes.
        r_87: (3,) position of the payload's centre of mass relative to the tip, in the payload's frame 8, if PA is 1;
            None for a centre of mass at the tip.

    Returns:
        `Lnkage`; if PA is 1, `LnkagePayload`.

    Raises:
        InputError: an argument is wrong, or a payload is described although PA is 0.
    """
    links, length, q = published_links(arm), metres(units), array(theta, (6,), "theta")
    tip = arm.model.mount.to("orbiter", arm.forward(q))
    wrist_pitch = np.empty((3, 3))
    observe_link(links, q, arm.model.mount.rotation, wrist_pitch)
    found = Lnkage(tip.position / length, tip.rotation, wrist_pitch)
    if PA == 0:
        for name, value in (("T_78", T_78), ("r_87", r_87)):
            if value is not None:
                raise InputError(f"{name}: got {value!r}, expected None; no payload is attached (PA = 0)")
        return found
    if PA != 1:
        raise InputError(f"PA: got {PA!r}, expected 0 or 1")
    T_B8 = product(found.T_B7, rotation(UNTURNED if T_78 is None else T_78, "T_78"))
    offset = array((0.0, 0.0, 0.0) if r_87 is None else r_87, (3,), "r_87")
    return LnkagePayload(*found, T_B8, found.r_6B + product(offset, T_B8.T))


def jacobi(arm: Arm, theta: ArrayLike, units: Units = "m") -> Array:
    """Return the Jacobian matrix, the report's `a`, in frame 5 (JSC-12628, subroutine JACOBI, p. 10).

    This matrix times the joint rates gives the report's vector `b`: the tip's angular velocity, then its velocity.

    Args:
        arm: as for `lnkage`.
        theta: (6,) joint angles [rad].
        units: unit of length in the lower three rows.

    Returns:
        (6, 6) matrix with one column for each joint. Rows 1 to 3 give the tip's angular velocity [1], rows 4 to 6 the
        tip's velocity, along the axes of `Lnkage.T_B5`.
    """
    links, length, q = published_links(arm), metres(units), array(theta, (6,), "theta")
    j = jacobian.jacobi(links, sines(links, *q.tolist()))
    rows = np.array(
        [
            [j.a11, 0.0, 0.0, 0.0, j.a15, j.a16],
            [0.0, 1.0, 1.0, j.a24, j.a25, j.a26],
            [j.a31, 0.0, 0.0, j.a34, j.a35, j.a36],
            [j.a41, j.a42, j.a43, j.a44, j.a45, 0.0],
            [j.a51, 0.0, 0.0, j.a54, j.a55, 0.0],
            [j.a61, j.a62, j.a63, j.a64, j.a65, 0.0],
        ]
    )
    rows[3:] /= length
    return rows


def erates(arm: Arm, theta: ArrayLike, theta_dot: ArrayLike, units: Units = "m") -> Erates:
    """Return the tip's velocities for joint rates (JSC-12628, subroutine ERATES, p. 9).

    Args:
        arm: as for `lnkage`.
        theta: (6,) joint angles [rad].
        theta_dot: (6,) joint rates [rad/s].
        units: the unit of length in which `V` is returned.
    """
    links, length = published_links(arm), metres(units)
    a = sines(links, *array(theta, (6,), "theta").tolist())
    rates = jacobian.of_six(*array(theta_dot, (6,), "theta_dot").tolist())
    twist = arm.model.mount.rotation @ np.array(jacobian.erates(a, jacobian.jacobi(links, a), rates)).reshape(2, 3).T
    return Erates(twist[:, 0], twist[:, 1] / length)


def rmsrat(arm: Arm, theta: ArrayLike, omega_C: ArrayLike, V_C: ArrayLike, units: Units = "m") -> Array:
    """Return the joint rates that give the tip the commanded velocities (JSC-12628, subroutine RMSRAT, p. 29).

    Args:
        arm: as for `lnkage`.
        theta: (6,) joint angles [rad].
        omega_C: (3,) commanded angular velocity [rad/s].
        V_C: (3,) commanded velocity.
        units: the unit of length in which `V_C` is given.

    Returns:
        (6,) joint rates theta_dot_C [rad/s].

    Raises:
        SingularityError: the arm is at a singularity; the error names the singularity.
    """
    published_links(arm)  # rejects an arm with another chain
    to_l = arm.model.mount.rotation.T
    omega, v = to_l @ array(omega_C, (3,), "omega_C"), to_l @ array(V_C, (3,), "V_C") * metres(units)
    return np.asarray(arm.joint_rates(array(theta, (6,), "theta"), np.concatenate([omega, v])))


def rmangs(arm: Arm, r_6B: ArrayLike, T_B7: ArrayLike, units: Units = "m") -> Array:
    """Return the joint angles for a pose, on the report's branch (JSC-12628, subroutine RMANGS, p. 25).

    `Arm.inverse` returns all branches. On the report's branch, theta_1 is the arc tangent of the wrist's direction,
    theta_5 is within +-90 deg, and the elbow is above the line from shoulder to wrist. Joint limits are ignored.

    Args:
        arm: as for `lnkage`.
        r_6B: (3,) tip position.
        T_B7: (3, 3) the end effector's frame.
        units: unit of `r_6B`.

    Returns:
        (6,) joint angles [rad], within +-180 deg.

    Raises:
        InputError: an argument is wrong; `T_B7` is not a rotation.
        SingularityError: the pose does not determine the angles.
        UnreachableError: no angles of this branch reach the pose.
    """
    links = published_links(arm)
    given = Pose(array(r_6B, (3,), "r_6B") * metres(units), rotation(T_B7, "T_B7"))
    pose = arm.model.mount.from_("orbiter", given)
    arm.inverse(pose, limits=False)
    angles, excess = np.empty((inverse.BRANCHES, 6)), np.empty(inverse.BRANCHES)
    inverse.rmangs(links, np.concatenate([pose.position, pose.rotation.ravel()]), angles, excess)
    if excess[0] != 0.0:
        raise UnreachableError(
            f"RMANGS's own branch misses this pose by {abs(excess[0]):.4g} m; Arm.inverse returns the branches that "
            "reach it",
            abs(float(excess[0])),
        )
    return np.asarray(angles[0])


def rmsist(
    arm: Arm,
    theta: ArrayLike | None = None,
    theta_dot: ArrayLike = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    *,
    r_6B: ArrayLike | None = None,
    T_B7: ArrayLike | None = None,
    units: Units = "m",
) -> Rmsist:
    """Return the arm's initial state from joint angles or from a pose (JSC-12628, subroutine RMSIST, p. 28).

    Args:
        arm: as for `lnkage`.
        theta: (6,) joint angles [rad]; if None, RMANGS computes them from `r_6B` and `T_B7`.
        theta_dot: (6,) joint rates [rad/s].
        r_6B: (3,) tip position, if `theta` is None.
        T_B7: (3, 3) the end effector's frame, if `theta` is None.
        units: unit of all lengths in arguments and results.

    Raises:
        InputError: the arguments contain neither angles nor a complete pose, or they contain angles and a part of a
            pose.
        LimitError: a joint is outside its hard limits.
        SingularityError: RMANGS raises it; see `rmangs`.
        UnreachableError: RMANGS raises it; see `rmangs`.
    """
    if theta is not None and r_6B is None and T_B7 is None:
        angles = array(theta, (6,), "theta")
    elif theta is None and r_6B is not None and T_B7 is not None:
        angles = rmangs(arm, r_6B, T_B7, units)
    else:
        raise InputError("rmsist: give either theta, or r_6B and T_B7")
    for name, angle, (low, high) in zip(arm.joints, angles.tolist(), arm.limits.hard.tolist(), strict=True):
        if not low <= angle <= high:
            raise LimitError(
                f"{name}: got {np.degrees(angle):g} deg, expected {np.degrees(low):g} to {np.degrees(high):g} deg",
                name,
                angle,
                (low, high),
            )
    rates = array(theta_dot, (6,), "theta_dot")
    here, moving = lnkage(arm, angles, units), erates(arm, angles, rates, units)
    return Rmsist(angles, rates, here.r_6B, here.T_B7, moving.omega, moving.V)
