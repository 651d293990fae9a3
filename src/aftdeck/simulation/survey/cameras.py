"""Search for cameras that are inside a part of the arm or of the worksite, for `survey.pairs`.

A camera may be inside the part that contains it by design (`Camera.housing`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.cameras import Camera
from aftdeck.bodies.hexahedron import NX, D, pack
from aftdeck.bodies.overlap import deepest
from aftdeck.bodies.pose import POSE
from aftdeck.files import Problem
from aftdeck.kinematics.frames import frames_of, place_frames
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.fit import TOLERANCE, Parts, hands, parts_at
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.on_arm import arm_solids
from aftdeck.scenario.relative import composed, inverted, scene_in_l
from aftdeck.simulation.constants.site import site_of
from aftdeck.simulation.survey.poses import bodies, inside_soft_stops, joints_text, placed, stops
from aftdeck.worksite.conditions import quantity_text
from aftdeck.worksite.file.check import depth_in

ArmPose = tuple[Array, float, float]
"""Joint angles [rad], length of the telescope and position of the prong [m]."""
_SMALL_ROTATION = 0.1
"""Test rotation of the first joint [rad], to find the direction in which this joint moves the middle of the arm."""


def cameras(scenario: Scenario) -> Iterator[Problem]:
    """Yield one problem for each camera and each part that contains it, with the first pose in which this occurs."""
    television = [camera for camera in cameras_of(scenario) if camera.kind == "camera"]
    yield from _on_the_arm(scenario, television)
    yield from _around_the_arm(scenario, television)
    yield from _on_payloads(scenario, television)


def _on_the_arm(scenario: Scenario, cameras: list[Camera]) -> Iterator[Problem]:
    """Yield the arm's cameras that are inside a part of the arm, in the poses of `poses.stops`."""
    on_arm = [camera for camera in cameras if camera.body in scenario.arm.model.frames]
    found: set[tuple[str, str]] = set()
    for how, angles, stand, prong in stops(scenario):
        frames = placed(scenario, angles, stand, prong)
        own = bodies(scenario, frames)
        for camera in on_arm:
            pose = frames[camera.body]
            for part, depth in _inside(pose.rotation @ np.array(camera.position) + pose.position, own):
                if part != camera.housing and (camera.name, part) not in found:
                    found.add((camera.name, part))
                    yield _problem(scenario, camera, part, depth, how)


def _around_the_arm(scenario: Scenario, cameras: list[Camera]) -> Iterator[Problem]:
    """Yield the worksite's cameras that are inside a part of the arm, in poses for which a run would log no contact.

    In such a pose, no monitored pair overlaps, and so the arm does not overlap the camera's housing. The body that
    carries the camera stays at its start pose.
    """
    model = scenario.arm.model
    stands = {body.name: body.pose for body in scenario.worksite.bodies}
    fixed = [camera for camera in cameras if camera.body in stands]
    scene = scene_in_l(model.mount, scenario.worksite.origin)
    poses = [composed(scene, stands[camera.body]) for camera in fixed]
    points = [pose.rotation @ camera.position + pose.position for camera, pose in zip(fixed, poses, strict=True)]
    samples = _aimed_at(scenario, list(inside_soft_stops(scenario)), points)
    found: set[tuple[int, str]] = set()
    for k, camera, part, depth in _points_inside(scenario, samples, np.array(points).reshape(-1, 3)):
        if (camera, part) not in found and not _logs_contact(scenario, bodies(scenario, placed(scenario, *samples[k]))):
            found.add((camera, part))
            yield _problem(scenario, fixed[camera], part, depth, joints_text(scenario.arm.model, samples[k][0]))


