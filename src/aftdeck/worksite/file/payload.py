"""Construction of a payload from the dimensions in its file: shapes and solids are made from the same numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import pi
from typing import NamedTuple

import numpy as np

from aftdeck.arms.geometry import frozen
from aftdeck.arrays import Array
from aftdeck.bodies.cover import prism
from aftdeck.bodies.mass_properties import cylinder
from aftdeck.bodies.mass_properties import prism as uniform_prism
from aftdeck.elementary import sincos
from aftdeck.errors import InputError
from aftdeck.frames import Pose, endori
from aftdeck.shapes import Box, Cylinder, Group, Material, Ring, Shape, Sphere
from aftdeck.tuples import Vec3, plain_vector
from aftdeck.worksite.berths.berth import Berth
from aftdeck.worksite.file.cargo_file import (
    CargoFile,
    GrappleFile,
    PrismBody,
    ReceptacleFile,
    StartFile,
    TrunnionsFile,
)
from aftdeck.worksite.file.solids import CORNERS, as_solids, checked, drawn, moved
from aftdeck.worksite.payload import LimitCycle, Payload, Start, part_of

_UPWARDS = pi / 2
"""Angle of the middle of a prism's first side, from y towards z [rad]. With this angle, one side is on top and one is
below."""
_ROUNDING = 1e-9
"""Allowance for rounding in the check that a bar does not extend beyond its payload's top [m]."""
_REPORT = np.diag([1.0, -1.0, -1.0])
"""Columns: the report's axes (x aft, y port, z down) in a payload's axes."""


class _Piece(NamedTuple):
    """A part of a payload: its hexahedra (n, 8, 3) in the payload's axes [m], and its shapes."""

    fitting: str
    bodies: Array
    shapes: tuple[Shape, ...]


def payload_of(file: CargoFile, berths: Mapping[str, Berth]) -> Payload:
    """Return the payload that a file describes, with its start.

    Raises:
        InputError: the sizes in the file do not make convex bodies.
        ValueError: the berth in which the payload starts is not listed or needs a fitting that the payload lacks, or
            the bar extends beyond the payload's top.
    """
    pieces = tuple(_pieces(file))
    bar = next((frozen(piece.bodies[0]) for piece in pieces if piece.fitting == "receptacle"), None)
    probe, trunnions = _probe_tip(file), _latched(file.trunnions)
    return Payload(
        name=file.name,
        title=file.title,
        mass=float(file.mass),
        inertia=frozen(_inertia(file)),
        centre_of_mass=frozen(np.zeros(3) if (centre := file.mass_centre()) is None else centre),
        shapes=tuple(shape for piece in pieces for shape in piece.shapes) + file.shapes,
        solids=tuple(
            solid
            for fitting, bodies, _ in pieces
            for solid in as_solids(part_of(file.name, fitting), file.name, checked(bodies, fitting or "body"))
        ),
        probe=probe,
        receptacle=bar,
        grapple=None if file.grapple is None else _pose(file.grapple),
        trunnions=trunnions,
        trunnion_names=() if file.trunnions is None else _names(len(file.trunnions.x)),
        start=start_of(file.start, berths, probe, trunnions),
        limit_cycle=None
        if file.limit_cycle is None
        else LimitCycle(*map(frozen, (file.limit_cycle.deadband, file.limit_cycle.rate, file.limit_cycle.start))),
        details=() if file.grapple is None else _in_fixture(file.grapple, file.grapple.details),
    )


def _inertia(file: CargoFile) -> Array:
    """Return the tensor of inertia (3, 3) along the payload's axes: given, or that of a uniform body [kg m2]."""
    if (given := file.tensor()) is not None:
        return given
    body, mass, end = file.body, float(file.mass), np.array([0.5 * file.body.length, 0.0, 0.0])
    if isinstance(body, PrismBody):
        return uniform_prism(mass, float(body.across), body.sides, -end, end).inertia
    return cylinder(mass, float(body.radius), -end, end).inertia


