from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from aftdeck.frames import Pose
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station import from_page, kinds, to_page
from aftdeck.station.wire import Translator
from tests.station.pages import scenario
from tests.steering.flying import BAY, PAYLOAD
from tests.steering.flying import scenario as written

OVER_THE_PIN = Path(__file__).parents[1] / "browser" / "over-the-pin.toml"
SCENE = np.diag([-1.0, 1.0, -1.0])


def flown(inputs: Inputs, steps: int = 40, name: str = "first-flight") -> tuple[Simulation, to_page.Frame]:
    """A simulation after some steps, and its last frame for the page."""
    sim = Simulation(scenario(name))
    for _ in range(steps):
        frame = sim.step(inputs)
    return sim, Translator(scenario(name), demo=False).frame(frame, 7)


def test_the_frames_panel_numbers_are_those_of_the_arm() -> None:
    sim, shown = flown(Inputs(translation=(1.0, 0.5, 0.0), rotation=(0.0, 0.3, 0.0)))
    arm = sim.scenario.arm
    position, attitude = arm.panel(arm.forward(shown.joints))
    assert np.array(shown.actual.position) / 0.0254 == pytest.approx(position, abs=1e-9)
    assert np.degrees(shown.actual.attitude) == pytest.approx(attitude, abs=1e-9)
    commanded = arm.forward(shown.joints_commanded)
    assert np.array(shown.commanded.position) / 0.0254 == pytest.approx(arm.panel(commanded)[0], abs=1e-9)


def test_first_flight_starts_over_the_bays_middle_looking_down() -> None:
    _, shown = flown(Inputs(), steps=1)
    assert np.array(shown.actual.position) / 0.0254 == pytest.approx([-942.0, 0.0, -557.48], abs=1e-6)
    assert np.degrees(shown.actual.attitude) == pytest.approx([270.0, 0.0, 0.0], abs=1e-6)


def test_a_target_on_the_panel_is_the_pose_that_the_panel_shows() -> None:
    sim, shown = flown(Inputs(rotation=(0.2, 0.4, -0.3)))
    message = from_page.SetTarget(0, shown.actual.position, shown.actual.attitude)
    pose = Translator(sim.scenario, demo=False).target(message)
    tip = sim.scenario.arm.forward(shown.joints)
    assert pose.position == pytest.approx(tip.position, abs=1e-12)
    assert pose.rotation == pytest.approx(tip.rotation, abs=1e-12)


@pytest.mark.parametrize("telescope", [0.0, 1.0, -1.0])
def test_what_is_commanded_rides_on_the_telescope_as_the_arm_does(telescope: float) -> None:
    _, shown = flown(Inputs(telescope=telescope), name="concept-1972")
    assert shown.commanded.position == pytest.approx(shown.actual.position, abs=1e-9)
    assert shown.commanded.attitude == pytest.approx(shown.actual.attitude, abs=1e-9)


@pytest.mark.parametrize("mode", ["ORB LD", "PL"])
def test_what_is_shown_of_a_payload_that_was_captured_is_its_own_point_and_axes(mode: str) -> None:
    sim, shown = flown(Inputs(mode=mode), steps=1, name="srms-berth")
    (cargo,) = shown.work.cargo
    assert cargo.held
    assert shown.commanded.position == pytest.approx(shown.actual.position, abs=1e-9)
    assert shown.commanded.attitude == pytest.approx(shown.actual.attitude, abs=1e-9)
    drawn = [body.name for body in Translator(sim.scenario, demo=False).welcome.bodies].index("payload")
    x, y, z, w, i, j, k = shown.poses[7 * drawn : 7 * drawn + 7]
    assert [x, y, z] == pytest.approx(SCENE @ np.array(shown.actual.position) - sim.scenario.worksite.origin, abs=1e-6)
    if mode == "PL":
        own = Rotation.from_quat([i, j, k, w]).as_matrix()
        w, i, j, k = shown.axes
        assert Rotation.from_quat([i, j, k, w]).as_matrix() == pytest.approx(own, abs=1e-9)


