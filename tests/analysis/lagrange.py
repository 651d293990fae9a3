"""Second witness for rigid arms: Lagrange's equations, from the frames of the laws and the masses of the arm's file."""

from __future__ import annotations

import numpy as np

from aftdeck.arms.load import ArmModel
from aftdeck.arms.masses import masses_of
from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties
from aftdeck.kinematics.frames import frames_of, place_frames
from aftdeck.plant.multibody.chain import DUST

STEP = 1e-5
"""Displacement of a coordinate from which the mass matrix's slope is taken [rad, m]."""


def mass_matrix(model: ArmModel, payload: MassProperties | None, coordinates: tuple[str, ...], q: Array) -> Array:
    """Return the sum of m Jv' Jv + Jw' I Jw over all bodies, and the motors' inertias."""
    at = dict(zip(coordinates, q, strict=True))
    frames, chain = frames_of(model), model.linkage.frames
    stand, prong = (None if joint is None else joint.frame for joint in (model.telescope, model.prong))
    rows = frames.rows()
    angles = np.array([at[f"motor.{name}"] for name in model.joints])
    place_frames(frames.joints, angles, float(model.links[0]) + at.get("telescope", 0.0), at.get("prong", 0.0), rows)
    poses = {name: (row[:3], row[3:].reshape(3, 3)) for name, row in zip(frames.names, rows, strict=True)}
    servo = model.servo
    assert servo is not None
    total = np.diag([servo.armature[model.joints.index(n[6:])] if n.startswith("motor.") else 0.0 for n in coordinates])
    for frame, body in bodies_of(model, payload):
        place, axes = poses[frame]
        centre, inertia = place + axes @ body.centre, axes @ body.inertia @ axes.T
        moving, turning = np.zeros((3, len(q))), np.zeros((3, len(q)))
        for k, name in enumerate(coordinates):
            if name == "telescope":
                moving[2, k] = -1.0
            elif name == "prong":
                moving[:, k] = poses[chain[-1]][1][:, 1] if frame == prong else 0.0
            else:
                joint = model.joints.index(name.removeprefix("motor."))
                if frame != stand and (frame == prong or chain.index(frame) > joint):
                    origin, carried = poses[chain[joint + 1]]
                    turning[:, k] = carried @ model.linkage.axes[joint]
                    moving[:, k] = np.cross(turning[:, k], centre - origin)
        total = total + body.mass * moving.T @ moving + turning.T @ inertia @ turning
    return total


def forces(
    model: ArmModel, payload: MassProperties | None, coordinates: tuple[str, ...], q: Array, v: Array, a: Array
) -> Array:
    """Return the forces on the coordinates by Lagrange's equations: M a + M' v - 1/2 d(v' M v)/dq."""
    slopes = []
    for k in range(len(q)):
        by = np.zeros(len(q))
        by[k] = STEP
        two = [mass_matrix(model, payload, coordinates, q + sign * by) for sign in (1.0, -1.0)]
        slopes.append((two[0] - two[1]) / (2.0 * STEP))
    along = np.tensordot(v, slopes, axes=1)
    pulled = np.array([0.5 * v @ slope @ v for slope in slopes])
    found: Array = mass_matrix(model, payload, coordinates, q) @ a + along @ v - pulled
    return found


def bodies_of(model: ArmModel, payload: MassProperties | None) -> list[tuple[str, MassProperties]]:
    """Return frame and mass properties of each moving body of a rigid arm; a frame without mass has the least one."""
    masses, (base, *moving) = masses_of(model), model.frames
    bodies = [(frame, body) for frame, body in masses.bodies.items() if frame != base]
    bodies += [(boom.frame, boom.whole()) for boom in masses.booms]
    bodies += [(frame, DUST) for frame in moving if frame not in {name for name, _ in bodies}]
    if payload is not None:
        bodies.append((model.linkage.frames[-1], payload.moved([float(model.links[4]), 0.0, 0.0])))
    return bodies
