"""What two runs differ in."""

from __future__ import annotations

import msgspec
import pytest

from aftdeck.recording.compare import Comparison, EventChange, alike, first_difference
from aftdeck.recording.convert import frame_record
from aftdeck.recording.records import FrameRecord
from aftdeck.simulation.frame import Event
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from tests.recording.flown import bay

JOINTS = ("a", "b", "c", "d", "e", "f")


@pytest.fixture(scope="module")
def flight() -> list[FrameRecord]:
    sim = Simulation(bay())
    push = Inputs(translation=(0.5, 0.0, 0.0))
    return [msgspec.structs.replace(frame_record(sim.step(push), 0.0, None), sha256="0", events=()) for _ in range(20)]


def compared(before: list[FrameRecord], after: list[FrameRecord]) -> Comparison:
    comparison = Comparison(JOINTS)
    comparison.follow(iter(before), iter(after))
    return comparison


def told(frame: FrameRecord, *texts: str) -> FrameRecord:
    return msgspec.structs.replace(frame, events=tuple(Event(frame.time_s, "x", "info", t) for t in texts))


def test_equal_runs_do_not_differ(flight: list[FrameRecord]) -> None:
    found = compared(flight, flight)
    assert found.first is None and found.events == () and found.compared == 20
    assert (found.tip.value, found.joint.value, found.joint_name, found.tip_at_end) == (0.0, 0.0, "", 0.0)


@pytest.mark.parametrize("field", ["wall_s", "latency_ms", "sha256"])
def test_what_says_nothing_of_the_flight_is_passed_over(flight: list[FrameRecord], field: str) -> None:
    value: object = "1" * 16 if field == "sha256" else 99.0
    assert alike(flight[0], msgspec.structs.replace(flight[0], **{field: value}))


def test_the_first_difference_names_its_fields_and_values(flight: list[FrameRecord]) -> None:
    other = msgspec.structs.replace(flight[7], rate="vernier", drive=0.25)
    found = compared(flight, [*flight[:7], other, *flight[8:]])
    assert found.first is not None and found.first == first_difference(flight[7], other)
    assert (found.first.tick, found.first.time_s) == (8, 0.16)
    assert [(c.field, c.before, c.after) for c in found.first.fields] == [
        ("rate", '"coarse"', '"vernier"'),
        ("drive", "0.0", "0.25"),
    ]


def test_the_greatest_differences_are_found_with_their_times(flight: list[FrameRecord]) -> None:
    after = list(flight)
    for k, by in ((3, 0.5), (9, 2.0), (15, 1.0)):
        frame = flight[k]
        x, y, z = frame.position
        angles = tuple(q + by * (i == 4) for i, q in enumerate(frame.angles))
        after[k] = msgspec.structs.replace(frame, position=(x + 3.0 * by, y, z - 4.0 * by), angles=angles)
    found = compared(flight, after)
    assert found.tip.value == pytest.approx(10.0) and found.tip.time_s == pytest.approx(0.2)
    assert found.joint.value == pytest.approx(2.0) and found.joint_name == "e"
    assert found.first is not None and found.first.tick == 4
    assert found.tip_at_end == 0.0


def test_frames_are_compared_at_equal_times_only(flight: list[FrameRecord]) -> None:
    coarser = [msgspec.structs.replace(frame, tick=k) for k, frame in enumerate(flight[1::2], 1)]
    found = compared(flight, coarser)
    assert found.compared == 10 and found.first is None
    assert compared(coarser, flight).compared == 10


@pytest.mark.parametrize("short", [0, 5])
def test_a_run_may_end_before_the_other(flight: list[FrameRecord], short: int) -> None:
    longer = [*flight[:-1], told(flight[-1], "the end")]
    found = compared(flight[:short], longer)
    assert found.compared == short
    assert found.events == (EventChange("the end", None, flight[-1].time_s),)
    assert compared(longer, flight[:short]).events == (EventChange("the end", flight[-1].time_s, None),)


def test_lines_meet_their_like_in_order(flight: list[FrameRecord]) -> None:
    before, after = list(flight), list(flight)
    before[2], before[5] = told(before[2], "stop"), told(before[5], "stop", "only before")
    after[2], after[9], after[12] = told(after[2], "stop"), told(after[9], "stop"), told(after[12], "only after")
    assert compared(before, after).events == (
        EventChange("stop", before[5].time_s, after[9].time_s),
        EventChange("only before", before[5].time_s, None),
        EventChange("only after", None, after[12].time_s),
    )


def test_the_same_line_twice_in_a_step_is_two_lines(flight: list[FrameRecord]) -> None:
    before, after = list(flight), list(flight)
    before[2], after[2] = told(before[2], "x", "x"), told(after[2], "x")
    assert compared(before, after).events == (EventChange("x", before[2].time_s, None),)
