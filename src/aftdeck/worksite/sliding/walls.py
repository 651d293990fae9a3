"""Sliding along walls: the held payload keeps its velocity along the walls and loses the velocity into the walls.

Remote Manipulator Simulation, final report, section VII.4: the payload slides up or down while it touches a side wall.
The law `sliding.projection.slide` assumes that the motion of a step is straight. This module corrects for the curvature
of the motion; the remaining error is almost as small as rounding errors. A payload that is pressed against a wall
therefore stays in contact with the wall.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.pose import POSE, moved, turned_back
from aftdeck.bodies.vector import Vector, dot, minus, vector_at
from aftdeck.kinematics.frames import place_frames
from aftdeck.kinematics.jacobian import Twist
from aftdeck.kinematics.solver import rates_of, tip_of, twist_of
from aftdeck.law import law
from aftdeck.steering.layout import ANGLES, DT, RATES, SHOULDER_OFFSET, TWIST
from aftdeck.steering.limiters import ratlmt
from aftdeck.steering.msteer import NEAR_FLOOR, cut, feed_back, scaled
from aftdeck.steering.views import posture_now, rates_at
from aftdeck.worksite.sliding.projection import LEAST, OUTWARD, POINT, slide
from aftdeck.worksite.watch.clearance_monitor import minimum_clearance_group
from aftdeck.worksite.watch.found import CLEARANCE

REACH_S = 2.0
"""Walls that the payload can reach within this number of steps at the present speed are considered [1]."""
LEAST_REACH = 1e-6
"""Walls within this distance are considered at any speed [m]."""
PASSES = 5
"""Greatest number of passes of the correction for the curvature of a step. Each pass divides the error by a
thousand."""
EXACT = 2e-9
"""Greatest accepted speed into a wall [m/s]. In a step of 0.02 s, this speed moves a point by 4e-11 m. Two parts count
as in contact up to a clearance of 1e-9 m."""


@law
def met(found: Array, near: Mask, counts: Mask, steering: Array, stand: float, size: float, period: float) -> float:
    """Return the distance within which walls are considered [m]; 0 if no wall is within this distance.

    Args:
        found: (g, 14) the last measurements.
        near: (g,) 1 for groups whose clearance in `found` is finite.
        counts: (g,) 1 for groups that consist of a sliding part and a wall.
        steering: state of the steering, with the step's commanded twist.
        stand: speed of the telescope [m/s].
        size: upper bound of the distance of the payload's points from the point of resolution [m].
        period: duration of a step [s].
    """
    turn, speed = 0.0, stand
    for k in range(3):
        turn += abs(steering[TWIST + k])
        speed += abs(steering[TWIST + 3 + k])
    reach: float = max(REACH_S * (speed + size * turn) * period, LEAST_REACH)
    wall = minimum_clearance_group(found, near, counts)
    return reach if wall >= 0 and found[wall, CLEARANCE] <= reach else 0.0


@law
def slid(
    rules: Array, joints: Array, last: Array, height: float, turning: float, found: Array, steering: Array
) -> None:
    """Replace the commanded joint rates by rates with which the payload slides along the walls, within the rate limits.

    Args:
        rules: parameters of the steering.
        joints: (n, 9) joints of the arm, as `kinematics.frames.Frames.joints`.
        last: (12,) pose of the last joint's frame, in L.
        height: height of the telescope after the step [m].
        turning: share of the commanded rotation that is kept [1].
        found: (k, 7) touches of the held payload.
        steering: state of the steering; its rates and twist are changed if they would move the payload into a wall.
    """
    a = posture_now(rules, steering)
    here = tip_of(rules, a)
    tip = Vector(here.x, here.y, here.z - steering[SHOULDER_OFFSET])
    rates = rates_at(steering, RATES)
    twist = twist_of(rules, a, rates)
    demanded = Twist(turning * twist.wx, turning * twist.wy, turning * twist.wz, twist.vx, twist.vy, twist.vz)
    least_speeds = found.copy()
    for k in range(PASSES):
        if turning == 1.0 or k > 0:
            lacking, changed = _correct_least_speeds(
                rules, joints, last, height, found, steering, twist, tip, least_speeds
            )
            if lacking <= EXACT and (changed <= EXACT or k == 0):
                return
        twist = slide(least_speeds, tip, demanded)
        rates = rates_of(rules, a, twist, NEAR_FLOOR)
        ratio = ratlmt(rules, steering, a, rates).ratio
        twist = scaled(twist, ratio)
        feed_back(steering, cut(rules, rates, ratio), twist, 0.0)


@law
def _correct_least_speeds(
    rules: Array,
    joints: Array,
    last: Array,
    height: float,
    found: Array,
    steering: Array,
    twist: Twist,
    tip: Vector,
    least_speeds: Array,
) -> tuple[float, float]:
    """Correct the least speeds in `least_speeds` (k, 7), a copy of the touches `found`, for the curvature of the step.

    Each point moves with the last joint's frame, from the frame's present pose to its pose after the step at the
    commanded rates.

    Returns:
        The greatest amount by which a point falls short of its least speed, and the greatest change of a speed in
        `least_speeds` [m/s].
    """
    count = joints.shape[0]
    rows, after = np.empty((1 + count, POSE)), np.empty(count)
    for i in range(count):
        after[i] = steering[ANGLES + i] + steering[RATES + i] * rules[DT]
    place_frames(joints, after, height, 0.0, rows)
    now, lacking, changed = rows[count], -np.inf, 0.0
    for k in range(len(found)):
        row = found[k]
        point, outward = vector_at(row, POINT), vector_at(row, OUTWARD)
        r = minus(point, tip)
        v = Vector(
            twist.vx + twist.wy * r.z - twist.wz * r.y,
            twist.vy + twist.wz * r.x - twist.wx * r.z,
            twist.vz + twist.wx * r.y - twist.wy * r.x,
        )
        straight = dot(outward, v)
        p = turned_back(last, minus(point, vector_at(last, 0)))
        true = dot(outward, minus(moved(now, p), point)) / rules[DT]
        least = row[LEAST] + straight - true
        lacking, changed = max(lacking, row[LEAST] - true), max(changed, abs(least - least_speeds[k, LEAST]))
        least_speeds[k, LEAST] = least
    return lacking, changed
