"""Poses of the tip, the payloads and the targets at the time of a frame."""

from __future__ import annotations

import math

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import Pose
from aftdeck.matrices import dots, product
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import at_berth, at_payload, composed, inverted, scene_in_l, takes
from aftdeck.scenario.target import AtBerth, AtPayload, InFrame, RelativeTarget, Target
from aftdeck.simulation.frame import Frame
from aftdeck.tuples import Rows, Vec3
from aftdeck.worksite.berths.berth import Berth


class Places:
    """Poses in L of the things of one scenario, computed from frames.

    Attributes:
        berths: the worksite's berths by name.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._model, self._payloads = scenario.arm.model, scenario.payloads
        self._index = {payload.name: k for k, payload in enumerate(scenario.payloads)}
        self.berths = {berth.name: berth for berth in scenario.worksite.berths}
        self._scene = scene_in_l(scenario.arm.model.mount, scenario.worksite.origin)

    def tip(self, frame: Frame) -> Pose:
        """Return the pose of the tip."""
        return _pose(frame.position, frame.orientation)

    def payload(self, frame: Frame, k: int) -> Pose:
        """Return the pose of payload k."""
        payload = frame.work.cargo[k]
        return _pose(payload.position, payload.orientation)

    def carrier(self, frame: Frame, name: str) -> Pose:
        """Return the pose of a coordinate frame: ``orbiter``, ``space``, or a payload's."""
        if name in self._index:
            return self.payload(frame, self._index[name])
        if name == "orbiter":
            return self._scene
        if frame.dynamics is None:
            return Pose(self._scene.position - np.array(frame.work.orbiter), self._scene.rotation)
        orbiter = frame.dynamics.orbiter  # includes the displacement
        return composed(inverted(_pose(orbiter.position, orbiter.orientation)), self._scene)

    def held(self, frame: Frame) -> int | None:
        """Return the index of the held payload; None if the end effector holds none."""
        return next((k for k, payload in enumerate(frame.work.cargo) if payload.held), None)

    def target(self, frame: Frame, target: Target | RelativeTarget) -> Pose | None:
        """Return the pose of the tip at a target; None if the target is a berth and no payload is held."""
        match target:
            case Target():
                return target.pose
            case AtPayload(payload=k):
                return composed(self.payload(frame, k), at_payload(self._model, self._payloads[k], target))
            case InFrame():
                return composed(self.carrier(frame, target.frame), target.pose)
            case AtBerth():
                if (held := self.held(frame)) is None:
                    return None
                in_payload = composed(inverted(self.payload(frame, held)), self.tip(frame))
                return composed(self._seated(frame, target, held), in_payload)

    def above(self, frame: Frame, target: Target | RelativeTarget) -> float | None:
        """Return how far the tip is above a payload, or the held payload above a berth [m].

        The distance is measured along the way out, from the target without its `above`. None if the target is neither,
        or no payload is held above a berth.
        """
        out = self.way_out(frame, target)
        match target:
            case AtPayload(payload=k, above=above) if out is not None:
                pose = composed(self.payload(frame, k), at_payload(self._model, self._payloads[k], target))
                return above + _along(out, self.tip(frame).position - pose.position)
            case AtBerth(above=above) if out is not None and (held := self.held(frame)) is not None:
                pose = self._seated(frame, target, held)
                return above + _along(out, self.payload(frame, held).position - pose.position)
            case _:
                return None

    def way_out(self, frame: Frame, target: Target | RelativeTarget) -> Array | None:
        """Return the direction (3,) in L that leads away from a payload or a berth; None for another target.

        It leads back along the end effector's axis from a payload, up out of the bay, or out from a port.
        """
        match target:
            case AtPayload(payload=k):
                pose = composed(self.payload(frame, k), at_payload(self._model, self._payloads[k], target))
                return -pose.rotation[:, 0]
            case AtBerth():
                berth = self.berths[target.berth]
                return product(self.carrier(frame, berth.frame).rotation, berth.pose.rotation)[:, berth.out]
            case _:
                return None

    def fixture(self, frame: Frame) -> int | None:
        """Return the index of the payload whose fixture or bar is nearest to the tip; None if there is none."""
        tip = self.tip(frame).position
        able = (k for k, payload in enumerate(self._payloads) if takes(self._model, payload))
        return min(able, key=lambda k: self._away(frame, AtPayload(k), tip), default=None)

    def berth(self, frame: Frame, k: int) -> Berth | None:
        """Return the nearest berth that accepts payload k; None if there is none."""
        payload = self._payloads[k]
        fitting = [berth for berth in self.berths.values() if not berth.lacks(payload.probe, payload.trunnions)]
        here = self.payload(frame, k).position
        return min(
            fitting,
            key=lambda berth: math.dist(self._seated(frame, AtBerth(berth.name), k).position, here),
            default=None,
        )

    def _away(self, frame: Frame, target: AtPayload, tip: Array) -> float:
        pose = self.target(frame, target)
        assert pose is not None, "a payload always has a pose"
        return math.dist(pose.position, tip)

    def _seated(self, frame: Frame, target: AtBerth, k: int) -> Pose:
        berth = self.berths[target.berth]
        return composed(self.carrier(frame, berth.frame), at_berth(berth, self._payloads[k], target))


def _pose(position: Vec3, orientation: Rows) -> Pose:
    return Pose(np.array(position), np.array(orientation))


def _along(axis: Array, vector: Array) -> float:
    return float(dots(axis, vector))
