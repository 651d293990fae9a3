"""Boxes of the concept arm for collision tests and drawing, computed from the dimensions in the arm's file.

The Remote Manipulator Simulation has these solids: the three hexahedra of the end effector; ARM 0, ARM 1 and ARM 2; and
STAND. The housings of the joints, and the tube that slides in the telescope's sleeve, are our additions.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from aftdeck.arms.geometry import PRONG, STAND
from aftdeck.arms.model import HeadingArmFile
from aftdeck.shapes import Material
from aftdeck.tuples import Vec3

Axes = tuple[int, int, int]

OWN: Axes = (1, 2, 3)
EFFECTOR: Axes = (-3, 2, 1)
"""(x, y, z) = (-Z2, Y2, X2): face c then faces the wrist, and face d the bar (restored from the report's MO2SET)."""


class Block(NamedTuple):
    """Box along the axes of its frame.

    Attributes:
        part: name that the operator reads.
        frame: name of the frame that carries the box.
        low: least x, y, z in that frame [m].
        high: greatest x, y, z in that frame [m].
        material: material with which the box is drawn.
        axes: for each of the box's own axes x, y and z, the number (1 to 3) of the parallel axis of the frame; negative
            if the two directions are opposite. The box's own axes define the numbers of its vertices.
    """

    part: str
    frame: str
    low: Vec3
    high: Vec3
    material: Material
    axes: Axes = OWN


def blocks_of(file: HeadingArmFile, frames: tuple[str, ...]) -> tuple[Block, ...]:
    """Return the arm's blocks, from the foot to the prong.

    Args:
        file: the arm's dimensions.
        frames: the frames of the arm's linkage, from the foot to the last joint.
    """
    return (*_stand(file, frames), *_booms(file, frames), *_effector(file, frames))


def _stand(file: HeadingArmFile, frames: tuple[str, ...]) -> Iterator[Block]:
    """Yield the telescope's sleeve and the tube that slides in the sleeve.

    The sleeve's upper end is at the upper end of the retracted tube. The tube is as long as the telescope's travel. If
    the travel is more than the sleeve's length, the retracted tube extends below the foot.
    """
    s = file.stand
    below = s.top_below_shoulder.value
    yield Block("stand", frames[0], *_along(2, below - s.least.value, 0.0, s.side.value), "structure")
    travel = s.greatest.value - s.least.value
    yield Block("telescope", STAND, *_along(2, below, below + travel, s.tube_side.value), "metal")


def _booms(file: HeadingArmFile, frames: tuple[str, ...]) -> Iterator[Block]:
    """Yield the upper arm, the lower arm, the stub, and the cubes around the pins."""
    b, upper, lower = file.booms, file.geometry.upper_arm.value, file.geometry.lower_arm.value
    back, side = b.set_back.value, b.side.value
    yield Block("shoulder", frames[2], *_cube(b.shoulder_housing.value), "housing")
    yield Block("upper boom", frames[2], *_along(0, back, upper - back, side), "boom")
    yield Block("elbow", frames[3], *_cube(b.elbow_housing.value), "housing")
    yield Block("lower boom", frames[3], *_along(0, back, lower - back, side), "boom")
    yield Block("wrist", frames[4], *_cube(b.wrist_housing.value), "housing")
    yield Block("stub", frames[6], *_along(0, *b.stub.value, b.stub_side.value), "padding")


def _effector(file: HeadingArmFile, frames: tuple[str, ...]) -> Iterator[Block]:
    """Yield HEX 1 to HEX 3; the origin of the prong's frame is at the prong's inner face."""
    e = file.effector
    (begin, end), wide, high = e.palm.value, e.palm_half_width.value, e.palm_half_height.value
    yield Block("palm", frames[6], (begin, -wide, -high), (end, wide, high), "structure", EFFECTOR)
    (begin, end), thick, high = e.fingers.value, e.finger_thickness.value, e.finger_half_height.value
    inner = e.fixed_finger.value
    yield Block("fixed finger", frames[6], (begin, inner, -high), (end, inner + thick, high), "bright", EFFECTOR)
    yield Block("prong", PRONG, (begin, -thick, -high), (end, 0.0, high), "bright", EFFECTOR)


def _along(axis: int, begin: float, end: float, side: float) -> tuple[Vec3, Vec3]:
    """Return the least and the greatest corner of a box that extends along one axis of its frame.

    `axis` is the number of this axis: 0, 1 or 2. The box has a square section.
    """
    half = 0.5 * side
    low, high = [-half] * 3, [half] * 3
    low[axis], high[axis] = begin, end
    return (low[0], low[1], low[2]), (high[0], high[1], high[2])


def _cube(edge: float) -> tuple[Vec3, Vec3]:
    """Return the least and the greatest corner of a cube whose centre is the origin of its frame."""
    return _along(0, -0.5 * edge, 0.5 * edge, edge)