def _pieces(file: CargoFile) -> Iterator[_Piece]:
    half, top = file.body.length / 2.0, _apothem(file)
    if isinstance(file.body, PrismBody):
        bodies = prism(top, file.body.length, sides=file.body.sides, turn=_UPWARDS)
        yield _Piece("", bodies, drawn(bodies, file.body.material))
    else:
        round_body = Cylinder(material=file.body.material, length=float(file.body.length), radius=float(top))
        yield _Piece("", prism(top, file.body.length, turn=_UPWARDS), (round_body,))
    if probe := file.probe:
        bodies = prism(_across_flats(probe.across, probe.sides), probe.length, sides=probe.sides, turn=_UPWARDS)
        bodies += [-half - probe.length / 2.0, 0.0, 0.0]
        yield _Piece("probe", bodies, drawn(bodies, probe.material))
    if bar := file.receptacle:
        _check_on_top(file, bar)
        bodies = _bar(bar, top)
        yield _Piece("receptacle", bodies, drawn(bodies, bar.material))
    if file.grapple:
        yield _fixture(file.grapple)
    if file.trunnions:
        yield _pins(file.trunnions)


def _across_flats(across: float, sides: int) -> float:
    """Return half the distance between opposite sides of a regular polygon.

    `across` is the distance between opposite corners.
    """
    return across / 2.0 * sincos(pi / sides)[1]


def _apothem(file: CargoFile) -> float:
    """Return the height of the body's top above its axis [m]."""
    body = file.body
    return _across_flats(body.across, body.sides) if isinstance(body, PrismBody) else float(body.radius)


def _bar(bar: ReceptacleFile, top: float) -> Array:
    """Return the vertices (1, 8, 3) of the bar, the report's RECPT.

    They are numbered in the report's axes: face c is on top.
    """
    own = (CORNERS - 0.5) * np.array([bar.length, bar.width, bar.height])
    return moved(own[None], Pose(np.array([*bar.at, top + bar.height / 2.0], dtype=np.float64), _REPORT))


def _check_on_top(file: CargoFile, bar: ReceptacleFile) -> None:
    """Reject a bar that extends beyond the top of its payload (ValueError).

    The top of a prism is its upper side. The top of a cylinder is assumed to be as wide as the cylinder.
    """
    body = file.body
    wide = body.across * sincos(pi / body.sides)[0] if isinstance(body, PrismBody) else 2.0 * body.radius
    for axis, middle, size, room in (("x", bar.at[0], bar.length, body.length), ("y", bar.at[1], bar.width, wide)):
        beyond = abs(middle) + 0.5 * size - 0.5 * room
        if beyond > _ROUNDING:
            raise ValueError(
                f"the bar ends {beyond:.3g} m beyond the top, which is {room:.4g} m along {axis}; the bar's middle is "
                f"at {middle:.4g} m and its size is {size:.4g} m"
            )


def _fixture(grapple: GrappleFile) -> _Piece:
    """Return a grapple fixture's base and target.

    The pin and the ramps around it enter the end effector and are therefore not solid.
    """
    base = prism(grapple.radius, grapple.depth) + np.array([grapple.depth / 2.0, 0.0, 0.0])
    shapes = _in_fixture(grapple, grapple.shapes)
    bodies = np.concatenate([base, *_target(grapple.shapes)])
    return _Piece("grapple fixture", moved(bodies, _pose(grapple)), shapes)


def _in_fixture(grapple: GrappleFile, shapes: tuple[Shape, ...]) -> tuple[Shape, ...]:
    """Return shapes in a fixture's axes as shapes in the payload's axes."""
    if not shapes:
        return ()
    return (Group(position=plain_vector(grapple.position), rotation=plain_vector(grapple.rotation), shapes=shapes),)


def _target(shapes: tuple[Shape, ...]) -> Iterator[Array]:
    """Yield boxes (1, 8, 3) that enclose the target, which is beside the fixture's axis.

    One box encloses the flat shapes (plate and ring), and a second box encloses the rod. A single box around all of
    them would be as wide as the plate and as long as the rod, and would obstruct the end effector.
    """
    halves = [(shape.position, half) for shape in shapes if any(shape.position[1:]) and (half := _half(shape))]
    boxes = np.array(halves, dtype=np.float64).reshape(-1, 2, 3)
    flat = boxes[:, 1, 0] < boxes[:, 1, 1]
    for middle, half in (boxes[some].transpose(1, 0, 2) for some in (flat, ~flat) if some.any()):
        low, high = (middle - half).min(axis=0), (middle + half).max(axis=0)
        yield (low + CORNERS * (high - low))[None]


