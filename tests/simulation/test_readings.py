"""The table of readings: everything that shows numbers of a run chooses from it."""

from __future__ import annotations

import json
import subprocess
import sys
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.export.state import StateReader
from aftdeck.report.metric import Metric
from aftdeck.report.recorded import metrics_of
from aftdeck.report.reduction import Reduction
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.readings.reading import Known, Recorded, Reducer
from aftdeck.simulation.readings.table import readings, readings_of
from aftdeck.simulation.run import Simulation

PERIOD = 0.02
"""Control period [s]."""


def test_reading_is_strip_metric_and_columns_by_one_entry() -> None:
    program = [sys.executable, "-m", "tests.simulation.new_reading"]
    shown = json.loads(subprocess.run(program, capture_output=True, text=True, check=True, timeout=300).stdout)
    heights = shown["heights"]
    assert len(set(heights)) > 1
    (ends,) = shown["strip"]
    assert (ends[0], ends[-1]) == (heights[0], heights[-1])
    assert shown["metric"]["peak_height_m"] == max(map(abs, heights))
    assert shown["column"] == heights
    assert shown["about"] == "height of the tip above L's origin"
    assert shown["state"] == pytest.approx(heights[-1])


def test_every_reading_has_its_own_name_and_a_definition() -> None:
    table = readings_of(load_scenario("srms-berth", {("plant",): "flexible"}))
    assert len({reading.name for reading in table}) == len(table)
    assert all(reading.definition and reading.source and not reading.definition.endswith(".") for reading in table)


@pytest.mark.parametrize("plant", ["kinematic", "rigid"])
def test_reading_has_a_value_for_each_of_its_names(plant: str) -> None:
    sim = Simulation(load_scenario("srms-berth", {("plant",): plant}), gauged=plant != "kinematic")
    known = Known(sim.step(), sim.scenario, sim.readings)
    for reading in readings_of(sim.scenario):
        if reading.state not in ("to_go", "rotation_to_go", "velocity", "turning"):  # these need the sticks' axes
            assert len(reading.values(known)) == len(reading.names(reading.name, sim.scenario)), reading.name
    assert len(set(StateReader(sim.scenario).names)) == len(StateReader(sim.scenario).names)


@pytest.mark.parametrize("count", [5, 7])
def test_readings_of_joints_are_as_many_as_the_arm_has(count: int) -> None:
    arm: Any = SimpleNamespace(arm=SimpleNamespace(joints=tuple(f"joint_{k}" for k in range(count))))
    of_joints = [reading for reading in readings() if reading.parts == "joints"]
    for reading in of_joints:
        assert reading.names("x", arm) == tuple(f"x_joint_{k}" for k in range(count))
        for how in reading.metrics:
            assert len({metric.column for metric in metrics_of(reading, how, count)}) == count
    assert of_joints


def reduced(by: Reducer, values: list[float]) -> float | None:
    """Return what a reducer makes of the values of a run."""
    reduction = Reduction(Metric("x", "X", "ratio", "X."), Recorded(by, "x", "X"), "", PERIOD)
    known: Any = object()
    for part in (values[:7], values[7:]):
        reduction.see(part, [known] * len(part))
    found = reduction.found()
    return None if found is None else found[1].number


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=30))
def test_reducers_of_a_number(values: list[float]) -> None:
    assert reduced("greatest", values) == max(map(abs, values))
    assert reduced("least", values) == min(values)
    assert reduced("last", values) == values[-1]
    assert reduced("mean", values) == pytest.approx(np.mean(values), abs=1e-6)
    assert reduced("integral", values) == pytest.approx(np.sum(values) * PERIOD, abs=1e-6)


@given(st.lists(st.booleans(), min_size=1, max_size=30))
def test_reducers_of_a_state(states: list[bool]) -> None:
    values = [float(state) for state in states]
    assert reduced("time", values) == pytest.approx(sum(states) * PERIOD)
    assert reduced("share", values) == pytest.approx(sum(states) / len(states))
    assert reduced("begun", values) == sum(b and not a for a, b in pairwise(states))


def test_reading_without_a_value_has_no_metric() -> None:
    assert reduced("greatest", []) is None
