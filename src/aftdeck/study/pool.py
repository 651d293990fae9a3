"""Pool of worker processes: survives workers that die, and ends runs that take too long."""

from __future__ import annotations

import contextlib
import multiprocessing.connection
import signal
import subprocess
import time
from collections import deque
from collections.abc import Iterator, Sequence

from aftdeck.law_folder import compiled_before
from aftdeck.processes import Child
from aftdeck.study.failures import Failures, Finished
from aftdeck.study.plan import Plan
from aftdeck.study.worker import Done, Job, Ready, work

START_S = 900.0
"""Longest time until a worker is ready [s]; to compile all laws takes a minute."""


class _Worker(Child):
    """A worker process and its present job."""

    def __init__(self, plan: Plan, job: Job) -> None:
        super().__init__(work, plan, job.case)
        self.ready = False
        self.job: Job | None = None
        self.since = time.monotonic()  # begin of the start, then of the job

    def give(self, job: Job) -> None:
        """Send a job; a worker that has died is found by its closed pipe later."""
        self.job, self.since = job, time.monotonic()
        try:
            self.pipe.send(job)
        except OSError:
            return

    def end_of_process(self) -> str:
        """Wait for the end of a process that has closed its pipe, and return the reason in words."""
        with contextlib.suppress(subprocess.TimeoutExpired):
            self.process.wait(5.0)
        self.kill()
        code = self.process.returncode
        return f"signal {-code} ({signal.Signals(-code).name})" if code < 0 else f"exit code {code}"


class Pool:
    """Pool of workers for one study; a context manager, which ends all workers."""

    def __init__(self, plan: Plan, processes: int, limit_s: float) -> None:
        """Set up the pool; `run` starts the workers.

        Args:
            plan: what all cases have in common.
            processes: number of worker processes.
            limit_s: longest time of a run by the wall clock [s].
        """
        self._plan, self._processes, self._limit_s = plan, processes, limit_s
        self._workers: list[_Worker] = []
        self._waiting: deque[Job] = deque()
        self._failures = Failures(plan)

    def __enter__(self) -> Pool:
        return self

    def __exit__(self, *_: object) -> None:
        for worker in self._workers:
            worker.kill()
        self._workers.clear()

    @property
    def busy(self) -> tuple[int, ...]:
        """Process ids of the workers that run a job."""
        return tuple(worker.process.pid for worker in self._workers if worker.job is not None)

    @property
    def pids(self) -> tuple[int, ...]:
        """Process ids of the workers."""
        return tuple(worker.process.pid for worker in self._workers)

    def run(self, jobs: Sequence[Job]) -> Iterator[Finished]:
        """Run jobs and yield them as they finish.

        Raises:
            PoolError: the workers die before they are ready.
        """
        self._waiting.extend(jobs)
        while self._waiting or any(worker.job for worker in self._workers):
            self._start()
            for worker in self._workers:
                if worker.ready and worker.job is None and self._waiting:
                    worker.give(self._waiting.popleft())
            readable = multiprocessing.connection.wait([worker.pipe for worker in self._workers], self._patience())
            for worker in list(self._workers):
                if worker.pipe in readable:
                    yield from self._message(worker)
                elif worker.job is not None and time.monotonic() - worker.since > self._limit_s:
                    yield self._too_long(worker, worker.job)
                elif not worker.ready and time.monotonic() - worker.since > START_S:
                    worker.process.kill()

    def _start(self) -> None:
        """Start workers; the first one alone if the laws have to be compiled, so that they are compiled once."""
        wanted = min(self._processes, len(self._waiting) + sum(worker.job is not None for worker in self._workers))
        if self._workers and not all(worker.ready for worker in self._workers) and not compiled_before():
            return
        while len(self._workers) < wanted and self._waiting:
            self._workers.append(_Worker(self._plan, self._waiting[0]))
            if not compiled_before():
                return

    def _patience(self) -> float:
        """Return the time until the next run reaches its limit [s]; at most a second, to start workers again."""
        now = time.monotonic()
        left = [worker.since + self._limit_s - now for worker in self._workers if worker.job is not None]
        return max(0.0, min([1.0, *left]))

    def _message(self, worker: _Worker) -> Iterator[Finished]:
        try:
            message = worker.pipe.recv()
        except (EOFError, OSError):
            yield from self._dead(worker)
            return
        if isinstance(message, Ready):
            worker.ready = True
            self._failures.ready()
        elif isinstance(message, Done) and worker.job is not None:
            job, worker.job = worker.job, None
            yield Finished(job, message.outcome, message.failure)

    def _dead(self, worker: _Worker) -> Iterator[Finished]:
        """Give the job of a dead worker to another one, or give it up if it has ended several workers."""
        self._workers.remove(worker)
        why, job = worker.end_of_process(), worker.job
        if not worker.ready:
            self._failures.not_started(f"worker processes ended before they were ready, the last by {why}")
        if job is None:
            return
        given_up = self._failures.died(job, f", the last by {why}")
        if given_up is None:
            self._waiting.appendleft(job)
        else:
            yield given_up

    def _too_long(self, worker: _Worker, job: Job) -> Finished:
        self._workers.remove(worker)
        worker.kill()
        return self._failures.too_long(job, self._limit_s)
