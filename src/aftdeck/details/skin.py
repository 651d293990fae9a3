"""Patches on the skin and on the ends of a hull, which leave its fixtures free."""

from __future__ import annotations

from collections.abc import Iterator
from math import inf, pi, tau

import numpy as np

from aftdeck.details.hull import Hull, Strip
from aftdeck.elementary import atan2, sincos
from aftdeck.shapes import Box, Material, Shape, Shell
from aftdeck.tuples import Vec3

CLEAR = 0.06
"""Least distance of a patch from a fixture, along the skin [m] (assumed)."""
SMALLEST = 0.1
"""Least length and width of a patch that is cut out of a larger one [m] (assumed)."""
PROUD = 0.05
"""Greatest distance by which a detail stands out of the skin [m]. Contacts are computed without it (assumed)."""
_NEAR = 0.7
"""A fixture leaves no room on an end if it is less than this distance beyond it [m] (assumed)."""


class Skin:
    """The skin of one hull."""

    def __init__(self, hull: Hull) -> None:
        self.hull = hull
        self._inside = hull.fixtures[:, 0], hull.fixtures[:, 1]

    def strip(self, angle: float) -> Strip:
        """Return the strip that faces a direction, from y towards z [rad]."""
        return min(self.hull.strips, key=lambda strip: abs(_wrapped(strip.angle - angle)))

    def cover(
        self, strip: Strip, x: tuple[float, float], s: tuple[float, float], material: Material, thickness: float = 0.012
    ) -> Iterator[Shape]:
        """Yield patches that together cover a rectangle of a strip, cut out around the fixtures on it.

        Args:
            strip: strip of the hull.
            x: extent along the axis [m].
            s: extent on the skin across the axis, from the middle of the strip, counter-clockwise seen from +x [m].
            material: material of the patches.
            thickness: distance of the patches' outer side from the skin [m].
        """
        blocked = self._blocked(strip, x, s)
        if blocked is None:
            yield self.patch(strip, x, s, material, thickness)
            return
        (low, high), (first, last) = blocked
        between = (max(low, x[0]), min(high, x[1]))
        for part_x, part_s in (
            ((x[0], low), s),
            ((high, x[1]), s),
            (between, (s[0], first)),
            (between, (last, s[1])),
        ):
            if part_x[1] - part_x[0] >= SMALLEST and part_s[1] - part_s[0] >= SMALLEST:
                yield from self.cover(strip, part_x, part_s, material, thickness)

    def patch(
        self, strip: Strip, x: tuple[float, float], s: tuple[float, float], material: Material, thickness: float
    ) -> Shape:
        """Return a patch on a rectangle of a strip, whether or not it is free; arguments as for `cover`."""
        if self.hull.curved:
            radius = self.hull.distance + thickness
            start, sweep = strip.angle + s[0] / self.hull.distance, (s[1] - s[0]) / self.hull.distance
            return Shell(
                material=material,
                position=(0.5 * (x[0] + x[1]), 0.0, 0.0),
                length=x[1] - x[0],
                radius=radius,
                thickness=thickness + 0.01,
                start=start,
                sweep=sweep,
            )
        size = (x[1] - x[0], s[1] - s[0], thickness)
        return self.box(strip, (0.5 * (x[0] + x[1]), 0.5 * (s[0] + s[1]), 0.5 * thickness), size, material)

    def box(self, strip: Strip, middle: Vec3, size: Vec3, material: Material) -> Shape:
        """Return a box on the skin.

        Args:
            strip: strip of the hull.
            middle: x, distance from the middle of the strip on the skin, and height above the skin [m].
            size: edges along the axis, across it, and outwards [m].
            material: material of the box.
        """
        x, s, up = middle
        angle, off = (strip.angle + s / self.hull.distance, 0.0) if self.hull.curved else (strip.angle, s)
        sine, cosine = sincos(angle)
        out = self.hull.distance + up
        return Box(
            material=material,
            position=(x, out * cosine - off * sine, out * sine + off * cosine),
            rotation=(angle - pi / 2, 0.0, 0.0),
            size=size,
        )

    def free(self, strip: Strip, x: tuple[float, float], s: tuple[float, float]) -> bool:
        """Return whether no fixture is on a rectangle of a strip, nor nearer to it than `CLEAR`."""
        return self._blocked(strip, x, s) is None

    def _blocked(
        self, strip: Strip, x: tuple[float, float], s: tuple[float, float]
    ) -> tuple[tuple[float, float], tuple[float, float]] | None:
        """Return the room that a fixture on a rectangle needs, along and across the strip [m]; None if it is free."""
        for low, high in self.hull.fixtures.tolist():
            begin, end = low[0] - CLEAR, high[0] + CLEAR
            if end <= x[0] or begin >= x[1]:
                continue
            outmost, first, last = self._across(strip, low, high)
            if outmost > self.hull.distance - CLEAR and first - CLEAR < s[1] and last + CLEAR > s[0]:
                return (begin, end), (first - CLEAR, last + CLEAR)
        return None

    def _across(self, strip: Strip, low: list[float], high: list[float]) -> tuple[float, float, float]:
        """Return a box's greatest distance from the axis towards a strip, and its extent across the strip [m]."""
        sine, cosine = sincos(strip.angle)
        corners = [(y, z) for y in (low[1], high[1]) for z in (low[2], high[2])]
        if not self.hull.curved:
            across = [z * cosine - y * sine for y, z in corners]
            return max(y * cosine + z * sine for y, z in corners), min(across), max(across)
        if low[1] < 0.0 < high[1] and low[2] < 0.0 < high[2]:  # around the axis
            return float(np.hypot(*np.abs(corners).max(axis=0))), -inf, inf
        turned = [_wrapped(atan2(z, y) - strip.angle) for y, z in corners]
        if max(turned) - min(turned) > pi:  # on the far side
            turned = [angle % tau for angle in turned]
        around = [self.hull.distance * angle for angle in turned]
        return float(np.hypot(*np.abs(corners).max(axis=0))), min(around), max(around)

    def end_is_free(self, side: int, y: float, z: float, radius: float) -> bool:
        """Return whether no fixture is before a disc on an end; `side`: -1 or 1; centre and radius of the disc [m]."""
        face = side * self.hull.ends[side > 0]
        for low, high in self.hull.fixtures.tolist():
            near, far = sorted((side * low[0], side * high[0]))
            if far < face - CLEAR or near > face + _NEAR:
                continue
            off_y, off_z = max(low[1] - y, 0.0, y - high[1]), max(low[2] - z, 0.0, z - high[2])
            if off_y**2 + off_z**2 < (radius + 0.5 * CLEAR) ** 2:
                return False
        return True


def _wrapped(angle: float) -> float:
    """Return an angle within half a turn of zero [rad]."""
    return (angle + pi) % tau - pi
