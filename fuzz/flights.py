"""Attack on runs: what the loaders accept starts and flies, and every number of every frame is finite."""

from __future__ import annotations

import math
import random
import tempfile
from pathlib import Path

import msgspec

from aftdeck.arms.load import HERE as ARMS
from aftdeck.errors import ScenarioError, SimulationError
from aftdeck.files import Where
from aftdeck.scenario.build import BUILT_IN as SCENARIOS
from aftdeck.scenario.load import load_scenario, parse_scenario
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from fuzz.files import load_worksite, originals, text_of, written
from fuzz.mutants import mild_mutant

STEPS = 50
"""Number of control steps of each run."""
TRIES = 60
"""Greatest number of mutants that are tried for an accepted one."""
FLOWN_WITH = {
    "srms": ("first-flight", "srms-deploy", "uncradle"),
    "concept-1972": ("concept-1972", "concept-1972-script"),
    "orbiter": ("first-flight", "srms-berth"),
    "space": ("free-flyer",),
}
"""Scenarios with which the mutants of an arm or of a worksite are flown."""
PLANTS = ("kinematic", "kinematic", "rigid", "flexible")
KINDS = ("arm", "worksite", "scenario")
MODES = ("ORB UNL", "END EFF", "ORB LD", "SINGLE", "DIRECT", "MASTER", "TEST", "OPR CMD")


def attack(seed: int) -> str:
    """Fly an accepted mutant for `STEPS` steps; return the kind of its file and the source of the inputs.

    Raises:
        Exception: the run raised an error.
        AssertionError: a number of a frame is not finite.
    """
    rng = random.Random(seed)
    for _ in range(TRIES):
        kind = rng.choice(KINDS)
        original = rng.choice([original for original in originals() if original.kind == kind])
        plant = rng.choice(PLANTS)
        text = mild_mutant(text_of(original.path), rng)
        try:
            sim = Simulation(_scenario(kind, original.path.stem, text, plant, rng))
        except ScenarioError:
            continue
        scripted = bool(sim.scenario.phases) and rng.random() < 0.5
        how = f"{kind}, {sim.scenario.plant}, by {'script' if scripted else 'hand'}"
        try:
            fly(sim, None if scripted else rng)
        except SimulationError:
            if sim.scenario.plant == "kinematic":
                raise
            return f"{how}: diverged"
        return how
    return "none accepted"


def _scenario(kind: str, name: str, text: str, plant: str, rng: random.Random) -> Scenario:
    """Return the scenario in which a mutant is flown, on a plant."""
    changes: dict[Where, object] = {} if plant == "kinematic" else {("plant",): plant}
    if kind == "scenario":
        return parse_scenario(text, "mutant", "mutant.toml", SCENARIOS, changes)
    with tempfile.TemporaryDirectory() as folder:
        path = written(Path(folder) / "mutant.toml", text)
        if kind == "worksite":
            load_worksite(text)
        for shapes in ARMS.glob("*.shapes.toml"):
            written(Path(folder) / shapes.name, text_of(shapes))
        own = load_scenario(rng.choice(FLOWN_WITH[name]))
        return parse_scenario(own.text, "mutant", "mutant.toml", SCENARIOS, {**changes, (kind,): str(path)})


def fly(sim: Simulation, rng: random.Random | None) -> None:
    """Advance a run by `STEPS` steps, with its script or with random inputs, and assert that all numbers are finite.

    Args:
        sim: the run.
        rng: source of random inputs; None for the script.
    """
    for tick in range(STEPS):
        if sim.ended:
            break
        frame = sim.step(None if rng is None else _inputs(rng, first=tick == 0))
        wrong = not_finite(msgspec.to_builtins(frame))
        assert not wrong, f"step {tick}: {wrong}"
    if rng is not None:
        sim.ahead()


def _inputs(rng: random.Random, *, first: bool) -> Inputs:
    """Return random inputs; a mode is selected in the first step and seldom after it."""
    x, y, z, roll, pitch, yaw, drive, telescope = (rng.uniform(-1.0, 1.0) for _ in range(8))
    return Inputs(
        translation=(x, y, z),
        rotation=(roll, pitch, yaw),
        drive=drive,
        telescope=telescope,
        mode=rng.choice(MODES) if first or rng.random() < 0.05 else None,
        joint=rng.randrange(6) if first else None,
        effector=rng.choice(("close", "open")) if rng.random() < 0.1 else None,
        latch=rng.choice(("latch", "unlatch")) if rng.random() < 0.1 else None,
        brakes=rng.random() < 0.5 if rng.random() < 0.05 else None,
        safing=rng.random() < 0.5 if rng.random() < 0.05 else None,
        orbiter=(x, y, z),
    )


def not_finite(value: object, where: str = "frame") -> str:
    """Return the place of the first number that is not finite; "" if all are finite."""
    if isinstance(value, float):
        return "" if math.isfinite(value) else f"{where} is {value}"
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list | tuple) else ()
    return next(filter(None, (not_finite(item, f"{where}.{key}") for key, item in items)), "")
