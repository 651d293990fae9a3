"""Failures of a study's workers, which processes of this machine and Ray have in common."""

from __future__ import annotations

from typing import NamedTuple

from aftdeck.errors import AftdeckError
from aftdeck.study.case import Outcome
from aftdeck.study.plan import Plan
from aftdeck.study.result import row_of
from aftdeck.study.worker import Job

MOST_DEATHS = 2
"""Number of workers that may die in the same case; the case is then recorded with an error."""
MOST_FAILED_STARTS = 3
"""Number of workers that may die one after the other before they are ready; the study then ends."""


class PoolError(AftdeckError):
    """Workers that cannot be started."""


class Finished(NamedTuple):
    """A finished job: its outcome, or the reason why its recording failed."""

    job: Job
    outcome: Outcome | None
    failure: str = ""


class Failures:
    """Count of the workers of one study that died, in each case and before they were ready."""

    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        self._deaths: dict[int, int] = {}
        self._failed_starts = 0

    def ready(self) -> None:
        """Note that a worker is ready."""
        self._failed_starts = 0

    def not_started(self, what: str) -> None:
        """Count a worker that died before it was ready; `what` says what died and why, for the message.

        Raises:
            PoolError: too many have died one after the other.
        """
        self._failed_starts += 1
        if self._failed_starts >= MOST_FAILED_STARTS:
            raise PoolError(f"{MOST_FAILED_STARTS} {what}")

    def died(self, job: Job, why: str) -> Finished | None:
        """Count a worker that died in a job; return the job's end if it is given up, or None if it runs again."""
        index = job.case.index
        self._deaths[index] = self._deaths.get(index, 0) + 1
        if self._deaths[index] < MOST_DEATHS:
            return None
        return self._ended(job, f"WorkerDied: {MOST_DEATHS} worker processes ended in this case{why}")

    def too_long(self, job: Job, limit_s: float) -> Finished:
        """Return the end of a job that took longer than the study allows [s]."""
        return self._ended(job, f"TooLong: ended after {limit_s:g} s, the study's limit", limit_s)

    def _ended(self, job: Job, why: str, wall_s: float = 0.0) -> Finished:
        return Finished(job, Outcome(row_of(self._plan, job.case, {"error": why}), wall_s))
