"""Kinematic plant: joints and telescope follow their commands exactly."""

from __future__ import annotations

import numpy as np

from aftdeck.plant.kinematic import KinematicPlant
from aftdeck.plant.linear_actuator import Slide, Travel

FREE = np.array([[-np.inf, np.inf]] * 6)
"""Joints without stops."""


TRAVEL = Travel(2.0, 5.0, 0.5)


def plant(*angles: float) -> KinematicPlant:
    at = np.array(angles or (0.0,) * 6)
    return KinematicPlant(at, np.zeros(6), at.copy(), Slide(3.0))


def test_joints_move_by_rate_times_period() -> None:
    moved = plant()
    moved.move(FREE, TRAVEL, np.array([0.5, -0.25, 0.0, 1.0, 2.0, -1.0]), 0.25)
    assert moved.angles.tolist() == [0.125, -0.0625, 0.0, 0.25, 0.5, -0.25]
    assert moved.rates.tolist() == [0.5, -0.25, 0.0, 1.0, 2.0, -1.0]


def test_plant_copies_the_commanded_rates() -> None:
    moved, asked = plant(), np.ones(6)
    moved.move(FREE, TRAVEL, asked, 1.0)
    asked[:] = 7.0
    assert moved.rates.tolist() == [1.0] * 6


def test_telescope_moves_only_with_its_drive() -> None:
    moved = plant()
    moved.move(FREE, TRAVEL, np.ones(6), 0.5, drive=1.0)
    assert (moved.stand.position, moved.stand.velocity) == (3.25, 0.5)
    moved.move(FREE, TRAVEL, np.ones(6), 0.5)
    assert (moved.stand.position, moved.stand.velocity) == (3.25, 0.0)


def test_hard_stop_limits_motion_and_actual_rate() -> None:
    moved, stops = plant(0.0, 0.9, 1.2, 0.0, 0.0, 0.0), np.array([[-1.0, 1.0]] * 6)
    moved.move(stops, TRAVEL, np.array([0.1, 0.4, 0.4, -2.0, 0.0, 0.0]), 0.5)
    assert moved.angles.tolist() == [0.05, 1.0, 1.2, -1.0, 0.0, 0.0]  # a joint that starts past its stop stays there
    assert np.allclose(moved.rates, [0.1, 0.2, 0.0, -2.0, 0.0, 0.0])
    moved.move(stops, TRAVEL, np.array([0.0, -0.4, -0.4, 0.0, 0.0, 0.0]), 0.5)
    assert np.allclose(moved.angles, [0.05, 0.8, 1.0, -1.0, 0.0, 0.0])
