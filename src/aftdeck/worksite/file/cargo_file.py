"""A payload in a worksite's file: the dimensions from which its solids and its shapes are made."""

from __future__ import annotations

from aftdeck.arms.body_file import Sides
from aftdeck.shapes import Material, Shape, without_lamps
from aftdeck.units import Angle, AngularRate, Length, Mass, Speed
from aftdeck.worksite.file.mass_file import MassTable
from aftdeck.worksite.tables import Placed, Range, Table, Text, Turn, ordered, positive


class PrismBody(Table, frozen=True, kw_only=True, tag_field="kind", tag="prism"):
    """A regular prism along x with one side on top and one side below; its solids have exactly its shape."""

    sides: Sides = 6
    across: Length
    """Distance between opposite corners."""
    length: Length
    material: Material

    def __post_init__(self) -> None:
        """Reject sizes that are not above zero (ValueError)."""
        positive(across=self.across, length=self.length)


class CylinderBody(Table, frozen=True, kw_only=True, tag_field="kind", tag="cylinder"):
    """A cylinder along x; a prism of twelve sides encloses it for collision."""

    radius: Length
    length: Length
    material: Material

    def __post_init__(self) -> None:
        """Reject sizes that are not above zero (ValueError)."""
        positive(radius=self.radius, length=self.length)


class ProbeFile(Table, frozen=True, kw_only=True):
    """A docking probe, a regular prism on the middle of the forward end (-x)."""

    sides: Sides = 6
    across: Length
    """Distance between opposite corners."""
    length: Length
    material: Material

    def __post_init__(self) -> None:
        """Reject sizes that are not above zero (ValueError)."""
        positive(across=self.across, length=self.length)


class ReceptacleFile(Table, frozen=True, kw_only=True):
    """The bar on the payload's top, which the concept arm's end effector acquires."""

    length: Length
    """Size along x."""
    width: Length
    """Size along y."""
    height: Length
    """Size along z."""
    at: tuple[Length, Length] = (Length(0.0), Length(0.0))
    """x and y of the bar's middle, from the middle of the top."""
    material: Material

    def __post_init__(self) -> None:
        """Reject sizes that are not above zero (ValueError)."""
        positive(length=self.length, width=self.width, height=self.height)


class GrappleFile(Placed, frozen=True, kw_only=True):
    """A grapple fixture.

    Its pose equals the pose of the end effector's own axes E (x outwards) when the fixture is captured without
    misalignment.
    """

    radius: Length
    """Radius of the fixture's base. The base begins at x = 0, at the rim of an end effector that has captured the
    fixture."""
    depth: Length
    """Depth of the fixture's base."""
    shapes: tuple[Shape, ...] = ()
    """Shapes that draw the fixture, in the fixture's axes. Boxes, cylinders, rings and spheres whose positions are not
    on the x axis form the target and collide. Groups only draw marks on the target and do not collide."""
    details: tuple[Shape, ...] = ()
    """Shapes that only decorate the fixture, in its axes. Only the station's page draws them. They cannot be lamps."""

    def __post_init__(self) -> None:
        """Reject sizes that are not above zero, and a lamp among the details (ValueError)."""
        positive(radius=self.radius, depth=self.depth)
        without_lamps(self.details)


class TrunnionsFile(Table, frozen=True, kw_only=True):
    """Pins that the bay's latches hold: pairs of pins on the two sides, and one pin down to the keel."""

    x: tuple[Length, ...]
    """Position of each pair of pins along the payload."""
    y: Length
    """|y| of the points at which the latches hold the pairs of pins."""
    z: Length
    """z of these points."""
    keel: tuple[Length, Length]
    """x and z of the point at which the keel latch holds the keel pin."""
    radius: Length
    span: Range
    """Range of |y| over which the pins extend."""
    keel_span: Range
    """Range of z over which the keel pin extends."""
    material: Material

    def __post_init__(self) -> None:
        """Reject an empty list of pins, sizes that are not above zero, and spans that do not ascend (ValueError)."""
        if not self.x:
            raise ValueError("x lists no pair of trunnions; it needs at least 1")
        positive(radius=self.radius, y=self.y)
        ordered(span=self.span, keel_span=self.keel_span)


class StartFile(Placed, frozen=True, kw_only=True):
    """Start of a payload: in a berth (`seat`), or free at a pose in the scene."""

    seat: Text | None = None
    velocity: tuple[Speed, Speed, Speed] = (Speed(0.0), Speed(0.0), Speed(0.0))
    """Velocity relative to the orbiter, in the scene's axes."""
    rates: tuple[AngularRate, AngularRate, AngularRate] = (AngularRate(0.0), AngularRate(0.0), AngularRate(0.0))
    """Angular rates about the payload's own axes."""

    def __post_init__(self) -> None:
        """Reject a pose or a motion if a berth is given (ValueError)."""
        if self.seat is not None and any(map(any, (self.position, self.rotation, self.velocity, self.rates))):
            raise ValueError(
                f"the cargo starts in the seat {self.seat!r}; only a free cargo can have a position, rotation or motion"
            )


class LimitCycleFile(Table, frozen=True, kw_only=True):
    """Limit cycle of a free payload's attitude control, about each of the payload's own axes."""

    deadband: Turn
    """Greatest angle to either side."""
    rate: tuple[AngularRate, AngularRate, AngularRate]
    """Rate of each angle; its sign gives the initial direction."""
    start: Turn = (Angle(0.0), Angle(0.0), Angle(0.0))
    """Angles at the start."""

    def __post_init__(self) -> None:
        """Reject a deadband that is not above zero, and a start outside the deadband (ValueError)."""
        for axis, deadband, start in zip("xyz", self.deadband, self.start, strict=True):
            positive(**{f"deadband about {axis}": deadband})
            if not abs(start) <= deadband:
                raise ValueError(
                    f"start angle about {axis} is {start:g} rad; it has to be within the deadband, {deadband:g} rad"
                )


class CargoFile(MassTable, frozen=True, kw_only=True):
    """A payload. The origin of its own frame is at its body's centre; the x axis is along the body.

    A scenario refers to the payload by its name.
    """

    name: Text
    title: Text
    source: Text
    mass: Mass
    body: PrismBody | CylinderBody
    shapes: tuple[Shape, ...] = ()
    """Additional shapes that draw the payload."""
    probe: ProbeFile | None = None
    receptacle: ReceptacleFile | None = None
    grapple: GrappleFile | None = None
    trunnions: TrunnionsFile | None = None
    start: StartFile
    limit_cycle: LimitCycleFile | None = None

    def __post_init__(self) -> None:
        """Reject a mass that is not above zero, and a tensor of inertia that no body has (ValueError).

        Reject also a payload that has neither receptacle nor grapple, or has both (ValueError).
        """
        positive(mass=self.mass)
        if why := self.tensor_problem():
            raise ValueError(why)
        if (self.receptacle is None) == (self.grapple is None):
            given = "neither is" if self.receptacle is None else "both are"
            raise ValueError(f"a cargo needs a receptacle or a grapple fixture, not both; {given} given")
