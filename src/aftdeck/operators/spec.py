"""Parameters of a synthetic operator."""

from __future__ import annotations

from typing import Annotated, Literal, cast, get_args

import msgspec

from aftdeck.bounds import Bounds
from aftdeck.errors import InputError
from aftdeck.units import Time

Kind = Literal["script", "perfect", "human"]
"""Kind of operator: the scenario's script, a pilot without delay and noise, or a pilot with human limits."""
ReactionTime = Annotated[Time, Bounds(0.0, 5.0, "a person reacts within a second")]


class OperatorSpec(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Parameters of an operator; all but `kind` apply to the kind ``human`` only.

    `reaction_time` is the effective delay of McRuer and Krendel's crossover model, from a change on the page to a
    motion of the stick. `gain` is its crossover frequency [rad/s]: the demanded speed is `gain` times the distance.
    `lag` is the time constant of nerves and muscles. `noise` is the standard deviation of the remnant, as a share of
    the deflection. `deadband` is the deflection below which the hand stays still. `thinking` is the time to read and
    understand a new instruction.
    """

    kind: Kind = "script"
    reaction_time: ReactionTime = Time(0.25)
    gain: Annotated[float, Bounds(0.01, 10.0, "people reach 3 to 5 rad/s with fast displays")] = 0.5
    lag: Annotated[Time, Bounds(0.0, 2.0, "muscles need 0.1 to 0.2 s")] = Time(0.1)
    noise: Annotated[float, Bounds(0.0, 1.0, "1 is as large as the deflection")] = 0.1
    deadband: Annotated[float, Bounds(0.0, 0.5, "1 is the full deflection")] = 0.05
    thinking: Annotated[Time, Bounds(0.0, 60.0, "an instruction has one or two sentences")] = Time(2.0)


def spec_of(kind: str) -> OperatorSpec:
    """Return the parameters of a kind of operator with its usual limits.

    Raises:
        InputError: the kind is not ``perfect`` or ``human``.
    """
    if kind not in get_args(Kind) or kind == "script":
        raise InputError(f"operator: got {kind!r}, expected perfect or human")
    return OperatorSpec(cast("Kind", kind))
