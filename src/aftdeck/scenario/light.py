"""Light in a run: directions to the sun and the Earth, lamps that are lit, exposures that are locked.

Light affects only pictures and is therefore not part of a simulation's state. The station stores the present light,
sends it to the pages and records it. A scenario gives the light at the start.
"""

from __future__ import annotations

from functools import cache
from itertools import chain
from pathlib import Path
from typing import Annotated

import msgspec

from aftdeck.arms.load import ArmModel
from aftdeck.bounds import DIRECTION, Bounds
from aftdeck.errors import InputError
from aftdeck.files import parse, read
from aftdeck.kinematics.payload import HeldPayload
from aftdeck.scenario.on_arm import arm_shapes
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import LightSpec
from aftdeck.shapes import switches
from aftdeck.worksite.model import Worksite
from aftdeck.worksite.payload import Payload

Colour = Annotated[str, msgspec.Meta(pattern=r"^#[0-9a-f]{6}$")]
Name = Annotated[str, msgspec.Meta(min_length=1, max_length=64)]
Strength = Annotated[float, Bounds(0.0, 1000.0, "full sunlight is 4.1 in the same units")]
Direction = tuple[Annotated[float, DIRECTION], Annotated[float, DIRECTION], Annotated[float, DIRECTION]]


class _Part(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A table of `light.toml`."""


class Glow(_Part, frozen=True):
    """Light from one side."""

    colour: Colour
    strength: Strength
    """Illuminance in relative units; full sunlight is 4.1."""


class SkyGlow(_Part, frozen=True):
    """Light from all sides."""

    above: Colour
    below: Colour
    """Colour of the half sphere below the orbiter; `above` is the colour of the half sphere above it."""
    strength: Strength


class LightCondition(_Part, frozen=True):
    """Directions to the sun and the Earth, and the light from them."""

    name: Name
    to_sun: Direction
    """Vector towards the sun, of any length, in the scene coordinate frame."""
    nadir: Direction
    """Vector towards the Earth's centre, of any length, in the scene coordinate frame."""
    sun: Glow
    earthshine: Glow
    sky: SkyGlow
    exposure: Annotated[float, Bounds(-20.0, 20.0, "20 stops are a factor of a million", "stops")]
    """Initial exposure of the cameras [photographic stops above the exposure for full sunlight]."""
    source: Annotated[str, msgspec.Meta(min_length=1)]


class LockedExposure(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Locked exposure of a camera. A locked exposure does not follow the brightness of the picture."""

    camera: Name
    stops: Annotated[float, msgspec.Meta(ge=-20.0, le=20.0)]
    """Exposure of the camera [photographic stops above the exposure for full sunlight]."""


class Lighting(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Present light: the condition, the lamps that are on, and the locked exposures."""

    condition: Name
    """Name of the condition, as in `LightCondition.name`."""
    lamps: Annotated[tuple[Name, ...], msgspec.Meta(max_length=32)]
    """Names of the switches that are on."""
    locked: Annotated[tuple[LockedExposure, ...], msgspec.Meta(max_length=64)] = ()


class LightFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Contents of `light.toml`."""

    condition: Annotated[tuple[LightCondition, ...], msgspec.Meta(min_length=1)]


@cache
def conditions() -> tuple[LightCondition, ...]:
    """Return the conditions that a scenario can name; the first is the default."""
    return parse(LightFile, read(Path(__file__).parent / "light.toml")).condition


def condition_named(name: str) -> LightCondition:
    """Return the light condition of a name.

    Raises:
        InputError: there is none; the message lists the conditions.
    """
    for condition in conditions():
        if condition.name == name:
            return condition
    raise InputError(f"no light condition {name!r}: there are {', '.join(one.name for one in conditions())}")


def lamps_of(
    worksite: Worksite, arm: ArmModel, payload: HeldPayload | None, payloads: tuple[Payload, ...]
) -> tuple[str, ...]:
    """Return the switches of all lamps of the worksite, the arm, the held payload and the worksite's payloads."""
    body_shapes = chain((body.shapes for body in worksite.bodies), arm_shapes(arm, worksite).values())
    payload_shapes = chain([payload.shapes] if payload else [], (item.shapes for item in payloads))
    return switches(chain.from_iterable(chain(body_shapes, payload_shapes)))


def lighting(problems: Problems, spec: LightSpec, lamps: tuple[str, ...]) -> Lighting:
    """Return a scenario's light; report a condition or lamps that do not exist."""
    names = [condition.name for condition in conditions()]
    condition = names[0] if spec.condition is None else spec.condition
    if condition not in names:
        problems.add(("light", "condition"), f"no light condition {condition!r}: there are {', '.join(names)}")
    for i, lamp in enumerate(spec.lamps or ()):
        if lamp not in lamps:
            choices = f"there are {', '.join(lamps)}" if lamps else "this scenario has none"
            problems.add(("light", "lamps", i), f"no lamp switch {lamp!r}: {choices}")
    return Lighting(condition, lamps if spec.lamps is None else tuple(name for name in lamps if name in spec.lamps))
