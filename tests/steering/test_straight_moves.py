"""Random straight moves of the kinematic plant in modes 1, 2 and 3.

According to Pinocchio, the lines of these moves stay inside the soft stops and clear of singularities.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.frames import angle_between
from aftdeck.steering.course import start_motion
from aftdeck.steering.layout import (
    ANGLES,
    ARRIVED,
    COMMAND,
    LAW,
    MEASURED,
    MOTION_ACTIVE,
    PLAN,
    RATES,
    RATIO,
    REPORT,
    STATE,
    TARGET,
)
from aftdeck.steering.msteer import msteer
from aftdeck.steering.rehearsal import MAX_STOPPED_TIME, STANDSTILL, rehearse
from aftdeck.steering.rules import rules_of
from tests.each import number
from tests.kinematics.engines import in_pinocchio
from tests.steering.lines import Move, chain_of, clear_moves

ARMS = pytest.mark.parametrize("name", ["srms", "concept-1972"])
PERIOD = 0.02
NEAR, NEAR_TURN = 1e-3, 0.02
"""Greatest final error of mode 3 [m], [deg]."""


@lru_cache
def arm_of(name: str) -> aftdeck.Arm:
    return aftdeck.load_arm(name)


def motion(name: str, start: Array, end: Array, law: int) -> tuple[Array, Array, Array]:
    """Return the arrays with which the steering moves the arm from the joint angles `start` to those at the `end`."""
    arm = arm_of(name)
    goal = arm.forward(end)
    command, state = np.zeros(COMMAND), np.zeros(STATE)
    command[LAW], command[TARGET : TARGET + 3] = law, goal.position
    command[TARGET + 3 : TARGET + 12], command[PLAN : PLAN + 6] = goal.rotation.ravel(), end
    state[ANGLES : ANGLES + 6] = start
    return rules_of(arm.model, arm.model.por_limits(0.0), PERIOD)["OPR CMD", "coarse", law], command, state


def final_error(name: str, move: Move, law: int) -> tuple[float, float, bool]:
    """Return the final error of a motion [m], [deg], and whether the motion ended."""
    arm = arm_of(name)
    rules, command, state = motion(name, move.start, move.end, law)
    goal = arm.forward(move.end)
    arrived = rehearse(rules, command, state, np.zeros(REPORT), 3600.0)
    tip = arm.forward(state[ANGLES : ANGLES + 6])
    turn = angle_between(tip.rotation.tolist(), goal.rotation.tolist())
    return math.dist(tip.position, goal.position), math.degrees(turn), arrived


def reached(name: str, move: Move, law: int) -> bool:
    """Return whether the final error is within its limits, even if a stop blocks the rest of the motion."""
    distance, turn, _ = final_error(name, move, law)
    return distance <= NEAR and turn <= NEAR_TURN


@ARMS
def test_pinocchio_agrees_with_the_arm(name: str) -> None:
    arm = arm_of(name)
    solve = in_pinocchio(chain_of(arm))
    for q in np.random.default_rng(3).uniform(-1.0, 1.0, (20, 6)):
        ours, theirs = arm.forward(q), solve(q)
        assert ours.position == pytest.approx(theirs.position, abs=1e-12)
        assert ours.rotation == pytest.approx(theirs.rotation, abs=1e-12)


def missed_moves(name: str, seed: int, count: int) -> dict[int, list[Move]]:
    """Return, for each steering law, the moves that do not reach their target."""
    moves = clear_moves(arm_of(name), seed, count)
    return {law: [move for move in moves if not reached(name, move, law)] for law in (1, 2, 3)}


@ARMS
def test_modes_1_and_3_reach_every_free_target(name: str) -> None:
    found = missed_moves(name, 1, 30)
    assert found[3] == [] and found[1] == []


@pytest.mark.slow
@ARMS
def test_modes_1_and_3_reach_each_of_many_free_targets(name: str) -> None:
    """The test prints the number of moves that miss their target, for each law."""
    count = number(60, 1000)
    found = missed_moves(name, 2, count)
    print(f"{name}: of {count} moves not reached: { ({law: len(moves) for law, moves in found.items()}) }")
    assert found[3] == [] and found[1] == []


@ARMS
def test_rehearsal_ends_with_the_motion_or_after_two_seconds_at_a_standstill(name: str) -> None:
    """The witness calls the steering once for each control step, and counts the steps at a standstill itself."""
    arm, stopped = arm_of(name), 0
    for seed in range(12):
        rng = np.random.default_rng(seed)
        start, end = rng.uniform(arm.limits.soft[:, 0], arm.limits.soft[:, 1], (2, 6))
        rules, command, state = motion(name, start, end, 1 + seed % 3)
        at, still, report = state.copy(), 0, np.zeros(REPORT)
        given = command.copy()
        for _ in range(200_000):
            if given[MOTION_ACTIVE] == 0.0:
                start_motion(rules, given, at)
            msteer(rules, given, at, report)
            at[ANGLES : ANGLES + 6] += at[RATES : RATES + 6] * PERIOD
            at[MEASURED : MEASURED + 6] = at[RATES : RATES + 6]
            still = still + 1 if report[RATIO] < STANDSTILL else 0
            if report[ARRIVED] or still == round(MAX_STOPPED_TIME / PERIOD):
                break
        stopped += not report[ARRIVED]
        assert rehearse(rules, command, state, np.zeros(REPORT), 3600.0) == bool(report[ARRIVED])
        assert state.tobytes() == at.tobytes()
    assert 0 < stopped < 12
