"""Tables of the columns in docs/export.md: ``python -m aftdeck.export.document FILE``."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.export.columns import Encoding
from aftdeck.export.state import GROUPS, Shown
from aftdeck.kinematics.arm import load_arm
from aftdeck.made_tables import renew_file


def tables() -> str:
    """Return the tables of the actions and of the state."""
    return "\n".join(_lines())


def _lines() -> Iterator[str]:
    yield "### Columns of an action\n"
    yield "| column | unit | definition |\n|---|---|---|"
    for column in Encoding((), len(load_arm("srms").joints)).columns:
        yield f"| `{column.name}` | {column.unit} | {column.definition} |"
    yield "\n### State\n"
    yield "| numbers | unit | definition |\n|---|---|---|"
    for group in GROUPS:
        yield f"| {_names(group)} | {group.unit} | {group.definition} |"
    yield ""


def _names(group: Shown) -> str:
    if group.parts is None:
        return f"`{group.name}_` and the name of each joint"
    names = [f"{group.name}_{part}" for part in group.parts] or [group.name]
    return ", ".join(f"`{name}`" for name in names)


if __name__ == "__main__":
    renew_file(tables())
