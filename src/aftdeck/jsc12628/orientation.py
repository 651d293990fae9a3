"""ENDORI and ORIEND: the end effector's orientation from Euler angles, and Euler angles from the orientation."""

from __future__ import annotations

from numpy.typing import ArrayLike

from aftdeck import frames
from aftdeck.arrays import Array
from aftdeck.jsc12628.quantities import array
from aftdeck.jsc12628.quantities import rotation as checked


def endori(roll: float, elevation: float, azimuth: float) -> Array:
    """Return the orientation for Euler angles [rad] (JSC-12628, subroutine ENDORI, p. 8).

    Returns:
        (3, 3) the rotated frame's axes as columns: azimuth about 3, then elevation about the new 2, then roll about the
        new 1.

    Raises:
        InputError: an angle is not a finite number; the message names it.
    """
    angles = (("roll", roll), ("elevation", elevation), ("azimuth", azimuth))
    return frames.endori(*(float(array(angle, (), name)) for name, angle in angles))


def oriend(rotation: ArrayLike) -> tuple[float, float, float]:
    """Return roll, elevation and azimuth [rad] of an orientation (JSC-12628, subroutine ORIEND, p. 23).

    Elevation lies in [-pi/2, pi/2]. At elevation +-pi/2 only azimuth -+ roll is determined; roll is then set to 0.

    Args:
        rotation: (3, 3) the orientation.

    Raises:
        InputError: the argument is not a rotation.
    """
    return frames.oriend(checked(rotation, "rotation"))