def _aimed_at(scenario: Scenario, samples: list[ArmPose], points: list[Array]) -> list[ArmPose]:
    """Return the poses `samples` with the first joint turned so that the plane of the booms contains a point.

    The points (3,), in L, are used in turn: the first pose is turned to the first point, the second pose to the second
    point, and so on. Poses whose first joint would be outside its soft stops are omitted. A boom contains a given point
    in 1 of 10 000 random poses, but in 1 of 50 returned poses. There are none if the first joint slides.
    """
    model = scenario.arm.model
    if not points or model.slides[0]:
        return []
    low, high = model.limits.soft[0]
    middle = 0.5 * model.limits.soft.sum(axis=1)
    turned = middle.copy()
    turned[0] += _SMALL_ROTATION
    frames = model.linkage.frames
    half_way = frames[len(frames) // 2]  # the elbow of an arm with six joints
    ahead, after = (_azimuth(placed(scenario, at, 0.0, 0.0)[half_way].position) for at in (middle, turned))
    sign, start = np.sign(np.sin(after - ahead)), middle[0]
    found = []
    for k, (angles, stand, prong) in enumerate(samples):
        # every second pass through the points adds pi: some arms reach a point by leaning back over their shoulder
        turn = sign * (_azimuth(points[k % len(points)]) - ahead) + (k // len(points) % 2) * np.pi
        heading = (start + turn + np.pi) % (2.0 * np.pi) - np.pi
        if low <= heading <= high:
            found.append((np.array([heading, *angles[1:]]), stand, prong))
    return found


def _azimuth(point: Array) -> float:
    return float(np.arctan2(point[1], point[0]))


def _points_inside(
    scenario: Scenario, samples: Sequence[ArmPose], points: Array
) -> Iterator[tuple[int, int, str, float]]:
    """Yield (pose, point, part, depth [m]) for each of the points (n, 3) in L that is inside a part of the arm."""
    arm = frames_of(scenario.arm.model)
    frames = np.empty((len(samples), len(arm.names), POSE))
    for row, (angles, stand, prong) in zip(frames, samples, strict=True):
        place_frames(arm.joints, angles, stand, prong, row)
    local = {
        name: np.einsum("kij,kni->knj", own[:, 3:].reshape(-1, 3, 3), points - own[:, None, :3])
        for name, own in zip(arm.names, frames.transpose(1, 0, 2), strict=True)
    }
    for solid in arm_solids(scenario.arm.model, scenario.worksite):
        body = pack(solid.vertices)
        depths = (body[D:] - local[solid.frame] @ body[NX:D].reshape(3, 6)).min(axis=2)
        for k, point in np.argwhere(depths >= 0.0).tolist():
            yield k, point, solid.part, float(depths[k, point])


def _logs_contact(scenario: Scenario, own: Parts) -> bool:
    """Return whether a run would log a contact: whether the parts of a monitored pair overlap.

    `own` contains the parts of the arm, in L.
    """
    layout = site_of(scenario).layout
    scene = scene_in_l(scenario.arm.model.mount, scenario.worksite.origin)
    around = parts_at(scenario.worksite.solids, scene)
    monitored = (layout.named(group) for group in range(len(layout.groups)))
    return any(deepest(own[a], around[b]) > TOLERANCE for a, b in monitored if a in own and b in around)


def _on_payloads(scenario: Scenario, cameras: list[Camera]) -> Iterator[Problem]:
    """Yield the payloads' cameras that are inside the end effector at capture, or inside parts of a berth."""
    for payload in scenario.payloads:
        own = [camera for camera in cameras if camera.body == payload.name]
        for how, hand in hands(scenario.arm.model, scenario.worksite, payload).items():
            yield from _inside_parts(scenario, own, hand, f"with the end effector at the payload's bar, prong {how}")
        for berth in scenario.worksite.berths:
            if berth.lacks(payload.probe, payload.trunnions):
                continue
            around = parts_at(scenario.worksite.solids, inverted(berth.seated(payload.probe)))
            yield from _inside_parts(scenario, own, around, f"with {payload.name} in the berth {berth.name!r}")


def _inside_parts(scenario: Scenario, cameras: list[Camera], around: Parts, how: str) -> Iterator[Problem]:
    """Yield a problem for each camera and each part that contains it. `around` is in the payload's axes."""
    for camera in cameras:
        for part, depth in _inside(np.array(camera.position), around):
            yield _problem(scenario, camera, part, depth, how)


def _problem(scenario: Scenario, camera: Camera, part: str, depth: float, how: str) -> Problem:
    deep = quantity_text(depth, "m", scenario.arm.model.units)
    return Problem(("worksite",), f"camera {camera.name} is {deep} inside {part} {how}")


def _inside(point: Array, parts: Parts) -> Iterator[tuple[str, float]]:
    """Yield the parts that contain a point, and the depth of the point in each [m]."""
    for part, solids in parts.items():
        depth = max((depth_in(point, body) for body in solids if _in_box(point, body)), default=-1.0)
        if depth >= 0.0:
            yield part, depth


def _in_box(point: Array, body: Array) -> bool:
    return bool((body.min(axis=0) <= point).all() and (point <= body.max(axis=0)).all())
