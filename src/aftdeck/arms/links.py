"""Links of an arm that are rods with housings, as rigid bodies, from their masses and moments of inertia.

The file gives a link's mass, and its moments about the joint at which it begins. Without a centre of mass, the link is
taken as a uniform rod from this joint to the next, and a housing at this joint. The housing's moment along the link is
the mean of its moments across it: this gives the mass of the rod, and with it the centre of mass. If the file gives the
centre of mass too, a boom also has a housing at its end, as a point.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from aftdeck.arms.geometry import FOOT, frame_of
from aftdeck.arms.joints import Slide
from aftdeck.arms.link_file import LinkFile, Place, RodLink
from aftdeck.arms.model import ArmFile
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties, about, cylinder, impossible, joined
from aftdeck.files import Problem, Where

_ROUNDED = 1e-3
"""Share of a link's mass by which a housing may be lighter than nothing, because the file's numbers are rounded [1]."""


class Shares(NamedTuple):
    """Parts of a boom.

    Attributes:
        rod: mass of the uniform cylinder between the joints [kg].
        beginning: the housing at the beginning, in the link's frame.
        tip: the housing at the end, whose coordinates begin there.
    """

    rod: float
    beginning: MassProperties
    tip: MassProperties


@dataclass(frozen=True)
class Link:
    """One link.

    Attributes:
        name: name of the link, such as ``upper_boom``.
        begin: (3,) place of the joint at which the link begins, in the link's frame [m].
        end: (3,) place of the next joint, or of the tip [m].
        mass: mass [kg].
        moments: (3,) moments of inertia about the joint: along the link, about the pitch axis, across both [kg m2].
        centre: distance of the centre of mass from the joint [m]; None if the file does not give it.
        radius: radius of the rod [m]; 0 for a stiff link.
    """

    name: str
    begin: Array
    end: Array
    mass: float
    moments: Array
    centre: float | None
    radius: float

    @property
    def bends(self) -> bool:
        """Whether the link is a boom, which bends on a flexible arm."""
        return self.radius > 0.0

    def whole(self) -> MassProperties:
        """Return the link as one rigid body, in the link's frame."""
        centre = self.begin + self._distance * self._axes[:, 0]
        return MassProperties(self.mass, centre, self._inertia - about(self.mass, centre - self.begin))

    def shares(self) -> Shares:
        """Return the uniform rod and the housings of which the link consists. The tip's housing is a point."""
        length, rod = self._length, self._rod
        end = 0.0 if self.centre is None else self.mass * self.centre / length - 0.5 * rod
        tip = MassProperties(end, np.zeros(3), np.zeros((3, 3)))
        others = joined(
            [cylinder(rod, self.radius, np.zeros(3), self.end - self.begin), tip.moved(self.end - self.begin)]
        )
        left = self._inertia - others.inertia - about(others.mass, others.centre)
        return Shares(rod, MassProperties(self.mass - rod - end, self.begin, left), tip)

    def problems(self) -> Iterator[str]:
        """Yield why no body has these values."""
        if not self._length or self.begin[1] != self.end[1]:
            yield f"{self.name}: a rod needs a length, and lies in the plane of x and z of its frame"
        elif why := impossible(self.whole().inertia):
            yield f"{self.name}: with the centre of mass {self._distance:.4g} m from its joint, {why}"
        elif self.bends:
            shares = self.shares()
            parts = {"rod": shares.rod, "housing": shares.beginning.mass, "housing at the end": shares.tip.mass}
            for part, mass in parts.items():
                if mass < -_ROUNDED * self.mass:
                    given = f"{self.mass:g} kg and the moments {self._given}"
                    yield f"{self.name}: with {given}, the {part} would have {mass:.4g} kg"

    @property
    def _given(self) -> str:
        return ", ".join(f"{moment:g}" for moment in self.moments) + " kg m2"

    @property
    def _length(self) -> float:
        return float(np.linalg.norm(self.end - self.begin))

    @property
    def _axes(self) -> Array:
        """Axes of the moments, as columns."""
        along = (self.end - self.begin) / self._length
        pitch = np.array([0.0, 1.0, 0.0])
        return np.stack([along, pitch, np.cross(along, pitch)], axis=1)

    @property
    def _inertia(self) -> Array:
        """Inertia about the joint, along the axes of the link's frame."""
        found: Array = self._axes @ np.diag(self.moments) @ self._axes.T
        return found

    @property
    def _rod(self) -> float:
        """Mass of the uniform rod [kg]. Housings, as points or spheres, add equally to the moments along and across."""
        length = self._length
        along, across = float(self.moments[0]), float(np.mean(self.moments[1:]))
        unit = length**2 / 3.0 - 0.25 * self.radius**2
        if self.centre is None:
            return max(across - along, 0.0) / unit
        return (self.mass * self.centre * length - across + along) / (0.5 * length**2 - unit)

    @property
    def _distance(self) -> float:
        """Distance of the centre of mass from the joint [m]."""
        return 0.5 * self._length * self._rod / self.mass if self.centre is None else self.centre


def rods_of(file: ArmFile) -> Iterator[tuple[Where, str, Link]]:
    """Yield the links that are rods: the place of each in the file, the frame that carries it, and the link."""
    ends = [*(np.array(joint.step, dtype=np.float64) for joint in file.steered[1:]), np.array(file.tip.value)]
    links: list[tuple[Where, str, LinkFile | None, Array]] = [(("foot",), FOOT, file.foot, np.zeros(3))]
    links += [
        (("joint", file.joint.index(joint), "link"), frame_of(joint.name), joint.link, end)
        for joint, end in zip(file.steered, ends, strict=True)
    ]
    for where, frame, link, end in links:
        if isinstance(link, RodLink):
            begin, until = (np.zeros(3), end) if link.span is None else map(_point, link.span)
            centre = None if link.centre is None else float(link.centre)
            radius, moments = float(link.radius or 0.0), np.array(link.moments, dtype=np.float64)
            yield where, frame, Link(link.part, begin, until, float(link.mass), moments, centre, radius)


def rod_problems(file: ArmFile) -> list[Problem]:
    """Return a problem for each rod that no body can be, or that is where none can be."""
    found, booms = [], ["base"]
    for where, _, link in rods_of(file):
        found += [Problem((*where, "moments"), why) for why in link.problems()]
        if link.bends and link.name in booms:
            found.append(
                Problem((*where, "part"), f"parts that bend need different names, also from 'base': {link.name!r}")
            )
        booms += [link.name] if link.bends else []
    if isinstance(file.foot, RodLink) and file.foot.radius is not None:
        found.append(Problem(("foot", "radius"), "only links behind joints that turn can bend"))
    for i, joint in enumerate(file.joint):
        if isinstance(joint, Slide) and isinstance(joint.link, RodLink):
            found.append(Problem(("joint", i, "link", "kind"), "only links behind joints that turn can be rods"))
    return found


def _point(place: Place) -> Array:
    return np.array(place, dtype=np.float64)
