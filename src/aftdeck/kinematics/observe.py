"""Values of the arm that are observed in each step, computed in one compiled call: tip, twist, singularities."""

from __future__ import annotations

from aftdeck.arms.geometry import GENERAL
from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import jacobi, of_array
from aftdeck.kinematics.linkage import WRIST, sines, spin
from aftdeck.kinematics.solver import distance, number_of_singularities, posture, tip_of, twist_of
from aftdeck.law import law

SEEN = 18
"""Number of values besides the distances from singularities: tip position (3), tip rotation (9, row by row), twist (6).

The distances follow: three with a closed form, one with the general solver.
"""


@law
def observe(arm: Array, angles: Array, rates: Array, seen: Array) -> None:
    """Write tip, twist and singularities at angles (n,) [rad] and rates (n,) [rad/s], in L, into `seen` (18 + s,).

    Source: JSC-12628, subroutines LNKAGE and ERATES.
    """
    p = posture(arm, of_array(angles))
    t = tip_of(arm, p)
    for i in range(12):
        seen[i] = t[i]
    w = twist_of(arm, p, of_array(rates))
    for i in range(6):
        seen[12 + i] = w[i]
    for i in range(number_of_singularities(arm)):
        seen[SEEN + i] = distance(arm, p, i)


@law
def observe_link(arm: Array, angles: Array, mount: Array, axes: Array) -> None:
    """Write LNKAGE's T_B5: the axes of the frame in which JACOBI gives its matrix.

    For the Shuttle's arm this is the wrist-pitch frame; for the concept arm it is the lower arm's frame. An arm without
    a closed form has no such frame; the axes are those of L.

    Args:
        arm: the arm's links.
        angles: (n,) joint angles [rad].
        mount: (3, 3) rotation that converts components in L to components in the orbiter's body axes.
        axes: (3, 3) output; the columns are the frame's axes in the orbiter's body axes.
    """
    if arm[WRIST] == GENERAL:
        for row in range(3):
            for column in range(3):
                axes[row, column] = mount[row, column]
        return
    a = sines(arm, angles[0], angles[1], angles[2], angles[3], angles[4], angles[5])
    j = jacobi(arm, a)
    for column in range(3):
        along, out, up = 1.0 if column == 0 else 0.0, 1.0 if column == 1 else 0.0, 1.0 if column == 2 else 0.0
        x, y, z = spin(a, j.s, j.c, along, out, up)
        for row in range(3):
            axes[row, column] = mount[row, 0] * x + mount[row, 1] * y + mount[row, 2] * z


@law
def observe_near(
    arm: Array, angles: Array, rates: Array, rising: float, reach: Array, threshold: float, seen: Array
) -> bool:
    """Observe an arm on its telescope; return whether a joint is past its reach limits or a singularity is near.

    Args:
        arm: the arm's links.
        angles: (n,) joint angles [rad].
        rates: (n,) joint rates [rad/s].
        rising: rate at which the telescope extends, in the direction opposite to axis 3 of L [m/s].
        reach: (n, 2) reach limits [rad].
        threshold: distance below which a singularity is near [1].
        seen: (18 + s,) output, as in `observe`.
    """
    observe(arm, angles, rates, seen)
    seen[17] -= rising  # the telescope carries the whole arm
    near = False
    for i in range(reach.shape[0]):
        near = near or not reach[i, 0] <= angles[i] <= reach[i, 1]
    for i in range(SEEN, seen.shape[0]):
        near = near or abs(seen[i]) < threshold
    return near


CARRIED = 18
"""Number of values: payload's centre (3), payload's axes (9, row by row), point of resolution (3), its velocity (3)."""


@law
def observe_payload(seen: Array, payload: Array, carried: Array) -> None:
    """Write the values of a held payload in L (LNKAGE for PA = 1).

    Args:
        seen: (18 + s,) observed values of the arm, from `observe`.
        payload: (15,) from `HeldPayload.packed`.
        carried: (18,) output.
    """
    for i in range(3):
        for j in range(3):
            carried[3 + 3 * i + j] = (
                seen[3 + 3 * i] * payload[j] + seen[4 + 3 * i] * payload[3 + j] + seen[5 + 3 * i] * payload[6 + j]
            )
    for i in range(3):
        x, y, z = carried[3 + 3 * i], carried[4 + 3 * i], carried[5 + 3 * i]
        carried[i] = seen[i] + x * payload[9] + y * payload[10] + z * payload[11]
        carried[12 + i] = carried[i] + x * payload[12] + y * payload[13] + z * payload[14]
    x, y, z = carried[12] - seen[0], carried[13] - seen[1], carried[14] - seen[2]
    carried[15] = seen[15] + seen[13] * z - seen[14] * y
    carried[16] = seen[16] + seen[14] * x - seen[12] * z
    carried[17] = seen[17] + seen[12] * y - seen[13] * x
