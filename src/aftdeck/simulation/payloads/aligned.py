"""Parts that are aligned: a straight motion over the remaining distance would bring them into a permitted contact.

The end effector is aligned with a payload, a probe with a port, or trunnions with their guides.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.law import law
from aftdeck.simulation.row.aligning import DOCKING, GUIDES, Aligning
from aftdeck.simulation.row.world import ENVELOPE, MOST, PORT, TIP, World
from aftdeck.worksite.berths.berthing import OFFSET, offsets, over
from aftdeck.worksite.berths.on_way import NEAR, straight_before
from aftdeck.worksite.capture.acquisition import enclosed_bar
from aftdeck.worksite.capture.grapple import around_axis
from aftdeck.worksite.capture.snares import WIDER, WIDEST, fixture_in_effector


@law
def aligned_payload(world: World, aligning: Aligning, placed: Array, frames: Array, before: int) -> int:
    """Return the payload with which the empty end effector is aligned for capture; -1 for none.

    Its bar is in front of the palm and between the fingers; or its pin is aligned with the snares in position and
    attitude, within a wider range if they were aligned `before`.
    """
    if len(world.bars) > 0:
        return enclosed_bar(placed, world.bars, world.tolerances, NEAR)
    for k in range(len(world.fixtures)):
        if world.fixtures[k, 0] != world.fixtures[k, 0]:  # NaN: no fixture
            continue
        (out, y, z), turned = fixture_in_effector(
            frames, world.hand[0], world.effector, world.rows[k], world.fixtures[k]
        )
        if abs(out) <= NEAR and around_axis(aligning.envelope, y, z, turned, WIDEST if k == before else WIDER):
            return k
    return -1


@law
def is_aligned(
    world: World, aligning: Aligning, frames: Array, k: int, relation: int, depth: float, inside: float
) -> bool:
    """Return whether payload k and a berth would touch in a permitted relative position after a straight approach.

    Args:
        world: constants of the run.
        aligning: constants of alignment.
        frames: (F, 12) poses of all frames in L.
        k: the payload.
        relation: number of the relation.
        depth: permitted penetration depth [m].
        inside: least distance from the limits of the conditions after the approach [m]: `depth` if the pair with the
            last minimum clearance has this payload and this relation, which keeps the lamp from flickering.
    """
    payload = frames[world.rows[k]]
    for b in range(world.berth_begins[k], world.berth_begins[k + 1]):
        if aligning.fits[b] != relation:
            continue
        berth = frames[world.berths[b]]
        if relation == DOCKING:
            port, probe = world.ports[b], world.probes[world.probe_begins[b] : world.probe_begins[b + 1]]
            if straight_before(
                probe, port[TIP:MOST], payload, berth, port[PORT:ENVELOPE], port[ENVELOPE:TIP].reshape(5, 4), depth,
                NEAR, inside, port[MOST] - inside,
            ):  # fmt: skip
                return True
        elif relation == GUIDES:
            t, u = aligning.guides[b], aligning.guides[b + 1]
            found = np.empty((u - t, OFFSET))
            axes = aligning.axes[9 * t : 9 * u].reshape(u - t, 3, 3)
            offsets(berth, payload, aligning.trunnions[t:u], aligning.seats[t:u], axes, found)
            least, most, room = over(
                found, aligning.opening[t:u], aligning.throat[t:u], aligning.height[t:u], aligning.play[t:u]
            )
            if least >= -depth and most <= NEAR and room >= inside:
                return True
    return False
