"""Laws of bent parts: the motion of a part's end, and what it does to all frames behind it.

A *bend* has six numbers: displacement of the part's end [m], then its rotation vector [rad], both in the frame that
carries the part and relative to the straight part.
"""

from __future__ import annotations

import math

import numpy as np

from aftdeck.arrays import Array, Indices
from aftdeck.bodies.pose import POSE, compose, put_turn, relative
from aftdeck.elementary import atan2, sincos
from aftdeck.law import law

BEND = 6
"""Length of a bend."""


@law
def measure_bend(carrier: Array, beyond: Array, own: Array, end: Array, bend: Array) -> None:
    """Write the bend of a part.

    Args:
        carrier: (12,) pose of the frame that carries the part, in some frame.
        beyond: (12,) pose, in the same frame, of a body that is fixed to the part's end; its axes are those of
            `carrier` if the part is straight.
        own: (3,) place of the part's end in this body [m].
        end: (3,) place of the straight part's end in the carrying frame [m].
        bend: (6,) output.
    """
    at = np.empty(POSE)
    relative(carrier, beyond, at)
    for i in range(3):
        row = 3 + 3 * i
        bend[i] = at[i] + at[row] * own[0] + at[row + 1] * own[1] + at[row + 2] * own[2] - end[i]
    x, y, z = 0.5 * (at[10] - at[8]), 0.5 * (at[5] - at[9]), 0.5 * (at[6] - at[4])
    sine = math.sqrt(x * x + y * y + z * z)
    angle = atan2(sine, 0.5 * (at[3] + at[7] + at[11] - 1.0))
    scale = angle / sine if sine > 0.0 else 1.0
    bend[3], bend[4], bend[5] = scale * x, scale * y, scale * z


@law
def bend_frames(carriers: Indices, ends: Array, bends: Array, rows: Array, stand: int) -> None:
    """Move the frames of an unbent arm to where they are with bent parts.

    Args:
        carriers: (b,) frame that carries each part, from the base to the wrist.
        ends: (b, 3) place of each straight part's end in its frame [m].
        bends: (b, 6) bends.
        rows: (n, 12) poses of the arm's frames; changed.
        stand: index of the telescope's frame, which no part bends; -1 if the arm has none.
    """
    inner, outer, motion = np.empty(POSE), np.empty(POSE), np.empty(POSE)
    for part in range(len(carriers) - 1, -1, -1):  # the outermost first: the frames before it are still unbent
        carrier, end = carriers[part], ends[part]
        motion_of(bends[part], end, motion)
        for n in range(carrier + 1, len(rows)):
            if n == stand:
                continue
            relative(rows[carrier], rows[n], inner)
            compose(motion, inner, outer)
            compose(rows[carrier], outer, inner)
            rows[n] = inner


@law
def motion_of(bend: Array, end: Array, motion: Array) -> None:
    """Write the motion of all bodies behind a bent part as a pose (12,) in the frame that carries the part.

    It takes a body from its pose behind the straight part to its pose behind the bent one.

    Args:
        bend: (6,) bend.
        end: (3,) place of the straight part's end [m].
        motion: (12,) output.
    """
    x, y, z = bend[3], bend[4], bend[5]
    angle = math.sqrt(x * x + y * y + z * z)
    if angle > 0.0:
        x, y, z = x / angle, y / angle, z / angle
    s, c = sincos(angle)
    put_turn(x, y, z, s, c, motion)
    for i in range(3):
        row = 3 + 3 * i
        turned = motion[row] * end[0] + motion[row + 1] * end[1] + motion[row + 2] * end[2]
        motion[i] = end[i] + bend[i] - turned
