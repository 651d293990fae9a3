"""Drawing in: a misalignment that goes to nothing while a mechanism pulls a body into its seat.

Both the end effector's carriage and a retention latch do so. Not modelled: forces, and what gives way to them.
"""

from __future__ import annotations

from math import atan2, cos, sin, sqrt

import numpy as np
from numpy.typing import NDArray

from aftdeck.law import law

Array = NDArray[np.float64]


@law
def remaining(whole: Array, fraction: float, out: Array) -> None:
    """What is left of a misalignment: that fraction of its offset, and of its turn about the turn's own axis.

    Args:
        whole: (12,) pose of the body in its seat's frame [m]; no turn when it is seated.
        fraction: 1 all of it, 0 nothing.
        out: (12,) what is left.
    """
    a, b, c, d, e, f, g, h, i = (
        whole[3],
        whole[4],
        whole[5],
        whole[6],
        whole[7],
        whole[8],
        whole[9],
        whole[10],
        whole[11],
    )
    # a quaternion but for its length, by its largest part
    w, x, y, z = 1.0 + a + e + i, h - f, c - g, d - b
    if 1.0 + a - e - i > w and a >= e and a >= i:
        w, x, y, z = h - f, 1.0 + a - e - i, d + b, c + g
    elif 1.0 - a + e - i > w and e >= i:
        w, x, y, z = c - g, d + b, 1.0 - a + e - i, f + h
    elif 1.0 - a - e + i > w:
        w, x, y, z = d - b, c + g, f + h, 1.0 - a - e + i
    size, turn = sqrt(x * x + y * y + z * z), 0.0
    if size > 0.0:
        half = fraction * (atan2(size, w) if w >= 0.0 else -atan2(size, -w))
        w, turn = cos(half), sin(half) / size
    else:
        w = 1.0
    x, y, z = x * turn, y * turn, z * turn
    for k in range(3):
        out[k] = fraction * whole[k]
    out[3], out[4], out[5] = 1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)
    out[6], out[7], out[8] = 2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)
    out[9], out[10], out[11] = 2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)
