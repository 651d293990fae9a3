"""Lamps, strips, metrics, time histories and observations of an arm with any number of joints."""

from __future__ import annotations

import pytest

from aftdeck.export.state import StateReader
from aftdeck.recording.codec import as_read, decode, encode
from aftdeck.recording.records import FrameRecord
from aftdeck.report.catalogue import named
from aftdeck.report.lamps import lit_lamps
from aftdeck.report.run_metrics import RunMetrics
from aftdeck.report.strips import curve_values, sources
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.readings.reading import Known
from aftdeck.simulation.run import Simulation
from aftdeck.simulation.series.groups import columns_of, in_series
from tests.joints import NUMBERS, frame_with_joints, scenario_with_joints
from tests.plant.multibody.flights import scenario

EACH = pytest.mark.parametrize("joints", NUMBERS)


@pytest.fixture(scope="module")
def flown() -> tuple[Scenario, Frame]:
    """A scenario on a plant with masses, and a frame of it."""
    made = scenario("rigid")
    return made, Simulation(made).step(Inputs())


@EACH
def test_lamps_name_the_joint_that_is_past_its_limit(flown: tuple[Scenario, Frame], joints: int) -> None:
    made = scenario_with_joints(flown[0], joints)
    lamps = {lamp.name: lamp.text for lamp in lit_lamps(made, frame_with_joints(flown[1], joints))}
    name = f"joint {joints - 1}"
    assert lamps["REACH LIM"] == lamps["SOFT STOP"] == name
    assert lamps["CONTR ERR"].endswith(f": {name}")


@EACH
def test_each_joint_has_a_strip_of_its_angle(flown: tuple[Scenario, Frame], joints: int) -> None:
    made, frame = scenario_with_joints(flown[0], joints), frame_with_joints(flown[1], joints)
    names = [source.blank.name for source in sources(made) for _ in source.curves]
    values = curve_values(made)(frame, None)
    for k, label in enumerate(made.arm.model.labels):
        assert [value for name, value in zip(names, values, strict=True) if name == label] == [frame.angles[k]] * 2
    assert [name for name in names if name.startswith("Joint ")].count("Joint torque") == 1
    assert len([name for name in names if name.startswith("Joint ")]) == 2 * joints + 3, "with rate and torque"


@EACH
def test_time_history_has_a_column_for_each_joint(flown: tuple[Scenario, Frame], joints: int) -> None:
    made, frame = scenario_with_joints(flown[0], joints), frame_with_joints(flown[1], joints)
    known = Known(frame, made)
    found = {one.name: (columns_of(one, made), one.values(known)) for one in in_series(made) if one.needs != "gauges"}
    for name in ("angle", "rate", "rate_commanded", "torque"):
        columns, values = found[name]
        assert len(columns) == len(values) == joints
        assert all(f"joint_{k}" in column.name for k, column in enumerate(columns))


@EACH
def test_metrics_of_a_run_take_the_worst_of_all_joints(flown: tuple[Scenario, Frame], joints: int) -> None:
    made, frame = scenario_with_joints(flown[0], joints), frame_with_joints(flown[1], joints)
    metrics = RunMetrics(made)
    metrics.see(frame, ())
    metrics.see(frame, ())
    assert metrics.found()[named("worst_joint_rate")].number == pytest.approx(1.0)


@EACH
def test_frame_is_recorded_with_a_value_for_each_joint(flown: tuple[Scenario, Frame], joints: int) -> None:
    frame = frame_with_joints(flown[1], joints)
    record = FrameRecord(
        wall_s=0.0, latency_ms=None, **{name: getattr(frame, name) for name in frame.__struct_fields__}
    )
    assert decode(FrameRecord, encode(record)) == as_read(record)
    assert as_read(record).angles == pytest.approx(frame.angles)
    assert len(as_read(record).zones) == joints


@EACH
def test_states_have_an_angle_and_a_rate_of_each_joint(flown: tuple[Scenario, Frame], joints: int) -> None:
    made, frame = scenario_with_joints(flown[0], joints), frame_with_joints(flown[1], joints)
    state = StateReader(made)
    names, seen = state.names, state.of(frame, None)
    for kind, values in (("angle", frame.angles), ("rate", frame.rates)):
        found = [seen[names.index(f"{kind}_joint_{k}")] for k in range(joints)]
        assert found == pytest.approx(values, rel=1e-6)
