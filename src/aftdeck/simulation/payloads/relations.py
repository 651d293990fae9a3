"""Test whether a contact of two parts is essential: whether the task permits their relative position and the depth.

Source: *Remote Manipulator Simulation*, final report, chapter IV: a collision is essential if the two parts are "in the
physical relationship required to achieve acquisition". This relative position is the *relation* of the two parts. If
the two parts do not have this relative position, or if their contact is deeper than the worksite's file allows, the
contact is detrimental.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.pair import CONTACT
from aftdeck.bodies.pose import POSE, compose
from aftdeck.law import law
from aftdeck.lent import lend
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.row.aligning import ACQUISITION, CAPTURE, DOCKING, Aligning, aligning_of
from aftdeck.simulation.row.now import Arrays, lent
from aftdeck.simulation.row.world import ENVELOPE, MOST, PORT, TIP, World, pairs_of, world_of
from aftdeck.simulation.state import State
from aftdeck.worksite.berths.bay import guided
from aftdeck.worksite.berths.berthing import OFFSET, offsets
from aftdeck.worksite.berths.docking import BEFORE, DISTANCE, FOUND, INSIDE, approach
from aftdeck.worksite.berths.on_way import NEAR
from aftdeck.worksite.capture.acquisition import FIXED, MEASURED, PALM, PRONG, acquire
from aftdeck.worksite.capture.grapple import NEAREST, around_axis
from aftdeck.worksite.capture.snares import fixture_in_effector
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.groups import PackedLayout
from aftdeck.worksite.watch.measured import Measured, MeasuredArrays, measured_of, place_solids
from aftdeck.worksite.watch.places import nearest_place


def permitted(flight: Flight, state: State, watch: ClearanceMonitor, frames: Array) -> Mask:
    """Return the pairs of parts whose contact the task permits at their present relative positions.

    Args:
        flight: constants of the run.
        state: state of the run, whose row has the constants.
        watch: clearances that were measured at `frames`.
        frames: (F, 12) pose of each frame, in L.

    Returns:
        (g,) 1 for the pairs that the task brings into contact; 0 for all other pairs. A pair of the task also has 0 if
        it is in contact without its relation, or deeper than permitted.
    """
    allowed = np.empty_like(flight.site.essential)
    _permit(state.row.arrays(flight.packed), watch.packed, frames, allowed)
    return allowed


@law
def _permit(arrays: Arrays, measured: MeasuredArrays, frames: Array, allowed: Mask) -> None:
    """Write the result of `permitted`."""
    flat = lent(arrays)
    permit(world_of(flat), aligning_of(flat), pairs_of(flat), measured_of(measured), lend(frames), lend(allowed))


@law
def permit(world: World, aligning: Aligning, pairs: PackedLayout, own: Measured, frames: Array, allowed: Mask) -> None:
    """Write the pairs of parts whose contact the task permits, as `permitted` describes them, into `allowed` (g,)."""
    allowed[:] = world.task
    for m in range(len(world.meetings)):
        g, depth = world.meetings[m], aligning.depths[m]
        clearance = own.found[g, CLEARANCE]
        if clearance <= CONTACT and not (clearance >= -depth and related(world, aligning, pairs, own, frames, m)):
            allowed[g] = 0


@law
def related(world: World, aligning: Aligning, pairs: PackedLayout, own: Measured, frames: Array, m: int) -> bool:
    """Return whether the two parts of meeting m are in their relation; the other arguments are those of `permit`."""
    k, relation, depth = aligning.payloads[m], aligning.relations[m], aligning.depths[m]
    if relation == ACQUISITION:
        return len(world.bars) > 0 and _between_fingers(world, pairs, own, k, depth)
    if relation == CAPTURE:
        return len(world.fixtures) > 0 and _among_snares(world, aligning, frames, k, depth)
    for berth in range(world.berth_begins[k], world.berth_begins[k + 1]):
        if aligning.fits[berth] != relation:
            continue
        if relation == DOCKING:
            if _in_port(world, frames, k, berth, depth):
                return True
        elif _in_guides(world, aligning, pairs, own, frames, m, berth):
            return True
    return False


@law
def _between_fingers(world: World, pairs: PackedLayout, own: Measured, k: int, depth: float) -> bool:
    """Return whether payload k's bar is in front of the palm and between the fingers: conditions 1 to 3 of MODE 1."""
    if world.bars[k, 0] < 0:
        return False
    place_solids(pairs, own, world.bars[k])
    found = np.empty(MEASURED)
    acquire(own.placed, world.bars[k], world.tolerances, found)
    return bool(min(found[PALM], found[FIXED], found[PRONG]) >= -depth)


