"""MSTEER: one steering step, from the measured arm and the command to the joint rates.

Source: JSC-12628, subroutine MSTEER. It calls JACOBI, LNKAGE, ERATES, VOTRAN (the mode's twist), AVCLMT, RMSRAT and
RATLMT. The twist of ERATES, times RATIO, is fed back to AVCLMT in the next step. Without `strict`, there are four
additions:

- Before AVCLMT, RATLMT's ratio reduces the mode's demand to a twist that the joints can reach. AVCLMT then does not
  accelerate towards a twist that the joints cannot reach.
- The rate law is evaluated at the joint angles expected in the middle of the coming step.
- In mode 2, AVCLMT's change of the twist keeps translation and rotation in proportion. In modes 4 to 7, a step makes
  only that share of the change which the joint accelerations allow (`steering.twist_change`).
- One factor (`steering.one_factor`) slows the whole motion, so that modes 1 and 3 stay on their plans.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates, Twist
from aftdeck.kinematics.linkage import Tip, lifted
from aftdeck.kinematics.rates import FLOOR
from aftdeck.kinematics.solver import Posture, posture, rates_of, tip_at, tip_of, twist_of
from aftdeck.law import law
from aftdeck.steering.layout import (
    AIMS,
    ANGLE,
    ANGLES,
    ARRIVED,
    BEFORE,
    CAUSE,
    CLOCK,
    CLOCK_RATE,
    DEMAND,
    DIRECT_LAW,
    DISTANCE,
    DT,
    GUARDED,
    LAW,
    LIMITING_JOINT,
    MASTER_LAW,
    MEASURED,
    MOTION_ACTIVE,
    OFFSET,
    POINT,
    POR_CAUSE,
    RATE,
    RATES,
    RATIO,
    REMAINING,
    SHOULDER_OFFSET,
    STRICT,
    TURN_REMAINING,
    TWIST,
)
from aftdeck.steering.limiters import BY_ACCELERATION, BY_RATE, NEAREST, avclmt, joint_ratio, ratlmt
from aftdeck.steering.modes import closed_loop, direct, manual, master, open_loop, position, single_joint
from aftdeck.steering.one_factor import one_factor
from aftdeck.steering.turn import from_hand
from aftdeck.steering.twist_change import Share, in_proportion, rates_between, share_of_change, twist_between
from aftdeck.steering.views import put_rates, put_twist, rates_at, twist_at

NEAR_FLOOR = 0.5 * NEAREST
"""Floor of the rate law [1], a normalised distance from a singularity, in rules with GUARDED = 1.

