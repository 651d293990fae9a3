"""Checks of a shell line that is not run: its command, options, target, module or extra exists."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from functools import cache
from typing import Any

import click
from packaging.requirements import InvalidRequirement, Requirement
from typer.main import get_command

from aftdeck.cli import app
from benchmarks.names import NAMES
from tests.pages import ROOT, Line


def problem(line: Line) -> str:
    """Return what a shell line names that does not exist; "" if all exists."""
    program, *words = line.words
    if program == "aftdeck":
        return _of_aftdeck(words)
    if program == "make":
        return "" if words[0] in _targets() else f"no target {words[0]!r} in the Makefile"
    if program == "python":
        return _of_python(words)
    if program == "pip":
        return next(_of_extras(words), "")
    return ""


def _of_aftdeck(words: list[str]) -> str:
    group: Any = get_command(app)
    given = words[0].startswith("-")  # an option of the program itself
    command = group if given else group.commands.get(words[0])
    if command is None:
        return f"no command {words[0]!r}"
    known = {"--help", *_options(command)}
    unknown = [word for word in words if word.startswith("-") and not _is_number(word) and word not in known]
    return f"no option {unknown[0]!r}" if unknown else ""


def _options(command: click.Command) -> Iterator[str]:
    for parameter in command.params:
        yield from (*parameter.opts, *parameter.secondary_opts)
    for each in getattr(command, "commands", {}).values():
        yield from _options(each)


def _is_number(word: str) -> bool:
    return re.fullmatch(r"-?[\d.]+", word) is not None


def _of_python(words: list[str]) -> str:
    if words[0] == "-c":
        compile(words[1], "-c", "exec")
        return ""
    if words[0] != "-m":
        text = (ROOT / words[0]).read_text(encoding="utf-8") if (ROOT / words[0]).is_file() else None
        if text is None:
            return f"no file {words[0]!r}"
        return next((f"no option {word!r}" for word in words if word.startswith("--") and f'"{word}"' not in text), "")
    path = ROOT.joinpath(*words[1].split("."))
    if not (path.with_suffix(".py").is_file() or (path / "__main__.py").is_file()):
        return f"no module {words[1]!r}"
    names = words[2:] if words[1] == "benchmarks" else []
    return next((f"no benchmark {name!r}" for name in names if name not in NAMES), "")


def _of_extras(words: list[str]) -> Iterator[str]:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    for word in words:
        try:
            requirement = Requirement(word)
        except InvalidRequirement:  # a path
            continue
        if requirement.name == project["name"]:
            yield from (f"no extra {each!r}" for each in requirement.extras - set(project["optional-dependencies"]))


@cache
def _targets() -> set[str]:
    return set(re.findall(r"(?m)^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8")))
