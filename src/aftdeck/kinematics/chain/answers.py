"""Posture of a packed chain, in one array, from which the general solver answers the steering's questions.

Laws call these functions and do not contain copies of them: arms with a closed form need none.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arms.chain import CHAIN, COUNT, EVEN, FOLLOW, HAND, JOINT, RANK, SCALE, WEIGHTS
from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE
from aftdeck.kinematics.chain.posture import place_joints, write_jacobian
from aftdeck.kinematics.chain.rates import Weighted, resolve, slope_of, weigh
from aftdeck.kinematics.jacobian import Rates, Twist
from aftdeck.kinematics.linkage import Tip
from aftdeck.law import large_law, law
from aftdeck.tuples import MOST_JOINTS

TIP = 0
"""(12,) pose of the tip in L."""
MATRIX = TIP + POSE
"""(6, n) Jacobian in L, row by row."""
LEFT = MATRIX + 6 * MOST_JOINTS
"""(6, k) left factors of the weighted Jacobian, as `rates.Weighted` has them."""
RIGHT = LEFT + 36
"""(n, k) right factors."""
VALUES = RIGHT + 6 * MOST_JOINTS
"""(k,) singular values."""
NEAR = VALUES + 6
"""Distance from a singularity, 0 to 1: the last singular value of the rank as a share of the first, divided by this
share in the best posture that was found when the arm was loaded."""
SLOPES = NEAR + 1
"""(n,) derivatives of this distance with respect to the joints' coordinates [1/rad or 1/m]."""
ANSWERS = SLOPES + MOST_JOINTS
"""Number of values."""


@law
def packed_of(arm: Array) -> Array:
    """Return the packed chain with which an arm's array, or the steering's rules, end."""
    return arm[arm.shape[0] - CHAIN :]


@law
def joints_of(packed: Array) -> Array:
    """Return the joints (n, 16) of a packed chain, as `posture` takes them."""
    count = int(packed[COUNT])
    return packed[: count * JOINT].reshape(count, JOINT)


@law
def follow_of(packed: Array, turning: float) -> Array:
    """Return the weights (6,) of a twist's components: of angular velocities `turning`, of velocities 1 per length."""
    follow = np.empty(6)
    for i in range(3):
        follow[i], follow[3 + i] = turning, 1.0 / packed[SCALE]
    return follow


@law
def place_tip(packed: Array, q: Rates, joints: Array, tip: Array) -> None:
    """Write the poses of the joints (n, 12) and of the tip (12,) in L at coordinates `q` [rad or m]."""
    place_joints(joints_of(packed), packed[HAND : HAND + POSE], q, joints, tip)


@law
def tip_of_row(row: Array) -> Tip:
    """Return a pose (12,) as the tip's pose."""
    return Tip(
        row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8], row[9], row[10], row[11]
    )  # fmt: skip


@large_law
def tip_at(arm: Array, q: Rates) -> Tip:
    """Return the tip's pose in L at coordinates `q`."""
    packed = packed_of(arm)
    joints, tip = np.empty((int(packed[COUNT]), POSE)), np.empty(POSE)
    place_tip(packed, q, joints, tip)
    return tip_of_row(tip)


@large_law
def answer(arm: Array, q: Rates) -> Array:
    """Return the posture (ANSWERS,) at coordinates `q` [rad or m].

    The distance from a singularity counts turning and moving alike, whatever the chain follows first.
    """
    packed, found = packed_of(arm), np.empty(ANSWERS)
    chain, count, rank = joints_of(packed), int(packed[COUNT]), int(packed[RANK])
    joints, tip, matrix = np.empty((count, POSE)), np.empty(POSE), np.empty((6, count))
    place_tip(packed, q, joints, tip)
    write_jacobian(chain, joints, tip, matrix)
    weights = packed[WEIGHTS : WEIGHTS + count]
    alike = weigh(matrix, weights, follow_of(packed, 1.0))
    w = alike if packed[FOLLOW] == 1.0 else weigh(matrix, weights, follow_of(packed, packed[FOLLOW]))
    for i in range(POSE):
        found[TIP + i] = tip[i]
    _keep(matrix, found, MATRIX)
    _keep(w.left, found, LEFT)
    _keep(w.right, found, RIGHT)
    for i in range(w.values.shape[0]):
        found[VALUES + i] = w.values[i]
    first, last = alike.values[0] * packed[EVEN], alike.values[rank - 1]
    found[NEAR] = min(last / first, 1.0) if first > 0.0 else 0.0
    for k in range(count):
        slope = 0.0
        if first > 0.0 and rank > 1:
            of_last = slope_of(chain, joints, tip, alike, rank - 1, k)
            slope = (of_last - found[NEAR] * packed[EVEN] * slope_of(chain, joints, tip, alike, 0, k)) / first
        found[SLOPES + k] = slope
    return found


@law
def _keep(matrix: Array, found: Array, at: int) -> None:
    """Copy a matrix row by row, from index `at` on."""
    rows, columns = matrix.shape
    for i in range(rows):
        for j in range(columns):
            found[at + i * columns + j] = matrix[i, j]


@large_law
def twist_of_rates(arm: Array, found: Array, rates: Rates) -> Twist:
    """Return the tip's twist in L at rates of the joints [rad/s or m/s]."""
    count, twist = int(packed_of(arm)[COUNT]), np.zeros(6)
    for i in range(6):
        for j in range(count):
            twist[i] += found[MATRIX + i * count + j] * rates[j]
    return Twist(twist[0], twist[1], twist[2], twist[3], twist[4], twist[5])


@large_law
def rates_of_twist(arm: Array, found: Array, twist: Twist, floor: float) -> Rates:
    """Return the rates of the joints [rad/s or m/s] for a twist of the tip in L, or for the part that they can make.

    `floor` is the distance from a singularity below which the rates grow no more [1].
    """
    packed, rates = packed_of(arm), np.zeros(MOST_JOINTS)
    count, rank = int(packed[COUNT]), int(packed[RANK])
    size = min(6, count)
    w = Weighted(
        found[LEFT : LEFT + 6 * size].reshape(6, size),
        found[RIGHT : RIGHT + count * size].reshape(count, size),
        found[VALUES : VALUES + size],
        packed[WEIGHTS : WEIGHTS + count],
        follow_of(packed, packed[FOLLOW]),
    )
    resolve(w, rank, twist, floor * packed[EVEN] * min(packed[FOLLOW], 1.0), rates[:count])
    return Rates(rates[0], rates[1], rates[2], rates[3], rates[4], rates[5], rates[6], rates[7])


@large_law
def change_of_distance(arm: Array, found: Array, rates: Rates) -> float:
    """Return the rate at which the distance from a singularity grows at rates of the joints [1/s]."""
    change = 0.0
    for k in range(int(packed_of(arm)[COUNT])):
        change += found[SLOPES + k] * rates[k]
    return change


@large_law
def freeing_joint(arm: Array, found: Array) -> int:
    """Return the joint whose motion changes the distance from a singularity most."""
    best = 0
    for k in range(int(packed_of(arm)[COUNT])):
        if abs(found[SLOPES + k]) > abs(found[SLOPES + best]):
            best = k
    return best
