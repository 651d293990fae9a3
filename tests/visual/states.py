"""States of runs for tests of pictures: frames of scripted runs and of runs with random sticks, with random cameras."""

from __future__ import annotations

from collections.abc import Iterator

import msgspec
import numpy as np

from aftdeck.bodies.cameras import Setting, Travel
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation


def states(scenario: Scenario, count: int, rng: np.random.Generator) -> Iterator[Frame]:
    """Yield frames of a run of the scenario's script, at random times; the cameras have random settings.

    Between two of these frames the sticks are deflected at random for some seconds, so that the poses differ from those
    of the script; then the script's state is restored.
    """
    simulation, tick, left = Simulation(scenario), 0, count
    at = np.sort(rng.choice(_steps(scenario), (count + 1) // 2, replace=False))
    for due in at.tolist():
        while tick < due:
            simulation.advance()
            tick += 1
        yield _aimed(scenario, simulation.look(), rng)
        left -= 1
        if left == 0:
            return
        saved = simulation.save()
        sticks = rng.uniform(-1.0, 1.0, 6).tolist()
        inputs = Inputs(translation=tuple(sticks[:3]), rotation=tuple(sticks[3:]))
        for _ in range(int(rng.integers(20, 400))):
            simulation.advance(inputs)
        yield _aimed(scenario, simulation.look(), rng)
        left -= 1
        simulation.restore(saved)


def _steps(scenario: Scenario) -> int:
    """Return the number of steps of a scenario's script."""
    simulation, steps = Simulation(scenario), 0
    while not simulation.ended:
        simulation.advance()
        steps += 1
    return steps


def _aimed(scenario: Scenario, frame: Frame, rng: np.random.Generator) -> Frame:
    """Return a frame in which every camera with a drive has a random setting within its stops."""
    drives = [camera.drive for camera in cameras_of(scenario) if camera.drive is not None]
    views = tuple(
        Setting(*(_random(travel, now, rng) for travel, now in zip((d.pan, d.tilt, d.zoom), view, strict=True)))
        for d, view in zip(drives, frame.views, strict=True)
    )
    return msgspec.structs.replace(frame, views=views)


def _random(travel: Travel | None, now: float, rng: np.random.Generator) -> float:
    return now if travel is None else float(rng.uniform(travel.least, travel.greatest))
