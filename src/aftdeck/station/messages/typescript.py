"""TypeScript of all messages: ``python -m aftdeck.station.messages.typescript`` prints ``web/src/link/protocol.ts``.

Every struct becomes an interface. Every alias (tuple, literal or union) in a module of `NAMED` becomes a type of the
same name. The docstrings of structs become comments; so do the descriptions or docstrings of fields. No field is
optional, because the encoder writes default values too.
"""

from __future__ import annotations

import inspect
import json
import sys
import types
import typing

import msgspec

from aftdeck import shapes
from aftdeck.field_meta import comments
from aftdeck.recording.hints import apart, is_object, names
from aftdeck.report import curves, lamps
from aftdeck.simulation import frame as sim
from aftdeck.simulation.readings import quantity
from aftdeck.simulation.readings.table import named as reading_named
from aftdeck.station.messages import frame, from_page, kinds, measure, playback, to_page, welcome
from aftdeck.worksite import report as work

HEADER = """\
// Generated from simulation/frame.py, report/ and station/messages by `make generate`; do not edit.
// All quantities are SI and radians; station/messages/kinds.py defines panel and scene axes.
"""

MODULES = (kinds, from_page, welcome, frame, to_page, curves, measure, playback)
"""Modules whose structs the page uses."""
READOUTS = ("clearance", "torque_of_limit")
"""Readings whose titles and definitions the panel shows."""
NAMED = (shapes, lamps, quantity, *MODULES, sim, work)
"""Modules whose aliases become types in TypeScript."""
_NUMBERS = tuple[float, ...]
"""Type of any list of numbers, which gets no name, although one of its uses has an alias."""

_PLAIN: dict[object, str] = {
    float: "number",
    int: "number",
    str: "string",
    bytes: "string",  # base64
    bool: "boolean",
    type(None): "null",
}


def typescript() -> str:
    """Return the text of the file, with a newline at its end.

    Raises:
        TypeError: a field has a type that cannot be converted, or two structs have the same name.
    """
    return _Writer().file()


class _Writer:
    """Writer that converts the structs in `MODULES`, and all structs in their fields, to TypeScript."""

    def __init__(self) -> None:
        self.aliases: dict[object, str] = {}
        for module in NAMED:
            for name, value in vars(module).items():
                kind, parts = typing.get_origin(value), typing.get_args(value)
                ranges = any(typing.get_origin(part) is typing.Annotated for part in parts)  # for files only
                if kind in (tuple, typing.Literal, typing.Union, types.UnionType) and not ranges and value != _NUMBERS:
                    self.aliases.setdefault(value, name)
        self.interfaces: dict[type[msgspec.Struct], str] = {}

    def file(self) -> str:
        named = [f"export type {name} = {self.structure(alias)};" for alias, name in self.aliases.items()]
        for value in [value for module in MODULES for value in vars(module).values()]:
            if isinstance(value, type) and issubclass(value, msgspec.Struct) and value is not kinds.WireMessage:
                self.structure(value)
        parts = [
            HEADER,
            f"export const PROTOCOL = {kinds.PROTOCOL};\n",
            "\n".join(named) + "\n",
            f"export const UNITS = {json.dumps(quantity.UNITS, indent=2)} as const;\n",
            f"export const READOUTS = {json.dumps(dict(map(_readout, READOUTS)), indent=2)};\n",
            *self.interfaces.values(),
        ]
        return "\n".join(parts)

    def name(self, hint: object) -> str:
        """Convert a type hint to TypeScript; if the hint has an alias, the result is the name of the alias."""
        alias = self.aliases.get(hint)
        return self.structure(hint) if alias is None else alias

    def structure(self, hint: object) -> str:
        """Convert a type hint to TypeScript without using its alias."""
        plain = _PLAIN.get(hint)
        if plain is not None:
            return plain
        origin, arguments = typing.get_origin(hint), typing.get_args(hint)
        if origin is typing.Literal:
            return " | ".join(_literal(value) for value in arguments)
        if origin in (typing.Union, types.UnionType):
            return " | ".join(self.name(part) for part in arguments)
        if origin is tuple and arguments[-1] is Ellipsis:
            item = self.name(arguments[0])
            return f"readonly ({item})[]" if " " in item else f"readonly {item}[]"
        if origin is tuple:
            return f"readonly [{', '.join(self.name(part) for part in arguments)}]"
        if isinstance(hint, type) and issubclass(hint, msgspec.Struct):
            if hint not in self.interfaces:
                if any(known.__name__ == hint.__name__ for known in self.interfaces):
                    raise TypeError(f"two structs have the name {hint.__name__}; rename one")
                self.interfaces[hint] = ""  # this entry fixes the struct's position, and ends a recursion
                self.interfaces[hint] = self.interface(hint)
            return hint.__name__
        if is_object(hint):
            hints = typing.get_type_hints(hint)
            return f"readonly [{', '.join(f'{name}: {self.name(hints[name])}' for name in names(hint))}]"
        raise TypeError(
            f"{hint} cannot be converted to TypeScript; allowed: numbers, strings, booleans, tuples, literals, "
            "structs and their unions"
        )

    def interface(self, struct: type[msgspec.Struct]) -> str:
        hints, texts = typing.get_type_hints(struct), comments(struct)
        declared = typing.get_type_hints(struct, include_extras=True)
        lines = [*_comment(inspect.getdoc(struct), ""), f"export interface {struct.__name__} {{"]
        config = struct.__struct_config__
        if config.tag_field is not None:
            lines.append(f"  readonly {config.tag_field}: {_literal(config.tag)};")
        for field, wire in zip(struct.__struct_fields__, struct.__struct_encode_fields__, strict=True):
            lines += _comment(_described(apart(declared[field])[1]) or texts.get(field), "  ")
            lines.append(f"  readonly {wire}: {self.name(hints[field])};")
        return "\n".join([*lines, "}", ""])


def _readout(name: str) -> tuple[str, dict[str, str]]:
    reading = reading_named(name)
    return name, {"title": reading.heading, "about": reading.sentence.rstrip(".")}


def _described(meta: msgspec.Meta | None) -> str:
    """Return a field's description, with its unit and axes."""
    if meta is None or meta.description is None:
        return ""
    extra = meta.extra or {}
    unit = "" if extra["unit"] in ("", "1") else f" [{extra['unit']}]"
    return f"{meta.description}{unit}" + (f", along the axes of {extra['frame']}" if extra["frame"] else "")


def _literal(value: object) -> str:
    return f"'{value}'" if isinstance(value, str) else str(value)


def _comment(text: str | None, indent: str) -> list[str]:
    if not text:
        return []
    lines = text.replace("``", "`").splitlines()
    if len(lines) == 1:
        return [f"{indent}/** {lines[0]} */"]
    return [f"{indent}/**", *(f"{indent} * {line}".rstrip() for line in lines), f"{indent} */"]


if __name__ == "__main__":
    sys.stdout.write(typescript())
