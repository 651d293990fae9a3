"""A whole study: runs the cases that are missing, writes the tables, and runs the worst cases with a recording."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from aftdeck.errors import InputError
from aftdeck.processes import cores
from aftdeck.study.case import Outcome, Runner
from aftdeck.study.cluster import Cluster
from aftdeck.study.design import cases
from aftdeck.study.failures import Finished
from aftdeck.study.file import Study
from aftdeck.study.plan import plan_of
from aftdeck.study.pool import Pool
from aftdeck.study.report import write_report
from aftdeck.study.store import Store
from aftdeck.study.table import write_tables
from aftdeck.study.worker import Job
from aftdeck.study.worst import recording_of, worst

Execute = Callable[[Sequence[Job]], Iterator[Finished]]
"""What runs jobs: a pool of processes, or Ray."""


class Progress(NamedTuple):
    """How far a study is.

    Attributes:
        done: number of finished cases, with those of earlier calls.
        failed: number of those with an error.
        cases: number of all cases.
    """

    done: int
    failed: int
    cases: int


def run_study(
    study: Study,
    folder: Path,
    *,
    jobs: int | None = None,
    ray: str | None = None,
    retry: bool = False,
    progress: Callable[[Progress], None] | None = None,
) -> list[Outcome]:
    """Run the cases of a study that a folder lacks, and write its tables and recordings.

    The call can be interrupted at any moment; the next call continues.

    Args:
        study: the study.
        folder: folder of the results; it is created if it is missing.
        jobs: number of processes; None: one for each core.
        ray: address of a Ray cluster that runs the cases; None: processes of this machine.
        retry: whether to run cases again that ended with an error.
        progress: called at the beginning, and after every case.

    Returns:
        The results of all cases, in order.

    Raises:
        StoreError: the folder has results of another study, or cannot be written.
        PoolError: the worker processes cannot be started.
        InputError: a library is not installed.
    """
    plan, limit_s = plan_of(study), float(study.spec.limit)
    with Store(folder, study) as store, Pool(plan, jobs or cores(), limit_s) as pool:
        if retry:
            store.drop_failed()
        if ray is None:
            fill(study, store, pool.run, progress)
        else:
            with Cluster(plan, ray, limit_s, jobs) as cluster:
                fill(study, store, cluster.run, progress)
        outcomes = store.outcomes()
        record_worst(study, outcomes, folder, pool.run)  # on this machine, which has the folder
    write_report(study, outcomes, folder)
    return outcomes


def fill(study: Study, store: Store, execute: Execute, progress: Callable[[Progress], None] | None = None) -> None:
    """Run the cases that a store lacks, and write the tables, also if the study is interrupted."""
    every = cases(study)
    missing = [Job(case) for case in every if case.index not in store.done]
    failed = sum(bool(outcome.row["error"]) for outcome in store.outcomes())
    done = len(every) - len(missing)

    def report() -> None:
        if progress is not None:
            progress(Progress(done, failed, len(every)))

    report()
    try:
        for finished in execute(missing) if missing else ():
            if finished.outcome is None:
                raise InputError(finished.failure)
            store.add(finished.job.case.index, finished.outcome)
            done += 1
            failed += bool(finished.outcome.row["error"])
            report()
    finally:
        write_tables(study, store.outcomes(), store.folder)


def record_worst(study: Study, outcomes: Sequence[Outcome], folder: Path, execute: Execute) -> None:
    """Run the worst cases again, each with a recording, unless it exists already; a failure leaves it without one."""
    every = cases(study)
    paths = {index: recording_of(folder, index) for index in worst(study, [outcome.row for outcome in outcomes])}
    wanted = [Job(every[index], str(path)) for index, path in paths.items() if not path.exists()]
    for _ in execute(wanted) if wanted else ():
        pass


def run_only(study: Study, folder: Path, index: int) -> tuple[Outcome, Path]:
    """Run one case in this process, with a recording; an older recording of the case is replaced.

    Returns:
        The result, and the path of the recording.

    Raises:
        InputError: there is no such case.
        RecordingError: the recording cannot be written.
    """
    every = cases(study)
    if not 0 <= index < len(every):
        raise InputError(f"no case {index}; the study has the cases 0 to {len(every) - 1}")
    path = recording_of(folder, index)
    return Runner(plan_of(study)).run(every[index], path), path
