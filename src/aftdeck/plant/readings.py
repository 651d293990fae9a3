"""Readings of a plant with masses: what gauges inside the arm and on the bodies would show.

No step needs them, and to find them takes time. They are therefore no part of the state or of a frame.
"""

from __future__ import annotations

from typing import Annotated, Literal, get_args

import msgspec

from aftdeck.field_meta import field_meta
from aftdeck.tuples import Vec3

Cut = Literal["upper_boom", "lower_boom", "end_effector"]
"""Place at which a load is measured: the roots of both booms (on the concept arm, of upper and lower arm), and the tip.

The root of a boom is the origin of the frame that carries it, behind the joint that turns it.
"""
CUTS: tuple[Cut, ...] = get_args(Cut)
"""All cuts, from the shoulder to the tip."""


class Load(msgspec.Struct, frozen=True, gc=False):
    """Load on the part of the arm beyond a cut, and on what it carries, by the part before the cut.

    The components are in the frame that carries the boom, or in frame 7 at the tip. The load at the tip is the one on
    the payload; contacts of the end effector itself do not belong to it.
    """

    cut: Annotated[Cut, field_meta("place of the cut")]
    force: Annotated[Vec3, field_meta("force at the end of the step", "N", "part")]
    moment: Annotated[Vec3, field_meta("moment about the place of the cut, at the end of the step", "N m", "part")]
    peak_force: Annotated[float, field_meta("greatest force of all steps of MuJoCo in the control step", "N")]
    peak_moment: Annotated[float, field_meta("greatest moment of all steps of MuJoCo in the control step", "N m")]


class Readings(msgspec.Struct, frozen=True, gc=False):
    """Readings after a control step."""

    loads: Annotated[tuple[Load, ...], field_meta("loads at all cuts")]
    orbiter_turn_rate: Annotated[Vec3, field_meta("angular velocity of the orbiter in space", "rad/s", "L")]
    orbiter_velocity: Annotated[Vec3, field_meta("velocity of L's origin in space", "m/s", "L")]
    payload_turn_rates: Annotated[
        tuple[Vec3, ...],
        field_meta("angular velocity of each payload of the worksite relative to the orbiter", "rad/s", "payload"),
    ]
