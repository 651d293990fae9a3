"""Ray: the same results as one process, whatever happens to the workers."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import nullcontext
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from aftdeck.report.table import Row
from aftdeck.study import cluster
from aftdeck.study.case import Runner
from aftdeck.study.cluster import Cluster
from aftdeck.study.design import cases
from aftdeck.study.failures import PoolError
from aftdeck.study.file import Study
from aftdeck.study.plan import plan_of
from aftdeck.study.worker import Job
from tests.study.studies import loaded


class FakeError(Exception):
    """Error of the fake Ray."""


class FakeRay:
    """Ray in this process: a call runs when its result is fetched; some calls fail, some never end."""

    exceptions = SimpleNamespace(RayError=FakeError)

    def __init__(self, broken: Callable[[str, Any], str]) -> None:
        self._broken = broken
        self.killed, self.now = 0, 0.0

    def cluster_resources(self) -> dict[str, float]:
        return {"CPU": 2.0}

    def put(self, value: Any) -> Any:
        return value

    def remote(self, **_: Any) -> Callable[[type], Any]:
        return lambda kind: SimpleNamespace(remote=lambda *given: self._actor(kind(*given)))

    def _actor(self, worker: Any) -> Any:
        def method(name: str) -> Any:
            return SimpleNamespace(remote=lambda *given: _Call(name, given, getattr(worker, name)))

        return SimpleNamespace(version=method("version"), run=method("run"))

    def wait(self, calls: list[Any], num_returns: int, timeout: float) -> tuple[list[Any], list[Any]]:
        ready = [call for call in calls if self._broken(call.name, call.given) != "hangs"]
        if not ready:
            self.now += timeout
        return ready[:num_returns], []

    def get(self, call: Any) -> Any:
        how = self._broken(call.name, call.given)
        if how == "dies":
            raise FakeError("the actor died")
        return how if how else call.function(*call.given)

    def kill(self, _: Any) -> None:
        self.killed += 1


class _Call:
    def __init__(self, name: str, given: tuple[Any, ...], function: Callable[..., Any]) -> None:
        self.name, self.given, self.function = name, given, function


def rows_with(study: Study, ray: FakeRay, monkeypatch: pytest.MonkeyPatch) -> list[Row]:
    monkeypatch.setattr(cluster, "connected", lambda *_: nullcontext(ray))
    monkeypatch.setattr(cluster, "time", SimpleNamespace(monotonic=lambda: ray.now))
    with Cluster(plan_of(study), "auto", 60.0, None) as workers:
        rows = [done.outcome.row for done in workers.run([Job(case) for case in cases(study)]) if done.outcome]
    return sorted(rows, key=lambda row: int(str(row["index"])))


@pytest.fixture
def study(tmp_path: Path) -> Study:
    return loaded(tmp_path)


def test_cluster_gives_the_results_of_one_process(study: Study, monkeypatch: pytest.MonkeyPatch) -> None:
    runner = Runner(plan_of(study))
    rows = rows_with(study, FakeRay(lambda *_: ""), monkeypatch)
    assert rows == [runner.run(case).row for case in cases(study)]


def test_case_that_ends_its_workers_or_hangs_has_an_error(study: Study, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(name: str, given: Any) -> str:
        return {1: "dies", 2: "hangs"}.get(given[0].index, "") if name == "run" else ""

    ray = FakeRay(broken)
    errors = [str(row["error"]).partition(":")[0] for row in rows_with(study, ray, monkeypatch)]
    assert errors == ["", "WorkerDied", "TooLong", ""]
    assert ray.killed > 0


def test_worker_of_another_version_is_refused(study: Study, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(PoolError, match="same version"):
        rows_with(study, FakeRay(lambda name, _: "other" if name == "version" else ""), monkeypatch)


def test_workers_that_cannot_start_end_the_study(study: Study, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(PoolError, match="before they were ready"):
        rows_with(study, FakeRay(lambda name, _: "dies" if name == "version" else ""), monkeypatch)
