"""Checks of an arm file that field types cannot express: lengths, the order of the limits, and the sum of the masses.

`arms.bodies` checks the tables that only a concept arm has: `stand`, `booms` and `effector`.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from aftdeck.arms.bodies import body_problems
from aftdeck.arms.covers import cover_problem
from aftdeck.arms.geometry import linkage_of
from aftdeck.arms.limits import JointRates, Limits, limit_problems
from aftdeck.arms.model import ArmFile, HeadingArmFile, HeadingGeometry, PorRow, YawArmFile, YawGeometry
from aftdeck.files import Problem

MASS_TOLERANCE = 1e-3
"""Greatest allowed difference between the sum of the parts' masses and the total mass, as a fraction of the sum [1]."""


def arm_problems(file: ArmFile) -> list[Problem]:
    """Return every problem in a decoded arm file, each with its place in the file."""
    if isinstance(file, HeadingArmFile):
        found = _boom_problems(file.geometry) + body_problems(file)
    else:
        found = _geometry_problems(file.geometry) + _cover_problems(file)
    limits = Limits(*(np.array(getattr(file.limits, name).value) for name in Limits._fields))
    rates = JointRates(*(np.array(getattr(file.rates, name).value) for name in JointRates._fields))
    found += limit_problems(file.joints, limits, rates)
    if len(set(file.joints)) < len(file.joints):
        found.append(Problem(("joints",), f"has to be six different names, got {', '.join(file.joints)}"))
    if not 0.0 < file.limits.singular.value < 1.0:
        found.append(Problem(("limits", "singular"), f"has to be between 0 and 1, got {file.limits.singular.value:g}"))
    return found + _por_problems(file.por) + _mass_problems(file)


def _geometry_problems(g: YawGeometry) -> list[Problem]:
    lengths = {
        "shoulder_yaw_to_pitch": g.shoulder_yaw_to_pitch.value,
        "wrist_pitch_to_yaw": g.wrist_pitch_to_yaw.value,
        "wrist_yaw_to_tip": g.wrist_yaw_to_tip.value,
    }
    found = [Problem(("geometry", name), f"has to be 0 or more, got {v:g} m") for name, v in lengths.items() if v < 0.0]
    for name, (along, _) in (("upper_arm", g.upper_arm.value), ("lower_arm", g.lower_arm.value)):
        if along <= 0.0:
            found.append(Problem(("geometry", name), f"the length along the arm has to be above 0, got {along:g} m"))
    return found


def _cover_problems(file: YawArmFile) -> list[Problem]:
    frames = linkage_of(file).frames
    found = []
    for i, body in enumerate(file.bodies):
        if body.frame not in frames:
            what = f"{body.frame!r} is not a frame of the arm; the frames are: {', '.join(frames)}"
            found.append(Problem(("bodies", i, "frame"), what))
        if problem := cover_problem(body, body.part):
            found.append(Problem(("bodies", i), problem))
    return found


def _boom_problems(g: HeadingGeometry) -> list[Problem]:
    lengths = {"upper_arm": g.upper_arm.value, "lower_arm": g.lower_arm.value}
    return [Problem(("geometry", name), f"has to be above 0, got {v:g} m") for name, v in lengths.items() if v <= 0.0]


def _por_problems(rows: tuple[PorRow, ...]) -> list[Problem]:
    found = []
    if rows[0].mass != 0.0:
        found.append(
            Problem(
                ("por", 0, "mass"), f"the first row has to be for mass 0, without a payload; got {rows[0].mass:g} kg"
            )
        )
    for i, (low, high) in enumerate(pairwise(rows)):
        if high.mass <= low.mass:
            what = f"masses have to increase from row to row, got {high.mass:g} after {low.mass:g} kg"
            found.append(Problem(("por", i + 1, "mass"), what))
    for i, r in enumerate(rows):
        where, values = ("por", i), (r.vernier_translation, r.translation, r.vernier_rotation, r.rotation, r.reached_in)
        if min(values) <= 0.0:
            found.append(
                Problem(where, f"speeds and the time have to be above 0, got {', '.join(f'{v:g}' for v in values)}")
            )
        if r.vernier_translation > r.translation or r.vernier_rotation > r.rotation:
            what = f"vernier limits have to be at most the coarse limits, got {', '.join(f'{v:g}' for v in values)}"
            found.append(Problem(where, what))
    return found


def _mass_problems(file: ArmFile) -> list[Problem]:
    parts, published = file.masses.parts.value, file.masses.total.value
    total = sum(getattr(parts, name) for name in parts.__struct_fields__)
    if abs(total - published) <= MASS_TOLERANCE * total:
        return []
    what = f"has to be the sum of the parts' masses, {total:g} kg; got {published:g} kg"
    return [Problem(("masses", "total"), what)]
