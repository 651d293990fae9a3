"""Scenario, routine and frames that the tests of this folder share."""

from __future__ import annotations

import functools

import numpy as np

from aftdeck.mainprior.routine import PriorityRoutine
from aftdeck.simulation.frame import Frame
from aftdeck.visual.scene import VisualScene
from tests import loaded
from tests.visual.states import states

SCRIPT = "concept-1972-script"
"""Scenario of the report's mission."""


@functools.cache
def scene() -> VisualScene:
    """Return the visual scene of the mission."""
    return VisualScene(loaded.scenario(SCRIPT))


@functools.cache
def routine() -> PriorityRoutine:
    """Return the priority routine of the mission."""
    return PriorityRoutine(loaded.scenario(SCRIPT), scene())


@functools.cache
def frames(count: int = 12) -> tuple[Frame, ...]:
    """Return frames of the mission and of random sticks, with random pan, tilt and zoom."""
    return tuple(states(loaded.scenario(SCRIPT), count, np.random.default_rng(3)))
