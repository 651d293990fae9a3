"""Autopilots of `aftdeck fly`: a policy file, or a synthetic operator."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from aftdeck.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable

    from aftdeck.scenario.model import Scenario
    from aftdeck.station.core.autopilot import Autopilot, Autopilots


def policy_flight(
    file: Path, scenario: str | None, seed: int | None, plant: str | None
) -> tuple[Callable[[], Scenario], Autopilots]:
    """Return the function that loads the scenario of a policy file, and the policy as autopilot.

    Raises:
        InputError: the file is not a policy file.
    """
    from aftdeck.gym.flight import pilot_of_policy, scenario_of_policy
    from aftdeck.gym.policy_file import load_policy
    from aftdeck.station.core.autopilot import Autopilot

    policy = load_policy(file)

    def load() -> Scenario:
        loaded = scenario_of_policy(policy, scenario, 0 if seed is None else seed, plant)
        pilot_of_policy(policy, loaded)  # an error of the first scenario ends the start of the station
        return loaded

    def autopilots(flown: Scenario) -> Autopilot | None:
        try:
            return Autopilot("policy", pilot_of_policy(policy, flown))
        except InputError:  # another scenario that was chosen on the page, which the policy cannot fly
            return None

    return load, autopilots


def operator_flight(kind: str, seed: int | None) -> Autopilots:
    """Return a synthetic operator as autopilot of each scenario that has steps.

    Raises:
        InputError: the kind is not ``perfect`` or ``human``.
    """
    from aftdeck.operators.pilot import pilot
    from aftdeck.operators.spec import spec_of
    from aftdeck.station.core.autopilot import Autopilot

    spec = spec_of(kind)

    def autopilots(flown: Scenario) -> Autopilot | None:
        own = flown.seed if seed is None else seed
        return Autopilot("synthetic operator", lambda: pilot(flown, spec, own)) if flown.steps else None

    return autopilots
