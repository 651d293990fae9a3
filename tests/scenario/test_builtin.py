"""The built-in scenarios."""

from __future__ import annotations

import numpy as np
import pytest

import aftdeck
from aftdeck.errors import ScenarioError
from aftdeck.scenario.load import built_in, load_scenario
from tests.kinematics.poses import structural
from tests.scenario.missions import FLOWN, SCRIPTED, takes_its_minutes

INCH = 0.0254

NAMES = {
    "first-flight",
    "loaded",
    "sequence",
    "singular",
    "concept-1972",
    "concept-1972-script",
    "free-flyer",
    "srms-berth",
    "srms-deploy",
    "sts-400-closed",
    "sts-400-open",
    "sts-400-position",
    "tutorial",
    "uncradle",
}


def test_promised_scenarios_are_built_in() -> None:
    assert set(built_in()) >= NAMES


@pytest.mark.parametrize("name", built_in())
def test_built_in_scenario_loads_with_title_and_description(name: str) -> None:
    scenario = load_scenario(name)
    assert scenario.name == name and scenario.title and scenario.description
    assert len({phase.name for phase in scenario.phases}) == len(scenario.phases)
    assert bool(scenario.phases) == (name in SCRIPTED)


@pytest.mark.parametrize("name", FLOWN)
def test_built_in_scenario_completes_its_script(name: str) -> None:
    done = aftdeck.run(name, keep_frames=False)
    assert done.summary.ended == "completed"
    assert done.summary.worst_rate_ratio <= 1.0
    assert done.summary.time_s <= done.scenario.duration
    assert done.scenario.steps or takes_its_minutes(done.scenario, done.summary.time_s)
    log = done.summary.events
    # each phase is logged in order, no command is rejected or abandoned, and no line is repeated in a step
    assert [e.text for e in log if e.kind == "phase"] == [f"phase {p.name!r} begins" for p in done.scenario.phases]
    assert not {e.kind for e in log} & {"refused", "blocked", "fault"}
    assert len({(e.time_s, e.text) for e in log}) == len(log)
    assert [e.time_s for e in log] == sorted(e.time_s for e in log)
    for event in log:
        assert event.text == event.text.strip() and "_" not in event.text and len(event.text) <= 100


def test_sequence_scenario_passes_two_points_pauses_at_one_and_returns() -> None:
    done = aftdeck.run("sequence", keep_frames=False)
    arrivals = [e.text for e in done.summary.events if e.kind == "arrived"]
    assert arrivals == [
        "AUTO 1, point 1 of 4 passed",
        "AUTO 1, point 2 of 4 passed",
        "AUTO 1, point 3 of 4 reached",
        "AUTO 1, point 4 of 4 reached",
    ]
    assert [e.kind for e in done.summary.events].count("proceed") == 2
    home = done.scenario.arm.forward(done.scenario.initial_angles)
    assert done.summary.tip.position_m == pytest.approx(home.position, abs=1e-3)


def test_singular_scenario_starts_near_all_singularities_and_leaves_each() -> None:
    scenario = load_scenario("singular")
    assert all(abs(float(d)) < scenario.arm.model.singular for d in scenario.arm.singularities(scenario.initial_angles))
    last = aftdeck.run(scenario).frames
    assert last[0].singular == ("shoulder", "elbow", "wrist")
    assert {w.cause for w in last[0].ways_out} >= {"shoulder", "elbow", "wrist"}
    left = {e.text for f in last for e in f.events if e.kind == "singular" and e.text.endswith("left behind")}
    assert left == {f"{name} singularity left behind" for name in ("shoulder", "elbow", "wrist")}


def test_first_flight_starts_over_the_bay_far_from_all_limits() -> None:
    scenario = load_scenario("first-flight")
    arm, q = scenario.arm, scenario.initial_angles
    xo, yo, zo = structural(arm.forward(q).position)
    # the bay's middle: Xo 942, Yo 0, Zo 400 in
    assert abs(xo - 942 * INCH) < 0.5 and abs(yo) < 0.5
    assert 3.0 <= zo - 400 * INCH <= 5.0
    assert min(abs(float(d)) for d in arm.singularities(q)) >= 0.35
    room = np.minimum(q - arm.limits.reach[:, 0], arm.limits.reach[:, 1] - q)
    assert np.degrees(room.min()) >= 15.0


def test_first_flight_stays_clear_of_stops_and_singularities() -> None:
    for frame in aftdeck.run("first-flight").frames:
        assert frame.zones == (0,) * 6 and frame.singular == ()


def test_cradled_arm_starts_with_zero_joint_angles() -> None:
    assert load_scenario("uncradle").initial_angles.tolist() == [0.0] * 6


def test_unknown_scenario_is_rejected_with_the_built_in_names() -> None:
    with pytest.raises(ScenarioError, match=r"'sts-999'; .* concept-1972, "):
        load_scenario("sts-999")
