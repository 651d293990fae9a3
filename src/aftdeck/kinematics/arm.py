"""The arm as callers see it: forward, Jacobian, rates, inverse, singularities, in Python and in batches."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from aftdeck.arms.limits import JointRates, Limits
from aftdeck.arms.load import ArmModel, load_model
from aftdeck.arrays import Array
from aftdeck.errors import InputError, SingularityError, UnreachableError
from aftdeck.frames import Pose, oriend, panel_attitude, panel_rotation, rotation_x
from aftdeck.kinematics.inverse import BRANCHES, rmangs
from aftdeck.kinematics.jacobian import jacobian_many
from aftdeck.kinematics.linkage import L2, L3, L4, forward_many
from aftdeck.kinematics.rates import rates_many
from aftdeck.kinematics.singular import NAMES, Singularities, distances_many
from aftdeck.units import INCH

_ROTATION_TOLERANCE = 1e-6
"""How far from orthonormal a given rotation may be [1]."""
_SAME = 1e-9
"""Two solutions whose angles differ by less are one [rad]."""
_EPSILON = 1e-9
"""Distance [m] or cosine [1] under which RMANGS calls a pose singular."""


class Arm:
    """An arm of one of the two families: the Shuttle's, or the concept's of 1972.

    Joint angles are the operator's: the Shuttle's arm has all zero at the cradle, the concept's where it is
    stretched out aft. Poses and twists are in L, the arm's base frame (for the concept arm the report's R), unless a
    frame is named. What is said of frame 7 is said of system 2 of the concept arm. Every method takes any number of
    leading dimensions unless it says otherwise.

    Attributes:
        model: every constant, with its source.
        name: as in the arm file.
        joints: names, base to tip.
        limits: `hard`, `soft` and `reach`, each (6, 2) [rad].
        rates: `servo`, `coarse` and `vernier`, each (6,) [rad/s].
        rate_limits: (6,) servo maxima [rad/s].
        stand: length of the telescope that the arm stands on [m], a constant of this arm; None where it has none.
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
        """``Arm('srms')``."""
        return f"Arm({self.name!r})"

    def at(self, *, stand: float) -> Arm:
        """The same arm with its telescope at another length.

        Args:
            stand: length, the shoulder's height above the telescope's foot [m].

        Raises:
            InputError: an arm without a telescope, or a length outside the telescope's limits.
        """
        length = _floats(stand, "stand")
        if length.ndim:
            raise InputError(f"stand: expected one number, got {stand!r}")
        return Arm(self.model.at(float(length)))

    def forward(self, angles: ArrayLike) -> Pose:
        """The tip's pose: frame 7 of JSC-12628, subroutine LNKAGE.

        Args:
            angles: (..., 6) joint angles [rad].

        Returns:
            Position (..., 3) [m] and rotation (..., 3, 3), in L.
        """
        rows, shape = _rows(angles, "joint angles")
        position, rotation = np.empty((len(rows), 3)), np.empty((len(rows), 3, 3))
        forward_many(self.model.links, rows, position, rotation)
        return Pose(position.reshape(*shape, 3), rotation.reshape(*shape, 3, 3))

    def jacobian(self, angles: ArrayLike) -> Array:
        """The Jacobian in L, JSC-12628, subroutine JACOBI.

        Args:
            angles: (..., 6) joint angles [rad].

        Returns:
            (..., 6, 6): rows angular [1], then translational [m]; columns joints.
        """
        rows, shape = _rows(angles, "joint angles")
        matrix = np.empty((len(rows), 6, 6))
        jacobian_many(self.model.links, rows, matrix)
        return matrix.reshape(*shape, 6, 6)

    def joint_rates(
        self, angles: ArrayLike, twist: ArrayLike, *, singular: Literal["raise", "mask"] = "raise"
    ) -> Array | tuple[Array, NDArray[np.bool_]]:
        """Joint rates for a tip twist by the closed resolved-rate law, JSC-12628, subroutine RMSRAT.

        Args:
            angles: (..., 6) joint angles [rad].
            twist: (..., 6) angular [rad/s], then translational velocity [m/s] of the tip, in L.
            singular: ``raise`` at a singular pose, or give finite rates there and a ``mask``.

        Returns:
            (..., 6) rates [rad/s]; with ``mask`` also (...) true where the pose is singular.

        Raises:
            SingularityError: which one; only with ``raise``.
        """
        if singular not in ("raise", "mask"):
            raise InputError(f"singular is 'raise' or 'mask', got {singular!r}")
        q, t = _sixes(angles, "joint angles"), _sixes(twist, "a twist")
        try:
            q, t = np.broadcast_arrays(q, t)
        except ValueError:
            raise InputError(f"joint angles {q.shape} and twists {t.shape} do not go together") from None
        rows, shape = _rows(q, "joint angles")
        twists, _ = _rows(t, "a twist")
        rates, mask = np.empty((len(rows), 6)), np.empty(len(rows), dtype=np.bool_)
        rates_many(self.model.links, rows, twists, rates, mask)
        if singular == "mask":
            return rates.reshape(*shape, 6), mask.reshape(shape)
        if mask.any():
            raise self._singularity(rows[int(mask.argmax())])
        return rates.reshape(*shape, 6)

    def singularities(self, angles: ArrayLike) -> Singularities:
        """Signed, normalised distances from the three singularities.

        Args:
            angles: (..., 6) joint angles [rad].

        Returns:
            `shoulder`, `elbow`, `wrist`, each (...) in [-1, 1], 0 at the singularity.
        """
        rows, shape = _rows(angles, "joint angles")
        result = np.empty((3, len(rows)))
        distances_many(self.model.links, rows, result)
        return Singularities(*(d.reshape(shape) for d in result))

    def inverse(self, pose: Pose, near: ArrayLike | None = None, limits: bool = True) -> Array:
        """All joint angles that put the tip at a pose, JSC-12628, subroutine RMANGS.

        Args:
            pose: position (3,) [m] and rotation (3, 3) of frame 7, in L.
            near: (6,) angles; solutions come nearest first (root of the sum of squared differences), wrist
                roll in the revolution nearest to it. Without it: nearest to all angles zero, wrist roll
                within +-180 deg.
            limits: leave out solutions outside the hard limits.

        Returns:
            (n, 6) joint angles [rad], 1 <= n <= 8.

        Raises:
            SingularityError: the pose fixes no single set of angles (shoulder or wrist), or does not on one of the
                solutions.
            UnreachableError: the pose is out of reach, or every solution is outside the hard limits; by
                how much on the branch that comes nearest.
        """
        position = _floats(pose.position, "a position")
        rotation = _floats(pose.rotation, "a rotation")
        if position.shape != (3,) or rotation.shape != (3, 3):
            raise InputError(
                f"a pose has a position (3,) and a rotation (3, 3), got {position.shape} and {rotation.shape}"
            )
        skew = float(np.abs(rotation @ rotation.T - np.eye(3)).max())
        if skew > _ROTATION_TOLERANCE:
            raise InputError(
                f"the rotation is not orthonormal: R R^T is off by {skew:.3g}, {_ROTATION_TOLERANCE:g} is allowed"
            )
        if np.linalg.det(rotation) < 0.0:
            raise InputError("the rotation is a mirror image: its determinant is -1, +1 is allowed")
        reference = np.zeros(6) if near is None else _floats(near, "near")
        if reference.shape != (6,):
            raise InputError(f"near has shape (6,), got {reference.shape}")
        branches, excess = np.empty((BRANCHES, 6)), np.empty(BRANCHES)
        off_axis, cosine = rmangs(self.model.links, np.concatenate([position, rotation.ravel()]), branches, excess)
        fifth = self.joints[4].replace("_", " ")
        if off_axis < _EPSILON:
            raise SingularityError(
                f"the {fifth} joint stands {off_axis:.2g} m from the {self.joints[0].replace('_', ' ')} axis: "
                "shoulder singularity",
                "shoulder",
                off_axis / float(self.model.links[L2] + self.model.links[L3] + self.model.links[L4]),
            )
        wrist = f"the {fifth} joint stands at +-90 deg: wrist singularity"
        if cosine < _EPSILON:
            raise SingularityError(wrist, "wrist", cosine)
        solutions = branches[excess == 0.0]
        if not len(solutions):
            raise self._out_of_reach(excess)
        solutions = self._revolutions(solutions, None if near is None else reference, limits)
        if limits:
            solutions = self._inside(solutions)
        cosine = float(np.abs(np.cos(solutions[:, 4])).min())
        if cosine < _EPSILON:
            raise SingularityError(wrist, "wrist", cosine)
        order = np.argsort(np.linalg.norm(solutions - reference, axis=1), kind="stable")
        return _distinct(solutions[order])

    def rmangs(self, pose: Pose) -> Array:
        """The one set of joint angles that JSC-12628's RMANGS gives: the elbow bent below the line, the wrist unturned.

        Args:
            pose: position (3,) [m] and rotation (3, 3) of frame 7, in L.

        Returns:
            (6,) joint angles in [-pi, pi], whatever their limits [rad].

        Raises:
            SingularityError, UnreachableError: as `inverse`.
        """
        self.inverse(pose, limits=False)  # says what is wrong with a pose
        branches, excess = np.empty((BRANCHES, 6)), np.empty(BRANCHES)
        packed = np.concatenate([_floats(pose.position, "a position"), _floats(pose.rotation, "a rotation").ravel()])
        rmangs(self.model.links, packed, branches, excess)
        if excess[0] != 0.0:
            raise self._out_of_reach(excess[:1])
        first: Array = branches[0]
        return first

    def end_effector(self, rotation: Array) -> Array:
        """The end effector's own axes E from frame 7's: R_E = R_7 Rx(end_effector_roll); (..., 3, 3)."""
        return rotation @ rotation_x(self.model.end_effector_roll)

    def panel(self, pose: Pose) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """What the panel shows of a pose in L: X, Y, Z [in] and the end effector's pitch, yaw, roll [deg]."""
        shown = self.model.mount.to("panel", Pose(pose.position, self.end_effector(pose.rotation)))
        attitude = panel_attitude(shown.rotation)
        return tuple(float(x) / INCH for x in shown.position), tuple(math.degrees(a) for a in attitude)

    def from_panel(self, position: ArrayLike, attitude: ArrayLike) -> Pose:
        """A tip pose in L from panel components: X, Y, Z [m] and the end effector's pitch, yaw, roll [rad]."""
        pitch, yaw, roll = _floats(attitude, "an attitude")
        rotation = panel_rotation(pitch, yaw, roll) @ rotation_x(-self.model.end_effector_roll)
        return self.model.mount.from_("panel", Pose(_floats(position, "a position"), rotation))

    def orbiter(self, pose: Pose) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """A pose in L in the orbiter frame: x, y, z [m] and ENDORI's roll, elevation, azimuth [rad]."""
        shown = self.model.mount.to("orbiter", pose)
        return tuple(float(x) for x in shown.position), oriend(shown.rotation)

    def _singularity(self, angles: Array) -> SingularityError:
        found = dict(zip(NAMES, (float(d) for d in self.singularities(angles)), strict=True))
        name = min(found, key=lambda key: abs(found[key]))
        return SingularityError(
            f"the arm stands at its {name} singularity (distance {found[name]:.2g} of 1): no bounded joint rates "
            "give this tip motion",
            name,
            found[name],
        )

    def _out_of_reach(self, excess: Array) -> UnreachableError:
        nearest = float(excess[np.abs(excess).argmin()])
        if nearest > 0.0:
            return UnreachableError(
                f"the arm cannot reach this pose: its wrist is {nearest:.4g} m too far out", nearest
            )
        return UnreachableError(
            f"the arm cannot fold to this pose: its wrist is {-nearest:.4g} m too close to the shoulder",
            -nearest,
        )

    def _revolutions(self, solutions: Array, near: Array | None, limits: bool) -> Array:
        """Angles in the revolution nearest to `near`, or within +-180 deg; inside the limits where that can be."""
        if near is not None:
            solutions = solutions + math.tau * np.round((near - solutions) / math.tau)
        if limits:
            low, high = self.limits.hard.T
            solutions = solutions - math.tau * np.ceil((solutions - high - _SAME) / math.tau).clip(min=0.0)
            solutions = solutions + math.tau * np.ceil((low - _SAME - solutions) / math.tau).clip(min=0.0)
            below = solutions - math.tau  # nearer to a range that the angle is outside of either way
            solutions = np.where((solutions > high + _SAME) & (low - below < solutions - high), below, solutions)
        return solutions

    def _inside(self, solutions: Array) -> Array:
        hard = self.limits.hard
        beyond = np.maximum(hard[:, 0] - solutions, solutions - hard[:, 1])
        worst = beyond.max(axis=1)
        inside: Array = solutions[worst <= _SAME]
        if len(inside):
            return inside
        row = int(worst.argmin())
        joint = int(beyond[row].argmax())
        name = self.joints[joint]
        low, high = np.degrees(hard[joint])
        raise UnreachableError(
            f"every solution lies outside the joint limits; the nearest needs {name} at "
            f"{math.degrees(solutions[row, joint]):.2f} deg, {math.degrees(worst[row]):.2f} deg outside "
            f"{low:.1f} to {high:.1f} deg",
            float(worst[row]),
            name,
        )


