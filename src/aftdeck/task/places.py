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
        self._captures: dict[AtPayload, Pose] = {}  # in the payload's axes
        self._seats: dict[tuple[AtBerth, int], Pose] = {}  # in the berth's frame; in L, if this is the orbiter
        self._outs: dict[str, Array] = {}  # in L, for berths of the orbiter

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
            case AtPayload():
                return self.capture(frame, target)
            case InFrame():
                return composed(self.carrier(frame, target.frame), target.pose)
            case AtBerth():
                if (held := self.held(frame)) is None:
                    return None
                in_payload = composed(inverted(self.payload(frame, held)), self.tip(frame))
                return composed(self.seated(frame, target, held), in_payload)

    def above(self, frame: Frame, target: Target | RelativeTarget) -> float | None:
        """Return how far the tip is above a payload, or the held payload above a berth [m].

        The distance is measured along the way out, from the target without its `above`. None if the target is neither,
        or no payload is held above a berth.
        """
        match target:
            case AtPayload(above=above):
                pose = self.capture(frame, target)
                return above + _along(-pose.rotation[:, 0], np.array(frame.position) - pose.position)
            case AtBerth(above=above) if (held := self.held(frame)) is not None:
                pose, at = self.seated(frame, target, held), np.array(frame.work.cargo[held].position)
                return above + _along(self._out(frame, self.berths[target.berth]), at - pose.position)
            case _:
                return None

    def way_out(self, frame: Frame, target: Target | RelativeTarget) -> Array | None:
        """Return the direction (3,) in L that leads away from a payload or a berth; None for another target.

        It leads back along the end effector's axis from a payload, up out of the bay, or out from a port.
        """
        match target:
            case AtPayload():
                return -self.capture(frame, target).rotation[:, 0]
            case AtBerth():
                return self._out(frame, self.berths[target.berth])
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
            key=lambda berth: math.dist(self.seated(frame, AtBerth(berth.name), k).position, here),
            default=None,
        )

    def _away(self, frame: Frame, target: AtPayload, tip: Array) -> float:
        pose = self.target(frame, target)
        assert pose is not None, "a payload always has a pose"
        return math.dist(pose.position, tip)

    def capture(self, frame: Frame, target: AtPayload) -> Pose:
        """Return the pose of the tip at a target over a payload."""
        if target not in self._captures:
            self._captures[target] = at_payload(self._model, self._payloads[target.payload], target)
        return composed(self.payload(frame, target.payload), self._captures[target])

    def seated(self, frame: Frame, target: AtBerth, k: int) -> Pose:
        """Return the pose of payload k at a target in a berth."""
        berth, fixed = self.berths[target.berth], (target, k)
        if fixed not in self._seats:
            seat = at_berth(berth, self._payloads[k], target)
            self._seats[fixed] = composed(self._scene, seat) if berth.frame == "orbiter" else seat
        seat = self._seats[fixed]
        return seat if berth.frame == "orbiter" else composed(self.carrier(frame, berth.frame), seat)

    def _out(self, frame: Frame, berth: Berth) -> Array:
        """Return the direction (3,) in L that leads out of a berth."""
        if berth.name not in self._outs or berth.frame != "orbiter":
            turn = product(self.carrier(frame, berth.frame).rotation, berth.pose.rotation)
            self._outs[berth.name] = turn[:, berth.out]
        return self._outs[berth.name]


def _pose(position: Vec3, orientation: Rows) -> Pose:
    return Pose(np.array(position), np.array(orientation))


def _along(axis: Array, vector: Array) -> float:
    return float(dots(axis, vector))
