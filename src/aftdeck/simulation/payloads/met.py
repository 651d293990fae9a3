"""Share of the conditions that hold, of the present objective (`objective`), for an observer of the row.

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
from aftdeck.simulation.payloads.relations import approached
from aftdeck.simulation.row.aligning import DOCKING, GUIDES, Aligning
from aftdeck.simulation.row.world import MOST, MOST_ANGLE, ONLY_Y, World
from aftdeck.worksite.berths.berthing import OFFSET, STAY_CONDITIONS, guides_met, offsets, retained_met
from aftdeck.worksite.berths.docking import CONDITIONS as PORT_CONDITIONS
from aftdeck.worksite.berths.docking import FOUND, docking_met
from aftdeck.worksite.berths.on_way import NEAR as BERTH_NEAR
from aftdeck.worksite.capture.acquisition import AWAY, MEASURED, acquire, acquisition_met
from aftdeck.worksite.capture.acquisition import CONDITIONS as BAR_CONDITIONS
from aftdeck.worksite.capture.grapple import CONDITIONS as PIN_CONDITIONS
from aftdeck.worksite.capture.grapple import envelope_met
from aftdeck.worksite.capture.snares import fixture_in_effector
from aftdeck.worksite.watch.groups import PackedLayout
from aftdeck.worksite.watch.measured import Measured, place_bars
from aftdeck.worksite.watch.places import nearest_place


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
        if len(world.bars) > 0:
            return _bar_met(world, pairs, own)
        return _pin_met(world, aligning, frames)
    if shown[FIXED] != 0.0:
        return 0.0
    begin, end = world.berth_begins[held], world.berth_begins[held + 1]
    nearest = nearest_place(frames, world.rows[held], world.berths[begin:end], world.places[begin:end], BERTH_NEAR)
    berth = begin + nearest
    if nearest < 0 or shown[RELEASED] == berth:
        return 0.0
    met, number = berth_met(world, aligning, frames, held, berth)
    return float(met / (number + shown[TAKEN + berth]))


@law
def berth_met(world: World, aligning: Aligning, frames: Array, held: int, berth: int) -> tuple[int, int]:
    """Return how many conditions of a berth hold for the held payload, and their number."""
    port, payload = world.ports[berth], frames[world.rows[held]]
    if aligning.fits[berth] == DOCKING:
        found = np.empty(FOUND)
        approached(world, frames, held, berth, found)
        return docking_met(found, port[MOST], port[MOST_ANGLE], port[ONLY_Y] != 0.0), PORT_CONDITIONS
    place, left = np.empty(POSE), np.empty(POSE)
    compose(frames[world.berths[berth]], world.places[berth], place)
    relative(place, payload, left)
    if aligning.fits[berth] != GUIDES:
        return retained_met(left, port[MOST], port[MOST_ANGLE]), STAY_CONDITIONS
    t, u = aligning.guides[berth], aligning.guides[berth + 1]
    off, axes = np.empty((u - t, OFFSET)), aligning.axes[9 * t : 9 * u].reshape(u - t, 3, 3)
    offsets(frames[world.berths[berth]], payload, aligning.trunnions[t:u], aligning.seats[t:u], axes, off)
    met = guides_met(
        off, aligning.opening[t:u], aligning.throat[t:u], aligning.height[t:u], aligning.play[t:u], left, port[MOST],
        port[MOST_ANGLE],
    )  # fmt: skip
    return met, 2 * (u - t) + 1


@law
def _bar_met(world: World, pairs: PackedLayout, own: Measured) -> float:
    """Return the share of the conditions that hold at the bar nearest to the palm."""
    place_bars(pairs, own, world.bars)
    found, within, met = np.empty(MEASURED), NEAR, 0
    for k in range(len(world.bars)):
        if world.bars[k, 0] >= 0:
            acquire(own.placed, world.bars[k], world.tolerances, found)
            if found[AWAY] < within:
                within, met = found[AWAY], acquisition_met(found, world.tolerances)
    return met / BAR_CONDITIONS


@law
def _pin_met(world: World, aligning: Aligning, frames: Array) -> float:
    """Return the share of the conditions that hold at the pin nearest to the end effector."""
    within, met = NEAR, 0
    for k in range(len(world.fixtures)):
        if world.fixtures[k, 0] != world.fixtures[k, 0]:  # NaN: no fixture
            continue
        (out, y, z), turned = fixture_in_effector(
            frames, world.hand[0], world.effector, world.rows[k], world.fixtures[k]
        )
        away = sqrt(out * out + y * y + z * z)
        if away < within:
            within, met = away, envelope_met(aligning.envelope, out, y, z, turned)
    return met / PIN_CONDITIONS
