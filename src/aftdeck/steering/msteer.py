"""MSTEER: one steering step, from where the arm is and what is asked to six joint rates.

JSC-12628, subroutine MSTEER: JACOBI, LNKAGE, ERATES, the mode's twist (VOTRAN), AVCLMT, RMSRAT, RATLMT, and
ERATES times RATIO fed back to the next step's AVCLMT. Two things are added unless `strict`: what the mode asks
is first cut to what the joints can give (RATLMT's ratio, taken before AVCLMT, so that no acceleration is spent
on a hopeless speed-up), and the rate law is taken at the middle of the step that is about to be made.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from aftdeck.kinematics.jacobian import Jacobian, Rates, Twist, erates, jacobi
from aftdeck.kinematics.linkage import Sines, Tip, lifted, sines, tip
from aftdeck.kinematics.rates import rmsrat
from aftdeck.law import law
from aftdeck.steering.layout import (
    ANGLE,
    ANGLES,
    ARRIVED,
    CAUSE,
    CLOCK,
    CULPRIT,
    DEMAND,
    DIRECT_LAW,
    DISTANCE,
    DT,
    LAW,
    MASTER_LAW,
    OFFSET,
    PACE,
    POINT,
    POR_CAUSE,
    RATE,
    RATES,
    RATIO,
    REMAINING,
    RISE,
    STRICT,
    TWIST,
)
from aftdeck.steering.limiters import BY_RATE, NEAREST, avclmt, ratlmt
from aftdeck.steering.modes import (
    closed_loop,
    direct,
    end_effector,
    master,
    mixed,
    open_loop,
    orbiter,
    payload,
    position,
    single_joint,
)
from aftdeck.steering.turn import from_hand

Array = NDArray[np.float64]

FLOOR = 0.5 * NEAREST
"""Normalised distance from a singularity that the rate law works with at least, where the arm starts nearer."""


@law
def msteer(rules: Array, command: Array, state: Array, report: Array) -> None:
    """MSTEER: the joint rates for the coming step, into `state`; how they came about, into `report`.

    The arrays are those of `steering.layout`. `state` holds measured angles, and the rates and the twist that
    the last step commanded; both are replaced.
    """
    report[RATIO], report[CAUSE], report[CULPRIT], report[POR_CAUSE] = 1.0, 0.0, -1.0, 0.0
    report[DISTANCE], report[ANGLE], report[REMAINING], report[ARRIVED] = 0.0, 0.0, 0.0, 0.0
    a = _sines_at(rules, state, 0.0 if rules[STRICT] != 0.0 else 0.5 * rules[DT])
    j = jacobi(rules, a)
    if command[LAW] == 1.0 or command[LAW] >= 8.0:
        _steer_joints(rules, command, state, report, a, j)
    else:
        _steer_point(rules, command, state, report, a, j)


@law
def measured(angles: Array, rise: float, state: Array) -> None:
    """Take up where the arm is: joint angles (6,) [rad], and how much higher the shoulder is than in `rules` [m]."""
    state[RISE] = rise
    for i in range(6):
        state[ANGLES + i] = angles[i]


@law
def _sines_at(rules: Array, state: Array, ahead: float) -> Sines:
    """Sines and cosines where the joints will be in a while [s] at the last step's rates."""
    return sines(
        rules,
        state[ANGLES] + ahead * state[RATES],
        state[ANGLES + 1] + ahead * state[RATES + 1],
        state[ANGLES + 2] + ahead * state[RATES + 2],
        state[ANGLES + 3] + ahead * state[RATES + 3],
        state[ANGLES + 4] + ahead * state[RATES + 4],
        state[ANGLES + 5] + ahead * state[RATES + 5],
    )


