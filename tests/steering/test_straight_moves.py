"""Random straight moves of the kinematic plant in modes 1, 2 and 3.

According to Pinocchio, the lines of these moves stay inside the soft stops and clear of singularities.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import pytest

import aftdeck
from aftdeck.frames import angle_between
from aftdeck.steering.layout import (
    ANGLES,
    COMMAND,
    LAW,
    PLAN,
    REPORT,
    STATE,
    TARGET,
)
from aftdeck.steering.rehearsal import rehearse
from aftdeck.steering.rules import rules_of
from tests.each import number
from tests.kinematics.engines import in_pinocchio
from tests.steering.lines import Move, chain_of, clear_moves

ARMS = pytest.mark.parametrize("name", ["srms", "concept-1972"])
NEAR, NEAR_TURN = 1e-3, 0.02
"""Greatest final error of mode 3 [m], [deg]."""


@lru_cache
def arm_of(name: str) -> aftdeck.Arm:
    return aftdeck.load_arm(name)


def final_error(name: str, move: Move, law: int) -> tuple[float, float, bool]:
    """Return the final error of a motion [m], [deg], and whether the motion ended."""
    arm = arm_of(name)
    rules = rules_of(arm.model, arm.model.por_limits(0.0), 0.02)["OPR CMD", "coarse", law]
    goal = arm.forward(move.end)
    command, state = np.zeros(COMMAND), np.zeros(STATE)
    command[LAW], command[TARGET : TARGET + 3] = law, goal.position
    command[TARGET + 3 : TARGET + 12], command[PLAN : PLAN + 6] = goal.rotation.ravel(), move.end
    state[ANGLES : ANGLES + 6] = move.start
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
