"""Observation of Capture, Extract and Dock from the row of a state: numbers that an operator also has.

`definition.observations` defines these numbers as readings of a frame; here they need no frame.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array, Flags
from aftdeck.bodies.placed import Place, along_axes, matrix_product, transposed, twist_along
from aftdeck.bodies.pose import POSE, relative, rows, vec3
from aftdeck.gym.mission.aim import HAND, MOUNT, Left, left
from aftdeck.gym.mission.score import ABOVE, AIMS, ANGLE, CONTACT, DISTANCE, MET
from aftdeck.gym.terms import Floats32
from aftdeck.kinematics.observe import CARRIED, observe_payload
from aftdeck.law import large_law, law
from aftdeck.lent import lend
from aftdeck.simulation.observe.frame_numbers import six
from aftdeck.simulation.parts.shown import (
    ATTACHED,
    AXES,
    COARSE,
    EFFECTOR,
    HELD,
    LOADED,
    LOGGED,
    MIXED,
    PACKED,
    PAYLOAD,
    SWITCH,
    TAKEN,
)
from aftdeck.simulation.payloads.met import share_met
from aftdeck.simulation.period.many import Constants, Rows, row_of
from aftdeck.simulation.row.aligning import aligning_of
from aftdeck.simulation.row.now import Arrays, Flat, Motion, Watch, lent, monitor_of, motion_of, watch_of
from aftdeck.simulation.row.scalars import ARM, NEAREST, PRONG_AT, PRONG_HIGH, PRONG_LOW
from aftdeck.simulation.row.world import World, pairs_of, world_of
from aftdeck.tuples import Rows as Turn
from aftdeck.tuples import Six, Vec3
from aftdeck.units import FOOT
from aftdeck.worksite.capture.snare import RING
from aftdeck.worksite.watch.found import CLEARANCE


class Scale(NamedTuple):
    """Scale of the observations, arrays (n,): (value - zero) / one, within the limits `low` and `high`."""

    zero: Array
    one: Array
    low: Array
    high: Array


@law
def observe_all(
    constants: Constants,
    rows: Rows,
    shown: Array,
    aim: Array,
    scale: tuple[Array, Array, Array, Array],
    chosen: Flags,
    observations: Floats32,
    scored: Array,
) -> None:
    """Write observations of states, and what their rewards need.

    Args:
        constants: constants of the run.
        rows: rows of n states.
        shown: (n, s) values that `parts.shown` describes.
        aim: result of `aim.aim_of`.
        scale: the arrays of a `Scale`.
        chosen: (n,) whether a state is observed.
        observations: (n, m) output.
        scored: (n, 6) output, rows as `score` describes them.
    """
    lent_scale = _lent_scale(scale)
    for i in range(len(chosen)):
        if chosen[i]:
            _observe(
                row_of(constants, rows, i), lend(shown[i]), lend(aim), lent_scale, observations[i], lend(scored[i])
            )


@law
def observe_one(
    arrays: Arrays,
    shown: Array,
    aim: Array,
    scale: tuple[Array, Array, Array, Array],
    observation: Floats32,
    scored: Array,
) -> None:
    """Write the observation of one state, and what its reward needs; arguments as for `observe_all`."""
    _observe(lent(arrays), lend(shown), lend(aim), _lent_scale(scale), observation, lend(scored))


@law
def _lent_scale(scale: tuple[Array, Array, Array, Array]) -> Scale:
    """Return a scale for as long as a call takes."""
    zero, one, low, high = scale
    return Scale(lend(zero), lend(one), lend(low), lend(high))


@large_law
def _observe(flat: Flat, shown: Array, aim: Array, scale: Scale, observation: Floats32, scored: Array) -> None:
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    held, seen, joints = int(shown[HELD]), now.observed, len(now.angles)
    tip: Place = (vec3(seen, 0), rows(seen, 3))
    payload = (vec3(now.frames[world.rows[held]], 0), rows(now.frames[world.rows[held]], 3)) if held >= 0 else tip
    to_go = left(aim, now.frames, tip, payload, held)
    centre, axes = _in_grasp(world, now.frames, shown, seen, tip)
    point, twist = _resolution(shown, tip[0], centre, six(seen, 12))
    moving, turning = _axes(shown, aim, tip[1], axes)
    velocity, rate = twist_along(twist, moving, turning)
    move, turn = _along(to_go, point, moving, turning)
    values = np.empty(len(observation))
    _put(values, 0, move)
    _put(values, 3, turn)
    _put(values, 6, velocity)
    _put(values, 9, rate)
    for i in range(joints):
        values[12 + i], values[12 + joints + i] = now.angles[i], now.rates[i]
    rest = 12 + 2 * joints
    met = share_met(world, aligning_of(flat), pairs_of(flat), monitor_of(watch), now.frames, held, shown)
    values[rest], values[rest + 1] = _clearance(now, watch), 1.0 if now.scalars[ARM] != 0.0 else 0.0
    values[rest + 2], values[rest + 3], values[rest + 4] = met, shown[COARSE], shown[SWITCH]
    values[rest + 5] = _opening(world, now)
    for i in range(len(values)):
        observation[i] = min(max((values[i] - scale.zero[i]) / scale.one[i], scale.low[i]), scale.high[i])
    scored[AIMS], scored[DISTANCE], scored[ANGLE], scored[ABOVE] = to_go.known, to_go.distance, to_go.angle, to_go.above
    scored[MET], scored[CONTACT] = met, _detrimental(shown[LOGGED] != 0.0, watch)


@law
def _along(to_go: Left, point: Vec3, moving: Turn, turning: Turn) -> tuple[Vec3, Vec3]:
    """Return the remaining motion along the sticks' axes: displacement [m], rotation vector [rad]; 0 for no place."""
    p, r = to_go.motion
    move, turn = along_axes(p, r, point, moving, turning)
    none = (0.0, 0.0, 0.0)
    return (move, turn) if to_go.known else (none, none)


