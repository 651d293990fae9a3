"""Initial states of the arm (RMSIST), for the full problem and for the parts to which a run can be re-initialised."""

from __future__ import annotations

import msgspec
import numpy as np

from aftdeck.arms.geometry import frozen
from aftdeck.errors import AftdeckError, InputError
from aftdeck.files import Where
from aftdeck.frames import Pose
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.by_joint import fits
from aftdeck.scenario.model import Grasped, Start
from aftdeck.scenario.places import TargetReferences, at_the_start, is_relative, payload_index
from aftdeck.scenario.poses import joint_angles, pose_in_l
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.relative import composed, inverted, scene_in_l
from aftdeck.scenario.schema import Initial, InitialiseSpec, JointAngles, Part, PoseSpec
from aftdeck.units import Length


def parts(
    problems: Problems, arm: Arm, spec: InitialiseSpec, full: Start | None, references: TargetReferences
) -> dict[Part, Start]:
    """Return the initial state of each part of the problem that the scenario describes, and of the full problem.

    The result is empty if the scenario describes no part, or if `full`, the state of the full problem, is None.
    """
    tables: dict[Part, Initial | None] = {
        "acquisition": spec.acquisition,
        "extraction": spec.extraction,
        "manoeuvring": spec.manoeuvring,
    }
    found = {
        part: start(problems, arm, initial, references, ("initialise", part))
        for part, initial in tables.items()
        if initial is not None
    }
    complete: dict[Part, Start] = {part: state for part, state in found.items() if state is not None}
    return {"full problem": full, **complete} if complete and full is not None else {}


def start(problems: Problems, arm: Arm, initial: Initial, references: TargetReferences, where: Where) -> Start | None:
    """Return the initial state of the arm (RMSIST); None if its table is wrong."""
    raised = _with_telescope_at(problems, arm, initial.stand, (*where, "stand"))
    if initial.near is not None and not fits(problems, arm.model, initial.near, (*where, "near")):
        initial = msgspec.structs.replace(initial, near=None)
    rates = frozen(np.zeros(len(arm.joints)))
    if initial.rates is not None and fits(problems, arm.model, initial.rates, (*where, "rates")):
        rates = frozen(initial.rates)
    for joint, slides, rate, limit in zip(arm.joints, arm.model.slides, rates, arm.rates.servo, strict=True):
        if abs(rate) > limit:
            unit = "m/s" if slides else "rad/s"
            text = f"{joint} starts at {rate:g} {unit}; its servo gives at most {limit:g} {unit}"
            problems.add((*where, "rates"), text)
    grasped = None if initial.grasped is None else _grasped(problems, arm, initial, references, where)
    angles = _angles(problems, raised, initial, references, grasped, where)
    if angles is None:
        return None
    return Start(angles, rates, float(raised.model.links[0]), grasped)


def _with_telescope_at(problems: Problems, arm: Arm, stand: Length | None, where: Where) -> Arm:
    """Return the arm with its telescope at the length `stand`; if `stand` is None, at the length in the arm's file."""
    try:
        return arm if stand is None else Arm(arm.model.at(float(stand)))
    except InputError as error:
        problems.add(where, str(error))
        return arm


def _angles(
    problems: Problems, arm: Arm, initial: Initial, references: TargetReferences, grasped: Grasped | None, where: Where
) -> np.ndarray | None:
    """Return the joint angles of an initial state (n,) [rad]; None if its table is wrong.

    The table gives the angles or a pose of the tip. For a pose, RMANGS as published gives the angles if the scenario is
    strict and the table has no `near`.
    """
    if initial.joints is not None and initial.pose is None:
        return joint_angles(problems, arm, initial.joints, (*where, "joints"))
    if initial.pose is None or initial.joints is not None:
        problems.add(where, "give either joints (the angle of each joint) or a pose")
        return None
    where = (*where, "pose")
    if is_relative(initial.pose):
        held = None if grasped is None else _held_from_start(arm, references, grasped)
        pose = at_the_start(problems, arm, initial.pose, references, held, where)
    else:
        pose = pose_in_l(problems, arm, initial.pose, where)
    if pose is None or not references.strict or initial.near is not None:
        return None if pose is None else _joint_angles_for(problems, arm, pose, initial.near, where)
    try:
        return joint_angles(problems, arm, arm.rmangs(pose).tolist(), where)
    except AftdeckError as error:
        problems.add(where, str(error))
        return None


def _joint_angles_for(
    problems: Problems, arm: Arm, pose: Pose, near: JointAngles | None, where: Where
) -> np.ndarray | None:
    """Return the joint angles for a tip pose in L, in the branch nearest to `near`; None if the pose is unreachable."""
    try:
        return frozen(arm.inverse(pose, near=near)[0])
    except AftdeckError as error:
        problems.add(where, str(error))
        return None


def _grasped(
    problems: Problems, arm: Arm, initial: Initial, references: TargetReferences, where: Where
) -> Grasped | None:
    spec, where = initial.grasped, (*where, "grasped")
    assert spec is not None, "the caller has checked that the table has `grasped`"
    raised = _with_telescope_at(problems, arm, spec.stand, (*where, "stand"))
    if references.worksite is None:
        return None  # the worksite's error is already reported; do not report a missing payload too
    index = payload_index(problems, arm, references.payloads, spec.cargo, (*where, "cargo"))
    angles = None
    if (spec.joints is None) == (spec.above is None):
        problems.add(where, "give either `joints` (the angle of each joint) or `above`")
    elif spec.joints is not None:
        angles = joint_angles(problems, raised, spec.joints, (*where, "joints"))
    elif index is not None:
        above_payload = PoseSpec(cargo=spec.cargo, above=spec.above)
        pose = at_the_start(problems, raised, above_payload, references, None, where)
        angles = None if pose is None else _joint_angles_for(problems, raised, pose, initial.near, where)
    return None if index is None or angles is None else Grasped(index, angles, float(raised.model.links[0]))


def _held_from_start(arm: Arm, references: TargetReferences, grasped: Grasped) -> tuple[int, Pose]:
    """Return the index of the payload that is held from the start, and the payload's pose in the tip's frame."""
    assert references.worksite is not None, "only a payload of a worksite can be grasped"
    scene = scene_in_l(arm.model.mount, references.worksite.origin)
    payload = composed(scene, references.payloads[grasped.payload].start.pose)
    telescope = grasped.stand != float(arm.model.links[0])
    tip = (arm.at(stand=grasped.stand) if telescope else arm).forward(grasped.angles)
    return grasped.payload, composed(inverted(tip), payload)
