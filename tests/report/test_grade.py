"""Faults of a run and its grade."""

from __future__ import annotations

from pathlib import Path

import msgspec
import pytest

from aftdeck.report.grade import FAULTS, faults, grade
from aftdeck.report.metric import Value
from aftdeck.report.run_metrics import RunMetrics
from aftdeck.simulation.frame import AT_HARD, FREE, Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.core.task_run import TaskRun
from tests.loaded import scenario
from tests.task.test_progress import two


def frames(*states: tuple[bool, bool, bool]) -> list[Frame]:
    """Return frames with an inhibit by a contact, a warning by CLEARANCE, and a joint at its hard stop."""
    frame = Simulation(scenario("first-flight")).step(Inputs())
    made = []
    for inhibited, warned, stopped in states:
        level = "warning" if warned else "caution"
        work = msgspec.structs.replace(frame.work, arm_inhibit=inhibited, clearance_level=level)
        zones = (FREE, FREE, AT_HARD if stopped else FREE, FREE, FREE, FREE)
        made.append(msgspec.structs.replace(frame, work=work, zones=zones))
    return made


def found(*states: tuple[bool, bool, bool]) -> tuple[int, ...]:
    metrics = RunMetrics(scenario("first-flight"))
    for frame in frames(*states):
        metrics.see(frame, ())
    values = metrics.found()
    return tuple(int(values[metric].number or 0) for metric in FAULTS)


def test_fault_is_counted_when_it_begins() -> None:
    no, yes = (False, False, False), (True, True, True)
    assert found(no, yes, yes, no, yes, no) == (2, 2, 2)
    assert found(no, (True, False, False), (False, True, False), (False, False, True)) == (1, 1, 1)


def test_what_the_first_frame_has_already_is_no_fault() -> None:
    no, yes = (False, False, False), (True, True, True)
    assert found(yes, yes, no) == (0, 0, 0)
    assert found(yes, no, yes) == (1, 1, 1)


def test_each_kind_of_fault_lowers_the_grade_by_one() -> None:
    counts = dict.fromkeys(FAULTS, 0)
    grades = [grade(faults({}))]
    for metric in FAULTS:
        counts[metric] = 7
        kinds = faults({kind: Value(float(count)) for kind, count in counts.items()})
        grades.append(grade(kinds))
        assert kinds[0].startswith("7 ")
    assert grades == ["A", "B", "C", "D"]


@pytest.mark.parametrize("skips", [0, 3])
def test_result_stands_once_all_steps_are_past(skips: int) -> None:
    sim = Simulation(scenario("uncradle"))
    run, steps = TaskRun(sim.scenario), len(sim.scenario.steps)
    run.add(sim.step(Inputs()), ())
    for _ in range(skips):
        run.progress.skip()
    while run.progress.present is not None:
        frame = sim.step()
        run.add(frame, ())
        assert run.debrief is None or run.progress.present is None
    frame = frame if skips == 0 else sim.step()
    run.add(frame, ())
    assert run.debrief is not None
    assert run.debrief.grade is None  # skipped, or flown by the script
    assert len(run.debrief.faults) == 1 + (skips > 0 and frame.by == "script")
    (time,) = [figure.value for figure in run.debrief.figures if figure.name == "Run time"]
    assert time == pytest.approx(frame.time_s, abs=0.05)
    later = run.debrief
    run.add(sim.step(Inputs()), ())
    assert run.debrief is later
    run.progress.back()
    run.add(sim.step(Inputs()), ())
    assert (run.debrief is None) == (run.progress.at < steps)


def test_run_by_hand_has_a_grade(tmp_path: Path) -> None:
    sim, _ = two(tmp_path)
    run = TaskRun(sim.scenario)
    run.add(sim.step(Inputs(rate="vernier")), ())
    while run.progress.present is not None:
        frame = sim.step(Inputs(translation=(0.0, 0.0, -1.0)))
        run.add(frame, ())
        assert frame.tick < 4000
    assert run.debrief is not None
    assert (run.debrief.grade, run.debrief.faults) == ("A", ())


def test_re_initialisation_begins_a_new_result() -> None:
    sim = Simulation(scenario("concept-1972"))
    run = TaskRun(sim.scenario)
    for _ in range(5):
        run.add(sim.step(Inputs(translation=(0.0, 0.0, -1.0))), ())
    run.add(sim.step(Inputs(initialise="manoeuvring")), ())
    assert (run.progress.first, run.progress.at, run.progress.skipped) == (3, 3, ())
    while run.progress.present is not None:
        run.progress.skip()
    run.add(sim.step(Inputs()), ())
    assert run.debrief is not None
    figures = {figure.name: figure.value for figure in run.debrief.figures}
    assert figures["Tip path"] == pytest.approx(0.0, abs=1e-6)
    assert "Capture misalignment" not in figures