@law
def _steer_joints(rules: Array, command: Array, state: Array, report: Array, a: Sines, j: Jacobian) -> None:
    """Modes 1 and 8, DIRECT and MASTER, which command joint rates."""
    if command[LAW] == 1.0:
        wanted = position.rates(rules, command, state, report)
        limit = ratlmt(rules, state, a, wanted)
        report[RATIO], report[CAUSE], report[CULPRIT] = limit.ratio, limit.cause, limit.culprit
        rates = cut(rules, wanted, limit.ratio)
        _run_clock(rules, state, limit.ratio)
    elif command[LAW] == DIRECT_LAW:
        rates = direct.rates(rules, command, state, report)
    elif command[LAW] == MASTER_LAW:
        rates = master.rates(rules, command, state, report)
    else:
        rates = single_joint.rates(rules, command, state, report)
    twist = erates(a, j, rates)
    report[DEMAND], report[DEMAND + 1], report[DEMAND + 2] = twist.wx, twist.wy, twist.wz
    report[DEMAND + 3], report[DEMAND + 4], report[DEMAND + 5] = twist.vx, twist.vy, twist.vz
    feed_back(state, rates, twist, 0.0)


@law
def _steer_point(rules: Array, command: Array, state: Array, report: Array, a: Sines, j: Jacobian) -> None:
    """Modes 2 to 7, which command a twist of the point of resolution."""
    here = lifted(tip(rules, _sines_at(rules, state, 0.0)), state[RISE])
    wanted = _wanted(rules, command, state, report, here)
    report[DEMAND], report[DEMAND + 1], report[DEMAND + 2] = wanted.wx, wanted.wy, wanted.wz
    report[DEMAND + 3], report[DEMAND + 4], report[DEMAND + 5] = wanted.vx, wanted.vy, wanted.vz
    offset = rules[OFFSET] != 0.0 or rules[OFFSET + 1] != 0.0 or rules[OFFSET + 2] != 0.0
    x, y, z = 0.0, 0.0, 0.0
    if offset:
        x, y, z = from_hand(tip(rules, a), rules[OFFSET], rules[OFFSET + 1], rules[OFFSET + 2])
        if command[LAW] < 4.0:  # POSITION HOLD in the payload's modes: mode 2 asks a twist of the tip
            wanted = _carried(wanted, x, y, z)
    if rules[STRICT] == 0.0:
        possible = ratlmt(rules, state, a, rmsrat(rules, a, _carried(wanted, -x, -y, -z), FLOOR))
        wanted = scaled(wanted, possible.ratio)
        report[RATIO], report[CAUSE], report[CULPRIT] = possible.ratio, possible.cause, possible.culprit
    present = _present(rules, state, a, j, offset, x, y, z)
    allowed, por_cause = avclmt(rules, wanted, present)
    report[POR_CAUSE] = por_cause
    rates = rmsrat(rules, a, _carried(allowed, -x, -y, -z), FLOOR)
    limit = ratlmt(rules, state, a, rates)
    if limit.cause != 0:
        report[RATIO], report[CAUSE], report[CULPRIT] = report[RATIO] * limit.ratio, limit.cause, limit.culprit
    if report[CAUSE] == BY_RATE and _below_limit(rules, rates, limit.ratio, int(report[CULPRIT])):
        report[CAUSE], report[CULPRIT] = 0.0, -1.0  # it would be met later, but the arm is still speeding up
    _run_clock(rules, state, report[RATIO])
    feed_back(state, cut(rules, rates, limit.ratio), scaled(allowed, limit.ratio), 1.0 if offset else 0.0)


@law
def _below_limit(rules: Array, r: Rates, k: float, joint: int) -> bool:
    """Whether a joint is well below its rate limit."""
    below: bool = abs(k * r[joint]) < 0.999 * rules[RATE + joint]
    return below


