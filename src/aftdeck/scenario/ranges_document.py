"""Tables of docs/files.md, generated from the types of the files: ``python -m aftdeck.scenario.ranges_document FILE``.

The command replaces the text between the two marks in FILE.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, NamedTuple, get_args, get_origin

import msgspec

from aftdeck.arms.constant import Constant
from aftdeck.arms.model import ArmFile
from aftdeck.arms.shapes import ShapesFile
from aftdeck.bounds import Bounds
from aftdeck.made_tables import renew_file
from aftdeck.scenario.light import LightFile
from aftdeck.scenario.schema import ScenarioFile
from aftdeck.unit_sizes import TABLE, si_symbol
from aftdeck.units import Quantity, quantities
from aftdeck.worksite.file.schema import WorksiteFile

FILES: dict[str, tuple[type[msgspec.Struct], ...]] = {
    "Arm file": (ArmFile,),
    "Shapes, in an arm's shape file and in a worksite file": (ShapesFile,),
    "Worksite file": (WorksiteFile,),
    "Scenario file": (ScenarioFile,),
    "Light conditions (built in)": (LightFile,),
}
"""Types of the files, by the heading of their tables."""


class Number(NamedTuple):
    """Number, or list of numbers, in a field of a file.

    Attributes:
        struct: table that has the field.
        field: name of the field.
        kind: `Quantity` subclass, float or int.
        bounds: plausible range that the field declares; None if it declares none.
    """

    struct: type
    field: str
    kind: type
    bounds: Bounds | None

    @property
    def range(self) -> Bounds | None:
        """Plausible range of the number, also one from its quantity; None if there is none."""
        return self.bounds or (self.kind.bounds if issubclass(self.kind, Quantity) else None)

    @property
    def unit(self) -> str:
        """SI unit of the number; "" for none."""
        if issubclass(self.kind, Quantity):
            return self.kind.unit
        return self.bounds.unit if self.bounds else ""


def numbers(kind: Any, known: set[Any]) -> Iterator[Number]:
    """Yield the numbers of a type of table, and of all tables in it that are not in `known`; add these to `known`."""
    struct = get_origin(kind) or kind
    if struct in known:
        return
    known.add(struct)
    inner: list[Any] = []
    for field in msgspec.structs.fields(kind):
        for leaf, bounds in _leaves(field.type, None):
            if isinstance(leaf, type) and issubclass(leaf, float | int) and not issubclass(leaf, bool):
                yield Number(struct, field.encode_name, leaf, bounds)
            elif isinstance(get_origin(leaf) or leaf, type) and issubclass(get_origin(leaf) or leaf, msgspec.Struct):
                inner.append(leaf)
    for table in inner:
        yield from numbers(table, known)


def _leaves(hint: Any, bounds: Bounds | None) -> Iterator[tuple[Any, Bounds | None]]:
    """Yield each type of which a type consists, with the range that the type declares for it."""
    origin, arguments = get_origin(hint), get_args(hint)
    if origin is Annotated:
        own = next((meta for meta in arguments[1:] if isinstance(meta, Bounds)), bounds)
        yield from _leaves(arguments[0], own)
    elif origin is Constant:
        yield from _leaves(arguments[0], bounds)
    elif origin is None or (isinstance(origin, type) and issubclass(origin, msgspec.Struct)):
        yield hint, bounds
    elif origin is not dict:  # a dictionary has named quantities, which are checked where they are used
        for argument in dict.fromkeys(arguments):
            yield from _leaves(argument, bounds)


def tables() -> str:
    """Return the tables of units, of the quantities' ranges, and of each file's fields with own ranges."""
    return "\n".join(_lines())


def _lines() -> Iterator[str]:
    yield "### Units\n\n| one | is | names |\n|---|---|---|"
    for one in TABLE:
        symbol, *other = (f"`{name}`" for name in one.names)
        yield f"| {symbol} | {one.size:.10g} {si_symbol(one.dimension)} | {', '.join(other)} |"
    yield "\n### Every field, unless a table below gives another range\n\n| quantity | range | because |\n|---|---|---|"
    for quantity in quantities():
        yield _row(quantity.noun, quantity.bounds, quantity.unit)
    known: set[Any] = set()
    for heading, kinds in FILES.items():
        rows: dict[tuple[Bounds, str], dict[str, None]] = {}
        for number in (number for kind in kinds for number in numbers(kind, known)):
            if number.bounds is not None:
                name = f"{number.struct.__name__.removesuffix('File').removesuffix('Spec')}.{number.field}"
                rows.setdefault((number.bounds, number.unit), {})[f"`{name}`"] = None
        yield f"\n### {heading}\n\n| fields | range | because |\n|---|---|---|"
        for (bounds, unit), names in rows.items():
            yield _row(", ".join(names), bounds, unit)
    yield ""


def _row(names: str, bounds: Bounds, unit: str) -> str:
    return f"| {names} | {bounds.least:,g} to {bounds.greatest:,.16g} {unit}".rstrip() + f" | {bounds.reason} |"


if __name__ == "__main__":
    renew_file(tables())