RATLMT already stops an approach at twice this distance. The floor therefore acts only if an arm starts nearer to
the singularity than the floor.
"""


@law
def msteer(rules: Array, command: Array, state: Array, report: Array) -> None:
    """Write into `state` the joint rates for the coming step, and into `report` the limits that act (MSTEER).

    `steering.layout` describes the arrays. At the call, `state` holds the measured angles, and the rates and the twist
    that the last step commanded. This function replaces the rates and the twist.
    """
    report[RATIO], report[CAUSE], report[LIMITING_JOINT], report[POR_CAUSE] = 1.0, 0.0, -1.0, 0.0
    report[DISTANCE], report[ANGLE], report[REMAINING], report[ARRIVED] = 0.0, 0.0, 0.0, 0.0
    report[TURN_REMAINING] = 0.0
    put_rates(report, BEFORE, rates_at(state, RATES))
    a = posture(rules, _angles_at(state, 0.0 if rules[STRICT] != 0.0 else 0.5 * rules[DT]))
    if command[LAW] == 1.0 or 8.0 <= command[LAW] <= MASTER_LAW:
        _steer_joints(rules, command, state, report, a)
    else:
        _steer_point(rules, command, state, report, a)


@law
def measured(angles: Array, rates: Array, holds: Array, rise: float, state: Array) -> None:
    """Copy the measurements into the state.

    Args:
        angles: (n,) joint angles [rad].
        rates: (n,) joint rates [rad/s].
        holds: (n,) angles to which servos turn the joints [rad]; NaN for a joint that has no such angle.
        rise: measured height of the shoulder minus its height in `rules` [m].
        state: receives the measurements.
    """
    state[SHOULDER_OFFSET] = rise
    for i in range(angles.shape[0]):
        state[ANGLES + i] = angles[i]
        state[MEASURED + i] = rates[i]
        state[AIMS + i] = angles[i] if holds[i] != holds[i] else holds[i]


@law
def _angles_at(state: Array, ahead: float) -> Rates:
    """Return the joint angles [rad] after a time `ahead` [s] at the measured rates."""
    q, r = rates_at(state, ANGLES), rates_at(state, MEASURED)
    return Rates(
        q.r1 + ahead * r.r1,
        q.r2 + ahead * r.r2,
        q.r3 + ahead * r.r3,
        q.r4 + ahead * r.r4,
        q.r5 + ahead * r.r5,
        q.r6 + ahead * r.r6,
        q.r7 + ahead * r.r7,
        q.r8 + ahead * r.r8,
    )


@law
def _steer_joints(rules: Array, command: Array, state: Array, report: Array, a: Posture) -> None:
    """Steer in modes 1 and 8, DIRECT and MASTER, which command joint rates. Singularities do not limit these modes."""
    if command[LAW] == 1.0:
        demanded = position.rates(rules, command, state, report)
        factor = _position_factor(rules, command, state, report, a, demanded)
        rates = cut(rules, demanded, factor)
        state[CLOCK_RATE] = factor
        share = 1.0 if rules[STRICT] != 0.0 else factor
        state[CLOCK] = position.clock_after(command, state[CLOCK], share, rules[DT])
    elif command[LAW] == DIRECT_LAW:
        rates = direct.rates(rules, command, state, report)
    elif command[LAW] == MASTER_LAW:
        rates = master.rates(rules, command, state, report)
    else:
        rates = single_joint.rates(rules, command, state, report)
    twist = twist_of(rules, a, rates)
    put_twist(report, DEMAND, twist)
    feed_back(state, rates, twist, 0.0)


@law
def _position_factor(rules: Array, command: Array, state: Array, report: Array, a: Posture, demanded: Rates) -> float:
    """Return the factor, 0 to 1, that reduces mode 1's joint rates; write into the report which limits act.

    Before the motion starts, and under `strict` (as in the source), only RATLMT acts. Otherwise the limits of the tip
    and of the joint accelerations also apply.
    """
    limit = joint_ratio(rules, state, demanded)
    if rules[STRICT] != 0.0 or command[MOTION_ACTIVE] == 0.0:
        report[RATIO], report[CAUSE], report[LIMITING_JOINT] = limit.ratio, limit.cause, limit.culprit
        return limit.ratio
    present = _present_twist(rules, state, a, False, 0.0, 0.0, 0.0)
    result = one_factor(rules, state, demanded, twist_of(rules, a, demanded), present, limit)
    report[RATIO], report[CAUSE], report[LIMITING_JOINT] = result.factor, result.cause, result.culprit
    report[POR_CAUSE] = result.por_cause
    return result.factor


@law
def _steer_point(rules: Array, command: Array, state: Array, report: Array, a: Posture) -> None:
    """Steer in modes 2 to 7, which command a twist of the point of resolution."""
    here = lifted(tip_at(rules, rates_at(state, ANGLES)), state[SHOULDER_OFFSET])
    twist = _demand(rules, command, state, report, here)
    put_twist(report, DEMAND, twist)
    offset = rules[OFFSET] != 0.0 or rules[OFFSET + 1] != 0.0 or rules[OFFSET + 2] != 0.0
    x, y, z = 0.0, 0.0, 0.0
    if offset:
        x, y, z = from_hand(tip_of(rules, a), rules[OFFSET], rules[OFFSET + 1], rules[OFFSET + 2])
        if command[LAW] < 4.0:  # POSITION HOLD in ORB LD and PL uses mode 2, which demands a twist of the tip
            twist = _twist_of_point(twist, x, y, z)
    floor = NEAR_FLOOR if rules[GUARDED] != 0.0 else FLOOR
    present = _present_twist(rules, state, a, offset, x, y, z)
    on_line = (command[LAW] == 2.0 or command[LAW] == 3.0) and command[MOTION_ACTIVE] != 0.0 and rules[STRICT] == 0.0
    if not (on_line and command[LAW] == 3.0):  # AVCLMT would take mode 3 off its plan; `one_factor` does not
        if rules[STRICT] == 0.0:
            possible = ratlmt(rules, state, a, rates_of(rules, a, _twist_of_point(twist, -x, -y, -z), floor))
            twist = scaled(twist, possible.ratio)
            report[RATIO], report[CAUSE], report[LIMITING_JOINT] = possible.ratio, possible.cause, possible.culprit
        if on_line:
            twist, por_cause = in_proportion(rules, twist, present)
        else:
            twist, por_cause = avclmt(rules, twist, present)
        report[POR_CAUSE] = por_cause
    rates = rates_of(rules, a, _twist_of_point(twist, -x, -y, -z), floor)
    change = Share(1.0, -1)
    if not on_line and rules[STRICT] == 0.0:
        kept = rates_of(rules, a, _twist_of_point(present, -x, -y, -z), floor)
        change = share_of_change(rules, state, kept, rates)
        rates, twist = rates_between(kept, rates, change.share), twist_between(present, twist, change.share)
    limit = ratlmt(rules, state, a, rates)
    factor, cause, culprit = limit.ratio, limit.cause, limit.culprit
    if rules[STRICT] == 0.0:
        result = one_factor(rules, state, rates, twist, present, limit)
        factor, cause, culprit = result.factor, result.cause, result.culprit
        if result.por_cause != 0:
            report[POR_CAUSE] = result.por_cause
    report[RATIO] = report[RATIO] * factor
    if cause != 0:
        report[CAUSE], report[LIMITING_JOINT] = cause, culprit
    if report[CAUSE] == BY_RATE and _below_limit(rules, rates, factor, int(report[LIMITING_JOINT])):
        # the arm is still accelerating, and the joint is still below its rate limit
        report[CAUSE], report[LIMITING_JOINT] = 0.0, -1.0
    if report[CAUSE] == 0.0 and change.share < 1.0:
        report[CAUSE], report[LIMITING_JOINT] = BY_ACCELERATION, change.joint
    state[CLOCK_RATE] = 1.0 if rules[STRICT] != 0.0 else report[RATIO]
    state[CLOCK] += state[CLOCK_RATE] * rules[DT]
    feed_back(state, cut(rules, rates, factor), scaled(twist, factor), 1.0 if offset else 0.0)


@law
def _below_limit(rules: Array, r: Rates, k: float, joint: int) -> bool:
    """Return whether a joint's rate, times `k`, is below its rate limit by more than a rounding error."""
    below: bool = abs(k * r[joint]) < 0.999 * rules[RATE + joint]
    return below


