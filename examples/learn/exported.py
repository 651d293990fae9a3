"""Export of a network of torch as a policy of Aftdeck."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import torch

from aftdeck.gym.policy import Activation, Layer, Policy


def exported(
    environment: str, modules: Iterable[torch.nn.Module], activation: Activation, mean: Any, std: Any
) -> Policy:
    """Return the policy of the linear layers in `modules`, with `activation` between two of them."""
    linear = [module for module in modules if isinstance(module, torch.nn.Linear)]
    arrays = [tuple(p.detach().numpy().astype(np.float64) for p in (each.weight, each.bias)) for each in linear]
    return Policy(environment, activation, np.asarray(mean), np.asarray(std), tuple(Layer(*each) for each in arrays))
