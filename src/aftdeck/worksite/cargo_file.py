"""A cargo as a worksite's file describes it: the dimensions that its solids and its look are made from."""

from __future__ import annotations

from aftdeck.shapes import Material, Shape
from aftdeck.units import Angle, AngularRate, Length, Mass, Speed
from aftdeck.worksite.tables import Placed, Range, Table, Text, Turn, ordered, positive


class PrismBody(Table, frozen=True, kw_only=True, tag_field="kind", tag="prism"):
    """A regular prism along x with two of its sides up and down, covered exactly."""

    sides: int = 6
    across: Length
    """Across corners."""
    length: Length
    material: Material

    def __post_init__(self) -> None:
        """Refuse sizes that are not above zero (ValueError)."""
        positive(across=self.across, length=self.length)


class CylinderBody(Table, frozen=True, kw_only=True, tag_field="kind", tag="cylinder"):
    """A cylinder along x, covered from outside by a prism of twelve sides."""

    radius: Length
    length: Length
    material: Material

    def __post_init__(self) -> None:
        """Refuse sizes that are not above zero (ValueError)."""
        positive(radius=self.radius, length=self.length)


class ProbeFile(Table, frozen=True, kw_only=True):
    """A docking probe, a regular prism on the middle of the forward end (-x)."""

    sides: int = 6
    across: Length
    """Across corners."""
    length: Length
    material: Material

    def __post_init__(self) -> None:
        """Refuse sizes that are not above zero (ValueError)."""
        positive(across=self.across, length=self.length)


class ReceptacleFile(Table, frozen=True, kw_only=True):
    """The bar that the concept's hand grips, on the cargo's top."""

    length: Length
    """Along x."""
    width: Length
    """Along y."""
    height: Length
    """Along z."""
    at: tuple[Length, Length] = (Length(0.0), Length(0.0))
    """x and y of its middle, from the middle of the top."""
    material: Material

    def __post_init__(self) -> None:
        """Refuse sizes that are not above zero (ValueError)."""
        positive(length=self.length, width=self.width, height=self.height)


class GrappleFile(Placed, frozen=True, kw_only=True):
    """A grapple fixture: its place is that of the end effector's own axes E (x out of the hand) at a perfect grasp."""

    radius: Length
    """Of its base, which begins where the end effector's rim ends."""
    depth: Length
    """Of its base."""
    shapes: tuple[Shape, ...] = ()
    """What it looks like, in the fixture's axes. Boxes, cylinders, rings and spheres listed beside its axis are its
    target and collide, groups of marks on them do not."""

    def __post_init__(self) -> None:
        """Refuse sizes that are not above zero (ValueError)."""
        positive(radius=self.radius, depth=self.depth)


class TrunnionsFile(Table, frozen=True, kw_only=True):
    """Pins to either side, and one down to the keel, that the bay's latches hold."""

    x: tuple[Length, ...]
    """Where along the cargo there is a pair of them."""
    y: Length
    """Of the points on them that the latches hold, on either side."""
    z: Length
    keel: tuple[Length, Length]
    """x and z of the point on the keel pin that its latch holds."""
    radius: Length
    span: Range
    """Of |y|: from where to where the pins go."""
    keel_span: Range
    """Of z, upwards."""
    material: Material

    def __post_init__(self) -> None:
        """Refuse no pins, and pins that are none (ValueError)."""
        if not self.x:
            raise ValueError("x lists no pair of trunnions; it needs at least 1")
        positive(radius=self.radius, y=self.y)
        ordered(span=self.span, keel_span=self.keel_span)


class StartFile(Placed, frozen=True, kw_only=True):
    """Where a cargo is at the start: in a seat, or free, at a pose in the scene."""

    seat: Text | None = None
    velocity: tuple[Speed, Speed, Speed] = (Speed(0.0), Speed(0.0), Speed(0.0))
    """In the scene's axes, against the orbiter."""
    rates: tuple[AngularRate, AngularRate, AngularRate] = (AngularRate(0.0), AngularRate(0.0), AngularRate(0.0))
    """About the cargo's own axes."""

    def __post_init__(self) -> None:
        """Refuse a pose or a motion in a seat (ValueError)."""
        if self.seat is not None and any(map(any, (self.position, self.rotation, self.velocity, self.rates))):
            raise ValueError(f"it stands in the seat {self.seat!r}; a position, rotation or motion is for a free cargo")


class LimitCycleFile(Table, frozen=True, kw_only=True):
    """How a free cargo's attitude control wanders about its attitude, about each of its own axes."""

    deadband: Turn
    """To either side."""
    rate: tuple[AngularRate, AngularRate, AngularRate]
    """How fast each angle changes; its sign is the way it sets out."""
    start: Turn = (Angle(0.0), Angle(0.0), Angle(0.0))
    """Each angle at the start."""

    def __post_init__(self) -> None:
        """Refuse a deadband that is not above zero, and a start outside of it (ValueError)."""
        for axis, deadband, start in zip("xyz", self.deadband, self.start, strict=True):
            positive(**{f"deadband about {axis}": deadband})
            if not abs(start) <= deadband:
                raise ValueError(
                    f"start about {axis} is {start:g} rad; it has to lie within the deadband, {deadband:g}"
                )


class CargoFile(Table, frozen=True, kw_only=True):
    """Something that the arm can hold; its own frame is at its body's centre, x along it. A scenario names it."""

    name: Text
    title: Text
    source: Text
    mass: Mass
    body: PrismBody | CylinderBody
    shapes: tuple[Shape, ...] = ()
    """What more it looks like."""
    probe: ProbeFile | None = None
    receptacle: ReceptacleFile | None = None
    grapple: GrappleFile | None = None
    trunnions: TrunnionsFile | None = None
    start: StartFile
    limit_cycle: LimitCycleFile | None = None

    def __post_init__(self) -> None:
        """Refuse no mass, and no way or two ways to be held (ValueError)."""
        positive(mass=self.mass)
        if (self.receptacle is None) == (self.grapple is None):
            given = "neither" if self.receptacle is None else "both"
            raise ValueError(f"a cargo is held by a receptacle or by a grapple fixture; {given} is given")
