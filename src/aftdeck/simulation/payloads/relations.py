"""Test whether a contact of two parts is essential: whether the task permits their relative position and the depth.

Source: *Remote Manipulator Simulation*, final report, chapter IV: a collision is essential if the two parts are "in the
physical relationship required to achieve acquisition". This relative position is the *relation* of the two parts. If
the two parts do not have this relative position, or if their contact is deeper than the worksite's file allows, the
contact is detrimental.
"""

from __future__ import annotations

from aftdeck.arrays import Array, Mask
from aftdeck.bodies.pair import CONTACT
from aftdeck.simulation.constants.site import Site
from aftdeck.worksite.relation import Meeting
from aftdeck.worksite.watch.clearance_monitor import ClearanceMonitor
from aftdeck.worksite.watch.found import CLEARANCE


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
    k, device = meeting.payload, site.capture
    if device is not None and meeting.relation == device.relation:
        return device.permits(frames, watch.place, meeting)
    fits = (fit for fit in site.fits[k] if fit.relation == meeting.relation)
    return any(fit.permits(frames, site.payload_rows[k], watch.place, meeting) for fit in fits)
