"""Changes in flight: checked as the file is, in force from their step on, and part of state, copies and replays."""

from __future__ import annotations

import copy
import functools
import random
from pathlib import Path

import numpy as np
import pytest

import aftdeck
from aftdeck import Inputs
from aftdeck.errors import InputError, ScenarioError
from aftdeck.frames import Pose
from aftdeck.recording.replay import verify
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.in_flight import CHANGING, FIXED, obstacle
from aftdeck.scenario.in_flight import changing as row_of
from aftdeck.scenario.key_list import NOT_GIVEN, key_list
from aftdeck.scenario.keys import key_of
from aftdeck.scenario.load import in_force, load_scenario, parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.target import target_at
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.run import Simulation
from tests.each import each, seeds
from tests.legal_changes import changing, random_change, texts

ARMS = "srms-berth", "concept-1972"


@functools.cache
def scenario(name: str) -> Scenario:
    return load_scenario(name)


@pytest.mark.parametrize("name", ARMS)
@each("seed", seeds(6, 60))
def test_change_acts_from_its_step_on_as_if_the_file_said_it(name: str, seed: int) -> None:
    """The constants after a change are those of a run whose files have had the value from the start."""
    rng = random.Random(f"{name} {seed}")
    sim = Simulation(scenario(name))
    entries = changing(sim.scenario)
    sim.step(Inputs())
    change = random_change(rng, entries, sim.prepare)
    (key, value), *_ = change.items()
    frame = sim.step(Inputs(changes=change))
    assert [event.text for event in frame.events if event.kind == "change"] == [f"{key} = {value}"]
    said = in_force(sim.scenario, frame.changes)
    assert sim.in_force is said
    try:
        other = aftdeck.load_scenario(name, {key: value})
    except ScenarioError:
        return  # no run could begin so, but this one can go on
    assert _numbers(said) == _numbers(other)


def _numbers(of: Scenario) -> object:
    """Return values of a scenario that changes in flight can change."""
    model = of.arm.model
    return (
        [limits.tolist() for limits in (*model.limits, *model.rates)],
        [list(row) for row in (model.servo or ())],
        model.por,
        model.singular,
        [(joint.least, joint.greatest, joint.rate) for joint in model.switched],
        of.por,
        (of.caution, of.warning, of.near, of.near_turn, of.fly_by, of.fly_by_turn, of.guarded, of.docking_axes),
        (of.telemetry_delay, of.camera_delay, of.camera_settings),
        of.worksite.cameras,
        of.worksite.acquisition,
        [(berth.distance, berth.angle, berth.time) for berth in of.worksite.berths],
        [essential.depth for essential in of.worksite.essential],
        of.worksite.translation,
        of.worksite.orbiter,
        [one.start.pose.position.tolist() for one in of.payloads],
    )


@pytest.mark.parametrize("name", ARMS)
def test_saved_copied_and_restarted_run_has_the_changes_of_its_state(name: str) -> None:
    rng = random.Random(name)
    sim = Simulation(scenario(name))
    first = sim.step(Inputs(translation=(1.0, 0.0, 0.0)))
    entries = changing(sim.scenario)
    for _ in range(3):
        sim.step(Inputs(changes=random_change(rng, entries, sim.prepare), translation=(1.0, 0.0, 0.0)))
    saved, twin = sim.save(), copy.deepcopy(sim)
    other = Simulation(scenario(name))
    other.restore(saved)
    expected = [sim.step(Inputs(rotation=(0.5, 0.0, 0.0))).sha256 for _ in range(20)]
    assert [twin.step(Inputs(rotation=(0.5, 0.0, 0.0))).sha256 for _ in range(20)] == expected
    assert [other.step(Inputs(rotation=(0.5, 0.0, 0.0))).sha256 for _ in range(20)] == expected
    assert other.in_force is sim.in_force is not sim.scenario
    sim.restart()
    assert sim.in_force is sim.scenario
    assert sim.step(Inputs(translation=(1.0, 0.0, 0.0))).sha256 == first.sha256


