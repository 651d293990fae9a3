"""Text on one line: check of text that a person enters, and output that a terminal shows without obeying it."""

from __future__ import annotations

import sys
from typing import TextIO

from aftdeck.errors import InputError


def one_line(what: str, text: str, most: int) -> str:
    """Return the text unchanged if it is one line of visible characters.

    Args:
        what: name of the text in the error message, such as ``a name``.
        text: the text to check.
        most: maximum number of characters.

    Raises:
        InputError: the text is empty or too long, begins or ends with a space, or contains unprintable characters such
            as line breaks.
    """
    if not text.strip():
        raise InputError(f"{what} must have at least one visible character, got {text!r}")
    if len(text) > most:
        raise InputError(f"{what} may have {most} characters at most, got {len(text)}: {text[:most]!r}…")
    if not text.isprintable():
        raise InputError(f"{what} must be one line of visible characters and plain spaces, got {text!r}")
    if text != text.strip():
        raise InputError(f"{what} must not begin or end with a space, got {text!r}")
    return text


def visible(text: str) -> str:
    r"""Return a text as one line of visible characters.

    A control character, a line break and a mark of the writing direction are replaced by their escapes (``\x1b``), so
    that a text from a file or a client can neither control the terminal nor look like other lines of the output.
    """
    if text.isprintable():
        return text
    return "".join(
        character if character.isprintable() else character.encode("unicode_escape").decode() for character in text
    )


def print_line(text: str = "", file: TextIO | None = None) -> None:
    """Print a text as one line of visible characters.

    Args:
        text: the text; the whole text may come from a file or a client.
        file: stream to which the line is written; None: standard output.
    """
    print(visible(text), file=file or sys.stdout, flush=True)


def print_error(text: str) -> None:
    """Print a problem as one line on standard error, after the name of the program."""
    print_line(f"aftdeck: {text}", sys.stderr)