@law
def _among_snares(world: World, aligning: Aligning, frames: Array, k: int, depth: float) -> bool:
    """Return whether payload k's pin is in the capture envelope, without a limit at the envelope's outer end.

    The snares reach beyond the outer end, and may touch the base of the fixture.
    """
    if world.fixtures[k, 0] != world.fixtures[k, 0]:  # NaN: no fixture
        return False
    (out, y, z), turned = fixture_in_effector(frames, world.hand[0], world.effector, world.rows[k], world.fixtures[k])
    envelope = aligning.envelope
    return bool(out >= envelope[NEAREST] - depth) and around_axis(envelope, y, z, turned, 1.0)


@law
def _in_port(world: World, frames: Array, k: int, berth: int, depth: float) -> bool:
    """Return whether payload k's probe is in the docking envelope, and its face within docking distance of the port."""
    found = np.empty(FOUND)
    approached(world, frames, k, berth, found)
    inside = found[BEFORE] >= -depth and found[INSIDE] >= -depth
    return bool(inside and found[DISTANCE] <= world.ports[berth, MOST])


@law
def berth_near(world: World, frames: Array, k: int) -> int:
    """Return the number of the berth whose final position for payload k is nearest to it; -1 if none is within `NEAR`.

    The berths are numbered as in `World.berths`.
    """
    begin, end = world.berth_begins[k], world.berth_begins[k + 1]
    nearest = nearest_place(frames, world.rows[k], world.berths[begin:end], world.places[begin:end], NEAR)
    return int(begin + nearest) if nearest >= 0 else -1


@law
def approached(world: World, frames: Array, k: int, berth: int, found: Array) -> None:
    """Write the results (6,) of `docking.approach` for payload k's probe at a port."""
    port, at = world.ports[berth], np.empty(POSE)
    compose(frames[world.berths[berth]], port[PORT:ENVELOPE], at)
    probe = world.probes[world.probe_begins[berth] : world.probe_begins[berth + 1]]
    approach(probe, port[TIP:MOST], frames[world.rows[k]], at, port[ENVELOPE:TIP].reshape(5, 4), found)


@law
def _in_guides(
    world: World, aligning: Aligning, pairs: PackedLayout, own: Measured, frames: Array, m: int, berth: int
) -> bool:
    """Return whether every trunnion in contact is inside the mouth of its own V-guide."""
    t, u = aligning.guides[berth], aligning.guides[berth + 1]
    p, q = aligning.meeting_begins[m], aligning.meeting_begins[m + 1]
    found = np.empty((u - t, OFFSET))
    axes = aligning.axes[9 * t : 9 * u].reshape(u - t, 3, 3)
    payload = frames[world.rows[aligning.payloads[m]]]
    offsets(frames[world.berths[berth]], payload, aligning.trunnions[t:u], aligning.seats[t:u], axes, found)
    solids = aligning.meeting_pairs[p:q]
    for k in range(len(solids)):
        place_solids(pairs, own, solids[k])
    return guided(
        found, aligning.opening[t:u], aligning.throat[t:u], aligning.height[t:u], aligning.play[t:u], own.placed,
        solids, aligning.meeting_trunnions[p:q], aligning.depths[m],
    )  # fmt: skip
