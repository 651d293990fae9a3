"""Data for SPEC 94 agree with the steering and the sequences."""

from __future__ import annotations

import numpy as np
import pytest

from aftdeck.frames import Pose
from aftdeck.scenario.load import built_in
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.conversion.frame_of import Displays
from aftdeck.station.conversion.welcome_of import welcome_of
from aftdeck.station.core.commands import inputs_of
from aftdeck.station.core.page_inputs import CENTRED
from aftdeck.station.messages import from_page
from tests.loaded import scenario
from tests.steering.flying import BAY, PAYLOAD
from tests.steering.flying import scenario as scenario_of_text

RATES = ("coarse", "vernier")
LOADED = "srms-berth"


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize("name", [LOADED, "loaded", "first-flight", "concept-1972"])
def test_limits_of_the_table_are_those_of_the_steering(name: str, rate: str) -> None:
    sim = Simulation(scenario(name))
    displays, payloads = Displays(sim.scenario), welcome_of(sim.scenario, demo=False).payloads
    setting = RATES.index(rate)
    for mode in ("ORB UNL", "SINGLE"):
        frame = sim.step(Inputs(mode=mode, rate=rate))  # type: ignore[arg-type]
        shown = displays.frame(frame, 0)
        row = payloads[shown.display.payload_id]
        assert shown.por_limits == (row.translation[setting], row.rotation[setting])
        if mode == "SINGLE":
            assert shown.rate_limits == (row.coarse, row.vernier)[setting]


@pytest.mark.parametrize(("name", "held"), [(LOADED, 1), ("loaded", 1), ("first-flight", 0), ("srms-deploy", 0)])
def test_payload_id_is_that_of_the_captured_payload(name: str, held: int) -> None:
    sim = Simulation(scenario(name))
    displays = Displays(sim.scenario)
    assert displays.frame(sim.step(Inputs()), 0).display.payload_id == held
    table = welcome_of(sim.scenario, demo=False).payloads
    assert [row.id for row in table] == list(range(len(table)))
    assert table[0].mass == 0.0 and all(row.mass > 0.0 for row in table[1:])


def test_payload_attached_by_a_phase_has_id_row_and_por() -> None:
    heavy, light = (PAYLOAD.replace("[payload]", "[phase.payload]").format(mass=f"{m} lb") for m in (32000, 1000))
    still = '[[phase]]\nmode = "ORB UNL"\nduration = 0.08\n'
    made = scenario_of_text(BAY, f"control_period = 0.08\n{still}{still}{heavy}{still}{light}{still}detached = true\n")
    sim, displays = Simulation(made), Displays(made)
    frames = [sim.step() for _ in range(4)]
    shown = [displays.frame(frame, 0) for frame in frames]
    assert [frame.display.payload_id for frame in shown] == [0, 1, 2, 0]
    table = [row.mass * 2.2046226218 for row in welcome_of(made, demo=False).payloads]
    assert table == pytest.approx([0.0, 32000.0, 1000.0])
    for frame, page in zip(frames[1:3], shown[1:3], strict=True):
        assert frame.payload is not None
        centre, axes = map(np.array, frame.payload)
        hand = made.arm.end_effector(np.array(frame.orientation))
        point = frame.position + hand @ np.array(page.display.por_offset)
        assert axes.T @ (point - centre) == pytest.approx([0.3, -0.4, 0.1], abs=1e-9)
    assert [page.display.por_offset == (0.0, 0.0, 0.0) for page in shown] == [True, False, False, True]


@pytest.mark.parametrize("name", [LOADED, "loaded"])
def test_por_offset_is_the_vector_to_the_point_that_orb_ld_moves(name: str) -> None:
    sim = Simulation(scenario(name))
    arm = sim.scenario.arm
    for _ in range(20):
        frame = sim.step(Inputs(mode="ORB LD", rotation=(0.5, -0.3, 1.0)))
    shown = Displays(sim.scenario).frame(frame, 0)
    tip = Pose(np.array(frame.position), np.array(frame.orientation))
    hand = arm.model.mount.to("panel", Pose(tip.position, arm.end_effector(tip.rotation)))
    point = hand.position + hand.rotation @ np.array(shown.display.por_offset)
    assert point == pytest.approx(shown.display.actual.position, abs=1e-9)


@pytest.mark.parametrize("name", built_in())
def test_stored_point_keyed_in_is_the_pose_of_the_sequence(name: str) -> None:
    loaded = scenario(name)
    stored = {sequence.position: sequence.points for sequence in welcome_of(loaded, demo=False).sequences}
    assert set(stored) == set(loaded.sequences)
    for position, points in loaded.sequences.items():
        for shown, point in zip(stored[position], points, strict=True):
            message = from_page.SetTarget(0, shown.position, shown.attitude)
            target = inputs_of(CENTRED, message, loaded.arm).target
            assert target is not None
            pose = target.pose
            assert pose.position == pytest.approx(point.target.pose.position, abs=1e-9)
            assert pose.rotation == pytest.approx(point.target.pose.rotation, abs=1e-9)
            assert shown.pause == point.pause


def test_singularity_threshold_is_that_of_the_arm() -> None:
    loaded = scenario("first-flight")
    assert welcome_of(loaded, demo=False).singular == loaded.arm.model.singular
