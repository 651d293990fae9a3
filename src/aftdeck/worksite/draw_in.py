"""Drawing in: the decrease of a misalignment to zero while a mechanism pulls a body into its seated pose.

Both the end effector's carriage and a retention latch draw a body in. Not modelled: forces, and deformation.
"""

from __future__ import annotations

from math import sqrt

from aftdeck.arrays import Array
from aftdeck.elementary import atan2, sincos
from aftdeck.law import law
from aftdeck.quaternions import scaled_quaternion


@law
def remaining(whole: Array, fraction: float, out: Array) -> None:
    """Compute a fraction of a misalignment.

    The offset and the angle of the rotation are multiplied by the fraction. The axis of the rotation does not change.

    Args:
        whole: (12,) the whole misalignment: pose of the body relative to its seated pose [m]. A seated body has zero
            offset and no rotation.
        fraction: 1 for the whole misalignment, 0 for none.
        out: (12,) output: the remaining misalignment, as a pose.
    """
    r = whole[3:]
    w, x, y, z, _ = scaled_quaternion(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8])
    size = sqrt(x * x + y * y + z * z)
    half = fraction * (atan2(size, w) if w >= 0.0 else -atan2(size, -w))
    s, c = sincos(half)
    per = s / size if size > 0.0 else 0.0
    w, x, y, z = c, per * x, per * y, per * z
    for k in range(3):
        out[k] = fraction * whole[k]
    out[3], out[4], out[5] = 1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)
    out[6], out[7], out[8] = 2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)
    out[9], out[10], out[11] = 2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)
