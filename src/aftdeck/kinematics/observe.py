"""Values of the arm that are observed in each step, computed in one compiled call: tip, twist, singularities."""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.kinematics.jacobian import Rates, erates, jacobi
from aftdeck.kinematics.linkage import sines, spin, tip
from aftdeck.kinematics.singular import distances
from aftdeck.law import law

OBSERVED = 21
"""Number of values: tip position (3), tip rotation (9, row by row), twist (6), distances from singularities (3)."""


@law
def observe(arm: Array, angles: Array, rates: Array, seen: Array) -> None:
    """Write tip, twist and singularities at angles (6,) [rad] and rates (6,) [rad/s], in L, into `seen` (21,).

    Source: JSC-12628, subroutines LNKAGE and ERATES.
    """
    a = sines(arm, angles[0], angles[1], angles[2], angles[3], angles[4], angles[5])
    t = tip(arm, a)
    for i in range(12):
        seen[i] = t[i]
    w = erates(a, jacobi(arm, a), Rates(rates[0], rates[1], rates[2], rates[3], rates[4], rates[5]))
    for i in range(6):
        seen[12 + i] = w[i]
    seen[18], seen[19], seen[20] = distances(arm, a)


@law
def observe_link(arm: Array, angles: Array, mount: Array, axes: Array) -> None:
    """Write LNKAGE's T_B5: the axes of the frame in which JACOBI gives its matrix.

    For the Shuttle's arm this is the wrist-pitch frame; for the concept arm it is the lower arm's frame.

    Args:
        arm: packed arm, as in `kinematics.linkage`.
        angles: (6,) joint angles [rad].
        mount: (3, 3) rotation that converts components in L to components in the orbiter's body axes.
        axes: (3, 3) output; the columns are the frame's axes in the orbiter's body axes.
    """
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
        arm: packed arm, as in `kinematics.linkage`.
        angles: (6,) joint angles [rad].
        rates: (6,) joint rates [rad/s].
        rising: rate at which the telescope extends, in the direction opposite to axis 3 of L [m/s].
        reach: (6, 2) reach limits [rad].
        threshold: distance below which a singularity is near [1].
        seen: (21,) output.
    """
    observe(arm, angles, rates, seen)
    seen[17] -= rising  # the telescope carries the whole arm
    near = False
    for i in range(6):
        near = near or not reach[i, 0] <= angles[i] <= reach[i, 1]
    for i in range(18, OBSERVED):
        near = near or abs(seen[i]) < threshold
    return near


CARRIED = 18
"""Number of values: payload's centre (3), payload's axes (9, row by row), point of resolution (3), its velocity (3)."""


@law
def observe_payload(seen: Array, payload: Array, carried: Array) -> None:
    """Write the values of a held payload in L (LNKAGE for PA = 1).

    Args:
        seen: (21,) observed values of the arm, from `observe`.
        payload: (15,) from `Payload.packed`.
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
