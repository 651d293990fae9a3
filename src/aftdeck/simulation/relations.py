"""Essential contacts: where two parts that the task brings into contact may touch, and how deep.

Source: *Remote Manipulator Simulation*, final report, chapter IV: a collision is essential where the two stand "in the
physical relationship required to achieve acquisition". Everywhere else, and deeper than the worksite's file allows, a
contact of the same two parts is detrimental.
"""

from __future__ import annotations

from math import hypot

import numpy as np

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.pair import CONTACT, PAIR
from aftdeck.bodies.pose import POSE, pose_of, relative
from aftdeck.bodies.watch import measure
from aftdeck.frames import oriend
from aftdeck.simulation.berths import Berth
from aftdeck.simulation.grasp import fixture_in_hand
from aftdeck.simulation.seating import approached
from aftdeck.simulation.site import Meeting, Site
from aftdeck.worksite.acquisition import FIXED, FOUND, PALM, PRONG, acquire
from aftdeck.worksite.berthing import inside, places
from aftdeck.worksite.docking import BEFORE, DISTANCE, INSIDE
from aftdeck.worksite.found import CLEARANCE
from aftdeck.worksite.watch import Watch


def permitted(site: Site, watch: Watch, frames: Array) -> Mask:
    """Return which groups may be in contact where they are.

    Args:
        site: what never changes.
        watch: after its look at
        frames: (F, 12) in L.

    Returns:
        (g,) 1 for the groups of the task, but those that touch where, or deeper than, their relation permits. Those
        that do not touch stay permitted.
    """
    may = site.essential.copy()
    for meeting in site.meetings:
        clearance = watch.found[meeting.group, CLEARANCE]
        if clearance <= CONTACT and not (clearance >= -meeting.depth and _related(site, watch, frames, meeting)):
            may[meeting.group] = 0
    return may


def _related(site: Site, watch: Watch, frames: Array, meeting: Meeting) -> bool:
    """Return whether the two parts stand to each other as the task needs it."""
    k, depth = meeting.cargo, meeting.depth
    match meeting.relation:
        case "acquisition":
            return _about_the_bar(site, watch.placed, k, depth)
        case "docking":
            ports = (berth for berth in site.berths[k] if berth.port is not None)
            return any(_at_the_port(site, frames, k, berth, depth) for berth in ports)
        case "guides":
            guided = (berth for berth in site.berths[k] if berth.guides is not None)
            return any(_in_the_mouth(site, watch.placed, frames, meeting, berth) for berth in guided)
        case "capture":
            return _in_the_envelope(site, frames, k, depth)


def _about_the_bar(site: Site, placed: Array, k: int, depth: float) -> bool:
    """Conditions 1 to 3 of acquisition: the bar before the palm and between the fingers."""
    if site.bar is None or (which := site.bar.which[k]) is None:
        return False
    found = np.empty(FOUND)
    acquire(placed, which, site.bar.packed, found)
    return bool(min(found[PALM], found[FIXED], found[PRONG]) >= -depth)


def _at_the_port(site: Site, frames: Array, k: int, berth: Berth, depth: float) -> bool:
    """The probe in the docking envelope, and its face no farther from the port than docking allows."""
    found = approached(berth, frames, site.cargo_row(k))
    return bool(found[BEFORE] >= -depth and found[INSIDE] >= -depth and found[DISTANCE] <= berth.docking.distance)


def trunnions_at(site: Site, frames: Array, k: int, berth: Berth) -> Array:
    """Return where the trunnions of a cargo are in the frame of a seat, (n, 3) [m]."""
    stands = np.empty(POSE)
    relative(frames[berth.row], frames[site.cargo_row(k)], stands)
    return places(site.cargo[k].trunnions, pose_of(stands))


def _in_the_mouth(site: Site, placed: Array, frames: Array, meeting: Meeting, berth: Berth) -> bool:
    """Every trunnion that touches stands in its own V-guide."""
    assert berth.guides is not None
    room = inside(trunnions_at(site, frames, meeting.cargo, berth), berth.guides)
    return all(room[trunnion] >= -meeting.depth for trunnion in _touching(site, placed, meeting))


def _touching(site: Site, placed: Array, meeting: Meeting) -> set[int]:
    """The trunnions of a group that are in contact."""
    layout, found = site.layout, set()
    for i, j in layout.pairs[layout.begins[meeting.group] : layout.begins[meeting.group + 1]].tolist():
        trunnion = meeting.trunnions[i if i in meeting.trunnions else j]
        if measure(placed[i], placed[j], np.zeros(PAIR)) <= CONTACT:
            found.add(trunnion)
    return found


def _in_the_envelope(site: Site, frames: Array, k: int, depth: float) -> bool:
    """The pin in the capture envelope, or in the snares' reach beyond it: the fixture's base may be touched."""
    if site.snares is None or (fixture := fixture_in_hand(site, frames, k)) is None:
        return False
    envelope, pose = site.snares.envelope, pose_of(fixture)
    out, y, z = pose.position.tolist()
    roll, pitch, yaw = (abs(angle) for angle in oriend(pose.rotation))
    return bool(
        hypot(y, z) <= envelope.radial
        and out >= envelope.nearest - depth
        and roll <= envelope.roll
        and pitch <= envelope.pitch
        and yaw <= envelope.yaw
    )
