"""Re-initialisation: from any state, a run continues like a new run that starts with the chosen part of the problem."""

from __future__ import annotations

import functools
import tomllib
from collections.abc import Iterable, Iterator
from pathlib import Path

import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.errors import ScenarioError
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.load import load_scenario, parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.frame import Frame
from aftdeck.worksite import load_worksite
from tests.simulation.concept import held_for, joints, scenario
from tests.simulation.flights import flown, random_inputs
from tests.steering.flying import checked

PARTS = ("full problem", "acquisition", "extraction", "manoeuvring")


@functools.cache
def problem(extra: str = "", name: str = "concept-1972") -> Scenario:
    """Return a built-in scenario, by default the report's full problem, with the lines `extra` before its text."""
    text = load_scenario(name).text
    return parse_scenario(f"{extra}\n{text}", "test", "test.toml", Path("."))


@functools.cache
def begins_there(part: str, extra: str = "", name: str = "concept-1972") -> Scenario:
    """Return a scenario that starts with one of `PARTS`, without re-initialisation."""
    text = load_scenario(name).text
    if part == "full problem":
        return parse_scenario(f"{extra}\n{text}", "test", "test.toml", Path("."))
    parts = tomllib.loads(text)["initialise"]
    head, _, rest = text.partition("[initial]")
    _, _, rest = rest.partition("[[cargo]]")
    lines = "\n".join(f"{key} = {_toml(value)}" for key, value in parts[part].items())
    return parse_scenario(f"{extra}\n{head}[initial]\n{lines}\n[[cargo]]{rest}", "test", "test.toml", Path("."))


def _toml(value: object) -> str:
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_toml(one)}" for key, one in value.items()) + " }"
    return repr(value)


def timeless(frames: list[Frame], *, first: bool) -> list[Frame]:
    """Return frames without time and digest; if `first`, the first frame also loses the log lines of initialisation."""
    found = []
    for k, frame in enumerate(frames):
        events = tuple(msgspec.structs.replace(event, time_s=0.0) for event in frame.events)
        if first and k == 0:
            events = tuple(event for event in events if event.kind not in ("initialise", "task"))
        found.append(msgspec.structs.replace(frame, tick=0, time_s=0.0, events=events, sha256=""))
    return found


def turning(given: Iterable[Inputs], made: Scenario, rng: np.random.Generator) -> Iterator[Inputs]:
    """Yield the inputs, each with a random camera command."""
    names = [camera.name for camera in cameras_of(made) if camera.drive is not None]
    for inputs in given:
        drive = CameraDrive(str(rng.choice(names)), *rng.choice([-1.0, 1.0], 3).tolist())
        yield msgspec.structs.replace(inputs, camera=drive)


