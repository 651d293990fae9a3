"""Headless runs: their ends, summaries and frames."""

from __future__ import annotations

import json
import math

import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck.errors import InputError
from aftdeck.simulation.frame import Frame
from tests.steering.flying import BAY, LEAN, scenario

FIELDS = {
    "scenario", "seed", "version", "ended", "time_s", "phase", "joints_rad", "tip", "target", "position_error_m",
    "rotation_error_rad", "worst_rate_ratio", "min_clearance_m", "events", "frames_sha256",
    "true_position_error_m", "true_rotation_error_rad",
}  # fmt: skip
PUSH = "[[phase]]\nname = 'push'\nmode = 4\ntranslation = [0.2, 0, 0]\nduration = 2\n"
FAR = "[[phase]]\nname = 'far'\nmode = 2\ntarget = { frame = 'L', position = [100, 0, 0] }\n"
NEAR_BY = [BAY[0] + 2.0, *BAY[1:]]
NEAR = f"[[phase]]\nname = 'near'\nmode = 2\ntarget = {{ joints = {[f'{q} deg' for q in NEAR_BY]} }}\n"


def ends(extra: str) -> aftdeck.Summary:
    return aftdeck.run(scenario(extra=extra)).summary


def test_scenario_without_phases_ends_at_its_duration() -> None:
    found = ends("duration = 3")
    assert (found.ended, found.time_s, found.phase) == ("time", 3.0, "")
    assert found.target is None and found.position_error_m is None and found.rotation_error_rad is None


def test_script_that_ends_is_completed() -> None:
    found = ends(f"duration = 30\n{PUSH}{NEAR}")
    assert (found.ended, found.phase) == ("completed", "near")


def test_phase_that_ends_with_the_scenario_is_completed() -> None:
    assert ends(f"duration = 2\n{PUSH}").ended == "completed"


def test_timed_phase_lasts_its_duration() -> None:
    frames = aftdeck.run(scenario(extra=f"duration = 30\n{PUSH}")).frames
    pushed = [f for f in frames if f.translation != (0.0, 0.0, 0.0)]
    assert len(pushed) == 100 and {f.phase for f in frames} == {"push"}
    assert {f.by for f in frames} == {"script"}


def test_script_that_exceeds_the_duration_is_a_fault() -> None:
    found = ends(f"duration = 1\n{PUSH}")
    assert (found.ended, found.time_s, found.phase) == ("fault", 1.0, "push")
    assert "fault" in [event.kind for event in found.events]


def test_phase_that_exceeds_its_time_is_a_fault() -> None:
    found = ends(f"duration = 30\n{NEAR}duration = 0.5\n")
    assert found.ended == "fault" and found.phase == "near"
    (text,) = (e.text for e in found.events if e.kind == "fault")
    assert "'near'" in text and "0.5 s" in text


@pytest.mark.parametrize("before", ["", PUSH, NEAR])
def test_phase_with_rejected_target_is_a_fault(before: str) -> None:
    found = ends(f"duration = 30\n{before}{FAR}")
    assert found.ended == "fault" and found.phase == "far"
    assert "refused" in [event.kind for event in found.events]


def test_scripted_motion_blocked_by_soft_stop_is_a_fault() -> None:
    goal = "target = { joints = [0, '60 deg', '-80 deg', '119 deg', '10 deg', 0] }"
    made = scenario((0, 60, -80, 110, 10, 0), f"duration = 60\n[[phase]]\nname = 'out'\nmode = 2\n{goal}\n")
    found = aftdeck.run(made).summary
    assert found.ended == "fault" and found.time_s < 60.0


def test_summary_has_documented_fields_and_is_json() -> None:
    for name in ("uncradle", "sts-400-closed"):
        summary = aftdeck.run(name, keep_frames=False).summary
        found = json.loads(msgspec.json.encode(summary))
        assert set(found) == FIELDS
        assert set(found["tip"]) == {"position_m", "rotation"}
        assert all(set(event) == {"time_s", "kind", "text"} for event in found["events"])
        assert len(found["frames_sha256"]) == 64 and found["version"] == aftdeck.__version__
        assert np.array(found["tip"]["rotation"]).shape == (3, 3)


