"""Channels in Foxglove's schemas: joints, tip, log, and a scene of bodies in moving coordinate frames.

The channels of `records` contain every step. The channels of this module are for viewing: their numbers are rounded,
and motion is sent at most ten times per simulated second.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from foxglove import messages as fox

from aftdeck.frames import quaternion
from aftdeck.recording.channels import COMMANDED, FIXED, LINES, MEASURED, MOVING, SCENE, TIP
from aftdeck.recording.declared import Log
from aftdeck.recording.entities import scene_update
from aftdeck.recording.live import Live
from aftdeck.scenario.model import Scenario
from aftdeck.scene.bodies import PAYLOAD, bodies_of
from aftdeck.scene.everything import ScenePoses
from aftdeck.scene.poses import Seven
from aftdeck.simulation.frame import Event, Frame

PERIOD = 0.1
"""Simulated time between two messages about motion [s]; rounded up to a whole number of control periods."""
GRAIN = 2.0**18
"""Number of increments per unit (metre, radian, 1).

Moving values are rounded to whole increments: short numbers compress well.
"""
ROOT, LONGERON, HAND = "scene", "L", "tip"
"""Names of the coordinate frames that belong to no body."""
_STILL: Seven = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
_LEVELS = {"info": fox.LogLevel.Info, "caution": fox.LogLevel.Warning, "warning": fox.LogLevel.Error}


class Viewing:
    """Writer of joints, tip, transforms, scene and log in Foxglove's schemas."""

    def __init__(self, log: Log, scenario: Scenario, began_ns: int, live: Live | None = None) -> None:
        """Prepare to write the messages of a run.

        Args:
            log: writes a message.
            scenario: the scenario of the run.
            began_ns: wall time at which the run began, since 1970 [ns].
            live: server for viewers, who may subscribe during the run.
        """
        self._log, self._began_ns, self._live = log, began_ns, live
        self._every = max(1, math.ceil(PERIOD / scenario.control_period - 1e-9))
        self._joints = scenario.arm.joints
        self._poses = ScenePoses(scenario)
        self._worksite = scenario.worksite.bodies
        self._picture = scene_update(bodies_of(scenario), _time(began_ns)).encode()
        foot = _seven(self._poses.arm.at(np.zeros(len(self._joints)))[:7])
        frames = scenario.arm.model.linkage.frames
        x, y, z = scenario.arm.model.linkage.tip.tolist()
        hand: Seven = (x, y, z, 1.0, 0.0, 0.0, 0.0)
        still = [
            (ROOT, body.name, _seven([*body.pose.position.tolist(), *quaternion(body.pose.rotation)]))
            for body in scenario.worksite.bodies
            if body.fixed_to == "orbiter"
        ]
        first, last = frames[0], frames[-1]
        self._fixed = [*still, (ROOT, LONGERON, foot), (LONGERON, first, _STILL), (last, HAND, hand)]

    def open(self) -> None:
        """Send the transforms that do not change, and the shapes and colours of all bodies."""
        if self._live:
            self._live.requested_topics()  # discard earlier requests: all attached viewers receive the topics now
        for topic in (FIXED, SCENE):
            self.send_topic(topic, self._began_ns)

    def frame(self, frame: Frame) -> None:
        """Send the events of a step, and the topics to which viewers have just subscribed.

        Every `PERIOD`, also send the motion.
        """
        now = self._began_ns + round(frame.time_s * 1e9)
        for event in frame.events:
            self.line(event, now)
        for topic in self._live.requested_topics() if self._live else ():
            self.send_topic(topic, now)
        if (frame.tick - 1) % self._every == 0:
            self._draw(frame, now)

    def line(self, event: Event, time_ns: int) -> None:
        """Send a line of the log."""
        line = fox.Log(timestamp=_time(time_ns), level=_LEVELS[event.level], message=event.text, name=event.kind)
        self._log(LINES, line.encode(), time_ns)

    def send_topic(self, topic: str, now: int) -> None:
        """Send the messages of `FIXED` or of `SCENE`; other topics are ignored."""
        if topic == FIXED:
            fixed = [_transform(parent, child, pose, _time(now)) for parent, child, pose in self._fixed]
            self._log(FIXED, fox.FrameTransforms(transforms=fixed).encode(), now)
        elif topic == SCENE:
            self._log(SCENE, self._picture, now)

    def _draw(self, frame: Frame, now: int) -> None:
        time = _time(now)
        links = self._poses.arm.links(frame.angles, frame.work.stand, self._poses.prong(frame))
        moving = [_transform(parent, child, _rounded(pose), time) for parent, child, pose in links]
        sevens = self._poses.worksite(frame)
        for k, body in enumerate(self._worksite):
            if body.fixed_to == "space":
                moving.append(_transform(ROOT, body.name, _rounded(sevens[7 * k : 7 * k + 7]), time))
        for payload in frame.work.cargo:
            pose = _rounded(self._poses.pose(payload.position, payload.orientation))
            moving.append(_transform(ROOT, payload.name, pose, time))
        if frame.attached and frame.payload is not None:
            centre, axes = frame.payload
            pose = _rounded((*centre, *quaternion(np.array(axes))))
            moving.append(_transform(LONGERON, PAYLOAD, pose, time))
        self._log(MOVING, fox.FrameTransforms(transforms=moving).encode(), now)
        self._log(MEASURED, self._states(frame.angles, frame.rates, time).encode(), now)
        self._log(COMMANDED, self._states(frame.angles_commanded, frame.rates_commanded, time).encode(), now)
        x, y, z, *attitude = _rounded((*frame.position, *quaternion(np.array(frame.orientation))))
        tip = fox.Pose(position=fox.Vector3(x=x, y=y, z=z), orientation=_attitude(*attitude))
        self._log(TIP, fox.PoseInFrame(timestamp=time, frame_id=LONGERON, pose=tip).encode(), now)

    def _states(self, angles: Sequence[float], rates: Sequence[float], time: fox.Timestamp) -> fox.JointStates:
        values = zip(self._joints, _rounded(angles), _rounded(rates), strict=True)
        return fox.JointStates(
            timestamp=time,
            joints=[fox.JointState(name=name, position=angle, velocity=rate) for name, angle, rate in values],
        )


def _transform(parent: str, child: str, pose: Sequence[float], time: fox.Timestamp) -> fox.FrameTransform:
    x, y, z, *attitude = pose
    return fox.FrameTransform(
        timestamp=time,
        parent_frame_id=parent,
        child_frame_id=child,
        translation=fox.Vector3(x=x, y=y, z=z),
        rotation=_attitude(*attitude),
    )


def _attitude(w: float, x: float, y: float, z: float) -> fox.Quaternion:
    return fox.Quaternion(x=x, y=y, z=z, w=w)


def _rounded(values: Sequence[float]) -> list[float]:
    return [round(value * GRAIN) / GRAIN for value in values]


def _seven(values: Sequence[float]) -> Seven:
    x, y, z, a, b, c, d = values
    return x, y, z, a, b, c, d


def _time(time_ns: int) -> fox.Timestamp:
    return fox.Timestamp(*divmod(time_ns, 1_000_000_000))
