"""Remaining motion: it vanishes at the place, and moving by it leads there."""

from __future__ import annotations

import math
from dataclasses import replace

import msgspec
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from aftdeck.scenario.schema import Plant
from aftdeck.scenario.target import AtBerth, AtPayload, InFrame
from aftdeck.scenario.task_file import StateSpec
from aftdeck.scenario.task_step import TaskStep
from aftdeck.scene.stick_axes import StickAxes
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.conversion.to_go import to_go
from aftdeck.task.along_sticks import along_sticks
from aftdeck.task.places import Places
from aftdeck.task.remaining import Aims
from aftdeck.worksite.conditions import all_ready
from tests.loaded import scenario

STILL = Inputs()
STRAIGHT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def step_to(target: AtPayload | AtBerth | InFrame) -> TaskStep:
    """Return a step with a target."""
    return TaskStep("", "", StateSpec(), target, None, 0.0, None, (), (), (), (), None, ())


@pytest.mark.parametrize("plant", ["kinematic", "rigid"])
@pytest.mark.parametrize("name", ["srms-berth", "free-flyer"])
def test_carriers_are_where_the_simulation_has_them(name: str, plant: Plant) -> None:
    sim = Simulation(replace(scenario(name), plant=plant, orbiter="free" if name == "srms-berth" else "fixed"))
    places = Places(sim.scenario)
    for _ in range(150):
        frame = sim.step(Inputs(orbiter=(1.0, 0.4, 0.0), translation=(0.3, 0.0, -0.5)))
    site, frames = sim._flight.site, sim._state.worksite.frames
    for carrier in ("orbiter", "space"):
        pose, row = places.carrier(frame, carrier), frames[site.layout.frames.index(carrier)]
        assert pose.position == pytest.approx(row[:3], abs=2e-9)
        assert np.ravel(pose.orientation) == pytest.approx(row[3:], abs=2e-9)


def test_payload_in_its_berth_has_nothing_left() -> None:
    sim = Simulation(scenario("concept-1972"))
    frame = sim.step(Inputs(initialise="extraction"))
    left = Aims(sim.scenario).remaining(frame, step_to(AtBerth("bay")))
    assert left is not None
    assert left.arrived
    assert left.distance == pytest.approx(0.0, abs=1e-6)
    assert Places(sim.scenario).above(frame, AtBerth("bay", above=1.0)) == pytest.approx(0.0, abs=1e-6)


def test_place_is_reached_when_all_conditions_of_the_capture_hold() -> None:
    sim = Simulation(scenario("srms-deploy"))
    aims, ready, beyond = Aims(sim.scenario), 0, 0
    while not (frame := sim.step()).work.cargo[0].held:
        left = aims.remaining(frame, step_to(AtPayload(0)))
        above = aims.remaining(frame, step_to(AtPayload(0, above=1.0)))
        assert left is not None and above is not None
        if all_ready(frame.work.conditions):
            ready += 1
            assert left.arrived and not above.arrived
        else:
            beyond += not left.arrived
    assert ready > 0 and beyond > 0


def test_height_above_a_payload_is_measured_back_along_the_end_effector() -> None:
    sim = Simulation(scenario("tutorial"))
    places, frame = Places(sim.scenario), sim.step(STILL)
    high = places.above(frame, AtPayload(0))
    assert high == pytest.approx(places.above(frame, AtPayload(0, above=0.3)))
    assert high == pytest.approx(2.0, abs=0.02)  # the scenario begins 2 m above the fixture


@pytest.mark.parametrize("name", ["srms-deploy", "srms-berth", "concept-1972"])
def test_only_a_place_far_from_a_payload_or_a_berth_is_named_above_or_before_it(name: str) -> None:
    loaded = scenario(name)
    aims, frame = Aims(loaded), Simulation(loaded).step(STILL)
    targets = [step.target for step in loaded.steps if isinstance(step.target, AtPayload | AtBerth)]
    for target in {targets[0], targets[-1]}:
        names = {}
        for above in (0.0, 0.09, 0.11, 3.0):
            left = aims.remaining(frame, step_to(msgspec.structs.replace(target, above=above)))
            assert left is not None
            names[above] = left.to
        assert names[0.0] == names[0.09] and names[0.11] == names[3.0]
        assert names[3.0] in (f"above {names[0.0]}", f"before {names[0.0]}")


