"""Check that a list in a scenario has one value for each joint of the arm, with the joint's unit."""

from __future__ import annotations

from collections.abc import Sequence

from aftdeck.arms.by_joint import misfits
from aftdeck.arms.load import ArmModel
from aftdeck.files import Where
from aftdeck.scenario.problems import Problems


def fits(problems: Problems, model: ArmModel, given: Sequence[object], where: Where) -> bool:
    """Return whether there is one value for each joint, with the unit of its kind; report what is wrong.

    Args:
        problems: collects the problems found.
        model: the arm.
        given: the list in the file.
        where: its place in the file.
    """
    found = list(misfits(model.joints, model.slides, given))
    for at, why in found:
        problems.add((*where, *at), why)
    return not found
