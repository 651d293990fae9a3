"""Conditions that hold, of the present objective (`objective`) and of a berth, from the row of a state.

The conditions and their ranges are those of the end effectors and berths (`worksite.capture`, `worksite.berths`).
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, relative
from aftdeck.law import law
from aftdeck.simulation.parts.shown import FIXED, RELEASED, TAKEN
from aftdeck.simulation.payloads.grasp import NEAR
from aftdeck.simulation.payloads.relations import approached, berth_near
from aftdeck.simulation.row.aligning import DOCKING, GUIDES, Aligning
from aftdeck.simulation.row.world import MOST, MOST_ANGLE, ONLY_Y, World
from aftdeck.worksite.berths.berthing import OFFSET, guides_met, offsets, retained_values
from aftdeck.worksite.berths.docking import FOUND, docking_values
from aftdeck.worksite.capture.acquisition import AWAY, MEASURED, acquire, acquisition_values
from aftdeck.worksite.capture.grapple import envelope_values
from aftdeck.worksite.capture.snares import fixture_in_effector
from aftdeck.worksite.watch.groups import PackedLayout
from aftdeck.worksite.watch.measured import Measured, place_bars
from aftdeck.worksite.within import number_that_hold


@law
def share_met(
    world: World, aligning: Aligning, pairs: PackedLayout, own: Measured, frames: Array, held: int, shown: Array
) -> float:
    """Return the share of the conditions of the present objective that hold; 0 without an objective.

    Args:
        world: constants of the run.
        aligning: constants of alignment.
        pairs: the monitored pairs.
        own: the clearance monitor, which places the solids of bars.
        frames: (F, 12) poses of all frames in L.
        held: index of the payload in the grasp; -1 for none.
        shown: values that `parts.shown` describes.
    """
    if held < 0:
        return _bar_met(world, pairs, own) if len(world.bars) > 0 else pin_met(world, aligning, frames, NEAR)
    berth = berth_near(world, frames, held)
    if shown[FIXED] != 0.0 or berth < 0 or shown[RELEASED] == berth:
        return 0.0
    number, of = berth_met(world, aligning, frames, held, berth)
    return float(number / (of + shown[TAKEN + berth]))


@law
def berth_holds(world: World, aligning: Aligning, frames: Array, held: int, berth: int) -> bool:
    """Return whether all conditions of a berth hold for the held payload, if no other payload is in it."""
    number, of = berth_met(world, aligning, frames, held, berth)
    return number == of


@law
def berth_met(world: World, aligning: Aligning, frames: Array, held: int, berth: int) -> tuple[int, int]:
    """Return how many conditions of a berth hold for the held payload, and their number."""
    port, payload = world.ports[berth], frames[world.rows[held]]
    if aligning.fits[berth] == DOCKING:
        found = np.empty(FOUND)
        approached(world, frames, held, berth, found)
        docking = docking_values(found, port[MOST], port[MOST_ANGLE], port[ONLY_Y] != 0.0)
        return number_that_hold(docking), len(docking)
    place, left = np.empty(POSE), np.empty(POSE)
    compose(frames[world.berths[berth]], world.places[berth], place)
    relative(place, payload, left)
    if aligning.fits[berth] != GUIDES:
        retained = retained_values(left, port[MOST], port[MOST_ANGLE])
        return number_that_hold(retained), len(retained)
    t, u = aligning.guides[berth], aligning.guides[berth + 1]
    off, axes = np.empty((u - t, OFFSET)), aligning.axes[9 * t : 9 * u].reshape(u - t, 3, 3)
    offsets(frames[world.berths[berth]], payload, aligning.trunnions[t:u], aligning.seats[t:u], axes, off)
    number = guides_met(
        off, aligning.opening[t:u], aligning.throat[t:u], aligning.height[t:u], aligning.play[t:u], left, port[MOST],
        port[MOST_ANGLE],
    )  # fmt: skip
    return number, 2 * (u - t) + 1


@law
def _bar_met(world: World, pairs: PackedLayout, own: Measured) -> float:
    """Return the share of the conditions that hold at the bar nearest to the palm; 0 if none is within `NEAR`."""
    place_bars(pairs, own, world.bars)
    found, within, share = np.empty(MEASURED), NEAR, 0.0
    for k in range(len(world.bars)):
        if world.bars[k, 0] >= 0:
            acquire(own.placed, world.bars[k], world.tolerances, found)
            if found[AWAY] < within:
                values = acquisition_values(found, world.tolerances)
                within, share = found[AWAY], number_that_hold(values) / len(values)
    return share


@law
def pin_met(world: World, aligning: Aligning, frames: Array, within: float) -> float:
    """Return the share of the conditions that hold at the pin nearest to the end effector; 0 if none is within [m]."""
    share = 0.0
    for k in range(len(world.fixtures)):
        if world.fixtures[k, 0] != world.fixtures[k, 0]:  # NaN: no fixture
            continue
        (out, y, z), turned = fixture_in_effector(
            frames, world.hand[0], world.effector, world.rows[k], world.fixtures[k]
        )
        away = sqrt(out * out + y * y + z * z)
        if away < within:
            values = envelope_values(aligning.envelope, out, y, z, turned)
            within, share = away, number_that_hold(values) / len(values)
    return share
