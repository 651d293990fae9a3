"""Arms of any chain of joints: each is one file, and flies, collides, is recorded, reported and drawn as any other."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

import aftdeck
from aftdeck import Inputs
from aftdeck.errors import AftdeckError, UnreachableError
from aftdeck.frames import Pose
from aftdeck.recording.reader import Recording
from aftdeck.recording.replay import verify
from aftdeck.recording.run import record
from aftdeck.report.of_recording import metrics_of
from aftdeck.scenario.load import load_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Simulation, run
from tests.each import number
from tests.loaded import CHAINS
from tests.simulation.flights import random_inputs

NAMES = ["five", "seven", "rail"]
ARMS = pytest.mark.parametrize("name", NAMES)
LAWS = {2, 1, 3, 4, 5, 8, 9, 10}
"""Steering laws that the flights use: those of OPR CMD, ORB UNL, END EFF, SINGLE, DIRECT and MASTER."""


def flight(name: str) -> Scenario:
    return load_scenario(CHAINS / f"fly-{name}.toml")


@pytest.fixture(scope="module", params=NAMES)
def flown(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording of a whole flight."""
    path: Path = tmp_path_factory.mktemp("chains") / f"{request.param}.mcap"
    assert record(flight(request.param), path).summary.ended == "completed"
    return path


def frames(path: Path) -> list[Frame]:
    return [frame for _, frame in Recording(path).steps()]


def test_flight_uses_every_kind_of_mode_and_reaches_its_targets(flown: Path) -> None:
    seen = frames(flown)
    assert {frame.law for frame in seen} == LAWS
    assert sum(event.text == "target reached" for frame in seen for event in frame.events) == 3


def test_no_joint_exceeds_a_limit(flown: Path) -> None:
    limits = aftdeck.load_arm(CHAINS / f"{flown.stem}.toml").limits.hard
    for frame in frames(flown):
        assert all(abs(rate) <= most * (1.0 + 1e-6) for rate, most in zip(frame.rates, frame.rate_limits, strict=True))
        assert (limits[:, 0] - 1e-9 <= frame.angles).all() and (frame.angles <= limits[:, 1] + 1e-9).all()


def test_recording_is_repeated_bit_for_bit(flown: Path) -> None:
    verdict = verify(flown)
    assert verdict.equal and verdict.whole and "/frames" in verdict.recomputed


def test_metrics_are_those_of_the_arms_joints(flown: Path) -> None:
    found = {metric.column: value.number for metric, value in metrics_of(Recording(flown)).items()}
    assert found["captures"] == 0.0 and (found["tip_path_m"] or 0.0) > 5.0


@ARMS
def test_an_arm_of_any_chain_collides(name: str) -> None:
    sim = Simulation(load_scenario(CHAINS / f"fly-{name}.toml"))
    down = Inputs(translation=(0.0, 0.0, 1.0))
    for _ in range(3000):
        frame = sim.step(down)
        if frame.work.arm_inhibit:
            break
    assert frame.work.arm_inhibit and frame.work.contacts
    frame = sim.step(down)  # inhibits act in the next step
    assert all(abs(rate) < 1e-9 for rate in frame.rates_commanded)


@ARMS
@pytest.mark.parametrize("seed", range(number(2, 8)))
def test_any_inputs_keep_the_limits(name: str, seed: int) -> None:
    given = flight(name)
    sim, most = Simulation(given, seed), given.arm.limits.hard
    for inputs in random_inputs(np.random.default_rng(seed), 600):
        joint = None if inputs.joint is None else inputs.joint % len(given.arm.joints)
        frame = sim.step(replace(inputs, joint=joint))
        assert np.isfinite(frame.rates).all() and len(frame.rates) == len(given.arm.joints)
        assert (most[:, 0] - 1e-9 <= frame.angles).all() and (frame.angles <= most[:, 1] + 1e-9).all()


@ARMS
def test_pose_out_of_reach_is_refused_with_the_miss(name: str) -> None:
    arm = aftdeck.load_arm(CHAINS / f"{name}.toml")
    far = arm.forward(arm.limits.reach.mean(axis=1))
    away = Pose(np.asarray(far.position) * 100.0, far.rotation)
    with pytest.raises(UnreachableError, match="within") as error:
        arm.inverse(away)
    assert error.value.excess > 10.0


@ARMS
@pytest.mark.parametrize("plant", ["kinematic", "rigid"])
def test_script_flies_on_each_plant(name: str, plant: str) -> None:
    assert run(load_scenario(CHAINS / f"fly-{name}.toml", {"plant": plant})).summary.ended == "completed"


def test_chain_whose_file_has_springs_flies_on_the_flexible_plant() -> None:
    sim = Simulation(load_scenario(CHAINS / "fly-seven.toml", {"plant": "flexible"}))
    most = 0.0
    for _ in range(400):
        dynamics = sim.step().dynamics
        assert dynamics is not None and [bend.part for bend in dynamics.bends] == ["base", "upper_boom", "lower_boom"]
        most = max(most, *(abs(part) for bend in dynamics.bends for part in bend.displacement))
    assert 1e-5 < most < 0.05


def test_chain_without_springs_has_no_flexible_plant() -> None:
    with pytest.raises(AftdeckError, match="flexibility"):
        Simulation(load_scenario(CHAINS / "fly-five.toml", {"plant": "flexible"}))
