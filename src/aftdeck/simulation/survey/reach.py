"""Search for payloads at their start and targets of the script that are out of reach, for `simulation.survey`."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import msgspec
import numpy as np

from aftdeck.errors import AftdeckError
from aftdeck.files import Problem
from aftdeck.frames import Pose
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import at_cargo, at_seat, composed, inverted, scene_in_l, takes
from aftdeck.scenario.target import AtCargo, AtSeat, InFrame


class _Sent(NamedTuple):
    """Target of a phase: index of the phase, pose of the tip in the scene, length of the telescope then [m]."""

    phase: int
    tip: Pose
    stand: float


def reach(scenario: Scenario) -> Iterator[Problem]:
    """Yield payloads that the hand cannot reach in their start seat, and the first phase with a target out of reach.

    A pose is in reach if one of RMANGS's solutions lies inside the soft stops.
    """
    model, stand = scenario.arm.model, scenario.start.stand
    for k, one in enumerate(scenario.cargo):
        if one.start.seat and takes(model, one):
            tip = composed(one.start.pose, at_cargo(model, one, AtCargo(k)))
            if why := _beyond(scenario, tip, stand):
                yield Problem(("cargo", k), f"the hand cannot take {one.name} in the seat {one.start.seat!r}: {why}")
    for sent in _sent(scenario):
        if why := _beyond(scenario, sent.tip, sent.stand):
            name = scenario.phases[sent.phase].name
            yield Problem(("phase", sent.phase), f"the arm cannot reach the target of the phase {name!r}: {why}")
            return  # the script would end at this phase


def _sent(scenario: Scenario) -> Iterator[_Sent]:
    """Yield the targets of the script that are known without a run.

    Targets are unknown after the orbiter has moved. They are also unknown for payloads that move by themselves or were
    just docked or latched.
    """
    model, cargo, start = scenario.arm.model, scenario.cargo, scenario.start
    seats = {seat.name: seat for seat in scenario.worksite.seats}
    still = [not (one.limit_cycle or one.start.velocity.any() or one.start.rates.any()) for one in cargo]
    places = {one.name: one.start.pose for one, stays in zip(cargo, still, strict=True) if stays}
    held, grip, stand = -1, None, start.stand
    if start.grasped is not None:
        held = start.grasped.cargo
        took = _at(scenario, start.grasped.stand).forward(start.grasped.angles)
        grip = composed(inverted(cargo[held].start.pose), composed(inverted(_scene(scenario)), took))
    for k, phase in enumerate(scenario.phases):
        if any(phase.orbiter):
            return
        stand = stand if phase.stand_at is None else phase.stand_at
        tip: Pose | None = None
        match phase.target:
            case AtCargo(cargo=held):
                one = cargo[held]
                grip = at_cargo(model, one, phase.target)
                if one.name in places:
                    tip = composed(places[one.name], grip)
            case AtSeat(seat=name) as place if grip is not None:
                one, seat = cargo[held], seats[name]
                if phase.until is not None:  # the phase ends as soon as the seat takes the payload
                    place = msgspec.structs.replace(place, above=max(place.above, seat.distance))
                places[one.name] = at_seat(seat, one, place)
                tip = composed(places[one.name], grip)
            case InFrame(frame=name) if name in places or name not in {one.name for one in cargo}:
                tip = composed(places[name], phase.target.pose) if name in places else phase.target.pose
        if tip is not None and (phase.until is None or isinstance(phase.target, AtSeat)):
            yield _Sent(k, tip, stand)
        if phase.until is not None and isinstance(phase.target, AtSeat):
            places.pop(cargo[held].name, None)


def _beyond(scenario: Scenario, tip: Pose, stand: float) -> str:
    """Return why the arm cannot reach a pose in the scene inside its soft stops; "" if it can."""
    arm = _at(scenario, stand)
    low, high = arm.limits.soft.T
    try:
        found = arm.inverse(composed(_scene(scenario), tip), near=scenario.start.angles)
    except AftdeckError as error:
        return str(error)
    if ((low <= found) & (found <= high)).all(axis=1).any():
        return ""
    joint = int(np.maximum(low - found[0], found[0] - high).argmax())
    return f"{arm.model.joints[joint]} would be at {math.degrees(found[0, joint]):.4g} deg, outside its soft stops"


def _at(scenario: Scenario, stand: float) -> Arm:
    arm = scenario.arm
    return arm if arm.model.equipment.telescope is None else arm.at(stand=stand)


def _scene(scenario: Scenario) -> Pose:
    """Return the pose of the scene's frame in L."""
    return scene_in_l(scenario.arm.model.mount, scenario.worksite.origin)
