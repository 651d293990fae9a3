"""What a reader may know of the worksite at one instant: contacts, captures, and where everything is."""

from __future__ import annotations

from typing import Literal

import msgspec

from aftdeck.worksite.alarm import Level
from aftdeck.worksite.conditions import Condition

Vec3 = tuple[float, float, float]
Rows = tuple[Vec3, Vec3, Vec3]
Six = tuple[float, float, float, float, float, float]


class Near(msgspec.Struct, frozen=True, gc=False):
    """Two parts that are watched, in L."""

    a: str
    """A part, for people: ``lower boom``."""
    b: str
    clearance: float
    """[m], negative where they overlap."""
    closing: float
    """Speed at which the two closest points approach [m/s]."""
    point_a: Vec3
    """The closest point of a [m]."""
    point_b: Vec3
    normal: Vec3
    """Unit normal of a plane between the two, from a to b; zero where they collide."""
    distance: float
    """The plane's distance from L's origin [m]."""
    essential: bool = False
    """Whether the two are made to touch; such a contact inhibits nothing."""
    feature_a: str = ""
    """What of a touches or penetrates: ``vertex 3``; empty where they are apart."""
    feature_b: str = ""


class Cargo(msgspec.Struct, frozen=True, gc=False):
    """A payload of the worksite, in L."""

    name: str
    position: Vec3
    """Its centre [m]."""
    orientation: Rows
    """Rows of the matrix whose columns are its axes."""
    velocity: Vec3
    """Of its centre, against L [m/s]."""
    held: bool
    """Whether the end effector holds it."""
    seat: str
    """The seat that it is fixed to; empty: none."""


class Hand(msgspec.Struct, frozen=True, gc=False):
    """The end effector."""

    switch: Literal["stop", "close", "open"]
    """How its switch stands."""
    opening: float
    """0 closed to 1 open: of the prong, or of the snares."""
    spacing: float | None
    """Prong to fixed finger [m]; None: this arm has none."""
    carriage: float | None
    """0 extended to 1 rigid; None: this arm has none."""
    flags: tuple[str, ...]
    """Lit on the panel: ``CAPTURE``, ``RIGID``."""
    mode: Literal["auto", "manual"] = "auto"
    """END EFFECTOR MODE of the snares."""
    rigid: Literal["off", "rigid", "derigid"] = "off"
    """END EFFECTOR MAN CONTR of the snares."""


class Work(msgspec.Struct, frozen=True, gc=False):
    """The worksite after a step. Vectors in L."""

    task: int
    """The report's mode: 1 acquisition, 2 extraction, 3 manoeuvring, 4 docked."""
    nearest: Near | None
    """The watched pair with the least clearance, but for those that are, or come, together as the task needs it, of
    which the conditions tell (`simulation.lined_up`); None: no pair is watched."""
    clearance_level: Level
    """What that clearance calls for, by the scenario's thresholds."""
    contacts: tuple[Near, ...]
    """Pairs that touch or overlap."""
    arm_inhibit: bool
    finger_inhibit: bool
    inhibits: tuple[str, ...]
    """Why the arm or the finger is inhibited, and what frees it."""
    pursuit: str
    """What the conditions are for: ``acquire payload``; empty: nothing is near enough."""
    conditions: tuple[Condition, ...]
    hand: Hand
    stand: float | None
    """Length of the telescope [m]; None: this arm stands on none."""
    orbiter: Vec3
    """How far the orbiter has moved [m]."""
    orbiter_velocity: Vec3
    """[m/s]"""
    cargo: tuple[Cargo, ...]
    master: Six | None
    """Where the master arm stands [rad]; None in other modes than MASTER."""
