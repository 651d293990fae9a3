"""Reader of playwright's accessibility snapshots: roles, names, states and texts of the page as a tree."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, field

_LINE = re.compile(
    r'(?P<role>[\w/]+)(?: (?P<name>"(?:[^"\\]|\\.)*"))?(?P<states>(?: \[[^]]*\])*)(?::(?: (?P<text>.*))?)?$'
)


@dataclass
class Node:
    """An element of the page.

    Attributes:
        role: its role; `text` for a text.
        name: its accessible name.
        states: its states, such as `pressed` and `disabled`.
        text: its own text.
        children: the elements in it.
    """

    role: str
    name: str = ""
    states: frozenset[str] = frozenset()
    text: str = ""
    children: list[Node] = field(default_factory=list)

    def walk(self) -> Iterator[Node]:
        """Yield this element and all elements in it, in the order of the page."""
        yield self
        for child in self.children:
            yield from child.walk()

    def all(self, role: str, name: str = "") -> list[Node]:
        """Return the elements of a role in this element; only those whose name begins with `name`."""
        return [node for node in self.walk() if node.role == role and node.name.startswith(name)]

    def first(self, role: str, name: str = "") -> Node:
        """Return the first of these elements; an empty one if there is none."""
        return next(iter(self.all(role, name)), Node(role))

    def words(self) -> str:
        """Return all texts in this element. A picture has its name as its text."""
        own = self.name if self.role == "img" else self.text
        return _joined([own, *(child.words() for child in self.children)])


def parse(snapshot: str) -> Node:
    """Return the tree of a snapshot, in a root element."""
    root = Node("root")
    open_nodes = [(-1, root)]
    for line in snapshot.splitlines():
        depth, content = len(line) - len(line.lstrip()), line.strip().removeprefix("- ")
        while open_nodes[-1][0] >= depth:
            open_nodes.pop()
        node = _node(content)
        open_nodes[-1][1].children.append(node)
        open_nodes.append((depth, node))
    return root


def _node(content: str) -> Node:
    quoted = re.match(r"'((?:[^']|'')*)'(.*)", content)  # YAML quotes a head that has a colon in its name
    found = _LINE.match(quoted[1].replace("''", "'") + quoted[2] if quoted else content)
    if not found:
        return Node("text", text=content)
    name, text = found["name"], found["text"] or ""
    return Node(
        found["role"],
        json.loads(name) if name else "",
        frozenset(re.findall(r"\[([^]]*)\]", found["states"])),
        json.loads(text) if text.startswith('"') else text,
    )


def _joined(parts: list[str]) -> str:
    """Return texts with a space between them, but without one before a mark of punctuation."""
    return re.sub(r" (?=[,.;:)])", "", " ".join(part for part in parts if part))
