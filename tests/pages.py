"""Shell lines of the documents: the lines in code blocks that tell the reader to type something."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
PROGRAMS = ("aftdeck", "make", "npm", "pip", "pre-commit", "python", "ray", "uv")
"""Programs that the documents call; a block whose first line calls one of them has to consist of such lines."""
ASSIGNMENT = re.compile(r"[A-Z_]+=\S*")
INDENT = "    "


class Line(NamedTuple):
    """A shell line.

    Attributes:
        place: page and line number.
        variables: variables that the line sets.
        words: program and arguments; the folder of a program is left out.
    """

    place: str
    variables: dict[str, str]
    words: tuple[str, ...]

    @property
    def text(self) -> str:
        """The line without its comment, spaces and variables."""
        return shlex.join(self.words)


def blocks(text: str) -> Iterator[list[tuple[int, str]]]:
    """Yield the code blocks of a page, indented or fenced, as line numbers and lines."""
    block: list[tuple[int, str]] = []
    fenced = False
    for number, line in enumerate([*text.splitlines(), ""], 1):
        fence = line.startswith("```")
        if not fence and (fenced or line.startswith(INDENT)):
            block.append((number, line if fenced else line.removeprefix(INDENT)))
        elif block:
            yield block
            block = []
        fenced ^= fence


def shell_line(place: str, text: str) -> Line | None:
    """Return a line of a block, or a command in the running text; None if it does not call one of the programs."""
    try:
        words = shlex.split(text, comments=True)
    except ValueError:  # a quotation mark that is not closed
        return None
    variables: dict[str, str] = {}
    while words and ASSIGNMENT.fullmatch(words[0]):
        name, _, variables[name] = words.pop(0).partition("=")
    if not words or (program := words[0].removeprefix(".venv/bin/")) not in PROGRAMS:
        return None
    return Line(place, variables, (program, *words[1:]))


def shell_lines(page: Path) -> list[Line]:
    """Return the shell lines of a page.

    Raises:
        ValueError: a block begins with a shell line, but another of its lines is none.
    """
    found: list[Line] = []
    for block in blocks(page.read_text(encoding="utf-8")):
        lines = [(f"{page.name}:{number}", text) for number, text in block]
        if shell_line(*lines[0]) is None:
            continue
        for place, text in lines:
            line = shell_line(place, text)
            if line is None:
                raise ValueError(f"{place}: got {text!r}; expected a call of {', '.join(PROGRAMS)}")
            found.append(line)
    return found


def commands_in_text(page: Path) -> list[Line]:
    """Return the commands with arguments in the running text of a page, between backticks."""
    found = []
    for number, text in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if not text.startswith(INDENT):
            quoted = (shell_line(f"{page.name}:{number}", each) for each in re.findall(r"`([^`]+)`", text))
            found += [line for line in quoted if line is not None and len(line.words) > 1]
    return found
