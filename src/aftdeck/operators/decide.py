"""What an operator does next: a function of the present step, its wanted state, and the frame.

An operator knows the procedures of the end effector and of the latches; where to move follows from the step's target.
"""

from __future__ import annotations

from typing import Literal

import msgspec
import numpy as np

from aftdeck.bodies.placed import components
from aftdeck.bodies.pose import vec3
from aftdeck.matrices import length
from aftdeck.operators.approach import LINED_UP, Axis, Speeds, deflection, deflections
from aftdeck.scenario.target import AtBerth, AtPayload
from aftdeck.scenario.task_step import TaskStep
from aftdeck.simulation.frame import Frame, WayOut
from aftdeck.simulation.inputs import Inputs
from aftdeck.steering.mode import MODES
from aftdeck.task.along_sticks import along_sticks
from aftdeck.task.progress import Progress
from aftdeck.task.remaining import Remaining
from aftdeck.tuples import Rows
from aftdeck.worksite.conditions import all_ready

CLOSED_BY_CLOSING = "prong closed"
"""Condition that the closing of the prong fulfils."""
OUT = 0.2
"""Deflection with which an operator leaves a contact."""
VERNIER_M, COARSE_M = 0.4, 0.8
"""Distance to a place of contact below which vernier rates are used, and above which coarse rates are used [m]."""
CONTACT_M = 0.1
"""Greatest distance above a payload or a berth at which a place is one of contact [m]."""
STILL_M_S = 0.01
"""Speed of the tip below which the operator works with end effector and latches [m/s]."""
_THC, _RHC = ("X", "Y", "Z"), ("roll", "pitch", "yaw")
_OPEN = 0.999
"""Opening from which on the end effector is open."""


def decide(frame: Frame, progress: Progress, axes: tuple[Rows, Rows], speeds: Speeds, orbiter: Speeds | None) -> Inputs:
    """Return what the operator wants now.

    Args:
        frame: the newest frame.
        progress: progress through the task, which has seen this frame; a step is present.
        axes: axes of the THC and of the RHC, in L, in columns.
        speeds: speeds of the arm.
        orbiter: speeds of the orbiter; None if it cannot translate.
    """
    step = progress.present
    assert step is not None, "an operator with a task that is over does nothing"
    if frame.work.arm_inhibit:
        return leave(frame, frame.ways_out)
    if step.mode is not None and frame.mode != step.mode:
        return Inputs(mode=step.mode)
    return operated(frame, step, progress.remaining()) or moved(frame, step, progress, axes, speeds, orbiter)


def leave(frame: Frame, ways: tuple[WayOut, ...]) -> Inputs:
    """Return the command of the first escape direction; centred sticks if there is none."""
    if not ways:
        return Inputs()
    way = ways[0]
    if way.position and frame.mode != way.position:
        return Inputs(mode=way.position)
    if way.stick == "joint":
        return Inputs(joint=way.axis, drive=way.sign * OUT)
    if way.stick == "telescope":
        return Inputs(telescope=way.sign * OUT)
    return _stick(way.stick, way.axis, way.sign * OUT)


def operated(frame: Frame, step: TaskStep, remaining: Remaining | None) -> Inputs | None:
    """Return the command for end effector, latches or sequence, or centred sticks while one of them acts.

    None if the step needs none now.
    """
    done, hand = step.done, frame.work.hand
    held = next((payload for payload in frame.work.cargo if payload.held), None)
    if MODES[frame.mode].kind == "automatic":
        return Inputs(proceed=frame.sequence == "ready")
    if held is None and done.held:
        return _capture(frame, remaining)
    if held is not None and done.held is False:
        return Inputs(effector="open" if hand.switch != "open" and _still(frame) else None)
    if held is None:
        return Inputs() if frame.motions else None
    if hand.carriage is not None and "RIGID" not in hand.flags:
        return Inputs()
    lifted = isinstance(step.target, AtBerth) and step.target.above > CONTACT_M
    if held.seat and (done.fixed is False or (lifted and done.berth is None)):
        return Inputs(latch=None if frame.motions else "unlatch")
    if not held.seat and (done.fixed or done.berth) and all_ready(frame.work.conditions) and _still(frame):
        return Inputs(latch=None if frame.motions else "latch")
    return Inputs() if frame.motions else None


