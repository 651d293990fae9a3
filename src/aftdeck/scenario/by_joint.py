"""Check that a list in a scenario has one value for each joint of the arm."""

from __future__ import annotations

from collections.abc import Sequence

from aftdeck.arms.by_joint import misfit
from aftdeck.files import Where
from aftdeck.scenario.problems import Problems


def fits(problems: Problems, joints: tuple[str, ...], given: Sequence[object], where: Where) -> bool:
    """Return whether there is one value for each joint; report it if not.

    Args:
        problems: collects the problems found.
        joints: names of the arm's joints.
        given: the list in the file.
        where: its place in the file.
    """
    if why := misfit(joints, given):
        problems.add(where, why)
    return not why
