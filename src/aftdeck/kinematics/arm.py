"""Python interface of the arm: forward and inverse kinematics, Jacobian, joint rates and singularities, in batches."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, Literal, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from aftdeck.arms.limits import JointRates, Limits
from aftdeck.arms.load import ArmModel, load_model
from aftdeck.arrays import Array, floats_of
from aftdeck.errors import InputError, SingularityError
from aftdeck.frames import Pose, oriend, panel_attitude, panel_rotation, rotation_x
from aftdeck.kinematics.closed import ClosedForm
from aftdeck.kinematics.finite import finite, not_finite
from aftdeck.kinematics.general import solver_of
from aftdeck.kinematics.singular import Singularities
from aftdeck.matrices import product
from aftdeck.units import INCH, short


class Arm:
    """Arm whose wrist has a closed form, as the Shuttle's arm and the concept arm of 1972 have, or any other chain.

    Joint angles are those of the panel. All angles of the Shuttle's arm are zero at the cradle; all angles of the
    concept arm are zero when it is stretched out aft. Poses and twists are in L, the arm's base frame, unless another
    frame is named. For the concept arm, L is the report's frame R, and frame 7 is system 2. Every method accepts arrays
    with any number of leading dimensions, unless its description states otherwise.

    Attributes:
        model: every constant, with its source.
        name: name in the arm file.
        joints: names of the joints, from base to tip.
        limits: `hard`, `soft` and `reach`, each (n, 2) [rad].
        rates: `servo`, `coarse` and `vernier`, each (n,) [rad/s].
        rate_limits: (n,) servo maxima [rad/s].
        stand: length of the telescope under the arm [m], constant for this object; None if the arm has no telescope.
    """

    def __init__(self, model: ArmModel) -> None:
        self.model = model
        self.name = model.name
        self.joints = model.joints
        self.limits: Limits = model.limits
        self.rates: JointRates = model.rates
        self.rate_limits: Array = model.rates.servo
        self.stand = model.stand
        self._solver, self._count = solver_of(model), len(model.joints)

    @property
    def closed_form(self) -> bool:
        """Whether the arm has a closed form, for which the report's laws are written."""
        return isinstance(self._solver, ClosedForm)

    def __repr__(self) -> str:
        """Return text such as ``Arm('srms')``."""
        return f"Arm({self.name!r})"

    def at(self, *, stand: float) -> Arm:
        """Return the same arm with its telescope at another length.

        Args:
            stand: length of the telescope, which is the shoulder's height above the telescope's foot [m].

        Raises:
            InputError: the arm has no telescope, or the length is outside the telescope's limits.
        """
        length = _floats(stand, "stand")
        if length.ndim:
            raise InputError(f"stand: expected one number, got {short(stand)}")
        return Arm(self.model.at(float(length)))

    def forward(self, angles: ArrayLike) -> Pose:
        """Return the pose of the tip: the pose of frame 7 (JSC-12628, subroutine LNKAGE).

        Args:
            angles: (..., n) joint angles [rad].

        Returns:
            Position (..., 3) [m] and rotation (..., 3, 3), in L.
        """
        rows, shape = self._rows(angles)
        position, rotation = np.empty((len(rows), 3)), np.empty((len(rows), 3, 3))
        if not self._solver.forward(rows, position, rotation):
            raise not_finite("joint angles", rows)
        return Pose(position.reshape(*shape, 3), rotation.reshape(*shape, 3, 3))

    def jacobian(self, angles: ArrayLike) -> Array:
        """Return the Jacobian in L (JSC-12628, subroutine JACOBI).

        Args:
            angles: (..., n) joint angles [rad].

        Returns:
            (..., 6, n): three rows for the angular velocity [1], then three rows for the translational velocity [m];
            one column for each joint.
        """
        rows, shape = self._rows(angles)
        matrix = np.empty((len(rows), 6, self._count))
        if not self._solver.jacobian(rows, matrix):
            raise not_finite("joint angles", rows)
        return matrix.reshape(*shape, 6, self._count)

    def joint_rates(
        self, angles: ArrayLike, twist: ArrayLike, *, singular: Literal["raise", "mask"] = "raise"
    ) -> Array | tuple[Array, NDArray[np.bool_]]:
        """Return joint rates for a tip twist by the closed-form resolved-rate law (JSC-12628, subroutine RMSRAT).

        Args:
            angles: (..., n) joint angles [rad].
            twist: (..., 6) angular velocity [rad/s], then translational velocity [m/s] of the tip, in L.
            singular: ``raise`` to raise an error if a pose is singular; ``mask`` to return finite rates for singular
                poses too, and a mask.

        Returns:
            (..., n) rates [rad/s]; with ``mask`` also a mask (...), true where the pose is singular.

        Raises:
            SingularityError: a pose is singular and `singular` is ``raise``; the error names the singularity.
        """
        if cast("object", type(singular)) is not str or singular not in ("raise", "mask"):
            raise InputError(f"singular: expected 'raise' or 'mask', got {short(singular)}")
        q, t = _last(angles, self._count, "joint angles"), _last(twist, 6, "a twist")
        shape = q.shape[:-1]
        if shape != t.shape[:-1]:
            try:
                shape = np.broadcast_shapes(shape, t.shape[:-1])
            except ValueError:
                raise InputError(f"joint angles {q.shape} and twists {t.shape} cannot be broadcast together") from None
            q, t = np.broadcast_to(q, (*shape, q.shape[-1])), np.broadcast_to(t, (*shape, 6))
        rows, twists = _flat(q), _flat(t)
        rates, mask = np.empty(rows.shape), np.empty(len(rows), dtype=np.bool_)
        if not self._solver.rates(rows, twists, rates, mask):
            raise not_finite("joint angles", rows) if not finite(rows.ravel()) else not_finite("a twist", twists)
        if singular == "mask":
            return rates.reshape(*shape, self._count), mask.reshape(shape)
        if mask.any():
            raise self._singularity(rows[int(mask.argmax())])
        return rates.reshape(*shape, self._count)

    def singularities(self, angles: ArrayLike) -> Singularities | Any:
        """Return the signed, normalised distances from the arm's singularities.

        Args:
            angles: (..., n) joint angles [rad].

        Returns:
            `shoulder`, `elbow`, `wrist`, each (...) in [-1, 1], 0 at the singularity; for an arm without a closed form
            only `rank`, in [0, 1]: how near the arm is to losing a direction in which it moves its tip.
        """
        rows, shape = self._rows(angles)
        found = self._solver.distances(rows, shape)
        if found is None:
            raise not_finite("joint angles", rows)
        return found

    def inverse(self, pose: Pose, near: ArrayLike | None = None, limits: bool = True) -> Array:
        """Return all sets of joint angles that put the tip at a pose (JSC-12628, subroutine RMANGS).

        Args:
            pose: position (3,) [m] and rotation (3, 3) of frame 7, in L.
            near: (n,) angles [rad]. Solutions are sorted by their distance from `near` (root of the sum of squared
                differences), nearest first. Each angle is in the revolution nearest to `near`. If None, the
                distance is measured from the zero angles, and each angle is within +-180 deg.
            limits: True to move each angle by whole revolutions to a value inside the hard stops where this is
                possible, and to leave out every solution that is still outside the hard stops.

        Returns:
            (s, n) joint angles [rad], 1 <= s <= 8. For an arm without a closed form s is 1: the solution that a search
            from `near` finds, or from other poses if that one fails.

        Raises:
            SingularityError: the pose does not determine the angles (shoulder or wrist singularity), or one of the
                solutions is singular.
            UnreachableError: the pose is out of reach, or every solution is outside the hard stops. The error's
                `excess` is the smallest of all branches: distance by which the wrist is out of reach [m], or angle
                beyond a hard stop [rad].
        """
        packed, count = _packed(pose), self._count
        # a copy, so that the law gets the same array type in every call
        reference = np.zeros(count) if near is None else np.array(floats_of(near, "near"))
        if reference.shape != (count,):
            raise InputError(f"near: expected shape ({count},), got {reference.shape}")
        return self._solver.solve(packed, reference, near is not None, bool(limits))

    def rmangs(self, pose: Pose) -> Array:
        """Return the set of joint angles that the published RMANGS of JSC-12628 returns.

        The elbow is above the line from shoulder to wrist, and the fifth angle is within 90 deg of zero.

        Args:
            pose: position (3,) [m] and rotation (3, 3) of frame 7, in L.

        Returns:
            (6,) joint angles in [-pi, pi] [rad]; joint limits are ignored.

        Raises:
            SingularityError: as for `inverse`, with `limits` False.
            UnreachableError: the pose is out of reach for this set of angles.
        """
        if not isinstance(self._solver, ClosedForm):
            raise InputError(f"{self.name} has no closed form, so RMANGS has no solution for it; use inverse()")
        self.inverse(pose, limits=False)  # raises an error if the pose is invalid
        return self._solver.rmangs(_packed(pose))

    def end_effector(self, rotation: Array) -> Array:
        """Return the end effector's axes E (..., 3, 3) from the axes of frame 7: R_E = R_7 Rx(end_effector_roll)."""
        axes = floats_of(rotation, "a rotation")
        if axes.shape[-2:] != (3, 3):
            raise InputError(f"a rotation: expected shape (..., 3, 3), got {axes.shape}")
        return product(axes, rotation_x(self.model.end_effector_roll))

    def panel(self, pose: Pose) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Return the panel's read-out of a pose in L: X, Y, Z [in] and the end effector's pitch, yaw, roll [deg]."""
        position, rotation = _single(pose)
        pose_on_panel = self.model.mount.to("panel", Pose(position, self.end_effector(rotation)))
        attitude = panel_attitude(pose_on_panel.rotation)
        return tuple(float(x) / INCH for x in pose_on_panel.position), tuple(math.degrees(a) for a in attitude)

    def from_panel(self, position: ArrayLike, attitude: ArrayLike) -> Pose:
        """Return the tip pose in L from panel components: X, Y, Z [m] and the end effector's pitch, yaw, roll [rad]."""
        pitch, yaw, roll = _three(attitude, "an attitude").tolist()
        rotation = product(panel_rotation(pitch, yaw, roll), rotation_x(-self.model.end_effector_roll))
        return self.model.mount.from_("panel", Pose(_three(position, "a position"), rotation))

    def orbiter(self, pose: Pose) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Return a pose in L as orbiter components: x, y, z [m] and ENDORI's roll, elevation, azimuth [rad]."""
        pose_in_orbiter = self.model.mount.to("orbiter", Pose(*_single(pose)))
        return tuple(float(x) for x in pose_in_orbiter.position), oriend(pose_in_orbiter.rotation)

    def _rows(self, angles: ArrayLike) -> tuple[Array, tuple[int, ...]]:
        """Return the contiguous rows (m, n) of joint angles (..., n), and the leading dimensions."""
        array = _last(angles, self._count, "joint angles")
        return _flat(array), array.shape[:-1]

    def _singularity(self, angles: Array) -> SingularityError:
        found = zip(self.model.singularities, (float(d) for d in self.singularities(angles)), strict=True)
        name, distance = min(found, key=lambda one: abs(one[1]))
        return SingularityError(
            f"the arm is at its {name} singularity (distance {distance:.2g}; the greatest is 1): no bounded "
            "joint rates produce this twist",
            name,
            distance,
        )


