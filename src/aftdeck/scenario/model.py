"""A scenario, checked and frozen: all data from which a simulation starts."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Literal

import numpy as np

from aftdeck.arms.flexures import Flexure, flexures_of
from aftdeck.arms.limits import JointRates
from aftdeck.bodies.cameras import Setting
from aftdeck.exact_pickle import pickled
from aftdeck.files import Problem
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.payload import HeldPayload
from aftdeck.scenario.disturbance import Disturbable, Planned, payload_names
from aftdeck.scenario.light import Lighting
from aftdeck.scenario.planned_changes import PlannedChange
from aftdeck.scenario.schema import FreeContact, Part, Plant, PorOverride, Rate, ScenarioGroup, Until
from aftdeck.scenario.target import RelativeTarget, Target
from aftdeck.scenario.task_step import TaskStep
from aftdeck.steering.mode import MODES, LawChoice
from aftdeck.tuples import Joints
from aftdeck.worksite.model import OrbiterMotion, Worksite
from aftdeck.worksite.payload import Payload


@dataclass(frozen=True, eq=False)
class RateLimits:
    """Limits of rates and accelerations.

    Attributes:
        joints: limits of the joints.
        por: limits of the point of resolution that replace the arm's limits.
    """

    joints: JointRates
    por: PorOverride


@dataclass(frozen=True, eq=False)
class PhasePlan:
    """A phase of the script, checked and converted to SI units.

    Attributes:
        name: name of the phase, for the summary and the page.
        mode: position of the MODE rotary.
        rate: rate setting, coarse or vernier.
        translation: THC deflections, each in [-1, 1].
        rotation: RHC deflections (roll, pitch, yaw), each in [-1, 1].
        velocity: V_C', which replaces the THC [m/s]; if None, the THC is used.
        angular_velocity: omega_C', which replaces the RHC [rad/s]; if None, the RHC is used.
        joint: selected joint, from 0.
        drive: SINGLE/DIRECT DRIVE in [-1, 1].
        joint_rate: theta_dot_C', which replaces the drive [rad/s or m/s]; if None, `drive` is used.
        joint_at: coordinate to which the joint moves [rad or m]; if None, `drive` or `joint_rate` is used.
        target: final tip pose, or a relative target, whose pose is computed as the phase begins; None for no target.
        law: steering law of the automatic modes, one of the report's modes 1 to 3; None for no change.
        payload_axes: whether ORB LD rotates in payload axes; None for no change.
        master: angles of the master arm [rad]; None for no change.
        effector: position of the end effector switch; None for no change.
        latch: latch button pressed as the phase begins; None for no button.
        brakes: position of the switch BRAKES; None for no change.
        safing: position of the switch SAFING; None for no change.
        stand_at: length to which the telescope moves [m]; None for no change.
        orbiter: translation commands of the orbiter along its three axes, each in [-1, 1].
        limits: limits during the phase; None for the scenario's limits.
        attaches: number, from 1, of the payload in `Scenario.own_payloads` that is attached to the end effector as the
            phase begins; 0 to detach the payload; None for no change.
        until: event for which the phase waits; None if the phase ends as its mode determines.
        duration: duration of the phase, or in automatic modes the longest time allowed [s]; None for no limit.
    """

    name: str
    mode: str
    rate: Rate
    translation: tuple[float, float, float]
    rotation: tuple[float, float, float]
    velocity: tuple[float, float, float] | None
    angular_velocity: tuple[float, float, float] | None
    joint: int
    drive: float
    joint_rate: float | None
    joint_at: float | None
    target: Target | RelativeTarget | None
    law: LawChoice | None
    payload_axes: bool | None
    master: Joints | None
    effector: Literal["stop", "close", "open"] | None
    latch: Literal["latch", "unlatch"] | None
    brakes: bool | None
    safing: bool | None
    stand_at: float | None
    orbiter: tuple[float, float, float]
    limits: RateLimits | None
    attaches: int | None
    until: Until | None
    duration: float | None

    @property
    def timed(self) -> bool:
        """Whether the phase ends only when its duration has passed."""
        driven = MODES[self.mode].kind == "single" and self.joint_at is None
        waits = self.until is not None or self.stand_at is not None
        return (driven or MODES[self.mode].kind in ("manual", "test")) and not waits


@dataclass(frozen=True)
class Point:
    """A prestored point of AUTO 1-4.

    Attributes:
        target: pose of the point.
        pause: True for a pause point, at which the arm waits for PROCEED; False for a fly-by point.
    """

    target: Target
    pause: bool


Sequences = dict[str, tuple[Point, ...]]
"""Points of AUTO 1-4, by panel position."""


@dataclass(frozen=True, eq=False)
class Grasped:
    """A payload that the end effector holds from the start.

    Attributes:
        payload: index of the payload in the scenario's `payloads`.
        angles: (n,) joint angles at which the arm captured the payload [rad]. At the capture, the payload was at its
            start pose (`Payload.start`).
        stand: length of the telescope at the capture [m].
    """

    payload: int
    angles: np.ndarray
    stand: float


@dataclass(frozen=True, eq=False)
class Start:
    """Initial state of the arm, for the full problem or for a part of it.

    Attributes:
        angles: (n,) joint angles [rad].
        rates: (n,) joint rates [rad/s].
        stand: length of the telescope, or height of the shoulder if there is no telescope [m].
        grasped: payload of the worksite that the arm holds; None for none.
    """

    angles: np.ndarray
    rates: np.ndarray
    stand: float
    grasped: Grasped | None


@dataclass(frozen=True, eq=False)
class Scenario:
    """All data from which a simulation starts. Frozen; its arrays are read-only.

    Attributes:
        name: built-in name or file stem.
        title: title for display.
        description: task of the operator.
        group: group of the list of scenarios.
        minutes: time that the task takes a practised operator, or the script if there are no steps [min]; None if the
            file does not say.
        arm: the arm, with the scenario's limits replacing the arm's limits.
        worksite: the worksite.
        seed: random seed.
        plant: model that turns commanded rates into motion.
        orbiter: motion of the orbiter on a plant with masses.
        inhibit: whether detrimental contacts inhibit motion also on a plant with contact forces.
        duration: longest simulated time [s].
        ticks: longest simulated time [control periods].
        control_period: duration of a control step [s].
        delay: delay before the operator's inputs take effect [steps].
        telemetry_delay: delay of the values, lamps and log that the station displays [s].
        camera_delay: delay of the station's pictures [s].
        start: initial state of the arm.
        parts: initial state of each part of the problem that the scenario describes, and `start` for "full problem";
            empty if the scenario describes no part.
        payloads: payloads of the worksite that are present.
        docking_axes: axes of payload and port that docking compares: all, or only y as in the report.
        free_contact: effect of a contact on a floating payload.
        caution: clearance below which the page shows a caution [m].
        warning: clearance below which the page shows a warning [m].
        lamps: switches of the lamps that are present.
        lighting: light at the start.
        camera_settings: settings of camera drives at the start that replace the cameras' own, by the camera's name.
        mode: mode at the start.
        rate: rate setting at the start, coarse or vernier.
        as_flown: whether every joint stops, in computed modes, when one joint is past its soft stop.
        strict: whether the steering is as published, without the corrections.
        guarded: whether computed modes slow the arm before its stops and singularities.
        near: radius of the end sphere of the automatic modes [m].
        near_turn: angle to the target's orientation up to which the tip counts as inside the end sphere [rad].
        fly_by: distance within which a fly-by point is passed [m].
        fly_by_turn: angle within which a fly-by point is passed [rad].
        law: steering law of the automatic modes at the start, one of the report's modes 1 to 3.
        payload_axes: whether ORB LD rotates in payload axes at the start.
        position_hold: whether POSITION HOLD is on at the start.
        sequences: points of AUTO 1-4, by panel position.
        por: limits of the point of resolution that replace the arm's limits.
        own_payloads: payloads that the scenario itself attaches to the end effector: the payload of `[payload]`, then
            the payloads of the phases. The end effector neither captures nor releases these payloads.
        payload: the payload of `[payload]`, which is attached at the start; None if there is none.
        disturbances: forces and torques that act for a time, on a plant with masses.
        planned_changes: changes in flight that the file plans, in the order of their times.
        phases: the script; empty if there is none.
        steps: steps of the operator's task; empty if the scenario describes none.
        next: name of the scenario that the station proposes after the last step; empty if it proposes none.
        text: text of the file.
        changes: changes from the text to this scenario, each as KEY=VALUE.
        cautions: misfits (`scenario.fit`) that do not make every run meaningless.
    """

    name: str
    title: str
    description: str
    group: ScenarioGroup
    minutes: int | None
    arm: Arm
    worksite: Worksite
    seed: int
    plant: Plant
    orbiter: OrbiterMotion
    inhibit: bool
    duration: float
    ticks: int
    control_period: float
    delay: int
    telemetry_delay: float
    camera_delay: float
    start: Start
    parts: dict[Part, Start]
    payloads: tuple[Payload, ...]
    docking_axes: Literal["all", "y"]
    free_contact: FreeContact
    caution: float
    warning: float
    lamps: tuple[str, ...]
    lighting: Lighting
    camera_settings: dict[str, Setting]
    mode: str
    rate: Rate
    as_flown: bool
    strict: bool
    guarded: bool
    near: float
    near_turn: float
    fly_by: float
    fly_by_turn: float
    law: LawChoice
    payload_axes: bool
    position_hold: bool
    sequences: Sequences
    por: PorOverride
    own_payloads: tuple[HeldPayload, ...]
    payload: HeldPayload | None
    disturbances: tuple[Planned, ...]
    planned_changes: tuple[PlannedChange, ...]
    phases: tuple[PhasePlan, ...]
    steps: tuple[TaskStep, ...]
    next: str
    text: str
    changes: tuple[str, ...]
    cautions: tuple[Problem, ...]

    def __deepcopy__(self, _memo: dict[int, object]) -> Scenario:
        """Return the scenario itself, which nothing can change."""
        return self

    def __reduce__(self) -> tuple[Callable[[bytes], Scenario], tuple[bytes]]:
        """Return how a pickled scenario is made again, with arrays that nothing can change."""
        return _unpickled, (pickled({field.name: getattr(self, field.name) for field in fields(self)}),)

    @cached_property
    def flexures(self) -> tuple[Flexure, ...]:
        """Parts of the arm that bend on the scenario's plant."""
        return flexures_of(self.arm.model) if self.plant == "flexible" else ()

    @cached_property
    def changes_at(self) -> dict[int, list[dict[str, str]]]:
        """Planned changes in flight, by the number of the step in which they act, from 1."""
        found: dict[int, list[dict[str, str]]] = {}
        for planned in self.planned_changes:
            found.setdefault(planned.tick, []).append(planned.changes)
        return found

    @cached_property
    def disturbable(self) -> Disturbable:
        """What disturbances can act on."""
        names = payload_names([one.name for one in self.payloads], own=bool(self.own_payloads))
        return Disturbable(self.plant, self.orbiter, names)

    @property
    def initial_angles(self) -> np.ndarray:
        """(n,) joint angles at the start [rad]."""
        return self.start.angles

    @property
    def initial_rates(self) -> np.ndarray:
        """(n,) joint rates at the start [rad/s]."""
        return self.start.rates


def _unpickled(values: bytes) -> Scenario:
    """Return a scenario from the pickle of its fields."""
    return Scenario(**pickle.loads(values))
