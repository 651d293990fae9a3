"""General solver of an arm that has no closed form, for many poses at a time, and its errors."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from aftdeck.arms.geometry import GENERAL
from aftdeck.arms.load import ArmModel
from aftdeck.arms.rank import spread
from aftdeck.arrays import Array
from aftdeck.errors import UnreachableError
from aftdeck.kinematics.chain.many import distances_many, forward_many, jacobian_many, rates_many, search_from
from aftdeck.kinematics.closed import ClosedForm
from aftdeck.kinematics.linkage import WRIST
from aftdeck.kinematics.solutions import FOUND, examine, pose_error

REACHED = 1e-9
"""Greatest miss of a pose that counts as reached [m], [rad]."""
STARTS = 12
"""Number of poses from which a search begins, besides the given one, before a pose counts as out of reach."""


class Rank(NamedTuple):
    """Distance (...) from a singularity of an arm without a closed form, in [0, 1].

    Attributes:
        rank: how well the arm moves its tip in the direction in which it moves it worst, as a share of the best one.
    """

    rank: Array


class GeneralForm:
    """Solver of any chain; `Arm` describes what its methods return, and `ClosedForm` their conventions."""

    def __init__(self, model: ArmModel) -> None:
        self._model, self._links = model, model.links

    def forward(self, rows: Array, position: Array, rotation: Array) -> bool:
        """Compute the tip's poses."""
        return forward_many(self._links, rows, position, rotation)

    def jacobian(self, rows: Array, matrix: Array) -> bool:
        """Compute the Jacobians."""
        return jacobian_many(self._links, rows, matrix)

    def rates(self, rows: Array, twists: Array, rates: Array, singular: NDArray[np.bool_]) -> bool:
        """Compute the rates of the joints, and whether each pose is singular."""
        return rates_many(self._links, rows, twists, rates, singular)

    def distances(self, rows: Array, shape: tuple[int, ...]) -> Rank | None:
        """Return the distances from a singularity; None if a coordinate is not finite."""
        result = np.empty((1, len(rows)))
        return Rank(result.reshape(shape)) if distances_many(self._links, rows, result) else None

    def solve(self, pose: Array, near: Array, _turned: bool, limited: bool) -> Array:
        """Return the coordinates (1, n) that a search finds for a pose (12,), from `near` or else from other poses.

        The search stays inside the hard stops if `limited`; otherwise turning joints have no stops.
        """
        outcome, value = examine(pose, near)
        if outcome != FOUND:
            raise pose_error(outcome, value, pose, near)
        limits = self._model.limits.hard if limited else self._free()
        best, least = np.inf, (np.inf, np.inf)
        for start in (near, *spread(self._model.limits.hard, STARTS)):
            q = start.copy()
            found = search_from(self._links, pose, limits, q)
            if max(found.distance, found.turn) <= REACHED:
                return self._within_a_turn(q, near)[None] if not limited else q[None]
            if found.distance + found.turn < best:
                best, least = found.distance + found.turn, (found.distance, found.turn)
        raise UnreachableError(
            f"the arm cannot reach this pose: it comes within {least[0]:.4g} m and {math.degrees(least[1]):.4g} deg",
            least[0],
        )

    def _within_a_turn(self, q: Array, near: Array) -> Array:
        """Return coordinates with each angle in the revolution nearest to `near`."""
        turned = np.where(self._model.linkage.slides, 0.0, np.round((near - q) / math.tau))
        return np.asarray(q + math.tau * turned)

    def _free(self) -> Array:
        """Return the hard stops of the joints that slide, and none for those that turn."""
        limits = self._model.limits.hard.copy()
        limits[~np.array(self._model.linkage.slides)] = -np.inf, np.inf
        return limits


def solver_of(model: ArmModel) -> ClosedForm | GeneralForm:
    """Return the solver of an arm: a closed form if it has one."""
    return GeneralForm(model) if model.links[WRIST] == GENERAL else ClosedForm(model)
