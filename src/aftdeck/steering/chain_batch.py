"""Closed-loop steps of many arms without a closed form, as `steering.blocks` makes them for arms with one."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Twist, of_array
from aftdeck.kinematics.linkage import Nine, Tip
from aftdeck.kinematics.solver import posture, rates_of, tip_at, tip_of
from aftdeck.law import law
from aftdeck.steering.blocks import GAIN, PER_RATE, PERIOD, remaining_distance, remaining_rotation
from aftdeck.steering.msteer import NEAR_FLOOR


@law
def _error(t: Tip, target: Array) -> Twist:
    """Return the remaining error to a target (12,), as `blocks.remaining_rotation` and `remaining_distance` do."""
    axes: Nine = (t.r11, t.r12, t.r13, t.r21, t.r22, t.r23, t.r31, t.r32, t.r33)
    wx, wy, wz = remaining_rotation(axes, target)
    vx, vy, vz = remaining_distance((t.x, t.y, t.z), target)
    return Twist(wx, wy, wz, vx, vy, vz)


@law
def steer_chains(arm: Array, pace: Array, angles: Array, targets: Array, left: Array, steps: int) -> None:
    """Make many steps of many arms.

    Args:
        arm: the arm's links.
        pace: the values of `batch.pace_of`.
        angles: (m, n) coordinates of the joints [rad or m]; changed in place.
        targets: (m, 12) targets.
        left: (m, 6) output: remaining errors, rotation first.
        steps: number of control periods.
    """
    for i in range(angles.shape[0]):
        q, target = angles[i], targets[i]
        for _ in range(steps):
            p = posture(arm, of_array(q))
            rates, fastest = rates_of(arm, p, _error(tip_of(arm, p), target), NEAR_FLOOR), 0.0
            for k in range(q.shape[0]):
                fastest = max(fastest, abs(rates[k]) * pace[PER_RATE + k])
            share = pace[GAIN] * pace[PERIOD] / max(1.0, pace[GAIN] * fastest)
            for k in range(q.shape[0]):
                q[k] += share * rates[k]
        error = _error(tip_at(arm, of_array(q)), target)
        for k in range(6):
            left[i, k] = error[k]
