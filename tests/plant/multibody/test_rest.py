"""Rest: the true tip stays in its place after a push in any position of the rotary, and after any built-in script."""

from __future__ import annotations

import numpy as np
import pytest

from aftdeck.arrays import Array
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.motion.tip_rest import AT_REST, WINDOW, WINDOW_LOADED
from aftdeck.simulation.run import Simulation
from aftdeck.steering.mode import MODES
from tests.plant.multibody.flights import BAY, move, scenario
from tests.plant.multibody.test_plant import parts, push
from tests.scenario.missions import SCRIPTED, VERY_LONG

PERIOD = 0.02
PUSHED, WITHIN = 5.0, 120.0
"""Time of a push, and time in which the tip has to come to rest [s]."""
RAISED = "joints = ['0 deg', '30 deg', '-5 deg', '0 deg', '0 deg', '0 deg']"
"""Nearly straight arm, which swings longest."""
POUNDS = 32_000.0
STICKS = Inputs(translation=(1.0, -1.0, -1.0), rotation=(1.0, 1.0, -1.0))
LONGEST = {VERY_LONG, "concept-1972-script"}
"""Scripts whose tests take more than half a minute."""
FORCE = np.array([10.0, -20.0, 20.0])
"""Force on the wrist from outside [N]."""


def pushed(plant: str, mode: str, initial: str, pounds: float) -> Simulation:
    """Return a run after 5 s of full commands in a position; OPR CMD is stopped in its motion."""
    if MODES[mode].kind == "automatic":
        sim = Simulation(scenario(plant, move((1.2, 0.8, -0.9)), initial=BAY, pounds=pounds))
        while sim.look().sequence != "in progress":
            sim.advance()
        for _ in range(round(PUSHED / PERIOD)):
            sim.advance()
        sim.advance(Inputs(stop=True))
        return sim
    sim = Simulation(scenario(plant, initial=initial, pounds=pounds))
    command = Inputs(mode=mode, joint=1, drive=1.0) if MODES[mode].kind == "single" else None
    for _ in range(round(PUSHED / PERIOD)):
        sim.advance(command or Inputs(mode=mode, translation=STICKS.translation, rotation=STICKS.rotation))
    return sim


def idle(sim: Simulation, seconds: float) -> Array:
    """Continue a run without commands; return the true tip in each step [m]."""
    tips = []
    for _ in range(round(seconds / PERIOD)):
        sim.advance(Inputs())
        bodies = sim._state.plant.bodies
        assert bodies is not None
        tips.append(bodies.tip.place)
    return np.array(tips)


def comes_to_rest(sim: Simulation) -> bool:
    """Return whether the tip comes to rest in time: all its positions of a whole window are within 5 mm."""
    idle(sim, WITHIN)
    loaded = sim._state.carried.payload is not None
    return bool(np.linalg.norm(np.ptp(idle(sim, WINDOW_LOADED if loaded else WINDOW), axis=0)) < AT_REST)


POSITIONS = [
    pytest.param(mode, pounds, id=f"{mode}, {pounds:g} lb")
    for mode, position in MODES.items()
    for pounds in (0.0, POUNDS)
    if not position.prestored and (pounds or not position.loaded)
]
"""Every position of the rotary, and MASTER; AUTO 1-4 steer as OPR CMD does."""


@pytest.mark.slow
@pytest.mark.parametrize("initial", [RAISED, pytest.param(BAY, marks=pytest.mark.long)], ids=["raised", "bay"])
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize(("mode", "pounds"), POSITIONS)
def test_tip_rests_after_a_command_of_five_seconds(mode: str, pounds: float, plant: str, initial: str) -> None:
    sim = pushed(plant, mode, initial, pounds)
    assert comes_to_rest(sim)
    assert sim.look().rates_commanded == (0.0,) * 6


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize(("mode", "pounds"), POSITIONS)
def test_tip_rests_after_a_force_from_outside(mode: str, pounds: float, plant: str) -> None:
    sim = Simulation(scenario(plant, initial=RAISED, pounds=pounds))
    sim.advance(Inputs(mode=mode))
    push(sim, FORCE)
    moved = idle(sim, PUSHED)
    push(sim, np.zeros(3))
    assert np.ptp(moved, axis=0).max() > 1e-3
    assert comes_to_rest(sim)


@pytest.mark.slow
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.long) if name in LONGEST else name for name in SCRIPTED]
)
def test_tip_rests_after_every_script(name: str, plant: str) -> None:
    given = load_scenario(name)
    if plant == "flexible" and given.arm.model.flexibility is None:
        return
    sim = Simulation(load_scenario(name, {("plant",): plant}))
    while not sim.ended:
        sim.advance()
    assert comes_to_rest(sim)


@pytest.mark.parametrize("mode", ["SINGLE", "MASTER"])
@pytest.mark.parametrize("plant", ["rigid", "flexible"])
def test_joints_return_to_the_angles_that_their_mode_holds(plant: str, mode: str) -> None:
    sim = Simulation(scenario(plant))
    sim.advance(Inputs(mode=mode))
    held = sim._state.plant.angles.copy()
    push(sim, np.array([0.0, 80.0, 80.0]))
    idle(sim, 2.0)
    assert np.abs(sim._state.plant.angles - held).max() > 1e-3
    push(sim, np.zeros(3))
    idle(sim, 40.0)
    servo = sim.scenario.arm.model.servo
    assert servo is not None
    sticks = servo.friction / (servo.gain * servo.hold_gain)  # closer to its angle, a motor does not overcome friction
    assert (np.abs(sim._state.plant.angles - held) <= 1.05 * sticks + 3.0 * servo.encoder_step).all()
    assert parts(sim)[2].holds == pytest.approx(held, abs=1e-4)
    assert sim.look().rates_commanded == (0.0,) * 6
