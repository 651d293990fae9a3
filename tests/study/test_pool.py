"""Pool of processes: the same results as one process, whatever happens to the workers."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import time
from pathlib import Path

import pytest

from aftdeck.report.table import Row
from aftdeck.study.case import Outcome, Runner
from aftdeck.study.design import cases
from aftdeck.study.file import Study
from aftdeck.study.plan import Plan, plan_of
from aftdeck.study.pool import Pool
from aftdeck.study.worker import Done, Job, Ready
from tests.study.studies import FOUR, loaded

ENDLESS = """
title = "One endless run"
scenario = "short.toml"
limit = "20 s"

[[factor]]
name = "length"

[[factor.level]]
name = "short"
set = {}

[[factor.level]]
name = "endless"
set = { duration = 80000, "phase[0].duration" = 80000 }

[[factor.level]]
name = "wrong"
set = { duration = 0.03 }

[[factor.level]]
name = "last"
set = { rate = "vernier" }
"""
"""Study in which one run would take hours, and one scenario cannot be built."""


def in_this_process(study: Study) -> list[Row]:
    runner = Runner(plan_of(study))
    return [runner.run(case).row for case in cases(study)]


@pytest.fixture
def study(tmp_path: Path) -> Study:
    return loaded(tmp_path, FOUR.replace("repeats = 2", "repeats = 6"))


@pytest.mark.slow
def test_pool_gives_the_results_of_one_process_although_a_worker_is_killed(study: Study) -> None:
    rows: list[Row] = []
    with Pool(plan_of(study), 2, 600.0) as pool:
        for finished in pool.run([Job(case) for case in cases(study)]):
            assert finished.outcome is not None
            rows.append(finished.outcome.row)
            if len(rows) == 3:
                os.kill(pool.pids[0], signal.SIGKILL)
    assert sorted(rows, key=lambda row: int(str(row["index"]))) == in_this_process(study)


def test_job_of_a_worker_that_dies_runs_next(study: Study, monkeypatch: pytest.MonkeyPatch) -> None:
    """The workers are no processes: the first one closes its pipe in its second job, the next one runs all jobs."""
    given: list[int] = []

    class Worker:
        def __init__(self, plan: Plan, job: Job) -> None:
            self.pipe, self._far = multiprocessing.Pipe()
            self._far.send(Ready())
            self.ready, self.since = False, time.monotonic()
            self.job: Job | None = None

        def give(self, job: Job) -> None:
            self.job = job
            given.append(job.case.index)
            if len(given) == 2:
                self._far.close()
            else:
                self._far.send(Done(Outcome({"index": job.case.index}, 0.0)))

        def end_of_process(self) -> str:
            return "exit code 1"

        def kill(self) -> None:
            self.pipe.close()
            self._far.close()

    monkeypatch.setattr("aftdeck.study.pool._Worker", Worker)
    jobs = [Job(case) for case in cases(study)]
    with Pool(plan_of(study), 1, 60.0) as pool:
        finished = [done.job for done in pool.run(jobs)]
    assert finished == jobs
    assert given == [0, 1, *range(1, len(jobs))]


@pytest.mark.slow
def test_run_that_hangs_or_fails_does_not_end_the_study(tmp_path: Path) -> None:
    study = loaded(tmp_path, ENDLESS)
    with Pool(plan_of(study), 2, 5.0) as pool:
        finished = list(pool.run([Job(case) for case in cases(study)]))
        pids = pool.pids
    errors = {done.job.case.index: str(done.outcome.row["error"]) for done in finished if done.outcome}
    assert len(finished) == len(errors) == 4
    assert [errors[index].partition(":")[0] for index in range(4)] == ["", "TooLong", "ScenarioError", ""]
    for pid in pids:
        with pytest.raises(ProcessLookupError):
            os.kill(pid, 0)


@pytest.mark.slow
def test_case_that_ends_its_worker_is_recorded_with_the_signal(tmp_path: Path) -> None:
    study = loaded(tmp_path, ENDLESS)
    endless = cases(study)[1]
    with Pool(plan_of(study), 1, 600.0) as pool:
        jobs = pool.run([Job(cases(study)[0]), Job(endless)])
        next(jobs)
        killer = _Killer(pool)
        with killer:
            (finished,) = jobs
    assert finished.outcome is not None
    assert "SIGKILL" in str(finished.outcome.row["error"])
    assert killer.killed == 2


class _Killer:
    """Kills each worker of a pool as soon as it has had a job for a moment."""

    def __init__(self, pool: Pool) -> None:
        self._pool, self.killed = pool, 0
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._work)

    def __enter__(self) -> None:
        self._thread.start()

    def __exit__(self, *_: object) -> None:
        self._over.set()
        self._thread.join()

    def _work(self) -> None:
        done: set[int] = set()
        while not self._over.wait(0.1):
            for pid in set(self._pool.busy) - done:
                os.kill(pid, signal.SIGKILL)
                done.add(pid)
                self.killed += 1