def test_summary_agrees_with_the_last_frame() -> None:
    done = aftdeck.run("sts-400-closed")
    last, summary = done.frames[-1], done.summary
    assert (summary.time_s, summary.joints_rad, summary.tip.position_m) == (last.time_s, last.angles, last.position)
    pose = done.scenario.arm.forward(last.angles)
    assert summary.tip.position_m == pytest.approx(pose.position, abs=1e-12)
    assert np.array(summary.tip.rotation) == pytest.approx(pose.rotation, abs=1e-12)
    assert summary.target is not None
    goal = done.scenario.arm.forward(np.radians([-118.4, 108.9, -107.4, 67.1, -1.1, -6.3]))
    assert summary.target.position_m == pytest.approx(goal.position, abs=1e-12)
    assert summary.position_error_m == pytest.approx(math.dist(goal.position, pose.position), abs=1e-12)


def test_worst_rate_ratio_is_largest_rate_over_limit() -> None:
    done = aftdeck.run("first-flight")
    ratios = [abs(r) / m for f in done.frames for r, m in zip(f.rates_commanded, f.rate_limits, strict=True)]
    assert done.summary.worst_rate_ratio == max(ratios) <= 1.0


def test_progress_is_reported_and_rises() -> None:
    told: list[float] = []
    aftdeck.run("sts-400-closed", keep_frames=False, progress=told.append)
    assert len(told) > 3 and told == sorted(told) and told[0] > 0.0 and told[-1] <= 1.0


def step_of(made: aftdeck.Scenario) -> list[Frame]:
    sim = aftdeck.Simulation(made)
    rng = np.random.default_rng(110)
    return [
        sim.step(aftdeck.Inputs(rotation=tuple(rng.uniform(-1, 1, 3).tolist()), translation=(0.3, 0.0, 0.1)))
        for _ in range(100)
    ]


def test_frame_numbers_and_times_are_whole_periods() -> None:
    frames = step_of(scenario(extra="control_period = '80 ms'\nduration = 80"))
    assert [f.tick for f in frames] == list(range(1, 101))
    assert [f.time_s for f in frames] == [round(0.08 * k, 9) for k in range(1, 101)]


def test_frame_pose_twist_and_singularities_follow_from_angles() -> None:
    made = scenario()
    for frame in step_of(made):
        pose = made.arm.forward(frame.angles)
        assert frame.position == pytest.approx(pose.position, abs=1e-13)
        assert np.array(frame.orientation) == pytest.approx(pose.rotation, abs=1e-13)
        assert frame.twist == pytest.approx(made.arm.jacobian(frame.angles) @ frame.rates, abs=1e-13)
        assert frame.singularity == pytest.approx([float(d) for d in made.arm.singularities(frame.angles)])


def test_kinematic_plant_integrates_the_commanded_rates() -> None:
    made = scenario()
    angles = np.array(made.initial_angles)
    for frame in step_of(made):
        angles += np.array(frame.rates_commanded) * 0.02
        assert frame.rates == frame.rates_commanded
        assert frame.angles == pytest.approx(angles, abs=1e-13) and frame.angles_commanded == frame.angles


def test_demand_is_stick_times_limit_in_orbiter_axes() -> None:
    frame = aftdeck.Simulation(scenario()).step(aftdeck.Inputs(translation=(0.0, 0.0, 1.0)))
    # the arm's base leans to port, so the orbiter's down direction has components down and to port in L
    wanted = [0.0, math.sin(LEAN) * 0.6096, math.cos(LEAN) * 0.6096]
    assert frame.twist_demanded[3:] == pytest.approx(wanted) and frame.twist_demanded[:3] == (0.0, 0.0, 0.0)


def test_given_inputs_replace_the_script() -> None:
    """`run` with inputs makes the same frames as `step` with these inputs. A first step without inputs is an error."""
    given = [aftdeck.Inputs(translation=(0.2 * k, 0.0, 0.0)) for k in range(4)]
    left, seen = iter(given), []
    done = aftdeck.run("first-flight", inputs=lambda _: next(left, None), stepped=lambda sim: seen.append(sim.given))
    sim = aftdeck.Simulation("first-flight")
    assert done.frames == tuple(sim.step(inputs) for inputs in given) and seen == given
    assert done.summary.ended == "completed" and {frame.by for frame in done.frames} == {"hand"}
    with pytest.raises(InputError):
        aftdeck.run("first-flight", inputs=lambda _: None)
