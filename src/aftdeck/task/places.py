"""Poses of the tip, the payloads and the targets at the time of a frame."""

from __future__ import annotations

import math

from aftdeck.bodies.placed import carried, composed, inverted, place_of, turned
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.relative import at_berth, at_payload, scene_in_l, takes
from aftdeck.scenario.target import AtBerth, AtPayload, InFrame, RelativeTarget, Target
from aftdeck.simulation.frame import Frame, Placed
from aftdeck.tuples import Vec3
from aftdeck.worksite.berths.berth import Berth

_MOST_KEPT = 100
"""Greatest number of poses at targets that are kept."""


class Places:
    """Poses in L of the things of one scenario, computed from frames.

    Attributes:
        berths: the worksite's berths by name.
    """

    def __init__(self, scenario: Scenario) -> None:
        self._model, self._payloads = scenario.arm.model, scenario.payloads
        self._index = {payload.name: k for k, payload in enumerate(scenario.payloads)}
        self.berths = {berth.name: berth for berth in scenario.worksite.berths}
        self._scene = Placed(*place_of(scene_in_l(scenario.arm.model.mount, scenario.worksite.origin)))
        self._captures: dict[AtPayload, Placed] = {}  # in the payload's axes
        self._seats: dict[tuple[AtBerth, int], Placed] = {}  # in the berth's frame; in L, if this is the orbiter
        self._outs: dict[str, Vec3] = {}  # in L, for berths of the orbiter

    def payload(self, frame: Frame, k: int) -> Placed:
        """Return the pose of payload k."""
        payload = frame.work.cargo[k]
        return Placed(payload.position, payload.orientation)

    def carrier(self, frame: Frame, name: str) -> Placed:
        """Return the pose of a coordinate frame: ``orbiter``, ``space``, or a payload's."""
        if name in self._index:
            return self.payload(frame, self._index[name])
        if name == "orbiter":
            return self._scene
        if frame.dynamics is None:
            (x, y, z), (a, b, c) = self._scene.position, frame.work.orbiter
            return Placed((x - a, y - b, z - c), self._scene.orientation)
        orbiter = frame.dynamics.orbiter  # includes the displacement
        return Placed(*composed(*inverted(*orbiter), *self._scene))

    def held(self, frame: Frame) -> int | None:
        """Return the index of the held payload; None if the end effector holds none."""
        return next((k for k, payload in enumerate(frame.work.cargo) if payload.held), None)

    def target(self, frame: Frame, target: Target | RelativeTarget) -> Placed | None:
        """Return the pose of the tip at a target; None if the target is a berth and no payload is held."""
        match target:
            case Target():
                return Placed(target.position, target.rotation)
            case AtPayload():
                return self.capture(frame, target)
            case InFrame():
                return Placed(*composed(*self.carrier(frame, target.frame), target.position, target.rotation))
            case AtBerth():
                if (held := self.held(frame)) is None:
                    return None
                seat, payload = self.seated(frame, target, held), self.payload(frame, held)
                return Placed(*carried(*seat, *payload, frame.position, frame.orientation))

    def above(self, frame: Frame, target: Target | RelativeTarget) -> float | None:
        """Return how far the tip is above a payload, or the held payload above a berth [m].

        The distance is measured along the way out, from the target without its `above`. None if the target is neither,
        or no payload is held above a berth.
        """
        match target:
            case AtPayload(above=above):
                pose = self.capture(frame, target)
                return above + _along(_backwards(pose), frame.position, pose.position)
            case AtBerth(above=above) if (held := self.held(frame)) is not None:
                pose, at = self.seated(frame, target, held), frame.work.cargo[held].position
                return above + _along(self._out(frame, self.berths[target.berth]), at, pose.position)
            case _:
                return None

    def way_out(self, frame: Frame, target: Target | RelativeTarget) -> Vec3 | None:
        """Return the direction in L that leads away from a payload or a berth; None for another target.

        It leads back along the end effector's axis from a payload, up out of the bay, or out from a port.
        """
        match target:
            case AtPayload():
                return _backwards(self.capture(frame, target))
            case AtBerth():
                return self._out(frame, self.berths[target.berth])
            case _:
                return None

    def fixture(self, frame: Frame) -> int | None:
        """Return the index of the payload whose fixture or bar is nearest to the tip; None if there is none."""
        able = (k for k, payload in enumerate(self._payloads) if takes(self._model, payload))
        return min(
            able, key=lambda k: math.dist(self.capture(frame, AtPayload(k)).position, frame.position), default=None
        )

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

    def capture(self, frame: Frame, target: AtPayload) -> Placed:
        """Return the pose of the tip at a target over a payload."""
        if target not in self._captures:
            if len(self._captures) >= _MOST_KEPT:  # targets of random starts
                self._captures.clear()
            place = at_payload(self._model, self._payloads[target.payload], target)
            self._captures[target] = Placed(*place_of(place))
        return Placed(*composed(*self.payload(frame, target.payload), *self._captures[target]))

    def seated(self, frame: Frame, target: AtBerth, k: int) -> Placed:
        """Return the pose of payload k at a target in a berth."""
        berth, fixed = self.berths[target.berth], (target, k)
        if fixed not in self._seats:
            if len(self._seats) >= _MOST_KEPT:
                self._seats.clear()
            seat = Placed(*place_of(at_berth(berth, self._payloads[k], target)))
            self._seats[fixed] = Placed(*composed(*self._scene, *seat)) if berth.frame == "orbiter" else seat
        seat = self._seats[fixed]
        return seat if berth.frame == "orbiter" else Placed(*composed(*self.carrier(frame, berth.frame), *seat))

    def _out(self, frame: Frame, berth: Berth) -> Vec3:
        """Return the direction in L that leads out of a berth."""
        if berth.name not in self._outs or berth.frame != "orbiter":
            x, y, z = berth.pose.rotation[:, berth.out].tolist()
            self._outs[berth.name] = turned(self.carrier(frame, berth.frame).orientation, (x, y, z))
        return self._outs[berth.name]


def _backwards(tip: Placed) -> Vec3:
    """Return the direction back along the end effector's axis."""
    (x, _, _), (y, _, _), (z, _, _) = tip.orientation
    return -x, -y, -z


def _along(axis: Vec3, at: Vec3, origin: Vec3) -> float:
    """Return how far a point is from an origin, along an axis [m]."""
    (a, b, c), (x, y, z), (p, q, r) = axis, at, origin
    return a * (x - p) + b * (y - q) + c * (z - r)
