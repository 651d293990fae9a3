"""Remaining motion to the place where the operator's task needs the tip or the held payload."""

from __future__ import annotations

import math
from typing import NamedTuple

from aftdeck.bodies.placed import motion_left
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.target import AtBerth, AtPayload, RelativeTarget, Target
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.frame import Frame, Placed
from aftdeck.steering.mode import MODES
from aftdeck.task.places import Places
from aftdeck.worksite.conditions import all_ready

_NEAR_M, _NEAR_RAD = 0.016, math.radians(2.0)
"""Distance [m] and angle [rad] that count as arrived if neither a step nor a berth gives them.

A green component is below 1/sqrt(3) of the distance: less than half of the least window of a capture (0.75 in).
"""

_ROUNDED_M = 1e-6
"""Greatest difference, by rounding, of a distance that is computed in two ways [m]."""
_AWAY_M = 0.1
"""Distance above a payload or a berth from which on the place is named `above` or `before` it [m]."""


class Remaining(NamedTuple):
    """Remaining motion.

    Attributes:
        to: place for the operator: ``pin``, ``above bar``, ``Cargo bay``, ``target``, or a joint's name.
        pose: pose of the tip at this place, in L; None if a joint has to move.
        motion: motion of the tip to this pose, x to R x + p in L; None if a joint has to move.
        distance: distance that the tip, the held payload or a joint that slides still has to move [m]; 0 for one that
            turns.
        angle: remaining rotation [rad]; for a joint, the signed motion [rad or m].
        near: distance [m] and angle [rad] within which the tip has arrived; for a joint that slides, a length twice.
    """

    to: str
    pose: Placed | None
    motion: Placed | None
    distance: float
    angle: float
    near: tuple[float, float]

    @property
    def arrived(self) -> bool:
        """Whether the tip, or the joint, has arrived."""
        return self.distance <= self.near[0] and abs(self.angle) <= self.near[1]


def _ready(left: Remaining, frame: Frame) -> Remaining:
    """Return a motion to a fixture or a berth; if all conditions hold there, the tip has arrived."""
    if not all_ready(frame.work.conditions):
        return left
    # Twice the distance: a component has arrived within 1/sqrt(3) of the distance that counts.
    return left._replace(near=(max(left.near[0], 2.0 * left.distance), max(left.near[1], 2.0 * abs(left.angle))))


class Aims:
    """Finder of the place to which the operator has to move, for the frames of one scenario."""

    def __init__(self, scenario: Scenario) -> None:
        self.places = Places(scenario)
        self._joints, self.slides = scenario.arm.model.joints, scenario.arm.model.slides
        self._fixture = "pin" if scenario.arm.model.prong is None else "bar"

    def remaining(self, frame: Frame, step: TaskStep | None) -> Remaining | None:
        """Return the remaining motion; None if there is no place to move to.

        The present step of the task tells the place. Without it, an automatic mode moves to its target, an empty end
        effector to the nearest payload, and a held payload to the berth of the present objective.
        """
        if step is not None and step.joint is not None:
            angle = step.joint_at - frame.angles[step.joint]
            name, near = self._joints[step.joint].replace("_", " "), self._near(step)
            if self.slides[step.joint]:
                return Remaining(name, None, None, abs(angle), angle, (near[0], near[0]))
            return Remaining(name, None, None, 0.0, angle, near)
        target = self.target(frame, step)
        if target is None and frame.goal is not None and MODES[frame.mode].kind == "automatic":
            goal = Placed(frame.goal.position, frame.goal.rotation)
            return self._to(frame, "target", goal, self._near(step))
        pose = None if target is None else self.places.target(frame, target)
        if target is None or pose is None:
            return None
        match target:
            case AtBerth(berth=name, above=above):
                berth = self.places.berths[name]
                to = f"{berth.away} {berth.title}" if above > _AWAY_M else berth.title
                left = self._to(frame, to, pose, self._near(step, (berth.distance, berth.angle)))
                return left if above > _AWAY_M else _ready(left, frame)
            case AtPayload(above=above):
                to = f"above {self._fixture}" if above > _AWAY_M else self._fixture
                left = self._to(frame, to, pose, self._near(step))
                return left if above > _AWAY_M else _ready(left, frame)
            case _:
                return self._to(frame, "target", pose, self._near(step))

    def is_beyond(self, frame: Frame, step: TaskStep, distance: float) -> bool:
        """Return whether the remaining distance to a step's payload or berth is certainly greater than `distance` [m].

        The remaining motion takes many times as long. Of a distance that is about equal, False tells nothing.
        """
        held = self.places.held(frame)
        match step.target:
            case AtPayload() as target if held is None:
                at, to = frame.position, self.places.capture(frame, target)
            case AtBerth() as target if held is not None:
                at, to = frame.work.cargo[held].position, self.places.seated(frame, target, held)
            case _:
                return False
        return math.dist(at, to.position) > distance + _ROUNDED_M

    def target(self, frame: Frame, step: TaskStep | None) -> Target | RelativeTarget | None:
        """Return the target of the present step, or else of the present objective; None if there is none.

        A joint that has to move, and an automatic mode without a step's target, have none.
        """
        if step is not None and (step.joint is not None or step.target is not None):
            return None if step.joint is not None else step.target
        automatic = frame.goal is not None and MODES[frame.mode].kind == "automatic"
        return None if automatic else self._objective(frame)

    def _objective(self, frame: Frame) -> Target | RelativeTarget | None:
        if (k := self.places.held(frame)) is None:
            k = self.places.fixture(frame)
            return None if k is None else AtPayload(k)
        berth = None if frame.work.objective is None else self.places.berth(frame, k)
        return None if berth is None else AtBerth(berth.name)

    def _to(self, frame: Frame, to: str, pose: Placed, near: tuple[float, float]) -> Remaining:
        held = self.places.held(frame)
        point = frame.position if held is None else frame.work.cargo[held].position
        motion, distance, angle = motion_left(*pose, frame.position, frame.orientation, point)
        return Remaining(to, pose, Placed(*motion), distance, angle, near)

    def _near(self, step: TaskStep | None, usual: tuple[float, float] = (_NEAR_M, _NEAR_RAD)) -> tuple[float, float]:
        done = None if step is None else step.done
        return (
            usual[0] if done is None or done.within is None else float(done.within),
            usual[1] if done is None or done.within_angle is None else float(done.within_angle),
        )