@law
def _demand(rules: Array, command: Array, state: Array, report: Array, here: Tip) -> Twist:
    """Return the twist that the mode demands; zero in modes that demand no twist."""
    number = command[LAW]
    if number == 2.0:
        twist = closed_loop.demand(rules, command, here, report)
        closed_loop.note_arrival(rules, state, report)
    elif number == 3.0:
        twist = open_loop.demand(rules, command, state, report)
    else:
        twist = manual.demand(rules, command, here)
    return twist


@law
def _present_twist(rules: Array, state: Array, a: Posture, offset: bool, x: float, y: float, z: float) -> Twist:
    """Return the present twist of the point of resolution, from which AVCLMT computes the accelerations.

    The source computes this twist by ERATES from the measured joint rates at the new angles. Without `strict`, the
    result is the twist that the last step commanded, plus a correction: ERATES of the measured minus the commanded
    joint rates. The twist changes during a step even if the joint rates are constant. With the corrected result,
    AVCLMT does not count this change as an acceleration. (x, y, z) is the vector from the tip to the point of
    resolution, in L.
    """
    actual, commanded = rates_at(state, MEASURED), rates_at(state, RATES)
    was = state[POINT] != 0.0
    if rules[STRICT] != 0.0:
        return _twist_of_point(twist_of(rules, a, actual), x, y, z)
    if was and not offset:  # TWIST belongs to a point of the payload, but the point of resolution is now the tip
        return twist_of(rules, a, actual)
    beside = Rates(
        actual.r1 - commanded.r1, actual.r2 - commanded.r2, actual.r3 - commanded.r3,
        actual.r4 - commanded.r4, actual.r5 - commanded.r5, actual.r6 - commanded.r6,
        actual.r7 - commanded.r7, actual.r8 - commanded.r8,
    )  # fmt: skip
    more = twist_of(rules, a, beside)
    if was:  # TWIST already belongs to the payload's point of resolution
        more = _twist_of_point(more, x, y, z)
    t = twist_at(state, TWIST)
    last = Twist(t.wx + more.wx, t.wy + more.wy, t.wz + more.wz, t.vx + more.vx, t.vy + more.vy, t.vz + more.vz)
    return _twist_of_point(last, x, y, z) if offset and not was else last


@law
def _twist_of_point(t: Twist, x: float, y: float, z: float) -> Twist:
    """Return the twist of a second point of a body; (x, y, z) is the vector from the point with twist `t` to it."""
    return Twist(
        t.wx,
        t.wy,
        t.wz,
        t.vx + t.wy * z - t.wz * y,
        t.vy + t.wz * x - t.wx * z,
        t.vz + t.wx * y - t.wy * x,
    )


@law
def carried_to_tip(rules: Array, here: Tip, t: Twist) -> Twist:
    """Return the tip's twist, from the twist `t` of the point of resolution."""
    x, y, z = from_hand(here, rules[OFFSET], rules[OFFSET + 1], rules[OFFSET + 2])
    return _twist_of_point(t, -x, -y, -z)


@law
def scaled(t: Twist, k: float) -> Twist:
    """Return a twist times a number."""
    return Twist(k * t.wx, k * t.wy, k * t.wz, k * t.vx, k * t.vy, k * t.vz)


@law
def cut(rules: Array, r: Rates, k: float) -> Rates:
    """Return the joint rates times `k`; a rate that exceeds its limit by a rounding error is set to the limit."""
    most = rates_at(rules, RATE)
    return Rates(
        _within(k * r.r1, most.r1),
        _within(k * r.r2, most.r2),
        _within(k * r.r3, most.r3),
        _within(k * r.r4, most.r4),
        _within(k * r.r5, most.r5),
        _within(k * r.r6, most.r6),
        _within(k * r.r7, most.r7),
        _within(k * r.r8, most.r8),
    )


@law
def _within(value: float, most: float) -> float:
    return min(max(value, -most), most)


@law
def feed_back(state: Array, r: Rates, t: Twist, point: float) -> None:
    """Store the commanded rates and twist for the next step's AVCLMT."""
    put_rates(state, RATES, r)
    put_twist(state, TWIST, t)
    state[POINT] = point
