"""Arms with another number of joints, for functions that read only an arm's tables: names, limits, rates, servos."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from msgspec.structs import replace as replace_fields

from aftdeck.arrays import Array
from aftdeck.kinematics.arm import Arm
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame

NUMBERS = (1, 5, 7, 8)
"""Numbers of joints that differ from those of the built-in arms."""
BY_JOINT = ("angles", "rates", "angles_commanded", "rates_commanded", "rate_limits", "zones")
"""Fields of a frame with one value for each joint."""


def with_joints(arm: Arm, joints: int) -> Arm:
    """Return an arm whose tables repeat those of `arm` for this number of joints; its links stay those of `arm`."""
    model = arm.model

    def fit(values: Any) -> Any:
        return type(values)(*(np.resize(own, (joints, *own.shape[1:])) for own in values))

    servo, springs, master = model.servo, model.flexibility, model.master
    return Arm(
        replace(
            model,
            joints=tuple(f"joint_{k}" for k in range(joints)),
            labels=tuple(f"Joint {k}" for k in range(joints)),
            linkage=model.linkage._replace(slides=(False,) * joints),
            limits=fit(model.limits),
            rates=fit(model.rates),
            servo=None if servo is None else fit(servo),
            flexibility=None
            if springs is None
            else springs._replace(
                gearboxes=np.resize(springs.gearboxes, joints), friction=np.resize(springs.friction, joints)
            ),
            master=(*master, *(None,) * joints)[:joints],
        )
    )


def scenario_with_joints(scenario: Scenario, joints: int) -> Scenario:
    """Return a scenario with such an arm; it cannot be flown."""
    return replace(scenario, arm=with_joints(scenario.arm, joints))


def frame_with_joints(frame: Frame, joints: int) -> Frame:
    """Return a frame with other numbers for each joint: 0.1, 0.2 and so on, with zone 2 for the last joint."""
    values = tuple(0.1 * k for k in range(1, joints + 1))
    fields: dict[str, Any] = dict.fromkeys(BY_JOINT, values) | {"zones": (*(0,) * (joints - 1), 2)}
    dynamics = frame.dynamics
    if dynamics is not None:
        fields["dynamics"] = replace_fields(dynamics, torques=values, overdriven=(joints - 1,))
    return replace_fields(frame, **fields)


def random_arrays(seed: int, joints: int, *scales: float) -> list[Array]:
    """Return a random array (joints,) for each scale, with values up to this size."""
    rng = np.random.default_rng(seed)
    return [scale * rng.uniform(-1.0, 1.0, joints) for scale in scales]