@law
def _wanted(rules: Array, command: Array, state: Array, report: Array, here: Tip) -> Twist:
    """What the mode asks of the point of resolution."""
    number = command[LAW]
    if number == 2.0:
        wanted = closed_loop.demand(rules, command, here, report)
        closed_loop.note_arrival(rules, state, report)
    elif number == 3.0:
        wanted = open_loop.demand(rules, command, state, report)
    elif number == 4.0:
        wanted = orbiter.demand(rules, command)
    elif number == 5.0:
        wanted = end_effector.demand(rules, command, here)
    elif number == 6.0:
        wanted = payload.demand(rules, command, here)
    elif number == 7.0:
        wanted = mixed.demand(rules, command, here)
    else:
        wanted = Twist(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    return wanted


@law
def _present(rules: Array, state: Array, a: Sines, j: Jacobian, offset: bool, x: float, y: float, z: float) -> Twist:
    """The present twist of the point of resolution, from which AVCLMT counts.

    The source works it out by ERATES from the last joint rates at the new angles; mended, it is the twist that
    the last step commanded, so that the turning of the arm under constant rates is no error to be limited.
    (x, y, z) is the point's place from the tip, in L.
    """
    if rules[STRICT] != 0.0:
        r = Rates(
            state[RATES], state[RATES + 1], state[RATES + 2], state[RATES + 3], state[RATES + 4], state[RATES + 5]
        )
        return _carried(erates(a, j, r), x, y, z)
    last = Twist(state[TWIST], state[TWIST + 1], state[TWIST + 2], state[TWIST + 3], state[TWIST + 4], state[TWIST + 5])
    was = state[POINT] != 0.0
    if offset and not was:
        return _carried(last, x, y, z)
    if was and not offset:  # the point has been given up: the tip's own velocity follows from the joint rates
        r = Rates(
            state[RATES], state[RATES + 1], state[RATES + 2], state[RATES + 3], state[RATES + 4], state[RATES + 5]
        )
        return erates(a, j, r)
    return last


@law
def _carried(t: Twist, x: float, y: float, z: float) -> Twist:
    """The twist of a point at (x, y, z) from the one whose twist is given, on the same body."""
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
    """The tip's twist from that of the point of resolution."""
    x, y, z = from_hand(here, rules[OFFSET], rules[OFFSET + 1], rules[OFFSET + 2])
    return _carried(t, -x, -y, -z)


@law
def scaled(t: Twist, k: float) -> Twist:
    """A twist times a number."""
    return Twist(k * t.wx, k * t.wy, k * t.wz, k * t.vx, k * t.vy, k * t.vz)


@law
def cut(rules: Array, r: Rates, k: float) -> Rates:
    """Rates times RATIO, less a rounding error where one is at its limit."""
    return Rates(
        _within(k * r.r1, rules[RATE]),
        _within(k * r.r2, rules[RATE + 1]),
        _within(k * r.r3, rules[RATE + 2]),
        _within(k * r.r4, rules[RATE + 3]),
        _within(k * r.r5, rules[RATE + 4]),
        _within(k * r.r6, rules[RATE + 5]),
    )


@law
def _within(value: float, most: float) -> float:
    return min(max(value, -most), most)


@law
def _run_clock(rules: Array, state: Array, ratio: float) -> None:
    """Phase time of modes 1 and 3: at RATIO, or, as in the source, on and on."""
    state[PACE] = 1.0 if rules[STRICT] != 0.0 else ratio
    state[CLOCK] += state[PACE] * rules[DT]


@law
def feed_back(state: Array, r: Rates, t: Twist, point: float) -> None:
    """Keep what was commanded for the next step's AVCLMT."""
    state[RATES], state[RATES + 1], state[RATES + 2] = r.r1, r.r2, r.r3
    state[RATES + 3], state[RATES + 4], state[RATES + 5] = r.r4, r.r5, r.r6
    state[TWIST], state[TWIST + 1], state[TWIST + 2] = t.wx, t.wy, t.wz
    state[TWIST + 3], state[TWIST + 4], state[TWIST + 5] = t.vx, t.vy, t.vz
    state[POINT] = point