@each("seed", seeds(3, 40))
def test_run_with_random_changes_replays_equal(seed: int, tmp_path: Path) -> None:
    rng = random.Random(seed)
    name = ARMS[seed % 2]
    sim, path = Simulation(scenario(name)), tmp_path / f"{seed}.mcap"
    entries, recorder = changing(sim.scenario), Recorder(path, sim.scenario, sim.seed)
    for tick in range(120):
        x, y, z = (rng.choice((-1.0, 0.0, 1.0)) for _ in range(3))
        change = random_change(rng, entries, sim.prepare) if tick % 20 == 10 else {}
        frame = sim.step(inputs := Inputs(translation=(x, y, z), changes=change))
        recorder.step(inputs, frame)
    recorder.close("stopped")
    verdict = verify(path)
    assert verdict.equal, verdict


def test_refused_change_leaves_the_run_as_it_was() -> None:
    sim = Simulation(scenario("srms-berth"))
    sim.step(Inputs())
    before = sim.save()
    for changes, words in (
        ({"arm.tip.value": [1, 2, 3]}, "length of the arm"),
        ({"limits.por.translation": "3 kg"}, "is not a speed"),
        ({"limits.por.translation": 500}, "expected 1e-06 to 10 m/s"),
        ({"limits.por.vernier_translation": "2 m/s"}, "at most the coarse limit"),
        ({"arm.joint[0].soft": ["-1 deg", "1 deg"]}, "reach limits have to be inside"),
        ({"limits.hard": [["170 deg", "171 deg"]] * 6}, "limits"),
        ({"no.such.key": 1}, "no such key"),
        ({"clearnce.caution": 1}, "did you mean clearance"),
        ({"worksite.camera[77].up": [0, 0, 1]}, "no item 77"),
        ({"cameras.A.pan": "1000 deg"}, "range of this camera's drive"),
        ({"mode": "SINGLE"}, "switch of the panel"),
    ):
        with pytest.raises(InputError, match=words):
            sim.step(Inputs(changes=texts(changes)))
        assert sim.save() == before


def test_stop_may_not_be_set_where_the_arm_is_not() -> None:
    sim = Simulation(scenario("srms-berth"))
    at = sim.step(Inputs()).angles[0]
    far = {
        f"arm.joint[0].{name}": [at + 0.1 + i / 100, at + 1.0 - i / 100]
        for i, name in enumerate(("hard", "soft", "reach"))
    }
    with pytest.raises(InputError, match="outside the new limits"):
        sim.step(Inputs(changes=texts(far)))
    near = {name: [least - 0.3, most] for name, (least, most) in far.items()}
    frame = sim.step(Inputs(changes=texts(near)))
    assert sim.in_force.arm.limits.soft[0].tolist() == near["arm.joint[0].soft"]
    assert len(frame.changes) == 3


def test_camera_takes_a_new_angle_and_keeps_the_others() -> None:
    sim = Simulation(scenario("concept-1972"))
    before = sim.step(Inputs()).views
    i = sim.cameras.index("B")
    after = sim.step(Inputs(changes={"cameras.B.pan": "12 deg"})).views
    assert after[i].pan == pytest.approx(0.20943951)
    assert after[i]._replace(pan=before[i].pan) == before[i]
    assert after[:i] + after[i + 1 :] == before[:i] + before[i + 1 :]


def test_free_payload_is_put_in_its_place_and_a_held_one_is_not() -> None:
    sim = Simulation(scenario("free-flyer"))
    sim.step(Inputs())
    before = sim.look().work.cargo[0].position
    frame = sim.step(Inputs(changes=texts({"cargo[0].start.position": ["31 ft", "1 ft", "12 ft"]})))
    moved = frame.work.cargo[0].position
    assert sum((a - b) ** 2 for a, b in zip(before, moved, strict=True)) ** 0.5 > 0.1
    held = Simulation(scenario("srms-berth"))
    held.step(Inputs())
    with pytest.raises(InputError, match=r"held|berth"):
        held.step(Inputs(changes=texts({"cargo[0].start.position": ["1 m", "0 m", "5 m"]})))


