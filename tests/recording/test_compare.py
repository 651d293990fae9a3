"""Differences between two runs."""

from __future__ import annotations

from pathlib import Path

import msgspec
import numpy as np
import pytest

from aftdeck.recording.changed import rerun
from aftdeck.recording.compare import Comparison, EventChange, alike, first_difference
from aftdeck.recording.convert import frame_record
from aftdeck.recording.records import FrameRecord
from aftdeck.recording.run import record
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.frame import Event, Goal
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation, run
from tests.recording.flown import bay

JOINTS = ("a", "b", "c", "d", "e", "f")


@pytest.fixture(scope="module")
def records() -> list[FrameRecord]:
    sim = Simulation(bay())
    push = Inputs(translation=(0.5, 0.0, 0.0))
    return [msgspec.structs.replace(frame_record(sim.step(push), 0.0, None), sha256="0", events=()) for _ in range(20)]


def compared(before: list[FrameRecord], after: list[FrameRecord]) -> Comparison:
    comparison = Comparison(JOINTS)
    comparison.follow(iter(before), iter(after))
    return comparison


def with_lines(frame: FrameRecord, *texts: str) -> FrameRecord:
    return msgspec.structs.replace(frame, events=tuple(Event(frame.time_s, "x", "info", t) for t in texts))


def test_equal_runs_have_no_difference(records: list[FrameRecord]) -> None:
    found = compared(records, records)
    assert found.first is None and found.events == () and found.compared == 20
    assert (found.tip.value, found.joint.value, found.joint_name, found.tip_at_end) == (0.0, 0.0, "", 0.0)


@pytest.mark.parametrize("field", ["wall_s", "latency_ms", "sha256"])
def test_fields_outside_the_state_are_not_compared(records: list[FrameRecord], field: str) -> None:
    value: object = "1" * 16 if field == "sha256" else 99.0
    assert alike(records[0], msgspec.structs.replace(records[0], **{field: value}))


def test_first_difference_has_its_fields_and_values(records: list[FrameRecord]) -> None:
    other = msgspec.structs.replace(records[7], rate="vernier", drive=0.25)
    found = compared(records, [*records[:7], other, *records[8:]])
    assert found.first is not None and found.first == first_difference(records[7], other)
    assert (found.first.tick, found.first.time_s) == (8, 0.16)
    assert [(c.field, c.before, c.after) for c in found.first.fields] == [
        ("rate", '"coarse"', '"vernier"'),
        ("drive", "0.0", "0.25"),
    ]


def test_difference_is_told_value_by_value(records: list[FrameRecord]) -> None:
    frame = records[7]
    a, b, c, d, e, _ = frame.angles
    goal = Goal((1.0, 2.0, 3.0), frame.orientation, 4.0, 0.0, 0.0)
    hand = msgspec.structs.replace(frame.work.hand, flags=("RIGID", "CAPTURE"))
    other = msgspec.structs.replace(
        frame, angles=(a, b, c, d, e, 0.5), work=msgspec.structs.replace(frame.work, hand=hand), goal=goal
    )
    found = {change.field: change.after for change in first_difference(frame, other).fields}
    assert found.keys() == {"angles[5]", "work.hand.flags", "goal"}
    further = msgspec.structs.replace(other, goal=msgspec.structs.replace(goal, position=(1.0, 2.0, 3.5), distance=3.0))
    (place, distance) = first_difference(other, further).fields
    assert (place.field, place.before, place.after) == ("goal.position[2]", "3.0", "3.5")
    assert distance.field == "goal.distance"


def test_tip_is_the_true_one(tmp_path: Path) -> None:
    record("sts-400-closed", tmp_path / "run.mcap")
    outcome = rerun(tmp_path / "run.mcap", ("plant=flexible",))
    before = run("sts-400-closed").table("tip")
    after = run(load_scenario("sts-400-closed", {"plant": "flexible"})).table("true_tip", "tip")
    steps = min(len(before["time_s"]), len(after["time_s"]))
    tips = [
        np.array([table[f"{tip}_{axis}_m"][:steps] for axis in "xyz"])
        for table, tip in ((before, "tip"), (after, "true_tip"), (after, "tip"))
    ]
    true, measured = (np.linalg.norm(tip - tips[0], axis=0) for tip in tips[1:])
    assert outcome.greatest_tip_m.value == pytest.approx(true.max(), abs=1e-6)
    assert outcome.greatest_tip_m.value != pytest.approx(measured.max(), abs=1e-3)
    assert outcome.tip_at_end_m == pytest.approx(true[-1], abs=1e-6)


def test_greatest_differences_have_their_times(records: list[FrameRecord]) -> None:
    after = list(records)
    for k, by in ((3, 0.5), (9, 2.0), (15, 1.0)):
        frame = records[k]
        x, y, z = frame.position
        angles = tuple(q + by * (i == 4) for i, q in enumerate(frame.angles))
        after[k] = msgspec.structs.replace(frame, position=(x + 3.0 * by, y, z - 4.0 * by), angles=angles)
    found = compared(records, after)
    assert found.tip.value == pytest.approx(10.0) and found.tip.time_s == pytest.approx(0.2)
    assert found.joint.value == pytest.approx(2.0) and found.joint_name == "e"
    assert found.first is not None and found.first.tick == 4
    assert found.tip_at_end == 0.0


def test_frames_are_compared_at_equal_times_only(records: list[FrameRecord]) -> None:
    coarser = [msgspec.structs.replace(frame, tick=k) for k, frame in enumerate(records[1::2], 1)]
    found = compared(records, coarser)
    assert found.compared == 10 and found.first is None
    assert compared(coarser, records).compared == 10


@pytest.mark.parametrize("short", [0, 5])
def test_lines_after_the_end_of_one_run_are_differences(records: list[FrameRecord], short: int) -> None:
    longer = [*records[:-1], with_lines(records[-1], "the end")]
    found = compared(records[:short], longer)
    assert found.compared == short
    assert found.events == (EventChange("the end", None, records[-1].time_s),)
    assert compared(longer, records[:short]).events == (EventChange("the end", records[-1].time_s, None),)


def test_equal_lines_are_paired_in_order(records: list[FrameRecord]) -> None:
    before, after = list(records), list(records)
    before[2], before[5] = with_lines(before[2], "stop"), with_lines(before[5], "stop", "only before")
    after[2], after[9], after[12] = (
        with_lines(after[2], "stop"),
        with_lines(after[9], "stop"),
        with_lines(after[12], "only after"),
    )
    assert compared(before, after).events == (
        EventChange("stop", before[5].time_s, after[9].time_s),
        EventChange("only before", before[5].time_s, None),
        EventChange("only after", None, after[12].time_s),
    )


def test_repeated_line_in_a_step_counts_twice(records: list[FrameRecord]) -> None:
    before, after = list(records), list(records)
    before[2], after[2] = with_lines(before[2], "x", "x"), with_lines(after[2], "x")
    assert compared(before, after).events == (EventChange("x", before[2].time_s, None),)
