"""Aftdeck: simulator of a space manipulator, with manual or scripted operation.

Each public name is imported from its module when the name is first used. Importing the package therefore takes almost
no time.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from aftdeck.analysis.dynamics import Dynamics, dynamics
    from aftdeck.analysis.linear_model import LinearModel
    from aftdeck.bodies.mass_properties import MassProperties
    from aftdeck.bodies.separation import Separation, separation
    from aftdeck.frames import Pose
    from aftdeck.kinematics.arm import Arm, load_arm
    from aftdeck.scenario.disturbance import Disturbance
    from aftdeck.scenario.load import load_scenario
    from aftdeck.scenario.model import Scenario
    from aftdeck.scenario.target import Target
    from aftdeck.simulation.frame import Frame
    from aftdeck.simulation.inputs import Inputs
    from aftdeck.simulation.run import Run, Simulation, run
    from aftdeck.simulation.summary import Summary
    from aftdeck.version import __version__

_HOMES = {
    "Arm": "aftdeck.kinematics.arm",
    "load_arm": "aftdeck.kinematics.arm",
    "Pose": "aftdeck.frames",
    "Scenario": "aftdeck.scenario.model",
    "load_scenario": "aftdeck.scenario.load",
    "Inputs": "aftdeck.simulation.inputs",
    "Target": "aftdeck.scenario.target",
    "Disturbance": "aftdeck.scenario.disturbance",
    "Frame": "aftdeck.simulation.frame",
    "Simulation": "aftdeck.simulation.run",
    "Run": "aftdeck.simulation.run",
    "Summary": "aftdeck.simulation.summary",
    "run": "aftdeck.simulation.run",
    "Dynamics": "aftdeck.analysis.dynamics",
    "LinearModel": "aftdeck.analysis.linear_model",
    "MassProperties": "aftdeck.bodies.mass_properties",
    "dynamics": "aftdeck.analysis.dynamics",
    "Separation": "aftdeck.bodies.separation",
    "separation": "aftdeck.bodies.separation",
    "__version__": "aftdeck.version",
}

__all__ = [
    "Arm",
    "Disturbance",
    "Dynamics",
    "Frame",
    "Inputs",
    "LinearModel",
    "MassProperties",
    "Pose",
    "Run",
    "Scenario",
    "Separation",
    "Simulation",
    "Summary",
    "Target",
    "__version__",
    "dynamics",
    "load_arm",
    "load_scenario",
    "run",
    "separation",
]


def __getattr__(name: str) -> object:
    """Load a public name from its module."""
    if name not in _HOMES:
        raise AttributeError(f"module 'aftdeck' has no attribute {name!r}")
    return getattr(importlib.import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    """Return the public names, sorted."""
    return sorted(__all__)
