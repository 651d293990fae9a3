"""Autopilot of a session: the script, a policy or a synthetic operator, which flies until the operator takes over."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from aftdeck.errors import AftdeckError
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
        fault: reason for which it cannot fly on; empty if there is none.
    """

    def __init__(self, autopilot: Autopilot) -> None:
        self.name = autopilot.name
        self.inputs: Inputs | None = None
        self.fault = ""
        self._pilot = None if autopilot.begin is None else autopilot.begin()

    def fly(self, sim: Simulation) -> bool:
        """Compute `inputs` for the next step; return False if the autopilot has ended, or gives no possible inputs."""
        if self._pilot is None:
            return not sim.ended
        try:
            inputs = self._pilot(sim)
            self.inputs = None if inputs is None else sim.checked(inputs)
        except AftdeckError as error:
            self.inputs, self.fault = None, str(error)
        return self.inputs is not None
