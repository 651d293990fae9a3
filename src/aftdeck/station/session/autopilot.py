"""Autopilot of a session: the script, a policy or a synthetic operator, which flies until the operator takes over."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from aftdeck.scenario.model import Scenario
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.run import Simulation
from aftdeck.station.messages.frame import AutopilotName

Pilot = Callable[[Simulation], Inputs | None]
"""Function that returns the inputs of the next step; None if it has completed its task or gives up."""


class Autopilot(NamedTuple):
    """Autopilot of one scenario.

    Attributes:
        name: what flies.
        begin: returns the pilot of a new run; None for the scenario's script, which flies each step without inputs.
    """

    name: AutopilotName
    begin: Callable[[], Pilot] | None


Autopilots = Callable[[Scenario], Autopilot | None]
"""Function that returns the autopilot of a scenario; None if there is none for it."""

SCRIPT = Autopilot("script", None)


class Engaged:
    """Autopilot in control of the present run.

    Attributes:
        name: what flies.
        inputs: its inputs for the next step; None for those of the script.
    """

    def __init__(self, autopilot: Autopilot) -> None:
        self.name = autopilot.name
        self.inputs: Inputs | None = None
        self._pilot = None if autopilot.begin is None else autopilot.begin()

    def fly(self, sim: Simulation) -> bool:
        """Compute `inputs` for the next step; return False if the autopilot has ended."""
        if self._pilot is None:
            return not sim.ended
        self.inputs = self._pilot(sim)
        return self.inputs is not None
