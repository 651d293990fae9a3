"""Natural frequencies of a flexible arm with its brakes on, linearised about a pose without deflection."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from aftdeck.arms.load import ArmModel
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.plant.multibody.build import arm_spec, attach
from aftdeck.plant.multibody.view import View

RIGID_MODES = 6
"""Modes of frequency zero of an arm on a free orbiter."""


def frequencies(
    arm: ArmModel, angles: ArrayLike, *, payload: MassProperties | None = None, orbiter: MassProperties | None = None
) -> Array:
    """Return the natural frequencies, lowest first [Hz].

    They are the eigenvalues of M and K: M is the mass matrix, K has the stiffness of each spring. The motors, which the
    brakes hold, are struck out.

    Args:
        arm: the arm.
        angles: (n,) joint angles [rad].
        payload: payload at the tip, in frame 7 with the tip as origin; None for none.
        orbiter: the free orbiter, in L; None if the arm's base is fixed.

    Raises:
        ArmError: the arm's file has no table `flexibility`, `servo` or `links`.
    """
    spec = arm_spec(arm, flexible=True, orbiter=orbiter)
    if payload is not None:
        attach(spec, payload)
    view = View(spec.compile(), arm)
    view.set_joints(np.asarray(angles, dtype=np.float64), np.zeros(len(arm.joints)), float(arm.links[0]))
    mujoco.mj_forward(view.model, view.data)
    return natural_frequencies(*matrices(view))[0 if orbiter is None else RIGID_MODES :]


def natural_frequencies(mass: Array, stiffness: Array) -> Array:
    """Return the natural frequencies (n,) of a mass and a stiffness matrix (n, n), lowest first [Hz]."""
    root = np.linalg.inv(np.linalg.cholesky(mass))
    squares = np.linalg.eigvalsh(root @ stiffness @ root.T)  # those of `eigh` lose digits if stiffnesses differ by 1e7
    found: Array = np.sqrt(np.maximum(squares, 0.0)) / (2.0 * np.pi)
    return found


def natural_shapes(mass: Array, stiffness: Array) -> Array:
    """Return the shapes of the natural modes as columns (n, n), lowest frequency first.

    Each has modal mass 1: its product with the mass matrix and itself.
    """
    root = np.linalg.inv(np.linalg.cholesky(mass))
    shapes: Array = root.T @ np.linalg.eigh(root @ stiffness @ root.T)[1]
    return shapes


def matrices(view: View) -> tuple[Array, Array]:
    """Return mass matrix and stiffness matrix at MuJoCo's present pose, without the motors' rows and columns."""
    model, data = view.model, view.data
    mass = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, mass)
    free = np.setdiff1d(np.arange(model.nv), view.motor_rates)
    return mass[np.ix_(free, free)], np.diag(stiffnesses(model)[free])


def stiffnesses(model: Any) -> Array:
    """Return the stiffness of each degree of freedom: the first term of MuJoCo's polynomial."""
    first: Array = model.jnt_stiffness.reshape(model.njnt, -1)[model.dof_jntid, 0]
    return first