EVENTS = """
[[event]]
at = "0.1 s"
set = { limits.por.translation = "0.25 m/s", "clearance.caution" = 0.9 }
[[event]]
at = "0.2 s"
set = { arm.joint[0].hard = 1 }
"""


def test_event_of_a_scenario_changes_values_at_its_time() -> None:
    source = load_scenario("concept-1972-script")
    text = source.text + EVENTS[: EVENTS.index('[[event]]\nat = "0.2')]
    planned = parse_scenario(text, "planned", "planned.toml", Path())
    for by_hand in (True, False):
        sim = Simulation(planned)
        frames = [sim.step(Inputs() if by_hand else None) for _ in range(10)]
        first = next(frame for frame in frames if frame.changes)
        assert first.tick == round(0.1 / planned.control_period) + 1
        assert {event.text for event in first.events if event.kind == "change"} == {
            "limits.por.translation = 0.25 m/s",
            "clearance.caution = 0.9",
        }
        assert sim.in_force.por.translation == pytest.approx(0.25)
        assert sim.in_force.caution == 0.9


@pytest.mark.parametrize(
    ("event", "words"),
    [
        (
            'at = "0.1 s"\nset = { "arm.tip.value" = [1, 2, 3] }',
            r"event\[0\].set: arm.tip.value cannot change",
        ),
        ('at = "0.1 s"\nset = { "limits.por.translation" = "3 kg" }', r"event\[0\].set: .*is not a speed"),
        ('at = "-1 s"\nset = { guards = true }', r"event\[0\].at"),
        ('at = "1 s"\nset = { }', r"event\[0\].set: has no key"),
        ('at = "1 s"', r"event\[0\]: the field 'set' is missing"),
    ],
)
def test_wrong_event_is_an_error_of_the_file(event: str, words: str) -> None:
    text = f"{load_scenario('first-flight').text}\n[[event]]\n{event}\n"
    with pytest.raises(ScenarioError, match=words):
        parse_scenario(text, "wrong", "wrong.toml", Path())


@pytest.mark.parametrize("name", ARMS)
def test_each_key_can_change_or_says_why_not(name: str) -> None:
    for text, entry in key_list(scenario(name)).items():
        assert key_of(text) == entry.key or "." in str(entry.key.where)
        assert (row_of(entry.key) is None) == bool(obstacle(entry.key))
        assert entry.sentence().startswith(text)


def test_each_pattern_names_a_key() -> None:
    known = [text for name in (*ARMS, "srms-deploy") for text in key_list(scenario(name))]
    keys = {key_of(text) for text in known if text.isascii() and " " not in text}
    for row in CHANGING:
        assert any(row_of(key) is row for key in keys), row.pattern
    whole = {why for key in keys if (why := obstacle(key))}
    assert len(whole) > len({why for _, why in FIXED}) / 2


def test_newest_value_counts_also_after_a_whole_table() -> None:
    sim = Simulation(scenario("concept-1972"))
    for changes, speed, printed in (
        ({"limits.por.translation": "0.3 m/s"}, 0.3, "0.3 m/s"),
        ({"limits": "{ }"}, 0.6096, NOT_GIVEN),
        ({"limits.por.translation": "0.25 m/s"}, 0.25, "0.25 m/s"),
        ({"limits.por": "{ translation = 0.35 }"}, 0.35, 0.35),
    ):
        frame = sim.step(Inputs(changes=changes))
        assert frame.por_limits[0] == pytest.approx(speed)
        assert key_list(sim.scenario, frame.changes)["limits.por.translation"].value == printed


def test_camera_takes_an_angle_again_after_its_drive_has_moved_it() -> None:
    sim = Simulation(scenario("concept-1972"))
    i = sim.cameras.index("B")
    first = sim.step(Inputs(changes={"cameras.B.pan": "12 deg"})).views[i].pan
    for _ in range(20):
        sim.step(Inputs(camera=CameraDrive("B", pan=1.0)))
    assert sim.look().views[i].pan > first
    assert sim.step(Inputs(changes={"cameras.B.pan": "12 deg"})).views[i].pan == first