@pytest.mark.parametrize("name", ["concept-1972", "srms-deploy"])
def test_a_payload_is_where_the_welcome_has_a_seat_of_that_title(name: str) -> None:
    _, shown = flown(Inputs(), steps=1, name=name)
    (cargo,) = shown.work.cargo
    assert cargo.seat in Translator(scenario(name), demo=False).welcome.work.seats


@pytest.mark.parametrize("axis", range(3))
def test_velocities_are_the_rates_of_the_numbers_shown(axis: int) -> None:
    push = [0.0, 0.0, 0.0]
    push[axis] = 1.0
    translator = Translator(scenario(), demo=False)
    sim = Simulation(scenario())
    for _ in range(100):
        sim.step(Inputs(translation=(push[0], push[1], push[2])))
    before = translator.frame(sim.step(Inputs(translation=(push[0], push[1], push[2]))), 0)
    after = translator.frame(sim.step(Inputs(translation=(push[0], push[1], push[2]))), 0)
    moved = (np.array(after.actual.position) - before.actual.position) / 0.02
    assert moved == pytest.approx(after.actual.velocity, abs=2e-3)  # it turns within a step
    assert moved[axis] > 0.01


def test_turn_rates_stand_in_the_order_pitch_yaw_roll() -> None:
    for axis, place in ((0, 2), (1, 0), (2, 1)):
        turn = [0.0, 0.0, 0.0]
        turn[axis] = 1.0
        _, shown = flown(Inputs(rotation=(turn[0], turn[1], turn[2])), steps=100)
        rates = shown.actual.turn_rate
        assert rates[place] == max(rates, key=abs) > 0.001


def test_the_control_axes_are_the_orbiters_or_the_end_effectors_own() -> None:
    sim, shown = flown(Inputs())
    w, x, y, z = shown.axes
    assert Rotation.from_quat([x, y, z, w]).as_matrix() == pytest.approx(SCENE, abs=1e-12)
    sim, shown = flown(Inputs(mode="END EFF"))
    w, x, y, z = shown.axes
    arm = sim.scenario.arm
    tip = arm.forward(shown.joints)
    own = arm.model.mount.to("panel", Pose(tip.position, arm.end_effector(tip.rotation)))
    assert Rotation.from_quat([x, y, z, w]).as_matrix() == pytest.approx(SCENE @ own.rotation, abs=1e-12)


def test_a_lamp_burns_with_its_cause() -> None:
    _, cradled = flown(Inputs(), steps=1, name="uncradle")
    lamps = {lamp.name: lamp.text for lamp in cradled.lamps}
    assert {"REACH LIM", "SOFT STOP", "SINGULAR"} <= set(lamps)
    assert all(lamps.values())
    _, free = flown(Inputs(), steps=1)
    assert free.lamps == ()


def lit(sim: Simulation, until: str, **inputs: Any) -> dict[str, str]:
    """Levels of the end effector's lamps once a flag of it is lit that was not."""
    translator = Translator(sim.scenario, demo=False)
    frame = sim.step(Inputs(**inputs))
    while until not in frame.work.hand.flags:
        frame = sim.step(Inputs())
        assert frame.time_s < 60.0
    names = ("DERIGIDIZE", "RELEASE")
    return {lamp.name: lamp.level for lamp in translator.lamps(frame) if lamp.name in names}


def test_derigidize_and_release_burn_while_a_payload_is_let_go() -> None:
    sim = Simulation(scenario("srms-berth"))
    assert lit(sim, "RIGID") == {}
    assert lit(sim, "DERIGID", effector="open") == {"DERIGIDIZE": "info", "RELEASE": "info"}
    assert lit(sim, "OPEN") == {}


def test_derigidize_is_a_caution_where_a_payload_was_left_so() -> None:
    sim = Simulation(scenario("srms-berth"))
    sim.step(Inputs(effector_mode="manual"))
    assert lit(sim, "DERIGID", rigid="derigid") == {"DERIGIDIZE": "info"}
    assert lit(sim, "DERIGID", rigid="off") == {"DERIGIDIZE": "caution"}


