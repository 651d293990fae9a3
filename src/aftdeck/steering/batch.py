"""Closed-loop steering of many arms at once, each along a straight line to its own target.

Not modelled: profiles and limits of the point of resolution, joint stops, and slowing before singularities. Near a
singularity, the rate law replaces its divisor by a minimum value.
"""

from __future__ import annotations

import contextlib
import math
import os
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arrays import Array, floats_of
from aftdeck.errors import InputError
from aftdeck.frames import Pose
from aftdeck.kinematics.arm import Arm
from aftdeck.plain_values import number
from aftdeck.steering.blocks import FIELDS, LANES, LEFT, TARGET, WORK, steer_blocks
from aftdeck.steering.chain_batch import steer_chains
from aftdeck.units import short

_ROUNDING_MARGIN = 1.0 + 1e-15
"""Factor that keeps the fastest joint's rate, after rounding, at or below its limit [1]."""
_THREADED = 20_000
"""Least product of arms and steps for which a second thread saves more time than its start takes."""
LINE = 64
"""Length of a cache line [bytes]."""
_SHARES = 8
"""Number of shares of the blocks, divided by the number of threads. A thread on a busy processor computes fewer
shares."""
_ROTATION_TOLERANCE = 1e-6
"""Maximum deviation of a target's rotation matrix from an orthonormal matrix [1]."""


class Steered(NamedTuple):
    """State of the arms after the last step, and the remaining errors to their targets.

    Attributes:
        angles: (..., n) joint angles [rad].
        position_error: (..., 3) target position minus tip position, in L [m].
        rotation_error: (..., 3) axis of the remaining rotation times the sine of its angle, in L [1].
    """

    angles: Array
    position_error: Array
    rotation_error: Array


def pace_of(arm: Arm, period: float, gain: float) -> Array:
    """Return an array (2 + n,): control period, gain, and the reciprocal of each joint's rate limit (servo maximum).

    Raises:
        InputError: with this period or gain the arm would not move, or would move past the target.
    """
    period, gain = _positive(period, "period"), _positive(gain, "gain")
    if not 0.0 < gain * period <= 1.0:
        raise InputError(f"gain: got {gain:g}; gain times period ({period:g}) has to be above 0 and at most 1")
    return np.array([period, gain, *(_ROUNDING_MARGIN / arm.rate_limits)])


