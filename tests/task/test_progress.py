"""Progress through the steps of a task."""

from __future__ import annotations

import math
import tomllib
from itertools import pairwise
from pathlib import Path

import msgspec
import pytest

from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.task.progress import Progress
from aftdeck.worksite.report import Motion
from tests.loaded import scenario

UP, STILL = Inputs(translation=(0.0, 0.0, -1.0)), Inputs()
TWO = """
title = "Two steps"
mode = "ORB UNL"
initial = { joints = ["-31 deg", "79 deg", "-103 deg", "-77 deg", "17 deg", "-128 deg"] }

[[step]]
title = "Rest"
text = "Rest."
done = { rate = "vernier" }
hint = [{ when = { at_rest = false }, text = "Moving." }]

[[step]]
title = "Move"
text = "Move."
done = { moved = "0.2 m" }
"""


def two(folder: Path) -> tuple[Simulation, Progress]:
    """Return a simulation whose task has the steps of `TWO`, and its progress."""
    file = folder / "two.toml"
    file.write_text(TWO)
    sim = Simulation(load_scenario(file))
    return sim, Progress(sim.scenario)


def flown(sim: Simulation, progress: Progress, inputs: Inputs, steps: int = 1) -> Frame:
    """Fly some steps, and return the last frame."""
    for _ in range(steps):
        frame = sim.step(inputs)
        progress.see(frame)
    return frame


def test_no_step_is_complete_while_a_contact_inhibits_the_arm(tmp_path: Path) -> None:
    sim, progress = two(tmp_path)
    flown(sim, progress, STILL)
    frame = sim.step(Inputs(rate="vernier"))
    touching = msgspec.structs.replace(frame, work=msgspec.structs.replace(frame.work, arm_inhibit=True))
    assert progress.see(touching) == ()
    assert progress.see(frame) == (0,)


def test_state_tells_whether_a_mechanism_moves(tmp_path: Path) -> None:
    file = tmp_path / "moves.toml"
    file.write_text(TWO.replace('done = { rate = "vernier" }', "done = { moves = true }"))
    sim = Simulation(load_scenario(file))
    progress = Progress(sim.scenario)
    frame = flown(sim, progress, STILL)
    assert progress.at == 0
    progress.see(msgspec.structs.replace(frame, motions=(Motion("latches open", 3.0),)))
    assert progress.at == 1


def test_closing_speed_is_that_of_the_distance_also_if_the_orbiter_flies() -> None:
    sim = Simulation("free-flyer")
    progress, distances, speeds = Progress(sim.scenario), [], []
    for _ in range(200):
        flown(sim, progress, Inputs(orbiter=(1.0, 0.0, 0.0)))
        remaining = progress.remaining()
        assert remaining is not None
        distances.append(remaining.distance)
        speeds.append(progress.closing())
    assert speeds[0] is None
    assert speeds[1:] == pytest.approx([50.0 * (a - b) for a, b in pairwise(distances)])
    assert (speeds[-1] or 0.0) > 0.05


def test_step_counts_the_way_since_its_own_beginning(tmp_path: Path) -> None:
    sim, progress = two(tmp_path)
    start = flown(sim, progress, UP)
    flown(sim, progress, UP, 200)
    assert progress.at == 0
    flown(sim, progress, Inputs(rate="vernier", translation=(0.0, 0.0, -1.0)))
    began = flown(sim, progress, UP)
    assert progress.at == 1
    while progress.at == 1:
        last = flown(sim, progress, UP)
        assert last.tick < 4000
    assert 0.2 <= math.dist(began.position, last.position) < 0.21
    assert math.dist(start.position, began.position) > 0.2
    assert progress.done_s[1] == last.time_s


def test_hint_is_shown_while_its_state_holds(tmp_path: Path) -> None:
    sim, progress = two(tmp_path)
    flown(sim, progress, STILL)
    assert progress.hint() == -1
    flown(sim, progress, UP, 10)
    assert progress.hint() == 0
    flown(sim, progress, STILL, 200)
    assert progress.hint() == -1


