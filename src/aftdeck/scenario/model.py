"""A scenario, checked and frozen: all that a simulation starts from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from aftdeck.arms.limits import JointRates
from aftdeck.files import Problem
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.payload import Payload
from aftdeck.scenario.light import Lighting
from aftdeck.scenario.schema import FreeContact, PorOverride, Rate, Until
from aftdeck.scenario.target import Place, Target
from aftdeck.steering.mode import MODES, LawChoice, PanelPosition
from aftdeck.worksite.model import Cargo, Worksite


@dataclass(frozen=True, eq=False)
class RateLimits:
    """Limits of rates and accelerations.

    Attributes:
        joints: of the joints.
        por: of the point of resolution, in place of the arm's.
    """

    joints: JointRates
    por: PorOverride


@dataclass(frozen=True, eq=False)
class PhasePlan:
    """A phase of the script, ready to fly.

    Attributes:
        name: for the summary and the page.
        mode: panel position.
        rate: coarse or vernier.
        translation: THC, each in [-1, 1].
        rotation: RHC (roll, pitch, yaw), each in [-1, 1].
        velocity: V_C' in place of the THC [m/s]; None: the THC.
        angular_velocity: omega_C' in place of the RHC [rad/s]; None: the RHC.
        joint: selected joint, 0 to 5.
        drive: SINGLE/DIRECT DRIVE in [-1, 1].
        joint_rate: theta_dot_C' in place of the drive [rad/s]; None: the drive.
        joint_at: angle to bring the joint to [rad], or None.
        target: final tip pose, or where it is found as the phase begins, or None.
        law: which of the report's modes 1 to 3 an automatic mode flies; None: as it is.
        payload_axes: ORB LD rotates in payload axes; None: as it is.
        master: angles of the master arm [rad]; None: it stays.
        effector: how the end effector switch is put; None: as it is.
        latch: pressed as the phase begins; None: not.
        stand_at: length to bring the telescope to [m]; None: it stays.
        orbiter: translation of the orbiter, each in [-1, 1].
        limits: that hold while the phase lasts; None: the scenario's.
        attaches: which of `Scenario.own_payloads`, from 1, is in the grasp from the phase on; 0: none; None: it stays
            as it is.
        until: what the phase waits for; None: its mode's own end.
        duration: length, or longest length in automatic modes [s]; None: no limit.
    """

    name: str
    mode: PanelPosition
    rate: Rate
    translation: tuple[float, float, float]
    rotation: tuple[float, float, float]
    velocity: tuple[float, float, float] | None
    angular_velocity: tuple[float, float, float] | None
    joint: int
    drive: float
    joint_rate: float | None
    joint_at: float | None
    target: Target | Place | None
    law: LawChoice | None
    payload_axes: bool | None
    master: tuple[float, float, float, float, float, float] | None
    effector: Literal["stop", "close", "open"] | None
    latch: Literal["latch", "unlatch"] | None
    stand_at: float | None
    orbiter: tuple[float, float, float]
    limits: RateLimits | None
    attaches: int | None
    until: Until | None
    duration: float | None

    @property
    def timed(self) -> bool:
        """Whether nothing but its duration ends the phase."""
        driven = MODES[self.mode].kind == "single" and self.joint_at is None
        waits = self.until is not None or self.stand_at is not None
        return (driven or MODES[self.mode].kind in ("manual", "test")) and not waits


@dataclass(frozen=True)
class Point:
    """A prestored point of AUTO 1-4.

    Attributes:
        target: where.
        pause: wait there for PROCEED; else only come near and go on.
    """

    target: Target
    pause: bool


Part = Literal["full problem", "acquisition", "extraction", "manoeuvring"]
"""Parts of the report's problem."""

Sequences = dict[str, tuple[Point, ...]]
"""The points of AUTO 1-4, by panel position."""


@dataclass(frozen=True, eq=False)
class Grasped:
    """A payload that is held from the start.

    Attributes:
        cargo: which of the scenario's.
        angles: (6,) joint angles at which the arm took it in its place [rad].
        stand: length of the telescope then [m].
    """

    cargo: int
    angles: np.ndarray
    stand: float


@dataclass(frozen=True, eq=False)
class Start:
    """How the arm starts, the whole problem or a part of it.

    Attributes:
        angles: (6,) [rad].
        rates: (6,) [rad/s].
        stand: length of the telescope, or height of the shoulder where there is none [m].
        grasped: what it holds of the worksite's payloads; None: nothing.
    """

    angles: np.ndarray
    rates: np.ndarray
    stand: float
    grasped: Grasped | None


@dataclass(frozen=True, eq=False)
class Scenario:
    """All that a simulation starts from. Frozen; arrays in it are read-only.

    Attributes:
        name: built-in name or file stem.
        title: for people.
        description: what the operator is asked to do.
        arm: with the scenario's limits in place of its own.
        worksite: the place to draw.
        seed: of everything random.
        duration: longest simulated time [s].
        ticks: the same, in control periods.
        control_period: [s].
        delay: steps that a person's inputs are under way before they are flown.
        telemetry_delay: how late the station's figures, lamps and log are [s].
        camera_delay: how late its pictures are [s].
        start: how the arm starts.
        parts: where the parts of the problem begin anew; "full problem" is `start`.
        cargo: the worksite's payloads that are there.
        docking_axes: which axes docking compares: all, or y alone as the report does.
        free_contact: what a contact does to a body that nothing holds.
        caution: clearance under which the page cautions [m].
        warning: clearance under which it warns [m].
        lamps: switches of the lamps that are there.
        lighting: how the light is at the start.
        mode: entered at the start.
        rate: coarse or vernier at the start.
        as_flown: soft stops stop every joint in computed modes.
        strict: the source's own steering, without the corrections.
        guarded: computed modes slow the arm before its stops and singularities.
        near: end sphere of the automatic modes [m].
        near_turn: the same in rotation [rad].
        fly_by: how near a fly-by point is come [m].
        fly_by_turn: the same in rotation [rad].
        law: which of the report's modes 1 to 3 the automatic modes fly at the start.
        payload_axes: ORB LD rotates in payload axes at the start.
        position_hold: POSITION HOLD at the start.
        sequences: points of AUTO 1-4, by panel position.
        por: limits of the point of resolution in place of the arm's.
        own_payloads: payloads that the scenario itself puts into the grasp: its own, then those of its phases. The
            hand neither takes nor lets go of them.
        payload: the first of these, where it is in the grasp at the start; else None.
        phases: the script; empty: none.
        text: the file.
        cautions: what does not fit, though runs make sense that stay clear of it.
    """

    name: str
    title: str
    description: str
    arm: Arm
    worksite: Worksite
    seed: int
    duration: float
    ticks: int
    control_period: float
    delay: int
    telemetry_delay: float
    camera_delay: float
    start: Start
    parts: dict[Part, Start]
    cargo: tuple[Cargo, ...]
    docking_axes: Literal["all", "y"]
    free_contact: FreeContact
    caution: float
    warning: float
    lamps: tuple[str, ...]
    lighting: Lighting
    mode: PanelPosition
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
    own_payloads: tuple[Payload, ...]
    payload: Payload | None
    phases: tuple[PhasePlan, ...]
    text: str
    cautions: tuple[Problem, ...]

    @property
    def initial_angles(self) -> np.ndarray:
        """(6,) joint angles at the start [rad]."""
        return self.start.angles

    @property
    def initial_rates(self) -> np.ndarray:
        """(6,) joint rates at the start [rad/s]."""
        return self.start.rates
