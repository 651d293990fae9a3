"""Lines of the log about the arm after a step: joints that pass a limit, nearby singularities, and small clearances."""

from __future__ import annotations

from aftdeck.kinematics.observe import SEEN
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame import AT_HARD, FREE, PAST_REACH, PAST_SOFT, Level
from aftdeck.simulation.log import Log, joint_label
from aftdeck.simulation.motion.ways_out import ways_out
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.period.observe import observe_arm
from aftdeck.simulation.period.quick import give_limits
from aftdeck.simulation.row.scalars import ARM, BY_JOINT, FLOWN, LIMITS, STAND_VELOCITY
from aftdeck.simulation.state import Panel, State
from aftdeck.steering.mode import MODES
from aftdeck.worksite.conditions import quantity_text
from aftdeck.worksite.watch.alarm import level_of
from aftdeck.worksite.watch.found import CLEARANCE

Zones = tuple[int, ...]

_BACK_TEXTS = {PAST_REACH: "back inside its soft stop", PAST_SOFT: "off its hard stop"}
_ZONE_TEXTS = {FREE: "clear of its limits", PAST_REACH: "past its reach limit", PAST_SOFT: "past its soft stop",
               AT_HARD: "at its hard stop"}  # fmt: skip


def log_arm_events(flight: Flight, state: State, log: Log, *, complete: bool) -> None:
    """Log changes of the joints' zones, the nearby singularities and the clearance level.

    Also update the escape directions. `complete`: whether compiled code has made the whole step.
    """
    panel = state.panel
    if not complete:
        _observe(flight, state)
    if not (state.row.values[LIMITS] or panel.singular or any(panel.zones) or state.worksite.contacts.inhibit.arm):
        _log_clearance_level(flight, state.worksite, panel, log)
        state.ways_out = ()
        panel.advice.clear()
        return
    model, row = flight.scenario.arm.model, state.row.limits
    state.row.limited = True
    zones: Zones = tuple(row.zones.tolist())
    singular = tuple(name for name, near in zip(model.singularities, row.singular.tolist(), strict=True) if near)
    if zones != panel.zones:
        _log_zone_changes(log, flight.scenario.arm.joints, panel.zones, zones)
        panel.zones = zones
    if singular != panel.singular:
        _log_singularities(
            log, panel.singular, singular, dict(zip(model.singularities, state.observed[SEEN:].tolist(), strict=True))
        )
        panel.singular = singular
    _log_clearance_level(flight, state.worksite, panel, log)
    state.ways_out = ways_out(flight, state)


def _observe(flight: Flight, state: State) -> None:
    """Observe the arm after a step that Python code has made."""
    panel, row, scalars = state.panel, state.row, state.row.scalars
    scalars[STAND_VELOCITY], scalars[ARM] = state.plant.stand.velocity, state.worksite.contacts.inhibit.arm
    scalars[FLOWN], scalars[BY_JOINT] = panel.stick_law, MODES[panel.mode].by_joint
    give_limits(flight, state)
    observe_arm(row.arrays(flight.packed), state.arm.model.links, state.stick_rules)
    row.values = scalars.tolist()


def _log_zone_changes(log: Log, joints: tuple[str, ...], before: Zones, zones: Zones) -> None:
    for joint, old, new in zip(joints, before, zones, strict=True):
        if new != old:
            level: Level = "caution" if new > old else "info"
            text = _ZONE_TEXTS[new] if new > old or new == FREE else _BACK_TEXTS[new]
            log.add("limit", level, f"{joint_label(joint)} {text}")


def _log_singularities(
    log: Log, before: tuple[str, ...], singular: tuple[str, ...], distances: dict[str, float]
) -> None:
    for name, distance in distances.items():
        if name in singular and name not in before:
            log.add("singular", "caution", f"{name} singularity near: {abs(distance):.2f} of 1")
        elif name in before and name not in singular:
            log.add("singular", "info", f"{name} singularity left behind")


def _log_clearance_level(flight: Flight, worksite: WorksiteState, panel: Panel, log: Log) -> None:
    """Log when the minimum clearance falls below a threshold of the scenario, or rises above it again."""
    scenario, before = flight.scenario, panel.clearance
    now: Level = "info"
    if worksite.nearest >= 0:
        clearance = float(worksite.watch.found[worksite.nearest, CLEARANCE])
        now = level_of(clearance, scenario.caution, scenario.warning, before)
    if now == before:
        return
    panel.clearance = now
    units = scenario.arm.model.units
    thresholds = {
        "caution": quantity_text(scenario.caution, "m", units),
        "warning": quantity_text(scenario.warning, "m", units),
    }
    if now == "warning" or before == "info":
        a, b = flight.site.layout.named(worksite.nearest)
        log.add("clearance", now, f"{a} within {thresholds[now]} of {b}")
    else:
        passed = thresholds["warning" if now == "caution" else "caution"]
        log.add("clearance", "info", f"clearance over {passed} again")