def test_an_empty_end_effector_is_told_how_far_the_next_fixture_is() -> None:
    _, held = flown(Inputs(), steps=1, name="srms-berth")
    assert held.work.fixture is None
    _, shown = flown(Inputs(), steps=1, name="srms-deploy")
    assert shown.work.fixture is not None
    assert 0.0 < shown.work.fixture < 40.0
    over = Simulation(load_scenario(OVER_THE_PIN))
    frame = Translator(over.scenario, demo=False).frame(over.step(Inputs()), 0)
    (depth,) = (condition for condition in frame.work.conditions if condition.name == "pin depth")
    assert frame.work.fixture == pytest.approx(depth.value, abs=1e-3)


def test_the_way_to_the_fixture_is_along_the_axes_that_the_sticks_move_along() -> None:
    sim = Simulation(scenario("tutorial"))
    translator = Translator(sim.scenario, demo=False)
    for mode, axis in (("END EFF", 0), ("ORB UNL", 2)):  # the hand looks straight down
        sim.step(Inputs(mode=mode))
        before = translator.frame(sim.step(Inputs()), 0).work.to_fixture
        assert before is not None
        assert max(before) == before[axis] == pytest.approx(2.0, abs=0.1)
        for _ in range(100):
            sim.step(Inputs(translation=(0.0, 1.0, 0.0)))
        after = translator.frame(sim.step(Inputs()), 0).work.to_fixture
        assert after is not None
        assert after[1] < before[1] - 0.05
        assert (after[0], after[2]) == pytest.approx((before[0], before[2]), abs=0.01)
    sim.step(Inputs(mode="SINGLE"))
    assert translator.frame(sim.step(Inputs()), 0).work.to_fixture is None


def test_a_frame_and_the_welcome_come_back_from_json_as_they_went() -> None:
    _, shown = flown(Inputs(translation=(1.0, 0.0, 0.0)))
    welcome = Translator(scenario(), demo=True).welcome
    for message in (shown, welcome):
        assert msgspec.json.decode(msgspec.json.encode(message), type=type(message)) == message
    assert welcome.phases[0] == "up"


def test_the_controllers_with_full_mappings_fit_into_a_message() -> None:
    used = from_page.ControllerInUse(
        "rhc joystick",
        "🕹" * 80,
        -math.pi * -0.1 / 2,
        1 / 3,
        ("x" * 16 + " " + "y" * 16,) * 64,
        (-0.29999999999999993,) * 16,
    )
    message = from_page.Controllers(2**53 - 1, (used,) * 5)
    text = msgspec.json.encode(message)
    assert len(text) <= kinds.MAX_MESSAGE_BYTES
    assert msgspec.json.decode(text, type=from_page.Controllers) == message
    with pytest.raises(msgspec.ValidationError):
        msgspec.json.decode(msgspec.json.encode(from_page.Controllers(0, (used,) * 6)), type=from_page.Controllers)


def test_the_longest_message_of_a_page_is_far_below_the_limit() -> None:
    third, pi = -1.0 / 3.0, -math.pi * 1e-300
    longest = [
        from_page.Sticks(2**53 - 1, (third, third, third), (pi, pi, pi), third),
        from_page.SetTarget(2**53 - 1, (third, third, third), (pi, pi, pi)),
    ]
    assert max(len(msgspec.json.encode(message)) for message in longest) < kinds.MAX_MESSAGE_BYTES / 8


def test_every_body_has_a_pose_whether_a_payload_without_shape_is_held_or_detached() -> None:
    still = '[[phase]]\nmode = "ORB UNL"\nduration = 0.08\n'
    made = written(BAY, f"control_period = 0.08\n{PAYLOAD.format(mass='1000 lb')}\n{still}{still}detached = true\n")
    sim, translator = Simulation(made), Translator(made, demo=False)
    for held in (True, False):
        frame = sim.step()
        assert (frame.payload is not None) == held
        assert len(translator.frame(frame, 0).poses) == 7 * len(translator.welcome.bodies)
