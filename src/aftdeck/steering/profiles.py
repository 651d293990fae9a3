"""VCLOSE and VTOPEN: speeds towards a target, such that translation and rotation end together.

JSC-12628, subroutines VCLOSE and VTOPEN. They have three corrections, which `strict` omits; VTOPEN has the last one:

- Braking is computed for finite steps, so that the last step ends at the target.
- The remaining time has one formula for a motion at maximum speed and one for a braking motion. At the transition, both
  give the same time.
- Translation and rotation are in proportion to what remains of them. Both subroutines therefore lead along one path,
  whatever the speed. In the source, the motion that would end first has an acceleration time of its own. The path then
  depends on the speeds, and in VCLOSE on every limit that reduces them.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.steering.layout import DT, SPEED, SPEED_UP, STRICT, TURN, TURN_UP
from aftdeck.steering.limiters import braked

NOTHING = 1e-200
"""Distance [m] or angle [rad] up to which nothing remains: limits divided by it are still numbers."""


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
    speed, speed_up = _of_remaining(distance, rules[SPEED], rules[SPEED_UP])
    turn, turn_up = _of_remaining(angle, rules[TURN], rules[TURN_UP])
    rate, remaining = _towards_the_end(min(speed, turn), min(speed_up, turn_up), rules[DT])
    _, turn_remaining = _towards_the_end(turn, turn_up, rules[DT])
    return Profile(rate * distance, rate * angle, remaining, turn_remaining)


@law
def _of_remaining(left: float, most: float, up: float) -> tuple[float, float]:
    """Return limits of rate and acceleration, divided by the remaining distance or angle [1/s], [1/s2]."""
    return (most / left, up / left) if left > NOTHING else (math.inf, math.inf)


@law
def _towards_the_end(most: float, up: float, dt: float) -> tuple[float, float]:
    """Return rate [1/s] and remaining time [s] of a motion whose remaining part counts as 1, in steps of dt.

    Braking from the rate n * up * dt takes n steps, and covers the part 0.5 * (n + 1) * dt times this rate.
    """
    if most == math.inf:
        return 0.0, 0.0
    rate = braked(1.0, up, dt)
    if rate < most:
        return rate, 2.0 / rate - dt
    return most, 1.0 / most + 0.5 * (most / up - dt)


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
    if rules[STRICT] != 0.0:
        return _open_as_published(rules, distance, angle)
    speed, speed_up = _of_remaining(distance, rules[SPEED], rules[SPEED_UP])
    turn, turn_up = _of_remaining(angle, rules[TURN], rules[TURN_UP])
    if min(speed, turn) == math.inf:
        return OpenProfile(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    eta, ramp = _ramped_alone(1.0, min(speed, turn), min(speed_up, turn_up))
    etap, _ = _ramped_alone(angle, rules[TURN], rules[TURN_UP])
    share = 1.0 / (eta - ramp)
    return OpenProfile(share * distance, share * angle, eta, etap, ramp, ramp)


@law
def _open_as_published(rules: Array, distance: float, angle: float) -> OpenProfile:
    """Return the profile of VTOPEN as published: the shorter motion keeps its own acceleration time."""
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
