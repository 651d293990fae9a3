"""Tables of the columns in docs/export.md: ``python -m aftdeck.export.document FILE``."""

from __future__ import annotations

from collections.abc import Iterator

from aftdeck.export.columns import Encoding
from aftdeck.export.state import in_state
from aftdeck.kinematics.arm import load_arm
from aftdeck.made_tables import renew_file
from aftdeck.simulation.readings.quantity import UNITS
from aftdeck.simulation.readings.reading import Reading


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
    for reading in in_state():
        yield f"| {_names(reading)} | {UNITS[reading.quantity]} | {reading.sentence} |"
    yield ""


def _names(reading: Reading) -> str:
    if isinstance(reading.parts, str):
        return f"`{reading.state}_` and the name of each of the arm's {reading.parts}"
    names = [f"{reading.state}_{part}" for part in reading.parts] or [reading.state]
    return ", ".join(f"`{name}`" for name in names)


if __name__ == "__main__":
    renew_file(tables())
