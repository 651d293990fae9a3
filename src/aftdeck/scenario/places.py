"""Targets relative to an object: a payload to capture, a berth for the held payload, or the axes of a body."""

from __future__ import annotations

from typing import NamedTuple

import msgspec

from aftdeck.files import Where
from aftdeck.frames import Pose
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.poses import FRAMES, position_and_rotation, target
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.relative import at_berth, at_payload, composed, in_frame, inverted, scene_in_l, takes
from aftdeck.scenario.schema import PoseSpec
from aftdeck.scenario.target import AtBerth, AtPayload, RelativeTarget, Target
from aftdeck.worksite.model import Worksite
from aftdeck.worksite.payload import Payload


class TargetReferences(NamedTuple):
    """Objects relative to which a target or a start may be given, and the choice of inverse kinematics.

    Attributes:
        payloads: the scenario's payloads.
        worksite: the worksite, for its bodies and berths; None if the named worksite could not be read.
        strict: whether a pose is converted to joint angles by RMANGS as published, which returns only one branch.
    """

    payloads: tuple[Payload, ...]
    worksite: Worksite | None
    strict: bool = False


def is_relative(spec: PoseSpec) -> bool:
    """Return whether a pose is given relative to an object."""
    return spec.frame not in FRAMES or (spec.cargo, spec.seat, spec.above, spec.offset) != (None, None, None, None)


def goal(
    problems: Problems, arm: Arm, spec: PoseSpec, references: TargetReferences, where: Where
) -> Target | RelativeTarget | None:
    """Return a target as a pose, or as a relative target that is computed as the phase begins; None if it is wrong."""
    return place(problems, arm, spec, references, where) if is_relative(spec) else target(problems, arm, spec, where)


def place(
    problems: Problems, arm: Arm, spec: PoseSpec, references: TargetReferences, where: Where
) -> RelativeTarget | None:
    """Return the relative target for a pose given relative to an object; None if the pose or the worksite is wrong."""
    if references.worksite is None:
        return None
    if spec.cargo is None and spec.seat is None:
        return _in_frame(problems, spec, references, where)
    other_fields = msgspec.structs.replace(spec, cargo=None, seat=None, above=None, offset=None)
    if other_fields != PoseSpec() or None not in (spec.cargo, spec.seat):
        problems.add(where, "give either cargo or seat, with above and offset if needed, and no other field")
        return None
    above, (x, y, z) = float(spec.above or 0.0), spec.offset or (0.0, 0.0, 0.0)
    offset = float(x), float(y), float(z)
    if spec.seat is not None:
        seats = [berth.name for berth in references.worksite.berths]
        if spec.seat in seats:
            return AtBerth(spec.seat, above, offset)
        problems.add((*where, "seat"), f"no seat {spec.seat!r}: seats are {', '.join(seats) or 'none'}")
        return None
    index = payload_index(problems, arm, references.payloads, spec.cargo or "", (*where, "cargo"))
    return None if index is None else AtPayload(index, above, offset)


def payload_index(problems: Problems, arm: Arm, payloads: tuple[Payload, ...], name: str, where: Where) -> int | None:
    """Return the index of the scenario's payload named `name`; None if there is none or the arm cannot capture it."""
    names = [payload.name for payload in payloads]
    if name not in names:
        choices = f"cargoes are {', '.join(names)}" if names else "the scenario has none: add a [[cargo]]"
        problems.add(where, f"no cargo {name!r}: {choices}")
        return None
    if not takes(arm.model, payloads[names.index(name)]):
        fixture = "grapple fixture" if arm.model.prong is None else "bar"
        problems.add(where, f"{name!r} has no {fixture} for the end effector of {arm.model.name}")
        return None
    return names.index(name)


def at_the_start(
    problems: Problems,
    arm: Arm,
    spec: PoseSpec,
    references: TargetReferences,
    held: tuple[int, Pose] | None,
    where: Where,
) -> Pose | None:
    """Return in L a tip pose that is given relative to an object; None if the tip pose is wrong.

    The object is at its start pose.

    Args:
        problems: collects the problems found.
        arm: the arm, with its telescope at the length for this pose.
        spec: the decoded pose.
        references: the objects.
        held: index of the held payload, and its pose in the tip's frame; None if no payload is held.
        where: the pose's place in the file.
    """
    found = place(problems, arm, spec, references, where)
    if found is None or references.worksite is None:
        return None
    scene = scene_in_l(arm.model.mount, references.worksite.origin)
    if isinstance(found, AtPayload):
        payload = references.payloads[found.payload]
        return composed(scene, composed(payload.start.pose, at_payload(arm.model, payload, found)))
    if isinstance(found, AtBerth):
        if held is None:
            problems.add(where, "a pose at a berth (`seat`) needs a held payload: give `grasped` too")
            return None
        index, pose_at_tip = held
        payload = references.payloads[index]
        berth = next(berth for berth in references.worksite.berths if berth.name == found.berth)
        if lacking := berth.lacks(payload.probe, payload.trunnions):
            what = f"{payload.name!r} has no {lacking}, by which the berth {berth.name!r} holds a payload"
            problems.add(where, what)
            return None
        return composed(scene, composed(at_berth(berth, payload, found), inverted(pose_at_tip)))
    frame_pose = next((payload.start.pose for payload in references.payloads if payload.name == found.frame), None)
    return composed(scene, found.pose if frame_pose is None else composed(frame_pose, found.pose))


def _in_frame(problems: Problems, spec: PoseSpec, references: TargetReferences, where: Where) -> RelativeTarget | None:
    """Return the relative target for a pose in the axes of a body, a berth or a payload; None if the pose is wrong."""
    if spec.above is not None or spec.offset is not None:
        problems.add(where, "above and offset are allowed only with cargo or seat")
        return None
    pose = position_and_rotation(problems, spec, where)
    if pose is None or references.worksite is None:
        return None
    found = in_frame(references.worksite, references.payloads, spec.frame, pose)
    if found is None:
        names = [body.name for body in references.worksite.bodies] + [
            berth.name for berth in references.worksite.berths
        ]
        choices = ", ".join(dict.fromkeys([*FRAMES, *names, *(payload.name for payload in references.payloads)]))
        problems.add((*where, "frame"), f"no frame {spec.frame!r}: there are {choices}")
    return found
