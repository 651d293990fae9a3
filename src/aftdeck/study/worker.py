"""Worker process of a study: receives cases from a pipe, runs them and sends their results back."""

from __future__ import annotations

import contextlib
from multiprocessing.connection import Connection
from pathlib import Path
from typing import NamedTuple

from aftdeck.errors import AftdeckError
from aftdeck.law_folder import compiled_before
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.warm import warm_up
from aftdeck.study.case import Outcome, Runner
from aftdeck.study.design import Case
from aftdeck.study.plan import Plan
from aftdeck.study.watch import Watch

FIRST_STEPS = 3
"""Steps of a run that load the laws before the first case."""


class Job(NamedTuple):
    """A case to run, and the file to record it into."""

    case: Case
    recording: str = ""


class Ready(NamedTuple):
    """Message of a worker that has loaded the laws."""


class Done(NamedTuple):
    """Message of a worker: the result of a job, or the reason why its recording failed."""

    outcome: Outcome | None
    failure: str = ""


def work(pipe: Connection, plan: Plan, first: Case) -> None:
    """Run jobs until the pipe closes.

    Args:
        pipe: supplies `Job`s, and takes `Ready` and one `Done` for each job.
        plan: what all cases have in common.
        first: case whose scenario is used to load the laws.
    """
    runner = Runner(plan)
    prepare(runner, first)
    with contextlib.suppress(EOFError, OSError):
        pipe.send(Ready())
        while True:
            job: Job = pipe.recv()
            pipe.send(_done(runner, job))


def _done(runner: Runner, job: Job) -> Done:
    try:
        return Done(runner.run(job.case, Path(job.recording) if job.recording else None))
    except AftdeckError as error:
        return Done(None, str(error))


def prepare(runner: Runner, case: Case) -> None:
    """Load the laws by a few steps, so that they count for no run; compile them first if this was never done."""
    with contextlib.suppress(Exception):  # the case itself reports its errors
        scenario = runner.scenario(case)
        if not compiled_before():
            warm_up(scenario)
        sim, watch = Simulation(scenario, case.seed, digests=False), Watch(scenario)
        for _ in range(FIRST_STEPS):
            sim.advance()
            watch.see(sim)
