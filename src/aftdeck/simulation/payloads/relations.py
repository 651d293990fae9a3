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
from aftdeck.bodies.pose import POSE, pose_of, relative
from aftdeck.frames import oriend_rows
from aftdeck.matrices import length
from aftdeck.simulation.constants.berths import Berth
from aftdeck.simulation.constants.site import Meeting, Site
from aftdeck.simulation.payloads.grasp import fixture_in_hand
from aftdeck.simulation.payloads.seating import approached
from aftdeck.worksite.capture.acquisition import FIXED, PALM, PRONG
from aftdeck.worksite.seats.berthing import inside, places
from aftdeck.worksite.seats.docking import BEFORE, DISTANCE, INSIDE
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.near import touching_pairs


def permitted(site: Site, watch: ClearanceMonitor, frames: Array) -> Mask:
    """Return the pairs of parts whose contact the task permits at their present relative positions.

    Args:
        site: constants of the worksite.
        watch: clearances that were measured at `frames`.
        frames: (F, 12) pose of each frame, in L.

    Returns:
        (g,) 1 for the pairs that the task brings into contact; 0 for all other pairs. A pair of the task also has 0 if
        it is in contact without its relation, or deeper than permitted.
    """
    allowed = site.essential.copy()
    for meeting in site.meetings:
        clearance = watch.found[meeting.group, CLEARANCE]
        if clearance <= CONTACT and not (clearance >= -meeting.depth and _related(site, watch, frames, meeting)):
            allowed[meeting.group] = 0
    return allowed


def _related(site: Site, watch: ClearanceMonitor, frames: Array, meeting: Meeting) -> bool:
    """Return whether the two parts of a pair are in their relation."""
    k, depth = meeting.cargo, meeting.depth
    match meeting.relation:
        case "acquisition":
            return _about_bar(site, watch.placed, k, depth)
        case "docking":
            ports = (berth for berth in site.berths[k] if berth.port is not None)
            return any(_at_port(site, frames, k, berth, depth) for berth in ports)
        case "guides":
            guided = (berth for berth in site.berths[k] if berth.guides is not None)
            return any(_in_mouth(site, watch.placed, frames, meeting, berth) for berth in guided)
        case "capture":
            return _in_envelope(site, frames, k, depth)


def _about_bar(site: Site, placed: Array, k: int, depth: float) -> bool:
    """Return whether the bar is in front of the palm and between the fingers: conditions 1 to 3 of acquisition."""
    if site.bar is None or (found := site.bar.measured(placed, k)) is None:
        return False
    return bool(min(found[PALM], found[FIXED], found[PRONG]) >= -depth)


def _at_port(site: Site, frames: Array, k: int, berth: Berth, depth: float) -> bool:
    """Return whether the probe is in the docking envelope, and its face is within docking distance of the port."""
    found = approached(berth, frames, site.cargo_row(k))
    return bool(found[BEFORE] >= -depth and found[INSIDE] >= -depth and found[DISTANCE] <= berth.docking.distance)


def trunnions_at(site: Site, frames: Array, k: int, berth: Berth) -> Array:
    """Return the positions (n, 3) of a payload's trunnions in the frame to which a berth is fixed [m]."""
    in_frame = np.empty(POSE)
    relative(frames[berth.row], frames[site.cargo_row(k)], in_frame)
    return places(site.cargo[k].trunnions, pose_of(in_frame))


def _in_mouth(site: Site, placed: Array, frames: Array, meeting: Meeting, berth: Berth) -> bool:
    """Return whether every trunnion in contact is inside the mouth of its own V-guide."""
    assert berth.guides is not None
    room = inside(trunnions_at(site, frames, meeting.cargo, berth), berth.guides)
    return all(room[trunnion] >= -meeting.depth for trunnion in _touching(site, placed, meeting))


def _touching(site: Site, placed: Array, meeting: Meeting) -> set[int]:
    """Return the indices of the pair's trunnions that are in contact."""
    layout, found = site.layout, set()
    pairs = layout.pairs[layout.begins[meeting.group] : layout.begins[meeting.group + 1]]
    touching = np.empty(len(pairs), np.uint8)
    touching_pairs(placed, pairs, touching)
    for i, j in pairs[touching != 0].tolist():
        found.add(meeting.trunnions[i if i in meeting.trunnions else j])
    return found


def _in_envelope(site: Site, frames: Array, k: int, depth: float) -> bool:
    """Return whether the pin is in the capture envelope, without a limit at the envelope's outer end.

    The snares reach beyond the outer end, and may touch the base of the fixture.
    """
    if site.snares is None or (fixture := fixture_in_hand(site, frames, k)) is None:
        return False
    envelope, ((out, y, z), rows) = site.snares.envelope, fixture
    roll, pitch, yaw = (abs(angle) for angle in oriend_rows(rows))
    return bool(
        length((y, z)) <= envelope.radial
        and out >= envelope.nearest - depth
        and roll <= envelope.roll
        and pitch <= envelope.pitch
        and yaw <= envelope.yaw
    )
