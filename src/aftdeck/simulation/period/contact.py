"""Contacts in a control period: poses of all frames, clearances, and the inhibits that contacts cause."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pair import PAIR
from aftdeck.law import large_law, law
from aftdeck.simulation.payloads.relations import permit
from aftdeck.simulation.row.aligning import aligning_of
from aftdeck.simulation.row.now import Flat, monitor_of, motion_of, watch_of
from aftdeck.simulation.row.scalars import (
    ARM,
    CHANGED,
    FINGER,
    HELD,
    INHIBITS,
    LEAST,
    NEAREST,
    PRONG_AT,
    SLIDES,
    STAND,
    TASK,
    TOUCHING,
    WITHIN,
)
from aftdeck.simulation.row.world import pairs_of, world_of
from aftdeck.worksite.watch.clearance_monitor import measure_groups
from aftdeck.worksite.watch.contacts import count_frame, two_frames
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.measured import lower_bound, measure_group, travelled
from aftdeck.worksite.watch.places import place_everything

LOOSE = 0.25
"""Bound of a clearance below which the clearance is measured again [m] (assumed)."""


@law
def seen(flat: Flat, true: Array) -> None:
    """Place all frames, measure the clearances and count the contacts; write the results into the scalars.

    `true` (f, 12) are the poses of the arm's frames in L; (0, 12) if they follow from the joint angles.
    """
    placed(flat, true)
    measured(flat, world_of(flat).constants[WITHIN])


@large_law
def placed(flat: Flat, true: Array) -> None:
    """Place all frames after a motion; `true` as for `seen`."""
    now, watch = motion_of(flat), watch_of(flat)
    watch.monitored_before[:] = watch.active
    now.before[:] = now.frames
    place(flat, now.angles, now.scalars[STAND], now.scalars[PRONG_AT], true, now.frames)


@large_law
def place(flat: Flat, angles: Array, stand: float, prong: float, true: Array, frames: Array) -> None:
    """Compute the poses of all frames, `frames` (F, 12), for joint angles (n,) and positions of telescope and prong.

    Everything else is as in the row; `true` as for `seen`.
    """
    world, now = world_of(flat), motion_of(flat)
    place_everything(
        world.joints, world.scene, world.axes, now.orbiter, now.carrier, now.poses_in_carrier, angles, stand,
        prong, true, now.base, frames,
    )  # fmt: skip


@large_law
def measured(flat: Flat, within: float) -> None:
    """Measure the clearances below `within` [m] and count the contacts; write the results into the scalars."""
    now, watch = motion_of(flat), watch_of(flat)
    v, own = now.scalars, monitor_of(watch)
    every = measure_groups(pairs_of(flat), own, watch.active, watch.counts, now.frames, within)
    touching, changed, groups = False, False, len(watch.near)
    least, nearest, minimum = np.inf, -1, np.inf
    for m in range(groups if every else own.listed[groups]):
        g = m if every else own.listed[m]
        changed = count_frame(watch.found, watch.near, watch.frames_touching, g) or changed
        touching = touching or watch.frames_touching[g] != 0
        if watch.near[g] != 0:
            clearance = watch.found[g, CLEARANCE]
            least = min(least, clearance)
            if watch.counts[g] != 0 and clearance < minimum:
                nearest, minimum = g, clearance
    v[TOUCHING], v[CHANGED] = 1.0 if touching else 0.0, 1.0 if changed else 0.0
    v[LEAST], v[NEAREST] = least, nearest


@law
def bounded(flat: Flat) -> float:
    """Return a lower bound of the clearances of all monitored pairs at the poses in `Watch.at` [m].

    It is -inf if a clearance was measured: then contacts have to be counted in the next step. Pairs with bounds below
    `LOOSE` are measured again, because a bound decreases with each motion of a part.
    """
    least: float = np.inf
    pairs, watch = pairs_of(flat), watch_of(flat)
    own, measures = monitor_of(watch), np.empty(PAIR)
    for g in range(len(watch.active)):
        if watch.near[g] != 0 or watch.frames_touching[g] != 0:
            return -np.inf
    for g in range(len(watch.active)):
        if watch.active[g] != 0:
            if lower_bound(pairs, own, g) < LOOSE:
                measure_group(pairs, own, g, measures)
            least = min(least, lower_bound(pairs, own, g))
    return least


@law
def still_clear(flat: Flat, bound: float, within: float) -> bool:
    """Return whether no clearance is below `within` [m], because all parts have moved too little since `bounded`.

    If so, the scalars and the measurements are those of a step without a pair that is near.
    """
    if bound < within:
        return False
    frames = motion_of(flat).frames
    travel, most = np.empty(len(frames)), 0.0
    travelled(frames, watch_of(flat).at, pairs_of(flat).reach, travel)
    for f in range(len(travel)):
        most = max(most, travel[f])
    return bool(bound - 2.0 * most >= within)


@large_law
def judged(flat: Flat, pressed: bool) -> None:
    """Find the contacts that the task permits, and write the inhibits that the others cause.

    `pressed`: whether forces between parts acted in this step, so that parts which are apart now may have touched.
    """
    world, now, watch = world_of(flat), motion_of(flat), watch_of(flat)
    v = now.scalars
    if pressed or v[TOUCHING] != 0.0 or v[CHANGED] != 0.0:
        permit(world, aligning_of(flat), pairs_of(flat), monitor_of(watch), now.frames, watch.permitted)
        held, slides = int(v[HELD]), v[SLIDES] != 0.0
        for g in range(len(watch.permitted)):
            watch.essential[g] = watch.permitted[g] | world.slides[held, g] if slides else watch.permitted[g]
    v[ARM] = v[FINGER] = 0.0
    if v[TOUCHING] != 0.0 and world.constants[INHIBITS] != 0.0:
        arm, finger = two_frames(watch.frames_touching, watch.essential, watch.arm, world.by_prong, int(v[TASK]))
        v[ARM], v[FINGER] = 1.0 if arm else 0.0, 1.0 if finger else 0.0
