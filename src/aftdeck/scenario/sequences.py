"""Prestored points of AUTO 1-4."""

from __future__ import annotations

from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.model import Point, Sequences
from aftdeck.scenario.poses import target
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import SequenceSpec


def stored_points(problems: Problems, arm: Arm, specs: tuple[SequenceSpec, ...]) -> Sequences:
    """Return the points of each sequence, by panel position (AUTO 1 to AUTO 4); invalid points are left out."""
    found: Sequences = {}
    for i, sequence in enumerate(specs):
        position = f"AUTO {sequence.slot}"
        if position in found:
            problems.add(("sequence", i, "slot"), f"{position} already has points; give each slot once")
        points = []
        for k, point in enumerate(sequence.point):
            point_target = target(problems, arm, point.target, ("sequence", i, "point", k, "target"))
            if point_target is not None:
                points.append(Point(point_target, point.pause))
        found[position] = tuple(points)
    return found
