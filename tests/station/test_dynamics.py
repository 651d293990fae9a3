"""Wire messages of a flight on a plant with masses."""

from __future__ import annotations

import numpy as np
import pytest
from msgspec.structs import replace

import aftdeck
from aftdeck.report.lamps import lit_lamps
from aftdeck.scenario.disturbance import Disturbance
from aftdeck.simulation.inputs import Inputs
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.conversion.welcome_of import welcome_of


def test_welcome_tells_the_plant_and_the_torque_limits() -> None:
    flexible = welcome_of(aftdeck.load_scenario("first-flight", {("plant",): "flexible"}), demo=False)
    kinematic = welcome_of(aftdeck.load_scenario("first-flight"), demo=False)
    assert (flexible.plant, kinematic.plant) == ("flexible", "kinematic")
    limits = [joint.torque for joint in flexible.joints]
    assert limits == sorted((limit for limit in limits if limit), reverse=True)  # strongest at the shoulder
    assert {joint.torque for joint in kinematic.joints} == {None}


def test_lamp_names_the_joint_that_is_driven_back_or_slips() -> None:
    scenario = aftdeck.load_scenario("first-flight", {("plant",): "rigid"})
    frame = aftdeck.Simulation(scenario).step(Inputs())
    assert frame.dynamics is not None
    assert "CONTR ERR" not in {lamp.name for lamp in lit_lamps(scenario, frame)}
    back = replace(frame, dynamics=replace(frame.dynamics, overdriven=(2,)))
    slipping = replace(back, brakes=True)
    texts = [{lamp.name: lamp.text for lamp in lit_lamps(scenario, one)}["CONTR ERR"] for one in (back, slipping)]
    assert all("elbow" in text.lower() for text in texts)
    assert texts[0] != texts[1]


def test_page_receives_the_force_of_a_disturbance_where_it_acts() -> None:
    """In the scene frame, whose axes are those of the orbiter frame with x aft and z up."""
    scenario = aftdeck.load_scenario("first-flight", {("plant",): "rigid"})
    sim = aftdeck.Simulation(scenario)
    push = Disturbance("orbiter", force=(30.0, -20.0, 10.0), frame="orbiter", at=(1.0, 2.0, 3.0))
    shown = Displays(scenario).frame(sim.step(Inputs(disturbances=(push,))), 0)
    (arrow,) = shown.display.pushes
    assert arrow.force == pytest.approx((-30.0, -20.0, -10.0), abs=1e-6)
    mount = scenario.arm.model.mount
    structural = (np.array([1.0, 2.0, 3.0]) + mount.orbiter_origin) * [-1.0, 1.0, -1.0]
    assert arrow.point == pytest.approx(structural - np.array(scenario.worksite.origin), abs=1e-3)