def load_arm(name_or_path: str | Path) -> Arm:
    """Return the arm of a built-in name (``srms``) or of an arm file.

    Raises:
        ArmError: no built-in arm has that name.
        ScenarioError: the file has errors, all listed in the message.
    """
    return Arm(load_model(name_or_path))


def _floats(values: ArrayLike, what: str) -> Array:
    """Return finite numbers as an array of float64."""
    array = floats_of(values, what)
    if not finite(array.ravel()):
        raise not_finite(what, array)
    return array


def _last(values: ArrayLike, count: int, what: str) -> Array:
    """Return numbers (..., count) as an array of float64, finite or not."""
    array = floats_of(values, what)
    if array.ndim == 0 or array.shape[-1] != count:
        raise InputError(f"{what}: expected shape (..., {count}), got {array.shape}")
    return array


def _flat(array: Array) -> Array:
    """Return the contiguous rows (m, k) of an array (..., k)."""
    return np.ascontiguousarray(array.reshape(-1, array.shape[-1]))


def _single(pose: object) -> tuple[Array, Array]:
    """Return position (3,) and rotation (3, 3) of one pose as arrays of float64, finite or not."""
    if not isinstance(pose, Pose):
        raise InputError(f"a pose: expected a Pose with a position (3,) and a rotation (3, 3), got {short(pose)}")
    position, rotation = floats_of(pose.position, "a position"), floats_of(pose.rotation, "a rotation")
    if position.shape != (3,) or rotation.shape != (3, 3):
        raise InputError(
            f"a pose: expected a position (3,) and a rotation (3, 3), got {position.shape} and {rotation.shape}"
        )
    return position, rotation


def _three(values: ArrayLike, what: str) -> Array:
    """Return three finite numbers as an array of float64."""
    array = _floats(values, what)
    if array.shape != (3,):
        raise InputError(f"{what}: expected shape (3,), got {array.shape}")
    return array


def _packed(pose: Pose) -> Array:
    """Return a pose as an array (12,), finite or not: position [m], then the rotation row by row."""
    position, rotation = _single(pose)
    packed = np.empty(12)
    packed[:3], packed[3:] = position, rotation.ravel()
    return packed
