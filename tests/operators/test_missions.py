"""Synthetic operators complete every built-in task, without a contact that inhibits the arm."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from _pytest.mark import ParameterSet

from aftdeck.errors import InputError
from aftdeck.operators.pilot import Pilot, pilot
from aftdeck.operators.spec import Kind, OperatorSpec
from aftdeck.recording.reader import Recording
from aftdeck.recording.records import FrameRecord
from aftdeck.recording.replay import verify
from aftdeck.recording.run import record
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.run import Run as Flight
from aftdeck.simulation.run import run as fly
from tests.commands import Run
from tests.loaded import names_with
from tests.scenario.missions import takes_its_minutes

TASKS = names_with("step")
WITH_PAYLOAD = ("tutorial", "srms-deploy", "srms-berth", "concept-1972", "free-flyer")
IN_CI = {"srms-deploy": "human", "concept-1972": "perfect"}
"""Tasks with both arms that CI flies, each with one kind of operator; the others are long."""
KINDS: tuple[Kind, ...] = ("perfect", "human")
QUICK = ("tutorial", "first-flight", "singular", "uncradle", "sequence", "sts-400-closed")


def flown(name: str, kind: Kind, seed: int = 1, plant: str = "kinematic") -> tuple[Pilot, Flight, list[Frame]]:
    scenario = load_scenario(name, {("plant",): plant})
    operator = pilot(scenario, OperatorSpec(kind), seed)
    assert isinstance(operator, Pilot)
    inhibited: list[Frame] = []

    def seen(frame: Frame) -> None:
        if frame.work.arm_inhibit:
            inhibited.append(frame)

    return operator, fly(scenario, inputs=operator, keep_frames=False, seen=seen), inhibited


def completes(name: str, kind: Kind, plant: str = "kinematic") -> None:
    operator, result, inhibited = flown(name, kind, plant=plant)
    assert operator.progress.present is None, operator.progress.present.title
    assert result.summary.ended == "completed"
    assert operator.progress.skipped == ()
    assert not inhibited
    assert kind == "perfect" or takes_its_minutes(result.scenario, result.summary.time_s)


@pytest.mark.parametrize("name", QUICK)
def test_the_perfect_operator_completes_short_tasks(name: str) -> None:
    completes(name, "perfect")


def those_of_ci(names: tuple[str, ...]) -> list[ParameterSet]:
    """Return scenarios and kinds of operators as parameters; all but those of `IN_CI` are marked long."""
    return [
        pytest.param(name, kind, marks=() if IN_CI.get(name) == kind else pytest.mark.long)
        for name in names
        for kind in KINDS
    ]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "kind"), those_of_ci(TASKS))
def test_both_operators_complete_every_task(name: str, kind: Kind) -> None:
    completes(name, kind)


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize(("name", "kind"), those_of_ci(WITH_PAYLOAD))
def test_both_operators_complete_every_mission_with_rigid_bodies(name: str, kind: Kind) -> None:
    completes(name, kind, "rigid")


def test_the_seed_decides_the_flight_of_a_human_operator() -> None:
    first, again, other = (flown("first-flight", "human", seed)[1].summary.frames_sha256 for seed in (1, 1, 2))
    assert first == again
    assert first != other


def test_a_human_operator_is_slower_than_the_perfect_one() -> None:
    _, human, _ = flown("first-flight", "human")
    _, perfect, _ = flown("first-flight", "perfect")
    assert human.summary.time_s > perfect.summary.time_s


def test_an_operator_needs_steps_and_is_no_script() -> None:
    with pytest.raises(InputError, match="steps"):
        pilot(load_scenario("concept-1972-script"), OperatorSpec("perfect"), 1)
    with pytest.raises(InputError, match="script"):
        pilot(load_scenario("first-flight"), OperatorSpec("script"), 1)


def test_an_operators_flight_is_recorded_and_verified_like_a_persons(tmp_path: Path) -> None:
    scenario, path = load_scenario("first-flight"), tmp_path / "run.mcap"
    flown_by = record(scenario, path, 0, inputs=pilot(scenario, OperatorSpec("human"), 3))
    assert verify(path).equal
    frames = [message for message in Recording(path).messages() if isinstance(message, FrameRecord)]
    assert {frame.by for frame in frames} == {"hand"}
    assert len(frames) == round(flown_by.summary.time_s / scenario.control_period)


def test_the_command_flies_a_task_with_an_operator(run: Run, tmp_path: Path) -> None:
    out = tmp_path / "run.mcap"
    code, printed, _ = run("run", "first-flight", "--operator", "perfect", "--out", str(out), "--json")
    assert code == 0
    assert json.loads(printed)["ended"] == "completed"
    assert Recording(out).opening.condition == "operator perfect"


def test_the_command_says_what_an_operator_needs(run: Run) -> None:
    assert run("run", "concept-1972-script", "--operator", "human")[0] == 2
    assert run("run", "first-flight", "--operator", "robot")[0] == 2
    assert run("run", "first-flight", "--operator", "human", "--channels", "some.jsonl")[0] == 2
