"""Check of text that a person enters on one line: a code, a condition, a name."""

from __future__ import annotations

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
