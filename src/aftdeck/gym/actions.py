"""Check of an environment's actions; a stick or a switch outside its travel is rejected or clipped."""

from __future__ import annotations

from collections.abc import Sequence
from typing import cast

import numpy as np

from aftdeck.errors import InputError
from aftdeck.gym.terms import Control, Floats32


def shaped(given: object, controls: Sequence[Control], count: int) -> Floats32:
    """Return the actions of `count` environments as an array (count, controls); for one also (controls,).

    Raises:
        InputError: they have another shape.
    """
    actions = np.ascontiguousarray(given, dtype=np.float32)
    if not actions.flags.writeable:  # such as one of JAX: the laws are compiled for arrays that can be written
        actions = actions.copy()
    expected = (count, len(controls))
    if actions.shape != expected and not (count == 1 and actions.shape == expected[1:]):
        raise InputError(f"action: got shape {actions.shape}, expected {expected[1:] if count == 1 else expected}")
    return actions.reshape(expected)


def clipped(given: object) -> Floats32:
    """Return actions whose finite numbers are in [-1, 1]: those beyond are at the end of their travel."""
    actions = np.array(given, dtype=np.float32)
    return np.clip(actions, -1.0, 1.0, out=actions, where=np.isfinite(actions))


def outside(actions: Floats32, controls: Sequence[Control]) -> InputError | None:
    """Return the error about a control outside [-1, 1]; None if all are inside.

    Args:
        actions: (n, controls) actions of n environments.
        controls: the controls.
    """
    inside = np.abs(actions) <= 1.0
    if inside.all():  # almost always, and quicker than to look for places
        return None
    row, column = np.argwhere(~inside)[0].tolist()
    where = f" in environment {row}" if len(actions) > 1 else ""
    remedy = "; with clip_actions=True, the environment clips it" if np.isfinite(actions[row, column]) else ""
    return InputError(
        f"action: {controls[column].name} is {actions[row, column]:g}{where}, expected a number in [-1, 1]{remedy}"
    )


def checked(given: object, controls: Sequence[Control]) -> list[float]:
    """Return the action of one environment as numbers in [-1, 1], one for each control.

    Raises:
        InputError: it has another shape, or a control is outside [-1, 1] or not a number.
    """
    plain = type(given) is np.ndarray and given.dtype == np.float32 and given.shape == (len(controls),)
    action = (
        cast("Floats32", given) if plain else shaped(given, controls, 1)[0]
    )  # a plain one takes a quarter of the time
    values: list[float] = action.tolist()
    if not all([-1.0 <= value <= 1.0 for value in values]) and (error := outside(action[None], controls)):
        raise error
    return values
