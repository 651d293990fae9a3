"""Score of a step of Capture, Extract or Dock: its reward, and whether its task may be complete."""

from __future__ import annotations

from math import inf

import numpy as np
from msgspec.structs import replace

from aftdeck.arrays import Array, Flags
from aftdeck.gym.mission import definition
from aftdeck.law import law
from aftdeck.scenario.task_file import StateSpec
from aftdeck.simulation.parts.worksite_state import WorksiteState

AIMS = 0
"""1 if there is a place to move to."""
DISTANCE, ANGLE = 1, 2
"""Distance [m] and rotation [rad] that the tip, or the held payload, still has to move."""
ABOVE = 3
"""Distance above the capture pose or the seat, along the way out [m]."""
MET = 4
"""Share of the conditions of capture or docking that hold; 0 without one."""
CONTACT = 5
"""1 if a detrimental contact exists."""
SCORED = 6
"""What is observed of a state for its score: the values above, and their number."""

_TIME = definition.TIME.weight * definition.PERIOD
_CONTACT = definition.CONTACT.weight * definition.PERIOD
_DISTANCE, _ROTATION, _SUCCESS = (one.weight for one in (definition.DISTANCE, definition.ROTATION, definition.SUCCESS))
ROUNDING = 1e-6
"""Greatest difference, by rounding, of a distance [m] or an angle [rad] that is computed in two ways."""


@law
def reward(before: Array, after: Array, success: float) -> float:
    """Return the reward of a step.

    Args:
        before: (6,) what was observed before the step.
        after: (6,) what is observed after it.
        success: 1 if the step has completed the task, else 0.
    """
    total = _TIME + _SUCCESS * success + _CONTACT * after[CONTACT]
    if before[AIMS] != 0.0 and after[AIMS] != 0.0:
        total += _DISTANCE * (before[DISTANCE] - after[DISTANCE])
        total += _ROTATION * (before[ANGLE] - after[ANGLE])
    return float(total)


def limits_of(wanted: StateSpec) -> Array:
    """Return what the state that a step names needs of `ABOVE`, `DISTANCE`, `ANGLE` and `MET`, for `may_be_done`."""
    rounding = 0.0 if is_decided(wanted) else ROUNDING
    above = -inf if wanted.above is None else float(wanted.above) - rounding
    distance = inf if wanted.within is None else float(wanted.within) + rounding
    angle = inf if wanted.within_angle is None else float(wanted.within_angle) + rounding
    return np.array([above, distance, angle, 1.0 if wanted.ready else 0.0])


_DECIDING = ("held", "berth", "above", "within", "within_angle")


def is_decided(wanted: StateSpec) -> bool:
    """Return whether `may_be_done` and `may_hold` decide whether a step is complete, so that no frame is needed."""
    rest = replace(wanted, ready=None if wanted.ready else wanted.ready, **dict.fromkeys(_DECIDING))
    return rest == StateSpec()


@law
def may_be_done(limits: Array, scored: Array) -> bool:
    """Return whether a step of a task may be complete: False if it certainly is not.

    Args:
        limits: (4,) from `limits_of`.
        scored: (6,) what is observed.
    """
    return bool(
        scored[ABOVE] >= limits[0]
        and scored[DISTANCE] <= limits[1]
        and scored[ANGLE] <= limits[2]
        and scored[MET] >= limits[3]
    )


def may_hold(wanted: StateSpec, worksite: WorksiteState) -> bool:
    """Return False if payloads are not where the state that a step names needs them: in the grasp, or in a berth."""
    held = [payload for payload in worksite.payloads if payload.held]
    return wanted.held in (None, bool(held)) and (
        wanted.berth is None or any(payload.berth == wanted.berth for payload in held or worksite.payloads)
    )


@law
def score_all(limits: Array, before: Array, after: Array, chosen: Flags, rewards: Array, done: Flags) -> None:
    """Write the rewards of n steps that have not completed their tasks, and which of them may have.

    Args:
        limits: (4,) from `limits_of`.
        before: (n, 6) what was observed before the steps.
        after: (n, 6) what is observed after them.
        chosen: (n,) whether there was a step.
        rewards: (n,) output; only those of chosen steps are written.
        done: (n,) output, the same.
    """
    for i in range(len(chosen)):
        if chosen[i]:
            rewards[i], done[i] = reward(before[i], after[i], 0.0), may_be_done(limits, after[i])
