"""Decoding of TOML files into types; all errors are reported together, each with its line."""

from __future__ import annotations

import stat
import tomllib
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import msgspec

from aftdeck.encodable import encodable
from aftdeck.errors import InputError, ScenarioError
from aftdeck.schema_check import convert, problems_of, split, unreadable
from aftdeck.toml_lines import excess, located
from aftdeck.units import short

_T = TypeVar("_T")

MOST_BYTES = 1_000_000
"""Maximum length of a file [bytes]; a longer file is rejected before it is parsed. Built-in files have up to 33 kB."""


class Text(NamedTuple):
    """Name and text of a file."""

    name: str
    text: str


def read(path: Path, most: int | None = MOST_BYTES) -> Text:
    """Read a file and return its name and text.

    Args:
        path: the file.
        most: maximum length [bytes]; None for no limit.

    Raises:
        ScenarioError: the file is missing, unreadable, too long or not UTF-8.
    """
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):  # a pipe or a device may never end
            raise ScenarioError([f"{path}: cannot be read: it is not a regular file"])
        if most is not None and status.st_size > most:
            raise ScenarioError([f"{path.name}: has {status.st_size} bytes; at most {most} bytes are allowed"])
        return Text(encodable(path.name), path.read_text(encoding="utf-8-sig"))
    except OSError as error:
        raise ScenarioError([f"{path}: cannot be read: {error.strerror or error}"]) from None
    except UnicodeDecodeError as error:
        raise ScenarioError([f"{path.name}: is not UTF-8 text (byte {error.start})"]) from None
    except ValueError as error:
        raise ScenarioError([f"{str(path)!r}: cannot be read: {error}"]) from None


