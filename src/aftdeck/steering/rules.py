"""Constants and limits of the steering laws: one `rules` array for each panel position, rate setting and law."""

from __future__ import annotations

from typing import Literal

import numpy as np

from aftdeck.arms.load import ArmModel, PorLimits
from aftdeck.arrays import Array
from aftdeck.elementary import sincos
from aftdeck.kinematics.linkage import LINKS
from aftdeck.kinematics.payload import HeldPayload
from aftdeck.matrices import product
from aftdeck.steering.layout import (
    AS_FLOWN,
    DT,
    GUARDED,
    HAND_COSINE,
    HAND_SINE,
    HELD,
    HIGH,
    JOINTS,
    LOW,
    MOST_UP,
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
    TOGETHER,
    TURN,
    TURN_UP,
)
from aftdeck.steering.mode import MODES, Mode
from aftdeck.tuples import MOST_JOINTS

Rate = Literal["coarse", "vernier"]
SETTINGS: tuple[Rate, ...] = ("coarse", "vernier")
"""Rate settings by their numbers."""
Key = tuple[str, Rate, int]
"""Panel position, rate setting and steering law."""

POSITION_LAW = 1
"""The report's mode 1, which commands joint rates in the automatic panel positions."""


def rules_of(
    arm: ArmModel,
    por: PorLimits,
    control_period: float,
    payload: HeldPayload | None = None,
    *,
    strict: bool = False,
    guarded: bool = True,
    as_flown: bool = False,
    near: float = 1e-4,
    near_turn: float = 2e-5,
) -> Rules:
    """Return the rules of every panel position, rate setting and steering law.

    The rate setting, coarse or vernier, selects the POR limits. In modes 1 and 8, DIRECT and MASTER it also selects the
    joint rate limits. In modes 2 to 7, and under `strict` in mode 1, the joint rate limits are the servo maxima. With a
    payload, the coarse and vernier joint rates are lower, in proportion to the POR's speed limit (assumed). The
    accelerations are computed from the coarse limits in both settings.
    """
    joints, tail = len(arm.joints), len(arm.links) - LINKS
    shared = np.zeros(RULES + tail)
    shared[:LINKS], shared[RULES:] = arm.links[:LINKS], arm.links[LINKS:]
    shared[JOINTS] = joints
    shared[DT], shared[STRICT], shared[GUARDED], shared[AS_FLOWN] = control_period, strict, guarded, as_flown
    shared[SPEED_UP], shared[TURN_UP] = por.acceleration, por.angular_acceleration
    shared[MOST_UP : MOST_UP + MOST_JOINTS] = np.inf
    shared[MOST_UP : MOST_UP + joints] = arm.rates.acceleration
    shared[MOUNT : MOUNT + 9] = arm.mount.rotation.T.ravel()
    shared[HAND_SINE], shared[HAND_COSINE] = sincos(arm.end_effector_roll)
    shared[NEAR], shared[NEAR_TURN] = near, near_turn
    shared[HELD : HELD + 9] = np.eye(3).ravel() if payload is None else payload.rotation.ravel()
    share = min(por.translation[0] / arm.por_limits(0.0).translation[0], 1.0)
    return Rules(arm, por, payload, shared, share, strict=strict)


class Rules(dict[Key, Array]):
    """Rules by panel position, rate setting and law; each is made when it is asked for first.

    Arguments of the constructor are those of `rules_of`, what all rules have in common, and the share of its joint
    rates that an arm with the payload has.
    """

    def __init__(
        self, arm: ArmModel, por: PorLimits, payload: HeldPayload | None, shared: Array, share: float, *, strict: bool
    ) -> None:
        super().__init__()
        self._arm, self._por, self._payload = arm, por, payload
        self._shared, self._share, self._strict = shared, share, strict

    def __missing__(self, key: Key) -> Array:
        """Return the rules of a panel position, rate setting and law, and keep them.

        Raises:
            KeyError: there is no such position, setting or law.
        """
        position, rate, law = key
        mode = MODES[position]
        if rate not in SETTINGS or law not in mode.laws:
            raise KeyError(key)
        arm, por, share, setting = self._arm, self._por, self._share, SETTINGS.index(rate)
        joints, rules = len(arm.joints), self._shared.copy()
        rules[SPEED], rules[TURN] = por.translation[setting], por.rotation[setting]
        if _by_joint(mode, law, self._strict):
            fastest = share * arm.rates.coarse
            rules[RATE : RATE + joints] = share * (arm.rates.coarse if rate == "coarse" else arm.rates.vernier)
        else:
            fastest = rules[RATE : RATE + joints] = arm.rates.servo
        rules[RATE_UP : RATE_UP + joints] = fastest * (por.acceleration / por.translation[0])
        stops = arm.limits.hard if mode.kind == "single" else arm.limits.soft
        rules[TOGETHER] = mode.kind == "manual"
        rules[LOW : LOW + joints], rules[HIGH : HIGH + joints] = stops[:, 0], stops[:, 1]
        if mode.loaded and self._payload is not None and not self._strict:
            payload = self._payload
            rules[OFFSET : OFFSET + 3] = product(payload.rotation, payload.centre + payload.por)
        rules.setflags(write=False)
        self[key] = rules
        return rules


def _by_joint(mode: Mode, law: int, strict: bool) -> bool:
    """Return whether the coarse or vernier joint rates limit the joints; if not, the servo maxima do."""
    return mode.kind in ("single", "master") or (law == POSITION_LAW and not strict)
