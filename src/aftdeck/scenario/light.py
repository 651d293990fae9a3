"""Light as a condition of a flight: where sun and Earth stand, which lamps are lit, which exposures are locked.

Nothing in flight depends on it but what people see. So it is no part of a simulation's state: the station holds it,
tells its pages and records it, and a scenario says how it is at the start.
"""

from __future__ import annotations

from functools import cache
from itertools import chain
from pathlib import Path
from typing import Annotated

import msgspec

from aftdeck.arms.load import ArmModel
from aftdeck.arms.shapes import shapes_of
from aftdeck.files import parse, read
from aftdeck.kinematics.payload import Payload
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import LightSpec
from aftdeck.shapes import switches
from aftdeck.worksite.model import Cargo, Worksite

Vec3 = tuple[float, float, float]
Colour = Annotated[str, msgspec.Meta(pattern=r"^#[0-9a-f]{6}$")]
Name = Annotated[str, msgspec.Meta(min_length=1, max_length=64)]
Strength = Annotated[float, msgspec.Meta(ge=0.0)]


class _Part(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A part of the file of conditions."""


class Glow(_Part, frozen=True):
    """Light from one side."""

    colour: Colour
    strength: Strength
    """[lx], in the scale in which full sunlight is 4.1 lx."""


class SkyGlow(_Part, frozen=True):
    """Light from all sides."""

    above: Colour
    below: Colour
    """Of the half spheres above and below the orbiter."""
    strength: Strength


class LightCondition(_Part, frozen=True):
    """Where sun and Earth stand, and what comes from them."""

    name: Name
    to_sun: Vec3
    """Direction in the scene, of any length."""
    nadir: Vec3
    """Direction to the Earth's centre in the scene, of any length."""
    sun: Glow
    earthshine: Glow
    sky: SkyGlow
    exposure: float
    """Where the cameras' exposure begins [stops over that of full sunlight]."""
    source: Annotated[str, msgspec.Meta(min_length=1)]


class LockedExposure(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A camera that does not follow its picture's brightness."""

    camera: Name
    stops: Annotated[float, msgspec.Meta(ge=-20.0, le=20.0)]
    """Its exposure [stops over that of full sunlight]."""


class Lighting(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How the light stands."""

    condition: Name
    """As `LightCondition.name`."""
    lamps: Annotated[tuple[Name, ...], msgspec.Meta(max_length=32)]
    """The switches that are on."""
    locked: Annotated[tuple[LockedExposure, ...], msgspec.Meta(max_length=64)] = ()


class _File(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`light.toml` as it is written."""

    condition: Annotated[tuple[LightCondition, ...], msgspec.Meta(min_length=1)]


@cache
def conditions() -> tuple[LightCondition, ...]:
    """The conditions that a scenario can name, the first being the usual one."""
    return parse(_File, read(Path(__file__).parent / "light.toml")).condition


def lamps_of(worksite: Worksite, arm: ArmModel, payload: Payload | None, cargo: tuple[Cargo, ...]) -> tuple[str, ...]:
    """The switches of all lamps that are there: the worksite's, the arm's, those of what it holds and can take."""
    bodies = chain((body.shapes for body in worksite.bodies), shapes_of(arm).bodies.values())
    carried = chain([payload.shapes] if payload else [], (one.shapes for one in cargo))
    return switches(chain.from_iterable(chain(bodies, carried)))


def lighting(problems: Problems, spec: LightSpec, lamps: tuple[str, ...]) -> Lighting:
    """A scenario's light, of these lamps; what there is not is noted."""
    names = [condition.name for condition in conditions()]
    condition = names[0] if spec.condition is None else spec.condition
    if condition not in names:
        problems.wrong(("light", "condition"), f"no condition of light {condition!r}: there are {', '.join(names)}")
    for i, lamp in enumerate(spec.lamps or ()):
        if lamp not in lamps:
            there = f"there are {', '.join(lamps)}" if lamps else "this place has none"
            problems.wrong(("light", "lamps", i), f"no lamps {lamp!r}: {there}")
    return Lighting(condition, lamps if spec.lamps is None else tuple(one for one in lamps if one in spec.lamps))