@law
def _in_grasp(world: World, frames: Array, shown: Array, seen: Array, tip: Place) -> Place:
    """Return point of resolution and axes of the payload in the grasp; without one, those of the tip.

    The tip is where the joint angles put it; with masses, the payload's pose in the end effector is that of the bodies.
    """
    held, carried, packed = int(shown[HELD]), np.empty(CARRIED), np.zeros(TAKEN - PACKED)
    if held < 0 and shown[ATTACHED] == 0.0:
        return tip
    if held < 0:
        packed[:] = shown[PACKED:TAKEN]
    else:
        _pack(world, frames[world.hand[0]], frames[world.rows[held]], packed)
    observe_payload(seen, packed, carried)
    return vec3(carried, 12), rows(carried, 3)


@law
def _pack(world: World, hand: Array, payload: Array, packed: Array) -> None:
    """Write a payload in the grasp as `HeldPayload.packed` has it, from the poses (12,) of last joint and payload."""
    tip, grasp, inside = np.zeros(POSE), np.empty(POSE), np.empty(POSE)
    tip[3] = tip[7] = tip[11] = 1.0
    tip[:3] = world.effector[:3]
    relative(hand, payload, grasp)
    relative(tip, grasp, inside)
    packed[:9] = inside[3:]
    for i in range(3):
        packed[9 + i] = inside[3 + i] * inside[0] + inside[6 + i] * inside[1] + inside[9 + i] * inside[2]


@law
def _resolution(shown: Array, tip: Vec3, centre: Vec3, twist: Six) -> tuple[Vec3, Six]:
    """Return the point that the sticks move, and its twist: those of the tip, or of the payload in the grasp."""
    if shown[LOADED] == 0.0:
        return tip, twist
    p, q, r, u, v, w = twist
    x, y, z = centre[0] - tip[0], centre[1] - tip[1], centre[2] - tip[2]
    return centre, (p, q, r, u + q * z - r * y, v + r * x - p * z, w + p * y - q * x)


@law
def _axes(shown: Array, aim: Array, tip: Turn, payload: Turn) -> tuple[Turn, Turn]:
    """Return the axes of the THC and of the RHC, in columns, in L (`scene.stick_axes`)."""
    mount = rows(aim, MOUNT)
    to_l = transposed(mount)
    if shown[AXES] == EFFECTOR:
        axes = matrix_product(to_l, matrix_product(mount, matrix_product(tip, rows(aim, HAND))))
        return axes, axes
    if shown[AXES] == PAYLOAD:
        axes = matrix_product(to_l, matrix_product(mount, payload))
        return axes, axes
    return to_l, payload if shown[AXES] == MIXED else to_l


@law
def _clearance(now: Motion, watch: Watch) -> float:
    """Return the minimum clearance c as c / (c + 1 ft); 1 without a pair."""
    nearest = int(now.scalars[NEAREST])
    if nearest < 0:
        return 1.0
    distance = max(watch.found[nearest, CLEARANCE], 0.0)
    return float(distance / (distance + FOOT))


@law
def _opening(world: World, now: Motion) -> float:
    """Return the share by which prong or snares are open."""
    low, high = world.constants[PRONG_LOW], world.constants[PRONG_HIGH]
    return float(1.0 - now.snare[RING] if low == high else (high - now.scalars[PRONG_AT]) / (high - low))


@law
def _detrimental(logged: bool, watch: Watch) -> bool:
    """Return whether a contact exists that does not belong to the task; `logged`: whether any is in the log."""
    found = False
    if logged:
        for g in range(len(watch.frames_touching)):
            found = found or (watch.frames_touching[g] != 0 and watch.essential[g] == 0)
    return found


@law
def _put(values: Array, at: int, given: Vec3) -> None:
    """Write three values into an array."""
    values[at], values[at + 1], values[at + 2] = given
