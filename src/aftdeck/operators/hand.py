"""The limits of a human hand: reaction time, lag, noise and deadband between what the operator wants and the sticks.

The model is the crossover model of McRuer and Krendel ("Mathematical Models of Human Pilot Behavior", AGARDograph 188,
1974): a gain, an effective delay, and a first-order lag of nerves and muscles, with a remnant that grows with the
deflection. The gain is in `approach`, which makes speeds of distances.
"""

from __future__ import annotations

import math
from collections import deque
from typing import cast

import msgspec
import numpy as np

from aftdeck.operators.spec import OperatorSpec
from aftdeck.simulation.inputs import Inputs
from aftdeck.tuples import Vec3

_NOISE_S = 0.2
"""Time constant of the remnant [s]; assumed: the noise lies within the bandwidth of the hand."""


class Hand:
    """Hand that moves the sticks of one run.

    Args:
        spec: parameters of the operator.
        seed: seed of the noise.
        period_s: control period [s].
    """

    def __init__(self, spec: OperatorSpec, seed: int, period_s: float) -> None:
        self._spec = spec
        self._late = deque([Inputs()] * round(float(spec.reaction_time) / period_s))
        self._follows = period_s / (period_s + float(spec.lag))
        self._fades = math.exp(-period_s / _NOISE_S)
        self._random = np.random.Generator(np.random.PCG64(seed))
        self._at, self._noise = np.zeros(11), np.zeros(11)

    def moved(self, wanted: Inputs) -> Inputs:
        """Return the inputs of this step, if the operator wants `wanted` from now on."""
        self._late.append(wanted)
        now = self._late.popleft()
        sticks = np.array([*now.translation, *now.rotation, *now.orbiter, now.drive, now.telescope])
        self._at += self._follows * (sticks - self._at)
        fresh = self._random.standard_normal(11)
        self._noise = self._fades * self._noise + math.sqrt(1.0 - self._fades**2) * fresh
        noisy = self._at * (1.0 + self._spec.noise * self._noise)
        noisy[np.abs(noisy) < self._spec.deadband] = 0.0
        held = np.clip(noisy, -1.0, 1.0).tolist()
        return msgspec.structs.replace(
            now,
            translation=_three(held[0:3]),
            rotation=_three(held[3:6]),
            orbiter=_three(held[6:9]),
            drive=held[9],
            telescope=held[10],
        )


def _three(values: list[float]) -> Vec3:
    return cast("Vec3", tuple(values))
