"""Scripted missions at both worksites: their end, their contacts, and rejected commands."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck.errors import ScenarioError
from aftdeck.frames import angle_between
from aftdeck.scenario.load import parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.worksite.report import Work
from tests.scenario.missions import EXPECTED_KINDS, MISSIONS, flown
from tests.steering.flying import fly

FOOT, INCH = 0.3048, 0.0254
GOES_ON = 150
"""Number of steps that are compared after a state is restored."""


@pytest.mark.slow
@pytest.mark.parametrize("name", MISSIONS)
def test_mission_completes_with_its_expected_events(name: str) -> None:
    done = flown(name)
    assert done.ended == "completed"
    assert done.turning_points() == EXPECTED_KINDS[name]
    assert not {event.kind for event in done.events} & {"refused", "missed", "fault", "inhibit"}


@pytest.mark.slow
@pytest.mark.parametrize("name", MISSIONS)
def test_mission_has_only_essential_contacts(name: str) -> None:
    for work in flown(name).work:
        assert not work.arm_inhibit and not work.finger_inhibit
        assert all(contact.essential for contact in work.contacts)
        assert work.nearest is not None and work.nearest.clearance > 0.0


@pytest.mark.slow
@pytest.mark.parametrize("name", MISSIONS)
def test_payload_never_jumps_and_never_moves_while_latched(name: str) -> None:
    done = flown(name)
    period = done.scenario.control_period
    for before, now in pairwise(done.work):
        (was,), (is_now,) = before.cargo, now.cargo
        step = math.dist(was.position, is_now.position)
        assert step <= 1.0 * period  # m/s; the greatest tip speed is 2 ft/s
        assert is_now.velocity == pytest.approx(
            [(b - a) / period for a, b in zip(was.position, is_now.position, strict=True)], abs=1e-9
        )
        if was.seat == is_now.seat == "bay" and done.scenario.name != "srms-berth":
            assert step == 0.0


def seated(name: str) -> Work:
    """Return a mission's worksite after its first step, with the payload in the bay."""
    return aftdeck.Simulation(name).step().work


def turned(one: Work, other: Work) -> float:
    """Return the rotation angle of a mission's payload between two steps [rad]."""
    return angle_between(one.cargo[0].orientation, other.cargo[0].orientation)


@pytest.mark.slow
def test_deployed_payload_stays_at_rest_where_it_was_released() -> None:
    done = flown("srms-deploy")
    first, last = done.work[0], done.work[-1]
    (payload,) = last.cargo
    assert not payload.held and not payload.seat and not last.hand.flags.count("CAPTURE")
    down = done.scenario.arm.model.mount.rotation.T @ [0.0, 0.0, 1.0]
    lifted = np.subtract(payload.position, first.cargo[0].position)
    assert lifted == pytest.approx(-11.0 * FOOT * down, abs=1e-3)  # as in the script
    assert turned(first, last) < 1e-4
    assert math.hypot(*payload.velocity) < 1e-6
    assert done.at("released", 1).cargo[0].position == pytest.approx(payload.position, abs=1e-6)


@pytest.mark.slow
def test_tutorial_starts_beside_the_pin_and_lifts_the_payload() -> None:
    done = flown("tutorial")
    first, last = done.work[0], done.work[-1]
    wanting = {condition.name for condition in first.conditions if not condition.holds}
    assert wanting == {"pin off axis", "pin depth"}
    assert last.cargo[0].held and not last.cargo[0].seat
    assert math.dist(last.cargo[0].position, first.cargo[0].position) > 1.0


@pytest.mark.slow
def test_payload_is_captured_only_with_its_fixture_in_the_envelope() -> None:
    before, work = flown("srms-deploy").about("acquired")
    assert work.cargo[0].held and work.cargo[0].seat == "bay" and not before.cargo[0].held
    assert {condition.name for condition in before.conditions} >= {"pin off axis", "pin depth", "roll"}
    assert all(condition.holds and condition.margin >= 0.0 for condition in before.conditions)


@pytest.mark.slow
def test_latches_move_the_payload_to_its_stowed_pose() -> None:
    done, stowed = flown("srms-berth"), seated("srms-deploy")
    (before,), (payload,) = done.at("latch").cargo, done.work[-1].cargo
    assert math.dist(before.position, stowed.cargo[0].position) == pytest.approx(0.5 * INCH, abs=1e-3)
    assert payload.position == pytest.approx(stowed.cargo[0].position, abs=1e-9)
    assert turned(done.work[-1], stowed) < 1e-7
    assert payload.seat == "bay" and not payload.held
    latching = [event.time_s for event in done.events if event.kind in ("latch", "latched")]
    assert latching[1] - latching[0] == pytest.approx(30.0, abs=0.03)


