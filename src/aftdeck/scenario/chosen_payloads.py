"""Selection of the worksite's payloads that are present in a scenario, with the start of each payload."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec

from aftdeck.arms.geometry import frozen
from aftdeck.scenario.problems import Problems
from aftdeck.scenario.schema import CargoSpec
from aftdeck.worksite.file.payload import start_of
from aftdeck.worksite.model import Worksite
from aftdeck.worksite.payload import Payload


def present_payloads(problems: Problems, worksite: Worksite | None, specs: Sequence[CargoSpec]) -> tuple[Payload, ...]:
    """Return the worksite's payloads that a scenario lists.

    A mass, its distribution or a start pose that the scenario gives for a payload replace those of the worksite's
    file.
    """
    if worksite is None:
        return ()
    available = {payload.name: payload for payload in worksite.payloads}
    berths = {berth.name: berth for berth in worksite.berths}
    present: list[Payload] = []
    for i, spec in enumerate(specs):
        if spec.name not in available:
            choices = f"it has {', '.join(available)}" if available else "it has none"
            problems.add(("cargo", i, "name"), f"worksite {worksite.name} has no cargo {spec.name!r}: {choices}")
            continue
        if any(payload.name == spec.name for payload in present):
            problems.add(("cargo", i, "name"), f"{spec.name!r} is listed twice; list each payload once")
            continue
        payload = available[spec.name]
        if spec.mass is not None and spec.mass <= 0.0:
            problems.add(("cargo", i, "mass"), f"has to be above 0, got {spec.mass:g} kg")
        elif spec.mass is not None:
            inertia = frozen(payload.inertia * spec.mass / payload.mass)
            payload = msgspec.structs.replace(payload, mass=float(spec.mass), inertia=inertia)
        if why := spec.tensor_problem():
            problems.add(("cargo", i, "inertia"), why)
        elif (given := spec.tensor()) is not None:
            payload = msgspec.structs.replace(payload, inertia=frozen(given))
        if (centre := spec.mass_centre()) is not None:
            payload = msgspec.structs.replace(payload, centre_of_mass=frozen(centre))
        if spec.start is not None:
            try:
                payload = msgspec.structs.replace(
                    payload, start=start_of(spec.start, berths, payload.probe, payload.trunnions)
                )
            except ValueError as error:
                problems.add(("cargo", i, "start"), str(error))
        present.append(payload)
    occupied = [payload.start.berth for payload in present if payload.start.berth]
    for berth in sorted({berth for berth in occupied if occupied.count(berth) > 1}):
        what = f"the berth {berth!r} holds one payload, but {occupied.count(berth)} payloads start in it"
        problems.add(("cargo",), what)
    return tuple(present)
