"""AUTO 1-4: prestored points, pause and fly-by, PROCEED and STOP, READY and IN PROG."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck.scenario.load import parse_scenario
from aftdeck.simulation.frame import Frame
from tests.steering.flying import BAY, checked, disturbed, fly, log_of, scenario, speed

POINTS = [(12.0, 0.0, 0.0), (12.0, -10.0, 0.0), (0.0, -10.0, 8.0), (0.0, 0.0, 0.0)]
"""Points of the sequence: offsets [deg] of the first three joint angles from `BAY`."""


def joints(point: Sequence[float]) -> list[float]:
    return [a + b for a, b in zip(BAY, (*point, 0.0, 0.0, 0.0), strict=True)]


def auto_1(pauses: Sequence[int], law: str = "closed loop", more: str = "") -> aftdeck.Simulation:
    """Return a simulation in AUTO 1; `pauses` lists the numbers of its pause points, counted from 1."""
    points = "\n".join(
        f"[[sequence.point]]\ntarget = {{ joints = {[f'{q} deg' for q in joints(point)]} }}\n"
        f"pause = {'true' if k in pauses else 'false'}"
        for k, point in enumerate(POINTS, 1)
    )
    return aftdeck.Simulation(
        scenario(BAY, f'mode = "AUTO 1"\nlaw = "{law}"\n{more}\n[[sequence]]\nslot = 1\n{points}\n')
    )


def until(sim: aftdeck.Simulation, sequence: str, first: aftdeck.Inputs, seconds: float = 120.0) -> list[Frame]:
    """Return the frames up to the next frame in which the sequence has this state.

    After PROCEED, the search begins only when the motion has started, or when its check has failed.
    """
    frames = [sim.step(first)]
    while first.proceed and frames[-1].sequence in {"checking", "ready"}:
        frames.append(sim.step(aftdeck.Inputs()))
    while frames[-1].sequence != sequence and frames[-1].time_s - frames[0].time_s < seconds:
        frames.append(sim.step(aftdeck.Inputs()))
    assert frames[-1].sequence == sequence, log_of(frames)
    return frames


def away(sim: aftdeck.Simulation, frames: Sequence[Frame], point: Sequence[float]) -> tuple[np.ndarray, np.ndarray]:
    """Return the distance [m] and the angle [rad] between a point and the tip, for each frame."""
    pose = sim.scenario.arm.forward(np.radians(joints(point)))
    distance = np.linalg.norm(np.array([f.position for f in frames]) - pose.position, axis=1)
    cosine = [(np.trace(np.array(f.orientation).T @ pose.rotation) - 1.0) / 2.0 for f in frames]
    return distance, np.arccos(np.clip(cosine, -1.0, 1.0))


PROCEED = aftdeck.Inputs(proceed=True)
laws = pytest.mark.parametrize("law", ["position", "closed loop", "open loop"])


@laws
def test_sequence_waits_at_pause_points_and_completes(law: str) -> None:
    sim = auto_1([2, 4], law)
    first = until(sim, "ready", PROCEED)
    assert {f.sequence for f in first[:-1]} == {"checking", "in progress"}
    assert (first[0].point, first[0].points, first[-1].point) == (1, 4, 3)
    assert first[-1].check is not None and first[-1].check.good
    distance, turn = away(sim, fly(sim, 10.0, aftdeck.Inputs())[-1:], POINTS[1])
    assert distance[0] < 0.02 and turn[0] < 0.005  # the arm waits at the point
    assert sim.frame is not None and sim.frame.sequence == "ready" and sim.frame.point == 3
    rest = until(sim, "idle", PROCEED)
    assert [event.kind for event in rest[-1].events] == ["arrived", "sequence"]
    assert away(sim, rest[-1:], POINTS[3])[0][0] < 0.02 and rest[-1].goal is None and rest[-1].point == 4


def test_fly_by_point_is_passed_without_slowing_to_rest() -> None:
    sim = auto_1([4], more="fly_by_within = 0.4\nfly_by_angle = 0.15")
    frames = until(sim, "idle", PROCEED)
    assert [t.split(", ")[1] for t in log_of(frames) if "point" in t] == [
        "point 1 of 4 passed", "point 2 of 4 passed", "point 3 of 4 passed", "point 4 of 4 reached",
    ]  # fmt: skip
    for number, point in enumerate(POINTS[:3], 1):
        distance, turn = away(sim, frames, point)
        passed = next(k for k, f in enumerate(frames) if f"AUTO 1, point {number} of 4 passed" in log_of([f]))
        # the line is written one step after the tip was in the sphere
        assert distance[passed - 1] <= 0.4 and turn[passed - 1] <= 0.15
        assert min(speed(f) for f in frames[passed - 10 : passed + 200]) > 0.05
    assert frames[-1].time_s < until(auto_1([1, 2, 3, 4]), "ready", PROCEED)[-1].time_s * 4


def test_modes_1_and_3_reach_each_fly_by_point() -> None:
    for law in ("position", "open loop"):
        sim = auto_1([4], law)
        frames = until(sim, "idle", PROCEED)
        for point in POINTS:
            distance, turn = away(sim, frames, point)
            assert distance.min() < 0.02 and turn[distance.argmin()] < 0.005
        assert {f.sequence for f in frames[:-1]} == {"checking", "in progress"}


@laws
def test_proceed_after_stop_continues_to_the_same_point(law: str) -> None:
    sim = auto_1([1, 2, 3, 4], law)
    fly(sim, 3.0, PROCEED)
    stopped = fly(sim, 6.0, aftdeck.Inputs(stop=True))
    assert {(f.sequence, f.point) for f in stopped} == {("ready", 1)} and speed(stopped[-1]) == 0.0
    assert away(sim, stopped[-1:], POINTS[0])[0][0] > 0.3
    going = until(sim, "ready", PROCEED)
    assert going[-1].point == 2 and away(sim, going[-1:], POINTS[0])[0][0] < 0.02


def test_proceed_restarts_a_complete_sequence() -> None:
    sim = auto_1([4])
    until(sim, "idle", PROCEED)
    again = until(sim, "idle", PROCEED)
    assert [t for t in log_of(again) if "reached" in t] and again[0].point == 1


def test_proceed_restarts_a_sequence_of_one_point() -> None:
    point = f"[[sequence.point]]\ntarget = {{ joints = {[f'{q} deg' for q in joints(POINTS[0])]} }}"
    sim = aftdeck.Simulation(scenario(BAY, f'mode = "AUTO 1"\n[[sequence]]\nslot = 1\n{point}\n'))
    for _ in range(4):  # from the third PROCEED on, the arm has not moved since the last check began
        assert until(sim, "idle", PROCEED)[-1].events[-1].kind == "sequence"


def test_entering_the_mode_again_begins_at_first_point() -> None:
    sim = auto_1([1, 2, 3, 4])
    until(sim, "ready", PROCEED)
    assert sim.step(aftdeck.Inputs(mode="ORB UNL")).sequence == "idle"
    frame = checked(sim, aftdeck.Inputs(mode="AUTO 1"))[-1]
    assert (frame.point, frame.sequence) == (1, "ready") and frame.check is not None and frame.check.good


def test_auto_mode_without_points_is_rejected() -> None:
    frame = auto_1([4]).step(aftdeck.Inputs(mode="AUTO 2"))
    assert frame.mode == "AUTO 1"
    assert frame.events[-1].kind == "refused" and "AUTO 2" in frame.events[-1].text


def test_sequence_continues_from_disturbed_position() -> None:
    sim = auto_1([1, 2, 3, 4])
    until(sim, "ready", PROCEED)
    disturbed(sim, {0: BAY[0] + 9.0})
    going = until(sim, "ready", PROCEED)
    assert going[-1].point == 3 and away(sim, going[-1:], POINTS[1])[0][0] < 1e-3


def test_impossible_point_stops_the_sequence_with_its_cause() -> None:
    far = f"[[sequence.point]]\ntarget = {{ joints = {[f'{q} deg' for q in (*BAY[:3], -118.5, *BAY[4:])]} }}\n"
    near = f"[[sequence.point]]\ntarget = {{ joints = {[f'{q} deg' for q in joints(POINTS[0])]} }}\npause = true\n"
    for law in ("closed loop", "position", "open loop"):
        sim = aftdeck.Simulation(scenario(BAY, f'mode = "AUTO 3"\nlaw = "{law}"\n[[sequence]]\nslot = 3\n{near}{far}'))
        frames = until(sim, "idle", PROCEED)
        stopped = checked(sim)[-1]
        assert stopped.check is not None and stopped.check.cause == "limit" and "wrist pitch" in stopped.check.text
        assert stopped.sequence == "idle" and frames[-1].point == 2
        assert speed(fly(sim, 6.0, aftdeck.Inputs())[-1]) == 0.0
        frame = checked(sim, PROCEED)[-1]
        assert frame.sequence == "idle" and [e.kind for e in frame.events] == ["refused"]


def test_script_gives_proceed_at_every_pause_point() -> None:
    text = auto_1([2, 4]).scenario.text + '\n[[phase]]\nname = "tour"\nmode = "AUTO 1"\n'
    done = aftdeck.run(parse_scenario(text, "t", "t.toml", Path(".")))
    assert done.summary.ended == "completed"
    assert sum(e.kind == "proceed" for e in done.summary.events) == 2


def test_sequence_at_0_08_s_ends_at_its_last_point() -> None:
    for law in ("position", "closed loop", "open loop"):
        sim = auto_1([4], law, "control_period = 0.08\nduration = 240")
        frames = until(sim, "idle", PROCEED)
        assert away(sim, frames[-1:], POINTS[3])[0][0] < 0.02
        assert math.isfinite(frames[-1].time_s)


@pytest.mark.parametrize("law", ["position", "open loop"])
def test_missed_point_is_logged_and_sequence_continues(law: str) -> None:
    sim = auto_1([4], law)
    flown = fly(sim, 3.0, PROCEED)
    disturbed(sim, {1: math.degrees(flown[-1].angles[1]) + 1.0})
    frames = until(sim, "idle", aftdeck.Inputs())
    arrivals = [(e.level, e.text) for f in frames for e in f.events if e.kind == "arrived"]
    assert [level for level, _ in arrivals] == ["caution", "info", "info", "info"]
    assert all(f"point {k} of 4 " in text for k, (_, text) in enumerate(arrivals, 1))
    assert re.search(r" \d+ mm, [01]\.\d+°", arrivals[0][1]), arrivals[0]
