"""Words that a person gives on one line: a code, a condition, a name."""

from __future__ import annotations

from aftdeck.errors import InputError


def one_line(what: str, text: str, most: int) -> str:
    """The text as it was given, if it can stand on one line and be read there.

    Args:
        what: what it is, for the error: ``a name``.
        text: as given.
        most: characters that it may have.

    Raises:
        InputError: nothing, too much, spaces at an end, or signs that cannot be seen, line breaks among them.
    """
    if not text.strip():
        raise InputError(f"{what} needs at least one letter or digit, got {text!r}")
    if len(text) > most:
        raise InputError(f"{what} has {most} characters at most, got {len(text)}: {text[:most]!r}…")
    if not text.isprintable():
        raise InputError(
            f"{what} stands on one line, of letters, digits, signs and plain spaces; got {text!r}, with signs that "
            "cannot be seen"
        )
    if text != text.strip():
        raise InputError(f"{what} begins and ends without a space, got {text!r}")
    return text
