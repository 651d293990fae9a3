"""Targets given by what is there when a phase begins: a payload to take, a seat to bring it to."""

from __future__ import annotations

from typing import NamedTuple

import msgspec

from aftdeck.arms.load import ArmModel
from aftdeck.arms.model import HeadingArmFile
from aftdeck.files import Where
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.poses import target
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import PoseSpec
from aftdeck.scenario.target import Place, Target
from aftdeck.worksite.model import Cargo


class Things(NamedTuple):
    """What a phase's target may be given by.

    Attributes:
        cargo: the scenario's payloads.
        seats: names of the worksite's seats.
    """

    cargo: tuple[Cargo, ...]
    seats: tuple[str, ...]


def goal(problems: Problems, arm: Arm, spec: PoseSpec, things: Things, where: Where) -> Target | Place | None:
    """A target as a pose, or as a place that is found when the phase begins; None where it is wrong."""
    if spec.cargo is None and spec.seat is None:
        return target(problems, arm, spec, where)
    if msgspec.structs.replace(spec, cargo=None, seat=None, above=None) != PoseSpec() or None not in (
        spec.cargo,
        spec.seat,
    ):
        problems.wrong(where, "give cargo or seat, with above where it is short of it, and nothing else")
        return None
    above = float(spec.above or 0.0)
    if spec.seat is not None:
        if spec.seat not in things.seats:
            problems.wrong((*where, "seat"), f"no seat {spec.seat!r}: there is {', '.join(things.seats) or 'none'}")
            return None
        return Place(None, spec.seat, above)
    names = [one.name for one in things.cargo]
    if spec.cargo not in names:
        there = f"there is {', '.join(names)}" if names else "the scenario has none: add a [[cargo]]"
        problems.wrong((*where, "cargo"), f"no cargo {spec.cargo!r}: {there}")
        return None
    k = names.index(spec.cargo)
    if not _takes(arm.model, things.cargo[k]):
        problems.wrong((*where, "cargo"), f"{spec.cargo!r} has nothing that the hand of {arm.model.name} takes")
        return None
    return Place(k, "", above)


def _takes(model: ArmModel, cargo: Cargo) -> bool:
    """Whether a payload has what this arm's hand takes hold of: a bar, or a grapple fixture."""
    return (cargo.receptacle if isinstance(model.source, HeadingArmFile) else cargo.grapple) is not None
