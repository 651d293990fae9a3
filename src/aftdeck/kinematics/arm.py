"""Python interface of the arm: forward and inverse kinematics, Jacobian, joint rates and singularities, in batches."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Literal, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from aftdeck.arms.limits import JointRates, Limits
from aftdeck.arms.load import ArmModel, load_model
from aftdeck.arrays import Array, floats_of
from aftdeck.errors import InputError, SingularityError, UnreachableError
from aftdeck.frames import Pose, oriend, panel_attitude, panel_rotation, rotation_x
from aftdeck.kinematics import solutions
from aftdeck.kinematics.finite import finite
from aftdeck.kinematics.inverse import BRANCHES, rmangs
from aftdeck.kinematics.jacobian import jacobian_many
from aftdeck.kinematics.linkage import L2, L3, L4, forward_many
from aftdeck.kinematics.rates import rates_many
from aftdeck.kinematics.singular import NAMES, Singularities, distances_many
from aftdeck.kinematics.solutions import FOUND, Solved, solve
from aftdeck.matrices import product
from aftdeck.units import INCH, short


class Arm:
    """Arm of one of two families: the family of the Shuttle's arm, or the family of the concept arm of 1972.

    Joint angles are those of the panel. All angles of the Shuttle's arm are zero at the cradle; all angles of the
    concept arm are zero when it is stretched out aft. Poses and twists are in L, the arm's base frame, unless another
    frame is named. For the concept arm, L is the report's frame R, and frame 7 is system 2. Every method accepts arrays
    with any number of leading dimensions, unless its description states otherwise.

    Attributes:
        model: every constant, with its source.
        name: name in the arm file.
        joints: names of the joints, from base to tip.
        limits: `hard`, `soft` and `reach`, each (6, 2) [rad].
        rates: `servo`, `coarse` and `vernier`, each (6,) [rad/s].
        rate_limits: (6,) servo maxima [rad/s].
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
            angles: (..., 6) joint angles [rad].

        Returns:
            Position (..., 3) [m] and rotation (..., 3, 3), in L.
        """
        rows, shape = _rows(angles, "joint angles")
        position, rotation = np.empty((len(rows), 3)), np.empty((len(rows), 3, 3))
        if not forward_many(self.model.links, rows, position, rotation):
            raise _not_finite("joint angles", rows)
        return Pose(position.reshape(*shape, 3), rotation.reshape(*shape, 3, 3))

    def jacobian(self, angles: ArrayLike) -> Array:
        """Return the Jacobian in L (JSC-12628, subroutine JACOBI).

        Args:
            angles: (..., 6) joint angles [rad].

        Returns:
            (..., 6, 6): three rows for the angular velocity [1], then three rows for the translational velocity [m];
            one column for each joint.
        """
        rows, shape = _rows(angles, "joint angles")
        matrix = np.empty((len(rows), 6, 6))
        if not jacobian_many(self.model.links, rows, matrix):
            raise _not_finite("joint angles", rows)
        return matrix.reshape(*shape, 6, 6)

    def joint_rates(
        self, angles: ArrayLike, twist: ArrayLike, *, singular: Literal["raise", "mask"] = "raise"
    ) -> Array | tuple[Array, NDArray[np.bool_]]:
        """Return joint rates for a tip twist by the closed-form resolved-rate law (JSC-12628, subroutine RMSRAT).

        Args:
            angles: (..., 6) joint angles [rad].
            twist: (..., 6) angular velocity [rad/s], then translational velocity [m/s] of the tip, in L.
            singular: ``raise`` to raise an error if a pose is singular; ``mask`` to return finite rates for singular
                poses too, and a mask.

        Returns:
            (..., 6) rates [rad/s]; with ``mask`` also a mask (...), true where the pose is singular.

        Raises:
            SingularityError: a pose is singular and `singular` is ``raise``; the error names the singularity.
        """
        if cast("object", type(singular)) is not str or singular not in ("raise", "mask"):
            raise InputError(f"singular: expected 'raise' or 'mask', got {short(singular)}")
        q, t = _sixes(angles, "joint angles"), _sixes(twist, "a twist")
        if q.shape != t.shape:
            try:
                q, t = np.broadcast_arrays(q, t)
            except ValueError:
                raise InputError(f"joint angles {q.shape} and twists {t.shape} cannot be broadcast together") from None
        rows, twists, shape = _flat(q), _flat(t), q.shape[:-1]
        rates, mask = np.empty((len(rows), 6)), np.empty(len(rows), dtype=np.bool_)
        if not rates_many(self.model.links, rows, twists, rates, mask):
            raise _not_finite("joint angles", rows) if not finite(rows.ravel()) else _not_finite("a twist", twists)
        if singular == "mask":
            return rates.reshape(*shape, 6), mask.reshape(shape)
        if mask.any():
            raise self._singularity(rows[int(mask.argmax())])
        return rates.reshape(*shape, 6)

    def singularities(self, angles: ArrayLike) -> Singularities:
        """Return the signed, normalised distances from the three singularities.

        Args:
            angles: (..., 6) joint angles [rad].

        Returns:
            `shoulder`, `elbow`, `wrist`, each (...) in [-1, 1], 0 at the singularity.
        """
        rows, shape = _rows(angles, "joint angles")
        result = np.empty((3, len(rows)))
        if not distances_many(self.model.links, rows, result):
            raise _not_finite("joint angles", rows)
        found = result.reshape(3, *shape)
        return Singularities(found[0, ...], found[1, ...], found[2, ...])

    def inverse(self, pose: Pose, near: ArrayLike | None = None, limits: bool = True) -> Array:
        """Return all sets of joint angles that put the tip at a pose (JSC-12628, subroutine RMANGS).

        Args:
            pose: position (3,) [m] and rotation (3, 3) of frame 7, in L.
            near: (6,) angles [rad]. Solutions are sorted by their distance from `near` (root of the sum of squared
                differences), nearest first. Each angle is in the revolution nearest to `near`. If None, the
                distance is measured from the zero angles, and each angle is within +-180 deg.
            limits: True to move each angle by whole revolutions to a value inside the hard stops where this is
                possible, and to leave out every solution that is still outside the hard stops.

        Returns:
            (n, 6) joint angles [rad], 1 <= n <= 8.

        Raises:
            SingularityError: the pose does not determine the angles (shoulder or wrist singularity), or one of the
                solutions is singular.
            UnreachableError: the pose is out of reach, or every solution is outside the hard stops. The error's
                `excess` is the smallest of all branches: distance by which the wrist is out of reach [m], or angle
                beyond a hard stop [rad].
        """
        packed = _packed(pose)
        # a copy, so that the law gets the same array type in every call
        reference = np.zeros(6) if near is None else np.array(floats_of(near, "near"))
        if reference.shape != (6,):
            raise InputError(f"near: expected shape (6,), got {reference.shape}")
        rows = np.empty((BRANCHES, 6))
        found = solve(self.model.links, self.limits.hard, packed, reference, near is not None, bool(limits), rows)
        if found.outcome != FOUND:
            raise self._unsolved(found, pose, reference)
        return rows[: found.number]

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
        self.inverse(pose, limits=False)  # raises an error if the pose is invalid
        branches, excess = np.empty((BRANCHES, 6)), np.empty(BRANCHES)
        rmangs(self.model.links, _packed(pose), branches, excess)
        if excess[0] != 0.0:
            raise _out_of_reach(float(excess[0]))
        first: Array = branches[0]
        return first

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

    def _singularity(self, angles: Array) -> SingularityError:
        distances = dict(zip(NAMES, (float(d) for d in self.singularities(angles)), strict=True))
        name = min(distances, key=lambda key: abs(distances[key]))
        return SingularityError(
            f"the arm is at its {name} singularity (distance {distances[name]:.2g}; the greatest is 1): no bounded "
            "joint rates produce this twist",
            name,
            distances[name],
        )

    def _unsolved(self, found: Solved, pose: Pose, near: Array) -> InputError | SingularityError | UnreachableError:
        """Return the error for a pose for which `inverse` finds no joint angles.

        The texts of these errors appear in CMD CK and in the log. Recordings therefore change if a text changes.
        """
        first, fifth = (self.joints[k].replace("_", " ") for k in (0, 4))
        match found.outcome:
            case solutions.SKEW:
                return InputError(solutions.skew_text(found.value))
            case solutions.MIRRORED:
                return InputError(solutions.MIRRORED_TEXT)
            case solutions.SHOULDER:
                return SingularityError(
                    f"the {fifth} joint stands {found.value:.2g} m from the {first} axis: shoulder singularity",
                    "shoulder",
                    found.value / float(self.model.links[L2] + self.model.links[L3] + self.model.links[L4]),
                )
            case solutions.WRIST:
                return SingularityError(
                    f"the {fifth} joint stands at +-90 deg: wrist singularity", "wrist", found.value
                )
            case solutions.OUT_OF_REACH:
                return _out_of_reach(found.value)
            case solutions.OUTSIDE:
                name, (low, high) = self.joints[found.joint], np.degrees(self.limits.hard[found.joint])
                return UnreachableError(
                    f"every solution lies outside the joint limits; the nearest needs {name} at "
                    f"{math.degrees(found.angle):.2f} deg, {math.degrees(found.value):.2f} deg outside "
                    f"{low:.1f} to {high:.1f} deg",
                    found.value,
                    name,
                )
        given = {"a position": np.array(pose.position), "a rotation": np.array(pose.rotation), "near": near}
        return next(_not_finite(name, values) for name, values in given.items() if not np.isfinite(values).all())


def _out_of_reach(excess: float) -> UnreachableError:
    """Return the error for a wrist out of reach; `excess` [m] is negative if the wrist is too close to the shoulder."""
    if excess > 0.0:
        return UnreachableError(f"the arm cannot reach this pose: its wrist is {excess:.4g} m too far out", excess)
    return UnreachableError(
        f"the arm cannot fold to this pose: its wrist is {-excess:.4g} m too close to the shoulder", -excess
    )


def load_arm(name_or_path: str | Path) -> Arm:
    """Return the arm of a built-in name (``srms``) or of an arm file.

    Raises:
        ArmError: no built-in arm has that name.
        ScenarioError: the file has errors, all listed in the message.
    """
    return Arm(load_model(name_or_path))


def _not_finite(what: str, values: Array) -> InputError:
    return InputError(f"{what}: expected finite numbers, got {values.squeeze()}")


def _floats(values: ArrayLike, what: str) -> Array:
    """Return finite numbers as an array of float64."""
    array = floats_of(values, what)
    if not finite(array.ravel()):
        raise _not_finite(what, array)
    return array


def _sixes(values: ArrayLike, what: str) -> Array:
    """Return numbers (..., 6) as an array of float64, finite or not."""
    array = floats_of(values, what)
    if array.ndim == 0 or array.shape[-1] != 6:
        raise InputError(f"{what}: expected shape (..., 6), got {array.shape}")
    return array


def _rows(values: ArrayLike, what: str) -> tuple[Array, tuple[int, ...]]:
    """Return the contiguous rows (n, 6) of an array (..., 6), and the array's leading dimensions."""
    array = _sixes(values, what)
    return _flat(array), array.shape[:-1]


def _flat(array: Array) -> Array:
    """Return the contiguous rows (n, 6) of an array (..., 6)."""
    return np.ascontiguousarray(array.reshape(-1, 6))


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
