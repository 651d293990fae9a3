"""Conversion of frames and look-aheads to the messages that a page receives."""

from __future__ import annotations

from collections.abc import Callable
from typing import cast

import numpy as np

from aftdeck.arrays import Array
from aftdeck.frames import SCENE_FROM_PANEL_AXES, Pose, panel_attitude, quaternion, rotation_x
from aftdeck.kinematics.arm import Arm
from aftdeck.report.lamps import Lamp, lit_lamps
from aftdeck.scenario.light import Lighting
from aftdeck.scenario.model import Scenario
from aftdeck.scene.everything import ScenePoses
from aftdeck.scene.stick_axes import StickAxes
from aftdeck.simulation import frame as sim
from aftdeck.simulation.observe import look_ahead
from aftdeck.station.conversion.to_go import to_go
from aftdeck.station.messages.frame import (
    Ahead,
    Aim,
    AutopilotName,
    ClosestPoints,
    Debrief,
    Display,
    Frame,
    LinkSteps,
    Push,
    Resolution,
    TaskNow,
    TaskPair,
    with_display,
)
from aftdeck.steering.mode import MODES
from aftdeck.task.pair import TaskPairs
from aftdeck.task.progress import Progress
from aftdeck.task.remaining import Aims
from aftdeck.tuples import Six, Vec3
from aftdeck.worksite.report import Near


