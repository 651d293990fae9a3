"""Present objective (capture, docking or berthing) and its conditions, as the panel displays them."""

from __future__ import annotations

from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.fixing import conditions_at
from aftdeck.simulation.payloads.grasp import NEAR
from aftdeck.simulation.payloads.latch_command import nearest_berth
from aftdeck.worksite.conditions import Condition
from aftdeck.worksite.report import Objective

Pursued = tuple[Objective | None, tuple[Condition, ...]]


def present_objective(site: Site, worksite: WorksiteState) -> Pursued:
    """Return the present objective and its conditions; None and () if no fixture, bar or berth is within `NEAR`.

    A berth that has just released the payload is no objective until the payload has left it.
    """
    if (k := worksite.held) is not None:
        fit = None if worksite.arm_fixed else nearest_berth(site, worksite.frames, k)
        if fit is None or worksite.payloads[k].released_from == fit.berth.name:
            return None, ()
        text = f"{fit.berth.verb} in the {fit.berth.title}"
        return Objective(fit.berth.verb, text), conditions_at(site, worksite, k, fit)
    device = site.capture
    near = None if device is None else device.nearest(worksite.frames, worksite.watch.place, NEAR)
    if device is None or near is None:
        return None, ()
    return Objective(device.action, f"{device.action} {site.payloads[near.payload].title}"), near.conditions


def holding(site: Site, worksite: WorksiteState, k: int) -> tuple[Condition, ...]:
    """Return the conditions of capture for the present pose of payload k; () if this end effector cannot capture it."""
    return () if site.capture is None else site.capture.conditions(worksite.frames, worksite.watch.place, k)
