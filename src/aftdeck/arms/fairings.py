"""Fairings of the concept arm: yokes, pins and necks between its boxes, computed from the arm's dimensions.

The boxes (`arms.blocks`) are what collides, and stay what the pictures of 1972 show. The report does not describe the
joints; all shapes are assumed. A yoke stands out of its boom by `_CHEEK` at most.
"""

from __future__ import annotations

from math import pi, tau

from aftdeck.arms.geometry import STAND
from aftdeck.arms.model import HeadingArmFile
from aftdeck.shapes import Axis, Box, Cylinder, Group, Hexahedron, Material, Ring, Shape, Sphere
from aftdeck.tuples import Vec3

_CHEEK = 0.03
"""Thickness of a yoke's cheeks [m]."""
_SLIT = 0.006
"""Distance of a cheek from the housing between the cheeks [m]."""


def fairings_of(file: HeadingArmFile, frames: tuple[str, ...]) -> dict[str, tuple[Shape, ...]]:
    """Return the fairings by the frame that carries them, in that frame's axes.

    Args:
        file: the arm's dimensions.
        frames: the frames of the arm's linkage, from the foot to the last joint.
    """
    base, heading, shoulder, elbow, wrist, _, hand = frames
    b = file.booms
    upper, lower = float(file.geometry.upper_arm.value), float(file.geometry.lower_arm.value)
    side, back, below = float(b.side.value), float(b.set_back.value), float(file.stand.top_below_shoulder.value)
    at_shoulder, at_elbow, at_wrist = (
        float(size.value) for size in (b.shoulder_housing, b.elbow_housing, b.wrist_housing)
    )
    return {
        base: _collar(0.5 * float(file.stand.side.value)),
        STAND: _turntable(below, float(file.stand.tube_side.value)),
        heading: _fork(at_shoulder, below),
        shoulder: (*_pin(at_shoulder, "y"), *_boom(side, 0.35 * at_shoulder, back, upper, 0.5 * at_elbow, "y")),
        elbow: (*_pin(at_elbow, "y"), *_boom(side, 0.35 * at_elbow, back, lower, 0.5 * at_wrist, "z")),
        wrist: (*_pin(at_wrist, "z"), *_ball(at_wrist)),
        hand: _hand(file),
    }


def _collar(half: float) -> tuple[Shape, ...]:
    """Return the collar at the upper end of the telescope's sleeve, with four wipers."""
    wiper = Box(material="bright", position=(half + 0.02, 0.0, -0.02), size=(0.04, 1.1 * half, 0.12))
    return (
        Box(material="housing", position=(0.0, 0.0, 0.06), size=(2.16 * half, 2.16 * half, 0.12)),
        Group(shapes=(wiper,), count=4, turn=(0.0, 0.0, pi / 2)),
    )


def _turntable(below: float, tube: float) -> tuple[Shape, ...]:
    """Return the bearing of the shoulder's heading on top of the tube; z is down."""
    radius = 0.62 * tube
    return (
        Cylinder(material="housing", axis="z", position=(0.0, 0.0, below - 0.04), length=0.08, radius=radius),
        Ring(material="bright", axis="z", position=(0.0, 0.0, below - 0.04), radius=radius, bar=0.015),
        Box(material="padding", position=(0.0, 0.0, below + 0.14), size=(1.1 * tube, 1.1 * tube, 0.2)),
    )


def _fork(housing: float, below: float) -> tuple[Shape, ...]:
    """Return the fork that turns on the bearing and carries the shoulder's pin; z is down."""
    out = 0.5 * housing + _SLIT + 0.5 * _CHEEK
    floor = below - 0.08
    cheek = (
        Box(material="padding", position=(0.0, out, 0.5 * floor), size=(0.8 * housing, _CHEEK, floor)),
        Cylinder(material="padding", axis="y", position=(0.0, out, 0.0), length=_CHEEK, radius=0.4 * housing),
        *_cap(out + 0.5 * _CHEEK, 0.26 * housing),
    )
    foot = Box(
        material="padding", position=(0.0, 0.0, floor - 0.02), size=(housing, 2.0 * out + _CHEEK, 0.04)
    )  # its corners stay below the turning housing
    return (Group(shapes=cheek, mirror=True), foot)


def _cap(out: float, radius: float) -> tuple[Shape, ...]:
    """Return the cap of a pin along y, which ends at y = `out`, with eight bolts."""
    bolt = Cylinder(material="dark", axis="y", position=(0.0, out + 0.022, 0.78 * radius), length=0.008, radius=0.012)
    return (
        Cylinder(material="bright", axis="y", position=(0.0, out + 0.009, 0.0), length=0.018, radius=radius),
        Cylinder(material="housing", axis="y", position=(0.0, out + 0.02, 0.0), length=0.012, radius=0.5 * radius),
        Group(shapes=(bolt,), count=8, turn=(0.0, tau / 8, 0.0)),
    )


def _pin(housing: float, axis: Axis) -> tuple[Shape, ...]:
    """Return the drum of a joint's motor around its pin, inside the cheeks."""
    return (
        Cylinder(material="bright", axis=axis, length=housing + _SLIT, radius=0.42 * housing),
        Cylinder(material="housing", axis=axis, length=0.86 * housing, radius=0.56 * housing),
    )


