"""Limits that acted in a step, with their texts for the operator.

The texts are values of the frame: `verify` compares them with the texts in older recordings.
"""

from __future__ import annotations

from aftdeck.arrays import Array
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame import AT_HARD, Limit, LimitKind
from aftdeck.simulation.log import joint_label
from aftdeck.simulation.motion.standstill import joint_lock_reason, latched_payload_reason
from aftdeck.simulation.state import State
from aftdeck.steering.layout import RATES
from aftdeck.steering.limiters import BY_ACCELERATION, CAUSES

_TEXTS: dict[str, tuple[LimitKind, str]] = {
    "joint rate": ("joint rate", "at its rate limit"),
    "soft stop": ("soft stop", "held by its soft stop"),
    "hard stop": ("hard stop", "held by its hard stop"),
    "joint acceleration": ("joint acceleration", "at its greatest acceleration"),
}
"""Kind of limit, and the text that follows the joint's name, for each joint limit of `limiters.CAUSES`."""


def active_limits(flight: Flight, state: State, acted: tuple[int, int, int, int]) -> tuple[Limit, ...]:
    """Return the limits that acted in the last step, and every joint acceleration that exceeded its limit.

    If a berth, a contact or a switch stopped the arm, the result contains only this limit. `acted`:
    `frame_numbers.Acted`.
    """
    if state.worksite.halt == "seat":
        return (Limit("seat", -1, latched_payload_reason(flight.site, state.worksite)),)
    if state.worksite.halt == "contact":
        return (Limit("contact", -1, "contact: only motion that relieves it is flown"),)
    if why := joint_lock_reason(state.panel):
        return (Limit("switch", -1, why),) if state.worksite.halt == "switch" else ()
    cause, por_cause, culprit, bits = acted
    stopped = AT_HARD in state.panel.zones
    if cause == 0 and por_cause == 0 and not stopped and not bits:
        return ()
    beyond = [joint for joint in range(len(state.plant.angles)) if bits >> joint & 1]
    found = [] if cause == BY_ACCELERATION and culprit in beyond else _of_joints(flight, cause, culprit)
    for joint in beyond:
        name = joint_label(flight.scenario.arm.joints[joint])
        found.append(Limit("joint acceleration", joint, f"{name} beyond its greatest acceleration"))
    if stopped:
        found += _held_by_stops(flight, state.panel.zones, state.steering, state.plant.angles, found)
    if por_cause & 2:
        found.append(Limit("POR translation", -1, "POR at its greatest speed"))
    if por_cause & 8:
        found.append(Limit("POR rotation", -1, "POR at its greatest rate of turn"))
    if por_cause & (1 | 4):
        what = {1: "speed", 4: "turning", 5: "speed and turning"}[por_cause & (1 | 4)]
        found.append(Limit("POR acceleration", -1, f"POR {what} still building up or falling"))
    return tuple(found)


def _held_by_stops(
    flight: Flight, zones: tuple[int, ...], steering: Array, angles: Array, found: list[Limit]
) -> list[Limit]:
    """Return the joints whose commanded rates press them against their hard stops, besides those in `found`."""
    rates, at = steering[RATES : RATES + len(zones)].tolist(), angles.tolist()
    named = {limit.joint for limit in found if limit.kind == "hard stop"}
    held = [
        joint
        for joint, (zone, (low, high)) in enumerate(zip(zones, flight.hard, strict=True))
        if zone == AT_HARD and joint not in named and rates[joint] * (at[joint] - 0.5 * (low + high)) > 0.0
    ]
    kind, text = _TEXTS["hard stop"]
    return [Limit(kind, joint, f"{joint_label(flight.scenario.arm.joints[joint])} {text}") for joint in held]


def _of_joints(flight: Flight, cause: int, culprit: int) -> list[Limit]:
    """Return a list with the limit that acted on the joint rates; an empty list if `cause` is 0."""
    if cause == 0:
        return []
    if CAUSES[cause] == "singularity":
        name = flight.scenario.arm.model.singularities[culprit]
        return [Limit("singularity", -1, f"slowed before the {name} singularity")]
    joint = joint_label(flight.scenario.arm.joints[culprit])
    kind, text = _TEXTS[CAUSES[cause]]
    return [Limit(kind, culprit, f"{joint} {text}")]
