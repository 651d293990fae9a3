"""Overlapping parts are rejected at load, with both names and the depth; consistent scenarios run."""

from __future__ import annotations

import functools
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck.bodies.overlap import overlap
from aftdeck.errors import ScenarioError
from aftdeck.scenario.fit import misfits
from aftdeck.scenario.load import load_scenario, parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import scene_in_l
from aftdeck.simulation.survey.cameras import _logs_contact
from aftdeck.simulation.survey.pairs import survey
from aftdeck.simulation.survey.poses import bodies, placed
from aftdeck.worksite import load_worksite
from tests.bodies.minkowski import depth
from tests.each import each, seeds

FOOT = 0.3048
G_IN_WRIST = r"camera G is \S+ \S+ inside wrist"
"""Pattern of the survey's reports about cameras without a housing, at the concept's worksite."""
numbers = st.integers(0, 2**32 - 1)


@functools.cache
def script() -> str:
    return load_scenario("concept-1972-script").text


def resized(dimensions: dict[str, str], text: str = "") -> Scenario:
    """Return a scenario with these dimensions, from its text; without a text, from the built-in script scenario."""
    table = "".join(f'{name} = "{value}"\n' for name, value in dimensions.items())
    return parse_scenario(f"{text or script()}\n[dimensions]\n{table}", "test", "test.toml", Path("."))


def rejection(dimensions: dict[str, str], text: str = "") -> str:
    with pytest.raises(ScenarioError) as raised:
        resized(dimensions, text)
    return "\n".join(raised.value.problems)


# --- depth, by an independent solver ----------------------------------------------------------------------


@settings(max_examples=60)
@given(numbers)
def test_overlap_depth_agrees_with_an_independent_solver(seed: int) -> None:
    rng = np.random.default_rng(seed)
    solids = [solid.vertices for solid in load_worksite("orbiter").solids]
    a, b = (solids[k] for k in rng.integers(len(solids), size=2))
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    b = (b - b.mean(axis=0)) @ turn.T + a.mean(axis=0) + rng.normal(size=3) * 2.0
    assert overlap(a, b) == pytest.approx(depth(a, b), abs=1e-7)


# --- section VI: a dimension moves everything that depends on it ------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize(
    "dimensions",
    [
        {},
        {"payload_length": "58 ft", "payload_width": "14 ft"},
        {"payload_length": "60 ft", "payload_width": "15 ft", "bay_length": "62 ft", "bay_width": "17 ft"},
        {"payload_length": "24 ft", "payload_width": "11 ft", "bar_aft": "2 ft"},
    ],
)
def test_payload_of_any_size_completes_the_script(dimensions: dict[str, str]) -> None:
    assert runs_without_overlap(resized(dimensions))


def test_largest_payload_is_rejected_in_the_reports_bay_with_its_depth() -> None:
    problems = rejection({"payload_length": "60 ft", "payload_width": "15 ft"})
    assert re.search("test.toml:.*payload is 18 in .*aft body", problems)


def runs_without_overlap(made: Scenario) -> bool:
    """Run the script. Return whether it is completed; assert that no contact is detrimental and no payload overlaps."""
    sim = aftdeck.Simulation(made)
    step = 0
    while not sim.ended:
        sim.advance()
        step += 1
        if step % 10 == 0:
            assert not [c for c in sim.look().work.contacts if not c.essential]
            if step % 50 == 0:
                assert deepest_overlap(made, sim) < 1e-6
    return sim.ended == "completed"


def deepest_overlap(made: Scenario, sim: aftdeck.Simulation) -> float:
    """Return the greatest penetration depth between any payload and the worksite, by the independent solver [m]."""
    frame = sim.look()
    worst = 0.0
    away = np.array(frame.work.orbiter)
    scene = np.diag([1.0, -1.0, -1.0])
    for cargo, held in zip(made.payloads, frame.work.cargo, strict=True):
        for solid in cargo.solids:
            body = solid.vertices @ np.array(held.orientation).T + np.array(held.position)
            low, high = body.min(axis=0), body.max(axis=0)
            for other in made.worksite.solids:
                other_body = other.vertices @ scene.T - (away if other.frame == "space" else 0.0)
                if (low < other_body.max(axis=0)).all() and (other_body.min(axis=0) < high).all():
                    worst = max(worst, depth(body, other_body))
    return worst


EDITED = {
    "payload_length": (10.0, 64.0),
    "payload_width": (4.0, 16.0),
    "payload_middle": (20.0, 36.0),
    "payload_floor_room": (-1.0, 2.0),
    "bay_length": (50.0, 66.0),
    "bay_width": (12.0, 18.0),
    "bay_depth": (11.0, 16.0),
    "bar_length": (0.8, 4.0),
    "bar_width": (0.3, 0.9),
    "bar_height": (0.55, 1.0),
    "bar_aft": (-3.0, 3.0),
    "probe_length": (0.5, 2.0),
    "port_aft": (-5.0, -2.0),
    "port_up": (20.0, 23.0),
    "cae_apothem": (6.0, 9.0),
}
"""Ranges of the edited dimensions [ft]."""


