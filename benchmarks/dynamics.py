"""Benchmark of plants with masses: whole control steps with frame and recording, beside bare steps of MuJoCo."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path
from typing import cast

import mujoco

from aftdeck.plant.multibody.plant import MultibodyPlant
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from benchmarks.measure import Figure

NAME = "loaded"
"""Scenario: 32,000 lb over the bay; the orbiter is free."""
STEPS, WARM, REPEATS = 1500, 100, 5
STICKS = Inputs(translation=(0.3, 0.2, -0.4), rotation=(0.1, 0.0, 0.2))
TIMES_REAL = {"rigid": 90.0, "flexible": 50.0}
"""Promised speeds, as multiples of real time."""
MORE = 1.3
"""Promised ratio of a whole step to the sum of MuJoCo's bare steps and the kinematic step."""


def dynamics() -> list[Figure]:
    """Measure the mean control step on each plant, on one core."""
    kinematic, _ = _flown("kinematic")
    figures = [Figure("kinematic, whole step", kinematic, "us", None, f"{NAME}, with frame and recording")]
    for plant, times in TIMES_REAL.items():
        whole, sim = _flown(plant)
        bare = _bare(sim)
        period = sim.scenario.control_period * 1e6
        note = f"{period / whole:.0f} times real time; promised {times:g}"
        figures += [
            Figure(f"{plant}, whole step", whole, "us", period / times, note),
            Figure(f"{plant}, bare MuJoCo", bare, "us", None, "mj_step of the same model for one control period"),
            Figure(f"{plant}, ratio", whole / (bare + kinematic), "1", MORE, "whole / (bare + kinematic)"),
        ]
    return figures


def _flown(plant: str) -> tuple[float, Simulation]:
    """Return the mean time of a step with frame and recording [us], best of `REPEATS`, and the simulation."""
    best = float("inf")
    for _ in range(REPEATS):
        sim = Simulation(load_scenario(NAME, {("plant",): plant}))
        with tempfile.TemporaryDirectory() as folder:
            recorder = Recorder(Path(folder) / "flight.mcap", sim.scenario, 0)
            for step in range(WARM + STEPS):
                if step == WARM:
                    start = time.perf_counter()
                recorder.step(STICKS, sim.step(STICKS))
            took = time.perf_counter() - start
            recorder.close("stopped")
        best = min(best, took / STEPS * 1e6)
    return best, sim


def _bare(sim: Simulation) -> float:
    """Return the time of MuJoCo's steps of one control period [us], best of `REPEATS`."""
    plant, state = cast(MultibodyPlant, sim._flight.plant), sim._state
    view, best = plant._views[state.script.attached], float("inf")
    assert state.plant.bodies is not None
    for _ in range(REPEATS):
        mujoco.mj_setState(view.model, view.data, state.plant.bodies.physics, mujoco.mjtState.mjSTATE_INTEGRATION)
        start = time.perf_counter()
        for _ in range(STEPS):
            mujoco.mj_step(view.model, view.data, nstep=plant._steps)
        best = min(best, (time.perf_counter() - start) / STEPS * 1e6)
    return best
