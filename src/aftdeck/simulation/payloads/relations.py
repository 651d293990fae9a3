"""Test whether a contact of two parts is essential: whether the task permits their relative position and the depth.

Source: *Remote Manipulator Simulation*, final report, chapter IV: a collision is essential if the two parts are "in the
physical relationship required to achieve acquisition". This relative position is the *relation* of the two parts. If
the two parts do not have this relative position, or if their contact is deeper than the worksite's file allows, the
contact is detrimental.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pair import CONTACT, PAIR
from aftdeck.frames import oriend_rows
from aftdeck.law import law
from aftdeck.matrices import length
from aftdeck.simulation.constants.berths import Berth
from aftdeck.simulation.constants.site import Meeting, Site
from aftdeck.simulation.payloads.grasp import fixture_in_hand
from aftdeck.simulation.payloads.seating import approached
from aftdeck.worksite.capture.acquisition import FIXED, PALM, PRONG
from aftdeck.worksite.seats.berthing import inside
from aftdeck.worksite.seats.docking import BEFORE, DISTANCE, INSIDE
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.near import touch


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


def _in_mouth(site: Site, placed: Array, frames: Array, meeting: Meeting, berth: Berth) -> bool:
    """Return whether every trunnion in contact is inside the mouth of its own V-guide."""
    guides, layout, k = berth.guides, site.layout, meeting.cargo
    assert guides is not None
    return guided(
        berth.trunnion_offsets(frames, site.cargo_row(k), site.cargo[k].trunnions),
        guides.opening,
        guides.throat,
        guides.height,
        guides.play,
        placed,
        layout.pairs[layout.begins[meeting.group] : layout.begins[meeting.group + 1]],
        meeting.trunnions,
        meeting.depth,
    )


@law
def guided(
    found: Array,
    opening: Array,
    throat: Array,
    height: Array,
    play: Array,
    placed: Array,
    pairs: Indices,
    trunnions: Indices,
    depth: float,
) -> bool:
    """Return whether every trunnion in contact is inside the mouth of its own V-guide.

    Args:
        found: (n, 4) result of `berthing.offsets`.
        opening: `Guides.opening`.
        throat: `Guides.throat`.
        height: `Guides.height`.
        play: `Guides.play`.
        placed: (s, 52) all solids in L.
        pairs: (m, 2) pairs of solids of trunnions and guides.
        trunnions: (m,) trunnion to which each pair belongs.
        depth: permitted penetration depth [m].
    """
    pair = np.zeros(PAIR)
    for k in range(len(pairs)):
        if inside(trunnions[k], found, opening, throat, height, play) >= -depth:
            continue
        if touch(placed[pairs[k, 0]], placed[pairs[k, 1]], pair):
            return False
    return True


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
