"""Frames and welcome as pages receive them."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from aftdeck.frames import Pose
from aftdeck.report.lamps import lit_lamps
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.conversion.welcome_of import welcome_of
from aftdeck.station.core.commands import inputs_of
from aftdeck.station.core.page_inputs import CENTRED
from aftdeck.station.messages import from_page, kinds
from aftdeck.station.messages.frame import Frame
from aftdeck.tuples import Vec3
from tests.loaded import scenario
from tests.steering.flying import BAY, PAYLOAD
from tests.steering.flying import scenario as scenario_of_text

OVER_THE_PIN = Path(__file__).parents[1] / "browser" / "over-the-pin.toml"
SCENE = np.diag([-1.0, 1.0, -1.0])


def flown(inputs: Inputs, steps: int = 40, name: str = "first-flight") -> tuple[Simulation, Frame]:
    """Return a simulation after some steps, and its last frame as a page receives it."""
    sim = Simulation(scenario(name))
    for _ in range(steps):
        frame = sim.step(inputs)
    return sim, Displays(scenario(name)).frame(frame, 7)


def test_read_outs_are_those_of_the_arm() -> None:
    sim, shown = flown(Inputs(translation=(1.0, 0.5, 0.0), rotation=(0.0, 0.3, 0.0)))
    arm = sim.scenario.arm
    position, attitude = arm.panel(arm.forward(shown.angles))
    assert np.array(shown.display.actual.position) / 0.0254 == pytest.approx(position, abs=1e-9)
    assert np.degrees(shown.display.actual.attitude) == pytest.approx(attitude, abs=1e-9)
    commanded = arm.forward(shown.angles_commanded)
    assert np.array(shown.display.commanded.position) / 0.0254 == pytest.approx(arm.panel(commanded)[0], abs=1e-9)


def test_first_flight_starts_above_the_bay_pointing_down() -> None:
    _, shown = flown(Inputs(), steps=1)
    assert np.array(shown.display.actual.position) / 0.0254 == pytest.approx([-942.0, 0.0, -557.48], abs=1e-6)
    assert np.degrees(shown.display.actual.attitude) == pytest.approx([270.0, 0.0, 0.0], abs=1e-6)


def test_target_keyed_in_from_the_panel_is_the_pose_shown() -> None:
    sim, shown = flown(Inputs(rotation=(0.2, 0.4, -0.3)))
    message = from_page.SetTarget(0, shown.display.actual.position, shown.display.actual.attitude)
    target = inputs_of(CENTRED, message, sim.scenario.arm).target
    assert target is not None
    pose = target.pose
    tip = sim.scenario.arm.forward(shown.angles)
    assert pose.position == pytest.approx(tip.position, abs=1e-12)
    assert pose.rotation == pytest.approx(tip.rotation, abs=1e-12)


@pytest.mark.parametrize("telescope", [0.0, 1.0, -1.0])
def test_commanded_pose_moves_with_the_telescope(telescope: float) -> None:
    _, shown = flown(Inputs(telescope=telescope), name="concept-1972")
    assert shown.display.commanded.position == pytest.approx(shown.display.actual.position, abs=1e-9)
    assert shown.display.commanded.attitude == pytest.approx(shown.display.actual.attitude, abs=1e-9)


@pytest.mark.parametrize("mode", ["ORB LD", "PL"])
def test_read_outs_with_a_captured_payload_are_its_point_and_axes(mode: str) -> None:
    sim, shown = flown(Inputs(mode=mode), steps=1, name="srms-berth")
    (cargo,) = shown.work.cargo
    assert cargo.held
    assert shown.display.commanded.position == pytest.approx(shown.display.actual.position, abs=1e-9)
    assert shown.display.commanded.attitude == pytest.approx(shown.display.actual.attitude, abs=1e-9)
    drawn = [body.name for body in welcome_of(sim.scenario, demo=False).bodies].index("payload")
    x, y, z, w, i, j, k = shown.display.poses[7 * drawn : 7 * drawn + 7]
    assert [x, y, z] == pytest.approx(
        SCENE @ np.array(shown.display.actual.position) - sim.scenario.worksite.origin, abs=1e-6
    )
    if mode == "PL":
        own = Rotation.from_quat([i, j, k, w]).as_matrix()
        w, i, j, k = shown.display.axes
        assert Rotation.from_quat([i, j, k, w]).as_matrix() == pytest.approx(own, abs=1e-9)


@pytest.mark.parametrize("name", ["concept-1972", "srms-deploy"])
def test_berth_of_a_payload_is_in_the_welcome(name: str) -> None:
    _, shown = flown(Inputs(), steps=1, name=name)
    (cargo,) = shown.work.cargo
    assert cargo.seat in [seat.name for seat in welcome_of(scenario(name), demo=False).work.seats]


@pytest.mark.parametrize("axis", range(3))
def test_velocities_are_the_rates_of_the_read_outs(axis: int) -> None:
    push = [0.0, 0.0, 0.0]
    push[axis] = 1.0
    displays = Displays(scenario())
    sim = Simulation(scenario())
    for _ in range(100):
        sim.step(Inputs(translation=(push[0], push[1], push[2])))
    before = displays.frame(sim.step(Inputs(translation=(push[0], push[1], push[2]))), 0)
    after = displays.frame(sim.step(Inputs(translation=(push[0], push[1], push[2]))), 0)
    moved = (np.array(after.display.actual.position) - before.display.actual.position) / 0.02
    assert moved == pytest.approx(after.display.actual.velocity, abs=2e-3)  # the tip also rotates within a step
    assert moved[axis] > 0.01


def test_angular_rates_are_in_the_order_pitch_yaw_roll() -> None:
    for axis, place in ((0, 2), (1, 0), (2, 1)):
        turn = [0.0, 0.0, 0.0]
        turn[axis] = 1.0
        _, shown = flown(Inputs(rotation=(turn[0], turn[1], turn[2])), steps=100)
        rates = shown.display.actual.turn_rate
        assert rates[place] == max(rates, key=abs) > 0.001


def test_control_axes_are_those_of_the_orbiter_or_end_effector() -> None:
    sim, shown = flown(Inputs())
    w, x, y, z = shown.display.axes
    assert Rotation.from_quat([x, y, z, w]).as_matrix() == pytest.approx(SCENE, abs=1e-12)
    sim, shown = flown(Inputs(mode="END EFF"))
    w, x, y, z = shown.display.axes
    arm = sim.scenario.arm
    tip = arm.forward(shown.angles)
    own = arm.model.mount.to("panel", Pose(tip.position, arm.end_effector(tip.rotation)))
    assert Rotation.from_quat([x, y, z, w]).as_matrix() == pytest.approx(SCENE @ own.rotation, abs=1e-12)


def test_lit_lamp_has_its_cause() -> None:
    _, cradled = flown(Inputs(), steps=1, name="uncradle")
    lit_lamps = {lamp.name: lamp.text for lamp in cradled.display.lamps}
    assert {"REACH LIM", "SOFT STOP", "SINGULAR"} <= set(lit_lamps)
    assert all(lit_lamps.values())
    _, free = flown(Inputs(), steps=1)
    assert free.display.lamps == ()


def lit(sim: Simulation, until: str, **inputs: Any) -> dict[str, str]:
    """Step until an end effector flag is lit, and return the levels of the end effector's lamps."""
    frame = sim.step(Inputs(**inputs))
    while until not in frame.work.hand.flags:
        frame = sim.step(Inputs())
        assert frame.time_s < 60.0
    names = ("DERIGIDIZE", "RELEASE")
    return {lamp.name: lamp.level for lamp in lit_lamps(sim.scenario, frame) if lamp.name in names}