def edited(rng: np.random.Generator) -> dict[str, str]:
    names = rng.choice(list(EDITED), size=int(rng.integers(1, 5)), replace=False)
    return {str(name): f"{rng.uniform(*EDITED[str(name)])!r} ft" for name in names}


OUT_OF_REACH = ("the end effector cannot reach", "the arm cannot reach")
"""Beginnings of the survey's reports of an unreachable position."""


@pytest.mark.slow
@each("seed", seeds(4, 100))
def test_edited_dimensions_are_rejected_with_depth_or_run_cleanly(seed: int) -> None:
    """If the arm can reach a position only beyond a stop, the survey reports the position, and the script fails."""
    dimensions = edited(np.random.default_rng(seed))
    try:
        made = resized(dimensions)
    except ScenarioError as error:
        expected = r"\d (in|ft) (inside|wide|long)|deg outside|m beyond the top|inside ends at|camera .* stands"
        assert all(re.search(expected, problem) for problem in error.problems), error.problems
        return
    out_of_reach = [one.what for one in survey(made) if one.what.startswith(OUT_OF_REACH)]
    assert runs_without_overlap(made) == (not out_of_reach), (dimensions, out_of_reach)


# --- faulty scenarios that the loader previously accepted -------------------------------------------------

CONCEPT = """title = "test"
arm = "concept-1972"
worksite = "concept-1972"
[initial]
joints = ["0 deg", "32.25 deg", "-106.33 deg", "0 deg", "-15.92 deg", "0 deg"]
stand = "16 ft"
[[cargo]]
name = "payload"
"""


def test_payload_that_starts_inside_the_cabin_is_rejected() -> None:
    problems = rejection({}, CONCEPT + 'start = { position = ["-2 ft", "0 ft", "-7 ft"] }\n')
    assert re.search(r"test.toml:7: cargo\[0\]: .*cabin", problems)


def test_payloads_that_start_inside_each_other_are_rejected() -> None:
    flyer = '[[cargo]]\nname = "free flyer"\nstart = { position = ["28 ft", "0 ft", "-5 ft"] }\n'
    assert re.search(r"free flyer .*[\d.]+ ft .*payload", rejection({}, CONCEPT + flyer))


def test_payload_that_is_held_does_not_excuse_two_others_that_overlap() -> None:
    flyer = '[[cargo]]\nname = "free flyer"\nstart = { position = ["28 ft", "0 ft", "-40 ft"] }\n'
    made = resized({}, CONCEPT + flyer)
    payload, other = made.payloads
    found = misfits(made.arm.model, made.worksite, (payload, other, other), frozenset(), frozenset({0}))
    assert {one.senseless for one in found if "free flyer and free flyer start where" in one.problem.what} == {True}


def test_berth_below_the_floor_is_rejected() -> None:
    assert re.search("payload .*9 in .*bay floor", rejection({"payload_floor_room": "-0.75 ft"}))


@pytest.mark.parametrize(
    ("dimensions", "pattern"),
    [
        ({"bar_width": "0.9 ft"}, r"bar of payload is 10\.8 in .* 9 in"),
        ({"bar_height": "0.5 ft"}, r"fixed finger is 0\.\d+ in inside payload"),
        ({"bar_length": "0.9 ft"}, r"front and rear .* together exclude 12 in"),
        ({"bar_aft": "14.5 ft"}, r"the bar ends 0\.305 m beyond"),
        ({"bar_starboard": "4 ft"}, r"the bar ends 0\.305 m beyond"),
    ],
)
def test_bar_that_does_not_fit_the_end_effector_is_rejected(dimensions: dict[str, str], pattern: str) -> None:
    assert re.search(pattern, rejection(dimensions)), rejection(dimensions)


@pytest.mark.parametrize(
    ("old", "new", "named"),
    [
        ('prong_spacing = "0.425 ft"', 'prong_spacing = "1.3 ft"', "open prong is 15 in"),
        ('prong_spacing = "0.425 ft"', 'prong_spacing = "0.3 ft"', "closed prong is 4.5 in"),
        ('"0 ft", "= payload_up"]', '"0 ft", "-9 ft"]', "floor"),
        ('["= bay_forward - 0.5 ft", "-4 ft", "0.45 ft"]', '["2 ft", "-4 ft", "-2 ft"]', "camera A"),
    ],
)  # fmt: skip
def test_inconsistent_worksite_is_rejected(tmp_path: Path, old: str, new: str, named: str) -> None:
    place = load_worksite("concept-1972").text
    assert place.count(old) == 1
    (tmp_path / "place.toml").write_text(place.replace(old, new))
    with pytest.raises(ScenarioError) as raised:
        parse_scenario(CONCEPT.replace('worksite = "concept-1972"', 'worksite = "place.toml"'), "t", "t.toml", tmp_path)
    assert named in "\n".join(raised.value.problems)


