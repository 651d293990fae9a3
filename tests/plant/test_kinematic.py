"""The kinematic plant does what it is told, exactly."""

from __future__ import annotations

import numpy as np

from aftdeck.plant.kinematic import KinematicPlant
from aftdeck.plant.slide import Slide


def stand() -> Slide:
    return Slide(3.0, 2.0, 5.0, 0.5)


def test_joints_move_by_their_rates_times_the_period() -> None:
    plant = KinematicPlant(np.zeros(6), np.zeros(6), stand())
    plant.move(np.array([0.5, -0.25, 0.0, 1.0, 2.0, -1.0]), 0.25)
    assert plant.angles.tolist() == [0.125, -0.0625, 0.0, 0.25, 0.5, -0.25]
    assert plant.rates.tolist() == [0.5, -0.25, 0.0, 1.0, 2.0, -1.0]


def test_the_plant_keeps_its_own_copy_of_what_it_was_given() -> None:
    angles, commanded = np.zeros(6), np.ones(6)
    plant = KinematicPlant(angles, np.zeros(6), stand())
    plant.move(commanded, 1.0)
    commanded[:] = 7.0
    assert angles.tolist() == [0.0] * 6
    assert plant.rates.tolist() == [1.0] * 6


def test_a_restored_plant_goes_on_as_the_saved_one_did() -> None:
    plant = KinematicPlant(np.arange(6.0), np.zeros(6), stand())
    plant.move(np.full(6, 0.1), 0.02, stand=1.0)
    saved = plant.save()
    plant.move(np.full(6, 0.3), 0.02, stand=-0.5)
    other = KinematicPlant(np.zeros(6), np.ones(6), stand())
    other.restore(saved)
    assert other.save() == saved
    other.move(np.full(6, 0.3), 0.02, stand=-0.5)
    assert other.save() == plant.save()


def test_the_stand_moves_with_the_joints_and_by_itself_stands() -> None:
    plant = KinematicPlant(np.zeros(6), np.zeros(6), stand())
    plant.move(np.ones(6), 0.5, stand=1.0)
    assert (plant.stand.position, plant.stand.velocity) == (3.25, 0.5)
    plant.move(np.ones(6), 0.5)
    assert (plant.stand.position, plant.stand.velocity) == (3.25, 0.0)
