"""Tables in a document that are generated from the source code, between two marks."""

from __future__ import annotations

import sys
from pathlib import Path

from aftdeck.errors import InputError

BEGIN, END = "<!-- made from the types: begin -->\n", "<!-- made from the types: end -->\n"


def renewed(text: str, tables: str) -> str:
    """Return a document with other tables between its marks.

    Raises:
        InputError: the document does not have the begin mark, or has no end mark after it.
    """
    before, begin, rest = text.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not begin or not end:
        raise InputError(f"the document must have {BEGIN.strip()} and, after it, {END.strip()}")
    return f"{before}{BEGIN}\n{tables}\n{END}{after}"


def renew_file(tables: str) -> None:
    """Renew the tables of the file that the command line names; with ``--check``, exit with 1 if they would change."""
    *flags, name = sys.argv[1:]
    file = Path(name)
    text = file.read_text(encoding="utf-8")
    new = renewed(text, tables)
    if flags == ["--check"]:
        sys.exit(0 if new == text else f"{name} does not agree with the source code; run `make generate`")
    file.write_text(new, encoding="utf-8")
