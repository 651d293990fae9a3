"""Copies of simulations and environments go on as the originals do, to the last bit."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from typing import Any

import gymnasium
import msgspec
import numpy as np
import pytest

import aftdeck
from aftdeck.law_cache import only_kept
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation

WAYS: dict[str, Callable[[Any], Any]] = {
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
    "pickle": lambda one: pickle.loads(pickle.dumps(one)),
}
ENVIRONMENTS = ("Reach", "Capture", "Extract", "Dock")


def flown(rng: np.random.Generator) -> Inputs | None:
    """Return random sticks, or None for the script."""
    sticks = rng.uniform(-1.0, 1.0, 6).tolist()
    return Inputs(translation=tuple(sticks[:3]), rotation=tuple(sticks[3:])) if rng.random() < 0.8 else None


@pytest.mark.parametrize("way", ["deepcopy", "pickle"])
@pytest.mark.parametrize(
    ("name", "plant"),
    [
        ("srms-berth", "kinematic"),
        ("srms-berth", "rigid"),
        ("sequence", "flexible"),
        ("concept-1972", "kinematic"),
        ("concept-1972", "rigid"),
    ],
)
def test_a_copied_simulation_goes_on_as_the_original(name: str, plant: str, way: str) -> None:
    changes = {"plant": plant, "command_delay": "0.1 s"}
    original, rng = Simulation(aftdeck.load_scenario(name, changes)), np.random.default_rng(5)
    for steps in (0, 1, 30):
        for _ in range(steps):
            original.advance(flown(rng))
        copied = WAYS[way](original)
        assert isinstance(copied, Simulation)
        assert (copied.frame, copied.given, copied.flown, copied.ended, copied.seed, copied.seal()) == (
            (original.frame, original.given, original.flown, original.ended, original.seed, original.seal())
        )
        for _ in range(10):
            inputs = flown(rng)
            with only_kept():  # no law is compiled again for the copy's arrays
                frame = copied.step(inputs)
            assert msgspec.structs.asdict(frame) == msgspec.structs.asdict(original.step(inputs))
    stays = original.seal()
    copied.step(Inputs(translation=(1.0, 0.0, 0.0)))
    assert original.seal() == stays != copied.seal()


class Named(Simulation):
    """Simulation of a user's own."""

    def __init__(self, name: str) -> None:
        super().__init__("uncradle")
        self.name = name


@pytest.mark.parametrize("way", WAYS)
def test_a_copy_has_the_class_and_the_fields_of_the_original(way: str) -> None:
    copied = WAYS[way](Named("mine"))
    assert type(copied) is Named and copied.name == "mine"


def _equal(a: object, b: object) -> bool:
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(_equal(a[key], b[key]) for key in a)
    return np.array_equal(a, b) if isinstance(a, np.ndarray) and isinstance(b, np.ndarray) else a == b


@pytest.mark.parametrize("way", ["deepcopy", "pickle"])
@pytest.mark.parametrize("plant", ["kinematic", "rigid"])
@pytest.mark.parametrize("name", ENVIRONMENTS)
def test_a_copied_environment_goes_on_as_the_original(name: str, plant: str, way: str) -> None:
    original: gymnasium.Env[object, object] = gymnasium.make(f"aftdeck.gym:aftdeck/{name}-v0", plant=plant)
    original.reset(seed=1)
    original.action_space.seed(1)
    for _ in range(5):
        original.step(original.action_space.sample())
    copied = WAYS[way](original)
    assert isinstance(copied, gymnasium.Env)
    for _ in range(10):
        action = original.action_space.sample()
        pairs = zip(copied.step(action), original.step(action), strict=True)
        assert all(_equal(a, b) for a, b in pairs)