def steer_batch(
    arm: Arm,
    angles: ArrayLike,
    targets: Pose | ArrayLike,
    *,
    steps: int = 1,
    period: float,
    gain: float,
    fast: bool = False,
) -> Steered:
    """Steer many arms in closed loop, on every processor that this process may use.

    Args:
        arm: the arm; `angles` contains many states of this arm.
        angles: (..., n) joint angles [rad].
        targets: tip poses in L, one for each arm or one for all arms. Either a Pose, or an array (..., 12) of positions
            [m], each followed by the rotation row by row.
        steps: number of control steps.
        period: duration of a step [s].
        gain: ratio of the twist to the remaining distance and rotation [1/s].
        fast: whether to use fused products and sums, which save a tenth of the time. The last digits of the result then
            depend on the processor, and differ from those of one arm alone.

    Raises:
        InputError: an argument has the wrong shape, or values outside the allowed range.
    """
    pace = pace_of(arm, period, gain)
    count_of_steps = _steps(steps)
    start = _finite(angles, "joint angles", len(arm.joints))
    lead = start.shape[:-1]
    goal = _targets(targets, lead)
    count = start.size // start.shape[-1]
    if not arm.closed_form:
        end, left = np.array(start.reshape(count, -1)), np.empty((count, 6))
        steer_chains(arm.model.links, pace, end, np.ascontiguousarray(goal.reshape(count, 12)), left, count_of_steps)
        return Steered(end.reshape(start.shape), left[:, 3:].reshape(*lead, 3), left[:, :3].reshape(*lead, 3))
    blocks = _aligned(-(-count // LANES) * FIELDS * LANES).reshape(-1, FIELDS, LANES)
    _scatter(blocks[:, :TARGET], start.reshape(count, 6))
    _scatter(blocks[:, TARGET:LEFT], goal.reshape(count, 12))
    _fly(arm, pace, blocks.reshape(len(blocks), FIELDS * LANES), count_of_steps, bool(fast))
    end, left = _gathered(blocks[:, :TARGET], count), _gathered(blocks[:, LEFT:], count)
    return Steered(end.reshape(*lead, 6), left[:, 3:].reshape(*lead, 3), left[:, :3].reshape(*lead, 3))


def _positive(given: object, name: str) -> float:
    """Return a number above 0 as a float; raise InputError if it is anything else."""
    with contextlib.suppress(Exception):  # methods of a foreign object may raise anything
        if 0.0 < (value := number(given)) < math.inf:
            return value
    raise InputError(f"{name}: got {short(given)}, expected a number above 0")


def _steps(given: object) -> int:
    """Return a number of steps as an int; raise InputError if it is not a whole number, 0 or more."""
    with contextlib.suppress(Exception):  # methods of a foreign object may raise anything
        if (value := number(given)) >= 0.0 and value.is_integer():
            return int(value)
    raise InputError(f"steps: got {short(given)}, expected a whole number, 0 or more")


def _fly(arm: Arm, pace: Array, blocks: Array, steps: int, fast: bool) -> None:
    """Run `steer_blocks` with the blocks divided among threads. A thread that has finished a share takes the next."""
    links, pace_tuple = tuple(arm.model.links.tolist()), tuple(pace.tolist())
    workers = min(_processors(), len(blocks)) if len(blocks) * LANES * steps >= _THREADED else 1
    if workers <= 1:
        steer_blocks(links, pace_tuple, blocks, _aligned(WORK * LANES), steps, fast)
        return
    shares = min(_SHARES * workers, len(blocks))

    def share(cut: tuple[int, int]) -> None:
        steer_blocks(links, pace_tuple, blocks[slice(*cut)], _aligned(WORK * LANES), steps, fast)

    cuts = [len(blocks) * k // shares for k in range(shares + 1)]
    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(share, pairwise(cuts)))


def _aligned(count: int) -> Array:
    """Return an array of zeros that begins at a cache line, so that no vector instruction reads across two lines."""
    room = np.zeros(count + LINE // 8)
    skip = -room.ctypes.data % LINE // 8
    return room[skip : skip + count]


def _processors() -> int:
    """Return the number of processors that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _finite(values: ArrayLike, what: str, width: int) -> Array:
    """Return values as (..., width) floats; raise InputError if shape or values are wrong."""
    array = floats_of(values, what)
    if array.ndim == 0 or array.shape[-1] != width:
        raise InputError(f"{what}: expected shape (..., {width}), got {array.shape}")
    if not np.isfinite(array).all():
        raise InputError(f"{what}: expected finite numbers")
    return array


def _targets(targets: Pose | ArrayLike, lead: tuple[int, ...]) -> Array:
    """Return targets as (*lead, 12) floats; raise InputError if shape or values are wrong."""
    if isinstance(targets, Pose):
        position, rotation = _finite(targets.position, "positions", 3), _finite(targets.rotation, "rotations", 3)
        if rotation.shape != (*position.shape, 3):
            raise InputError(
                f"targets: got shapes {position.shape} and {rotation.shape}, expected (..., 3) and (..., 3, 3)"
            )
        targets = np.concatenate([position, rotation.reshape(*position.shape[:-1], 9)], axis=-1)
    array = _finite(targets, "targets", 12)
    x1, x2, x3, y1, y2, y3, z1, z2, z3 = np.ascontiguousarray(np.moveaxis(array[..., 3:], -1, 0))
    lengths = [x1 * x1 + x2 * x2 + x3 * x3 - 1.0, y1 * y1 + y2 * y2 + y3 * y3 - 1.0, x1 * y1 + x2 * y2 + x3 * y3]
    third = [x2 * y3 - x3 * y2 - z1, x3 * y1 - x1 * y3 - z2, x1 * y2 - x2 * y1 - z3]
    off = np.abs(lengths + third).max(initial=0.0)
    if off > _ROTATION_TOLERANCE:
        raise InputError(
            f"targets: a rotation is not a right-handed orthonormal matrix: deviation {off:.3g}, at most "
            f"{_ROTATION_TOLERANCE:g} allowed"
        )
    try:
        return np.broadcast_to(array, (*lead, 12))
    except ValueError:
        raise InputError(
            f"targets: expected the leading shape of the joint angles, {lead}, or one target for all arms, got "
            f"{array.shape[:-1]}"
        ) from None


def _scatter(fields: Array, rows: Array) -> None:
    """Write rows (n, k) into the lanes of fields (blocks, k, LANES); leave the remaining lanes unchanged."""
    whole, rest = divmod(len(rows), LANES)
    fields[:whole] = rows[: whole * LANES].reshape(whole, LANES, rows.shape[1]).swapaxes(1, 2)
    if rest:
        fields[whole, :, :rest] = rows[whole * LANES :].T


def _gathered(fields: Array, count: int) -> Array:
    """Return rows (count, k) read from the lanes of fields (blocks, k, LANES)."""
    return np.ascontiguousarray(fields.swapaxes(1, 2)).reshape(len(fields) * LANES, fields.shape[1])[:count]
