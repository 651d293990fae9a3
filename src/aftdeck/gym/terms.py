"""Definitions of what an environment accepts, observes and rewards; its spaces and the document's tables read them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

Floats32 = NDArray[np.float32]


class Observed(NamedTuple):
    """A group of observed numbers.

    Attributes:
        name: name of the group, for the tables.
        size: number of its values.
        definition: what it is, and where an operator sees it.
        unit: unit before the division; empty for a pure number.
        scale: values that are normalised to 1, one for all or one for each; as a text for the tables.
        limit: greatest magnitude after the division.
        reading: name of the reading that it shows; empty for none.
    """

    name: str
    size: int
    definition: str
    unit: str
    scale: str
    limit: float
    reading: str = ""


class Control(NamedTuple):
    """One element of an action: a stick or a switch, in [-1, 1].

    Attributes:
        name: name of the stick's axis or of the switch.
        definition: its effect.
    """

    name: str
    definition: str


class Rewarded(NamedTuple):
    """A term of the reward.

    Attributes:
        name: name of the term.
        weight: reward for one unit.
        unit: unit of what is rewarded.
        definition: what is rewarded.
    """

    name: str
    weight: float
    unit: str
    definition: str


def observation_space(groups: Sequence[Observed]) -> spaces.Box[np.float32]:
    """Return the space of the observations: one number for each value of each group."""
    limits = np.concatenate([np.full(group.size, group.limit, dtype=np.float32) for group in groups])
    return spaces.Box(-limits, limits, dtype=np.float32)


def action_space(controls: Sequence[Control]) -> spaces.Box[np.float32]:
    """Return the space of the actions: one number in [-1, 1] for each control."""
    return spaces.Box(-1.0, 1.0, (len(controls),), dtype=np.float32)
