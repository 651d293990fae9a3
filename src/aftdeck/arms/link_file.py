"""Links of an arm file: the rigid or flexible body behind each joint, which a plant with masses needs."""

from __future__ import annotations

from typing import Annotated

from aftdeck.arms.constant import Part, Text
from aftdeck.bounds import Bounds
from aftdeck.units import FlexuralRigidity, Length, Mass, MomentOfInertia

LONGEST = 200.0
"""Greatest plausible length of an arm [m]."""
REAL_LENGTHS = "the Shuttle's arm is 15 m long, Canadarm2 18 m"
Distance = Annotated[Length, Bounds(-LONGEST, LONGEST, REAL_LENGTHS)]
"""Coordinate on an arm."""
Place = tuple[Distance, Distance, Distance]
LinkMass = Annotated[Mass, Bounds(1e-6, 1e5, "the Shuttle's whole arm has 410 kg")]
Radius = Annotated[Length, Bounds(0.0005, 10.0, "the Shuttle's booms have a radius of 0.19 m")]
LinkInertia = Annotated[MomentOfInertia, Bounds(1e-9, 1e7, "the Shuttle's booms have about 1000 kg m2")]
BeamRigidity = Annotated[
    FlexuralRigidity, Bounds(1e-3, 1e12, "the Shuttle's booms have about 4e6 N m2, a steel rod of 1 cm 100")
]
"""Rigidity of a boom: EI for bending, GJ for torsion."""


class _LinkFile(Part, frozen=True, kw_only=True, tag_field="kind"):
    """Fields of every link. Vectors are in the frame of the joint at which the link begins; the foot's, in L."""

    mass: LinkMass


class BodyLink(_LinkFile, frozen=True, kw_only=True, tag="body"):
    """Link with a centre of mass and moments of inertia."""

    centre: Place
    inertia: tuple[LinkInertia, LinkInertia, LinkInertia]
    """Moments of inertia about the centre of mass, along the axes of the frame."""


class BoxLink(_LinkFile, frozen=True, kw_only=True, tag="box"):
    """Uniform box with edges along the axes of the frame."""

    low: Place
    """Corner with the least coordinates."""
    high: Place
    """Corner with the greatest coordinates."""


class RodLink(_LinkFile, frozen=True, kw_only=True, tag="rod"):
    """Link in the plane of x and z, made of a uniform rod and of housings at its ends; `arms.links` has the rule."""

    part: Text
    """Name of the link, such as ``upper_boom``."""
    moments: tuple[LinkInertia, LinkInertia, LinkInertia]
    """Moments of inertia about the point at which the link begins: along the link, about the frame's y, across both."""
    centre: Annotated[Length, Bounds(0.0, LONGEST, "the Shuttle's booms are 7 m long")] | None = None
    """Distance of the centre of mass from this point; without it, `arms.links` has the rule."""
    span: tuple[Place, Place] | None = None
    """Points at which the link begins and ends; without them, its joint and the next one, or the tip."""
    radius: Radius | None = None
    """Radius of the uniform cylinder that represents a boom, which bends on a flexible arm; none for a stiff link."""
    bending: BeamRigidity | None = None
    """EI of a boom, equal in both planes."""
    torsion: BeamRigidity | None = None
    """GJ of a boom."""


LinkFile = BodyLink | BoxLink | RodLink
