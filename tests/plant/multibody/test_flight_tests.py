"""Built-in flight tests, and the script's inputs that they need: brakes, safing, and waiting for rest."""

from __future__ import annotations

import math

import numpy as np
import pytest

from aftdeck.errors import ScenarioError
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.motion.tip_rest import AT_REST
from aftdeck.simulation.run import Simulation
from aftdeck.units import FOOT
from benchmarks.flight_tests import TESTS, stops
from tests.plant.multibody.flights import flown, scenario
from tests.scenario.missions import but_very_long

STEP = "[[phase]]\nmode = 'ORB UNL'\ntranslation = [0.5, 0.0, -0.5]\nduration = '3 s'\n"
WAIT = "[[phase]]\nmode = 'ORB UNL'\nuntil = 'at rest'\nduration = '100 s'\n"


def test_script_operates_brakes_and_safing() -> None:
    body = STEP + "".join(
        f"[[phase]]\nmode = 'ORB UNL'\n{switch} = {on}\nduration = '1 s'\n"
        for switch in ("brakes", "safing")
        for on in ("true", "false")
    )
    sim, seen = Simulation(scenario("rigid", body)), []
    while not sim.ended:
        frame = sim.step()
        seen.append((frame.brakes, frame.safing))
    assert sim.ended == "completed"
    assert {(True, False), (False, True)} < set(seen)
    assert seen[-1] == (False, False)


@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_script_waits_until_the_tip_stays_in_its_place(plant: str) -> None:
    after = "[[phase]]\nmode = 'ORB UNL'\nduration = '20 s'\n"
    sim, tips = flown(scenario(plant, STEP + WAIT + after))
    assert sim.ended == "completed"
    waited = len(tips) - 1000
    assert waited > 350
    assert math.dist(tips[waited], tips[149]) > 0.05
    assert np.linalg.norm(tips[waited - 200 :] - tips[waited], axis=1).max() < 1.1 * AT_REST


def test_kinematic_arm_is_at_rest_one_step_after_the_command() -> None:
    sim, tips = flown(scenario("kinematic", STEP.replace("'3 s'", "'5 s'") + WAIT))
    assert sim.ended == "completed"
    assert len(tips) < 260


def test_waiting_for_rest_that_does_not_come_is_a_fault() -> None:
    sim, _ = flown(scenario("rigid", STEP + WAIT.replace("'100 s'", "'2 s'")))
    assert sim.ended == "fault"


def test_waiting_for_rest_is_rejected_in_a_mode_without_sticks() -> None:
    with pytest.raises(ScenarioError, match="'at rest' is for a manual mode"):
        scenario("rigid", WAIT.replace("ORB UNL", "TEST"))


@pytest.mark.slow
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize("name", but_very_long(TESTS))
def test_flight_test_measures_each_stop_once_from_comparable_speeds(name: str, plant: str) -> None:
    found, steps = stops(name, plant), 2 if "loaded" in name else 1
    assert len({step for step, _ in found}) == len(found) == 9 * steps
    assert load_scenario(name).plant == "rigid"
    for n in range(0, len(found), 3):  # a step stopped by brakes, by the command and by safing
        speeds = [stop.speed for _, stop in found[n : n + 3]]
        assert max(speeds) < 1.05 * min(speeds)
        permitted = 0.115 * FOOT if steps == 2 else 2.0 * FOOT
        fastest = "long step" in found[n][0] or steps == 1
        assert not fastest or min(speeds) > (0.95 if steps == 2 else 0.4) * permitted


@pytest.mark.slow
def test_each_step_of_a_flight_test_begins_at_rest() -> None:
    sim, tips, starts = Simulation(load_scenario("flight-test", {("plant",): "flexible"})), [], []
    while not sim.ended:
        sim.advance()
        state = sim._state
        assert state.plant.bodies is not None
        tips.append(state.plant.bodies.tip.place)
        starts += [state.tick for event in state.events if event.kind == "phase" and "stopped by" in event.text]
    assert sim.ended == "completed"
    assert len(starts) == 9
    for start in starts:
        before = np.array(tips[start - 201 : start - 1])
        assert np.linalg.norm(np.ptp(before, axis=0)) < 1.1 * AT_REST
