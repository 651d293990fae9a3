"""Faults of a run and its grade."""

from __future__ import annotations

import msgspec
import pytest

from aftdeck.simulation.frame import AT_HARD, FREE, Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.session.task_run import TaskRun
from aftdeck.task.grade import Faults, grade
from tests.station.pages import scenario


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


def found(*states: tuple[bool, bool, bool]) -> tuple[int, int, int]:
    faults = Faults()
    for frame in frames(*states):
        faults.see(frame)
    return faults.contacts, faults.warnings, faults.stops


def test_fault_is_counted_when_it_begins() -> None:
    no, yes = (False, False, False), (True, True, True)
    assert found(no, yes, yes, no, yes, no) == (2, 2, 2)
    assert found(no, (True, False, False), (False, True, False), (False, False, True)) == (1, 1, 1)


def test_what_the_first_frame_has_already_is_no_fault() -> None:
    no, yes = (False, False, False), (True, True, True)
    assert found(yes, yes, no) == (0, 0, 0)
    assert found(yes, no, yes) == (1, 1, 1)


def test_each_kind_of_fault_lowers_the_grade_by_one() -> None:
    faults = Faults()
    assert grade(faults.texts(0)) == "A"
    faults.contacts = 7
    assert grade(faults.texts(0)) == "B"
    faults.warnings = faults.stops = 1
    assert grade(faults.texts(0)) == "D"
    assert grade(faults.texts(3)) == "E"
    assert faults.texts(1)[0].startswith("7 ")


@pytest.mark.parametrize("skips", [0, 3])
def test_result_stands_once_all_steps_are_past(skips: int) -> None:
    sim = Simulation(scenario("uncradle"))
    run, steps = TaskRun(sim.scenario), len(sim.scenario.steps)
    run.see(sim.step(Inputs()), ())
    for _ in range(skips):
        run.progress.skip()
    while run.progress.present is not None:
        frame = sim.step()
        run.see(frame, ())
        assert run.debrief is None or run.progress.present is None
    frame = frame if skips == 0 else sim.step()
    run.see(frame, ())
    assert run.debrief is not None
    assert run.debrief.grade == ("A" if skips == 0 else "B")
    (time,) = [figure.value for figure in run.debrief.figures if figure.name == "Run time"]
    assert time == pytest.approx(frame.time_s, abs=0.05)
    later = run.debrief
    run.see(sim.step(Inputs()), ())
    assert run.debrief is later
    run.progress.back()
    run.see(sim.step(Inputs()), ())
    assert (run.debrief is None) == (run.progress.at < steps)
