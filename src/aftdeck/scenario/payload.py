"""Payloads that a scenario attaches to the end effector, built from their tables."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from aftdeck.arms.covers import cover_problem, hexahedra
from aftdeck.arms.geometry import frozen
from aftdeck.bodies.mass_properties import box
from aftdeck.files import Where
from aftdeck.frames import endori
from aftdeck.kinematics.payload import HeldPayload
from aftdeck.plant.usual_payload import usual_payload
from aftdeck.scenario.poses import rotation_matrix
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import AttachedSpec, PayloadSpec

PART = "payload"
"""Name of the payload's part."""


def held_payload(problems: Problems, spec: PayloadSpec | None) -> HeldPayload | None:
    """Return the payload of the table `[payload]`; None if the file has no such table, or if the table is wrong."""
    held = None if spec is None else attached_payload(problems, spec, ("payload",))
    if spec is None or held is None:
        return None
    for k, cover in enumerate(spec.body):
        if problem := cover_problem(cover, PART):
            problems.add(("payload", "body", k), problem)
            return None
    solids = tuple(frozen(vertices) for cover in spec.body for vertices in hexahedra(cover, PART))
    inertia = held.inertia
    if solids and spec.inertia is None:
        corners = np.concatenate(solids)
        inertia = frozen(box(held.mass, corners.min(axis=0), corners.max(axis=0)).inertia)
    return replace(held, shapes=spec.shape, solids=solids, inertia=inertia)


def attached_payload(problems: Problems, spec: AttachedSpec, where: Where) -> HeldPayload | None:
    """Return the payload of the table at `where` in the file, without shapes and solids; None if the table is wrong."""
    if spec.mass <= 0.0:
        problems.add((*where, "mass"), f"has to be above 0, got {spec.mass:g} kg")
        return None
    if why := spec.tensor_problem():
        problems.add((*where, "inertia"), why)
        return None
    turned = endori(spec.roll, spec.pitch, spec.yaw)
    if spec.matrix is not None:
        given = rotation_matrix(problems, spec.matrix, (*where, "matrix"))
        if given is None:
            return None
        turned = given
    inertia, centre = spec.tensor(), spec.mass_centre()
    return HeldPayload(
        float(spec.mass),
        frozen(turned),
        frozen(spec.position),
        frozen(spec.por),
        inertia=frozen(usual_payload(float(spec.mass)).inertia if inertia is None else inertia),
        centre_of_mass=frozen(np.zeros(3) if centre is None else centre),
    )
