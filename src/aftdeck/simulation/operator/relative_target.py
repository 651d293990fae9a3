"""Conversion of a relative target to a pose of the tip, when the phase with this target begins.

A relative target is a pose relative to a payload, a berth or a body.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import POSE, compose, inverse, pose_of, row_of
from aftdeck.scenario.relative import at_berth, at_payload
from aftdeck.scenario.target import AtBerth, AtPayload, InFrame, RelativeTarget, Target, target_at
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.grasp import pose_in_hand


def resolve_target(flight: Flight, worksite: WorksiteState, target: RelativeTarget) -> Target | str:
    """Return the present pose of a relative target; if the pose cannot be computed, return the reason as text."""
    site, frames = flight.site, worksite.frames
    match target:
        case AtBerth():
            return _at_berth(site, worksite, target)
        case AtPayload(payload=k):
            over = row_of(at_payload(flight.scenario.arm.model, site.payloads[k], target))
            return target_at(pose_of(_composed(frames[site.payload_rows[k]], over)))
        case InFrame():
            carrier = frames[site.layout.frames.index(target.frame)]
            return target_at(pose_of(_composed(carrier, row_of(target.pose))))


def _at_berth(site: Site, worksite: WorksiteState, target: AtBerth) -> Target | str:
    """Return the tip pose with which the held payload is in a berth, or at the target's distance above the berth.

    Returns:
        The pose; or the reason as text, if no payload is held or the berth does not accept the payload.
    """
    k = worksite.held
    if k is None:
        return "the grasp is empty: there is no payload to move to a berth"
    fit = site.fit(k, target.berth)
    if fit is None:
        return f"the {site.berth(target.berth).title} does not accept {site.payloads[k].title}"
    seated = _composed(worksite.frames[fit.row], row_of(at_berth(fit.berth, site.payloads[k], target)))
    joint = _composed(seated, inverse(pose_in_hand(site, worksite.frames, k)))
    return target_at(pose_of(_composed(joint, site.hand)))


def _composed(outer: Array, inner: Array) -> Array:
    out = np.empty(POSE)
    compose(outer, inner, out)
    return out
