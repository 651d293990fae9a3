"""Payload in the grasp, and the steering's rules for this payload.

Both change at capture and release, and after a mechanism has moved the payload in the grasp. The rules also change with
the rate limits of the script's phase.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from aftdeck.arrays import Array
from aftdeck.kinematics.payload import HeldPayload
from aftdeck.scenario.limits import por_with
from aftdeck.scenario.model import RateLimits, Scenario
from aftdeck.state_part import Cache
from aftdeck.steering.rules import Key, Rules, rules_of

if TYPE_CHECKING:
    from aftdeck.simulation.operator.script import Kept


class SteeringSetup(Cache):
    """Payload in the grasp, and the steering's rules for it; `grasp.carried_by` derives both from the state.

    Attributes:
        payload: payload in the grasp, as the steering uses it; None if the grasp is empty.
        rules: the steering's rules by panel position, rate setting and steering law.
        sticks: stick inputs of the script's phase that were computed last; None if there are none.
    """

    def __init__(self, payload: HeldPayload | None, rules: dict[Key, Array]) -> None:
        self.payload = payload
        self.rules = rules
        self.sticks: Kept | None = None


def steering_setup(scenario: Scenario, payload: HeldPayload | None, limits: RateLimits | None = None) -> SteeringSetup:
    """Return the steering's setup.

    Args:
        scenario: the scenario.
        payload: payload in the grasp; None if the grasp is empty.
        limits: rate limits that replace the scenario's rate limits; None to keep the scenario's rate limits.
    """
    if payload is None:
        return SteeringSetup(None, _rules(scenario, limits, 0.0, b""))
    return SteeringSetup(payload, _rules(scenario, limits, payload.mass, payload.packed.tobytes()))


@lru_cache(maxsize=16)
def _rules(scenario: Scenario, limits: RateLimits | None, mass: float, packed: bytes) -> Rules:
    """Return the steering's rules; each episode of an environment begins with the same ones.

    Args:
        scenario: the scenario.
        limits: as for `steering_setup`.
        mass: mass of the payload in the grasp [kg]; 0 if the grasp is empty.
        packed: bytes of `HeldPayload.packed`; empty if the grasp is empty.
    """
    model, por, payload = scenario.arm.model, scenario.por, None
    if limits is not None:
        model, por = replace(model, rates=limits.joints), limits.por
    if packed:
        values = np.frombuffer(packed)
        payload = HeldPayload(mass, values[:9].reshape(3, 3), values[9:12], values[12:])
    return rules_of(
        model,
        por_with(model, mass, por),
        scenario.control_period,
        payload,
        strict=scenario.strict,
        guarded=scenario.guarded,
        as_flown=scenario.as_flown,
        near=scenario.near,
        near_turn=scenario.near_turn,
    )