def test_step_entered_again_needs_its_state_anew(tmp_path: Path) -> None:
    sim, progress = two(tmp_path)
    vernier, coarse = Inputs(rate="vernier"), Inputs(rate="coarse")
    flown(sim, progress, vernier)
    assert progress.at == 1
    progress.back()
    flown(sim, progress, STILL, 3)
    assert progress.at == 0
    flown(sim, progress, coarse)
    flown(sim, progress, vernier)
    assert progress.at == 1


def test_skipped_step_is_not_done_until_it_is_completed_later(tmp_path: Path) -> None:
    sim, progress = two(tmp_path)
    flown(sim, progress, STILL)
    progress.skip()
    progress.skip()
    progress.skip()
    assert (progress.at, progress.skipped, progress.present) == (2, (0, 1), None)
    for _ in range(3):
        progress.back()
    flown(sim, progress, STILL)
    flown(sim, progress, Inputs(rate="vernier"))
    assert (progress.at, progress.skipped) == (1, ())


def test_milestone_completes_the_open_steps_before_it() -> None:
    sim = Simulation(scenario("tutorial"))
    progress = Progress(sim.scenario)
    held = False
    done: tuple[int, ...] = ()
    while not held:  # no camera is changed, so that the first step stays open
        frame = sim.step()
        done, held = progress.see(frame), any(cargo.held for cargo in frame.work.cargo)
        assert frame.tick < 4000
    assert done == (0, 1, 2, 3, 4)
    assert progress.at == 5


def test_milestone_right_after_the_present_step_completes_both() -> None:
    steps = tomllib.loads(load_scenario("tutorial").text)["step"]
    sim = Simulation(load_scenario("tutorial", {("step",): [steps[0], steps[4]]}))
    progress = Progress(sim.scenario)
    assert not progress.steps[0].is_milestone and progress.steps[1].is_milestone
    while progress.places.held(frame := sim.step()) is None:
        assert progress.see(frame) == () and frame.tick < 4000
    assert progress.see(frame) == (0, 1)


def test_milestone_that_held_from_the_beginning_completes_nothing() -> None:
    sim = Simulation(scenario("srms-berth"))  # the payload is captured, and "held" is no news
    progress = Progress(sim.scenario)
    for _ in range(50):
        progress.see(sim.step(STILL))
    assert progress.at == 0


def test_re_initialisation_begins_at_the_step_of_its_part() -> None:
    sim = Simulation(scenario("concept-1972"))
    progress = Progress(sim.scenario)
    for part, title in (("extraction", "Extract it"), ("full problem", "Over the bar"), ("manoeuvring", "Move it")):
        progress.see(sim.step(Inputs(initialise=part)))  # type: ignore[arg-type]
        assert progress.present is not None
        assert progress.present.title.startswith(title)


def test_look_counts_for_the_present_step_only() -> None:
    sim = Simulation(scenario("tutorial"))
    progress = Progress(sim.scenario)
    flown(sim, progress, STILL, 3)
    assert progress.at == 0
    progress.look()
    flown(sim, progress, STILL)
    assert progress.at == 1
    progress.back()
    flown(sim, progress, STILL, 3)
    assert progress.at == 0


def test_lost_payload_returns_the_task_to_its_capture() -> None:
    sim = Simulation(scenario("srms-deploy"))
    progress = Progress(sim.scenario)
    lift = next(i for i, step in enumerate(progress.steps) if step.title == "Lift it out of the bay")
    frame = sim.step()
    while progress.at < lift or frame.phase != "lift":
        progress.see(frame)
        frame = sim.step()
        assert frame.tick < 20_000
    flown(sim, progress, UP, 500)  # out of the guides; the first input of the operator ends the script
    frame = flown(sim, progress, Inputs(effector="open"))
    while any(cargo.held for cargo in frame.work.cargo):
        assert progress.at == lift
        frame = flown(sim, progress, STILL)
        assert frame.tick < 20_000
    assert progress.steps[progress.at].title == "Capture it"
    assert progress.done_s[progress.at :] == [None] * (len(progress.steps) - progress.at)
    assert progress.skipped == ()