def _boom(side: float, neck: float, begin: float, end: float, housing: float, pin: Axis) -> tuple[Shape, ...]:
    """Return what a boom carries: a neck at its inner end, a yoke at its outer end, rings, a cable and its clamps.

    Args:
        side: side of the boom's section [m].
        neck: half of the neck's section at the joint [m].
        begin: distance of both ends of the boom from the pins [m].
        end: distance of the outer pin [m].
        housing: half of the edge of the outer joint's housing [m].
        pin: axis of the outer pin, in the boom's axes.
    """
    half, last = 0.5 * side, end - begin
    inner = housing + _SLIT
    long = begin + 1.2 * housing
    cheek: tuple[Shape, ...] = (
        Box(
            material="padding",
            position=(last + 0.5 * (long - 1.2 * housing), inner + 0.5 * _CHEEK, 0.0),
            size=(long - 1.2 * housing, _CHEEK, 1.3 * housing),
        ),
        Cylinder(
            material="padding",
            axis="y",
            position=(end, inner + 0.5 * _CHEEK, 0.0),
            length=_CHEEK,
            radius=0.65 * housing,
        ),
        Group(position=(end, 0.0, 0.0), shapes=_cap(inner + _CHEEK, 0.4 * housing)),
    )
    taper = max(1.3 * housing, 1e-3)
    shut = min(0.45 * begin, begin - 1.5 * housing)
    yoke: tuple[Shape, ...] = (
        _frustum((last, half, half), (last + shut, inner + _CHEEK, 0.5 * taper), "padding"),
        Group(shapes=cheek, mirror=True),
    )
    clamp = Box(material="structure", position=(begin + 0.4, 0.0, half + 0.02), size=(0.06, 0.14, 0.04))
    count = max(2, int((last - begin) / 0.9))
    return (
        _frustum((0.6 * begin, neck, neck), (begin, half, half), "padding"),
        _frustum((0.0, neck, neck), (0.6 * begin, neck, neck), "housing"),
        *(_band(x, half) for x in (begin + 0.05, last - 0.05)),
        Box(material="dark", position=(0.5 * end, 0.0, half + 0.015), size=(last - begin - 0.2, 0.05, 0.03)),
        Group(shapes=(clamp,), count=count, step=((last - begin - 0.8) / (count - 1), 0.0, 0.0)),
        Group(shapes=yoke, rotation=(pi / 2 if pin == "z" else 0.0, 0.0, 0.0)),
    )


def _band(x: float, half: float) -> Shape:
    """Return the band round an end of a boom."""
    return Box(material="bright", position=(x, 0.0, 0.0), size=(0.08, 2.0 * half + 0.024, 2.0 * half + 0.024))


def _ball(housing: float) -> tuple[Shape, ...]:
    """Return the ball of the wrist, whose three axes meet in one point."""
    return (
        Sphere(material="padding", radius=0.62 * housing),
        Ring(material="bright", axis="z", radius=0.62 * housing, bar=0.008),
    )


def _hand(file: HeadingArmFile) -> tuple[Shape, ...]:
    """Return the neck from the wrist to the stub, the stub's flange on the palm, and the drive of the prong."""
    b, e = file.booms, file.effector
    (begin, end), half = map(float, b.stub.value), 0.5 * float(b.stub_side.value)
    (palm, front), wide = map(float, e.palm.value), float(e.palm_half_width.value)
    high = float(e.palm_half_height.value)
    screw: Vec3 = (palm - 0.05, -0.5 * wide, 0.0)
    return (
        Cylinder(material="housing", position=(0.5 * begin, 0.0, 0.0), length=begin, radius=0.62 * half),
        Cylinder(material="bright", position=(begin - 0.03, 0.0, 0.0), length=0.06, radius=0.95 * half),
        _frustum((end - 0.6 * (end - begin), half, half), (end, 1.6 * half, 0.92 * high), "padding"),
        _band(begin + 0.06, half),
        # drive of the prong: motor, screw and bearings behind the palm
        Box(material="housing", position=(palm - 0.05, -0.93 * wide, 0.0), size=(0.1, 0.12 * wide, 0.9 * high)),
        Cylinder(material="bright", axis="y", position=screw, length=0.75 * wide, radius=0.02),
        Box(material="housing", position=(palm - 0.04, 0.6 * wide, 0.0), size=(0.08, 0.5 * wide, 0.8 * high)),
        # edges of the palm, and the black and yellow stripes that mark where it closes
        *(
            Box(
                material="rail" if k % 2 else "dark",
                position=(0.5 * (palm + front), y, sign * (high + 0.001)),
                size=(0.9 * (front - palm), 0.06, 0.004),
            )
            for sign in (-1.0, 1.0)
            for k, y in enumerate(-0.9 * wide + 0.06 * i for i in range(8))
        ),
    )


def _frustum(begin: Vec3, end: Vec3, material: Material) -> Hexahedron:
    """Return a truncated pyramid along x; `begin` and `end`: x, and half of the section along y and z [m]."""
    corners: list[Vec3] = []
    for y in (-1.0, 1.0):
        for x, half_y, half_z in (begin, end):
            corners += [(x, y * half_y, -half_z), (x, y * half_y, half_z)]
    return Hexahedron(material=material, vertices=tuple(corners))
