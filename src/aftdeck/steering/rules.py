"""The `rules` array of each mode and rate setting: what the steering laws have to keep to."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from aftdeck.arms.load import ArmModel, PorLimits
from aftdeck.kinematics.payload import Payload
from aftdeck.steering.layout import (
    AS_FLOWN,
    DT,
    HAND,
    HELD,
    HIGH,
    LOW,
    MOUNT,
    NEAR,
    NEAR_TURN,
    OFFSET,
    RATE,
    RATE_UP,
    RULES,
    SPEED,
    SPEED_UP,
    STRICT,
    TURN,
    TURN_UP,
)
from aftdeck.steering.mode import MODES

Array = NDArray[np.float64]
Rate = Literal["coarse", "vernier"]


def rules_of(
    arm: ArmModel,
    por: PorLimits,
    control_period: float,
    payload: Payload | None = None,
    *,
    strict: bool = False,
    as_flown: bool = False,
    near: float = 1e-4,
    near_turn: float = 2e-5,
) -> dict[tuple[str, Rate], Array]:
    """The rules of every mode (by panel position) and rate setting.

    Coarse and vernier choose the POR limits in computed modes, whose joints are held to the servo maxima, and
    the joint rates in SINGLE, DIRECT and MASTER. With a payload these rates fall as the POR's speed does, so that the
    tip is no faster than its limits mean it to be (assumed). Accelerations are those of the coarse limits, reached in
    the POR's time, with either setting.
    """
    loaded = por.translation[0] / arm.por_limits(0.0).translation[0]
    result: dict[tuple[str, Rate], Array] = {}
    for position, mode in MODES.items():
        for setting, rate in enumerate[Rate](("coarse", "vernier")):
            rules = np.zeros(RULES)
            rules[: len(arm.links)] = arm.links
            rules[DT], rules[STRICT], rules[AS_FLOWN] = control_period, strict, as_flown
            rules[SPEED], rules[TURN] = por.translation[setting], por.rotation[setting]
            rules[SPEED_UP] = por.translation[0] / por.reached_in
            rules[TURN_UP] = por.rotation[0] / por.reached_in
            by_joint = mode.kind in ("single", "master")
            stops = arm.limits.hard if mode.kind == "single" else arm.limits.soft
            own = min(loaded, 1.0) * (arm.rates.coarse if rate == "coarse" else arm.rates.vernier)
            rules[RATE : RATE + 6] = own if by_joint else arm.rates.servo
            fastest = min(loaded, 1.0) * arm.rates.coarse if by_joint else arm.rates.servo
            rules[RATE_UP : RATE_UP + 6] = fastest / por.reached_in
            rules[LOW : LOW + 6], rules[HIGH : HIGH + 6] = stops[:, 0], stops[:, 1]
            rules[MOUNT : MOUNT + 9] = arm.mount.rotation.T.ravel()
            rules[HAND], rules[HAND + 1] = math.cos(arm.end_effector_roll), math.sin(arm.end_effector_roll)
            rules[NEAR], rules[NEAR_TURN] = near, near_turn
            rules[HELD : HELD + 9] = np.eye(3).ravel() if payload is None else payload.rotation.ravel()
            if mode.loaded and payload is not None and not strict:
                rules[OFFSET : OFFSET + 3] = payload.rotation @ (payload.centre + payload.por)
            rules.setflags(write=False)
            result[position, rate] = rules
    return result
