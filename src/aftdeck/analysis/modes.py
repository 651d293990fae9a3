"""Natural modes of a flexible arm with its brakes on: frequencies, damping and shapes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from aftdeck.arrays import Array
from aftdeck.plant.multibody.frequencies import matrices, natural_frequencies, natural_shapes
from aftdeck.plant.multibody.view import View


class Modes(NamedTuple):
    """Natural modes of a flexible arm about an unbent pose, lowest first. The brakes hold the motors.

    Without friction: that of the gearboxes depends on the amplitude (docs/dynamics.md).

    Attributes:
        frequencies: (m,) undamped natural frequencies [Hz].
        damping: (m,) damping ratios by the dampers of the springs [1].
        shapes: (m, n) displacement of each coordinate [rad or m], of modal mass 1.
        tip: (m, 6) displacement of the tip [m], then its rotation [rad], of the same shapes, relative to L.
    """

    frequencies: Array
    damping: Array
    shapes: Array
    tip: Array


def modes_of(view: View, damping: Array, jacobian: Array, drifting: int) -> Modes:
    """Return the natural modes at MuJoCo's present pose.

    Args:
        view: the flexible model, after `mj_forward`.
        damping: (n,) damping of each coordinate [N m s/rad].
        jacobian: (6, n) motion of the tip relative to L: displacement, then rotation.
        drifting: number of the modes of frequency zero, which are left out.
    """
    equations = matrices(view)
    frequencies, columns = natural_frequencies(*equations)[drifting:], natural_shapes(*equations)[:, drifting:]
    free = np.setdiff1d(np.arange(view.model.nv), view.motor_rates)
    shapes = np.zeros((len(frequencies), view.model.nv))
    shapes[:, free] = columns.T
    largest = np.take_along_axis(shapes, np.abs(shapes).argmax(axis=1)[:, None], axis=1)
    shapes *= np.sign(largest)
    ratios = (shapes**2 @ damping) / (4.0 * np.pi * frequencies)
    return Modes(frequencies, ratios, shapes, shapes @ jacobian.T)
