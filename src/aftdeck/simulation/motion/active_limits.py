"""Limits that acted in a step, in the operator's words."""

from __future__ import annotations

from aftdeck.kinematics.singular import NAMES
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame import Limit, LimitKind
from aftdeck.simulation.log import spoken
from aftdeck.simulation.motion.standstill import held_fast, standing
from aftdeck.simulation.state import State
from aftdeck.steering.layout import CAUSE, CULPRIT, POR_CAUSE
from aftdeck.steering.limiters import CAUSES

_TEXTS: dict[str, tuple[LimitKind, str]] = {
    "joint rate": ("joint rate", "at its rate limit"),
    "soft stop": ("soft stop", "held by its soft stop"),
    "hard stop": ("hard stop", "held by its hard stop"),
    "joint acceleration": ("joint acceleration", "at its greatest acceleration"),
    "joint acceleration passed": ("joint acceleration", "beyond its greatest acceleration: the line is kept"),
}
"""Kind of limit, and text about the joint, for each of `limiters.CAUSES` that names a joint."""


def acting_limits(flight: Flight, state: State) -> tuple[Limit, ...]:
    """Return the limits that acted in the last step.

    If a seat, a contact or a switch stopped the arm, return that alone.
    """
    if state.site.halt == "seat":
        return (Limit("seat", -1, held_fast(flight, state)),)
    if state.site.halt == "contact":
        return (Limit("contact", -1, "contact: only motion that relieves it is flown"),)
    if why := standing(state.panel):
        return (Limit("switch", -1, why),) if state.site.halt == "switch" else ()
    report = state.report
    cause, por_cause = int(report[CAUSE]), int(report[POR_CAUSE])
    if cause == 0 and por_cause == 0:
        return ()
    found = _of_joints(flight, cause, int(report[CULPRIT]))
    if por_cause & 2:
        found.append(Limit("POR translation", -1, "POR at its greatest speed"))
    if por_cause & 8:
        found.append(Limit("POR rotation", -1, "POR at its greatest rate of turn"))
    if por_cause & (1 | 4):
        what = {1: "speed", 4: "turning", 5: "speed and turning"}[por_cause & (1 | 4)]
        found.append(Limit("POR acceleration", -1, f"POR {what} still building up or falling"))
    return tuple(found)


def _of_joints(flight: Flight, cause: int, culprit: int) -> list[Limit]:
    """Return the limit that acted on the joint rates; an empty list if `cause` is 0."""
    if cause == 0:
        return []
    if CAUSES[cause] == "singularity":
        return [Limit("singularity", -1, f"slowed before the {NAMES[culprit]} singularity")]
    joint = spoken(flight.scenario.arm.joints[culprit])
    kind, text = _TEXTS[CAUSES[cause]]
    return [Limit(kind, culprit, f"{joint} {text}")]