@pytest.mark.slow
def test_docked_payload_is_at_its_port_within_tolerance() -> None:
    for name in ("concept-1972-script", "free-flyer"):
        done = flown(name)
        (port,) = (seat for seat in done.scenario.worksite.berths if seat.name == "port")
        (cargo,) = done.scenario.payloads
        mount, docked = done.scenario.arm.model.mount, done.at("docked")
        assert cargo.probe is not None
        # R: X aft, Y port, Z down; the scene: x aft, y starboard, z up, both from the telescope's foot
        turn = np.array(docked.cargo[0].orientation)
        tip = np.add(docked.cargo[0].position, turn @ cargo.probe.position) * [1.0, -1.0, -1.0]
        moved = mount.rotation @ docked.orbiter * [-1.0, 1.0, -1.0]  # the port does not move with the orbiter
        assert math.dist(tip, port.pose.position - moved) <= port.distance


@pytest.mark.slow
def test_free_flyer_stays_in_its_deadband_until_captured() -> None:
    done = flown("free-flyer")
    (flyer,) = done.scenario.payloads
    assert flyer.limit_cycle is not None
    most = float(np.linalg.norm(flyer.limit_cycle.deadband))
    free = done.work[: next(done.tick(e) for e in done.events if e.kind == "acquired") - 1]
    angles = [turned(free[0], work) for work in free]
    assert max(angles) <= 2.0 * most
    assert max(angles) > 0.25 * most  # it does rotate
    assert all(not work.cargo[0].held for work in free)


