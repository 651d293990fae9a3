"""Stops of an arm with masses: the log's measurements against the frames, and laws of brakes, safing and payloads."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pinocchio
import pytest

from aftdeck.arms.load import load_model
from aftdeck.arrays import Array
from aftdeck.kinematics.arm import Arm
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.motion.tip_rest import AT_REST, SLOTS, WINDOW
from aftdeck.simulation.run import Simulation
from aftdeck.units import FOOT, POUND
from benchmarks.flight_tests import Measured, measured
from benchmarks.stops import LOADS, stop
from tests.plant.multibody.flights import scenario
from tests.plant.multibody.test_model import of_pinocchio

STEP = Inputs(mode="ORB UNL", translation=(0.6, -0.4, -0.7))
ENDS = {"command": Inputs(), "brakes": Inputs(brakes=True), "safing": Inputs(safing=True)}
PERIOD = 0.02


class Stopped(NamedTuple):
    """A stop: its log lines, the true tip in each step since the last step of the command [m], and the run."""

    lines: list[Measured]
    tips: Array
    before: Array
    sim: Simulation


def stopped(plant: str, last: Inputs, *, step: Inputs = STEP, seconds: float = 5.0, pounds: float = 0.0) -> Stopped:
    """Move the tip for some time, stop, and wait for the log line of the stop."""
    given = scenario(plant, pounds=pounds)
    sim = Simulation(replace(given, arm=Arm(replace(given.arm.model, units="SI"))))
    lines: list[Measured] = []
    tips = [sim.step(step).dynamics for _ in range(round(seconds / PERIOD))][-2:]
    while not lines:
        frame = sim.step(last)
        last = Inputs()
        tips.append(frame.dynamics)
        lines += [measured(event.text) for event in frame.events if event.kind == "stop"]
    places = np.array([tip.position for tip in tips if tip is not None])
    return Stopped(lines, places[1:], places[0], sim)


def diagonal(tips: Array) -> float:
    return float(np.linalg.norm(np.ptp(tips, axis=0)))


@pytest.mark.slow
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize("end", ENDS)
def test_log_line_agrees_with_the_path_of_the_true_tip(plant: str, end: str) -> None:
    (line,), tips, before, _ = stopped(plant, ENDS[end])
    window = round(WINDOW / PERIOD)
    slot = round(WINDOW / SLOTS / PERIOD)
    rests = next(k for k in range(len(tips)) if diagonal(tips[k : k + window]) < AT_REST)
    rests_longer = next(k for k in range(len(tips)) if diagonal(tips[k : k + window + slot]) < AT_REST)
    away = np.linalg.norm(tips - tips[0], axis=1)
    last = 0.5 * (tips[-window - 1 : -1].min(axis=0) + tips[-window - 1 : -1].max(axis=0))
    turned = np.maximum.accumulate(np.maximum.accumulate(away) - away) > 1e-4
    swung = float(np.linalg.norm(tips[turned] - last, axis=1).max(initial=0.0))
    assert line.left is None
    assert rests * PERIOD - 0.051 <= line.seconds <= (rests_longer + slot) * PERIOD + 0.05
    assert line.speed == pytest.approx(math.dist(tips[0], before) / PERIOD, rel=0.006)
    assert line.moved == pytest.approx(math.dist(last, tips[0]), rel=0.006, abs=6e-5)
    assert line.farther == pytest.approx(max(away.max() - math.dist(last, tips[0]), 0.0), rel=0.006, abs=6e-5)
    assert 0.99 * swung - 6e-5 <= line.swung <= 1.42 * swung + 6e-5


@pytest.mark.slow
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize("end", ENDS)
def test_path_of_a_stop_is_not_shorter_than_the_straight_distances(plant: str, end: str) -> None:
    (line,), tips, _, _ = stopped(plant, ENDS[end])
    path = np.linalg.norm(np.diff(tips, axis=0), axis=1).sum()
    assert path + 1e-4 >= line.moved + line.farther  # rounded to 0.1 mm
    farthest = line.moved + (line.moved + line.farther)  # from the last place over the first one
    assert line.swung <= 1.42 * farthest + 1e-3  # 1.42: `swing_about` measures with a box


def test_brakes_stop_the_arm_in_a_shorter_distance_than_the_end_of_the_command() -> None:
    brakes, command = (stopped("rigid", ENDS[end]).lines[0] for end in ("brakes", "command"))
    assert brakes.moved + brakes.farther < command.moved + command.farther


@pytest.mark.slow
@pytest.mark.parametrize("end", ENDS)
def test_loaded_arm_stops_in_no_shorter_distance_than_the_unloaded_arm_from_the_same_speed(end: str) -> None:
    found = []
    for pounds in (0.0, 32_000.0):
        (limit, _), *_ = load_model("srms").por_limits(pounds * POUND)
        step = Inputs(mode="ORB UNL", translation=(0.03 / limit, 0.0, 0.0))
        found += stopped("rigid", ENDS[end], step=step, seconds=40.0, pounds=pounds).lines
    unloaded, loaded = found
    assert loaded.speed == pytest.approx(unloaded.speed, rel=0.02)
    assert loaded.moved + loaded.farther >= unloaded.moved + unloaded.farther


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_brakes_hold_the_joints_within_two_steps_of_the_encoders_after_the_stop(axis: int) -> None:
    direction = tuple(float(k == axis) for k in range(3))
    sim = stopped("rigid", ENDS["brakes"], step=Inputs(mode="ORB UNL", translation=direction)).sim  # type: ignore[arg-type]
    servo = load_model("srms").servo
    assert servo is not None
    start = sim._state.plant.angles.copy()
    for _ in range(1000):
        sim.step(Inputs())
        assert (np.abs(sim._state.plant.angles - start) < 2.5 * servo.encoder_step).all()


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_no_rate_is_commanded_after_safing_or_brakes(plant: str) -> None:
    for end in ("safing", "brakes"):
        sim = Simulation(scenario(plant))
        for _ in range(100):
            sim.step(STEP)
        held = [sim.step(ENDS[end]), *(sim.step(STEP) for _ in range(200))]
        assert all(rate == 0.0 for frame in held for rate in frame.rates_commanded)


def test_brake_stops_one_joint_as_its_holding_torque_and_friction_do() -> None:
    # a constant torque stops an inertia I from the rate w within the angle I w^2 / (2 T)
    model, rate, mass, moment = load_model("srms"), math.radians(1.27), 10_000.0, 20_000.0
    angles = np.radians([0.0, 60.0, -60.0, -20.0, 0.0, 0.0])
    made, armature = of_pinocchio(model)
    arm = pinocchio.crba(made, made.createData(), angles)[0, 0] + armature[0]
    tip = Arm(model).jacobian(angles)[3:, 0]  # its velocity for a yaw rate of 1 rad/s
    inertia = arm + mass * float(tip @ tip) + moment
    assert model.servo is not None
    torque = float(model.servo.holding_torque[0] + model.servo.friction[0])
    joints = f"joints = {angles.tolist()}\nrates = [{rate}, 0, 0, 0, 0, 0]"
    payload = f"[payload]\nmass = {mass}\ninertia = [{moment}, {moment}, {moment}]\n"
    sim = Simulation(scenario("rigid", payload, initial=joints))
    found = [sim.step(Inputs(brakes=True) if step == 0 else Inputs()).angles[0] for step in range(1000)]
    assert max(found) == pytest.approx(inertia * rate**2 / (2.0 * torque), rel=0.01)


def test_setting_and_releasing_the_brakes_each_begin_a_stop_of_their_own() -> None:
    sim, causes = Simulation(scenario("flexible")), []
    for inputs, steps in (
        (STEP, 250),
        (Inputs(), 250),
        (Inputs(brakes=True), 250),
        (Inputs(brakes=False), 250),
        (STEP, 2),
    ):
        for step in range(steps):
            frame = sim.step(inputs if step == 0 or inputs == STEP else Inputs())
            causes += [
                event.text.split(" after ")[1].split(" at ")[0] for event in frame.events if event.kind == "stop"
            ]
    assert causes == ["the command", "BRAKES", "BRAKES off"]


def test_release_of_the_brakes_at_rest_is_not_logged() -> None:
    sim = stopped("rigid", ENDS["brakes"]).sim
    frames = [sim.step(Inputs(brakes=False)), *(sim.step(Inputs()) for _ in range(400))]
    assert not [event for frame in frames for event in frame.events if event.kind == "stop"]


def test_kinematic_arm_logs_no_stop() -> None:
    sim, kinds = Simulation(scenario("kinematic")), []
    for step in range(600):
        kinds += [event.kind for event in sim.step(STEP if step < 250 else Inputs()).events]
    assert "stop" not in kinds


def test_saved_run_continues_to_the_last_bit_during_a_stop() -> None:
    sim = Simulation(scenario("flexible"))
    for step in range(350):
        sim.step(STEP if step < 250 else Inputs())
    other = Simulation(sim.scenario)
    other.restore(sim.save())
    for _ in range(400):
        assert sim.step(Inputs()) == other.step(Inputs())
    assert sim.save() == other.save()


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("pounds", LOADS)
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_loaded_arm_stops_within_two_feet_for_every_mass(plant: str, pounds: float) -> None:
    assert 0.5 * FOOT < stop(plant, pounds, "stretched", 2.3) < 2.0 * FOOT