def _capture(frame: Frame, remaining: Remaining | None) -> Inputs | None:
    """Return the command for a capture; None if the end effector has to move first."""
    hand, conditions = frame.work.hand, frame.work.conditions
    if hand.switch == "close" and frame.motions:
        return Inputs() if hand.spacing is None else None  # the bar may drift while the prong closes: follow it
    if hand.opening < _OPEN:
        return Inputs(effector="open" if hand.switch != "open" else None)
    ready = bool(conditions) and all(c.holds for c in conditions if c.name != CLOSED_BY_CLOSING)
    lined_up = remaining is None or remaining.distance <= LINED_UP * remaining.near[0]
    if not (ready and lined_up):
        return None
    return Inputs(effector="close" if _still(frame) else None)


def moved(
    frame: Frame, step: TaskStep, progress: Progress, axes: tuple[Rows, Rows], speeds: Speeds, orbiter: Speeds | None
) -> Inputs:
    """Return the sticks that bring the run closer to the state that completes the step."""
    done, remaining = step.done, progress.remaining()
    if done.looked:
        progress.look()
        return Inputs()
    if step.joint is not None:
        limit = frame.rate_limits[step.joint]
        left_of_joint = step.joint_at - frame.angles[step.joint]
        slides = progress.slides[step.joint]
        stops = speeds.por.acceleration if slides else speeds.por.angular_acceleration
        drive = deflection(left_of_joint, Axis(limit, stops, 0.0), speeds)
        within = done.within if slides else done.within_angle
        arrived = within is not None and abs(left_of_joint) < LINED_UP * within
        return Inputs(joint=step.joint, drive=0.0 if arrived else drive)
    if step.target is not None and remaining is not None:
        left = along_sticks(remaining, frame, axes)
        if left is None:
            return Inputs()
        if orbiter is not None and any(use.use == "fly orbiter" for use in step.uses) and done.orbiter_at_rest:
            arrived = done.within is not None and remaining.distance < LINED_UP * done.within
            thc, _ = deflections(left, remaining, None, (), orbiter)
            return Inputs(orbiter=(0.0, 0.0, 0.0) if arrived else vec3(thc, 0))
        if (rate := _rate(frame, step, remaining.distance)) is not None:
            return Inputs(rate=rate)
        out = progress.places.way_out(frame, step.target)
        thc, rhc = deflections(
            left,
            remaining,
            None if out is None else np.array(components(out, axes[0])),
            tuple("XYZ".index(axis) for axis in step.way),
            speeds,
        )
        return Inputs(translation=vec3(thc, 0), rotation=vec3(rhc, 0))
    if done.singular is False and frame.singular:
        return leave(frame, frame.ways_out)
    if done.sticks_released or done.at_rest:
        return Inputs()
    return _push(step, turns=done.turned is not None)


def _rate(frame: Frame, step: TaskStep, distance: float) -> Literal["coarse", "vernier"] | None:
    """Return the rate setting to change to; None for no change."""
    near = isinstance(step.target, AtPayload | AtBerth) and step.target.above <= CONTACT_M
    if near and distance < VERNIER_M and frame.rate == "coarse":
        return "vernier"
    return "coarse" if frame.rate == "vernier" and (not near or distance > COARSE_M) else None


def _push(step: TaskStep, turns: bool) -> Inputs:
    """Return full deflection of the first axis that the step names: of the RHC if `turns`, else of the THC."""
    stick, names = ("rotation", _RHC) if turns else ("translation", _THC)
    for use in step.uses:
        sign, axis = use.use[:1], use.use[1:]
        if axis in names:
            return _stick(stick, names.index(axis), float(f"{sign}1"))
    return Inputs()


def _still(frame: Frame) -> bool:
    """Return whether the tip is slow enough to work with end effector or latches."""
    return length(frame.twist[3:]) < STILL_M_S


def _stick(stick: str, axis: int, value: float) -> Inputs:
    vector = [0.0, 0.0, 0.0]
    vector[axis] = value
    return msgspec.structs.replace(Inputs(), **{stick: tuple(vector)})
