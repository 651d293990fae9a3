"""Checks of an arm file that field types cannot express: sources, names, order of limits, bodies, sum of the masses.

`arms.joint_check` checks the joints, `arms.dynamics` the brakes and springs, and `arms.links` the links that are rods.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from aftdeck.arms.body_file import BlockBody
from aftdeck.arms.covers import cover_problem
from aftdeck.arms.dynamics import drive_problems
from aftdeck.arms.geometry import FOOT, frame_of
from aftdeck.arms.joint_check import joint_problems
from aftdeck.arms.links import rod_problems
from aftdeck.arms.model import ArmFile, PorRow
from aftdeck.files import Problem

MASS_TOLERANCE = 1e-3
"""Greatest allowed difference between the sum of the parts' masses and the total mass, as a fraction of the sum [1]."""
LEAST_STEP = 0.001
"""Least difference of the masses of two rows of limits, between which limits are interpolated [kg] (assumed)."""


def arm_problems(file: ArmFile) -> list[Problem]:
    """Return every problem in a decoded arm file, each with its place in the file."""
    return [
        *joint_problems(file),
        *_body_problems(file),
        *_mass_problems(file),
        *rod_problems(file),
        *_por_problems(file.por),
        *drive_problems(file),
    ]


def _body_problems(file: ArmFile) -> Iterator[Problem]:
    frames = [FOOT, *(frame_of(joint.name) for joint in file.joint)]
    for i, body in enumerate(file.bodies):
        if body.frame not in frames:
            what = f"{body.frame!r} is not a frame of the arm; the frames are: {', '.join(frames)}"
            yield Problem(("bodies", i, "frame"), what)
        if problem := cover_problem(body, body.part):
            yield Problem(("bodies", i), problem)


def _mass_problems(file: ArmFile) -> Iterator[Problem]:
    """Yield a problem if the published mass is not the sum of the masses that a telescope does not carry alone."""
    if file.mass is None:
        return
    alone = frame_of(file.switched[0].name) if file.switched and file.switched[0] is file.joint[0] else ""
    links = [(FOOT, file.foot), *((frame_of(joint.name), joint.link) for joint in file.joint)]
    masses = [float(link.mass) for frame, link in links if link is not None and frame != alone]
    blocks = [body for body in file.bodies if isinstance(body, BlockBody) and body.frame != alone]
    total = sum(masses) + sum(float(block.mass) for block in blocks if block.mass is not None)
    if total and abs(total - file.mass.value) > MASS_TOLERANCE * total:
        what = f"has to be the sum of the masses of links and bodies, {total:g} kg; got {file.mass.value:g} kg"
        yield Problem(("mass",), what)


def _por_problems(rows: tuple[PorRow, ...]) -> list[Problem]:
    found = []
    if rows[0].mass != 0.0:
        found.append(
            Problem(
                ("por", 0, "mass"), f"the first row has to be for mass 0, without a payload; got {rows[0].mass:g} kg"
            )
        )
    for i, (low, high) in enumerate(pairwise(rows)):
        if high.mass < low.mass + LEAST_STEP:
            what = (
                f"masses have to increase from row to row by at least {LEAST_STEP:g} kg, got {high.mass:g} after "
                f"{low.mass:g} kg"
            )
            found.append(Problem(("por", i + 1, "mass"), what))
    for i, r in enumerate(rows):
        where, values = ("por", i), (r.vernier_translation, r.translation, r.vernier_rotation, r.rotation)
        if r.vernier_translation > r.translation or r.vernier_rotation > r.rotation:
            what = f"vernier limits have to be at most the coarse limits, got {', '.join(f'{v:g}' for v in values)}"
            found.append(Problem(where, what))
    return found
