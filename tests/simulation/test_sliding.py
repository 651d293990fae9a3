"""Sliding of a payload along the walls of the bay (section VII.4 of the report).

Sticks act along the orbiter's axes (forward, starboard, down); positions are in R (aft, port, down).
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import aftdeck
from aftdeck import Inputs
from aftdeck.simulation.frame import Frame
from tests.simulation.concept import FOOT, ON_BAR, held_for, scenario, vec3
from tests.simulation.flights import flown
from tests.simulation.payload_invariants import check_possession

seeds = st.integers(0, 2**32 - 1)
TOUCH = 1e-9
"""Greatest clearance of a contact, and greatest depth of a sliding payload in a wall [m]."""
WALLS = {"bay wall port", "bay wall starboard", "bay floor"}


def wall_contacts(frame: Frame) -> dict[str, float]:
    """Return the walls in contact with the payload, and the clearance to each of them [m]."""
    return {c.b: c.clearance for c in frame.work.contacts if c.a.startswith("payload") and c.b in WALLS}


def check_slides(frames: list[Frame]) -> None:
    """Check that the payload penetrates no wall, that the arm is not inhibited, and that the contacts are essential."""
    for frame in frames:
        assert all(clearance >= -TOUCH for clearance in wall_contacts(frame).values()), frame.time_s
        assert not frame.work.arm_inhibit
        assert all(c.essential for c in frame.work.contacts if c.b in WALLS)


@pytest.mark.parametrize(("side", "wall"), [(1.0, "bay wall port"), (-1.0, "bay wall starboard")])
def test_payload_slides_up_along_a_side_wall(side: float, wall: str) -> None:
    made = scenario((ON_BAR[0], side * 0.9, ON_BAR[2]), held=True)
    sim = aftdeck.Simulation(made)
    frames = flown(sim, held_for(400, Inputs((0.0, -0.3 * side, 0.0), rate="coarse")))
    check_slides(frames)
    assert wall in wall_contacts(frames[-1])
    still = frames[-1].position
    frames = flown(sim, held_for(250, Inputs((0.0, -0.3 * side, -0.4))))
    check_slides(frames)
    check_possession(made, frames)
    assert all(wall in wall_contacts(frame) for frame in frames)
    speed = (frames[-2].position[2] - frames[-1].position[2]) / 0.02
    assert speed == pytest.approx(0.4 * 2.0 * FOOT, abs=1e-3) and still[2] - frames[-1].position[2] > 0.9
    assert frames[-1].position[1] == pytest.approx(still[1], abs=1e-6)
    leaving = flown(sim, held_for(100, Inputs((0.0, 0.3 * side, 0.0))))
    assert not wall_contacts(leaving[-1])


@settings(max_examples=3)
@given(seeds)
def test_sliding_payload_never_penetrates_a_wall(seed: int) -> None:
    rng = np.random.default_rng(seed)
    made = scenario(vec3(np.add(ON_BAR, [0.0, 0.95 * rng.choice([-1.0, 1.0]), 0.7])), held=True)
    pushes = []
    for _ in range(8):
        turn, stand = 0.4 * rng.uniform(-1.0, 1.0, 3), float(rng.choice([-1.0, 0.0, 1.0]))
        pushes.append(Inputs(vec3(rng.uniform(-1.0, 1.0, 3)), vec3(turn), telescope=stand))
    frames = flown(made, [push for push in pushes for _ in range(35)])
    check_slides(frames)
    check_possession(made, frames)
    assume(any(wall_contacts(frame) for frame in frames))  # a few seeds never reach a wall


def test_sliding_removes_only_velocity_into_the_wall() -> None:
    made = scenario((ON_BAR[0], 1.0, ON_BAR[2]), held=True)
    sim = aftdeck.Simulation(made)
    flown(sim, held_for(300, Inputs((0.0, -0.3, 0.0))))
    for along in (Inputs((0.3, -0.3, 0.0)), Inputs((-0.3, 0.0, -0.3))):
        frames = flown(sim, held_for(150, along))
        check_slides(frames)
        velocity = np.subtract(frames[-1].position, frames[-2].position) / 0.02
        expected = np.array(along.translation) * [-1.0, 0.0, 1.0] * 2.0 * FOOT  # forward, starboard, down
        assert velocity == pytest.approx(expected, abs=2e-3)


@pytest.mark.parametrize("mode", ["SINGLE", "DIRECT"])
def test_wall_contact_inhibits_in_single_joint_modes(mode: str) -> None:
    made = scenario((ON_BAR[0], 0.9, ON_BAR[2]), held=True)
    sim = aftdeck.Simulation(made)
    flown(sim, held_for(300, Inputs((0.0, -0.3, 0.0))))
    frames = flown(sim, [Inputs(mode=mode, joint=0, drive=0.2), *held_for(60, Inputs(drive=0.2))])
    assert frames[-1].work.arm_inhibit
    depths = [min(wall_contacts(frame).values()) for frame in frames if wall_contacts(frame)]
    assert all(b >= a - TOUCH for a, b in list(pairwise(depths))[3:])
    back = flown(sim, held_for(300, Inputs((0.0, 0.1, 0.0), mode="ORB UNL")))
    assert not back[-1].work.arm_inhibit and not wall_contacts(back[-1])