def test_angle_of_a_joint_is_signed() -> None:
    sim = Simulation(scenario("uncradle"))
    aims, step = Aims(sim.scenario), sim.scenario.steps[0]
    left = aims.remaining(sim.step(STILL), step)
    assert left is not None
    assert (left.to, left.pose) == ("shoulder pitch", None)
    assert left.angle == pytest.approx(math.radians(25.0), abs=1e-6)


@pytest.mark.parametrize("mode", ["ORB UNL", "END EFF"])
def test_motion_along_and_about_the_sticks_leads_to_the_place(mode: str) -> None:
    """The components, applied about the axes of the sticks, move the tip to the pose of the target."""
    sim = Simulation(scenario("srms-deploy"))
    for _ in range(60):
        sim.step(Inputs(rotation=(0.5, 0.3, -0.4)))
    sim.step(Inputs(mode=mode))
    frame = sim.step(STILL)
    shown = Displays(sim.scenario).frame(frame, 0).display
    left = Aims(sim.scenario).remaining(frame, None)
    assert shown.to_go is not None and shown.to_go.translation is not None and shown.to_go.rotation is not None
    assert left is not None and left.pose is not None
    w, x, y, z = shown.axes
    mount = sim.scenario.arm.model.mount.rotation
    in_scene = np.diag([-1.0, 1.0, -1.0]) @ mount  # L to scene
    axes = in_scene.T @ Rotation.from_quat([x, y, z, w]).as_matrix()
    turn = Rotation.from_rotvec(axes @ shown.to_go.rotation).as_matrix()
    assert frame.position + axes @ shown.to_go.translation == pytest.approx(np.array(left.pose.position), abs=1e-6)
    assert turn @ np.array(frame.orientation) == pytest.approx(np.array(left.pose.orientation), abs=1e-6)


@pytest.mark.parametrize("payload_axes", [False, True])
def test_rotation_to_go_turns_the_payload_in_either_law_of_orb_ld(payload_axes: bool) -> None:
    sim = Simulation(scenario("srms-berth"))
    for _ in range(400):
        sim.step(Inputs(rotation=(0.5, 0.8, -0.6)))
    sim.step(Inputs(mode="ORB LD", payload_axes=payload_axes))
    frame = sim.step(STILL)
    assert frame.law == (7 if payload_axes else 4)
    left = Aims(sim.scenario).remaining(frame, step_to(AtBerth("bay", above=3.0)))
    assert left is not None and left.motion is not None
    along = along_sticks(left, frame, StickAxes(sim.scenario).in_l(frame))
    assert along is not None
    push = 0.5 * np.array(along.rotation) / np.abs(along.rotation).max()
    demanded = np.array(sim.step(Inputs(rotation=(push[0], push[1], push[2]))).twist_demanded[:3])
    wanted = Rotation.from_matrix(np.array(left.motion.orientation)).as_rotvec()
    assert demanded / np.linalg.norm(demanded) == pytest.approx(wanted / np.linalg.norm(wanted), abs=2e-3)


def test_shift_moves_the_drawn_payload_into_its_berth() -> None:
    sim = Simulation(scenario("srms-berth"))
    displays, aims = Displays(sim.scenario), Aims(sim.scenario)
    frame = sim.step(STILL)
    seat = next(seat for seat in sim.scenario.worksite.berths if seat.name == "bay")
    shown = displays.frame(frame, 0).display
    assert shown.to_go is None  # the berth is too far to be an objective
    left = aims.remaining(frame, step_to(AtBerth("bay")))
    assert left is not None
    message = to_go(left, frame, displays._poses, (STRAIGHT, STRAIGHT))
    x, y, z, *payload_turn = shown.poses[-7:]
    px, py, pz, *turn = message.shift
    moving = Rotation.from_quat([*turn[1:], turn[0]])
    moved = np.add(moving.apply([x, y, z]), [px, py, pz])
    seated = seat.seated(sim.scenario.payloads[0].probe)
    assert moved == pytest.approx(seated.position, abs=1e-5)  # the scene is the orbiter's frame
    turned = moving * Rotation.from_quat([*payload_turn[1:], payload_turn[0]])
    assert turned.as_matrix() == pytest.approx(seated.rotation, abs=1e-5)
