"""Readings of the panel and the hand controllers, and the states of the arm that are counted."""

from __future__ import annotations

from collections.abc import Mapping

from aftdeck.simulation.frame import AT_HARD, PAST_REACH, PAST_SOFT, Frame, LimitKind
from aftdeck.simulation.payloads.task_phases import TASKS
from aftdeck.simulation.readings.reading import XYZ, Known, Reading, Recorded, Strip, Value, shown
from aftdeck.simulation.readings.source import FORMAN, OWN, REPORT

MODE_NUMBERS: Mapping[object, int] = {
    "OPR CMD": 1,
    "AUTO 1": 2,
    "AUTO 2": 3,
    "AUTO 3": 4,
    "AUTO 4": 5,
    "TEST": 6,
    "ORB UNL": 7,
    "END EFF": 8,
    "ORB LD": 9,
    "PL": 10,
    "SINGLE": 11,
    "DIRECT": 12,
    "MASTER": 13,
}
"""Number of each position of the MODE rotary; these numbers never change, a new mode gets a new one."""
_JOINTS = ", with one joint or several"


def _acts(s: Known, kind: LimitKind) -> bool:
    return bool(s.frame.limits) and any(limit.kind == kind for limit in s.frame.limits)


def _at_soft_stop(s: Known) -> bool:
    return max(s.frame.zones) >= PAST_SOFT or _acts(s, "soft stop")


def _in_task(task: int) -> Value:
    return lambda s: s.frame.work.task == task if s.frame.work.cargo else None


def _state(name: str, definition: str, holds: Value, metric: Recorded, source: str = OWN) -> Reading:
    """Return the reading of a state that holds or not, and its metric."""
    return Reading(name, definition, holds, source=source, metrics=(metric,))


TIMES = (
    shown(Frame, "time_s", "time", group="time"),
    shown(Frame, "phase", "phase", quantity="words", group="phase"),
    shown(Frame, "mode", "mode", quantity="words", group="phase"),
    _state(
        "by_hand",
        "with manual inputs",
        lambda s: s.frame.by == "hand",
        Recorded("share", "manual_share", "Manual share"),
    ),
    _state(
        "vernier",
        "with the rate setting vernier",
        lambda s: s.frame.rate == "vernier",
        Recorded("time", "vernier_time", "Time in vernier"),
    ),
    *(
        _state(
            name,
            f"in task phase {task}: {name}",
            _in_task(task),
            Recorded("time", f"{name}_time", f"Time of {name}"),
            REPORT,
        )
        for task, name in TASKS.items()
    ),
)
"""Readings of what a run does, and who flies it."""

STICKS = (
    shown(Frame, "translation", "thc", XYZ, group="sticks"),
    shown(Frame, "rotation", "rhc", ("roll", "pitch", "yaw"), group="sticks"),
    shown(Frame, "drive", "drive", group="sticks"),
    Reading(
        "deflection",
        "greatest deflection of an axis",
        lambda s: [max(map(abs, stick)) for stick in (s.frame.translation, s.frame.rotation)],
        ("THC", "RHC"),
        "share",
        title="{part}",
        strip=Strip(role="commanded"),
    ),
    Reading(
        "stick_to_picture", "time from stick to picture", lambda s: s.latency_ms, (), "milliseconds", strip=Strip()
    ),
)
"""Readings of the hand controllers."""


def _limit(title: str, began: str, holds: Value, source: str = OWN) -> Reading:
    """Return the reading of a limit that the arm reaches, and the metric of how often it did."""
    name = title.lower().replace(" ", "_")
    return _state(name, began, holds, Recorded("begun", f"{name}_events", title), source)


LIMITS = (
    _limit("Rate limit", "the limit of a joint's rate began to slow the arm", lambda s: _acts(s, "joint rate")),
    _limit(
        "Reach limit", f"the arm came beyond a reach limit{_JOINTS}", lambda s: max(s.frame.zones) >= PAST_REACH, FORMAN
    ),
    _limit("Soft stop", f"the arm came to or beyond a soft stop{_JOINTS}", _at_soft_stop, FORMAN),
    _limit("Hard stop", f"the arm came to a hard stop{_JOINTS}", lambda s: AT_HARD in s.frame.zones, FORMAN),
    _limit(
        "Singularity",
        "the arm came nearer to a singularity than its threshold",
        lambda s: bool(s.frame.singular),
        FORMAN,
    ),
    Reading(
        "mode_number",
        "mode, numbered as in the column `mode` of an action",
        lambda s: float(MODE_NUMBERS.get(s.frame.mode, 0)),
        state="mode",
    ),
    Reading(
        "coarse",
        "rate setting: 1 coarse, -1 vernier",
        lambda s: 1.0 if s.frame.rate == "coarse" else -1.0,
        state="coarse",
    ),
    shown(
        Frame,
        "brakes",
        "brakes",
        metrics=(Recorded("begun", "brakes_used", "Brakes used", "Number of times that the brakes were set."),),
        group="phase",
        state="brakes",
    ),
)
"""Readings of limits that the arm reaches, and of switches."""
