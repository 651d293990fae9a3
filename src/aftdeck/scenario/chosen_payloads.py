"""Selection of the worksite's payloads that a scenario has, and where they start."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec

from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import CargoSpec
from aftdeck.worksite.file.cargo import start_of
from aftdeck.worksite.model import Cargo, Worksite


def present_cargo(problems: Problems, worksite: Worksite | None, specs: Sequence[CargoSpec]) -> tuple[Cargo, ...]:
    """Return the worksite's payloads that a scenario lists, with the mass and the start that the scenario gives."""
    if worksite is None:
        return ()
    offered = {one.name: one for one in worksite.cargoes}
    seats = {seat.name: seat for seat in worksite.seats}
    found: list[Cargo] = []
    for i, spec in enumerate(specs):
        if spec.name not in offered:
            there = f"it has {', '.join(offered)}" if offered else "it has none"
            problems.add(("cargo", i, "name"), f"worksite {worksite.name} has no cargo {spec.name!r}: {there}")
            continue
        if any(one.name == spec.name for one in found):
            problems.add(("cargo", i, "name"), f"{spec.name!r} is listed twice; each is there once")
            continue
        one = offered[spec.name]
        if spec.mass is not None and spec.mass <= 0.0:
            problems.add(("cargo", i, "mass"), f"is above 0, got {spec.mass:g} kg")
        elif spec.mass is not None:
            one = msgspec.structs.replace(one, mass=float(spec.mass))
        if spec.start is not None:
            try:
                one = msgspec.structs.replace(one, start=start_of(spec.start, seats, one.probe, one.trunnions))
            except ValueError as error:
                problems.add(("cargo", i, "start"), str(error))
        found.append(one)
    taken = [one.start.seat for one in found if one.start.seat]
    for seat in sorted({seat for seat in taken if taken.count(seat) > 1}):
        problems.add(("cargo",), f"the seat {seat!r} can hold one cargo, {taken.count(seat)} start in it")
    return tuple(found)