def test_derigidize_and_release_are_lit_during_a_release() -> None:
    sim = Simulation(scenario("srms-berth"))
    assert lit(sim, "RIGID") == {}
    assert lit(sim, "DERIGID", effector="open") == {"DERIGIDIZE": "info", "RELEASE": "info"}
    assert lit(sim, "OPEN") == {}


def test_derigidize_is_a_caution_when_the_switch_is_off() -> None:
    sim = Simulation(scenario("srms-berth"))
    sim.step(Inputs(effector_mode="manual"))
    assert lit(sim, "DERIGID", rigid="derigid") == {"DERIGIDIZE": "info"}
    assert lit(sim, "DERIGID", rigid="off") == {"DERIGIDIZE": "caution"}


def test_empty_end_effector_has_the_distance_to_the_next_fixture() -> None:
    over = Simulation(load_scenario(OVER_THE_PIN))
    frame = Displays(over.scenario).frame(over.step(Inputs()), 0)
    (depth,) = (condition for condition in frame.work.conditions if condition.name == "pin depth")
    assert frame.display.to_go is not None
    assert frame.display.to_go.to == "pin"
    assert frame.display.to_go.distance == pytest.approx(depth.value, abs=1e-3)


def test_motion_to_the_fixture_is_along_the_axes_of_the_sticks() -> None:
    sim = Simulation(scenario("tutorial"))
    displays = Displays(sim.scenario)
    for mode, axis in (("END EFF", 0), ("ORB UNL", 2)):  # the end effector points straight down
        sim.step(Inputs(mode=mode))
        before = left(displays.frame(sim.step(Inputs()), 0))
        assert max(before) == before[axis] == pytest.approx(2.0, abs=0.1)
        for _ in range(100):
            sim.step(Inputs(translation=(0.0, 1.0, 0.0)))
        after = left(displays.frame(sim.step(Inputs()), 0))
        assert after[1] < before[1] - 0.05
        assert (after[0], after[2]) == pytest.approx((before[0], before[2]), abs=0.01)
    sim.step(Inputs(mode="SINGLE"))
    shown = displays.frame(sim.step(Inputs()), 0).display.to_go
    assert shown is not None
    assert (shown.translation, shown.rotation) == (None, None)


