"""Benchmark of plants with masses: control steps with frame, and with a recording, beside bare steps of MuJoCo."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path
from typing import cast

import mujoco

from aftdeck.plant.multibody.plant import MultibodyPlant
from aftdeck.plant.multibody.view import View
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.payloads.surroundings import surroundings
from aftdeck.simulation.run import Simulation
from benchmarks.measure import Figure

NAME = "loaded"
"""Scenario: 32,000 lb over the bay; the orbiter is free."""
BAY, AT_LATCHES = "srms-berth", 150.0
"""Scenario whose payload is between the guides of the bay's latches at this time [s]."""
STEPS, WARM, REPEATS = 1500, 100, 5
STICKS = Inputs(translation=(0.3, 0.2, -0.4), rotation=(0.1, 0.0, 0.2))
TIMES_REAL = {"rigid": 90.0, "flexible": 50.0}
"""Promised speeds in free space, as multiples of real time."""
TIMES_AT_LATCHES = {"rigid": 40.0, "flexible": 30.0}
"""Promised speeds over the bay and in contact: mean over the whole berthing."""
MORE = 1.3
"""Promised ratio of a recorded step to the sum of MuJoCo's bare steps and the recorded kinematic step."""


def dynamics() -> list[Figure]:
    """Measure the mean control step on each plant, on one core."""
    framed, recorded, _ = _flown("kinematic")
    figures = [
        Figure("kinematic, step with frame", framed, "us", None, NAME),
        Figure("kinematic, recorded step", recorded, "us", None, "until its record is in the file"),
    ]
    for plant, times in TIMES_REAL.items():
        step, whole, sim = _flown(plant)
        bare = _bare(sim, cast(MultibodyPlant, sim._flight.plant)._apart[sim._state.script.attached].view)
        period = sim.scenario.control_period * 1e6
        note = f"{period / step:.0f} times real time; promised {times:g}"
        figures += [
            Figure(f"{plant}, step with frame", step, "us", period / times, note),
            Figure(f"{plant}, recorded step", whole, "us", None, f"{period / whole:.0f} times real time"),
            Figure(f"{plant}, bare MuJoCo", bare, "us", None, "mj_step of the same model for one control period"),
            Figure(f"{plant}, ratio", whole / (bare + recorded), "1", MORE, "recorded / (bare + recorded kinematic)"),
        ]
    for plant, times in TIMES_AT_LATCHES.items():
        step = _berthing(plant)
        note = f"{period / step:.0f} times real time; promised {times:g}: {BAY}, from its start to its end"
        figures.append(Figure(f"{plant}, step with frame of a berthing", step, "us", period / times, note))
        step, bare, pairs = _at_latches(plant)
        note = f"{period / step:.0f} times real time; bare MuJoCo takes {bare:.0f} us; {pairs} pairs of solids near"
        figures.append(Figure(f"{plant}, step with frame pressed into the guides", step, "us", None, note))
    return figures


def _berthing(plant: str) -> float:
    """Return the mean time of a step with its frame in a whole berthing [us]."""
    sim = Simulation(load_scenario(BAY, {("plant",): plant}))
    sim.step()
    start, steps = time.perf_counter(), 0
    while not sim.ended:
        sim.step()
        steps += 1
    return (time.perf_counter() - start) / steps * 1e6


def _at_latches(plant: str) -> tuple[float, float, int]:
    """Return the mean time of a step with its frame [us] while a payload is pressed sideways into its guides.

    The second value is the time of MuJoCo's steps alone [us], the third the number of pairs of solids near each other.
    """
    sim = Simulation(load_scenario(BAY, {("plant",): plant}))
    while sim.look().time_s < AT_LATCHES:
        sim.advance()
    down = Inputs(mode="ORB LD", translation=(0.2, 0.1, 1.0))
    for _ in range(STEPS):
        sim.step(down)
    start = time.perf_counter()
    for _ in range(STEPS):
        sim.step(down)
    mean = (time.perf_counter() - start) / STEPS * 1e6
    model = cast(MultibodyPlant, sim._flight.plant)._near[0]
    return mean, _bare(sim, model.view, repeats=1), len(surroundings(sim._flight, sim._state, down).near)


def _flown(plant: str) -> tuple[float, float, Simulation]:
    """Return the mean time of a step with its frame, and recorded [us], each best of `REPEATS`, and a simulation.

    The time of recorded steps ends when all are in the file.
    """
    framed = recorded = float("inf")
    for _ in range(REPEATS):
        sim = Simulation(load_scenario(NAME, {("plant",): plant}))
        for _ in range(WARM):
            sim.step(STICKS)
        start = time.perf_counter()
        for _ in range(STEPS):
            sim.step(STICKS)
        framed = min(framed, (time.perf_counter() - start) / STEPS * 1e6)
        sim = Simulation(load_scenario(NAME, {("plant",): plant}))
        for _ in range(WARM):
            sim.step(STICKS)
        with tempfile.TemporaryDirectory() as folder:
            recorder = Recorder(Path(folder) / "flight.mcap", sim.scenario, 0)
            start = time.perf_counter()
            for _ in range(STEPS):
                recorder.step(STICKS, sim.step(STICKS))
                recorder.take_turns()
            recorder.close("stopped")
            recorded = min(recorded, (time.perf_counter() - start) / STEPS * 1e6)
    return framed, recorded, sim


def _bare(sim: Simulation, view: View, repeats: int = REPEATS) -> float:
    """Return the time of MuJoCo's steps of one control period [us], best of `repeats`."""
    plant, state, best = cast(MultibodyPlant, sim._flight.plant), sim._state, float("inf")
    assert state.plant.bodies is not None
    for _ in range(repeats):
        mujoco.mj_setState(view.model, view.data, state.plant.bodies.physics, mujoco.mjtState.mjSTATE_INTEGRATION)
        start = time.perf_counter()
        for _ in range(STEPS):
            mujoco.mj_step(view.model, view.data, nstep=plant._steps)
        best = min(best, (time.perf_counter() - start) / STEPS * 1e6)
    return best
