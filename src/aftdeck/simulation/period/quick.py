"""Calls of the compiled parts of a control step, with the single values that they need and change."""

from __future__ import annotations

from typing import TYPE_CHECKING

from aftdeck.simulation.parts.worksite_state import DRIVES, Halt
from aftdeck.simulation.payloads.jets import translation_rejection
from aftdeck.simulation.payloads.sliding import sliding_payload
from aftdeck.simulation.period.period import COUNTED, JUDGED, OBSERVED, advance, followed
from aftdeck.simulation.period.prong import close_or_open
from aftdeck.simulation.period.steer import steer
from aftdeck.simulation.row.scalars import (
    ALIGNED,
    ARM,
    BEGAN,
    CHANGED,
    CLOSES,
    CONTROLLED,
    CYCLE_AT,
    FINGER,
    FLOATS,
    HALT,
    LEAST,
    MADE,
    MOTION_AT,
    NEAREST,
    POSE_AT,
    PRONG_AT,
    PRONG_VELOCITY,
    REFERENCE_AT,
    STAND,
    STAND_VELOCITY,
    TELESCOPE,
    TIME_AT,
    WORKS,
)
from aftdeck.steering.mode import MODES
from aftdeck.worksite.capture.effector import BEGINS, MOVES, RESTS
from aftdeck.worksite.capture.snare import AUTO, MAN, unpacked
from aftdeck.worksite.watch.contacts import UNINHIBITED, Inhibit

if TYPE_CHECKING:
    from aftdeck.simulation.constants.flight import Flight
    from aftdeck.simulation.inputs import Inputs
    from aftdeck.simulation.state import State

RIGID_POSITIONS = ("off", "rigid", "derigid")
"""Positions of MAN CONTR, in the order of `snare.CONTRS`."""
_HALTS: tuple[Halt, ...] = ("", "seat", "switch", "contact")
"""What blocked the commanded motion, by the number in `HALT`."""


def quick_step(
    flight: Flight, state: State, inputs: Inputs, *, observes: bool, most: int = 1, goes_on: bool = False
) -> int:
    """Make control steps of the kinematic plant after the operator's commands, as far as compiled code can.

    Args:
        flight: constants of the run.
        state: changed in place; holds the command that the panel has set.
        inputs: the operator's inputs.
        observes: as for `advance`.
        most: greatest number of steps; `state.tick` is that of the first, and is then that of the last.
        goes_on: whether the row already has the single values, as `Row.goes_on` states.

    Returns:
        How far the last step has come, as `period.period.advance` returns it.
    """
    if goes_on:
        state.row.scalars[TELESCOPE] = inputs.telescope
    else:
        give(flight, state, inputs)
    reached = advance(
        state.row.arrays(flight.packed),
        *state.both_rules(),
        state.arm.model.links,
        state.stick_rules,
        observes,
        most,
    )
    take(flight, state, reached)
    return reached


def command_motion(flight: Flight, state: State, inputs: Inputs) -> float:
    """Command the rates in `state.steering`, as far as contacts, berths, switches and walls allow.

    Return the drive of the telescope that they allow, in [-1, 1]. On the kinematic plant, `quick_step` does this.
    """
    state.measure()
    give(flight, state, inputs)
    steer(state.row.arrays(flight.packed), *state.both_rules())
    values = state.row.values = state.row.scalars.tolist()
    state.worksite.halt = _HALTS[int(values[HALT])]
    if values[BEGAN]:
        state.panel.motion_began = state.tick - 1
    return float(values[TELESCOPE])


def follow_bodies(flight: Flight, state: State, *, observes: bool) -> int:
    """Complete a step after Python code has moved bodies, as far as compiled code can; return how far that is.

    `observes` as for `advance`.
    """
    plant, scalars = state.plant, state.row.scalars
    scalars[STAND], scalars[STAND_VELOCITY], scalars[MADE] = plant.stand.position, plant.stand.velocity, 1.0
    scalars[PRONG_AT], scalars[PRONG_VELOCITY] = state.worksite.prong.position, state.worksite.prong.velocity
    pressed = plant.bodies is not None and bool(plant.bodies.touches)
    links, sticks = state.arm.model.links, state.stick_rules
    reached = followed(state.row.arrays(flight.packed), plant.frames, pressed, links, sticks, observes)
    _take_values(flight, state, reached)
    return reached


def move_prong(flight: Flight, state: State) -> None:
    """Move the prong after the bodies of a plant with masses. On the kinematic plant, `quick_step` does this."""
    scalars, prong, plant = state.row.scalars, state.worksite.prong, state.plant
    if state.row.values[CLOSES] == 0.0 and prong.velocity == 0.0:
        return
    scalars[STAND] = plant.stand.position
    close_or_open(state.row.arrays(flight.packed), plant.frames)
    prong.position, prong.velocity = scalars[[PRONG_AT, PRONG_VELOCITY]].tolist()


def take(flight: Flight, state: State, reached: int) -> None:
    """Take the single values of the state and the free flights from its row; arguments as for `_take_values`."""
    _take_values(flight, state, reached)
    if state.row.floats and (reached >= JUDGED or state.row.values[MADE] > 1.0):
        _take_flights(state)


