"""Readings of the arm's motion."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from operator import truediv

from aftdeck.frames import quaternion_of_rows
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.readings.reading import XYZ, Along, Known, Reading, Recorded, Strip, pose, shown


def worst_rate(rates: Sequence[float], limits: Sequence[float]) -> tuple[float, int]:
    """Return the largest ratio |rate| / limit, and the index of its joint; the index is -1 if no joint moves."""
    parts = list(_shares(rates, limits))
    worst = max(parts)
    return worst, parts.index(worst) if worst > 0 else -1


def _shares(rates: Sequence[float], limits: Sequence[float]) -> Iterator[float]:
    """Return the ratios |rate| / limit of the joints."""
    return map(truediv, map(abs, rates), limits)


def _worst_commanded(s: Known) -> float:
    return max(_shares(s.frame.rates_commanded, s.frame.rate_limits))


_WORST = "Greatest commanded joint rate, as a fraction of the joint's limit at that time."
MOTION = (
    Reading(
        "por_speed",
        "measured speed of the point of resolution",
        lambda s: math.hypot(*s.frame.twist[3:]),
        quantity="speed",
        title="POR rate",
        commanded=lambda s: math.hypot(*s.frame.twist_demanded[3:]),
        strip=Strip(shown=True),
        metrics=(Recorded("greatest", "greatest_speed", "Greatest POR speed"),),
    ),
    Reading(
        "joint_rate",
        "greatest joint rate, as a fraction of the joint's limit at that time",
        lambda s: max(_shares(s.frame.rates, s.frame.rate_limits)),
        quantity="part of limit",
        commanded=_worst_commanded,
        strip=Strip(limit=1.0, shown=True),
        metrics=(Recorded("greatest", "worst_joint_rate", "Worst joint rate", _WORST, of=_worst_commanded),),
    ),
    Reading(
        "turn_rate",
        "angular rate of the tip",
        lambda s: math.hypot(*s.frame.twist[:3]),
        quantity="turn rate",
        title="POR turn rate",
        commanded=lambda s: math.hypot(*s.frame.twist_demanded[:3]),
        strip=Strip(),
        metrics=(
            Recorded("integral", "tip_rotation", "Tip rotation", "Sum of all angles by which the tip turned.", "angle"),
        ),
    ),
    Reading(
        "target_distance",
        "distance from the tip to the target",
        lambda s: None if s.frame.goal is None else s.frame.goal.distance,
        quantity="distance",
        title="Remaining distance",
        strip=Strip(),
        metrics=(Recorded("last", "target_distance", "Distance to target", quantity="length"),),
    ),
    Reading(
        "target_angle",
        "angle between the tip's attitude and the target's",
        lambda s: None if s.frame.goal is None else s.frame.goal.angle,
        quantity="angle",
        metrics=(Recorded("last", "target_angle", "Angle to target"),),
    ),
    shown(Frame, "ratio", "ratio", title="RATLMT ratio", strip=Strip()),
    shown(
        Frame,
        "singularity",
        "singular_distance",
        "singularities",
        of=lambda s: [abs(distance) for distance in s.frame.singularity],
        title="{part} singularity",
        strip=Strip(),
    ),
    shown(
        Frame,
        "angles",
        "angle",
        "joints",
        title="{part}",
        commanded=lambda s: s.frame.angles_commanded,
        strip=Strip(rests=False),
        group="angles",
        state="angle",
    ),
    shown(Frame, "rates", "rate", "joints", group="rates", state="rate"),
    shown(Frame, "rates_commanded", "rate_commanded", "joints", group="commanded"),
    *pose(Frame, "tip", group="tip", state="tip"),
    Reading(
        "attitude",
        "attitude of frame 7 (L), as a quaternion with w not negative",
        lambda s: quaternion_of_rows(s.frame.orientation),
        ("w", *XYZ),
        quantity="ratio",
        state="attitude",
    ),
    shown(Frame, "resolution", "por", XYZ, group="por"),
    shown(Frame, "twist", "por_turn_rate", XYZ, of=lambda s: s.frame.twist[:3], quantity="turn rate", group="por"),
    shown(Frame, "twist", "por_velocity", XYZ, of=lambda s: s.frame.twist[3:], quantity="speed", group="por"),
    shown(Along, "velocity", "velocity", XYZ, state="velocity"),
    shown(Along, "turning", "turning", XYZ, state="turning"),
    shown(Along, "to_go", "to_go", XYZ, state="to_go"),
    shown(Along, "rotation_to_go", "rotation_to_go", XYZ, state="rotation_to_go"),
)
"""Readings of the arm's motion."""
