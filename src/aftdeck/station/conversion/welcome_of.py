"""Welcome message of a scenario, which a page receives before all frames: arm, modes, cameras, payloads, bodies."""

from __future__ import annotations

from functools import lru_cache

from aftdeck.arrays import Array
from aftdeck.details.details_of import details_of
from aftdeck.scenario.all_cameras import cameras_of
from aftdeck.scenario.light import conditions
from aftdeck.scenario.model import Scenario
from aftdeck.scenario.task_step import TaskStep, UseInStep
from aftdeck.scene.bodies import bodies_of
from aftdeck.simulation.operator.master import AXES, axes_of
from aftdeck.station.conversion.payload_table import payload_table, stored_sequences
from aftdeck.station.messages import kinds
from aftdeck.station.messages.to_page import Changed
from aftdeck.station.messages.welcome import (
    BodyInfo,
    FlexureInfo,
    HintInfo,
    JointInfo,
    ModeInfo,
    SeatInfo,
    StandInfo,
    StepInfo,
    UseInfo,
    Welcome,
    WorkInfo,
)
from aftdeck.steering.mode import MODES, Mode
from aftdeck.version import __version__


def welcome_of(scenario: Scenario, *, demo: bool) -> Welcome:
    """Return the welcome message; `demo` is True if the session begins with the scenario's script."""
    model, now = scenario.arm.model, changed_of(scenario)
    bodies = tuple(
        BodyInfo(body.name, body.shapes, details)
        for body, details in zip(bodies_of(scenario), details_of(scenario), strict=True)
    )
    modes = tuple(
        ModeInfo(m.position, m.laws, m.title, m.kind, m.point, _has_points(scenario, m), m.axes, m.axis_names)
        for m in MODES.values()
    )
    return Welcome(
        protocol=kinds.PROTOCOL,
        version=__version__,
        scenario=scenario.name,
        title=scenario.title,
        text=scenario.description,
        arm=model.title,
        plant=scenario.plant,
        control_period_s=scenario.control_period,
        command_delay_s=scenario.delay * scenario.control_period,
        telemetry_delay_s=now.telemetry_delay_s,
        camera_delay_s=now.camera_delay_s,
        units=model.units,
        joints=now.joints,
        modes=modes,
        work=now.work,
        conditions=conditions(),
        lamps=scenario.lamps,
        bodies=bodies,
        flexures=_flexures(scenario),
        ghost=_ghost(scenario, len(bodies)),
        cameras=now.cameras,
        payloads=now.payloads,
        sequences=stored_sequences(scenario),
        singularities=model.singularities,
        singular=now.singular,
        steps=tuple(_step(step) for step in scenario.steps),
        next=scenario.next,
        phases=tuple(phase.name for phase in scenario.phases) if demo else (),
    )


@lru_cache(maxsize=8)
def changed_of(scenario: Scenario) -> Changed:
    """Return the fields of the welcome that changes in flight can change; `scenario`: with the changes in force."""
    model = scenario.arm.model
    servo = None if scenario.plant == "kinematic" else model.servo
    joints = tuple(
        JointInfo(
            name,
            label,
            stick=None if axis is None else AXES[axis],
            slides=model.slides[i],
            hard=_pair(model.limits.hard[i]),
            soft=_pair(model.limits.soft[i]),
            reach=_pair(model.limits.reach[i]),
            coarse=float(model.rates.coarse[i]),
            vernier=float(model.rates.vernier[i]),
            servo=float(model.rates.servo[i]),
            torque=None if servo is None else float(servo.torque_limit[i]),
            holding=None if servo is None else float(servo.holding_torque[i]),
        )
        for i, (name, label, axis) in enumerate(zip(model.joints, model.labels, axes_of(model), strict=True))
    )
    return Changed(
        joints=joints,
        cameras=cameras_of(scenario),
        work=_work(scenario),
        payloads=payload_table(scenario),
        singular=model.singular,
        telemetry_delay_s=scenario.telemetry_delay,
        camera_delay_s=scenario.camera_delay,
    )


def _work(scenario: Scenario) -> WorkInfo:
    """Return the equipment of a scenario's worksite and its clearance thresholds."""
    model = scenario.arm.model
    telescope, prong = model.telescope, model.prong
    return WorkInfo(
        hand="snares" if prong is None else "prong",
        effector=(model.linkage.frames[-1], *(() if prong is None else (prong.frame,))),
        stand=None if telescope is None else StandInfo(telescope.least, telescope.greatest, telescope.rate),
        cargo=tuple(payload.name for payload in scenario.payloads),
        seats=tuple(SeatInfo(berth.name, berth.title) for berth in scenario.worksite.berths),
        parts=tuple(scenario.parts),
        caution=scenario.caution,
        warning=scenario.warning,
    )


def _step(step: TaskStep) -> StepInfo:
    """Return a step of the operator's task."""
    hints = tuple(HintInfo(hint.text, _uses(hint.uses)) for hint in step.hints)
    return StepInfo(step.title, step.text, step.mode, _uses(step.uses), step.groups, step.cameras, hints)


def _uses(uses: tuple[UseInStep, ...]) -> tuple[UseInfo, ...]:
    return tuple(UseInfo(*use) for use in uses)


def _flexures(scenario: Scenario) -> tuple[FlexureInfo, ...]:
    """Return the parts of the arm that bend."""
    first = len(scenario.worksite.bodies)
    return tuple(
        FlexureInfo(first + part.frame, (float(part.end[0]), float(part.end[1]), float(part.end[2])))
        for part in scenario.flexures
    )


def _ghost(scenario: Scenario, count: int) -> tuple[int, ...]:
    """Return the indices of the arm's bodies and the payloads in `Welcome.bodies`, which has `count` entries."""
    first, payloads = len(scenario.worksite.bodies), len(scenario.payloads)
    return (*range(first, first + len(scenario.arm.model.frames)), *range(count - payloads, count))


def _has_points(scenario: Scenario, mode: Mode) -> bool:
    return not mode.prestored or mode.position in scenario.sequences


def _pair(values: Array) -> tuple[float, float]:
    return float(values[0]), float(values[1])
