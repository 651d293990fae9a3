"""Changes in flight: which keys of a scenario, its arm and its worksite can change while a run lasts, and how.

The report's operator read and changed values by typewriter while the program ran (*Remote Manipulator Simulation*,
section V.A and TABLE III). Here a change in flight makes a new scenario with the loader of the files
(`load.in_force`), so that the value is checked as the file is; the run then goes on with the new constants.
"""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from functools import lru_cache
from typing import NamedTuple

import msgspec

from aftdeck.errors import InputError
from aftdeck.files import place
from aftdeck.scenario.changes import change_text, parse_change, parse_key, value_of
from aftdeck.scenario.keys import FILES, Key

MOST_CHANGES = 64
"""Greatest number of changes in one step (assumed)."""


class Changing(NamedTuple):
    """Key that can change in flight.

    Attributes:
        pattern: the key; ``[*]`` stands for any number. All keys inside it can change, too.
        what: what it is.
        rehearsed: whether a rehearsal of CMD CK depends on it; not if it is only seen or announced. The place and the
            direction of a camera are those of its housing, too, which collides.
    """

    pattern: str
    what: str
    rehearsed: bool = True


CHANGING = (
    Changing("limits", "limits of joints and of the point of resolution"),
    Changing("clearance", "clearances of caution and warning", rehearsed=False),
    Changing("arrive_within", "end sphere of the automatic modes"),
    Changing("arrive_within_angle", "end sphere of the automatic modes"),
    Changing("fly_by_within", "tolerance at fly-by points"),
    Changing("fly_by_angle", "tolerance at fly-by points"),
    Changing("guards", "whether computed modes slow the arm before stops and singularities"),
    Changing("docking", "axes that docking compares"),
    Changing("telemetry_delay", "delay of values, lamps and log", rehearsed=False),
    Changing("camera_delay", "delay of the pictures", rehearsed=False),
    Changing("cameras", "pan, tilt and zoom: the camera takes them at once", rehearsed=False),
    Changing("cargo[*].start", "place and motion of a free payload: it takes them at once"),
    Changing("arm.joint[*].hard", "stops of a joint"),
    Changing("arm.joint[*].soft", "stops of a joint"),
    Changing("arm.joint[*].reach", "stops of a joint"),
    Changing("arm.joint[*].servo", "rates of a joint"),
    Changing("arm.joint[*].coarse", "rates of a joint"),
    Changing("arm.joint[*].vernier", "rates of a joint"),
    Changing("arm.joint[*].acceleration", "rates of a joint"),
    Changing("arm.joint[*].least", "limits of telescope and prong"),
    Changing("arm.joint[*].greatest", "limits of telescope and prong"),
    Changing("arm.joint[*].rate", "rates of telescope and prong"),
    Changing("arm.por", "limits of the point of resolution"),
    Changing("arm.singular", "threshold of the lamp SINGULAR"),
    Changing("arm.servo", "constants of servos and brakes"),
    Changing("arm.shapes.camera[*].position", "place of a camera"),
    Changing("arm.shapes.camera[*].boresight", "direction of a camera"),
    Changing("arm.shapes.camera[*].up", "direction of a camera"),
    Changing("arm.shapes.camera[*].zero", "direction of a camera"),
    Changing("arm.shapes.camera[*].field_of_view", "field of view of a camera", rehearsed=False),
    Changing("arm.shapes.drive", "ranges and rates of a camera's drive", rehearsed=False),
    Changing("worksite.camera[*].position", "place of a camera"),
    Changing("worksite.camera[*].boresight", "direction of a camera"),
    Changing("worksite.camera[*].up", "direction of a camera"),
    Changing("worksite.camera[*].zero", "direction of a camera"),
    Changing("worksite.camera[*].field_of_view", "field of view of a camera", rehearsed=False),
    Changing("worksite.drive", "ranges and rates of a camera's drive", rehearsed=False),
    Changing("worksite.cargo[*].start", "place and motion of a free payload: it takes them at once"),
    Changing("worksite.seat[*].distance", "tolerances of a berth"),
    Changing("worksite.seat[*].angle", "tolerances of a berth"),
    Changing("worksite.seat[*].time", "time of a berth's latches"),
    Changing("worksite.acquisition", "tolerances of capture"),
    Changing("worksite.essential[*].depth", "permitted penetration"),
    Changing("worksite.translation", "speed of the orbiter's translation"),
    Changing("worksite.orbiter.jets", "jets of the orbiter"),
)
"""Keys that can change in flight; the first that fits counts."""

