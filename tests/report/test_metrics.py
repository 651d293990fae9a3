"""Metrics of runs made by hand, whose values are known."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from aftdeck.operators.pilot import pilot
from aftdeck.operators.spec import OperatorSpec
from aftdeck.report.catalogue import METRICS
from aftdeck.report.lamps import Lamp
from aftdeck.report.metric import Collector, Metric, Value
from aftdeck.report.metrics import (
    alarms,
    announcements,
    clearance,
    moments,
    path,
    pictures,
    steps,
    sticks,
    stopping,
    times,
)
from aftdeck.report.recorded import ReadingMetrics
from aftdeck.report.run_metrics import RunMetrics
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.frame import Dynamics, Force, Frame, Goal, Holding, Placed
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.payloads.task_phases import TASKS
from aftdeck.simulation.readings.reading import Known
from aftdeck.simulation.run import Simulation, run
from aftdeck.task.progress import Progress
from aftdeck.worksite.report import Cargo, Near
from tests.loaded import scenario

PERIOD = 0.02
"""Control period [s]."""
ONE = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
"""No rotation."""
RESTING = (0.0,) * 6
"""Twist of a tip at rest."""


@pytest.fixture(scope="module")
def frame() -> Frame:
    """Frame of an arm without payloads; its twist is zero."""
    return msgspec.structs.replace(Simulation(scenario("first-flight")).step(Inputs()), twist=RESTING)


def changed(frame: Frame, **fields: Any) -> Frame:  # fields of a frame have many types
    """Return a frame with other fields; those of `Work` are found by their names."""
    within = {name: fields.pop(name) for name in list(fields) if name in frame.work.__struct_fields__}
    return msgspec.structs.replace(frame, work=msgspec.structs.replace(frame.work, **within), **fields)


def found(collector: Collector, frames: Iterable[Frame]) -> dict[Metric, Value]:
    """Return the metrics of a run."""
    before = None
    for frame in frames:
        collector.see(frame, before)
        before = frame
    return dict(collector.found())


def numbers(collector: Collector, frames: Iterable[Frame]) -> dict[Metric, float | None]:
    """Return the numbers of the metrics of a run."""
    return {metric: value.number for metric, value in found(collector, frames).items()}


def read(frames: Iterable[Frame], plant: str = "kinematic") -> dict[str, float | None]:
    """Return the numbers of the metrics of readings in a run, by their columns."""
    flown = load_scenario("first-flight", {("plant",): plant})
    metrics = ReadingMetrics(flown)
    for each in frames:
        metrics.see(Known(each, flown))
    return {metric.column: value.number for metric, value in metrics.found()}


def cargo(*, held: bool = False, seat: str = "", at: float = 0.0, turned: float = 0.0, speed: float = 0.0) -> Cargo:
    """Return a payload on the X axis, turned about Z."""
    s, c = math.sin(turned), math.cos(turned)
    return Cargo("payload", (at, 0.0, 0.0), ((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)), (speed, 0.0, 0.0), held, seat)


def near(gap: float, a: str = "boom", *, essential: bool = False) -> Near:
    """Return a pair with this clearance."""
    zero = (0.0, 0.0, 0.0)
    return Near(a, "sill", gap, 0.0, zero, zero, zero, 0.0, essential)


def test_every_metric_has_its_own_column_and_a_definition() -> None:
    assert len({metric.column for metric in METRICS}) == len({metric.title for metric in METRICS}) == len(METRICS)
    assert all(metric.definition.endswith(".") and metric.source for metric in METRICS)


def test_a_run_has_only_metrics_of_the_catalogue() -> None:
    for name in ("concept-1972-script", "srms-berth"):
        sim = Simulation(name)
        metrics = RunMetrics(sim.scenario)
        for _ in range(50):
            metrics.see(sim.step(), ())
        assert set(metrics.found()) <= set(METRICS)


@given(st.lists(st.tuples(*[st.floats(-5.0, 5.0)] * 3), min_size=2, max_size=12))
def test_path_and_directness_are_those_of_the_polyline(places: list[tuple[float, float, float]]) -> None:
    still = msgspec.structs.replace(Simulation(scenario("first-flight")).step(Inputs()), twist=RESTING)
    values = numbers(path.Path(), [changed(still, position=place) for place in places])
    length = sum(math.dist(a, b) for a, b in pairwise(places))
    assert values[path.PATH] == pytest.approx(length)
    if length:
        assert values[path.DIRECTNESS] == pytest.approx(math.dist(places[0], places[-1]) / length)


def test_path_is_divided_where_a_payload_is_captured(frame: Frame) -> None:
    corner = [(0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (3.0, 4.0, 0.0)]
    bent = [changed(frame, position=place, cargo=(cargo(),)) for place in corner]
    taken = [bent[0], *(changed(each, cargo=(cargo(held=True),)) for each in bent[1:])]
    assert numbers(path.Path(), bent)[path.DIRECTNESS] == pytest.approx(5.0 / 7.0)
    assert numbers(path.Path(), taken)[path.DIRECTNESS] == pytest.approx(1.0)


def test_turning_at_a_constant_rate(frame: Frame) -> None:
    turning = [changed(frame, twist=(0.0, 0.0, 0.1, 0.0, 0.3, 0.4))] * 50
    values = read(turning)
    assert values["tip_rotation_rad"] == pytest.approx(0.1 * 50 * PERIOD)
    assert values["greatest_speed_m_s"] == pytest.approx(0.5)


def stick(frame: Frame, *axes: float, drive: float = 0.0) -> Frame:
    """Return a frame with deflected sticks: X, Y, Z, roll, pitch, yaw."""
    six = (*axes, *[0.0] * (6 - len(axes)))
    return changed(frame, translation=six[:3], rotation=six[3:], drive=drive)


def test_use_of_the_hand_controllers(frame: Frame) -> None:
    centred, x, both = stick(frame), stick(frame, 1.0), stick(frame, 1.0, 0.0, 0.0, 0.5)
    diagonal, back = stick(frame, 1.0, 1.0), stick(frame, -1.0)
    values = numbers(sticks.Sticks(PERIOD), [centred, x, both, diagonal, centred, back, x, stick(frame, drive=1.0)])
    assert values[sticks.TWO_HANDED] == 1 / 5
    assert values[sticks.MULTI_AXIS] == 2 / 5
    assert values[sticks.TRANSLATION] == 1 / 5
    assert values[sticks.ROTATION] == 0.0
    assert values[sticks.INPUTS] == 4  # THC twice, RHC once, DRIVE once
    assert values[sticks.REVERSALS] == 2  # + to -, and back
    assert found(sticks.Sticks(PERIOD), [x, back])[sticks.WORST_AXIS].text == "X, 1"


def test_run_without_sticks_has_no_shares(frame: Frame) -> None:
    values = numbers(sticks.Sticks(PERIOD), [stick(frame)] * 3)
    assert {sticks.TWO_HANDED, sticks.MULTI_AXIS, sticks.TRANSLATION, sticks.ROTATION}.isdisjoint(values)
    assert values[sticks.INPUTS] == 0


def test_preparation_ends_with_the_first_command_and_rest_after_it_is_idle(frame: Frame) -> None:
    still, x = stick(frame), stick(frame, 1.0)
    moving = changed(still, twist=(0.0, 0.0, 0.0, 0.1, 0.0, 0.0))
    values = numbers(times.Times(PERIOD), [still] * 10 + [x] * 5 + [moving] * 3 + [still] * 7)
    assert values[times.RUN] == pytest.approx(25 * PERIOD)
    assert values[times.PREPARATION] == pytest.approx(10 * PERIOD)
    assert values[times.IDLE] == pytest.approx(7 * PERIOD)
    assert times.IDLE not in numbers(times.Times(PERIOD), [still] * 4)


def test_task_phases_add_up_to_the_run(frame: Frame) -> None:
    phases = [1, 1, 2, 3, 3, 3, 4, 1]
    values = read([changed(frame, task=task, cargo=(cargo(),)) for task in phases])
    assert [round((values[f"{name}_time_s"] or 0.0) / PERIOD) for name in TASKS.values()] == [3, 1, 3, 1]


def test_contact_counts_once_for_each_pair_and_not_if_it_belongs_to_the_task(frame: Frame) -> None:
    def touching(*pairs: Near) -> Frame:
        return changed(frame, contacts=pairs)

    clear, boom, both = touching(), touching(near(0.0)), touching(near(0.0), near(0.0, "wrist"))
    assert numbers(clearance.Collisions(), [clear, boom, both, boom, clear, boom])[clearance.COLLISIONS] == 3
    assert numbers(clearance.Collisions(), [boom, boom, clear])[clearance.COLLISIONS] == 0
    finger = touching(near(0.0, essential=True))
    assert numbers(clearance.Collisions(), [clear, finger])[clearance.COLLISIONS] == 0


def test_least_and_mean_clearance(frame: Frame) -> None:
    gaps = [None, 1.0, 0.25, 0.75, None]
    run = [changed(frame, nearest=None if gap is None else near(gap)) for gap in gaps]
    values = read(run)
    assert values["min_clearance_m"] == 0.25
    assert values["mean_clearance_m"] == pytest.approx(2.0 / 3.0)
    assert "min_clearance_m" not in read(run[:1])


def test_released_payload_turns_and_drifts_at_its_rate(frame: Frame) -> None:
    rate, speed = 0.02, 0.03
    run = [changed(frame, cargo=(cargo(held=True),))] * 2
    run += [changed(frame, cargo=(cargo(turned=rate * PERIOD * i, speed=speed),)) for i in range(4)]
    values = numbers(moments.Moments(scenario("first-flight")), run)
    assert values[moments.RELEASES] == 1
    assert values[moments.TIP_OFF] == pytest.approx(rate, rel=1e-6)
    assert values[moments.DRIFT] == pytest.approx(speed)
    left = [changed(frame, cargo=(cargo(held=held, seat="bay"),)) for held in (True, False, False)]
    assert numbers(moments.Moments(scenario("first-flight")), left)[moments.RELEASES] == 0


def test_closing_speed_at_capture_is_relative_to_the_payload(frame: Frame) -> None:
    twist = (0.0, 0.0, 0.0, 0.5, 0.0, 0.0)
    run = [changed(frame, twist=twist, cargo=(cargo(held=held, speed=0.3),)) for held in (False, False, True)]
    values = numbers(moments.Moments(scenario("first-flight")), run)
    assert values[moments.CAPTURE.number] == 1
    assert values[moments.CAPTURE.speed] == pytest.approx(0.2)


def test_stopping_distance_is_measured_from_the_release_of_the_sticks(frame: Frame) -> None:
    moving = (0.0, 0.0, 0.0, 0.1, 0.0, 0.0)
    run = [changed(stick(frame, 1.0), twist=moving, resolution=(x, 0.0, 0.0)) for x in (0.0, 1.0)]
    run += [changed(stick(frame), twist=moving, resolution=(x, 0.0, 0.0)) for x in (1.3, 1.5)]
    run += [changed(stick(frame), resolution=(x, 0.0, 0.0)) for x in (1.6, 7.0)]  # it rests at 1.6
    assert numbers(stopping.Stopping(), run)[stopping.STOPPING] == pytest.approx(0.6)
    assert stopping.STOPPING not in numbers(stopping.Stopping(), run[:2])


def test_point_that_jumps_with_the_mode_is_no_stopping_distance(frame: Frame) -> None:
    moving = changed(stick(frame, 1.0), mode="ORB LD", twist=(0.0, 0.0, 0.0, 0.1, 0.0, 0.0))
    jumped = changed(stick(frame), mode="OPR CMD", twist=moving.twist, resolution=(9.0, 9.0, 9.0))
    assert stopping.STOPPING not in numbers(stopping.Stopping(), [moving, jumped, jumped])


def automatic(frame: Frame, distances: Sequence[float]) -> list[Frame]:
    """Return the frames of an automatic motion with these remaining distances."""
    goals = (Goal((1.0, 2.0, 3.0), ONE, left, 0.0, 1.0) for left in distances)
    return [changed(frame, goal=goal, sequence="in progress") for goal in goals]


def test_overshoot_counts_only_after_the_nearest_point(frame: Frame) -> None:
    def overshoot(*distances: float) -> float | None:
        return numbers(stopping.Stopping(), automatic(frame, distances))[stopping.OVERSHOOT]

    assert overshoot(3.0, 2.0, 1.0, 0.0) == 0.0
    assert overshoot(3.0, 4.0, 2.0, 0.1) == 0.0
    assert overshoot(3.0, 1.0, 0.2, 0.5, 0.3) == pytest.approx(0.3)
    assert stopping.OVERSHOOT not in numbers(stopping.Stopping(), [frame])


def test_asking_during_a_motion_changes_nothing(frame: Frame) -> None:
    asked, before = stopping.Stopping(), None
    for each in automatic(frame, (3.0, 1.0, 0.2, 0.3, 0.4, 0.5)):
        asked.see(each, before)
        assert dict(asked.found()) == dict(asked.found())
        before = each
    assert dict(asked.found())[stopping.OVERSHOOT].number == pytest.approx(0.3)


def test_release_in_the_last_step_has_no_tip_off_rate(frame: Frame) -> None:
    run = [changed(frame, cargo=(cargo(held=held),)) for held in (True, False)]
    values = numbers(moments.Moments(scenario("first-flight")), run)
    assert values[moments.RELEASES] == 1
    assert moments.TIP_OFF not in values


def test_misalignment_of_a_latching_is_that_of_its_trunnions() -> None:
    sim = Simulation("srms-berth")
    collector, before = moments.Moments(sim.scenario), None
    while not sim.ended:
        frame = sim.step()
        collector.see(frame, before)
        before = frame
    values = {metric: value.number for metric, value in collector.found()}
    assert values[moments.LATCH.number] == 1
    # The script moves the payload to half an inch above its seats.
    assert values[moments.LATCH.offset] == pytest.approx(0.0127, abs=1e-4)


def test_re_initialisation_begins_the_metrics_again() -> None:
    sim = Simulation("concept-1972")
    metrics = RunMetrics(sim.scenario)
    for inputs in (Inputs(translation=(0.5, 0.0, 0.0)), Inputs(), Inputs(initialise="manoeuvring"), Inputs()):
        metrics.see(sim.step(inputs), ())
    values = metrics.found()
    assert values[moments.CAPTURE.number].number == 0
    assert values[path.PATH].number == pytest.approx(0.0, abs=1e-6)
    assert values[times.RUN].number == pytest.approx(2 * PERIOD)


def test_wrist_camera_looks_along_the_sticks_in_end_eff() -> None:
    sim = Simulation("tutorial")
    frames = [sim.step(Inputs(translation=(0.2, 0.0, 0.0))) for _ in range(20)]
    collector = pictures.Pictures(sim.scenario)
    assert not numbers(collector, frames)
    collector.shown((("A",), ("WR",)))
    values = numbers(collector, frames)
    assert values[pictures.TURNED] == pytest.approx(0.0, abs=1e-3)
    assert values[pictures.CROSSED] == 0.0
    collector.shown((("B",), ("WR",)))
    assert numbers(collector, [])[pictures.CAMERAS] == 1


def test_camera_that_looks_back_is_crossed() -> None:
    sim = Simulation("concept-1972")
    frame = sim.step(Inputs(translation=(0.2, 0.0, 0.0)))
    for camera, angle in (("H", math.pi), ("P2", 0.0), ("C", 0.0)):
        collector = pictures.Pictures(sim.scenario)
        collector.shown(((camera,),))
        values = numbers(collector, [frame])
        assert values[pictures.TURNED] == pytest.approx(angle, abs=math.radians(8.0)), camera
        assert values[pictures.CROSSED] == (angle > math.pi / 2)
    free = pictures.Pictures(sim.scenario)
    free.shown((("ENG",),))
    assert pictures.TURNED not in numbers(free, [frame])


def test_state_of_the_first_step_is_no_event(frame: Frame) -> None:
    free, braked = changed(frame, brakes=False), changed(frame, brakes=True)
    assert read([braked, free, braked, braked, free])["brakes_used"] == 1


def test_impulse_of_a_constant_force(frame: Frame) -> None:
    pushed = Force("a", "b", (3.0, 4.0, 0.0), (0.0, 0.0, 0.0))
    dynamics = Dynamics(
        (0.0, 0.0, 0.0), ONE, None, RESTING, (), Placed((0.0, 0.0, 0.0), ONE), RESTING, (pushed,),
        (Holding("payload", "end effector", 70.0),), (),
    )  # fmt: skip

    def forces(dynamics: Dynamics, steps: int) -> list[float | None]:
        values = read([changed(frame, dynamics=dynamics)] * steps, "rigid")
        return [values[name] for name in ("peak_contact_force_n", "contact_impulse_n_s", "peak_holding_force_n")]

    assert forces(dynamics, 10) == [5.0, pytest.approx(5.0 * 10 * PERIOD), 70.0]
    assert "peak_contact_force_n" not in read([frame])
    struck = msgspec.structs.replace(
        dynamics,
        contacts=(msgspec.structs.replace(pushed, greatest=12.0),),
        holds=(msgspec.structs.replace(dynamics.holds[0], greatest=90.0),),
    )
    assert forces(struck, 1) == [12.0, pytest.approx(5.0 * PERIOD), 90.0]


def test_lamp_that_goes_out_and_on_again_raises_a_second_alarm() -> None:
    collector = alarms.Alarms()
    caution, warning = Lamp("CLEARANCE", "caution", ""), Lamp("CLEARANCE", "warning", "")
    info = Lamp("RELEASE", "info", "")
    for lit in [(), (caution,), (caution,), (warning, info), (), (caution,)]:
        collector.see(lit)
    ((_, value),) = collector.found()
    assert (value.number, value.level) == (3.0, "warning")


def test_steps_are_counted_as_a_task_is_flown() -> None:
    made = load_scenario("first-flight")
    frames = run(made, inputs=pilot(made, OperatorSpec("perfect"), 1)).frames
    metrics, progress = RunMetrics(made), Progress(made)
    done: list[float] = []
    for frame in frames:
        metrics.see(frame, ())
        done += [frame.time_s] * len(progress.see(frame))
        if len(done) == 1:
            assert steps.TASK not in metrics.found()
            assert metrics.found()[steps.DONE].number == 1
    found = metrics.found()
    assert found[steps.DONE].number == len(made.steps) == len(done)
    assert found[steps.SHARE].number == 1.0
    assert found[steps.TASK].number == pytest.approx(done[-1])
    assert found[steps.LONGEST].number == pytest.approx(max(b - a for a, b in pairwise([0.0, *done])))


def test_steps_of_a_part_are_timed_from_its_re_initialisation() -> None:
    sim = Simulation("concept-1972")
    metrics = RunMetrics(sim.scenario)
    for _ in range(100):
        metrics.see(sim.step(Inputs()), ())
    metrics.see(sim.step(Inputs(initialise="manoeuvring")), ())
    assert metrics.found()[steps.DONE].number == 0
    assert metrics.found()[times.RUN].number == pytest.approx(PERIOD)


def test_announcements_belong_to_the_alarm_that_they_precede_or_that_lasts(frame: Frame) -> None:
    collector, seconds = announcements.Announcements(), [round(k * PERIOD, 9) for k in range(1, 2001)]
    alarms_s = ((10.0, 12.0), (20.0, 25.0), (35.0, 36.0))
    for at in (6.0, 22.0, 30.5, 31.0):
        collector.announce(at)
    for at in seconds:
        level = "caution" if any(begin <= at < end for begin, end in alarms_s) else "info"
        collector.see(changed(msgspec.structs.replace(frame, time_s=at), clearance_level=level), None)
    found = dict(collector.found())
    assert found[announcements.COUNT].number == 4
    assert found[announcements.SHARE].number == 1.0
    assert found[announcements.DELAY].number == pytest.approx((-4.0 + 2.0 - 4.5) / 3.0)
    silent = announcements.Announcements()
    silent.see(frame, None)
    assert not dict(silent.found())