def _half(shape: Shape) -> Vec3 | None:
    """Return half the size of the box that encloses a shape; None for a group, which draws marks and does not collide.

    Raises:
        InputError: a target cannot have a shape of this kind, or the shape is rotated, tapered or not along x.
    """
    match shape:
        case Group():
            return None
        case Box(rotation=(0.0, 0.0, 0.0), size=(x, y, z)):
            return x / 2.0, y / 2.0, z / 2.0
        case Cylinder(rotation=(0.0, 0.0, 0.0), axis="x", length=length, radius=radius, radius_end=None):
            return length / 2.0, radius, radius
        case Ring(rotation=(0.0, 0.0, 0.0), axis="x", radius=radius, bar=bar):
            return bar, radius + bar, radius + bar
        case Sphere(radius=radius):
            return radius, radius, radius
        case _:
            kind = type(shape).__name__.lower()
            raise InputError(
                f"grapple: this {kind} cannot be part of a target; a shape beside the fixture's axis has to be a "
                "group, a sphere, a box without rotation, or a ring or untapered cylinder along x without rotation"
            )


def _pins(trunnions: TrunnionsFile) -> _Piece:
    """Return the trunnions: each is drawn as a round pin and covered by a square prism.

    Of all prisms, a square one needs the fewest hexahedra.
    """
    (inner, outer), (low, high) = trunnions.span, trunnions.keel_span
    radius, material = float(trunnions.radius), trunnions.material
    across = prism(radius, outer - inner, axis="y", sides=4)
    upright = prism(radius, high - low, axis="z", sides=4)
    bodies, shapes = [], []
    for x in trunnions.x:
        for side in (-1.0, 1.0):
            middle = (float(x), side * (inner + outer) / 2.0, float(trunnions.z))
            bodies.append(across + middle)
            shapes.append(_pin(middle, radius, outer - inner, material, "y"))
    keel = (float(trunnions.keel[0]), 0.0, (low + high) / 2.0)
    return _Piece(
        "trunnions",
        np.concatenate([*bodies, upright + keel]),
        (*shapes, _pin(keel, radius, high - low, material, "z")),
    )


def _pin(middle: Vec3, radius: float, length: float, material: Material, axis: str) -> Cylinder:
    return Cylinder(
        material=material, position=middle, axis="y" if axis == "y" else "z", length=float(length), radius=radius
    )


def _latched(trunnions: TrunnionsFile | None) -> Array:
    """Return the points (n, 3) that latches hold [m].

    They are the port and the starboard point of each pair, then the point of the keel pin.
    """
    if trunnions is None:
        return frozen(np.empty((0, 3)))
    pairs = [(x, side * trunnions.y, trunnions.z) for x in sorted(trunnions.x) for side in (-1.0, 1.0)]
    return frozen([*pairs, (trunnions.keel[0], 0.0, trunnions.keel[1])])


def _names(pairs: int) -> tuple[str, ...]:
    """Return the names of the points of `_latched`, pair by pair."""
    numbers = tuple(str(k + 1) for k in range(pairs))
    where = ("forward", "aft") if numbers == ("1", "2") else numbers
    return (*(f"{pair} {side}" for pair in where for side in ("port", "starboard")), "keel")


def _probe_tip(file: CargoFile) -> Pose | None:
    """Return the pose of the middle of the probe's forward face in the payload's axes; None without a probe."""
    if file.probe is None:
        return None
    return Pose(frozen([-file.body.length / 2.0 - file.probe.length, 0.0, 0.0]), frozen(np.eye(3)))


def start_of(file: StartFile, berths: Mapping[str, Berth], probe: Pose | None, trunnions: Array) -> Start:
    """Return the start of a payload.

    Args:
        file: the payload's table ``start``.
        berths: the worksite's berths by name.
        probe: `Payload.probe` of the payload.
        trunnions: `Payload.trunnions` of the payload.

    Raises:
        ValueError: the berth does not exist, or needs a fitting that the payload does not have.
    """
    if file.seat is None:
        return Start("", _pose(file), frozen(file.velocity), frozen(file.rates))
    berth = berths.get(file.seat)
    if berth is None:
        raise ValueError(f"start.seat: {file.seat!r} is not a seat; seats are: {', '.join(berths) or 'none'}")
    if lacking := berth.lacks(probe, trunnions):
        raise ValueError(f"start.seat: {file.seat!r} holds a payload by its {lacking}; this cargo has no {lacking}")
    return Start(berth.name, berth.seated(probe), frozen(np.zeros(3)), frozen(np.zeros(3)))


def _pose(placed: GrappleFile | StartFile) -> Pose:
    return Pose(frozen(placed.position), frozen(endori(*placed.rotation)))
