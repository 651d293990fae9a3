"""Policy: a trained multilayer perceptron and the environment that it flies. It needs NumPy only, no learning library.

`policy_file` reads and writes policies.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal, NamedTuple, get_args

import numpy as np

from aftdeck.arrays import Array
from aftdeck.errors import InputError
from aftdeck.gym.choices import one_of
from aftdeck.gym.mission.definition import MISSIONS, observations
from aftdeck.gym.reach import definition as reach
from aftdeck.gym.terms import Floats32, Observed
from aftdeck.tuples import MOST_JOINTS

MAX_LAYERS = 32
"""Greatest number of layers; assumed."""

Activation = Literal["tanh", "relu"]
"""Function between two layers; the last layer is linear."""


def _count(groups: Sequence[Observed]) -> int:
    return sum(group.size for group in groups)


class Sizes(NamedTuple):
    """Sizes of an environment.

    Attributes:
        observations: numbers of observations that it can have: one for Reach, whose arm has six joints; else, those for
            an arm with one joint, with two joints, and so on.
        actions: number of actions.
    """

    observations: tuple[int, ...]
    actions: int


SIZES: Mapping[str, Sizes] = MappingProxyType(
    {reach.ID: Sizes((_count(reach.OBSERVATIONS),), len(reach.CONTROLS))}
    | {
        id: Sizes(tuple(_count(observations(n)) for n in range(1, MOST_JOINTS + 1)), len(one.controls))
        for id, one in MISSIONS.items()
    }
)
"""Sizes of each environment, by its id."""


class Layer(NamedTuple):
    """One layer: output = weight @ input + bias.

    Attributes:
        weight: (outputs, inputs).
        bias: (outputs,).
    """

    weight: Array
    bias: Array


@dataclass(frozen=True, eq=False)
class Policy:
    """A multilayer perceptron, from an environment's observation to its action.

    Attributes:
        environment: id of the environment.
        activation: function between two layers.
        mean: (observations,) subtracted from an observation.
        std: (observations,) divides the difference.
        layers: layers in order; the output of the last one, clipped to [-1, 1], is the action.
        keywords: keywords with which the environment is made, such as ``plant``.
    """

    environment: str
    activation: Activation
    mean: Array
    std: Array
    layers: tuple[Layer, ...]
    keywords: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))

    def act(self, observation: Floats32 | Array) -> Floats32:
        """Return the action (actions,) for an observation (observations,), or one for each row (n, observations).

        Raises:
            InputError: the action is not finite. Finite weights can be so great that a sum is infinite.
        """
        with np.errstate(over="ignore", invalid="ignore"):
            value = (np.asarray(observation, dtype=np.float64) - self.mean) / self.std
            for weight, bias in self.layers[:-1]:
                value = value @ weight.T + bias
                value = np.tanh(value) if self.activation == "tanh" else np.maximum(value, 0.0)
            weight, bias = self.layers[-1]
            action = np.clip(value @ weight.T + bias, -1.0, 1.0)
        if not np.isfinite(action).all():
            raise InputError(f"the policy for {self.environment} gives an action that is not a number")
        return action.astype(np.float32)


def check_policy(policy: Policy, where: str) -> None:
    """Check that the environment exists, and that all arrays fit to it and to each other.

    Args:
        policy: the policy.
        where: name of its file, for the message.

    Raises:
        InputError: it does not; the message states what was given and what is expected.
    """
    environment = one_of(f"{where}: environment", policy.environment, SIZES)
    one_of(f"{where}: activation", policy.activation, get_args(Activation))
    for name in policy.keywords:
        one_of(f"{where}: keyword", name, ("plant",) if environment == reach.ID else ("plant", "scenario"))
    sizes, actions = SIZES[environment]
    if not 1 <= len(policy.layers) <= MAX_LAYERS:
        raise InputError(f"{where}: got {len(policy.layers)} layers, expected 1 to {MAX_LAYERS}")
    size = policy.mean.size if policy.mean.size in sizes else sizes[-1]
    for name, array in (("mean", policy.mean), ("std", policy.std)):
        if array.shape != (size,):
            allowed = " or ".join(f"({n},)" for n in (sizes if name == "mean" else (size,)))
            raise InputError(f"{where}: {name} has shape {array.shape}, expected {allowed} for {environment}")
    if not (policy.std > 0.0).all():
        raise InputError(f"{where}: std has the value {policy.std.min():g}, expected numbers above 0")
    for k, (weight, bias) in enumerate(policy.layers):
        if weight.shape != (bias.size, size) or bias.shape != (bias.size,):
            raise InputError(
                f"{where}: weight_{k} has shape {weight.shape} and bias_{k} {bias.shape}, expected (outputs, {size}) "
                "and (outputs,)"
            )
        size = len(bias)
    if size != actions:
        raise InputError(f"{where}: the last layer gives {size} numbers, expected {actions} for {environment}")
