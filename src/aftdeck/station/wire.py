"""Conversion of the simulation's values to the page's: the welcome, and each frame with its lamps."""

from __future__ import annotations

from typing import cast

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.cameras import Camera, Setting
from aftdeck.frames import SCENE_FROM_PANEL_AXES, Pose, panel_attitude, quaternion, rotation_x
from aftdeck.recording.records import ControllerRecord
from aftdeck.scenario.cameras import cameras_of
from aftdeck.scenario.light import Lighting, conditions
from aftdeck.scenario.model import Scenario
from aftdeck.scene.bodies import bodies_of
from aftdeck.scene.everything import ScenePoses
from aftdeck.simulation import frame as sim
from aftdeck.simulation.log import spoken
from aftdeck.simulation.look_ahead import Ahead
from aftdeck.simulation.master import AXES, axes_of
from aftdeck.station import from_page, kinds, to_page
from aftdeck.station.wire_spec94 import payload_table, stored_sequences
from aftdeck.station.wire_work import WorkTranslator, effector_lamps, work_info
from aftdeck.steering.mode import MODES, STICK_AXES, Mode
from aftdeck.version import __version__

VIEW = 6
"""Decimals of a camera's angles on the page [rad]; a pixel is a thousand times as wide."""


class Translator:
    """Converter of one scenario's frames to the page's frames."""

    def __init__(self, scenario: Scenario, *, demo: bool) -> None:
        self._scenario = scenario
        self._arm = self._raised = scenario.arm
        self._mount = scenario.arm.model.mount
        self._hand = rotation_x(scenario.arm.model.end_effector_roll)
        self._poses = ScenePoses(scenario)
        self._work = WorkTranslator(scenario)
        bodies = tuple(to_page.BodyInfo(body.name, body.shapes) for body in bodies_of(scenario))
        phases = tuple(phase.name for phase in scenario.phases) if demo else ()
        self.welcome = self._welcome(bodies, cameras_of(scenario), phases)
        self._views: tuple[tuple[Setting, ...], tuple[kinds.Vec3, ...]] = ((), ())

    def _welcome(
        self, bodies: tuple[to_page.BodyInfo, ...], cameras: tuple[Camera, ...], phases: tuple[str, ...]
    ) -> to_page.Welcome:
        scenario, model = self._scenario, self._arm.model
        joints = tuple(
            to_page.JointInfo(
                name,
                label,
                stick=AXES[axis],
                hard=_pair(model.limits.hard[i]),
                soft=_pair(model.limits.soft[i]),
                reach=_pair(model.limits.reach[i]),
                coarse=float(model.rates.coarse[i]),
                vernier=float(model.rates.vernier[i]),
                servo=float(model.rates.servo[i]),
            )
            for i, (name, label, axis) in enumerate(zip(model.joints, model.labels, axes_of(model), strict=True))
        )
        modes = tuple(
            to_page.ModeInfo(m.position, m.laws, m.title, m.kind, m.point, self._has_points(m), m.axes, m.axis_names)
            for m in MODES.values()
        )
        return to_page.Welcome(
            protocol=kinds.PROTOCOL,
            version=__version__,
            scenario=scenario.name,
            title=scenario.title,
            text=scenario.description,
            arm=model.title,
            control_period_s=scenario.control_period,
            command_delay_s=scenario.delay * scenario.control_period,
            telemetry_delay_s=scenario.telemetry_delay,
            camera_delay_s=scenario.camera_delay,
            units=model.units,
            joints=joints,
            modes=modes,
            work=work_info(scenario),
            conditions=conditions(),
            lamps=scenario.lamps,
            bodies=bodies,
            ghost=self._ghost(len(bodies)),
            cameras=cameras,
            payloads=payload_table(scenario),
            sequences=stored_sequences(scenario),
            singular=model.singular,
            phases=phases,
        )

    def _ghost(self, count: int) -> tuple[int, ...]:
        """Return the indices of the arm's bodies and of the worksite's payloads, among `count` bodies."""
        first, cargo = len(self._scenario.worksite.bodies), len(self._scenario.cargo)
        return (*range(first, first + len(self._arm.model.frames)), *range(count - cargo, count))

    def _has_points(self, mode: Mode) -> bool:
        return not mode.position.startswith("AUTO") or mode.position in self._scenario.sequences

    def ahead(self, ahead: Ahead, frame: sim.Frame) -> to_page.Ahead:
        """Return a look-ahead, made from `frame`, in the form that the page uses."""
        near = ahead.nearest
        return to_page.Ahead(
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

    def frame(
        self,
        frame: sim.Frame,
        stick_seq: int,
        recording_s: float | None = None,
        ahead: to_page.Ahead | None = None,
        lighting: Lighting | None = None,
        flown_seq: int = -1,
    ) -> to_page.Frame:
        """Return a frame in the form that the page uses; without `lighting`, the lighting is the scenario's."""
        tip = Pose(np.array(frame.position), np.array(frame.orientation))
        loaded = MODES[frame.mode].loaded and not self._scenario.strict
        resolution, axes = np.array(frame.resolution), self._shown_axes(frame, tip, loaded)
        control = self._control_axes(frame, tip)
        return to_page.Frame(
            tick=frame.tick,
            time_s=frame.time_s,
            stick_seq=stick_seq,
            flown_seq=flown_seq,
            recording_s=recording_s,
            phase=frame.phase,
            by=frame.by,
            mode=frame.mode,
            law=frame.law,
            law_choice=frame.law_choice,
            payload_axes=frame.payload_axes,
            rate_hold=frame.rate_hold,
            position_hold=frame.position_hold,
            brakes=frame.brakes,
            safing=frame.safing,
            joint=frame.joint,
            rate=frame.rate,
            sequence=frame.sequence,
            point=frame.point,
            points=frame.points,
            check=None if frame.check is None else to_page.Check(frame.check.good, frame.check.text),
            translation=frame.translation,
            rotation=frame.rotation,
            drive=frame.drive,
            joints=frame.angles,
            joints_commanded=frame.angles_commanded,
            rates=frame.rates,
            rates_commanded=frame.rates_commanded,
            rate_limits=frame.rate_limits,
            zones=frame.zones,
            actual=self._resolution(Pose(resolution, axes), frame.twist),
            commanded=self._resolution(self._commanded(frame, tip, Pose(resolution, axes)), frame.twist_demanded),
            por_limits=frame.por_limits,
            payload=self._payload(frame),
            por_offset=self._por_offset(frame, tip),
            limits=tuple(to_page.Limit(limit.kind, limit.joint, limit.text) for limit in frame.limits),
            singularity=frame.singularity,
            ways_out=tuple(to_page.WayOut(w.cause, w.text, w.stick, w.axis, w.sign) for w in frame.ways_out),
            lamps=self.lamps(frame),
            aim=self._aim(frame.goal),
            work=self._work.frame(frame.work, tip.position, control if MODES[frame.mode].kind == "manual" else None),
            ahead=ahead,
            axes=quaternion(SCENE_FROM_PANEL_AXES @ control),
            poses=tuple(self._poses.at(frame)),
            views=self._shortened(frame.views),
            lighting=lighting or self._scenario.lighting,
        )

    def _payload(self, frame: sim.Frame) -> int:
        """Return the PL ID of the captured payload; 0 if there is none."""
        return frame.attached or next((i for i, cargo in enumerate(frame.work.cargo, 1) if cargo.held), 0)

    def _por_offset(self, frame: sim.Frame, tip: Pose) -> kinds.Vec3:
        """Return the vector from the tip to the point that ORB LD and PL move, in the end effector's axes [m]."""
        if frame.payload is None or self._scenario.strict:  # as published, every mode moves the tip
            return (0.0, 0.0, 0.0)
        centre, axes = np.array(frame.payload[0]), np.array(frame.payload[1])
        own = self._scenario.own_payloads[frame.attached - 1] if frame.attached else None
        point = centre if own is None else centre + axes @ own.por
        return _vec3(((point - tip.position) @ tip.rotation @ self._hand).tolist())

    def target(self, message: from_page.SetTarget) -> Pose:
        """Return a keyed-in target, given in panel components, as frame 7 in L."""
        return self._arm.from_panel(message.position, message.attitude)

    def _shortened(self, views: tuple[Setting, ...]) -> tuple[kinds.Vec3, ...]:
        """Return the settings rounded to a microradian; while no camera moves, the result of the last call."""
        if views is not self._views[0]:
            short = [(round(pan, VIEW), round(tilt, VIEW), round(zoom, VIEW)) for pan, tilt, zoom in views]
            self._views = views, tuple(short)
        return self._views[1]

    def _shown_axes(self, frame: sim.Frame, tip: Pose, loaded: bool) -> Array:
        """Return the axes in L whose attitude the panel shows: the payload's in its modes, else the end effector's."""
        if loaded and frame.payload is not None:
            return np.array(frame.payload[1])
        return tip.rotation @ self._hand

    def _commanded(self, frame: sim.Frame, tip: Pose, shown: Pose) -> Pose:
        """Return the pose in L that the panel would show if the arm had followed the commanded rates."""
        stand = frame.work.stand
        if stand is not None and stand != self._raised.stand:
            self._raised = self._arm.at(stand=stand)
        there = self._raised.forward(frame.angles_commanded)
        turn = there.rotation @ tip.rotation.T
        return Pose(there.position + turn @ (shown.position - tip.position), turn @ shown.rotation)

    def _control_axes(self, frame: sim.Frame, tip: Pose) -> Array:
        """Return the axes that the sticks act along, in panel components."""
        along = STICK_AXES.get(frame.law)
        if along == "end effector":
            hand = tip.rotation if self._scenario.strict else tip.rotation @ self._hand
            return np.asarray(self._mount.rotation @ hand)
        if along == "payload" and frame.payload is not None:
            return np.asarray(self._mount.rotation @ np.array(frame.payload[1]))
        return np.eye(3)

    def _resolution(self, pose: Pose, twist: sim.Six) -> to_page.Resolution:
        """Return a point of resolution in panel components; `pose` and `twist` are in L."""
        shown = self._mount.to("panel", pose)
        turn = self._mount.rotation @ np.array(twist[:3])
        velocity = self._mount.rotation @ np.array(twist[3:])
        return to_page.Resolution(
            _vec3(shown.position.tolist()),
            panel_attitude(shown.rotation),
            _vec3(velocity.tolist()),
            (float(turn[1]), float(turn[2]), float(turn[0])),
        )

    def _aim(self, goal: sim.Goal | None) -> to_page.Aim | None:
        if goal is None:
            return None
        goal_pose = Pose(np.array(goal.position), np.array(goal.rotation) @ self._hand)
        shown = self._mount.to("panel", goal_pose)
        position = _vec3(shown.position.tolist())
        return to_page.Aim(position, panel_attitude(shown.rotation), goal.distance, goal.angle, goal.remaining_s)

    def lamps(self, frame: sim.Frame) -> tuple[to_page.Lamp, ...]:
        """Return the lit lamps, each with its cause."""
        joints = [spoken(name) for name in self._arm.joints]
        lamps = []
        if frame.singular:
            shown = ", ".join(
                f"{name} {abs(d):.2f}"
                for name, d in zip(("shoulder", "elbow", "wrist"), frame.singularity, strict=True)
                if name in frame.singular
            )
            lamps.append(to_page.Lamp("SINGULAR", "caution", shown))
        zones: tuple[tuple[to_page.FlightLamp, int], ...] = (
            ("REACH LIM", sim.PAST_REACH),
            ("SOFT STOP", sim.PAST_SOFT),
        )
        for name, zone in zones:
            past = [joint for joint, z in zip(joints, frame.zones, strict=True) if z >= zone]
            if past:
                lamps.append(to_page.Lamp(name, "caution", ", ".join(past)))
        held = [limit.text for limit in frame.limits if limit.kind == "soft stop"]
        if held and not any(lamp.name == "SOFT STOP" for lamp in lamps):
            lamps.append(to_page.Lamp("SOFT STOP", "caution", held[0]))
        rate = [limit.text for limit in frame.limits if limit.kind == "joint rate"]
        if rate:
            lamps.append(to_page.Lamp("RATE LIM", "info", rate[0]))
        near = frame.work.nearest
        if near is not None and frame.work.clearance_level != "info":
            lamps.append(to_page.Lamp("CLEARANCE", frame.work.clearance_level, f"{near.a} to {near.b}"))
        return (*lamps, *effector_lamps(frame.work))


def controller_records(message: from_page.Controllers) -> tuple[ControllerRecord, ...]:
    """Return the hand controllers in use, in the form in which they are recorded."""
    return tuple(
        ControllerRecord(used.kind, used.name, used.deadband, used.expo, used.bindings, used.centres)
        for used in message.controllers
    )


def _vec3(values: list[float]) -> kinds.Vec3:
    return cast("kinds.Vec3", tuple(values))


def _pair(values: Array) -> tuple[float, float]:
    return float(values[0]), float(values[1])
