"""Texts for the reasons why the arm cannot move at all."""

from __future__ import annotations

from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.state import Panel


def joint_lock_reason(panel: Panel) -> str:
    """Return a text about the switch that stops all joints, BRAKES or SAFING; "" if both are off."""
    if panel.brakes:
        return "BRAKES are on"
    return "SAFING is on; CANCEL it first" if panel.safing else ""


def latched_payload_reason(site: Site, worksite: WorksiteState) -> str:
    """Return a text about the berth that blocks the arm, with the remedy; "" if the held payload is not fixed."""
    where = fixed_in(site, worksite)
    return f"{where}: UNLATCH" if where else ""


def fixed_in(site: Site, worksite: WorksiteState) -> str:
    """Return a text with the names of the held payload and its berth; "" if no held payload is fixed to a berth."""
    if worksite.held is None or not worksite.arm_fixed:
        return ""
    berth = site.berth(worksite.payloads[worksite.held].berth)
    return f"{site.payloads[worksite.held].title} is fixed in the {berth.title}"
