"""Metrics of torques, bends and loads against the time history of the same run."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace as replace_fields

from aftdeck.kinematics.arm import Arm
from aftdeck.plant.readings import CUTS
from aftdeck.recording.reader import Recording
from aftdeck.recording.run import record
from aftdeck.report.catalogue import named
from aftdeck.report.of_recording import metrics_of
from aftdeck.report.recorded import NEED_GAUGES, ReadingMetrics
from aftdeck.report.run_metrics import RunMetrics
from aftdeck.report.series import series_of
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.reading import Known
from aftdeck.simulation.run import run
from aftdeck.study.case import Runner
from aftdeck.study.design import cases
from aftdeck.study.file import load_study
from aftdeck.study.plan import plan_of
from tests.joints import with_joints
from tests.plant.multibody.flights import scenario
from tests.study.studies import FOUR, written

AT_LIMIT = [named(f"torque_limit_time_joint_{k}_s") for k in range(1, 7)]
PUSH = "[[phase]]\nname = 'push'\nmode = 'ORB UNL'\ntranslation = [1.0, 0.0, -1.0]\nduration = '3 s'\n"


def weak(given: Scenario, share: float) -> Scenario:
    """Return a scenario whose motors have a share of their torque."""
    model = given.arm.model
    assert model.servo is not None
    return replace(
        given, arm=Arm(replace(model, servo=model.servo._replace(torque_limit=share * model.servo.torque_limit)))
    )


def test_metrics_are_those_of_the_time_history(tmp_path: Path) -> None:
    record(scenario("flexible", PUSH, pounds=8000.0), tmp_path / "run.mcap")
    table = series_of(Recording(tmp_path / "run.mcap"))
    found = metrics_of(Recording(tmp_path / "run.mcap"), gauged=True)
    joints = ("shoulder_yaw", "shoulder_pitch", "elbow_pitch", "wrist_pitch", "wrist_yaw", "wrist_roll")
    for k, joint in enumerate(joints, 1):
        assert found[named(f"peak_torque_joint_{k}_n_m")].number == pytest.approx(
            np.abs(table[f"torque_{joint}_n_m"]).max()
        )
    for cut in CUTS:
        assert found[named(f"peak_moment_{cut}_n_m")].number == max(table[f"{cut}_peak_moment_n_m"])
    for part in ("base", "upper_boom", "lower_boom"):
        turns = np.linalg.norm([table[f"bend_{part}_{axis}_rad"] for axis in "xyz"], axis=0)
        assert found[named(f"peak_bend_{part}_rad")].number == pytest.approx(turns.max()) and turns.max() > 0.0
    bends = {metric.column for metric in found if metric.column.startswith("peak_bend_") and metric.quantity == "gap"}
    assert bends == {"peak_bend_upper_boom_m", "peak_bend_lower_boom_m"}
    assert NEED_GAUGES.isdisjoint(metric.column for metric in metrics_of(Recording(tmp_path / "run.mcap")))
    assert {metric.column for metric in found} >= NEED_GAUGES


@pytest.mark.parametrize("share", [1.0, 0.02])
def test_time_at_the_torque_limit_is_that_of_a_motor_too_weak(share: float) -> None:
    given = weak(scenario("rigid", PUSH, pounds=32_000.0), share)
    metrics = RunMetrics(given)
    torques = run(given, seen=lambda frame: metrics.see(frame, ())).table("torques")
    found = metrics.found()
    assert given.arm.model.servo is not None
    for k, name in enumerate(list(torques)[1:]):
        at_limit = np.abs(torques[name]) >= given.arm.model.servo.torque_limit[k] * (1.0 - 1e-9)
        assert found[AT_LIMIT[k]].number == pytest.approx(at_limit.sum() * given.control_period)
    assert (sum(found[metric].number or 0.0 for metric in AT_LIMIT) > 0.0) == (share < 1.0)


def test_study_that_names_a_moment_has_its_value(tmp_path: Path) -> None:
    text = FOUR.replace("repeats = 2", "metrics = ['peak_moment_upper_boom_n_m', 'peak_torque_joint_2_n_m']")
    written(tmp_path, text)
    short = tmp_path / "short.toml"
    short.write_text(short.read_text().replace('arm = "srms"', 'arm = "srms"\nplant = "rigid"'))
    study = load_study(tmp_path / "study.toml")
    row = Runner(plan_of(study)).run(cases(study)[0]).row
    moment, torque = row["peak_moment_upper_boom_n_m"], row["peak_torque_joint_2_n_m"]
    assert isinstance(moment, float) and isinstance(torque, float) and moment > 1.0 and torque > 1.0


def test_study_has_gauges_only_if_it_names_a_metric_that_needs_them(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    for extra in ("", "metrics = ['run_time_s']\n", "metrics = ['peak_moment_end_effector_n_m']\n"):
        file.write_text(f"title = 'a study'\nscenario = 'loaded'\n{extra}", encoding="utf-8")
        assert load_study(file).gauged == any(column in extra for column in NEED_GAUGES)
    text = "title = 'a study'\nscenario = 'loaded'\n[success.at_most]\npeak_moment_upper_boom_n_m = 500.0\n"
    file.write_text(text, encoding="utf-8")
    assert load_study(file).gauged


@pytest.mark.parametrize("joints", [1, 5, 7, 8])
def test_a_run_has_the_metrics_of_its_arms_joints_only(joints: int) -> None:
    given = scenario("rigid", PUSH)
    made, frames = replace(given, arm=with_joints(given.arm, joints)), list[Frame]()
    run(given, seen=frames.append)
    metrics, most = ReadingMetrics(made), [0.0] * joints
    for frame in frames[:20]:
        assert frame.dynamics is not None
        torques = tuple(1e-3 * (k + 1) * abs(frame.dynamics.torques[0]) for k in range(joints))  # below all limits
        most = list(map(max, most, torques))
        metrics.see(Known(replace_fields(frame, dynamics=replace_fields(frame.dynamics, torques=torques)), made))
    found = {metric.column: value.number for metric, value in metrics.found()}
    assert [found[f"peak_torque_joint_{k}_n_m"] for k in range(1, joints + 1)] == most and max(most) > 0.0
    assert [found[f"torque_limit_time_joint_{k}_s"] for k in range(1, joints + 1)] == [0.0] * joints
    assert not any(f"joint_{k}" in column for column in found for k in range(joints + 1, 9))
