"""Libraries of the extras of Aftdeck, imported when something needs them."""

from __future__ import annotations

import importlib
from types import ModuleType

from aftdeck.errors import InputError


def needed(module: str, extra: str = "study") -> ModuleType:
    """Return a module of an optional library.

    Raises:
        InputError: the library is not installed; the message tells how to install it.
    """
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        library = module.partition(".")[0]
        if error.name is None or error.name.partition(".")[0] != library:
            raise
        raise InputError(
            f"this needs {library}, which is not installed; install it with `pip install 'aftdeck[{extra}]'`"
        ) from None
