"""Benchmark of studies: time of a case and of its parts, and how much faster two processes are than one."""

from __future__ import annotations

import importlib.util
import os
import tempfile
import time
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

import aftdeck
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.run import Simulation
from aftdeck.study.case import Runner
from aftdeck.study.cluster import Cluster
from aftdeck.study.design import cases
from aftdeck.study.failures import Finished
from aftdeck.study.file import Study, load_study
from aftdeck.study.plan import plan_of
from aftdeck.study.pool import Pool
from aftdeck.study.worker import Job
from benchmarks.measure import Figure, absent, against
from benchmarks.ray_nodes import nodes

LIMIT_S = 600.0
EFFICIENT = 0.8
"""Promised efficiency of two processes: half the ratio of their throughput to that of one."""
METRICS = 1.9
"""Promised time of a case, as a share of the time of its simulation with frames."""


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        kinematic: scenario without masses: the whole problem of 1972.
        cases: number of cases of a throughput measurement; the first case of each worker does not count.
        rigid: scenario that is run with rigid bodies, half as many times.
        rounds: number of runs; the shortest counts.
        duration: duration of a run; empty for that of the scenario.
    """

    kinematic: str
    cases: int
    rigid: str
    rounds: int
    duration: str


FULL = Size("concept-1972-script", 60, "sts-400-closed", 5, "")
TINY = Size("sts-400-position", 6, "sts-400-position", 1, "1 s")
RIGID = '[[factor]]\nkey = "plant"\nlevels = ["rigid"]\n'
"""Part of a study file: the plant of all runs."""


def studies(size: Size) -> list[Figure]:
    """Measure a case of the whole problem of 1972 and its parts, and the throughput of one and two processes."""
    scenario = aftdeck.load_scenario(size.kinematic, {("duration",): size.duration} if size.duration else None)
    study = _study(size.kinematic, size.cases, size)
    runner, (first, *_) = Runner(plan_of(study)), cases(study)
    rounds = [
        (_alone(scenario, frames=False), _alone(scenario, frames=True), runner.run(first).wall_s)
        for _ in range(size.rounds)
    ]
    motion, flown, whole = map(min, zip(*rounds, strict=True))
    frames = Figure("a case, with its frames", flown * 1e3, "ms")
    return [
        Figure("a case, simulation alone", motion * 1e3, "ms", None, f"{size.kinematic}, without digests"),
        frames,
        against(frames, METRICS, "a case, with its metrics", whole * 1e3, "ms", "what a worker does"),
        *_throughput("1,000 cases", study),
        *_throughput("1,000 cases with rigid bodies", _study(size.rigid, size.cases // 2, size, RIGID)),
    ]


def _throughput(name: str, study: Study) -> list[Figure]:
    """Measure the throughput of one and of two processes."""
    one, two = (_each_by_pool(study, workers) for workers in (1, 2))
    alone = Figure(f"{name}, one process", one * 1000 / 60, "min")
    share = 1.0 / EFFICIENT / min(2, os.cpu_count() or 1)
    return [
        alone,
        against(alone, share, f"{name}, two processes", two * 1000 / 60, "min", _efficiency(one, two)),
    ]


def on_ray(size: Size) -> list[Figure]:
    """Measure the throughput of one and two nodes of a Ray cluster, beside the pool."""
    if importlib.util.find_spec("ray") is None:
        return [absent("two nodes of Ray", "ratio", "install ray (extra `aftdeck[ray]`)")]
    study = _study(size.kinematic, size.cases, size)
    found: list[Figure] = []
    with tempfile.TemporaryDirectory(prefix="ray") as folder, nodes(2, 6391, Path(folder)) as address:
        seconds = []
        for workers in (1, 2):
            pool = _each_by_pool(study, workers)
            with Cluster(plan_of(study), address, LIMIT_S, workers) as cluster:
                each, memory = _each(cluster.run([Job(case) for case in cases(study)]), workers)
            seconds.append(each)
            note = f"the pool {pool * 1e3:.0f} ms; {memory:.0f} MB a worker"
            found.append(Figure(f"a case, Ray, {workers} nodes", each * 1e3, "ms", None, note))
        found.append(Figure("two nodes of Ray", 2.0 * seconds[1] / seconds[0], "ratio", None, _efficiency(*seconds)))
    return found


def _efficiency(one: float, two: float) -> str:
    return f"one takes {one * 1e3:.0f} ms a case, two {two * 1e3:.0f} ms: efficiency {one / two / 2:.0%}"


def _study(scenario: str, repeats: int, size: Size, more: str = "") -> Study:
    """Return a study that runs a scenario a number of times."""
    if size.duration:
        more += f'[[factor]]\nkey = "duration"\nlevels = ["{size.duration}"]\n'
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "study.toml"
        path.write_text(f'title = "Benchmark"\nscenario = "{scenario}"\nrepeats = {repeats}\n{more}', encoding="utf-8")
        return load_study(path)


def _alone(scenario: Scenario, *, frames: bool) -> float:
    """Return the time of a run in this process [s]."""
    begin = time.perf_counter()
    sim = Simulation(scenario, digests=False)
    while not sim.ended:
        sim.advance()
        if frames:
            sim.look()
    return time.perf_counter() - begin


def _each_by_pool(study: Study, workers: int) -> float:
    """Return the time of a case by the wall clock, with a number of processes [s]."""
    with Pool(plan_of(study), workers, LIMIT_S) as pool:
        return _each(pool.run([Job(case) for case in cases(study)]), workers)[0]


def _each(finished: Iterable[Finished], workers: int) -> tuple[float, float]:
    """Return the mean time of a case by the wall clock [s], and the greatest memory of a worker [MB].

    The first case of each worker does not count.
    """
    times, memory = [], 0.0
    for done in finished:
        assert done.outcome is not None and not done.outcome.row["error"], done
        times.append(time.perf_counter())
        memory = max(memory, done.outcome.peak_memory_mb)
    return (times[-1] - times[workers - 1]) / (len(times) - workers), memory
