"""Environments that make their steps together, and the result of such a step."""

from __future__ import annotations

from typing import NamedTuple, Protocol

from aftdeck.arrays import Array, Flags
from aftdeck.errors import InputError
from aftdeck.gym.terms import Floats32

NEXT_STEP, SAME_STEP, DISABLED = 0, 1, 2
"""When an environment whose episode has ended is reset: in the next step, at once, or by the caller."""
UNLIMITED = 2**53
"""Number of steps that no episode reaches."""


class NoStartError(InputError):
    """No random start of an episode is possible. The environments have to be reset."""


class Step(NamedTuple):
    """Result of a step of n environments.

    Attributes:
        observations: (n, m).
        rewards: (n,).
        terminated: (n,) whether the episode is over.
        truncated: (n,) whether the episode has reached its greatest number of steps.
        reached: (n,) whether the task was completed in this step.
        final: (n, m) with SAME_STEP, the last observation of each episode that has ended.
        ended: number of episodes that have ended.
    """

    observations: Floats32
    rewards: Array
    terminated: Flags
    truncated: Flags
    reached: Flags
    final: Floats32
    ended: int


class EnvBatch(Protocol):
    """Environments that make their steps together."""

    def seed(self, keys: list[int | None]) -> None:
        """Give each environment its key, and begin with its first episode; None changes nothing."""

    def begin(self, chosen: Flags) -> Floats32:
        """Begin the next episode in the chosen environments (n,); return all observations (n, m)."""

    def step(self, actions: object, autoreset: int) -> Step:
        """Make one step of all environments.

        Args:
            actions: (n, controls) numbers in [-1, 1].
            autoreset: NEXT_STEP, SAME_STEP or DISABLED.

        Raises:
            InputError: the actions have another shape, or a control is outside [-1, 1]; nothing has changed.
            NoStartError: an episode cannot begin.
        """
