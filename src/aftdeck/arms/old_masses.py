"""Masses in arm files of Aftdeck before 0.2, which are those of housings and booms, not of links.

The converted file gives each link the same mass, centre of mass and moments of inertia. Only the boundaries between
neighbouring spheres and rods inside a link differ.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from aftdeck.arrays import Array
from aftdeck.bodies.mass_properties import MassProperties, about, cylinder, joined, sphere
from aftdeck.units import Length, Mass, MomentOfInertia

LINKS = ("foot", "shoulder", "upper_boom", "lower_boom", "wrist_pitch", "wrist_yaw", "end_effector")
"""Links of an arm of the Shuttle's family."""
_SOURCE = {"source": "converted from the masses of housings and booms", "confidence": "assumed"}
_FOOT = 0.5
"""Length given to the foot, which is fixed to the vehicle, so that its own mass properties have no effect [m]."""


def with_links(raw: dict[str, Any]) -> None:
    """Convert the masses in the contents of an arm file, if they are those of housings; else change nothing."""
    try:
        parts = raw["masses"]["parts"]["value"]
        if "yaw_housing" not in parts:
            return
        masses = {name: float(Mass.read(value)) for name, value in parts.items()}
        raw.get("flexibility", {}).pop("added_inertia", None)
        housings = raw.pop("housings", None)
        if housings is None:
            raw["masses"]["parts"]["value"] = dict.fromkeys(LINKS, sum(masses.values()) / len(LINKS))
            return
        links = _links(masses, housings, raw["geometry"])
        raw["masses"]["parts"]["value"] = {n: body.mass for n, body in zip(LINKS, links, strict=True)}
        raw["links"] = {
            "centre": {"value": [float(body.centre[0]) for body in links], **_SOURCE},
            "inertia": {"value": [_moments(body) for body in links], **_SOURCE},
            "foot": {"value": _FOOT, **_SOURCE},
            "boom_radius": housings["boom_radius"],
            "wrist_yaw_to_roll": housings["wrist_yaw_to_roll"],
        }
    except (ValueError, TypeError, KeyError, AttributeError):
        return  # the reader of arm files says what is wrong with it


def _links(m: dict[str, float], housings: dict[str, Any], geometry: dict[str, Any]) -> list[MassProperties]:
    """Return the links, each along x from its joint."""

    def length(of: dict[str, Any]) -> float:
        return float(Length.read(of["value"]))

    def rod(mass: float, end: float) -> MassProperties:
        return cylinder(mass, length(housings["boom_radius"]), np.zeros(3), np.array([end, 0.0, 0.0]))

    def ball(mass: float, at: float = 0.0) -> MassProperties:
        return sphere(mass, length(housings["radius"]), (at, 0.0, 0.0))

    upper, lower = (
        float(np.linalg.norm([Length.read(part) for part in geometry[arm]["value"]]))
        for arm in ("upper_arm", "lower_arm")
    )
    to_roll, to_tip = length(housings["wrist_yaw_to_roll"]), length(geometry["wrist_yaw_to_tip"])
    wrist = [
        MassProperties(mass, np.array([0.5 * ahead, 0.0, 0.0]), np.diag([along, across, across]))
        for mass, ahead, (along, across) in zip(
            (
                0.5 * m["wrist_pitch"] + 0.5 * m["wrist_yaw"],
                0.5 * m["wrist_yaw"] + 0.5 * m["wrist_roll"],
                0.5 * m["wrist_roll"] + m["end_effector"],
            ),
            (length(geometry["wrist_pitch_to_yaw"]), to_roll, to_tip - to_roll),
            [[float(MomentOfInertia.read(v)) for v in pair] for pair in housings["wrist_inertia"]["value"]],
            strict=True,
        )
    ]
    return [
        ball(m["yaw_housing"], _FOOT),
        ball(m["shoulder"], 0.5 * length(geometry["shoulder_yaw_to_pitch"])),
        joined([rod(m["upper_boom"], upper), ball(0.5 * m["elbow"], upper)]),
        joined([ball(0.5 * m["elbow"]), rod(m["lower_boom"], lower), ball(0.5 * m["wrist_pitch"], lower)]),
        *wrist,
    ]


def _moments(body: MassProperties) -> list[float]:
    """Return the moments of inertia about the origin."""
    moments: Array = np.diagonal(body.inertia + about(body.mass, body.centre))
    return [float(moment) for moment in moments]
