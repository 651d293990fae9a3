"""Checks of an arm file of the family ``chain`` that field types cannot express."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.arms.chain import chain_length
from aftdeck.arms.geometry import FOOT, PRONG, STAND
from aftdeck.arms.joints import JointFile, Slide
from aftdeck.arms.limits import limit_problems, limits_of, rates_of
from aftdeck.arms.model import ChainArmFile
from aftdeck.bodies.mass_properties import impossible, tensor
from aftdeck.files import Problem
from aftdeck.matrices import length

RESERVED = tuple(name.removeprefix("arm.") for name in (FOOT, STAND, PRONG))
"""Names that no joint can have, because the frames of foot, telescope and prong have them."""
SHORTEST = 1e-3
"""Least length of the vector along a joint's axis [1], and of an arm [m] (assumed)."""


def joint_problems(file: ChainArmFile) -> list[Problem]:
    """Return a problem, with its place in the file, for each joint that cannot be."""
    found = []
    for i, joint in enumerate(file.joint):
        found += [Problem(("joint", i, *where), what) for where, what in _of_joint(joint)]
        if joint.name in RESERVED:
            what = f"{joint.name!r} names another frame of an arm; expected another name than {', '.join(RESERVED)}"
            found.append(Problem(("joint", i, "name"), what))
        if joint.name in file.joints[:i]:
            found.append(Problem(("joint", i, "name"), f"{joint.name!r} is already the name of another joint"))
    for problem in limit_problems(file.joints, limits_of(file), rates_of(file)):
        found.append(Problem(("joint",), problem.what))
    reach = chain_length([joint.step for joint in file.joint], file.tip.value)
    if reach < SHORTEST:
        what = (
            f"the distances from joint to joint and to the tip are {reach:g} m in all; expected {SHORTEST:g} m or more"
        )
        found.append(Problem(("tip",), what))
    if not any(joint.weight for joint in file.joint):
        found.append(Problem(("joint",), "every joint has the weight 0, so the sticks would move none"))
    return found


def _of_joint(joint: JointFile) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield what is wrong with one joint, and where in its table."""
    if isinstance(joint, Slide):
        yield ("kind",), f"{joint.name}: got slide, expected turn; lists of joints have no lengths yet, only angles"
    if length(joint.axis) < SHORTEST:
        yield ("axis",), f"expected the direction of an axis, got {', '.join(f'{part:g}' for part in joint.axis)}"
    if joint.link is None:
        return
    if why := impossible(tensor(joint.link.inertia)):
        yield ("link", "inertia"), why
