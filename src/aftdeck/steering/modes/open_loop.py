"""Mode 3, automatic, open-loop velocity: the line and axis of mode 2, planned once and executed without correction.

Inputs: the final tip pose; PROCEED and STOP.
Limits: POR limits for speed and acceleration, servo maxima and accelerations of the joints, soft stops, singularities.
One factor slows the whole twist and the mode's clock, so that limits slow the arm on its path but do not change the
path.
Ends: when the mode's clock reaches ETA. Under `strict` the clock is not slowed, as in the source, and a slowed arm
stops short of the target.
Source: JSC-12628, subroutines OPERIN (MODE = 3), LATRAJ, VTOPEN, VOTRAN.

Plan of this mode: velocity (3) [m/s] and angular velocity (3) [rad/s] at full speed, then ETA, t_v1, t_w1 and ETAP [s].
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist
from aftdeck.kinematics.linkage import lifted
from aftdeck.kinematics.solver import tip_at
from aftdeck.law import law
from aftdeck.steering.aim import latraj
from aftdeck.steering.layout import (
    ANGLES,
    ARRIVED,
    CLOCK,
    CLOCK_RATE,
    DT,
    MOTION_ACTIVE,
    PLAN,
    PLANNED_END,
    REMAINING,
    SHOULDER_OFFSET,
    STRICT,
    TARGET,
    TURN_REMAINING,
)
from aftdeck.steering.profiles import vtopen
from aftdeck.steering.views import rates_at

_VELOCITY, _TURNING = PLAN, PLAN + 3
_T_V1, _T_W1, _ETAP = PLANNED_END + 1, PLANNED_END + 2, PLANNED_END + 3


@law
def plan(rules: Array, command: Array, state: Array) -> None:
    """Plan mode 3 from the arm's present pose (OPERIN: LATRAJ and VTOPEN once), and reset the clock."""
    aim = latraj(lifted(tip_at(rules, rates_at(state, ANGLES)), state[SHOULDER_OFFSET]), command[TARGET:PLAN])
    profile = vtopen(rules, aim.distance, aim.angle)
    v, w = profile.speed, profile.turn
    command[_VELOCITY], command[_VELOCITY + 1], command[_VELOCITY + 2] = v * aim.ux, v * aim.uy, v * aim.uz
    command[_TURNING], command[_TURNING + 1], command[_TURNING + 2] = w * aim.ax, w * aim.ay, w * aim.az
    command[PLANNED_END], command[_T_V1], command[_T_W1] = profile.eta, profile.t_v1, profile.t_w1
    command[_ETAP] = profile.etap
    state[CLOCK], state[CLOCK_RATE] = 0.0, 1.0


@law
def _share(time: float, eta: float, ramp: float) -> float:
    """Return the share of full speed, 0 to 1, at a phase time, by VOTRAN's ramps of acceleration and deceleration."""
    if ramp <= 0.0:
        return 0.0
    return max(0.0, min(1.0, min(time, eta - time) / ramp))


@law
def demand(rules: Array, command: Array, state: Array, report: Array) -> Twist:
    """Return the twist in L that mode 3 demands at the present phase time; zero before the start of the motion."""
    eta = command[PLANNED_END]
    ahead = 0.0 if rules[STRICT] != 0.0 else 0.5 * rules[DT] * state[CLOCK_RATE]
    time = state[CLOCK] + ahead
    v = command[MOTION_ACTIVE] * _share(time, eta, command[_T_V1])
    w = command[MOTION_ACTIVE] * _share(time, eta, command[_T_W1])
    report[REMAINING] = max(eta - state[CLOCK], 0.0)
    report[TURN_REMAINING] = max(command[_ETAP] - state[CLOCK], 0.0)
    report[ARRIVED] = 1.0 if command[MOTION_ACTIVE] != 0.0 and state[CLOCK] >= eta - 1e-9 else 0.0
    return Twist(
        w * command[_TURNING],
        w * command[_TURNING + 1],
        w * command[_TURNING + 2],
        v * command[_VELOCITY],
        v * command[_VELOCITY + 1],
        v * command[_VELOCITY + 2],
    )
