"""Checks of an arm file that field types cannot express: bodies, the order of the limits, and the sum of the masses.

`arms.bodies` checks the tables that only a concept arm has: `stand`, `booms` and `effector`. `arms.dynamics` checks
the brakes, and `arms.links` the links of an arm of the Shuttle's family.
"""

from __future__ import annotations

from itertools import pairwise

from aftdeck.arms.blocks import blocks_of
from aftdeck.arms.bodies import body_problems
from aftdeck.arms.chain_check import joint_problems
from aftdeck.arms.covers import corners, cover_problem
from aftdeck.arms.dynamics import drive_problems
from aftdeck.arms.geometry import frames_of, linkage_of
from aftdeck.arms.limits import limit_problems, limits_of, rates_of
from aftdeck.arms.links import link_problems
from aftdeck.arms.model import ArmFile, ChainArmFile, HeadingArmFile, PorRow, YawArmFile
from aftdeck.bodies.hexahedron_check import hexahedron
from aftdeck.errors import InputError
from aftdeck.files import Problem

MASS_TOLERANCE = 1e-3
"""Greatest allowed difference between the sum of the parts' masses and the total mass, as a fraction of the sum [1]."""

LEAST_STEP = 0.001
"""Least difference of the masses of two rows of limits, between which limits are interpolated [kg] (assumed)."""


def arm_problems(file: ArmFile) -> list[Problem]:
    """Return every problem in a decoded arm file, each with its place in the file."""
    found = body_problems(file) if isinstance(file, HeadingArmFile) else _cover_problems(file)
    if isinstance(file, ChainArmFile):
        found += joint_problems(file)
    else:
        found += limit_problems(file.joints, limits_of(file), rates_of(file))
        if len(set(file.joints)) < len(file.joints):
            found.append(Problem(("joints",), f"has to be different names, got {', '.join(file.joints)}"))
        found += _mass_problems(file)
    if not found and isinstance(file, HeadingArmFile):
        found = _block_problems(file)
    if isinstance(file, YawArmFile):
        found += link_problems(file)
    return found + _por_problems(file.por) + drive_problems(file)


_TABLE_OF = {"stand": "stand", "telescope": "stand", **dict.fromkeys(("palm", "fixed finger", "prong"), "effector")}
"""Table of a block's dimensions, for the blocks whose table is not `booms`."""


def _block_problems(file: HeadingArmFile) -> list[Problem]:
    """Return a problem for each body of a concept arm that is too thin to be a solid."""
    found = []
    for block in blocks_of(file, linkage_of(file).frames):
        try:
            hexahedron(corners(block.low, block.high, block.axes), block.part)
        except InputError as error:
            found.append(Problem((_TABLE_OF.get(block.part, "booms"),), str(error)))
    return found


def _cover_problems(file: YawArmFile | ChainArmFile) -> list[Problem]:
    frames = frames_of(*file.joints) if isinstance(file, ChainArmFile) else linkage_of(file).frames
    found = []
    for i, body in enumerate(file.bodies):
        if body.frame not in frames:
            what = f"{body.frame!r} is not a frame of the arm; the frames are: {', '.join(frames)}"
            found.append(Problem(("bodies", i, "frame"), what))
        if problem := cover_problem(body, body.part):
            found.append(Problem(("bodies", i), problem))
    return found


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


def _mass_problems(file: YawArmFile | HeadingArmFile) -> list[Problem]:
    parts, published = file.masses.parts.value, file.masses.total.value
    total = sum(getattr(parts, name) for name in parts.__struct_fields__)
    if abs(total - published) <= MASS_TOLERANCE * total:
        return []
    what = f"has to be the sum of the parts' masses, {total:g} kg; got {published:g} kg"
    return [Problem(("masses", "total"), what)]
