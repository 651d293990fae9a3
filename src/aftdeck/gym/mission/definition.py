"""Tasks of Capture, Extract and Dock: controls, starts, observations, rewards, and end of an episode."""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.gym.terms import Control, Observed, Rewarded
from aftdeck.scenario.target import AtBerth, AtPayload
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.readings.quantity import UNITS
from aftdeck.simulation.readings.table import named
from aftdeck.units import FOOT

PERIOD = 0.1
"""Duration of a step of the environment [s]; it contains several control steps with the same sticks."""
SWITCHED = 0.5
"""Element of an action beyond which a switch changes its position; nearer to 0 it keeps its position."""


class Spread(NamedTuple):
    """Random start of an episode, relative to the pose to which the step's task leads.

    Attributes:
        least: least distance from that pose, or from the upper ends of the berth's guides, along the way out [m].
        greatest: greatest such distance [m].
        across: greatest displacement along each of the two axes across the way out [m].
        turn: greatest rotation about each axis of the tip [rad].
    """

    least: float
    greatest: float
    across: float
    turn: float


class Mission(NamedTuple):
    """One environment.

    Attributes:
        name: name of the environment.
        scenario: name of the built-in scenario that it flies unless another is given.
        controls: elements of the action.
        spread: random start.
        contact_ends: whether a detrimental contact ends the episode, without success.
        most_steps: greatest number of steps of an episode.
        task: the task, for the tables.
        cameras: cameras that see the task in the built-in scenario; the first one is that of `render`.
    """

    name: str
    scenario: str
    controls: tuple[Control, ...]
    spread: Spread
    contact_ends: bool
    most_steps: int
    task: str
    cameras: tuple[str, ...]

    @property
    def id(self) -> str:
        """Id of the environment."""
        return f"aftdeck/{self.name}-v0"

    def is_step(self, step: TaskStep) -> bool:
        """Return whether a step of a scenario's task is the one that this environment flies."""
        match self.name:
            case "Capture":
                return isinstance(step.target, AtPayload) and step.done.held is True
            case "Extract":
                return isinstance(step.target, AtBerth) and step.done.held is True and step.done.above is not None
            case _:
                ends = step.done.berth is not None or step.done.ready is True
                return isinstance(step.target, AtBerth) and ends and step.done.held is None


STICKS = (
    Control("THC X", "Translation along axis 1 of the sticks; forward in orbiter axes, ahead in END EFF."),
    Control("THC Y", "Translation along axis 2."),
    Control("THC Z", "Translation along axis 3."),
    Control("RHC roll", "Rotation about axis 1."),
    Control("RHC pitch", "Rotation about axis 2."),
    Control("RHC yaw", "Rotation about axis 3."),
    Control("rate", "Rate setting: coarse above 0.5, vernier below -0.5."),
)
EFFECTOR = Control("end effector", "End effector switch: close above 0.5, open below -0.5.")

CAPTURE = Mission(
    "Capture",
    "tutorial",
    (*STICKS, EFFECTOR),
    Spread(0.3, 0.6, 0.15, math.radians(4.0)),
    False,
    900,
    "Capture the payload in the bay; the end effector is above its grapple fixture.",
    ("WR", "ELB"),
)
EXTRACT = Mission(
    "Extract",
    "concept-1972",
    STICKS,
    Spread(0.0, 0.1, 0.003, 0.0),
    True,
    600,
    "Lift the held payload out of its berth, clear of the walls of the bay, without a detrimental contact.",
    ("F", "A"),
)
DOCK = Mission(
    "Dock",
    "concept-1972",
    STICKS,
    Spread(0.8 * FOOT, 1.5 * FOOT, 0.08, math.radians(2.0)),
    False,
    900,
    "Bring the held payload from in front of the docking port into the port, which latches by itself.",
    ("W", "C"),
)
MISSIONS = {mission.id: mission for mission in (CAPTURE, EXTRACT, DOCK)}
"""Environments by their ids."""

_FAR = 40.0
"""Greatest displacement that is observed [m]."""
_OVERSHOOT = 2.0
"""Greatest magnitude of an observation that a limit keeps at 1; a joint with a mass can overshoot its greatest rate."""
_BEYOND_SOFT = 1.5
"""Greatest magnitude of a joint angle, in half ranges between its soft stops."""


def _observed(name: str, size: int, scale: str, limit: float) -> Observed:
    reading = named(name)
    return Observed(name.replace("_", " "), size, reading.sentence, UNITS[reading.quantity], scale, limit, name)


def observations(joints: int) -> tuple[Observed, ...]:
    """Return what the environments observe of an arm with this number of joints."""
    return (
        _observed("to_go", 3, "1 m", _FAR),
        _observed("rotation_to_go", 3, "1 rad", 3.2),
        _observed("velocity", 3, "coarse speed limit", _OVERSHOOT),
        _observed("turning", 3, "coarse angular rate limit", _OVERSHOOT),
        _observed("angle", joints, "soft stop, 0 midway between the soft stops", _BEYOND_SOFT),
        _observed("rate", joints, "servo maximum", _OVERSHOOT),
        _observed("clearance_share", 1, "1", 1.0),
        _observed("arm_inhibit", 1, "1", 1.0),
        _observed("conditions", 1, "1", 1.0),
        _observed("coarse", 1, "1", 1.0),
        _observed("effector", 1, "1", 1.0),
        _observed("opening", 1, "1", 1.0),
    )


DISTANCE = Rewarded("distance", 5.0, "m", "Distance to go that the step has removed.")
ROTATION = Rewarded("rotation", 5.0, "rad", "Rotation to go that the step has removed.")
TIME = Rewarded("time", -0.05, "s", "Duration of the step.")
CONTACT = Rewarded("contact", -2.0, "s", "Duration of a step after which a detrimental contact exists.")
SUCCESS = Rewarded("success", 10.0, "1", "The task is complete; this ends the episode.")
REWARDS = (DISTANCE, ROTATION, TIME, CONTACT, SUCCESS)
