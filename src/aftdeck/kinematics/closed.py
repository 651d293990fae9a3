"""Closed forms of the two arms of the reports, for many poses at a time, and their errors."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array
from aftdeck.errors import InputError, SingularityError, UnreachableError
from aftdeck.kinematics import solutions
from aftdeck.kinematics.inverse import BRANCHES, rmangs
from aftdeck.kinematics.jacobian import jacobian_many
from aftdeck.kinematics.linkage import L2, L3, L4, forward_many
from aftdeck.kinematics.rates import rates_many
from aftdeck.kinematics.singular import Singularities, distances_many
from aftdeck.kinematics.solutions import FOUND, Solved, pose_error, solve


class ClosedForm:
    """Solver of an arm with six joints whose wrist has a closed form; `Arm` describes what its methods return.

    A method with an array for its results writes them into it, and returns whether all given numbers are finite.
    """

    def __init__(self, model: ArmModel) -> None:
        self._model, self._links = model, model.links

    def forward(self, rows: Array, position: Array, rotation: Array) -> bool:
        """Compute the tip's poses."""
        return forward_many(self._links, rows, position, rotation)

    def jacobian(self, rows: Array, matrix: Array) -> bool:
        """Compute the Jacobians."""
        return jacobian_many(self._links, rows, matrix)

    def rates(self, rows: Array, twists: Array, rates: Array, singular: NDArray[np.bool_]) -> bool:
        """Compute joint rates, and whether each pose is singular."""
        return rates_many(self._links, rows, twists, rates, singular)

    def distances(self, rows: Array, shape: tuple[int, ...]) -> Singularities | None:
        """Return the distances from the singularities; None if an angle is not finite."""
        result = np.empty((3, len(rows)))
        if not distances_many(self._links, rows, result):
            return None
        found = result.reshape(3, *shape)
        return Singularities(found[0, ...], found[1, ...], found[2, ...])

    def solve(self, pose: Array, near: Array, turned: bool, limited: bool) -> Array:
        """Return the joint angles for a pose (12,)."""
        rows = np.empty((BRANCHES, 6))
        found = solve(self._links, self._model.limits.hard, pose, near, turned, limited, rows)
        if found.outcome != FOUND:
            raise self._unsolved(found, pose, near)
        return rows[: found.number]

    def rmangs(self, pose: Array) -> Array:
        """Return the solution of the published RMANGS for a pose (12,)."""
        branches, excess = np.empty((BRANCHES, 6)), np.empty(BRANCHES)
        rmangs(self._links, pose, branches, excess)
        if excess[0] != 0.0:
            raise _out_of_reach(float(excess[0]))
        first: Array = branches[0]
        return first

    def _unsolved(self, found: Solved, pose: Array, near: Array) -> InputError | SingularityError | UnreachableError:
        """Return the error for a pose for which `inverse` finds no joint angles.

        The texts of these errors appear in CMD CK and in the log. Recordings therefore change if a text changes.
        """
        first, fifth = (self._model.joints[k].replace("_", " ") for k in (0, 4))
        match found.outcome:
            case solutions.SHOULDER:
                return SingularityError(
                    f"the {fifth} joint stands {found.value:.2g} m from the {first} axis: shoulder singularity",
                    "shoulder",
                    found.value / float(self._links[L2] + self._links[L3] + self._links[L4]),
                )
            case solutions.WRIST:
                return SingularityError(
                    f"the {fifth} joint stands at +-90 deg: wrist singularity", "wrist", found.value
                )
            case solutions.OUT_OF_REACH:
                return _out_of_reach(found.value)
            case solutions.OUTSIDE:
                name, (low, high) = self._model.joints[found.joint], np.degrees(self._model.limits.hard[found.joint])
                return UnreachableError(
                    f"every solution lies outside the joint limits; the nearest needs {name} at "
                    f"{math.degrees(found.angle):.2f} deg, {math.degrees(found.value):.2f} deg outside "
                    f"{low:.1f} to {high:.1f} deg",
                    found.value,
                    name,
                )
        return pose_error(found.outcome, found.value, pose, near)


def _out_of_reach(excess: float) -> UnreachableError:
    """Return the error for a wrist out of reach; `excess` [m] is negative if the wrist is too close to the shoulder."""
    if excess > 0.0:
        return UnreachableError(f"the arm cannot reach this pose: its wrist is {excess:.4g} m too far out", excess)
    return UnreachableError(
        f"the arm cannot fold to this pose: its wrist is {-excess:.4g} m too close to the shoulder", -excess
    )