def _take_values(flight: Flight, state: State, reached: int) -> None:
    """Take the single values of the state from its row.

    Args:
        flight: constants of the run.
        state: changed in place; its tick is that of the first step.
        reached: how far compiled code has made the last step. What it has not reached is in the row as the step before
            has left it.
    """
    plant, worksite, values = state.plant, state.worksite, state.row.scalars.tolist()
    state.row.values, several = values, values[MADE] > 1.0
    worksite.halt = _HALTS[int(values[HALT])]
    state.tick += int(values[MADE]) - 1
    if values[BEGAN]:
        state.panel.motion_began = state.tick - 1
    plant.stand.position, plant.stand.velocity = values[STAND], values[STAND_VELOCITY]
    worksite.prong.position, worksite.prong.velocity = values[PRONG_AT], values[PRONG_VELOCITY]
    if reached < JUDGED and not several:
        return
    worksite.nearest, worksite.watch.least = int(values[NEAREST]), values[LEAST]
    if values[WORKS] == MOVES:
        worksite.snare = unpacked(state.row.snare)
    if reached >= COUNTED or several:
        worksite.aligned_with = None if values[ALIGNED] < 0.0 else int(values[ALIGNED])
    if several and reached < OBSERVED:
        take_advice(flight, state)


def take_advice(flight: Flight, state: State) -> None:
    """Take the stick directions that were shown last from the state's row."""
    names = (*flight.scenario.arm.model.singularities, *flight.scenario.arm.joints)
    for name, direction in zip(names, state.row.limits.advice.tolist(), strict=True):
        if direction >= 0:
            state.panel.advice[name] = direction


def inhibit_of(state: State) -> Inhibit:
    """Return the inhibits that compiled code has found."""
    values = state.row.values
    arm, finger, changed = values[ARM] != 0.0, values[FINGER] != 0.0, values[CHANGED] != 0.0
    return Inhibit(arm, finger, changed) if arm or finger or changed else UNINHIBITED


def give(flight: Flight, state: State, inputs: Inputs) -> None:
    """Write the single values and free flights that compiled code needs into the state's row."""
    site, worksite, panel, plant = flight.site, state.worksite, state.panel, state.plant
    held, kind = worksite.held, MODES[panel.mode].kind
    inhibit = worksite.contacts.inhibit
    released, docked = 0, False
    if held is not None:
        payload = worksite.payloads[held]
        docked = bool(payload.berth) and site.berth(payload.berth).docks
        if payload.released_from:
            number = site.number(held, payload.released_from)
            released = number + 1 if number >= 0 else -1
    works, pressed = RESTS, inputs.effector is not None
    if (pressed or worksite.snare.motion or worksite.rigid != "off") and not (
        site.capture is None or state.script.attached
    ):
        works = site.capture.acts(worksite.controls(pressed=pressed))
    if inputs.latch is not None or any(payload.latches.motion for payload in worksite.payloads):
        works = BEGINS
    if works == MOVES:
        state.row.snare[:] = worksite.snare.packed
    orbits = any(inputs.orbiter) or (site.worksite.translation is not None and bool(worksite.orbiter_velocity.any()))
    orbits = orbits and not translation_rejection(flight, worksite, plant.bodies)
    state.row.give(
        inputs.telescope,
        DRIVES[worksite.switch] if site.prong and not state.script.attached else 0.0,
        state.standing.height,
        plant.stand.position,
        plant.stand.velocity,
        worksite.prong.position,
        worksite.prong.velocity,
        -1 if held is None else held,
        worksite.arm_fixed,
        docked,
        released,
        panel.brakes or panel.safing,
        kind == "automatic",
        panel.sequence == "in progress",
        sliding_payload(flight, held, panel.mode) is not None,
        inhibit.arm,
        inhibit.finger,
        orbits,
        works,
        worksite.task,
        worksite.nearest,
        -1 if worksite.aligned_with is None else worksite.aligned_with,
        *flight.same_level[panel.clearance],
        panel.stick_law,
        MODES[panel.mode].by_joint,
        AUTO if worksite.effector_mode == "auto" else MAN,
        RIGID_POSITIONS.index(worksite.rigid),
        worksite.advice is not None,
        *inputs.orbiter,
        bool(worksite.logged_contacts),
    )
    give_limits(flight, state)
    floats = worksite.floating.count(None) < len(worksite.floating)
    if floats or state.row.floats:
        _give_flights(state)
        state.row.floats = floats


def give_limits(flight: Flight, state: State) -> None:
    """Write the limits and singularities of the step before, and the ways out that were shown, into the state's row."""
    panel, row = state.panel, state.row
    if not (panel.advice or panel.singular or any(panel.zones) or row.limited):
        return
    singularities, joints = flight.scenario.arm.model.singularities, flight.scenario.arm.joints
    row.limits.zones[:] = panel.zones or 0
    row.limits.singular[:] = [name in panel.singular for name in singularities]
    row.limits.advice[:] = [panel.advice.get(name, -1) for name in (*singularities, *joints)]
    row.limited = bool(panel.advice or panel.singular or any(panel.zones))


def _give_flights(state: State) -> None:
    """Write the free flights into the state's row."""
    for row, one in zip(state.row.flights, state.worksite.floating, strict=True):
        row[FLOATS] = one is not None
        if one is None:
            continue
        row[POSE_AT:MOTION_AT], row[MOTION_AT:REFERENCE_AT] = one.pose, one.motion
        row[TIME_AT], row[CONTROLLED] = one.time, one.cycle is not None
        if one.cycle is not None:
            row[REFERENCE_AT:CYCLE_AT], row[CYCLE_AT:TIME_AT] = one.reference.ravel(), one.cycle


def _take_flights(state: State) -> None:
    """Take the free flights from the state's row."""
    for row, one in zip(state.row.flights, state.worksite.floating, strict=True):
        if one is not None:
            one.pose[:], one.motion[:] = row[POSE_AT:MOTION_AT], row[MOTION_AT:REFERENCE_AT]
            one.time, one.met = float(row[TIME_AT]), False
