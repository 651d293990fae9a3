"""Mutants of a TOML text: one to three random changes of keys, values, numbers, structure or characters."""

from __future__ import annotations

import random
import re
from collections.abc import Callable

_COMMENT = re.compile(r'("(?:[^"\\\n]|\\.)*")|#[^\n]*')
_KEY = re.compile(r"(?<![\w.\"'-])[A-Za-z_][\w-]*(?=\s*=)")
_HEADER = re.compile(r"(?m)^\[+[^\]\n]+\]+[ \t]*$")
_PHASE = re.compile(r"(?m)^\[\[phase\]\]\n")
_LINE = re.compile(r"(?m)^[^\n]+\n")
_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
_STRING = re.compile(r'"(?:[^"\\\n]|\\.)*"')
_LIST = re.compile(r"\[[^\[\]\n]*,[^\[\]\n]*\]")
_VALUE = re.compile(rf"(?<=[=\[,])\s*(?:{_STRING.pattern}|{_NUMBER.pattern}|true|false|\[[^\[\]\n]*\])")

HUGE_INTEGER, HUGE_HEX = "1" + "0" * 400, "0x" + "f" * 5000
"""Integers beyond a float's range; the second also has more decimal digits than Python converts to text."""
NUMBERS = (
    "0", "1", "-1", "2", "-0.0", "1e-300", "5e-324", "1e-9", "1e6", "-9e7", "6e7", "1e100", "-1e100", "1e308", "inf",
    "-inf", "nan", "9223372036854775808", "1000000000", HUGE_INTEGER, HUGE_HEX,
)  # fmt: skip
FACTORS = (0.0, -1.0, 1e-12, 1e-3, 0.1, 0.5, 0.9, 1.01, 2.0, 10.0, 1e3, 1e9, 1e100)
UNITS = ("m", "in", "ft", "km", "deg", "rad", "deg/s", "rad/s", "m/s", "kg", "lb", "s", "Hz", "parsec", "")
VALUES = (
    "true", "false", '""', '"x"', "[]", "{}", "[[]]", "[1, 2, 3]", "{ a = 1 }", "1979-05-27", "07:32:00", '"= 1 / 0"',
    '"= sqrt(-1 m)"', '"= a + b"', '"nan m"', '"1e400 m"', '"1e100 in"', '"\\u001b[2J"', '"\\u0000"', '"a\\nb"',
    '"\\u202e"', '"' + "x" * 200_000 + '"', "[" * 60 + "]" * 60, "{ a = " * 60 + "1" + " }" * 60,
    '"= ' + "(" * 140 + "1" + ")" * 140 + '"', '"= ' + "-" * 290 + '1"', '"= 1e999 * 0"', *NUMBERS,
)  # fmt: skip
PHASE_KEYS = (
    "brakes = true", "brakes = false", "safing = true", "safing = false", 'until = "at rest"\nduration = "0.5 s"',
)  # fmt: skip
"""Keys of a script's phase that few built-in files have."""
CHARACTERS = "[]{}=\",.#\n\t -\\'\x00\x1b\x7f\u202e\ufeff\U0001f680é0eE"

Change = Callable[[str, random.Random], str]


def mutant(text: str, rng: random.Random) -> str:
    """Return a text with one to three random changes; comments are removed first, so that changes hit values."""
    text = without_comments(text)
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        text = rng.choice(CHANGES)(text, rng)
    return text


def mild_mutant(text: str, rng: random.Random) -> str:
    """Return a text with one to three small changes, which a loader accepts more often than those of other mutants."""
    text = without_comments(text)
    for _ in range(rng.choice((1, 1, 2, 3))):
        text = rng.choice((_scaled, _scaled, _scaled, _other_number, _without_line, _with_phase_key))(text, rng)
    return text


def without_comments(text: str) -> str:
    """Return a TOML text without its comments."""
    return _COMMENT.sub(lambda match: match[1] or "", text)


def _replaced(pattern: re.Pattern[str], new: Callable[[str], str]) -> Change:
    """Return a change that replaces one random match of a pattern."""

    def change(text: str, rng: random.Random) -> str:
        found = list(pattern.finditer(text))
        if not found:
            return text
        match = rng.choice(found)
        return text[: match.start()] + new(match[0]) + text[match.end() :]

    return change


def _with_phase_key(text: str, rng: random.Random) -> str:
    """Add a key to a phase of the script: to the first one in half of the cases, because runs are short."""
    starts = [match.end() for match in _PHASE.finditer(text)]
    if not starts:
        return text
    at = rng.choice((starts[0], rng.choice(starts)))
    return text[:at] + rng.choice(PHASE_KEYS) + "\n" + text[at:]


