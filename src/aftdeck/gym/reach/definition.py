"""Task of Reach: ranges of starts and goals, observations, rewards, and end of an episode."""

from __future__ import annotations

import math

import numpy as np

from aftdeck.arrays import Array
from aftdeck.gym.terms import Control, Observed, Rewarded
from aftdeck.tuples import Six

ID = "aftdeck/Reach-v0"
"""Id of the environment."""
PERIOD = 0.08
"""Control period [s]: that of the arm's own computer. A step of the environment is one control step."""
MOST_STEPS = 500
"""Greatest number of steps of an episode: 40 s. The longest motion of both sticks' axes takes about 30 s."""

HOME: Six = (-31.0, 79.0, -103.0, -77.0, 17.0, -128.0)
"""Middle of all starts and goals: joint angles above the payload bay, far from all limits [deg]."""
START_HALF: Six = (10.0, 6.0, 8.0, 10.0, 10.0, 15.0)
GOAL_HALF: Six = (25.0, 12.0, 16.0, 20.0, 20.0, 30.0)
"""Half ranges of the joint angles of starts and goals [deg]; in these ranges no singularity is near (assumed)."""
APART = 0.5
"""Least distance of start and goal [m] (assumed)."""

NEAR = 4.0 * 0.0254
NEAR_ANGLE = math.radians(3.0)
"""Distance [m] and angle [rad] within which the goal is reached: as *over the pin* in the scenario `srms-deploy`."""

_METRES, _REACH = 2.0, 16.0
"""Distance that is observed as 1 [m]. The greatest length of the arm is below 16 m; two tips are at most twice as far
apart."""
_OVERSHOOT = 2.0
"""Greatest magnitude of an observation that a limit keeps at 1; a joint with a mass can overshoot its greatest rate."""
_BEYOND_SOFT = 1.1
"""Greatest magnitude of a joint angle, in half ranges between its soft stops; the hard stops are nearer."""

CONTROLS = (
    Control("THC X", "Forward (+) or aft (-), along the orbiter's X axis."),
    Control("THC Y", "To starboard (+) or to port (-)."),
    Control("THC Z", "Down (+) or up (-)."),
    Control("RHC roll", "About the orbiter's X axis."),
    Control("RHC pitch", "About the orbiter's Y axis."),
    Control("RHC yaw", "About the orbiter's Z axis."),
)

OBSERVATIONS = (
    Observed("distance to go", 3, "Position of the goal minus that of the tip.", "m", f"{_METRES:g} m", _REACH),
    Observed(
        "rotation to go",
        3,
        "Rotation from the tip's attitude to the goal's: unit axis times 2 sin(angle / 2).",
        "",
        "1",
        2.001,
    ),
    Observed("velocity", 3, "Velocity of the tip.", "m/s", "speed limit of the mode", _OVERSHOOT),
    Observed("angular rate", 3, "Angular velocity of the tip.", "rad/s", "angular rate limit of the mode", _OVERSHOOT),
    Observed("joint angles", 6, "Joint angles, 0 midway between the soft stops.", "rad", "soft stop", _BEYOND_SOFT),
    Observed("joint rates", 6, "Joint rates.", "rad/s", "servo maximum", _OVERSHOOT),
)

DISTANCE = Rewarded("distance", 1.0, "m", "Distance to the goal that the step has removed.")
ROTATION = Rewarded("rotation", 2.0, "1", "Rotation to go, 2 sin(angle / 2), that the step has removed.")
TIME = Rewarded("time", -0.05, "s", "Duration of the step.")
SUCCESS = Rewarded("success", 10.0, "1", "The goal is reached; this ends the episode.")
REWARDS = (DISTANCE, ROTATION, TIME, SUCCESS)


def chord(angle: float) -> float:
    """Return the size of a rotation by `angle` [rad], as Reach measures it: 2 sin(angle / 2)."""
    return 2.0 * math.sin(0.5 * angle)


def scales(speed: float, turn: float, soft: Array, servo: Array) -> tuple[Array, Array]:
    """Return the observations (24,) that are normalised to 0, and those whose difference from them is 1.

    Args:
        speed: speed limit of the mode [m/s].
        turn: angular rate limit of the mode [rad/s].
        soft: (6, 2) soft stops [rad].
        servo: (6,) greatest joint rates [rad/s].
    """
    middle, one = np.zeros(24), np.ones(24)
    one[0:3], one[6:9], one[9:12], one[18:24] = _METRES, speed, turn, servo
    middle[12:18], one[12:18] = soft.mean(axis=1), 0.5 * (soft[:, 1] - soft[:, 0])
    return middle, one
