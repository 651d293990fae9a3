"""Checks of an arm file's joints that field types cannot express."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.arms.chain import chain_length
from aftdeck.arms.geometry import FOOT, linkage_of
from aftdeck.arms.joints import JointFile, Slide, SourcesFile
from aftdeck.arms.limits import limit_problems, limits_of, rates_of
from aftdeck.arms.link_file import BodyLink, LinkFile
from aftdeck.arms.model import ArmFile
from aftdeck.arms.switched import TELESCOPE, carrier_of
from aftdeck.bodies.mass_properties import impossible, tensor
from aftdeck.files import Problem, Where
from aftdeck.matrices import length
from aftdeck.tuples import MOST_JOINTS

RESERVED = FOOT.removeprefix("arm.")
"""Name that no joint can have, because the foot's frame has it."""
SHORTEST = 1e-3
"""Least length of the vector along a joint's axis [1], and of an arm [m] (assumed)."""


def joint_problems(file: ArmFile) -> list[Problem]:
    """Return a problem, with its place in the file, for each joint that cannot be."""
    if not 1 <= len(file.steered) <= MOST_JOINTS:
        what = f"expected 1 to {MOST_JOINTS} joints that steering drives, got {len(file.steered)}"
        return [Problem(("joint",), what)]
    found = list(_unsourced(file, file.foot, ("foot",), None))
    names = [joint.name for joint in file.joint]
    for i, joint in enumerate(file.joint):
        found += [Problem(("joint", i, *where), what) for where, what in _of_joint(file, joint)]
        if joint.name == RESERVED:
            what = f"{joint.name!r} names the frame of the foot; expected another name"
            found.append(Problem(("joint", i, "name"), what))
        if joint.name in names[:i]:
            what = f"the joints need different names; {joint.name!r} is already the name of another joint"
            found.append(Problem(("joint", i, "name"), what))
    numbers = [file.joint.index(joint) for joint in file.steered]
    for limit in limit_problems(file.joints, file.slides, limits_of(file), rates_of(file)):
        found.append(Problem(("joint", numbers[limit.joint], limit.quantity), limit.what))
    reach = chain_length([joint.step for joint in file.steered], file.tip.value)
    if reach < SHORTEST:
        what = (
            f"the distances from joint to joint and to the tip are {reach:g} m in all; expected {SHORTEST:g} m or more"
        )
        found.append(Problem(("tip",), what))
    if not any(joint.weight for joint in file.steered):
        found.append(Problem(("joint",), "every joint has the weight 0, so the sticks would move none"))
    return found or [*_slide_problems(file)]


def _of_joint(file: ArmFile, joint: JointFile) -> Iterator[tuple[Where, str]]:
    """Yield what is wrong with one joint, and where in its table."""
    if length(joint.axis) < SHORTEST:
        yield ("axis",), f"expected the direction of an axis, got {', '.join(f'{part:g}' for part in joint.axis)}"
    if (joint.source is None) != (joint.confidence is None):
        yield (), "expected `source` and `confidence`, or neither"
    if joint.source is None:
        for problem in (*_unsourced(file, joint, (), None), *_unsourced(file, joint.link, (), joint.name)):
            yield problem.where, problem.what
    if isinstance(joint.link, BodyLink) and (why := impossible(tensor(joint.link.inertia))):
        yield ("link", "inertia"), why


def _unsourced(file: ArmFile, table: JointFile | LinkFile | None, where: Where, name: str | None) -> Iterator[Problem]:
    """Yield a problem for each quantity of a joint or link that has no source."""
    for quantity in () if table is None else table.__struct_fields__:
        given = quantity in SourcesFile.__struct_fields__ and getattr(table, quantity) is not None
        if given and getattr(file.sources, quantity) is None:
            of = "" if name is None else f" of the link behind {name}"
            yield Problem(where, f"no source of `{quantity}`{of}: expected one here, or [sources.{quantity}]")


def _slide_problems(file: ArmFile) -> Iterator[Problem]:
    """Yield what is wrong with the joints that switches drive; the laws serve one telescope and one prong."""
    if len(file.switched) == 1:
        what = "the laws place a telescope and a prong together; expected both, or neither"
        yield Problem(("joint", file.joint.index(file.switched[0])), what)
    for k, slide in enumerate(file.switched):
        least, greatest, start, _ = slide.travel()
        where: Where = ("joint", file.joint.index(slide))
        if slide.driver in (other.driver for other in file.switched[:k]):
            yield Problem((*where, "driver"), f"the {slide.driver} switch already drives another joint")
        of_switch = _telescope_problems if slide.driver == TELESCOPE else _prong_problems
        for within, what in of_switch(file, slide):
            yield Problem((*where, *within), what)
        if not (least <= start <= greatest and least < greatest):
            what = f"expected least <= start <= greatest, got {least:g}, {start:g}, {greatest:g} m"
            yield Problem(where, what)


def _telescope_problems(file: ArmFile, telescope: Slide) -> Iterator[tuple[Where, str]]:
    """Yield what is wrong with a telescope, and where in its table."""
    if telescope.on is not None:
        yield ("on",), "a telescope is on the foot; leave `on` out"
    if file.joint[0] != telescope or tuple(telescope.axis) != (0.0, 0.0, -1.0) or any(telescope.step):
        yield (), "a telescope is the first joint, at L's origin, with the axis 0, 0, -1"
    if any(file.steered[0].step) or linkage_of(file).links[0] != telescope.travel().start:
        yield (), "expected the first steered joint (with a closed form, the second too) at the telescope's end"


def _prong_problems(file: ArmFile, prong: Slide) -> Iterator[tuple[Where, str]]:
    """Yield what is wrong with a prong, and where in its table."""
    last = file.steered[-1].name
    if carrier_of(file, prong) != last or tuple(prong.axis) != (0.0, 1.0, 0.0) or any(prong.step):
        yield (), f"a prong is on the last joint that steering drives, {last}, with the axis 0, 1, 0 and no step"
    if prong.facing is None or not prong.travel().greatest < prong.facing.value:
        yield (), "the prong closes towards the fixed finger: expected `facing`, a coordinate greater than `greatest`"