@pytest.mark.slow
def test_payload_docked_in_space_stays_behind_when_the_orbiter_moves() -> None:
    done = flown("free-flyer")
    for phase in ("close in", "stand off", "come back"):
        steady = done.during(phase)[210:]  # the orbiter reaches its speed in 2 s, and reverses it in 4 s
        assert steady
        for work in steady:
            assert math.hypot(*work.orbiter_velocity) == pytest.approx(0.2 * FOOT)
            assert work.cargo[0].velocity == pytest.approx([-v for v in work.orbiter_velocity], abs=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("name", MISSIONS)
def test_mission_restored_from_any_saved_state_is_bit_identical(name: str) -> None:
    done = flown(name)
    assert len(done.saved) > 3
    for tick, saved in done.saved.items():
        other = aftdeck.Simulation(done.scenario)
        other.restore(msgspec.msgpack.decode(msgspec.msgpack.encode(saved), type=type(saved)))
        for expected in done.digests[tick : tick + GOES_ON]:
            assert other.step().sha256 == expected, tick


# --- rejected commands --------------------------------------------------------------------------------------

SRMS = """
arm = "srms"
worksite = "orbiter"
[[cargo]]
name = "payload"
[initial]
near = ["-35 deg", "87 deg", "-109 deg", "-79 deg", "16 deg", "-123 deg"]
{grasped}
[initial.pose]
frame = "panel"
position = ["-903.7323 in", "{y} in", "{z} in"]
pitch = "270 deg"
roll = "{roll} deg"
"""
GRASPED = """
[initial.grasped]
cargo = "payload"
joints = ["-31.097 deg", "80.888 deg", "-120.011 deg", "-61.23 deg", "16.592 deg", "-127.91 deg"]
"""
FIXTURE = 400.0 + 2.26 / INCH
"""Zo of the payload's grapple fixture in the bay [in]."""


def made(text: str) -> Scenario:
    return parse_scenario(f'title = "t"\n{text}', "t", "t.toml", Path("."))


def srms(above: float, y: float = 0.0, roll: float = 0.0, grasped: str = "") -> aftdeck.Simulation:
    """Return a run that starts with the end effector above and beside the fixture [in], and rolled [deg]."""
    return aftdeck.Simulation(made(SRMS.format(y=y, z=-(FIXTURE + above), roll=roll, grasped=grasped)))


def capture(sim: aftdeck.Simulation) -> list[Frame]:
    """Return the frames of CAPTURE until the snares are closed."""
    return fly(sim, 2.6, aftdeck.Inputs(effector="close"))


def texts(frames: Sequence[Frame], kind: str) -> list[str]:
    """Return the texts of the log lines of a kind."""
    return [event.text for frame in frames for event in frame.events if event.kind == kind]


def test_capture_outside_the_envelope_logs_the_failed_conditions() -> None:
    frames = capture(srms(above=2.0, y=6.0, roll=13.0))
    missed = texts(frames, "missed")
    assert len(missed) == 1
    assert re.search(r"pin 6 in .* 4 in", missed[0])
    assert "roll" in missed[0] and "13°" in missed[0] and "10°" in missed[0]
    assert "depth" not in missed[0] and "pitch" not in missed[0]
    work = frames[-1].work
    assert not work.cargo[0].held
    margins = {condition.name: condition.margin for condition in work.conditions}
    assert margins["pin off axis"] == pytest.approx(-2.0 * INCH, abs=1e-3)
    assert margins["roll"] == pytest.approx(math.radians(-3.0), abs=1e-3)
    assert margins["pin depth"] == pytest.approx(2.0 * INCH, abs=1e-3)


def test_capture_inside_the_envelope_holds_the_payload() -> None:
    work = capture(srms(above=2.0, y=2.0, roll=3.0))[-1].work
    assert work.cargo[0].held and work.cargo[0].seat == "bay"


def test_capture_far_from_any_fixture_logs_the_distance() -> None:
    (line,) = texts(capture(srms(above=140.0)), "missed")
    assert re.search(r"pin 1[12]\.\d ft .* 0 to 4 in", line)


def test_rejected_latch_lists_each_misplaced_trunnion_with_its_distance() -> None:
    frames = fly(srms(above=5.0, grasped=GRASPED), 0.1, aftdeck.Inputs(latch="latch"))
    (refused,) = texts(frames, "refused")
    for trunnion in ("forward port", "forward starboard", "aft port", "aft starboard", "keel"):
        assert re.search(f"{trunnion} trunnion (5|4.9[5-9]|5.0[0-5]?) in .* 1.97 in", refused)
    work = frames[-1].work
    assert work.cargo[0].held and not work.cargo[0].seat
    ready = [condition for condition in work.conditions if condition.name.endswith("latch ready")]
    assert [condition.margin for condition in ready] == pytest.approx([0.05 - 5.0 * INCH] * 5, abs=2e-3)


def test_latch_far_from_a_berth_and_unlatch_without_payload_are_rejected() -> None:
    sim = srms(above=150.0, grasped=GRASPED)
    (latch,) = texts(fly(sim, 0.1, aftdeck.Inputs(latch="latch")), "refused")
    assert re.match(r"LATCH .* Deployable payload .*12\.5 ft", latch)
    (unlatch,) = texts(fly(sim, 0.1, aftdeck.Inputs(latch="unlatch")), "refused")
    assert unlatch.startswith("UNLATCH ")


CONCEPT = """
arm = "concept-1972"
worksite = "concept-1972"
duration = "60 s"
[initial]
joints = ["0 deg", "32.25 deg", "-106.33 deg", "0 deg", "-15.92 deg", "0 deg"]
stand = "16 ft"
[[cargo]]
name = "payload"
"""
APOTHEM = 6.5 * math.cos(math.pi / 6)
"""Apothem of the payload, which is 13 ft across corners [ft]."""
BAR = 13.5 - 0.75 - 2.0 * APOTHEM - 0.75
"""Z of the top of the bar [ft]. The bar is 0.75 ft high, and the payload is 0.75 ft above the floor of the bay."""


def test_prong_closed_too_high_acquires_nothing_and_reports_the_height() -> None:
    frames = fly(aftdeck.Simulation(made(CONCEPT)), 4.0, aftdeck.Inputs(effector="close"))
    work = frames[-1].work
    assert not work.cargo[0].held and work.hand.opening == 0.0
    failing = [condition for condition in work.conditions if not condition.holds]
    assert len(failing) == 1 and failing[0].name == "palm height" and failing[0].value > 0.0
    height = BAR * FOOT - frames[-1].position[2]
    assert failing[0].margin == pytest.approx(0.75 * INCH - height, abs=1e-6)


# --- relative targets and starts -----------------------------------------------------------------------------


def phase(goal: str) -> str:
    return f'{CONCEPT}[[phase]]\nmode = "OPR CMD"\nduration = "30 s"\ntarget = {goal}\n'


def test_target_by_payload_is_its_capture_pose() -> None:
    sim = aftdeck.Simulation(made(phase('{ cargo = "payload", above = "0.5 ft" }')))
    while not sim.ended:
        frame = sim.step()
    assert sim.ended == "completed"
    assert frame.position == pytest.approx([28.0 * FOOT, 0.0, (BAR - 0.5) * FOOT], abs=1e-3)
    assert np.array(frame.orientation)[:, 0] == pytest.approx([0.0, 0.0, 1.0], abs=1e-4)


def test_target_by_berth_requires_a_held_payload() -> None:
    sim = aftdeck.Simulation(
        made(phase('{ seat = "port" }').replace('mode = "OPR CMD"', 'name = "p"\nmode = "OPR CMD"'))
    )
    frame = sim.step()
    assert sim.ended == "fault"
    (failure,) = texts([frame], "fault")
    assert "phase 'p'" in failure


@pytest.mark.parametrize(
    ("goal", "pattern"),
    [
        ('{ cargo = "box" }', r"phase\[0\]\.target\.cargo: .*'box'.* payload"),
        ('{ seat = "dock" }', r"phase\[0\]\.target\.seat: .*'dock'.* port, bay"),
        ('{ seat = "bay", cargo = "payload" }', r"phase\[0\]\.target: .*cargo.*seat.*above"),
        ('{ seat = "bay", roll = "1 deg" }', r"phase\[0\]\.target: .*cargo.*seat.*above"),
        ('{ above = "1 ft" }', r"phase\[0\]\.target: above.*offset.*cargo.*seat"),
        ('{ joints = [0, 1, -1, 0, 0, 0], above = "1 ft" }', r"phase\[0\]\.target: above.*offset"),
    ],
)
def test_invalid_relative_target_is_rejected(goal: str, pattern: str) -> None:
    with pytest.raises(ScenarioError) as caught:
        made(phase(goal))
    assert any(re.search(pattern, problem) for problem in caught.value.problems), caught.value.problems


AT_START = 'joints = ["0 deg", "32.25 deg", "-106.33 deg", "0 deg", "-15.92 deg", "0 deg"]'
NATURAL = 'near = ["0 deg", "32 deg", "-106 deg", "0 deg", "-16 deg", "0 deg"]'


def test_start_can_be_relative_to_a_payload_a_berth_or_a_body() -> None:
    middle = 'position = ["-4 ft", "0 ft", "6 ft"], matrix = [[0, 0, -1], [0, -1, 0], [-1, 0, 0]]'
    for pose, expected in [
        ('{ cargo = "payload", above = "4 ft" }', [28.0, 0.0, BAR - 4.0]),
        ('{ cargo = "payload", above = "4 ft", offset = ["1 ft", "2 ft", "3 ft"] }', [29.0, -2.0, BAR - 7.0]),
        (f'{{ frame = "orbiter bay", {middle} }}', None),
        (f'{{ frame = "bay", {middle} }}', [24.0, 0.0, BAR + 0.75 + APOTHEM - 6.0]),
        (f'{{ frame = "cae", {middle.replace("-4 ft", "34 ft")} }}', [22.5, 16.0, -28.0]),
    ]:
        text = CONCEPT.replace(AT_START, f"pose = {pose}\n{NATURAL}")
        assert text != CONCEPT
        if expected is None:
            with pytest.raises(ScenarioError, match=r"'orbiter bay': .* L, orbiter, panel, cae, port, bay"):
                made(text)
            continue
        frame = aftdeck.Simulation(made(text)).step(aftdeck.Inputs())
        assert frame.position == pytest.approx(np.array(expected) * FOOT, abs=1e-9)


def test_start_at_a_berth_requires_a_held_payload() -> None:
    with pytest.raises(ScenarioError, match=r"initial.pose: .* berth"):
        made(CONCEPT.replace(AT_START, 'pose = { seat = "port" }'))


@pytest.mark.parametrize("seat", ["bay", "port"])
def test_start_at_a_berth_puts_the_held_payload_into_it(seat: str) -> None:
    held = 'grasped = { cargo = "payload", above = "0.36 in", stand = "16 ft" }'
    text = CONCEPT.replace(AT_START, f'pose = {{ seat = "{seat}", above = "0.1 ft" }}\n{NATURAL}\n{held}')
    frame = aftdeck.Simulation(made(text)).step(aftdeck.Inputs())
    place = {"bay": [28.0, 0.0, BAR + 0.75 + APOTHEM - 0.1], "port": [12.1, 16.0, -22.0]}[seat]
    assert frame.work.cargo[0].position == pytest.approx(np.array(place) * FOOT, abs=1e-9)