class Displays:
    """Converter of one scenario's frames to messages for a page."""

    def __init__(self, scenario: Scenario) -> None:
        mount = scenario.arm.model.mount
        self._scenario = scenario
        self._arm = self._raised = scenario.arm
        self._mount = mount
        self._hand = rotation_x(scenario.arm.model.end_effector_roll)
        self._poses, self._sticks = ScenePoses(scenario), StickAxes(scenario)
        self._aims, self._pairs = Aims(scenario), TaskPairs(scenario)

    def ahead(self, ahead: look_ahead.Ahead, frame: sim.Frame) -> Ahead:
        """Return the message about a look-ahead, which was computed from `frame`."""
        near = ahead.nearest
        return Ahead(
            seconds=ahead.seconds,
            held=ahead.held,
            moves=ahead.moves,
            clearance=None if near is None else near.clearance,
            a="" if near is None else near.a,
            b="" if near is None else near.b,
            contact_s=ahead.contact_s,
            stopping=ahead.stopping,
            joint=ahead.joint,
            room=ahead.room,
            poses=tuple(self._poses.then(ahead, self._poses.prong(frame))),
        )

    def pair(self, watched: Callable[[], tuple[Near, ...]], frame: sim.Frame, progress: Progress) -> TaskPair | None:
        """Return the pair that the present step brings together or takes apart; None if there is none.

        `watched` returns all monitored pairs of the frame's step (`Simulation.watched`); it is only called if needed.
        """
        near = self._pairs.nearest(watched, frame, progress.present)
        return None if near is None else TaskPair(near.a, near.b, near.clearance, near.closing)

    def frame(
        self,
        frame: sim.Frame,
        stick_seq: int,
        recording_s: float | None = None,
        ahead: Ahead | None = None,
        lighting: Lighting | None = None,
        flown_seq: int = -1,
        lamps: tuple[Lamp, ...] | None = None,
        progress: Progress | None = None,
        debrief: Debrief | None = None,
        autopilot: AutopilotName | None = None,
        pair: TaskPair | None = None,
        link: LinkSteps | None = None,
    ) -> Frame:
        """Return a frame as a message to a page.

        If `lighting` is None, the message has the scenario's lighting; if `lamps` is None, the lamps that this frame
        lights. `progress` is the progress through the task, which has seen this frame, and `debrief` its result;
        both are None in a replay. `autopilot` is what flies; the script is
        known from the frame. `pair` is the newest result of the method `pair`. `link` has the steps that the
        pages show; it is None in a replay.
        """
        tip = Pose(np.array(frame.position), np.array(frame.orientation))
        loaded = MODES[frame.mode].loaded and not self._scenario.strict
        shown = Pose(np.array(frame.resolution), self._shown_axes(frame, tip, loaded))
        control = np.array(self._sticks.in_panel(frame))
        work, left = frame.work, progress.remaining() if progress else self._aims.remaining(frame, None)
        closing = progress.closing() if progress else None
        display = Display(
            link=link,
            stick_seq=stick_seq,
            flown_seq=flown_seq,
            autopilot="script" if frame.by == "script" else autopilot,
            recording_s=recording_s,
            actual=self._resolution(shown, frame.twist),
            commanded=self._resolution(self._commanded(frame, tip, shown), frame.twist_demanded),
            aim=self._aim(frame.goal),
            payload_id=payload_id(frame),
            por_offset=self._por_offset(frame, tip),
            task_pair=pair,
            to_go=None if left is None else to_go(left, frame, self._poses, self._sticks.in_l(frame), closing),
            task=None
            if progress is None
            else TaskNow(progress.at, progress.hint(), progress.first, tuple(progress.done_s), debrief),
            orbiter=_vec3(self._mount.rotation @ np.array(work.orbiter)),
            orbiter_velocity=_vec3(self._mount.rotation @ np.array(work.orbiter_velocity)),
            lamps=lit_lamps(self._scenario, frame) if lamps is None else lamps,
            gap=None if work.nearest is None else self._gap(work.nearest),
            contacts=tuple([self._gap(near) for near in work.contacts]),
            pushes=self._pushes(frame),
            ahead=ahead,
            axes=quaternion(SCENE_FROM_PANEL_AXES @ control),
            poses=tuple(self._poses.at(frame)),
            lighting=lighting or self._scenario.lighting,
        )
        return with_display(frame, display)

    def _por_offset(self, frame: sim.Frame, tip: Pose) -> Vec3:
        """Return the vector from the tip to the point that ORB LD and PL move, in the end effector's axes [m]."""
        if frame.payload is None or self._scenario.strict:  # as published, every mode moves the tip
            return (0.0, 0.0, 0.0)
        centre, axes = np.array(frame.payload[0]), np.array(frame.payload[1])
        own = self._scenario.own_payloads[frame.attached - 1] if frame.attached else None
        point = centre if own is None else centre + axes @ own.por
        return _vec3((point - tip.position) @ tip.rotation @ self._hand)

    def _shown_axes(self, frame: sim.Frame, tip: Pose, loaded: bool) -> Array:
        """Return the axes, in L, whose attitude the panel shows: the payload's if `loaded`, else the end effector's."""
        if loaded and frame.payload is not None:
            return np.array(frame.payload[1])
        return tip.rotation @ self._hand

    def _commanded(self, frame: sim.Frame, tip: Pose, shown: Pose) -> Pose:
        """Return the pose in L that the panel would show if the arm had followed the commanded rates."""
        stand = frame.work.stand
        if stand is not None and stand != self._raised.stand:
            self._raised = Arm(self._arm.model.standing(stand))
        commanded_tip = self._raised.forward(frame.angles_commanded)
        from_tip = commanded_tip.rotation @ tip.rotation.T
        return Pose(commanded_tip.position + from_tip @ (shown.position - tip.position), from_tip @ shown.rotation)

    def _resolution(self, pose: Pose, twist: Six) -> Resolution:
        """Return a point of resolution in panel components; `pose` and `twist` are in L."""
        shown = self._mount.to("panel", pose)
        roll, pitch, yaw = (self._mount.rotation @ np.array(twist[:3])).tolist()
        velocity = _vec3(self._mount.rotation @ np.array(twist[3:]))
        return Resolution(_vec3(shown.position), panel_attitude(shown.rotation), velocity, (pitch, yaw, roll))

    def _aim(self, goal: sim.Goal | None) -> Aim | None:
        if goal is None:
            return None
        shown = self._mount.to("panel", Pose(np.array(goal.position), np.array(goal.rotation) @ self._hand))
        return Aim(_vec3(shown.position), panel_attitude(shown.rotation))

    def _pushes(self, frame: sim.Frame) -> tuple[Push, ...]:
        """Return the forces between parts in contact, and those of disturbances."""
        if frame.dynamics is None:
            return ()
        forces: tuple[sim.Force | sim.Wrench, ...] = (*frame.dynamics.contacts, *frame.dynamics.disturbances)
        return tuple(Push(self._poses.point(each.position), self._poses.vector(each.force)) for each in forces)

    def _gap(self, near: Near) -> ClosestPoints:
        a, b = self._poses.point(near.point_a), self._poses.point(near.point_b)
        middle = _vec3(0.5 * np.add(a, b))
        return ClosestPoints(a, b, middle, self._poses.vector(near.normal))


def payload_id(frame: sim.Frame) -> int:
    """Return the PL ID of the captured payload; 0 if there is none."""
    return frame.attached or next((i for i, payload in enumerate(frame.work.cargo, 1) if payload.held), 0)


def _vec3(values: Array) -> Vec3:
    return cast("Vec3", tuple(values.tolist()))
