"""Mode 2, automatic, closed-loop velocity: translation along a line and rotation about one axis, which end together.

Inputs: the final tip pose; PROCEED and STOP.
Limits: POR limits for speed and acceleration, servo maxima for the joints, soft stops, singularities.
Ends: when the tip is inside the end sphere and at rest. The estimated end time ETA is recomputed in every step.
Source: JSC-12628, subroutines OPERIN (MODE = 2), LATRAJ, VCLOSE.
"""

from __future__ import annotations

import math

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist
from aftdeck.kinematics.linkage import Tip
from aftdeck.law import law
from aftdeck.steering.aim import latraj
from aftdeck.steering.layout import (
    ANGLE,
    ARRIVED,
    DISTANCE,
    DT,
    MOTION_ACTIVE,
    NEAR,
    NEAR_TURN,
    PLAN,
    REMAINING,
    SPEED_UP,
    STRICT,
    TARGET,
    TURN_REMAINING,
    TURN_UP,
    TWIST,
)
from aftdeck.steering.profiles import vclose
from aftdeck.steering.views import twist_at

SLOW = 1.5
"""Greatest speed and angular rate at which the arm counts as at rest inside the end sphere, divided by the change that
the maximum acceleration makes in one control period [1]."""


@law
def demand(rules: Array, command: Array, tip: Tip, report: Array) -> Twist:
    """Return the twist in L that mode 2 demands at this pose; zero until the motion has started."""
    aim = latraj(tip, command[TARGET:PLAN])
    profile = vclose(rules, aim.distance, aim.angle)
    report[DISTANCE], report[ANGLE], report[REMAINING] = aim.distance, aim.angle, profile.remaining
    report[TURN_REMAINING] = profile.turn_remaining
    w, v = profile.turn * command[MOTION_ACTIVE], profile.speed * command[MOTION_ACTIVE]
    return Twist(w * aim.ax, w * aim.ay, w * aim.az, v * aim.ux, v * aim.uy, v * aim.uz)


@law
def note_arrival(rules: Array, state: Array, report: Array) -> None:
    """Write into the report whether the motion has ended, that is, whether the tip is inside the end sphere and slow.

    Under `strict` the motion ends when the remaining time is 0.
    """
    t = twist_at(state, TWIST)
    w = math.sqrt(t.wx * t.wx + t.wy * t.wy + t.wz * t.wz)
    v = math.sqrt(t.vx * t.vx + t.vy * t.vy + t.vz * t.vz)
    near = report[DISTANCE] <= rules[NEAR] and report[ANGLE] <= rules[NEAR_TURN]
    if rules[STRICT] != 0.0:  # in the source, the phase ends when VCLOSE's remaining time is 0
        report[ARRIVED] = 1.0 if report[REMAINING] == 0.0 else 0.0
        return
    slow = v <= SLOW * rules[SPEED_UP] * rules[DT] and w <= SLOW * rules[TURN_UP] * rules[DT]
    report[ARRIVED] = 1.0 if near and slow else 0.0
