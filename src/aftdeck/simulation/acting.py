"""Which limits acted in a step, named for people."""

from __future__ import annotations

from aftdeck.kinematics.singular import NAMES
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.frame import Limit
from aftdeck.simulation.log import spoken
from aftdeck.simulation.standstill import held_fast, standing
from aftdeck.simulation.state import State
from aftdeck.steering.layout import CAUSE, CULPRIT, POR_CAUSE
from aftdeck.steering.limiters import CAUSES


def acting_limits(flight: Flight, state: State) -> tuple[Limit, ...]:
    """The limits that acted, named; where the arm may not move at all, what keeps it."""
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
    found = []
    joints = flight.scenario.arm.joints
    culprit = int(report[CULPRIT])
    match CAUSES[cause]:
        case "joint rate":
            found.append(Limit("joint rate", culprit, f"{spoken(joints[culprit])} at its rate limit"))
        case "soft stop":
            found.append(Limit("soft stop", culprit, f"{spoken(joints[culprit])} held by its soft stop"))
        case "hard stop":
            found.append(Limit("hard stop", culprit, f"{spoken(joints[culprit])} held by its hard stop"))
        case "singularity":
            found.append(Limit("singularity", -1, f"slowed before the {NAMES[culprit]} singularity"))
    if por_cause & 2:
        found.append(Limit("POR translation", -1, "POR at its greatest speed"))
    if por_cause & 8:
        found.append(Limit("POR rotation", -1, "POR at its greatest rate of turn"))
    if por_cause & (1 | 4):
        what = {1: "speed", 4: "turning", 5: "speed and turning"}[por_cause & (1 | 4)]
        found.append(Limit("POR acceleration", -1, f"POR {what} still building up or falling"))
    return tuple(found)