def check_initialised(made: Scenario, direct: Scenario, part: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    sim = aftdeck.Simulation(made)
    flown(sim, turning(random_inputs(rng, 150), made, rng))
    later = list(random_inputs(rng, 120))
    initialised = [sim.step(Inputs(initialise=part)), *flown(sim, later)]  # type: ignore[arg-type]
    other = flown(direct, [Inputs(), *later])
    for one, two in zip(timeless(initialised, first=True), timeless(other, first=True), strict=True):
        assert one == two, initialised[0].tick
    assert initialised[0].events[0].kind == "initialise" and part in initialised[0].events[0].text


@pytest.mark.slow
@pytest.mark.parametrize("name", ["concept-1972", "free-flyer"])
@pytest.mark.parametrize("part", PARTS)
def test_initialised_run_equals_run_that_starts_there(part: str, name: str) -> None:
    check_initialised(problem("", name), begins_there(part, "", name), part, 7 + PARTS.index(part))


@pytest.mark.parametrize(("part", "task"), [("acquisition", 1), ("extraction", 2), ("manoeuvring", 3)])
@pytest.mark.parametrize("name", ["concept-1972", "free-flyer"])
def test_each_start_has_its_task_phase_and_no_contact(name: str, part: str, task: int) -> None:
    sim = aftdeck.Simulation(name)
    sim.step(Inputs())
    frame = sim.step(Inputs(initialise=part))  # type: ignore[arg-type]
    assert frame.work.task == task and not [contact for contact in frame.work.contacts if not contact.essential]


def test_initialisation_resets_every_switch() -> None:
    head = 'position_hold = true\nrate = "vernier"\nlaw = "position"'
    check_initialised(problem(head), begins_there("extraction", head), "extraction", 3)
    sim = aftdeck.Simulation(problem(head))
    flown(sim, [Inputs(position_hold=False, rate="coarse", joint=3, effector_mode="manual", rigid="derigid")])
    frame = sim.step(Inputs(initialise="full problem"))
    assert frame.position_hold and frame.rate == "vernier" and frame.joint == 0
    assert frame.work.hand.mode == "auto" and frame.work.hand.rigid == "off"


def test_initialisation_repeats_check_of_automatic_mode() -> None:
    point = 'frame = "L", position = ["28 ft", "0 ft", "-2 ft"], matrix = [[0, 0, -1], [0, 1, 0], [1, 0, 0]]'
    goal = f"[[sequence]]\nslot = 1\npoint = [{{ target = {{ {point} }}, pause = true }}]"
    text = load_scenario("concept-1972").text.replace('mode = "ORB UNL"', 'mode = "AUTO 1"') + goal
    made = parse_scenario(text, "test", "test.toml", Path("."))
    sim = aftdeck.Simulation(made)
    first = checked(sim)[-1]
    assert first.sequence == "ready" and first.check is not None
    flown(sim, [Inputs(proceed=True), *held_for(100, Inputs())])
    again = checked(sim, Inputs(initialise="full problem"))[-1]
    assert (again.sequence, again.check, again.mode) == ("ready", first.check, "AUTO 1")


def test_initialisation_with_empty_grasp_enters_orb_unl() -> None:
    grasped = f'mode = "ORB LD"\n[initialise.acquisition]\njoints = {joints((28.0, 0.0, -3.3))}\nstand = "16 ft"'
    sim = aftdeck.Simulation(scenario((28.0, 0.0, -20.0), held=True, extra=grasped))
    assert sim.step(Inputs()).mode == "ORB LD"
    frame = sim.step(Inputs(initialise="acquisition"))
    assert frame.mode == "ORB UNL" and not frame.work.cargo[0].held
    assert sim.step(Inputs(initialise="full problem")).mode == "ORB LD"


def test_initialisation_without_start_is_rejected_without_effect() -> None:
    sim, same = aftdeck.Simulation("srms-deploy"), aftdeck.Simulation("srms-deploy")
    frames = flown(sim, held_for(20, Inputs((0.3, 0.0, 0.0))))
    flown(same, held_for(20, Inputs((0.3, 0.0, 0.0))))
    rejected, expected = sim.step(Inputs(initialise="extraction")), same.step(Inputs())
    (event,) = rejected.events
    assert event.kind == "refused" and "extraction" in event.text
    assert msgspec.structs.replace(rejected, events=(), sha256="") == msgspec.structs.replace(expected, sha256="")
    assert len(frames) == 20


def test_start_with_impossible_grasp_is_rejected() -> None:
    text = load_scenario("concept-1972").text
    over = text.replace('above = "0.36 in"', 'above = "1 in"')  # the palm is above the bar, not on it
    assert over != text
    with pytest.raises(ScenarioError) as raised:
        aftdeck.Simulation(parse_scenario(over, "test", "test.toml", Path(".")))
    first, second = raised.value.problems
    assert first.startswith("test: initialise.extraction.grasped: Payload ") and "palm" in first
    assert second.startswith("test: initialise.manoeuvring.grasped: Payload ")


def test_worksite_error_is_reported_instead_of_missing_payload(tmp_path: Path) -> None:
    place = load_worksite("concept-1972").text
    seven = place.replace('sides = 6, across = "= payload_width"', 'sides = 7, across = "= payload_width"')
    (tmp_path / "place.toml").write_text(seven)
    text = load_scenario("concept-1972").text.replace('worksite = "concept-1972"', 'worksite = "place.toml"')
    with pytest.raises(ScenarioError) as raised:
        parse_scenario(text, "test", "test.toml", tmp_path)
    (problem,) = raised.value.problems
    assert "place.toml" in problem and "7 sides" in problem
