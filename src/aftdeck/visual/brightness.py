"""Brightness of faces in a light, and the greys of the look of 1972."""

from __future__ import annotations

import numpy as np

from aftdeck.arrays import Array
from aftdeck.matrices import lengths
from aftdeck.scenario.light import LightCondition

GREYS = 8
"""Number of greys of the look of 1972 (assumed: the scene generator's number of levels is not legible)."""
GAMMA = 2.2
"""Exponent between a displayed value and its light."""
_FULL = 4.1
"""Illuminance of full sunlight, in the units of `light.toml`."""


def brightness(normal: Array, light: LightCondition) -> Array:
    """Return the light (Q,) on faces with normals (Q, 3) in the scene, without shadows; 1 is full sunlight."""
    sun, earth = (np.array(to) / lengths(np.array(to)) for to in (light.to_sun, light.nadir))
    bright = light.sun.strength * np.maximum(normal @ sun, 0.0) + light.earthshine.strength * np.maximum(
        normal @ earth, 0.0
    )
    return np.asarray((bright + light.sky.strength) * 2.0**light.exposure / _FULL)


def luminance(colours: Array) -> Array:
    """Return the luminance (F,), 0 to 1, of sRGB colours (F, 3)."""
    return np.asarray(colours @ [0.30, 0.59, 0.11])


def grey_levels(own: Array, bright: Array) -> Array:
    """Return the displayed grey (Q,), 0 to 1, of faces in the look of 1972.

    Args:
        own: (Q,) luminance of the faces' colours.
        bright: (Q,) light on the faces.
    """
    grey = own * np.minimum(bright, 1.0) ** (1.0 / GAMMA)
    return np.asarray(np.ceil(grey * GREYS) / GREYS)
