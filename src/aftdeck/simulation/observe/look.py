"""Frame of a step, built from the state after the step."""

from __future__ import annotations

from aftdeck.frames import angle_between
from aftdeck.kinematics.observe import SEEN
from aftdeck.matrices import distance
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.frame import Frame, Goal, Placed, Times
from aftdeck.simulation.motion.active_limits import active_limits
from aftdeck.simulation.observe.frame_numbers import carried_numbers, frame_numbers
from aftdeck.simulation.observe.look_bodies import dynamics_of
from aftdeck.simulation.observe.look_work import work_of
from aftdeck.simulation.observe.motions import motions_of
from aftdeck.simulation.payloads.grasp import packed_in_grasp
from aftdeck.simulation.state import Panel, State
from aftdeck.steering.layout import RATE, RATES
from aftdeck.steering.mode import MODES
from aftdeck.tuples import Rows, Vec3


def frame_of(flight: Flight, state: State, seal: bytes) -> Frame:
    """Return the frame of the last step, with its log lines and the state's digest; leave the state unchanged."""
    scenario, panel, plant = flight.scenario, state.panel, state.plant
    model, rules = scenario.arm.model, state.rules
    observed, steered, scalars, acted = frame_numbers(
        model.links,
        model.mount.rotation,
        plant.angles,
        state.observed,
        rules,
        state.command,
        state.steering,
        state.report,
    )
    position, orientation, tip_twist, wrist_pitch = observed
    singularity = tuple(state.observed[SEEN:].tolist())
    angles, rates = tuple(plant.angles.tolist()), tuple(plant.rates.tolist())
    angles_commanded, joints = tuple(plant.commanded.tolist()), len(model.joints)
    rates_commanded = tuple(state.steering[RATES : RATES + joints].tolist())
    rate_limits = tuple(rules[RATE : RATE + joints].tolist())
    twist_commanded, twist_demanded, por_limits, translation, rotation = steered
    drive, ratio, remaining, turn_remaining, go = scalars
    points = len(scenario.sequences.get(panel.mode, ()))
    resolution, twist, payload = position, tip_twist, None
    if (held := packed_in_grasp(flight.site, state.worksite, state.carried.payload)) is not None:
        pose, centre, velocity = carried_numbers(state.observed, held)
        payload = Placed(*pose)
        if MODES[panel.mode].loaded and not scenario.strict:  # as published, the POR is always the tip
            resolution, twist = centre, (*tip_twist[:3], *velocity)
    return Frame(  # in the order of its fields; names of arguments would cost 2 us in each frame
        state.tick,
        round(state.tick * scenario.control_period, 9),
        state.phase,
        "script" if state.by_script else "hand",
        panel.mode,
        panel.flown,
        panel.law,
        panel.payload_axes,
        panel.rate_hold_sticks is not None,
        panel.position_hold,
        panel.brakes,
        panel.safing,
        panel.joint,
        panel.rate,
        panel.sequence,
        min(panel.point + 1, points) if points else 0,
        points,
        panel.check,
        translation,
        rotation,
        drive,
        angles,
        rates,
        angles_commanded,
        rates_commanded,
        rate_limits,
        panel.zones,
        position,
        orientation,
        wrist_pitch,
        resolution,
        payload,
        state.script.attached,
        twist,
        twist_commanded,
        twist_demanded,
        por_limits,
        ratio,
        active_limits(flight, state, acted),
        singularity,
        panel.singular,
        state.ways_out,
        _goal(panel, position, orientation, remaining),
        _times(flight, state, remaining, turn_remaining, under_way=go != 0.0),
        work_of(flight, state),
        tuple(state.events),
        state.views,
        seal.hex(),
        dynamics_of(flight, state),
        motions_of(flight, state.worksite, plant.stand),
        state.changes,
    )


def _times(flight: Flight, state: State, remaining: float, turn_remaining: float, *, under_way: bool) -> Times:
    """Return TP, ETA and ETAP.

    The laws report the remaining time at the beginning of the step. ETA and ETAP are therefore computed from TP at that
    time.
    """
    panel, period = state.panel, flight.scenario.control_period
    steered = (state.tick - 1 - panel.motion_began) * period
    eta = etap = None
    if panel.sequence == "in progress":
        if under_way:
            eta = steered + remaining
            etap = None if panel.law == "position" else steered + turn_remaining
    elif state.by_script and state.phase and not state.script.ended:
        phase = flight.scenario.phases[state.script.phase]
        eta = phase.duration if phase.timed else None
    return Times(steered + period, eta, etap)


def _goal(panel: Panel, position: Vec3, orientation: Rows, remaining: float) -> Goal | None:
    target = panel.target
    if target is None:
        return None
    return Goal(
        target.position,
        target.rotation,
        distance(target.position, position),
        angle_between(target.rotation, orientation),
        remaining if panel.sequence == "in progress" else 0.0,
    )
