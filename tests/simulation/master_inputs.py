"""Random inputs in MASTER that TABLE I can express."""

from __future__ import annotations

from collections.abc import Iterator

import msgspec
import numpy as np

from aftdeck import Inputs
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.camera_drives import CameraDrive

STATIONS = "ABCDEFGH"


def random_master_inputs(rng: np.random.Generator, scenario: Scenario, steps: int) -> Iterator[Inputs]:
    """Yield random inputs in MASTER, with every input of TABLE I. A switch is sent only in the step that sets it."""
    angles = scenario.initial_angles.copy()
    parts = [part for part in scenario.parts if part != "manoeuvring"] or ["full problem"]
    yield Inputs(mode="MASTER")
    for k in range(1, steps):
        given: dict[str, object] = {}
        if rng.random() < 0.3:
            angles = angles + rng.uniform(-0.03, 0.03, 6)
            given["master"] = tuple(angles.tolist())
        if k % 9 == 0:
            telescope = float(rng.choice([-1.0, 0.0, 1.0]))
            switch = str(rng.choice(["stop", "close", "open"]))
            motion = [0.0, 0.0]
            motion[rng.integers(2)] = float(rng.choice([-1.0, 0.0, 1.0]))
            zoom = float(rng.choice([-1.0, 0.0, 1.0]))
            camera = CameraDrive(str(rng.choice(list(STATIONS))), motion[0], motion[1], zoom)
        if k >= 9:
            given |= {"telescope": telescope, "effector": switch if k % 9 == 0 else None}
            given |= {"camera": camera if rng.random() < 0.8 else None}
        if rng.random() < 0.01:
            given |= {"initialise": str(rng.choice(parts)), "mode": "MASTER"}
        yield msgspec.structs.replace(Inputs(), **given)
