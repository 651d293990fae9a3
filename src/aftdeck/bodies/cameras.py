"""Camera definitions: where a camera stands, where it looks, how wide."""

from __future__ import annotations

from math import hypot, pi

import msgspec

Vec3 = tuple[float, float, float]


class Camera(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A television camera fixed to a body.

    Not modelled yet: pan, tilt and zoom drives; the fields give the fixed setting.
    """

    name: str
    """Short name on the selector: ``B``."""
    title: str
    """``Aft bulkhead port``."""
    body: str
    """Name of the body that carries it."""
    position: Vec3
    """Lens, in the body's frame [m]."""
    boresight: Vec3
    """Direction of view in the body's frame (any length above zero)."""
    up: Vec3
    """Direction in the body's frame that is up in the picture, not along the boresight."""
    field_of_view: float
    """Horizontal field of view [rad]."""

    def __post_init__(self) -> None:
        """Refuse a camera that can make no picture (ValueError)."""
        if not 0.0 < self.field_of_view < pi:
            raise ValueError(
                f"camera {self.name}'s field_of_view is {self.field_of_view:g}; it has to be between 0 and pi"
            )
        bx, by, bz = self.boresight
        ux, uy, uz = self.up
        across = hypot(by * uz - bz * uy, bz * ux - bx * uz, bx * uy - by * ux)
        if across <= 1e-9 * hypot(bx, by, bz) * hypot(ux, uy, uz):
            raise ValueError(f"camera {self.name}'s boresight and up have to be two different directions")