def left(frame: Frame) -> Vec3:
    """Return the translation that is left in a frame."""
    assert frame.display.to_go is not None
    assert frame.display.to_go.translation is not None
    return frame.display.to_go.translation


def test_frame_and_welcome_survive_json() -> None:
    _, shown = flown(Inputs(translation=(1.0, 0.0, 0.0)))
    welcome = welcome_of(scenario(), demo=True)
    for message in (shown, welcome):
        assert msgspec.json.decode(msgspec.json.encode(message), type=type(message)) == message
    assert welcome.phases[0] == "up"


def test_controllers_with_full_mappings_fit_into_a_message() -> None:
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


def test_other_messages_are_far_below_the_length_limit() -> None:
    third, pi = -1.0 / 3.0, -math.pi * 1e-300
    longest = [
        from_page.Sticks(2**53 - 1, (third, third, third), (pi, pi, pi), third),
        from_page.SetTarget(2**53 - 1, (third, third, third), (pi, pi, pi)),
    ]
    assert max(len(msgspec.json.encode(message)) for message in longest) < kinds.MAX_MESSAGE_BYTES / 8


def test_every_body_has_a_pose_with_and_without_an_own_payload() -> None:
    still = '[[phase]]\nmode = "ORB UNL"\nduration = 0.08\n'
    made = scenario_of_text(
        BAY, f"control_period = 0.08\n{PAYLOAD.format(mass='1000 lb')}\n{still}{still}detached = true\n"
    )
    sim, displays, bodies = Simulation(made), Displays(made), welcome_of(made, demo=False).bodies
    for held in (True, False):
        frame = sim.step()
        assert (frame.payload is not None) == held
        assert len(displays.frame(frame, 0).display.poses) == 7 * len(bodies)
