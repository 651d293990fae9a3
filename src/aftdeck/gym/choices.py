"""Keywords of the environments, and errors about them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeVar, get_args

from aftdeck.errors import InputError
from aftdeck.scenario.schema import Plant
from aftdeck.units import short

PLANTS: tuple[Plant, ...] = get_args(Plant)

_T = TypeVar("_T", bound=str)


def one_of(name: str, given: object, allowed: Iterable[_T]) -> _T:
    """Return the allowed value that equals `given`.

    Raises:
        InputError: there is none; the message lists the allowed values.
    """
    values = tuple(allowed)
    for value in values:
        if isinstance(given, str) and given == value:
            return value
    raise InputError(f"{name}: got {short(given)}, expected {', '.join(map(repr, values))}")


def whole(name: str, given: object, least: int) -> int:
    """Return a whole number of at least `least`.

    Raises:
        InputError: it is anything else.
    """
    if isinstance(given, int) and not isinstance(given, bool) and given >= least:
        return given
    raise InputError(f"{name}: got {short(given)}, expected a whole number, {least} or more")


def no_options(options: object, allowed: Iterable[str] = ()) -> None:
    """Check the options of a reset.

    Raises:
        InputError: an option is not allowed.
    """
    names = tuple(allowed)
    for name in options if isinstance(options, dict) else ():
        if name not in names:
            raise InputError(f"options: got {short(name)}, expected {' or '.join(map(repr, names)) or 'no options'}")


def rendered(render_mode: object, modes: Iterable[_T]) -> _T | None:
    """Return the render mode; None for an environment that shows nothing.

    Raises:
        InputError: the mode is not allowed.
    """
    return None if render_mode is None else one_of("render_mode", render_mode, modes)


def not_rendered() -> InputError:
    """Return the error about a picture of an environment that was made without pictures."""
    return InputError("render: the environment was made without pictures; make it with render_mode='rgb_array'")
