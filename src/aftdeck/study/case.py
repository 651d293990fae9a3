"""One run of a study: from the changes of a case to its row in the table of results."""

from __future__ import annotations

import resource
import sys
import time
from collections import OrderedDict
from pathlib import Path
from typing import Any

import msgspec

from aftdeck.errors import RecordingError
from aftdeck.recording.run import record
from aftdeck.recording.trial import Trial
from aftdeck.report.table import Row
from aftdeck.scenario.keys import FILES, Change, of_kind
from aftdeck.scenario.model import Scenario
from aftdeck.schema_check import convert
from aftdeck.simulation.run import run
from aftdeck.simulation.summary import Summary
from aftdeck.study.design import Case
from aftdeck.study.operator import Operator, operator_of, pilot_of, until_the_end
from aftdeck.study.plan import Plan
from aftdeck.study.result import error_text, results, row_of
from aftdeck.study.schema import MonitorsSpec
from aftdeck.study.watch import Monitors, Watch

KEPT_SCENARIOS = 32
"""Number of scenarios that a worker keeps, each for its set of changes; one takes about 1 MB."""


class Outcome(msgspec.Struct, frozen=True):
    """Result of a case."""

    row: Row
    wall_s: float
    """Time by the wall clock, with the building of the scenario [s]."""
    peak_memory_mb: float = 0.0
    """Greatest memory of the worker until then [MB]."""


class Runner:
    """Runs cases of one study in this process, one after the other; keeps the scenarios that it has built."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self._scenarios: OrderedDict[tuple[str, ...], Scenario] = OrderedDict()

    def run(self, case: Case, recording: Path | None = None) -> Outcome:
        """Run a case and return its result; an error is part of the result.

        Args:
            case: the case.
            recording: file to record into; None: the run is not recorded.
        """
        began = time.perf_counter()
        try:
            found = self._results(case, recording)
        except RecordingError:
            raise
        except Exception as error:
            found = {"error": error_text(error)}
        return Outcome(row_of(self.plan, case, found), time.perf_counter() - began, peak_memory_mb())

    def scenario(self, case: Case) -> Scenario:
        """Return the scenario of a case; raises the errors of its changes."""
        changes = [change for change in case.changes if change.key.kind in FILES]
        key = tuple(f"{change.key.text}={change.value!r}" for change in changes)
        scenario = self._scenarios.pop(key, None)
        if scenario is None:
            scenario = self.plan.carried.scenario(changes)
        self._scenarios[key] = scenario
        if len(self._scenarios) > KEPT_SCENARIOS:
            self._scenarios.popitem(last=False)
        return scenario

    def _results(self, case: Case, recording: Path | None) -> Row:
        plan, scenario = self.plan, self.scenario(case)
        spec = operator_of(_table(plan.operator, "operator", case.changes))
        monitors = convert(_table(plan.monitors, "monitors", case.changes), MonitorsSpec)
        check_cameras(scenario, monitors)
        shown = _cameras(monitors.mon_1), _cameras(monitors.mon_2)
        flown = pilot_of(scenario, spec, case.seed)
        watch = Watch(scenario, shown, None if flown is None else flown.progress)
        inputs = None if flown is None else until_the_end(flown, scenario.ticks)
        if recording is None:
            summary = run(
                scenario,
                case.seed,
                inputs=inputs,
                keep_frames=False,
                stepped=watch.see,
                digests=False,
                gauged=plan.gauged,
            ).summary
        else:
            summary = _recorded(scenario, case, inputs, watch, shown, recording, gauged=plan.gauged)
        return results(plan, scenario, spec, watch, summary)


def _recorded(
    scenario: Scenario,
    case: Case,
    inputs: Operator | None,
    watch: Watch,
    shown: Monitors,
    path: Path,
    *,
    gauged: bool,
) -> Summary:
    """Run a case with a recording; the file appears when it is complete, and replaces an older one.

    Raises:
        RecordingError: the file cannot be written.
    """
    new = path.with_name(f".{path.stem}.new.mcap")
    new.unlink(missing_ok=True)
    trial = Trial(condition=f"case {case.index}")
    try:
        done = record(
            scenario,
            new,
            case.seed,
            trial=trial,
            shown=shown,
            inputs=inputs,
            stepped=watch.see,
            gauged=gauged,
        )
    except RecordingError:
        raise
    except BaseException:
        new.replace(path)  # what was recorded until the run failed
        raise
    new.replace(path)
    return done.summary


def check_cameras(scenario: Scenario, monitors: MonitorsSpec) -> None:
    """Check that the cameras of the monitors exist.

    Raises:
        InputError: a camera does not exist.
    """
    if monitors.mon_1 or monitors.mon_2:
        from aftdeck.scene.cameras import SceneCameras  # noqa: PLC0415  (builds the scene)

        cameras = SceneCameras(scenario)
        for name in filter(None, (monitors.mon_1, monitors.mon_2)):
            cameras.camera(name)


def _cameras(name: str) -> tuple[str, ...]:
    return (name,) if name else ()


def peak_memory_mb() -> float:
    """Return the greatest memory of this process until now [MB]."""
    unit = 1e6 if sys.platform == "darwin" else 1e3
    return float(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss) / unit


def _table(table: dict[str, Any], kind: str, changes: tuple[Change, ...]) -> dict[str, Any]:
    """Return a table of the study with the changes of a case."""
    return table | {str(where[0]): value for where, value in of_kind(changes, kind).items()}