def test_telescope_that_retracts_into_the_cabin_is_rejected(tmp_path: Path) -> None:
    arm = (Path(aftdeck.__file__).parent / "arms" / "concept-1972.toml").read_text(encoding="utf-8")
    arm = arm.replace('telescope_least = "9.5 ft"', 'telescope_least = "8 ft"').replace(
        'shapes = "concept-1972.shapes.toml"', ""
    )
    (tmp_path / "arm.toml").write_text(arm, encoding="utf-8")
    with pytest.raises(ScenarioError, match=r"telescope .*2\.8 ft .*cabin"):
        parse_scenario(CONCEPT.replace('arm = "concept-1972"', 'arm = "arm.toml"'), "t", "t.toml", tmp_path)


def test_unused_berth_that_does_not_fit_a_payload_is_a_caution() -> None:
    text = CONCEPT.replace('"payload"', '"free flyer"')
    assert resized({}, text).cautions == ()
    (caution,) = resized({"flyer_width": "15.5 ft"}, text).cautions
    assert "bay wall" in caution.what and caution.where == ("cargo", 0)


# --- survey of sampled poses ------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("name", ["concept-1972", "concept-1972-script", "free-flyer", "srms-deploy", "first-flight"])
def test_built_in_scenario_has_no_overlap_over_sampled_poses(name: str) -> None:
    scenario = load_scenario(name)
    assert scenario.cautions == ()
    assert [one.what for one in survey(scenario)] == []


def moved_camera(tmp_path: Path, name: str, position: str) -> None:
    """Write the concept's worksite as `place.toml`, with one camera moved and without a housing."""
    before, after = load_worksite("concept-1972").text.split(f'[[camera]]\nname = "{name}"')
    after = re.sub(r"(?m)^position = .*$", f"position = {position}", after, count=1)
    after = re.sub(r"(?m)^drive = .*$", "", after, count=1)
    (tmp_path / "place.toml").write_text(f'{before}[[camera]]\nname = "{name}"{after}')


def test_camera_inside_the_arm_at_a_sampled_pose_is_reported(tmp_path: Path) -> None:
    moved_camera(tmp_path, "G", '["24.8 ft", "0 ft", "0.2 ft"]')
    text = CONCEPT.replace('worksite = "concept-1972"', 'worksite = "place.toml"')
    found = [one.what for one in survey(parse_scenario(text, "t", "t.toml", tmp_path))]
    assert any(re.search(G_IN_WRIST, what) for what in found)
    assert all(re.search(G_IN_WRIST, what) or "no housing" in what for what in found)


@pytest.mark.parametrize("part", ["upper boom", "lower boom"])
def test_camera_in_the_path_of_an_arm_part_is_reported(tmp_path: Path, part: str) -> None:
    """The camera is placed inside a part of the arm at a random pose without a contact."""
    plain, rng = resized({}), np.random.default_rng(5)
    low, high = plain.arm.limits.soft.T
    scene = scene_in_l(plain.arm.model.mount, plain.worksite.origin)
    while True:
        own = bodies(plain, placed(plain, rng.uniform(low, high), plain.start.stand, -0.4))
        if not _logs_contact(plain, own):
            break
    x, y, z = (scene.rotation.T @ (np.concatenate(own[part]).mean(axis=0) - scene.position)).tolist()
    moved_camera(tmp_path, "W", f"[{x}, {y}, {z}]")
    text = script().replace('worksite = "concept-1972"', 'worksite = "place.toml"')
    found = [one.what for one in survey(parse_scenario(text, "t", "t.toml", tmp_path))]
    assert [what for what in found if re.match(r"camera W .*at joint angles", what)], found
    assert len(found) == len({what.split(" at joint")[0] for what in found}), "each camera and part once"


def test_berth_that_is_reached_only_beyond_a_stop_is_reported() -> None:
    assert "elbow_pitch" in survey(resized({"payload_length": "20 ft", "payload_width": "8 ft"}))[0].what


def test_start_in_contact_is_reported_with_its_depth() -> None:
    text = CONCEPT.replace('"32.25 deg", "-106.33 deg"', '"20 deg", "-98 deg"')
    found = survey(resized({}, text))
    assert any(
        re.search(r" is [\d.]+ (in|ft) inside payload", one.what) and one.where == ("initial",) for one in found
    ), found
