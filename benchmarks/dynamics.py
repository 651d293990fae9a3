"""Benchmark of plants with masses: control steps with frame, and with a recording, beside bare steps of MuJoCo.

All times are those of the processor, so that other work of the machine does not count.
"""

from __future__ import annotations

import tempfile
import time
from pathlib import Path
from typing import NamedTuple, cast

import mujoco

from aftdeck.plant.multibody.plant import MultibodyPlant
from aftdeck.plant.multibody.view import View
from aftdeck.recording.writer import Recorder
from aftdeck.scenario.load import load_scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.payloads.surroundings import surroundings
from aftdeck.simulation.run import Simulation
from benchmarks.measure import Figure, against

NAME = "loaded"
"""Scenario: 32,000 lb over the bay; the orbiter is free."""
BAY = "srms-berth"
"""Scenario that lowers a payload into the guides of the bay's latches."""
STICKS = Inputs(translation=(0.3, 0.2, -0.4), rotation=(0.1, 0.0, 0.2))
PERIOD = 20_000.0
"""Control period of both scenarios [us]."""
PLANTS = ("rigid", "flexible")
FRAMED, RECORDED = 1.9, 1.6
"""Promised step with its frame, and recorded step, as shares of the sum of MuJoCo's bare steps and the same step of the
kinematic plant."""
BERTHING = 2.7
"""Promised step with its frame in a whole berthing, as a share of the sum of MuJoCo's bare steps in free space and the
kinematic step in the same berthing; the contacts come in addition."""


class Size(NamedTuple):
    """Extent of the measurement.

    Attributes:
        steps: number of steps whose mean is taken.
        warm: number of steps before.
        repeats: number of runs; the shortest mean counts.
        berthing: greatest number of steps of the berthing.
        at_latches: time at which the payload is between the guides [s].
    """

    steps: int
    warm: int
    repeats: int
    berthing: int
    at_latches: float


FULL, TINY = Size(1500, 100, 5, 1_000_000, 150.0), Size(10, 2, 1, 20, 0.1)


class Means(NamedTuple):
    """Mean times in free space [us].

    Attributes:
        framed: step with its frame.
        recorded: step with its record in the file.
        bare: MuJoCo's steps of one control period; 0 on the kinematic plant.
    """

    framed: float
    recorded: float
    bare: float


def dynamics(size: Size) -> list[Figure]:
    """Measure the mean control step on each plant, on one core."""
    plants = ("kinematic", *PLANTS)
    rounds = [[_means(plant, size) for plant in plants] for _ in range(size.repeats)]  # all plants in turn
    best = {plant: Means(*map(min, zip(*made, strict=True))) for plant, *made in zip(plants, *rounds, strict=True)}
    framed, recorded, _ = best["kinematic"]
    berthing = _berthing("kinematic", size)
    figures = [
        Figure("kinematic, step with frame", framed, "us", None, NAME),
        Figure("kinematic, recorded step", recorded, "us", None, "until its record is in the file"),
        Figure("kinematic, step with frame of a berthing", berthing, "us", None, BAY),
    ]
    for plant in PLANTS:
        step, whole, bare = best[plant]
        docked = _berthing(plant, size)
        sums = (
            Figure(f"{plant}, MuJoCo + kinematic step", bare + framed, "us"),
            Figure(f"{plant}, MuJoCo + kinematic recorded step", bare + recorded, "us"),
            Figure(f"{plant}, MuJoCo + kinematic step of a berthing", bare + berthing, "us"),
        )
        figures += [
            Figure(f"{plant}, bare MuJoCo", bare, "us", None, "mj_step of the same model for one control period"),
            *sums,
            against(sums[0], FRAMED, f"{plant}, step with frame", step, "us", _times_real(step)),
            against(sums[1], RECORDED, f"{plant}, recorded step", whole, "us", _times_real(whole)),
            against(
                sums[2],
                BERTHING,
                f"{plant}, step with frame of a berthing",
                docked,
                "us",
                f"{_times_real(docked)}: {BAY}, from its start to its end",
            ),
        ]
        step, bare, pairs = _at_latches(plant, size)
        note = f"{_times_real(step)}; bare MuJoCo takes {bare:.0f} µs; {pairs} pairs of solids near"
        figures.append(Figure(f"{plant}, step with frame pressed into the guides", step, "us", None, note))
    return figures


def _times_real(step: float) -> str:
    return f"{PERIOD / step:.0f} times real time"


def _berthing(plant: str, size: Size) -> float:
    """Return the mean time of a step with its frame in a whole berthing [us]."""
    sim = Simulation(load_scenario(BAY, {("plant",): plant}))
    sim.step()
    start, steps = time.process_time(), 0
    while not sim.ended and steps < size.berthing:
        sim.step()
        steps += 1
    return (time.process_time() - start) / steps * 1e6


def _at_latches(plant: str, size: Size) -> tuple[float, float, int]:
    """Return the mean time of a step with its frame [us] while a payload is pressed sideways into its guides.

    The second value is the time of MuJoCo's steps alone [us], the third the number of pairs of solids near each other.
    """
    sim = Simulation(load_scenario(BAY, {("plant",): plant}))
    while sim.look().time_s < size.at_latches:
        sim.advance()
    down = Inputs(mode="ORB LD", translation=(0.2, 0.1, 1.0))
    for _ in range(size.steps):
        sim.step(down)
    start = time.process_time()
    for _ in range(size.steps):
        sim.step(down)
    mean = (time.process_time() - start) / size.steps * 1e6
    model = cast(MultibodyPlant, sim._flight.plant)._near[0]
    return mean, _bare(sim, model.view, size), len(surroundings(sim._flight, sim._state, down).near)


def _means(plant: str, size: Size) -> Means:
    """Measure the steps of a plant once. The time of recorded steps ends when all are in the file."""
    sim = _warm(plant, size)
    start = time.process_time()
    for _ in range(size.steps):
        sim.step(STICKS)
    framed = (time.process_time() - start) / size.steps * 1e6
    moved = cast(MultibodyPlant, sim._flight.plant)
    bare = 0.0 if plant == "kinematic" else _bare(sim, moved._apart[sim._state.script.attached].view, size)
    sim = _warm(plant, size)
    with tempfile.TemporaryDirectory() as folder:
        recorder = Recorder(Path(folder) / "flight.mcap", sim.scenario, 0)
        start = time.process_time()
        for _ in range(size.steps):
            recorder.step(STICKS, sim.step(STICKS))
            recorder.take_turns()
        recorder.close("stopped")
        recorded = (time.process_time() - start) / size.steps * 1e6
    return Means(framed, recorded, bare)


def _warm(plant: str, size: Size) -> Simulation:
    """Return a simulation after its first steps."""
    sim = Simulation(load_scenario(NAME, {("plant",): plant}))
    for _ in range(size.warm):
        sim.step(STICKS)
    return sim


def _bare(sim: Simulation, view: View, size: Size) -> float:
    """Return the mean time of MuJoCo's steps of one control period [us]."""
    plant, state = cast(MultibodyPlant, sim._flight.plant), sim._state
    assert state.plant.bodies is not None
    mujoco.mj_setState(view.model, view.data, state.plant.bodies.physics, mujoco.mjtState.mjSTATE_INTEGRATION)
    start = time.process_time()
    for _ in range(size.steps):
        mujoco.mj_step(view.model, view.data, nstep=plant._steps)
    return (time.process_time() - start) / size.steps * 1e6