@pytest.mark.parametrize("key", ["camera_delay", "limits.por.translation"])
def test_script_goes_on_through_a_change_while_cmd_ck_runs(key: str) -> None:
    """A change that the rehearsal needs begins it again; a PROCEED that waits for the verdict stays."""
    value = {"camera_delay": "0.5 s", "limits.por.translation": "0.55 m/s"}[key]
    checking, ended, step = False, Simulation(scenario("first-flight")), 0
    while not checking:
        step += 1
        checking = ended.step().sequence == "checking"
    ended.step(Inputs(script=True, changes={key: value}))
    while not ended.ended:
        ended.advance()
    assert ended.ended == "completed"


def test_change_acts_at_once_under_a_command_delay() -> None:
    sim = Simulation(aftdeck.load_scenario("concept-1972", {"command_delay": "0.2 s"}))
    sim.step(Inputs())
    frame = sim.step(Inputs(changes={"limits.por.translation": "0.3 m/s"}, rate="vernier"))
    assert frame.por_limits[0] == pytest.approx(0.3) and frame.rate == "coarse"
    assert sim.flown.changes and not sim.step(Inputs()).events
    assert not sim.flown.changes


def test_kinds_of_devices_stay() -> None:
    sim = Simulation(scenario("srms-berth"))
    sim.step(Inputs())
    sizes = "prong_spacing = 0.1, window = 0.02, front = 0.1, rear = 0.1, fingers_within = 1"
    bar = f"{{ kind = 'bar', {sizes}, source = 'x' }}"
    for changes in (
        {"worksite.acquisition": bar},
        {"worksite.drive[0].tilt": "{ least = -1, greatest = 1, rate = 0.1 }", "worksite.camera": "[]"},
        {"worksite.seat[0].kind": "port"},
        {"worksite.acquisition.source": "mine"},
    ):
        with pytest.raises(InputError):
            sim.step(Inputs(changes=changes))


def test_formula_of_a_file_can_be_set_as_it_is_written() -> None:
    sim = Simulation(scenario("concept-1972"))
    sim.step(Inputs())
    before = sim.in_force.worksite.cameras
    sim.step(Inputs(changes={"worksite.camera[0].position": "['= bay_forward - 0.5 ft', '-4 ft', '0.45 ft']"}))
    assert sim.in_force.worksite.cameras == before


def test_saved_state_of_another_worksite_is_rejected() -> None:
    other = Simulation(aftdeck.load_scenario("srms-berth", {"worksite.seat[0].distance": "20 cm"}))
    sim = Simulation(scenario("srms-berth"))
    sim.step(Inputs())
    with pytest.raises(InputError, match="belongs to a scenario"):
        other.restore(sim.save())


def test_too_many_changes_in_a_step_are_refused() -> None:
    sim = Simulation(scenario("concept-1972"))
    many = {f"cameras.A{i}.pan": "1" for i in range(70)}
    with pytest.raises(InputError, match="at most 64"):
        sim.prepare(many)
    with pytest.raises(InputError, match="at most 64"):
        sim.step(Inputs(changes=many))


def test_verdict_is_given_again_after_a_change_on_which_it_depends() -> None:
    """The housing of a camera collides; a field of view does not."""
    sim = Simulation(scenario("first-flight"))
    tip = sim.scenario.arm.forward(sim.step(Inputs()).angles)
    target = target_at(Pose(tip.position + np.array([0.0, 0.0, 0.2]), tip.rotation))
    sim.step(Inputs(mode="OPR CMD"))
    frame = sim.step(Inputs(target=target))
    while frame.check is None:
        frame = sim.step(Inputs())
    kept = sim.save()
    for key, value, again in (
        ("worksite.camera[0].field_of_view", "40 deg", False),
        ("clearance.caution", "0.6 m", False),
        ("worksite.camera[0].position", "[-8.8, -1.8, 1.2]", True),
    ):
        sim.restore(kept)
        sim.step(Inputs(changes={key: value}))
        assert (sim._state.checking is not None) == again, key