def _misspelt(text: str, rng: random.Random) -> str:
    def new(name: str) -> str:
        at = rng.randrange(len(name))
        inserted = rng.choice((*"axz_", "é", "-", "0"))
        return rng.choice((name[:at] + name[at + 1 :] or "x", name[:at] + inserted + name[at:], name[::-1]))

    return _replaced(rng.choice((_KEY, _KEY, _KEY, _HEADER)), new)(text, rng)


def _other_key(text: str, rng: random.Random) -> str:
    names: list[str] = [match[0] for match in _KEY.finditer(text)]
    return _replaced(_KEY, lambda _: rng.choice(names))(text, rng)


def _without_line(text: str, rng: random.Random) -> str:
    return _replaced(_LINE, lambda _: "")(text, rng)


def _twice(text: str, rng: random.Random) -> str:
    return _replaced(rng.choice((_LINE, _HEADER)), lambda line: line.rstrip("\n") + "\n" + line)(text, rng)


def _moved(text: str, rng: random.Random) -> str:
    lines = text.splitlines(keepends=True)
    lines.insert(rng.randrange(len(lines)), lines.pop(rng.randrange(len(lines))))
    return "".join(lines)


def _without_table(text: str, rng: random.Random) -> str:
    """Remove a header with its lines, or repeat them."""
    starts = [match.start() for match in _HEADER.finditer(text)] + [len(text)]
    if len(starts) < 2:
        return text
    i = rng.randrange(len(starts) - 1)
    table = text[starts[i] : starts[i + 1]]
    return text[: starts[i]] + (table * 2 if rng.random() < 0.5 else "") + text[starts[i + 1] :]


def _other_header(text: str, rng: random.Random) -> str:
    """Turn a table into a list of tables or back, nest it, or remove its header."""

    def new(header: str) -> str:
        name = header.strip().strip("[]")
        return rng.choice((f"[{name}]", f"[[{name}]]", f"[{name}.{name}]", f"[[{name}.a]]", f"[a.{name}]", ""))

    return _replaced(_HEADER, new)(text, rng)


def _other_value(text: str, rng: random.Random) -> str:
    return _replaced(_VALUE, lambda _: " " + rng.choice(VALUES))(text, rng)


def _wrapped(text: str, rng: random.Random) -> str:
    before, after = rng.choice((("[", "]"), ("{ value = ", " }"), ("[[", "]]"), ("{ kind = ", " }")))
    return _replaced(_VALUE, lambda value: f" {before}{value.strip()}{after}")(text, rng)


def _other_length(text: str, rng: random.Random) -> str:
    """Add or remove items of a list."""

    def new(given: str) -> str:
        items = [item for item in given[1:-1].split(",") if item.strip()]
        kept = rng.choice((items[:-1], items[1:], [*items, *items[:1]], items * 3, items[::-1]))
        return f"[{','.join(kept)}]"

    return _replaced(_LIST, new)(text, rng)


def _scaled(text: str, rng: random.Random) -> str:
    return _replaced(_NUMBER, lambda number: f"{float(number) * rng.choice(FACTORS):.6g}")(text, rng)


def _other_number(text: str, rng: random.Random) -> str:
    return _replaced(_NUMBER, lambda _: rng.choice(NUMBERS))(text, rng)


def _other_unit(text: str, rng: random.Random) -> str:
    def new(given: str) -> str:
        number, _, _ = given.strip('"').partition(" ")
        return f'"{number} {rng.choice(UNITS)}"'

    return _replaced(_STRING, new)(text, rng)


def _other_string(text: str, rng: random.Random) -> str:
    others: list[str] = [*VALUES, *(match[0] for match in _STRING.finditer(text))]
    return _replaced(_STRING, lambda _: rng.choice(others))(text, rng)


def _other_characters(text: str, rng: random.Random) -> str:
    at, removed = rng.randrange(len(text) + 1), rng.choice((0, 1, 1, 5, 200))
    inserted: str = rng.choice(("", *CHARACTERS))
    return text[:at] + inserted + text[at + removed :]


CHANGES: tuple[Change, ...] = (
    _misspelt, _misspelt, _other_key, _without_line, _twice, _moved, _without_table, _other_header, _other_value,
    _other_value, _wrapped, _other_length, _scaled, _scaled, _scaled, _other_number, _other_number, _other_unit,
    _other_string, _other_characters, _with_phase_key,
)  # fmt: skip
"""Changes of `mutant`; those listed more than once are made more often."""
