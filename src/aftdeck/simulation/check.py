"""CMD CK: whether the way to a target is clear, found by flying it ahead of time."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from aftdeck.errors import AftdeckError
from aftdeck.kinematics.singular import NAMES
from aftdeck.scenario.target import Target
from aftdeck.simulation.flight import Flight
from aftdeck.simulation.frame import Check
from aftdeck.simulation.inputs import AGREED
from aftdeck.simulation.log import spoken
from aftdeck.simulation.miss import THERE, THERE_TURN, miss
from aftdeck.simulation.standstill import held_fast
from aftdeck.simulation.state import State
from aftdeck.steering.layout import ANGLES, COMMAND, DT, GO, LAW, MASTER, NEAR, NEAR_TURN, PLAN, REPORT, TARGET
from aftdeck.steering.limiters import BY_SINGULARITY, CAUSES
from aftdeck.steering.mode import AUTOMATIC_LAWS
from aftdeck.steering.rehearsal import rehearse

Array = NDArray[np.float64]

LONGEST = 3600.0
"""Longest motion rehearsed [s]."""
COARSE_STEP = 0.08
"""Step of a rehearsal [s], where the control period is shorter."""


def set_course(state: State, target: Target, command: Array) -> None:
    """OPERIN: what the law chosen for the automatic modes needs to set off to a target, into `command`.

    Raises:
        UnreachableError, SingularityError: no joint angles put the tip there.
    """
    final = _final_angles(state, target)
    command[LAW], command[GO] = AUTOMATIC_LAWS[state.panel.law], 0.0
    command[TARGET : TARGET + 3] = target.position
    command[TARGET + 3 : TARGET + 12] = np.ravel(target.rotation)
    command[PLAN:MASTER] = 0.0
    command[PLAN : PLAN + 6] = final


def _final_angles(state: State, target: Target) -> Array:
    """Joint angles at the target: as given, or the solution nearest to the present ones.

    Angles given while the telescope had another length lead elsewhere: then the solution nearest to them.
    """
    given = None if target.joints is None else np.array(target.joints)
    if given is not None and math.dist(state.arm.forward(given).position, target.position) <= AGREED:
        return given
    nearest: Array = state.arm.inverse(target.pose, near=state.plant.angles if given is None else given)[0]
    return nearest


def command_check(flight: Flight, state: State, target: Target) -> Check:
    """GOOD with the time the motion takes, or FAIL with what is in its way: a seat, reach, a stop, a singularity.

    A motion that ends beside its target fails, for it is asked to go there. With `strict` it may be flown: what the
    source's own clock misses is what that setting is there to show, and the text says how much.
    """
    if fast := held_fast(flight, state):
        return Check(False, f"FAIL: {fast}")
    command, steering = np.zeros(COMMAND), state.steering.copy()
    rules = state.carried.rules["OPR CMD", state.panel.rate].copy()
    rules[DT] = max(rules[DT], COARSE_STEP)
    rules[NEAR], rules[NEAR_TURN] = max(rules[NEAR], THERE), max(rules[NEAR_TURN], THERE_TURN)
    try:
        set_course(state, target, command)
    except AftdeckError as error:
        return Check(False, f"FAIL: {error}")
    went = rehearse(rules, command, steering, np.zeros(REPORT), LONGEST)
    if went.arrived:
        where = f", passing the {NAMES[went.which]} singularity at {went.nearest:.2f}"
        close = where if went.nearest < flight.scenario.arm.model.singular else ""
        beside = miss(flight, state.arm, steering[ANGLES : ANGLES + 6], target)
        if beside and not flight.scenario.strict:
            return Check(False, f"FAIL: ends {beside} the target{close}")
        missing = f", ends {beside} the target" if beside else ""
        return Check(True, f"GOOD: {went.time:.0f} s{missing}{close}")
    if went.cause == 0:
        return Check(False, f"FAIL: not there within {LONGEST:.0f} s")
    if went.cause == BY_SINGULARITY:
        return Check(False, f"FAIL: the {NAMES[went.culprit]} singularity lies in the way, {went.time:.0f} s from here")
    joint = spoken(flight.scenario.arm.joints[went.culprit])
    return Check(False, f"FAIL: {joint} meets its {CAUSES[went.cause]} {went.time:.0f} s from here")
