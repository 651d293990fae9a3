"""Search for payloads and targets of the script that the arm cannot reach, for `survey.pairs`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import msgspec
import numpy as np

from aftdeck.arms.by_joint import shown
from aftdeck.errors import AftdeckError
from aftdeck.files import Problem
from aftdeck.frames import Pose
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import at_berth, at_payload, composed, inverted, scene_in_l, takes
from aftdeck.scenario.target import AtBerth, AtPayload, InFrame


class _ScriptTarget(NamedTuple):
    """Target of a phase: index of the phase, pose of the tip in the scene, length of the telescope [m]."""

    phase: int
    tip: Pose
    stand: float


def reach(scenario: Scenario) -> Iterator[Problem]:
    """Yield the payloads that are out of reach in their start berth, and the first phase with a target out of reach.

    A pose is within reach if one of RMANGS's solutions is inside the soft stops.
    """
    model, stand = scenario.arm.model, scenario.start.stand
    for k, payload in enumerate(scenario.payloads):
        if payload.start.berth and takes(model, payload):
            tip = composed(payload.start.pose, at_payload(model, payload, AtPayload(k)))
            if why := _beyond(scenario, tip, stand):
                where = f"in the berth {payload.start.berth!r}"
                yield Problem(("cargo", k), f"the end effector cannot reach {payload.name} {where}: {why}")
    for target in _script_targets(scenario):
        if why := _beyond(scenario, target.tip, target.stand):
            name = scenario.phases[target.phase].name
            yield Problem(("phase", target.phase), f"the arm cannot reach the target of the phase {name!r}: {why}")
            return  # the script would end at this phase


def _script_targets(scenario: Scenario) -> Iterator[_ScriptTarget]:
    """Yield each target of the script if its pose is known without a run.

    All poses are unknown after the orbiter has moved. A pose relative to a payload is also unknown in two cases: the
    payload moves in free flight, or an earlier phase moved it to a berth and ended with an event such as docking.
    """
    model, payloads, start = scenario.arm.model, scenario.payloads, scenario.start
    berths = {berth.name: berth for berth in scenario.worksite.berths}
    still = [
        not (payload.limit_cycle or payload.start.velocity.any() or payload.start.rates.any()) for payload in payloads
    ]
    poses = {payload.name: payload.start.pose for payload, rests in zip(payloads, still, strict=True) if rests}
    held, tip_in_payload, stand = -1, None, start.stand
    if start.grasped is not None:
        held = start.grasped.payload
        tip_at_grasp = _at(scenario, start.grasped.stand).forward(start.grasped.angles)
        tip_in_payload = composed(
            inverted(payloads[held].start.pose), composed(inverted(_scene(scenario)), tip_at_grasp)
        )
    for k, phase in enumerate(scenario.phases):
        if any(phase.orbiter):
            return
        stand = stand if phase.stand_at is None else phase.stand_at
        tip: Pose | None = None
        match phase.target:
            case AtPayload(payload=held):
                payload = payloads[held]
                tip_in_payload = at_payload(model, payload, phase.target)
                if payload.name in poses:
                    tip = composed(poses[payload.name], tip_in_payload)
            case AtBerth(berth=name) as place if tip_in_payload is not None:
                payload, berth = payloads[held], berths[name]
                if phase.until is not None:  # the phase ends as soon as the berth fixes the payload
                    place = msgspec.structs.replace(place, above=max(place.above, berth.distance))
                poses[payload.name] = at_berth(berth, payload, place)
                tip = composed(poses[payload.name], tip_in_payload)
            case InFrame(frame=name) if name in poses or name not in {payload.name for payload in payloads}:
                tip = composed(poses[name], phase.target.pose) if name in poses else phase.target.pose
        if tip is not None and (phase.until is None or isinstance(phase.target, AtBerth)):
            yield _ScriptTarget(k, tip, stand)
        if phase.until is not None and isinstance(phase.target, AtBerth):
            poses.pop(payloads[held].name, None)


def _beyond(scenario: Scenario, tip: Pose, stand: float) -> str:
    """Return the reason why no joint angles inside the soft stops reach a pose in the scene; "" if some reach it."""
    arm = _at(scenario, stand)
    low, high = arm.limits.soft.T
    try:
        solutions = arm.inverse(composed(_scene(scenario), tip), near=scenario.start.angles)
    except AftdeckError as error:
        return str(error)
    if ((low <= solutions) & (solutions <= high)).all(axis=1).any():
        return ""
    nearest = solutions[0]
    joint = int(np.maximum(low - nearest, nearest - high).argmax())
    at = shown(nearest[joint], arm.model.slides[joint], ".4g")
    return f"{arm.model.joints[joint]} would be at {at}, outside its soft stops"


def _at(scenario: Scenario, stand: float) -> Arm:
    arm = scenario.arm
    return arm if arm.model.telescope is None else arm.at(stand=stand)


def _scene(scenario: Scenario) -> Pose:
    """Return the pose of the scene frame in L."""
    return scene_in_l(scenario.arm.model.mount, scenario.worksite.origin)