def load_arm(name_or_path: str | Path) -> Arm:
    """The arm of a built-in name (``srms``) or of an arm file.

    Raises:
        ArmError: no such arm.
        ScenarioError: everything that is wrong in the file.
    """
    return Arm(load_model(name_or_path))


def _floats(values: ArrayLike, what: str) -> Array:
    try:
        if np.iscomplexobj(values):
            raise TypeError
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"{what}: expected numbers, got {values!r}") from None
    if not np.isfinite(array).all():
        raise InputError(f"{what}: expected finite numbers, got {array}")
    return array


def _sixes(values: ArrayLike, what: str) -> Array:
    array = _floats(values, what)
    if array.ndim == 0 or array.shape[-1] != 6:
        raise InputError(f"{what}: expected shape (..., 6), got {array.shape}")
    return array


def _rows(values: ArrayLike, what: str) -> tuple[Array, tuple[int, ...]]:
    """(n, 6) contiguous rows and the leading shape."""
    array = _sixes(values, what)
    return np.ascontiguousarray(array.reshape(-1, 6)), array.shape[:-1]


def _distinct(solutions: Array) -> Array:
    """Solutions without repetitions (the two elbow branches meet where the arm is stretched)."""
    kept: list[Array] = []
    for row in solutions:
        if all(np.abs(row - other).max() > _SAME for other in kept):
            kept.append(row)
    return np.array(kept)
