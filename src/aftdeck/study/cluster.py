"""Ray cluster: runs the cases of a study on several machines, with the same results as a pool on one machine."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence

from aftdeck.study.case import Outcome, Runner
from aftdeck.study.design import Case
from aftdeck.study.plan import Plan
from aftdeck.study.pool import ONE_THREAD, Finished
from aftdeck.study.worker import Job, prepare


class Actor:
    """Worker on a machine of the cluster; it keeps its scenarios and laws from case to case."""

    def __init__(self, plan: Plan, first: Case) -> None:
        os.environ.update(dict.fromkeys(ONE_THREAD, "1"))
        self._runner = Runner(plan)
        prepare(self._runner, first)

    def run(self, case: Case) -> Outcome:
        """Run a case."""
        return self._runner.run(case)


class Cluster:
    """Workers of one study on a Ray cluster; a context manager, which ends them."""

    def __init__(self, plan: Plan, address: str, limit_s: float, workers: int | None) -> None:
        """Connect to a cluster.

        Args:
            plan: what all cases have in common.
            address: ``auto`` for a cluster that runs on this machine, ``local`` for a new one, or an address.
            limit_s: longest time of a run by the wall clock [s].
            workers: number of workers; None: one for each core of the cluster.

        Raises:
            InputError: Ray is not installed, or the cluster does not answer.
        """
        raise NotImplementedError

    def __enter__(self) -> Cluster:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def run(self, jobs: Sequence[Job]) -> Iterator[Finished]:
        """Run jobs and yield them as they finish."""
        raise NotImplementedError