FIXED: tuple[tuple[str, str], ...] = (
    ("initial", "is where a run begins, and this run has begun; the panel can re-initialise it"),
    ("initialise", "is where a run begins; it counts in the next run"),
    ("phase", "belongs to the script, which is planned before the run"),
    ("sequence", "is stored before the run; key in a target instead"),
    ("step", "belongs to the task, which is planned before the run"),
    ("disturbance", "is planned before the run"),
    ("event", "is planned before the run"),
    ("mode", "is a switch of the panel: set it there"),
    ("rate", "is a switch of the panel: set it there"),
    ("law", "is a switch of the panel: set it there"),
    ("position_hold", "is a switch of the panel: set it there"),
    ("light", "is set with the switches of the lamps"),
    ("control_period", "is the step of the clock, in which all times of this run are counted"),
    ("command_delay", "has commands under way, which would be lost or arrive twice"),
    ("duration", "is the length of the run, by which it is recorded"),
    ("plant", "selects the equations of motion of this run"),
    ("dynamics", "selects the equations of motion of this run"),
    ("seed", "has been used at the start of the run"),
    ("soft_stops", "selects the laws of this run"),
    ("strict", "selects the laws of this run"),
    ("free_contact", "selects the laws of this run"),
    ("payload", "is a body, whose mass and shape the run was made with"),
    ("cargo", "is a body, whose mass and shape the run was made with"),
    ("dimensions", "gives the sizes of bodies, whose pairs are laid out before the run"),
    ("arm.joint", "is a length or an axis of the arm, for which its state and its laws were made"),
    ("arm.tip", "is a length of the arm, for which its state and its laws were made"),
    ("arm.mount", "is the place of the arm's base, from which all poses are measured"),
    ("arm.end_effector_roll", "is an angle of the arm, for which its state and its laws were made"),
    ("arm.turning", "is a weight of the arm's laws, which are made before the run"),
    ("arm.dimensions", "gives the lengths of the arm, for which its state and its laws were made"),
    ("arm.shapes", "is a shape of the arm, whose pairs are laid out before the run"),
    ("arm.*", "is a body or a mass of the arm, with which the run was made"),
    ("worksite.*", "is a body, whose pairs are laid out before the run"),
    ("arm", "selects the arm that flies this run"),
    ("worksite", "selects the worksite of this run"),
)
"""Keys that cannot change in flight, each with the reason; the first that fits counts."""
NAMES = ("name", "title", "source", "confidence", "label", "text", "kind", "units", "sources")
"""Last parts of keys whose values are texts."""
OTHERS = "is a text or a name, which no law reads"
"""Reason for all other keys that cannot change in flight."""


def changing(key: Key) -> Changing | None:
    """Return the row of a key that can change in flight; None if it cannot change."""
    if key.where[-1] in NAMES:
        return None
    return next((row for row in CHANGING if _fits(key, row.pattern)), None)


def obstacle(key: Key) -> str:
    """Return why a key cannot change in flight; "" if it can."""
    if changing(key) is not None:
        return ""
    if key.where[-1] in NAMES:
        return OTHERS
    return next((why for pattern, why in FIXED if _fits(key, pattern)), OTHERS)


def _fits(key: Key, pattern: str) -> bool:
    """Return whether a key is that of a pattern or inside it; ``[*]`` and ``*`` stand for any one part."""
    wanted = _parts(pattern)
    given = (*key.prefix, *key.where)
    return len(given) >= len(wanted) and all(
        w in (g, "*") if isinstance(g, str) else w == "*" for g, w in zip(given, wanted, strict=False)
    )


@lru_cache(maxsize=256)
def _parts(pattern: str) -> tuple[str, ...]:
    return tuple(pattern.replace("[*]", ".*").split("."))


def merged(before: tuple[str, ...], new: Mapping[str, str]) -> tuple[str, ...]:
    """Return changes in force and new ones, each as KEY=VALUE; a new value replaces that of the same key."""
    return _merged(before, tuple(new.items()))


@lru_cache(maxsize=64)
def _merged(before: tuple[str, ...], new: tuple[tuple[str, str], ...]) -> tuple[str, ...]:
    values = dict(map(parse_change, before))
    for key, value in new:
        where = parse_key(key)
        for other in [one for one in values if one[: len(where)] == where]:
            del values[other]  # also what is inside a table that is set as a whole: the newest value comes last
        values[where] = value_of(value)
    return tuple(change_text(where, value) for where, value in values.items())


def check_key(key: Key) -> None:
    """Check that a key exists, as far as its first name, and can change in flight.

    Raises:
        InputError: it does not exist, or cannot change; the message says why.
    """
    known = [field.encode_name for field in msgspec.structs.fields(FILES[key.kind])]
    if (first := key.where[0]) not in known:
        near = get_close_matches(str(first), known, 1)
        hint = f"; did you mean {place((*key.prefix, near[0]))}?" if near else f": they begin with {', '.join(known)}"
        raise InputError(f"{key.text}: no such key{hint}")
    if why := obstacle(key):
        raise InputError(f"{key.text} cannot change in flight: it {why}")
