"""Tip poses relative to objects: over a payload, with a held payload at a berth, or in the frame of a body.

The functions are used at the start of a run, when all objects are at their start poses, and when a phase begins.
"""

from __future__ import annotations

import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.frames import IDENTITY, SCENE_FROM_PANEL_AXES, Mount, Pose, rotation_x
from aftdeck.matrices import product
from aftdeck.scenario.target import AtBerth, AtPayload, InFrame
from aftdeck.worksite.berths.berth import Berth
from aftdeck.worksite.model import Worksite
from aftdeck.worksite.payload import Payload

_OVER_A_BAR = np.array([[0.0, 0.0, -1.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]])
"""The tip's axes in a payload's axes when the end effector points down at the payload's bar, with the fixed finger to
port."""


def scene_in_l(mount: Mount, origin: tuple[float, float, float]) -> Pose:
    """Return the pose in L of a scene whose origin has the given structural coordinates [m]."""
    turn = product(mount.rotation.T, SCENE_FROM_PANEL_AXES)
    return Pose(product(turn, np.array(origin)) - product(mount.rotation.T, mount.origin), turn)


def composed(outer: Pose, inner: Pose) -> Pose:
    """Return the composed pose: `outer` is the pose of the frame in which `inner` is given."""
    return Pose(outer.position + product(outer.rotation, inner.position), product(outer.rotation, inner.rotation))


def inverted(pose: Pose) -> Pose:
    """Return the inverse pose: if `pose` is the pose of frame a in frame b, return the pose of frame b in frame a."""
    return Pose(-product(pose.rotation.T, pose.position), pose.rotation.T)


def takes(model: ArmModel, payload: Payload) -> bool:
    """Return whether a payload has the fitting that this arm's end effector needs for a capture.

    An end effector with a prong needs a bar; an end effector with snares needs a grapple fixture.
    """
    return (payload.grapple if model.prong is None else payload.receptacle) is not None


def at_payload(model: ArmModel, payload: Payload, place: AtPayload) -> Pose:
    """Return the tip's pose in a payload's axes: the capture pose, displaced by `above` and `offset` of `place`."""
    if payload.grapple is not None:
        rotation = product(payload.grapple.rotation, rotation_x(-model.end_effector_roll))
        capture_pose = Pose(payload.grapple.position, rotation)
    else:
        assert payload.receptacle is not None, "the caller has checked that the payload has a fixture or a bar"
        low, high = payload.receptacle.min(axis=0), payload.receptacle.max(axis=0)
        capture_pose = Pose(np.array([*(low + high)[:2] / 2.0, high[2]]), _OVER_A_BAR)
    return Pose(
        capture_pose.position - place.above * capture_pose.rotation[:, 0] + np.array(place.offset),
        capture_pose.rotation,
    )


def at_berth(berth: Berth, payload: Payload, place: AtBerth) -> Pose:
    """Return a payload's pose in `berth.frame`: the seated pose, displaced by `above` and `offset` of `place`."""
    seated, turn = berth.seated(payload.probe), berth.pose.rotation
    return Pose(
        seated.position + place.above * turn[:, berth.out] + product(turn, np.array(place.offset)), seated.rotation
    )


def in_frame(worksite: Worksite, payloads: tuple[Payload, ...], name: str, pose: Pose) -> InFrame | None:
    """Return the target for a pose in the axes of the body, berth or payload `name`; None if none has this name."""
    carriers: dict[str, tuple[str, Pose]] = {body.name: (body.fixed_to, body.pose) for body in worksite.bodies}
    carriers |= {payload.name: (payload.name, IDENTITY) for payload in payloads}
    carriers |= {berth.name: (berth.frame, berth.pose) for berth in worksite.berths}
    if name not in carriers:
        return None
    frame, pose_in_carrier = carriers[name]
    combined = composed(pose_in_carrier, pose)
    x, y, z = combined.position.tolist()
    a, b, c = (tuple(row) for row in combined.rotation.tolist())
    return InFrame(frame, (x, y, z), (a, b, c))
