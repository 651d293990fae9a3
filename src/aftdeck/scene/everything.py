"""Poses in the scene of all drawn bodies, computed from a `Frame`; in the order of `scene.bodies.bodies_of`."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import SCENE_FROM_PANEL_AXES, quaternion
from aftdeck.matrices import product
from aftdeck.scenario.model import Scenario
from aftdeck.scene.bodies import draws_payload
from aftdeck.scene.poses import ArmPoses
from aftdeck.simulation.frame import Frame, Placed
from aftdeck.simulation.observe.look_ahead import Ahead
from aftdeck.tuples import Rows, Vec3


class ScenePoses:
    """Poses of all drawn bodies: worksite, arm, the scenario's own payload, and the worksite's payloads."""

    def __init__(self, scenario: Scenario) -> None:
        mount, origin = scenario.arm.model.mount, np.array(scenario.worksite.origin)
        self.arm = ArmPoses(scenario.arm.model, origin, scenario.flexures)
        self._turn = product(SCENE_FROM_PANEL_AXES, mount.rotation)
        self._origin = product(SCENE_FROM_PANEL_AXES, mount.origin) - origin
        self._bodies = [
            (body.pose.position, quaternion(body.pose.rotation), body.fixed_to == "space")
            for body in scenario.worksite.bodies
        ]
        self._payload = draws_payload(scenario)
        prong = scenario.arm.model.prong
        self._finger = 0.0 if prong is None else prong.facing

    def at(self, frame: Frame) -> list[float]:
        """Return seven numbers for each body: x, y, z [m], then the quaternion w, x, y, z."""
        poses = self.worksite(frame)
        poses += self.arm.at(np.array(frame.angles), frame.work.stand, self.prong(frame), bends_in(frame))
        if self._payload and frame.payload is not None:
            poses += self.pose(*frame.payload)
        for payload in frame.work.cargo:
            poses += self.pose(payload.position, payload.orientation)
        return poses

    def then(self, ahead: Ahead, prong: float | None) -> list[float]:
        """Return seven numbers for each body in a look-ahead: first the arm's bodies, then the worksite's payloads."""
        poses = self.arm.at(np.array(ahead.angles), ahead.stand, prong)
        for position, orientation in ahead.payloads:
            poses += self.pose(position, orientation)
        return poses

    def worksite(self, frame: Frame) -> list[float]:
        """Return seven numbers for each body of the worksite.

        Bodies that are fixed to ``space`` move opposite to the orbiter's translation, because the scene moves with the
        orbiter.
        """
        travel = self.orbiter_travel(frame)
        poses: list[float] = []
        for position, attitude, in_space in self._bodies:
            poses += [*(position - travel if in_space else position).tolist(), *attitude]
        return poses

    def orbiter_travel(self, frame: Frame) -> Array:
        """Return the orbiter's displacement (3,) since the start, in scene axes [m]."""
        return np.asarray(product(self._turn, np.array(frame.work.orbiter)))

    def prong(self, frame: Frame) -> float | None:
        """Return y2 of the prong's inner face [m]; None if the end effector has no prong."""
        spacing = frame.work.hand.spacing
        return None if spacing is None else self._finger - spacing

    def pose(self, position: Vec3, orientation: Rows) -> list[float]:
        """Convert a pose in L to seven numbers in the scene."""
        return [*self.point(position), *quaternion(product(self._turn, np.array(orientation)))]

    def point(self, position: Vec3) -> Vec3:
        """Convert a point in L to the scene [m]."""
        x, y, z = (product(self._turn, np.array(position)) + self._origin).tolist()
        return x, y, z

    def vector(self, components: Vec3) -> Vec3:
        """Convert a vector's components in L to those in the scene."""
        x, y, z = product(self._turn, np.array(components)).tolist()
        return x, y, z

    def motion(self, motion: Placed) -> tuple[float, ...]:
        """Convert a rigid motion, x to R x + p in L, to the same motion in the scene, as seven numbers."""
        turn = product(product(self._turn, np.array(motion.orientation)), self._turn.T)
        moved = product(self._turn, np.array(motion.position)) + self._origin - product(turn, self._origin)
        return *moved.tolist(), *quaternion(turn)


def bends_in(frame: Frame) -> Array | None:
    """Return the bends (b, 6) of the arm's parts in a frame; None if nothing bends."""
    if frame.dynamics is None or not frame.dynamics.bends:
        return None
    return np.array([(*bend.displacement, *bend.rotation) for bend in frame.dynamics.bends])
