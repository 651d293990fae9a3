"""How the arm starts (RMSIST): the whole problem, and the parts of it that can be begun anew."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from aftdeck.arms.geometry import frozen
from aftdeck.errors import AftdeckError, InputError
from aftdeck.files import Where
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.model import Grasped, Part, Start
from aftdeck.scenario.poses import joint_angles, pose_in_l
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import GraspSpec, Initial, InitialiseSpec
from aftdeck.units import Length


def parts(
    problems: Problems, arm: Arm, spec: InitialiseSpec, full: Start | None, cargo: Sequence[str]
) -> dict[Part, Start]:
    """Where the parts of the problem begin; none where the scenario gives none."""
    given: dict[Part, Initial | None] = {
        "acquisition": spec.acquisition,
        "extraction": spec.extraction,
        "manoeuvring": spec.manoeuvring,
    }
    found = {
        part: start(problems, arm, initial, cargo, ("initialise", part))
        for part, initial in given.items()
        if initial is not None
    }
    begun: dict[Part, Start] = {part: begin for part, begin in found.items() if begin is not None}
    return {"full problem": full, **begun} if begun and full is not None else {}


def start(problems: Problems, arm: Arm, initial: Initial, cargo: Sequence[str], where: Where) -> Start | None:
    """RMSIST: how the arm starts; None where it is wrong."""
    standing = _standing(problems, arm, initial.stand, (*where, "stand"))
    rates = frozen(initial.rates or [0.0] * 6)
    for joint, rate, most in zip(arm.joints, rates, arm.rates.servo, strict=True):
        if abs(rate) > most:
            problems.wrong(
                (*where, "rates"), f"{joint} starts at {rate:g} rad/s; its servo gives at most {most:g} rad/s"
            )
    angles = _angles(problems, standing, initial, where)
    grasped = None if initial.grasped is None else _grasped(problems, arm, initial.grasped, cargo, where)
    if angles is None:
        return None
    return Start(angles, rates, float(standing.model.links[0]), grasped)


def _standing(problems: Problems, arm: Arm, stand: Length | None, where: Where) -> Arm:
    """The arm with its telescope at a length."""
    try:
        return arm if stand is None else Arm(arm.model.at(float(stand)))
    except InputError as error:
        problems.wrong(where, str(error))
        return arm


def _angles(problems: Problems, arm: Arm, initial: Initial, where: Where) -> np.ndarray | None:
    """Joint angles as given, or those of a pose through RMANGS."""
    if initial.joints is not None and initial.pose is None:
        return joint_angles(problems, arm, initial.joints, (*where, "joints"))
    if initial.pose is None or initial.joints is not None:
        problems.wrong(where, "give either joints (six angles) or a pose")
        return None
    pose = pose_in_l(problems, arm, initial.pose, (*where, "pose"))
    if pose is None:
        return None
    try:
        return frozen(arm.inverse(pose, near=initial.near)[0])
    except AftdeckError as error:
        problems.wrong((*where, "pose"), str(error))
        return None


def _grasped(problems: Problems, arm: Arm, spec: GraspSpec, cargo: Sequence[str], where: Where) -> Grasped | None:
    where = (*where, "grasped")
    standing = _standing(problems, arm, spec.stand, (*where, "stand"))
    angles = joint_angles(problems, standing, spec.joints, (*where, "joints"))
    if spec.cargo not in cargo:
        there = f"there is {', '.join(cargo)}" if cargo else "the scenario has none: add a [[cargo]]"
        problems.wrong((*where, "cargo"), f"no cargo {spec.cargo!r}: {there}")
        return None
    if angles is None:
        return None
    return Grasped(cargo.index(spec.cargo), angles, float(standing.model.links[0]))
