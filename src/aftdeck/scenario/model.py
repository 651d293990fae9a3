"""A scenario, checked and frozen: all that a simulation starts from."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from aftdeck.arms.load import PorLimits
from aftdeck.kinematics.arm import Arm
from aftdeck.kinematics.payload import Payload
from aftdeck.scenario.schema import Rate
from aftdeck.scenario.target import Target
from aftdeck.steering.mode import LawChoice, PanelPosition
from aftdeck.worksite.model import Worksite


@dataclass(frozen=True, eq=False)
class PhasePlan:
    """A phase of the script, ready to fly.

    Attributes:
        name: for the summary and the page.
        mode: panel position.
        rate: coarse or vernier.
        translation: THC, each in [-1, 1].
        rotation: RHC (roll, pitch, yaw), each in [-1, 1].
        joint: selected joint, 0 to 5.
        drive: SINGLE/DIRECT DRIVE in [-1, 1].
        joint_at: angle to bring the joint to [rad], or None.
        target: final tip pose, or None.
        law: which of the report's modes 1 to 3 an automatic mode flies; None: as it is.
        payload_axes: ORB LD rotates in payload axes; None: as it is.
        duration: length, or longest length in automatic modes [s]; None: no limit.
    """

    name: str
    mode: PanelPosition
    rate: Rate
    translation: tuple[float, float, float]
    rotation: tuple[float, float, float]
    joint: int
    drive: float
    joint_at: float | None
    target: Target | None
    law: LawChoice | None
    payload_axes: bool | None
    duration: float | None


@dataclass(frozen=True)
class Point:
    """A prestored point of AUTO 1-4.

    Attributes:
        target: where.
        pause: wait there for PROCEED; else only come near and go on.
    """

    target: Target
    pause: bool


Sequences = dict[str, tuple[Point, ...]]
"""The points of AUTO 1-4, by panel position."""


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
        initial_angles: (6,) [rad].
        initial_rates: (6,) [rad/s].
        mode: entered at the start.
        rate: coarse or vernier at the start.
        as_flown: soft stops stop every joint in computed modes.
        strict: the source's own steering, without the mending rules.
        near: end sphere of the automatic modes [m].
        near_turn: the same in rotation [rad].
        fly_by: how near a fly-by point is come [m].
        fly_by_turn: the same in rotation [rad].
        law: which of the report's modes 1 to 3 the automatic modes fly at the start.
        payload_axes: ORB LD rotates in payload axes at the start.
        position_hold: POSITION HOLD at the start.
        sequences: points of AUTO 1-4, by panel position.
        por: limits of the point of resolution with this payload.
        payload: in the grasp, or None.
        phases: the script; empty: none.
        text: the file.
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
    initial_angles: np.ndarray
    initial_rates: np.ndarray
    mode: PanelPosition
    rate: Rate
    as_flown: bool
    strict: bool
    near: float
    near_turn: float
    fly_by: float
    fly_by_turn: float
    law: LawChoice
    payload_axes: bool
    position_hold: bool
    sequences: Sequences
    por: PorLimits
    payload: Payload | None
    phases: tuple[PhasePlan, ...]
    text: str
