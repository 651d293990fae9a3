"""VCLOSE and VTOPEN: speeds towards a target, such that translation and rotation end together.

JSC-12628, subroutines VCLOSE and VTOPEN. VCLOSE has three corrections, which `strict` omits:

- Braking is computed for finite steps, so that the last step ends at the target.
- The remaining time has one formula for a motion at maximum speed and one for a braking motion. At the transition, both
  give the same time.
- If translation ends later than rotation, the angular rate is reduced to the remaining angle divided by a time that
  is never zero. If rotation ends later, the speed is reduced in the same manner.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.steering.layout import DT, SPEED, SPEED_UP, STRICT, TURN, TURN_UP
from aftdeck.steering.limiters import braked


class Profile(NamedTuple):
    """Speed [m/s] and angular rate [rad/s] towards the target, and the remaining times [s].

    `remaining` is ETA - TP for translation and rotation together; `turn_remaining` is ETAP - TP for the rotation alone.
    """

    speed: float
    turn: float
    remaining: float
    turn_remaining: float


@law
def vclose(rules: Array, distance: float, angle: float) -> Profile:
    """Return the demanded speeds for a remaining distance [m] and angle [rad] (VCLOSE)."""
    if rules[STRICT] != 0.0:
        return _as_published(rules, distance, angle)
    dt = rules[DT]
    speed, time, brake = _alone(distance, rules[SPEED], rules[SPEED_UP], dt)
    turn, turn_time, turn_brake = _alone(angle, rules[TURN], rules[TURN_UP], dt)
    if time >= turn_time:
        if time > 0.0:
            own = min(turn_brake, time)
            turn = min(turn, angle / (time - 0.5 * (own - dt)))
        return Profile(speed, turn, time, turn_time)
    own = min(brake, turn_time)
    return Profile(min(speed, distance / (turn_time - 0.5 * (own - dt))), turn, turn_time, turn_time)


@law
def _alone(left: float, most: float, up: float, dt: float) -> tuple[float, float, float]:
    """Return rate, remaining time [s] and braking time [s] of one motion, translation or rotation, in steps of dt.

    Braking from the rate n * up * dt takes n steps, and covers the distance 0.5 * (n + 1) * dt times this rate.
    """
    if left <= 0.0:
        return 0.0, 0.0, 0.0
    rate = braked(left, up, dt)
    if rate < most:
        time = 2.0 * left / rate - dt
        return rate, time, time
    brake = most / up
    return most, left / most + 0.5 * (brake - dt), brake


@law
def _as_published(rules: Array, distance: float, angle: float) -> Profile:
    """Return the profile of VCLOSE as published, with TP = 0. The source's small time epsilon is one control period.

    The motion that would end first is slowed: its speed is the remaining distance or angle, divided by a time. This
    time is at least half of the time that the motion alone would need, and is therefore above 0 until the motion has
    ended.
    """
    t_v, eta = rules[SPEED] / rules[SPEED_UP], distance / rules[SPEED]
    if t_v <= eta:
        eta += 0.5 * t_v
    else:
        t_v = math.sqrt(2.0 * distance / rules[SPEED_UP])
        eta = t_v
    t_w, etap = rules[TURN] / rules[TURN_UP], angle / rules[TURN]
    if t_w <= etap:
        etap += 0.5 * t_w
    else:
        t_w = math.sqrt(2.0 * angle / rules[TURN_UP])
        etap = t_w
    remaining = max(eta, etap)
    if remaining < rules[DT]:
        return Profile(0.0, 0.0, 0.0, 0.0)
    if eta >= etap:
        return Profile(rules[SPEED_UP] * t_v, angle / (eta - 0.5 * t_w), remaining, etap)
    return Profile(distance / (etap - 0.5 * t_v), rules[TURN_UP] * t_w, remaining, etap)


class OpenProfile(NamedTuple):
    """Maximum speed [m/s] and angular rate [rad/s], and times [s].

    `eta` is the duration ETA of the motion. `etap` is the duration ETAP that the rotation alone would have at the
    maximum rate. `t_v1` and `t_w1` are the acceleration times of translation and rotation.
    """

    speed: float
    turn: float
    eta: float
    etap: float
    t_v1: float
    t_w1: float


@law
def vtopen(rules: Array, distance: float, angle: float) -> OpenProfile:
    """Return the open-loop profile for a distance [m] and an angle [rad], computed once (VTOPEN)."""
    eta, t_v1 = _ramped_alone(distance, rules[SPEED], rules[SPEED_UP])
    etap, t_w1 = _ramped_alone(angle, rules[TURN], rules[TURN_UP])
    eta = max(eta, etap)
    speed = distance / (eta - t_v1) if distance > 0.0 else 0.0
    turn = angle / (eta - t_w1) if angle > 0.0 else 0.0
    return OpenProfile(speed, turn, eta, etap, t_v1, t_w1)


@law
def _ramped_alone(distance: float, most: float, up: float) -> tuple[float, float]:
    """Return the duration and the acceleration time [s] of one motion, translation or rotation."""
    ramp, eta = most / up, distance / most
    if ramp <= eta:
        return eta + ramp, ramp
    ramp = math.sqrt(distance / up)
    return 2.0 * ramp, ramp
