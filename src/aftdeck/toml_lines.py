"""Line numbers in a TOML text: the line on which each table, key and list item begins; and limits of a text.

`tomllib` returns values without their lines. This scanner reads the same grammar (TOML 1.0), only to find lines. The
text must be one that `tomllib` has already accepted, because the scanner reports no errors.
"""

from __future__ import annotations

import re
import tomllib
from bisect import bisect_right
from dataclasses import dataclass, field
from functools import lru_cache

_SPACE = re.compile(r"[ \t]*")
_GAP = re.compile(r"(?:[ \t\r\n]+|#[^\n]*)*")
"""White space and comments, which separate expressions and the items of a list."""
_STRING = re.compile(
    r'"""(?:[^\\]|\\.)*?"{3,5}'  # the last three quotes end the string; one or two more before these are content
    r"|'''.*?'{3,5}"
    r'|"[^"\\]*(?:\\.[^"\\]*)*"'
    r"|'[^']*'",
    re.DOTALL,
)
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")
_SCALAR = re.compile(r"[^,\]}#\n]+")
"""A number, boolean or date, with the blanks that follow it."""


MOST = {"=": 60_000, ",": 60_000, "[": 10_000}
"""Greatest number of these signs in a text, that is, of keys, items and tables; a built-in file has 1,800 at most."""
MOST_PARTS = 30
"""Greatest number of parts of a dotted key: `tomllib` needs a time that grows with the square of this number."""
_LONG_KEY = re.compile(
    r"""(?<![A-Za-z0-9_-])(?:(?:[A-Za-z0-9_-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+)"""  # a part and a dot
    f"{{{MOST_PARTS}}}"
)


def excess(text: str) -> str:
    """Return why a TOML text is too large to be parsed in a short time; empty if it is not.

    Dots within a string count as dots of a key.
    """
    for sign, most in MOST.items():
        if (count := text.count(sign)) > most:
            return f"has {count} signs {sign!r}; at most {most} are allowed"
    if (key := _LONG_KEY.search(text)) is not None:
        line = text.count("\n", 0, key.start()) + 1
        return f"line {line}: a key has more than {MOST_PARTS} parts"
    return ""


@dataclass(slots=True)
class Located:
    """A table, list or value of a file.

    Attributes:
        line: line on which it begins, from 1; 0 for the file itself.
        parts: its contents, by key, or by index from 0 in a list.
    """

    line: int
    parts: dict[str | int, Located] = field(default_factory=dict)


@lru_cache(maxsize=4)
def located(text: str) -> Located:
    """Return the lines of all tables, keys and list items in a TOML text that `tomllib` accepts."""
    return _Scanner(text).file()


class _Scanner:
    """Scanner with a position in a text; each method reads from that position and advances it."""

    def __init__(self, text: str) -> None:
        self._text, self._at = text, 0
        self._starts = [0, *(match.end() for match in re.finditer("\n", text))]

    def file(self) -> Located:
        """Read the whole text."""
        table = root = Located(0)
        while self._skip(_GAP) < len(self._text):
            if self._take("[["):
                table = self._table(root, self._key(), another=True)
                self._take("]]")
            elif self._take("["):
                table = self._table(root, self._key(), another=False)
                self._take("]")
            else:
                self._pair(table)
        return root

    def _table(self, root: Located, key: list[str], another: bool) -> Located:
        """Return the table to which a header belongs; create it if it is new.

        Args:
            root: the whole file.
            key: parts of the header's key.
            another: whether the header has double brackets, which append a table to a list of tables.
        """
        table, line = root, self._line()
        for depth, part in enumerate(key, 1):
            table = table.parts.setdefault(part, Located(line))
            if another and depth == len(key):
                table = table.parts.setdefault(len(table.parts), Located(line))
            elif table.parts and 0 in table.parts:  # a list of tables: the header refers to its last table
                table = table.parts[len(table.parts) - 1]
        return table

    def _pair(self, table: Located) -> None:
        """Read ``key = value`` into a table."""
        line = self._line()
        for part in self._key():
            table = table.parts.setdefault(part, Located(line))
        self._take("=")
        self._value(table)

    def _value(self, value: Located) -> None:
        """Read a value into `value`; the contents of a list or an inline table become the parts of `value`."""
        self._skip(_SPACE)
        if self._take("["):
            self._skip(_GAP)
            while not self._take("]"):
                self._value(value.parts.setdefault(len(value.parts), Located(self._line())))
                self._skip(_GAP)
                self._take(",")
                self._skip(_GAP)
        elif self._take("{"):
            self._skip(_GAP)
            while not self._take("}"):
                self._pair(value)
                self._skip(_GAP)
                self._take(",")
                self._skip(_GAP)
        elif string := _STRING.match(self._text, self._at):
            self._at = string.end()
        else:
            start = self._at
            assert self._skip(_SCALAR) > start, "tomllib accepted this text, so a value begins here"

    def _key(self) -> list[str]:
        """Read a dotted key."""
        parts = []
        while True:
            self._skip(_SPACE)
            bare = _BARE_KEY.match(self._text, self._at)
            found = bare or _STRING.match(self._text, self._at)
            assert found is not None, "tomllib accepted this text, so a key begins here"
            parts.append(found[0] if bare else next(iter(tomllib.loads(f"{found[0]} = 0"))))
            self._at = found.end()
            self._skip(_SPACE)
            if not self._take("."):
                return parts

    def _take(self, sign: str) -> bool:
        """Skip `sign` if the text continues with it; return whether it does."""
        if not self._text.startswith(sign, self._at):
            return False
        self._at += len(sign)
        return True

    def _skip(self, pattern: re.Pattern[str]) -> int:
        """Skip the text that a pattern matches; return the new position."""
        if match := pattern.match(self._text, self._at):
            self._at = match.end()
        return self._at

    def _line(self) -> int:
        """Return the line of the current position, from 1."""
        return bisect_right(self._starts, self._at)
