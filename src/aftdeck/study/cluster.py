"""Ray cluster: runs the cases of a study on several machines, with the same results as a pool on one machine."""

from __future__ import annotations

import os
import time
from collections import deque
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from typing import Any, NamedTuple

from aftdeck.law_folder import state_of_the_laws
from aftdeck.processes import ONE_THREAD
from aftdeck.study.case import Outcome, Runner
from aftdeck.study.design import Case
from aftdeck.study.failures import Failures, Finished, PoolError
from aftdeck.study.plan import Plan
from aftdeck.study.ray_connection import connected
from aftdeck.study.worker import Job, prepare
from aftdeck.version import __version__

POLL_S = 1.0
"""Longest wait for a result, before the runs that take too long are looked for [s]."""


class Actor:
    """Worker on a machine of the cluster; it keeps its scenarios and laws from case to case."""

    def __init__(self, plan: Plan, first: Case) -> None:
        os.environ.update(dict.fromkeys(ONE_THREAD, "1"))
        self._runner = Runner(plan)
        prepare(self._runner, first)

    def version(self) -> tuple[str, str]:
        """Return the version of Aftdeck and the digest of its laws; they are loaded when the call returns."""
        return __version__, state_of_the_laws()

    def run(self, case: Case) -> Outcome:
        """Run a case."""
        return self._runner.run(case)


class _Worker(NamedTuple):
    """An actor, and what it does: its job (None: it starts), and when that began."""

    actor: Any
    job: Job | None
    since: float


class Cluster:
    """Workers of one study on a Ray cluster; a context manager, which ends them."""

    def __init__(self, plan: Plan, address: str, limit_s: float, workers: int | None) -> None:
        """Connect to a cluster.

        Args:
            plan: what all cases have in common.
            address: ``auto`` for the cluster to which this machine belongs, ``local`` for a new one on this machine, or
                the address of a cluster.
            limit_s: longest time of a run by the wall clock [s].
            workers: number of workers; None: one for each core of the cluster.

        Raises:
            InputError: Ray is not installed, the cluster does not answer, or it does not accept the token.
        """
        self._plan, self._limit_s = plan, limit_s
        self._connection = ExitStack()
        self._ray: Any = self._connection.enter_context(connected(address, workers))
        self._count = workers or max(1, int(self._ray.cluster_resources().get("CPU", 1)))
        self._stored = self._ray.put(plan)
        self._busy: dict[Any, _Worker] = {}
        self._waiting: deque[Job] = deque()
        self._failures = Failures(plan)

    def __enter__(self) -> Cluster:
        return self

    def __exit__(self, *_: object) -> None:
        self._connection.close()

    def run(self, jobs: Sequence[Job]) -> Iterator[Finished]:
        """Run jobs and yield them as they finish; jobs with a recording are refused, because the files are elsewhere.

        Raises:
            PoolError: the workers die before they are ready.
        """
        assert not any(job.recording for job in jobs), "a recording is made on the machine that has the folder"
        self._waiting.extend(jobs)
        for _ in range(min(self._count, len(jobs))):
            self._start(jobs[0].case)
        while self._busy:
            self._ray.wait(list(self._busy), num_returns=1, timeout=POLL_S)
            ready, _ = self._ray.wait(list(self._busy), num_returns=len(self._busy), timeout=0)
            now = time.monotonic()
            for reference in ready:
                yield from self._done(reference, self._busy.pop(reference))
            for reference, worker in list(self._busy.items()):
                if worker.job is not None and now - worker.since > self._limit_s:
                    del self._busy[reference]
                    self._ray.kill(worker.actor)
                    yield self._failures.too_long(worker.job, self._limit_s)
                    self._start(worker.job.case)

    def _start(self, first: Case) -> None:
        """Start a worker, if a job is left for it."""
        if self._waiting:
            actor = self._ray.remote(num_cpus=1)(Actor).remote(self._stored, first)
            self._busy[actor.version.remote()] = _Worker(actor, None, time.monotonic())

    def _give(self, actor: Any) -> None:
        """Give a worker its next job; end it if no job is left."""
        if self._waiting:
            job = self._waiting.popleft()
            self._busy[actor.run.remote(job.case)] = _Worker(actor, job, time.monotonic())
        else:
            self._ray.kill(actor)

    def _done(self, reference: Any, worker: _Worker) -> Iterator[Finished]:
        """Yield the result of a job, and give the worker the next one; replace a worker that has died."""
        try:
            result = self._ray.get(reference)
        except self._ray.exceptions.RayError as error:
            yield from self._dead(worker, str(error).splitlines()[0])
            return
        if worker.job is None:
            self._failures.ready()
            if result != (__version__, state_of_the_laws()):
                raise PoolError(
                    f"a machine of the cluster has Aftdeck {result[0]}, laws {result[1]}; this one has {__version__}, "
                    f"laws {state_of_the_laws()}: install the same version everywhere"
                )
        self._give(worker.actor)
        if worker.job is not None:
            yield Finished(worker.job, result)

    def _dead(self, worker: _Worker, why: str) -> Iterator[Finished]:
        job = worker.job
        if job is None:
            self._failures.not_started(f"Ray workers ended before they were ready: {why}")
            if self._waiting:
                self._start(self._waiting[0].case)
            return
        given_up = self._failures.died(job, f": {why}")
        if given_up is None:
            self._waiting.appendleft(job)
        else:
            yield given_up
        self._start(job.case)
