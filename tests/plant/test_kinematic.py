"""The kinematic plant does what it is told, exactly."""

from __future__ import annotations

import numpy as np

from aftdeck.plant.kinematic import KinematicPlant
from aftdeck.plant.slide import Slide

FREE = np.array([[-np.inf, np.inf]] * 6)
"""Joints without stops."""


def stand() -> Slide:
    return Slide(3.0, 2.0, 5.0, 0.5)


def test_joints_move_by_their_rates_times_the_period() -> None:
    plant = KinematicPlant(np.zeros(6), np.zeros(6), stand(), FREE)
    plant.move(np.array([0.5, -0.25, 0.0, 1.0, 2.0, -1.0]), 0.25)
    assert plant.angles.tolist() == [0.125, -0.0625, 0.0, 0.25, 0.5, -0.25]
    assert plant.rates.tolist() == [0.5, -0.25, 0.0, 1.0, 2.0, -1.0]


def test_the_plant_keeps_its_own_copy_of_what_it_was_given() -> None:
    angles, commanded = np.zeros(6), np.ones(6)
    plant = KinematicPlant(angles, np.zeros(6), stand(), FREE)
    plant.move(commanded, 1.0)
    commanded[:] = 7.0
    assert angles.tolist() == [0.0] * 6
    assert plant.rates.tolist() == [1.0] * 6


def test_a_restored_plant_goes_on_as_the_saved_one_did() -> None:
    plant = KinematicPlant(np.arange(6.0), np.zeros(6), stand(), FREE)
    plant.move(np.full(6, 0.1), 0.02, stand=1.0)
    saved = plant.save()
    plant.move(np.full(6, 0.3), 0.02, stand=-0.5)
    other = KinematicPlant(np.zeros(6), np.ones(6), stand(), FREE)
    other.restore(saved)
    assert other.save() == saved
    other.move(np.full(6, 0.3), 0.02, stand=-0.5)
    assert other.save() == plant.save()


def test_the_stand_moves_with_the_joints_and_by_itself_stands() -> None:
    plant = KinematicPlant(np.zeros(6), np.zeros(6), stand(), FREE)
    plant.move(np.ones(6), 0.5, stand=1.0)
    assert (plant.stand.position, plant.stand.velocity) == (3.25, 0.5)
    plant.move(np.ones(6), 0.5)
    assert (plant.stand.position, plant.stand.velocity) == (3.25, 0.0)


def test_a_hard_stop_ends_a_joints_motion_and_its_rate_is_the_one_that_it_had() -> None:
    plant = KinematicPlant(np.array([0.0, 0.9, 1.2, 0.0, 0.0, 0.0]), np.zeros(6), stand(), np.array([[-1.0, 1.0]] * 6))
    plant.move(np.array([0.1, 0.4, 0.4, -2.0, 0.0, 0.0]), 0.5)
    assert plant.angles.tolist() == [0.05, 1.0, 1.2, -1.0, 0.0, 0.0]  # a joint that starts past its stop stays there
    assert np.allclose(plant.rates, [0.1, 0.2, 0.0, -2.0, 0.0, 0.0])
    plant.move(np.array([0.0, -0.4, -0.4, 0.0, 0.0, 0.0]), 0.5)
    assert np.allclose(plant.angles, [0.05, 0.8, 1.0, -1.0, 0.0, 0.0])
