"""Console of a session, the report's typewriter: it prints values of the scenario, and changes them in flight.

The report has no format for what the operator typed (*Remote Manipulator Simulation*, section V.A, figure 11): the
words of this module are ours. `historical.typewriter` reads and writes the words of TABLE III.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import NamedTuple, Protocol

from aftdeck.errors import InputError
from aftdeck.historical.typewriter import addresses, read_word, write_word
from aftdeck.scenario.in_flight import check_key, merged
from aftdeck.scenario.key_list import entry_of, key_list
from aftdeck.scenario.keys import key_of
from aftdeck.scenario.load import in_force
from aftdeck.scenario.model import Scenario
from aftdeck.simulation.frame import Frame
from aftdeck.simulation.in_flight import Made, make
from aftdeck.station.core.desk import NOT_IN_CONTROL

HELP = (
    "print KEY                  value, unit, range and source of a key, or of all keys in a table",
    "set KEY = VALUE            change a value from the next step on; several changes: KEY = VALUE; KEY = VALUE",
    "changes                    the changes in force",
    "read ADDRESS               word of the report's TABLE III (octal address), with its value",
    "write ADDRESS = WORD       set such a word (octal)",
    "help                       this text",
    "KEY is a key of the scenario's file, or arm.… or worksite.… for a key of those files; Tab completes it.",
)
MOST_LINES = 40
"""Greatest number of lines of an answer."""
MOST_WORDS = 40
"""Greatest number of completions."""
_END = re.compile(r"[.\[]")
"""End of a part of a key."""
_LAST = re.compile(r"[^\s;=]*$")


class Now(NamedTuple):
    """State of the run in which a line is typed.

    Attributes:
        frame: newest frame; None before the first step.
        waiting: changes by their keys that act in the next step.
        may_set: whether the line may change values.
    """

    frame: Frame | None
    waiting: Mapping[str, str]
    may_set: bool = True

    @property
    def changes(self) -> tuple[str, ...]:
        """Changes in force, each as KEY=VALUE."""
        return self.frame.changes if self.frame else ()


class Reply(NamedTuple):
    """Result of a line.

    Attributes:
        lines: the answer.
        changes: changes in flight that the line asks for, by their keys.
        made: constants of the run with these changes and those before them; None without changes.
    """

    lines: tuple[str, ...]
    changes: dict[str, str]
    made: Made | None = None


class Console(Protocol):
    """What answers the lines of a run's console: a `Typewriter`, in this process or in another one."""

    def reply(self, line: str, now: Now) -> Reply:
        """Return the result of a line.

        Raises:
            InputError: the line is not understood, names what does not exist, or may not change values; the message
                says why.
        """

    def completions(self, line: str, now: Now) -> tuple[str, ...]:
        """Return the words with which the last word of a line can go on: at most `MOST_WORDS`, the shortest first."""


class Typewriter:
    """Console of a run of a scenario."""

    def __init__(self, scenario: Scenario) -> None:
        """Set up the console; `scenario`: the one with which the run began."""
        self._scenario = scenario
        self._actions: dict[str, Callable[[str, Now], Reply]] = {
            "print": self._print,
            "set": self._set,
            "changes": self._changes,
            "read": self._read,
            "write": self._write,
            "help": self._help,
        }

    def reply(self, line: str, now: Now) -> Reply:
        """Return the result of a line; errors as for `Console.reply`."""
        word, _, rest = line.strip().partition(" ")
        if word.lower() not in self._actions:
            known = f"known words: {', '.join(self._actions)}"
            raise InputError(
                f"{word[:40]!r} is not a word of the console; {known}" if word else f"nothing typed; {known}"
            )
        reply = self._actions[word.lower()](rest.strip(), now)
        if not reply.changes:
            return reply
        if not now.may_set:
            raise InputError(NOT_IN_CONTROL)
        done = tuple(f"{key} = {value}" for key, value in reply.changes.items())
        made = make(self._scenario, merged(now.changes, {**now.waiting, **reply.changes}))
        return Reply((*reply.lines, *done), reply.changes, made)

    def completions(self, line: str, now: Now) -> tuple[str, ...]:
        """Return the words with which the last word of a line can go on: at most `MOST_WORDS`, the shortest first.

        A key is completed up to its next point or bracket, so that few words lead to each of thousands.
        """
        match = _LAST.search(line)
        last = match[0] if match else ""
        before = line[: len(line) - len(last)].split()
        if not before:
            return tuple(word for word in self._actions if word.startswith(last))
        if before[0] in ("read", "write"):
            return tuple(text for text in addresses() if text.startswith(last))[:MOST_WORDS]
        if before[0] not in ("print", "set"):
            return ()
        entries = key_list(self._scenario, now.changes)
        found: dict[str, None] = {}
        for name, entry in entries.items():
            if name.startswith(last) and (before[0] == "print" or entry.changes):
                end = _END.search(name, len(last) + 1)
                found[name[: end.start()] if end else name] = None
        return tuple(sorted(found, key=lambda name: (len(name), name)))[:MOST_WORDS]

    def _print(self, rest: str, now: Now) -> Reply:
        if not rest:
            raise InputError("print what? Give a key, such as limits.por.translation")
        lines: list[str] = []
        for text in rest.split():
            entries = entry_of(self._scenario, text, now.changes)
            lines += [entry.sentence() for entry in entries]
        return Reply(_few(lines), {})

    def _set(self, rest: str, _: Now) -> Reply:
        changes: dict[str, str] = {}
        for part in _parts(rest):
            text, equals, value = part.partition("=")
            if not equals or not value.strip():
                raise InputError(
                    f"expected KEY = VALUE, such as limits.por.translation = 0.2 m/s; got {part.strip()[:60]!r}"
                )
            key = key_of(text.strip())
            check_key(key)
            changes[key.text] = value.strip()
        return Reply((), changes)

    def _changes(self, _: str, now: Now) -> Reply:
        changes = [change.replace("=", " = ", 1) for change in now.changes]
        return Reply(_few(changes or ["no value has been changed"]), {})

    def _read(self, rest: str, now: Now) -> Reply:
        scenario = in_force(self._scenario, now.changes)
        if rest:
            return Reply(_few([read_word(text, scenario, now.frame) for text in rest.split()]), {})
        found = []
        for text in addresses():
            with suppress(InputError):  # the scenario has nothing that the word describes
                found.append(read_word(text, scenario, now.frame))
        return Reply(tuple(found) or ("this scenario has nothing that TABLE III describes",), {})

    def _write(self, rest: str, now: Now) -> Reply:
        address, _, word = rest.partition("=")
        return Reply((), write_word(address.strip(), word.strip(), in_force(self._scenario, now.changes), now.frame))

    def _help(self, _: str, __: Now) -> Reply:
        return Reply(HELP, {})


def _parts(text: str) -> list[str]:
    """Return the parts of a text between semicolons; those in quotes do not count."""
    return [part for part in re.findall(r"(?:[^;'\"]|'[^']*'|\"[^\"]*\"|['\"])+", text) if part.strip()] or [""]


def _few(lines: list[str]) -> tuple[str, ...]:
    """Return the first lines, and how many more there are."""
    more = len(lines) - MOST_LINES
    return (*lines[:MOST_LINES], *([f"and {more} more: name a smaller table"] if more > 0 else []))
