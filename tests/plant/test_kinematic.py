"""Kinematic plant: joints and telescope follow their commands exactly."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.pose import HERE
from aftdeck.plant.kinematic import KinematicPlant
from aftdeck.plant.linear_actuator import Slide, Travel
from aftdeck.plant.plant import Surroundings
from aftdeck.plant.state import PlantState

FREE = np.array([[-np.inf, np.inf]] * 6)
"""Joints without stops."""


TRAVEL = Travel(2.0, 5.0, 0.5)


def start(*angles: float) -> PlantState:
    at = np.array(angles or (0.0,) * 6)
    return PlantState(at, np.zeros(6), at.copy(), Slide(3.0), np.array(HERE))


def move(state: PlantState, rates: Array, period: float, drive: float = 0.0, stops: Array = FREE) -> None:
    KinematicPlant(stops, TRAVEL, period).move(
        state, rates, drive, Surroundings(), brakes=False, attached=0, by_angle=False
    )


def test_joints_move_by_rate_times_period() -> None:
    moved = start()
    move(moved, np.array([0.5, -0.25, 0.0, 1.0, 2.0, -1.0]), 0.25)
    assert moved.angles.tolist() == [0.125, -0.0625, 0.0, 0.25, 0.5, -0.25]
    assert moved.rates.tolist() == [0.5, -0.25, 0.0, 1.0, 2.0, -1.0]


def test_plant_copies_the_commanded_rates() -> None:
    moved, asked = start(), np.ones(6)
    move(moved, asked, 1.0)
    asked[:] = 7.0
    assert moved.rates.tolist() == [1.0] * 6


def test_telescope_moves_only_with_its_drive() -> None:
    moved = start()
    move(moved, np.ones(6), 0.5, drive=1.0)
    assert (moved.stand.position, moved.stand.velocity) == (3.25, 0.5)
    move(moved, np.ones(6), 0.5)
    assert (moved.stand.position, moved.stand.velocity) == (3.25, 0.0)


def test_hard_stop_limits_motion_and_actual_rate() -> None:
    moved, stops = start(0.0, 0.9, 1.2, 0.0, 0.0, 0.0), np.array([[-1.0, 1.0]] * 6)
    move(moved, np.array([0.1, 0.4, 0.4, -2.0, 0.0, 0.0]), 0.5, stops=stops)
    assert moved.angles.tolist() == [0.05, 1.0, 1.2, -1.0, 0.0, 0.0]  # a joint that starts past its stop stays there
    assert np.allclose(moved.rates, [0.1, 0.2, 0.0, -2.0, 0.0, 0.0])
    move(moved, np.array([0.0, -0.4, -0.4, 0.0, 0.0, 0.0]), 0.5, stops=stops)
    assert np.allclose(moved.angles, [0.05, 0.8, 1.0, -1.0, 0.0, 0.0])
