"""Random straight moves of the kinematic plant in modes 1, 2 and 3.

According to Pinocchio, the lines of these moves stay inside the soft stops and clear of singularities.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache

import numpy as np
import pytest

import aftdeck
from aftdeck.arrays import Array
from aftdeck.bodies.placed import rows_of
from aftdeck.frames import angle_between
from aftdeck.law import load
from aftdeck.steering import rehearsal
from aftdeck.steering.layout import (
    ANGLES,
    COMMAND,
    LAW,
    MOTION_ACTIVE,
    PLAN,
    RATIO,
    REPORT,
    STATE,
    TARGET,
)
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
    turn = angle_between(rows_of(tip.rotation), rows_of(goal.rotation))
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


NONE: dict[int, list[Move]] = {1: [], 2: [], 3: []}
"""Result of `missed_moves` if every move reaches its target."""


@ARMS
def test_automatic_modes_reach_every_free_target(name: str) -> None:
    assert missed_moves(name, 1, 30) == NONE


@pytest.mark.slow
@ARMS
def test_automatic_modes_reach_each_of_many_free_targets(name: str) -> None:
    assert missed_moves(name, 2, number(60, 1000)) == NONE


def shares_left(name: str, move: Move, law: int) -> Array:
    """Return the remaining shares of translation and rotation after each step, (steps, 2), by Pinocchio.

    A move that ends at a soft stop may come to a standstill just before its end.
    """
    rules, command, state = motion(name, move.start, move.end, law)
    report, angles = np.zeros(REPORT), [move.start]
    while not rehearse(rules, command, state, report, PERIOD) and report[RATIO] >= STANDSTILL:
        angles.append(state[ANGLES : ANGLES + 6].copy())
        assert len(angles) * PERIOD < 3600.0
    solve = in_pinocchio(chain_of(arm_of(name)))
    goal, poses = solve(move.end), [solve(q) for q in angles]
    left = np.array(
        [
            (math.dist(pose.position, goal.position), angle_between(rows_of(pose.rotation), rows_of(goal.rotation)))
            for pose in poses
        ]
    )
    return np.asarray(left / left[0])


@ARMS
@pytest.mark.parametrize("law", [2, 3])
def test_line_keeps_translation_and_rotation_in_proportion(name: str, law: int) -> None:
    for move in clear_moves(arm_of(name), 3, number(10, 100)):
        left = shares_left(name, move, law)
        assert left[-1].max() < 1e-3 and np.abs(left[:, 0] - left[:, 1]).max() < 1e-4, move


@pytest.mark.parametrize("moves_again", [False, True])
def test_rehearsal_ends_after_two_seconds_at_a_standstill(moves_again: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """The steering of this test stands still from its sixth step, and may move once after 1.9 s."""
    limit, steps = round(MAX_STOPPED_TIME / PERIOD), 0

    def steering(_rules: Array, _command: Array, _state: Array, report: Array) -> None:
        nonlocal steps
        steps += 1
        report[RATIO] = 1.0 if steps <= 5 or (moves_again and steps == 5 + limit - 5) else 0.0

    load()
    plain: Callable[..., bool] = rehearsal.rehearse.py_func  # type: ignore[attr-defined]
    monkeypatch.setattr(rehearsal, "msteer", steering)
    rules, command, state = motion("srms", np.zeros(6), np.full(6, 0.1), 2)
    command[MOTION_ACTIVE] = 1.0
    assert not plain(rules, command, state, np.zeros(REPORT), 3600.0)
    assert steps == limit + (limit if moves_again else 5)
