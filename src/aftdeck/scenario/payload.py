"""The payload in the grasp at the start."""

from __future__ import annotations

from aftdeck.arms.covers import cover_problem, hexahedra
from aftdeck.arms.geometry import frozen
from aftdeck.frames import endori
from aftdeck.kinematics.payload import Payload
from aftdeck.scenario.poses import rotation_matrix
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import PayloadSpec

PART = "payload"
"""What people call it."""


def held_payload(problems: Problems, spec: PayloadSpec | None) -> Payload | None:
    """The payload that the file describes; None where there is none, or its mass is wrong."""
    if spec is None:
        return None
    if spec.mass <= 0.0:
        problems.wrong(("payload", "mass"), f"is above 0, got {spec.mass:g} kg")
        return None
    if spec.matrix is None:
        turned = endori(spec.roll, spec.pitch, spec.yaw)
    else:
        given = rotation_matrix(problems, spec.matrix, ("payload", "matrix"))
        if given is None:
            return None
        turned = given
    for k, cover in enumerate(spec.body):
        if problem := cover_problem(cover, PART):
            problems.wrong(("payload", "body", k), problem)
            return None
    solids = tuple(frozen(vertices) for cover in spec.body for vertices in hexahedra(cover, PART))
    return Payload(float(spec.mass), frozen(turned), frozen(spec.position), frozen(spec.por), spec.shape, solids)
