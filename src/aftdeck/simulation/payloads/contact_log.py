"""Log lines of contacts: parts that touch, and parts that are clear of each other again."""

from __future__ import annotations

from math import inf

import numpy as np
from msgspec.structs import replace

from aftdeck.plant.state import Bodies, ContactForce
from aftdeck.simulation.log import Log
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.payloads.forces import ENDED_AFTER
from aftdeck.worksite.conditions import Units
from aftdeck.worksite.watch.found import CLEARANCE
from aftdeck.worksite.watch.groups import Layout

_NEW = ContactForce(apart_for=inf)
"""Force of a contact that begins without a force, such as of parts that only touch."""


def log_contacts(layout: Layout, worksite: WorksiteState, bodies: Bodies | None, log: Log, units: Units) -> None:
    """Log the contacts that began or ended.

    Without contact forces, a contact ends as soon as the parts are apart. With them, parts that are pressed together
    can bounce; their contact ends when they have been apart for `ENDED_AFTER`. It can then begin and end within a
    control period, so that the parts overlap at no end of a step.
    """
    contacts, found = worksite.contacts, worksite.watch.found
    forces = {} if bodies is None else bodies.contacts
    if not (contacts.inhibit.changed or forces):
        return
    touching: set[int] = set(np.flatnonzero(contacts.count).tolist())
    if bodies is not None:
        for group in touching:
            if (force := forces.get(group, _NEW)).apart_for > 0.0:
                forces[group] = replace(force, apart_for=0.0)
        touching.update(touch.group for touch in bodies.touches if worksite.watch.active[touch.group])
    logged = set(worksite.logged_contacts)
    for group in sorted(touching - logged, key=lambda group: float(found[group, CLEARANCE])):
        contact = contacts.contact(group, layout, found, units)
        log.add("contact", "info" if contact.essential else "caution", contact.text)
    for group in sorted(logged - touching):
        if group in forces and forces[group].apart_for <= ENDED_AFTER:
            touching.add(group)
            continue
        a, b = layout.named(group)
        log.add("contact", "info", f"{a} clear of {b}{_force_text(forces.pop(group, None))}")
    worksite.logged_contacts = tuple(sorted(touching))


def _force_text(force: ContactForce | None) -> str:
    """Return the text of a contact's greatest force and its impulse; "" if no force acted."""
    if force is None or force.greatest == 0.0:
        return ""
    return f"; greatest force {force.greatest:.0f} N, impulse {force.impulse:.3g} N s"