def is_file(path: Path) -> bool:
    """Return whether a path is that of a regular file; a path that is too long for the system is not."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def check_new(path: Path) -> None:
    """Check that nothing has this path, and that a file or folder can have it.

    Raises:
        InputError: something exists there, or the name is not allowed, for example because it is too long.
    """
    try:
        path.lstat()
    except FileNotFoundError:
        return
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be the name of a folder or file: {error}") from None
    raise InputError(f"{path}: exists already; give a new name")


def as_path(name_or_path: object) -> Path:
    """Return a name or path as a Path.

    Raises:
        InputError: it is neither a text nor a path.
    """
    if not isinstance(name_or_path, str | Path):
        raise InputError(f"got {short(name_or_path)}, expected a name or a path")
    return Path(name_or_path)


def find_toml(
    name_or_path: object, folder: Path, names: Sequence[str], kinds: tuple[str, str], error: Callable[[str], Exception]
) -> Path:
    """Return the path of a built-in file of `folder` by its name, or a path to another TOML file unchanged.

    Args:
        name_or_path: the name or the path.
        folder: folder of the built-in files.
        names: names of the built-in files.
        kinds: what the file is, singular and plural, for the message.
        error: makes the error for a name that is not built in.

    Raises:
        InputError: `name_or_path` is neither a text nor a path.
    """
    path = as_path(name_or_path)
    if path.suffix == ".toml":
        return path
    if str(name_or_path) not in names:
        kind, plural = kinds
        raise error(
            f"no {kind} {str(name_or_path)!r}; the built-in {plural} are {', '.join(names)}; a path to "
            f"{'an' if kind == 'arm' else 'a'} {kind} file ends in .toml"
        )
    return folder / f"{name_or_path}.toml"


def beside(name: str, folder: Path) -> str:
    """Return `folder` joined with the path `name`; `folder` is the folder of the file in which `name` is written.

    Names of built-in files and absolute paths are returned unchanged.
    """
    return str(folder / name) if name.endswith(".toml") and not Path(name).is_absolute() else name


def parse(kind: type[_T], file: Text) -> _T:
    """Return the file's contents as a value of `kind`, a msgspec struct.

    Raises:
        ScenarioError: the text is not valid TOML, or fields are wrong or unknown. The message lists all problems found.
    """
    value, problems = examine(kind, file)
    if value is None or problems:
        raise ScenarioError(sentences(problems, file.name, file.text))
    return value


def examine(
    kind: type[_T],
    file: Text,
    changes: Changes | None = None,
    derive: Callable[[dict[str, Any]], list[Problem]] | None = None,
) -> tuple[_T | None, list[Problem]]:
    """Return two values: the file's contents without the wrong fields, and a list of all problems found.

    The contents are None if they cannot be decoded without the wrong fields, for example because a field is required.

    Args:
        kind: type of the contents, a msgspec struct.
        file: name and text of the file.
        changes: new values for places in the file; they are set before the contents are decoded.
        derive: function that replaces expressions by their values, after the changes (`aftdeck.dimensions`).

    Raises:
        ScenarioError: the text is not TOML, is nested too deeply, or has values that no schema allows
            (`schema_check.unreadable`).
    """
    name, text = file
    raw = raw_contents(file)
    for where, value in (changes or {}).items():
        put(raw, where, value)
    try:
        if wrong := [Problem(where, what) for where, what in unreadable(raw)]:
            raise ScenarioError(sentences(wrong, name, text))
        underived = derive(raw) if derive is not None else []
        places = {problem.where for problem in underived}
        found = [Problem(where, what) for where, what in problems_of(raw, kind) if where not in places]
        problems = underived + found
        for problem in problems:
            _leave_out(raw, problem.where)
        return convert(raw, kind), problems
    except RecursionError:
        raise ScenarioError([f"{name}: is nested too deeply to be read"]) from None
    except msgspec.ValidationError as error:
        what, where = split(str(error))
        return None, problems or [Problem(where, what)]


def raw_contents(file: Text) -> dict[str, Any]:
    """Return the contents of a TOML file as plain dicts, lists, numbers and strings.

    Raises:
        ScenarioError: the text is not TOML, is too large or is nested too deeply.
    """
    name, text = file
    if why := excess(text):
        raise ScenarioError([f"{name}: {why}"])
    try:
        return tomllib.loads(text)
    except ValueError as error:  # invalid TOML, or a number with thousands of digits
        raise ScenarioError([f"{name}: {error}"]) from None
    except RecursionError:
        raise ScenarioError([f"{name}: is nested too deeply to be read"]) from None


def put(raw: Any, where: Where, value: object) -> None:
    """Set a value at a place in the raw contents; create the tables that contain the place if they are missing.

    Raises:
        InputError: the place is a list item that does not exist, or is inside a value that is not a table.
    """
    *outer, last = where
    value = plain_value(value)
    for depth, part in enumerate(outer):
        raw = raw.setdefault(part, {}) if isinstance(part, str) and isinstance(raw, dict) else _item(raw, where, depth)
    if isinstance(last, str) and isinstance(raw, dict):
        raw[last] = value
    else:
        _item(raw, where, len(outer))
        raw[last] = value


def plain_value(value: Any) -> Any:
    """Return a value in which NumPy types and tuples are converted to Python numbers and lists."""
    if isinstance(value, dict):
        return {key: plain_value(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain_value(item) for item in value]
    return value.tolist() if hasattr(value, "tolist") else value


def _item(raw: Any, where: Where, depth: int) -> Any:
    """Return the item of the list `raw` with the index `where[depth]`.

    Raises:
        InputError: `raw` is not a list or has no such item, or `where[depth]` is not an index.
    """
    part, before = where[depth], place(where[:depth])
    if isinstance(part, str):
        raise InputError(f"{place(where)}: {before} is not a table, so it cannot have the key {part!r}")
    if not isinstance(raw, list) or not part < len(raw):
        size = f"has {len(raw)} items" if isinstance(raw, list) else "is not a list in the file"
        raise InputError(f"{place(where)}: {before} {size}; there is no item {part} (the first is 0)")
    return raw[part]


def _leave_out(raw: Any, where: Where) -> None:
    """Remove a wrong field from the raw contents; the field is the innermost part of `where` that is a key."""
    names = [i for i, part in enumerate(where) if isinstance(part, str)]
    if not names:
        return
    for part in where[: names[-1]]:
        try:
            raw = raw[part]
        except (KeyError, IndexError, TypeError):
            return
    if isinstance(raw, dict):
        raw.pop(where[names[-1]], None)


Where = tuple[str | int, ...]
"""Place in a file: the keys and list indices, outermost first, that lead to a value. Indices start at 0."""
Changes = Mapping[Where, object]
"""New values for places in a file; each replaces the value there."""


def place(where: Where) -> str:
    """Return a place as text, such as ``phase[1].rate``."""
    return "".join(f"[{k}]" if isinstance(k, int) else f".{k}" for k in where).lstrip(".")


class Problem(msgspec.Struct, frozen=True):
    """A problem at a place in a file."""

    where: Where
    what: str

    def sentence(self, name: str, text: str) -> str:
        """Return the problem as ``file.toml:12: phase[1].rate: what is wrong``."""
        line = line_of(self.where, text)
        where = place(self.where)
        return f"{name}{f':{line}' if line else ''}: {where + ': ' if where else ''}{self.what}"


def sentences(problems: Sequence[Problem], name: str, text: str) -> list[str]:
    """Return one sentence per problem, in order of lines; `name` is the file's name in the sentences."""
    in_order = sorted(problems, key=lambda problem: line_of(problem.where, text) or 0)
    return [problem.sentence(name, text) for problem in in_order]


def line_of(where: Where, text: str) -> int | None:
    """Return the line (from 1) of a place in the text; None if not even the first part of `where` is found.

    If only the first parts of `where` are found, return the line of the last of these parts.
    """
    found = located(text)
    for part in where:
        if part not in found.parts:
            break
        found = found.parts[part]
    return found.line or None
