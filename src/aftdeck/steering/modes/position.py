"""Mode 1, automatic, position: all joints start and stop together.

Inputs: the final tip pose (CMD CK chooses one set of joint angles for it) or final joint angles; PROCEED and STOP.
Limits: coarse or vernier joint rates, which are lower with a payload; the tip's speed and acceleration; joint
accelerations; soft stops. One factor slows all joints. Singularities do not act, because no Jacobian is inverted. Under
`strict` only the servo maxima (RATLMT) act, as in the source.
Ends: when the mode's clock reaches ETA = 1/RATIO + V_L/dV_L. If limits slow the arm, they also slow the clock.
Source: JSC-12628, introduction (mode 1), subroutine OPERIN (MODE = 1). The source says that acceleration is accounted
for. The rate profile is ours: ramps of the duration V_L/dV_L at both ends. A motion that is too short for these ramps
has a triangular profile.

Plan of this mode: the rotation of each joint (8) [rad], ETA and ramp time [s], and the full rate, as a share of the
rotation per second [1/s]. Until the plan is computed, its first elements contain the joints' final angles [rad].
"""

from __future__ import annotations

import math

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates
from aftdeck.law import law
from aftdeck.steering.layout import (
    ANGLES,
    ARRIVED,
    CLOCK,
    CLOCK_RATE,
    DT,
    JOINTS,
    MEASURED,
    MOTION_ACTIVE,
    PLAN,
    PLANNED_END,
    RATE,
    REMAINING,
    SPEED,
    SPEED_UP,
)
from aftdeck.steering.views import rates_at

_ROTATION, _RAMP, _FULL = PLAN, PLANNED_END + 1, PLANNED_END + 2


@law
def plan(rules: Array, command: Array, state: Array) -> None:
    """Plan mode 1 (OPERIN): replace final angles by rotations from the present angles, add times, reset the clock."""
    ratio = 1.0
    moves = False
    for i in range(int(rules[JOINTS])):
        command[_ROTATION + i] -= state[ANGLES + i]
        rotation = abs(command[_ROTATION + i])
        moves = moves or rotation > 0.0
        if rotation * ratio > rules[RATE + i]:
            ratio = rules[RATE + i] / rotation
    ramp = rules[SPEED] / rules[SPEED_UP]
    if 1.0 / ratio >= ramp:
        full, eta = ratio, 1.0 / ratio + ramp
    else:
        ramp = math.sqrt(ramp / ratio)
        full, eta = 1.0 / ramp, 2.0 * ramp
    command[PLANNED_END] = eta if moves else 0.0
    command[_RAMP], command[_FULL] = ramp, full
    state[CLOCK], state[CLOCK_RATE] = 0.0, 1.0


@law
def _completed(command: Array, time: float) -> float:
    """Return the share of the rotation, 0 to 1, that the plan completes by a phase time."""
    eta: float = command[PLANNED_END]
    ramp: float = command[_RAMP]
    full: float = command[_FULL]
    if time <= 0.0:
        return 0.0
    if time >= eta:
        return 1.0
    if time < ramp:
        return 0.5 * full * time * time / ramp
    if time > eta - ramp:
        left = eta - time
        return 1.0 - 0.5 * full * left * left / ramp
    return full * (time - 0.5 * ramp)


@law
def _time_of(command: Array, made: float) -> float:
    """Return the phase time by which the plan completes a share of the rotation: the inverse of `_completed`."""
    eta: float = command[PLANNED_END]
    ramp: float = command[_RAMP]
    full: float = command[_FULL]
    at_ramp = 0.5 * full * ramp
    if made <= at_ramp:
        return math.sqrt(2.0 * made * ramp / full)
    if made < 1.0 - at_ramp:
        return made / full + 0.5 * ramp
    return eta - math.sqrt(2.0 * max(1.0 - made, 0.0) * ramp / full)


@law
def clock_after(command: Array, time: float, factor: float, period: float) -> float:
    """Return the phase time [s] after a step in which the arm made only the share `factor` of the planned motion.

    At this time of the plan, the planned joint angles are those that the arm has after the step.
    """
    if factor >= 1.0 or command[MOTION_ACTIVE] == 0.0:
        return time + factor * period
    here = _completed(command, time)
    return max(time, _time_of(command, here + factor * (_completed(command, time + period) - here)))


@law
def rates(rules: Array, command: Array, state: Array, report: Array) -> Rates:
    """Return mode 1's joint rates [rad/s] for this step.

    Before the motion starts, the rates bring all joints to rest at the same time.
    """
    if command[MOTION_ACTIVE] != 0.0:
        time = state[CLOCK]
        k = (_completed(command, time + rules[DT]) - _completed(command, time)) / rules[DT]
        report[REMAINING] = max(command[PLANNED_END] - time, 0.0)
        report[ARRIVED] = 1.0 if time >= command[PLANNED_END] - 1e-9 else 0.0
        return _share(k, command, _ROTATION)
    share = 0.0
    for i in range(int(rules[JOINTS])):
        share = max(share, abs(state[MEASURED + i]) / rules[RATE + i])
    slower = rules[DT] * rules[SPEED_UP] / rules[SPEED]
    k = max(share - slower, 0.0) / share if share > 0.0 else 0.0
    return _share(k, state, MEASURED)


@law
def _share(k: float, of: Array, at: int) -> Rates:
    """Return `k` times the values of the joints that begin at index `at` of an array."""
    r = rates_at(of, at)
    return Rates(k * r.r1, k * r.r2, k * r.r3, k * r.r4, k * r.r5, k * r.r6, k * r.r7, k * r.r8)
