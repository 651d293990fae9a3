"""Reasons why the raw contents of a file do not fit its schema: names, types, plausible ranges, rules of structs."""

from __future__ import annotations

import re
import types
import unicodedata
from collections.abc import Iterator
from functools import cache
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin

import msgspec

from aftdeck.bounds import Bounds
from aftdeck.units import Quantity, decode_hook, short

_T = TypeVar("_T")
_Where = tuple[str | int, ...]

LONGEST_TEXT, LONGEST_KEY = 20_000, 100
"""Greatest length of a text and of a key in a file [characters] (assumed)."""
INTEGER_BITS = 64
"""Size of an integer; TOML 1.0 requires no more, and longer ones are rejected."""
_DIRECTIONAL = re.compile("[\u202a-\u202e\u2066-\u2069]")
"""Characters that change the direction of the text after them, and thereby hide what a file says."""


def convert(raw: object, kind: type[_T]) -> _T:
    """Convert plain dicts, lists, numbers and strings to a decoded value of `kind`."""
    return msgspec.convert(raw, kind, dec_hook=decode_hook)


def unreadable(raw: object, where: _Where = ()) -> Iterator[tuple[_Where, str]]:
    """Yield keys and values that no schema allows: overlong or unprintable texts, and integers beyond 64 bits."""
    if isinstance(raw, dict):
        for key, item in raw.items():
            if what := _text_problem(key, LONGEST_KEY, ""):
                yield where, f"the key {short(key)} {what}"
            else:
                yield from unreadable(item, (*where, key))
    elif isinstance(raw, list):
        for i, item in enumerate(raw):
            yield from unreadable(item, (*where, i))
    elif isinstance(raw, str):
        if what := _text_problem(raw, LONGEST_TEXT, "\t\n\r"):
            yield where, f"the text {short(raw)} {what}"
    elif isinstance(raw, int) and raw.bit_length() >= INTEGER_BITS:
        yield where, f"got an integer of {raw.bit_length()} bits; {INTEGER_BITS} bits with the sign are allowed"


def _text_problem(text: str, most: int, allowed: str) -> str:
    """Return why a text or key is rejected; "" if it is accepted."""
    if len(text) > most:
        return f"has {len(text)} characters; at most {most} are allowed"
    if text.isprintable():
        return ""
    hidden = next((x for x in text if unicodedata.category(x) == "Cc" and x not in allowed), "")
    found = hidden or "".join(_DIRECTIONAL.findall(text)[:1])
    return f"contains the control character {found!r}" if found else ""


def problems_of(raw: object, kind: Any, where: _Where = (), bounds: Bounds | None = None) -> list[tuple[_Where, str]]:
    """Return all reasons why `raw` is not a valid `kind`, each with its place.

    Args:
        raw: plain dicts, lists, numbers and strings.
        kind: the type, such as a struct.
        where: place of `raw` in the file.
        bounds: plausible range of `raw`, from the metadata of its type.
    """
    kind, optional = without_none(kind)
    if optional and raw is None:
        return []
    base = get_origin(kind) or kind
    if base is Annotated:  # check the constraint only if the value is valid without it
        inner, *metas = get_args(kind)
        own = next((meta for meta in metas if isinstance(meta, Bounds)), bounds)
        return problems_of(raw, inner, where, own) or _problem(raw, kind, where)
    if tagged := tagged_kinds(kind):
        return _tagged_problems(raw, tagged, where)
    if isinstance(base, type) and issubclass(base, msgspec.Struct):
        return _struct_problems(raw, kind, where)
    if base is tuple and isinstance(raw, list):
        items = get_args(kind)
        if items[1:] == (...,):
            items = items[:1] * len(raw)
        if len(items) == len(raw):
            return [p for i, item in enumerate(raw) for p in problems_of(item, items[i], (*where, i))]
    if base is dict:
        if not isinstance(raw, dict):
            return [(where, f"expected a table, got {short(raw)}")]
        return [p for key, item in raw.items() for p in problems_of(item, get_args(kind)[1], (*where, key))]
    if base is Literal and raw not in get_args(kind):
        return [(where, f"expected one of {', '.join(map(str, get_args(kind)))}, got {short(raw)}")]
    return _problem(raw, kind, where) or _range_problem(raw, kind, where, bounds)


def _range_problem(raw: object, kind: Any, where: _Where, bounds: Bounds | None) -> list[tuple[_Where, str]]:
    """Return the reason why a valid number is not plausible, with its place; empty for other types."""
    quantity = kind if isinstance(kind, type) and issubclass(kind, Quantity) else None
    bounds = bounds or (quantity.bounds if quantity else None)
    if bounds is None:
        return []
    what = bounds.problem(convert(raw, kind), quantity.unit if quantity else "")
    return [(where, what)] if what else []


def _problem(raw: object, kind: Any, where: _Where) -> list[tuple[_Where, str]]:
    """Return the first reason why `raw` cannot be converted to `kind`, with its place; empty if it can."""
    try:
        convert(raw, kind)
    except msgspec.ValidationError as error:
        what, inner = split(str(error))
        return [((*where, *inner), what)]
    return []


@cache
def tagged_kinds(kind: Any) -> dict[str, Any]:
    """Return the structs of a tagged union, by the value of their tag field; empty for other kinds."""
    members = get_args(kind) if get_origin(kind) in (Union, types.UnionType) else ()
    if not all(isinstance(k, type) and issubclass(k, msgspec.Struct) and k.__struct_config__.tag for k in members):
        return {}
    return {k.__struct_config__.tag: k for k in members}


def _tagged_problems(raw: object, tagged: dict[str, Any], where: _Where) -> list[tuple[_Where, str]]:
    """Return the reasons why `raw` is not a valid struct of a tagged union, each with its place.

    The tag field selects the struct to check. A missing or unknown tag is reported as a problem; only the fields that
    all structs share are then checked.
    """
    field = next(iter(tagged.values())).__struct_config__.tag_field
    if not isinstance(raw, dict):
        return [(where, f"expected a table, got {short(raw)}")]
    name = raw.get(field)
    if isinstance(name, str) and name in tagged:
        return _struct_problems(raw, tagged[name], where)
    if field in raw:
        tag_problem = ((*where, field), f"expected one of {', '.join(tagged)}, got {short(name)}")
    else:
        tag_problem = (where, f"the field {field!r} is missing")
    common = set.intersection(*({(f.encode_name, f.type) for f in fields_of(k).values()} for k in tagged.values()))
    known = [(key, field_type) for key, field_type in common if key in raw]
    in_order = sorted(known, key=lambda pair: pair[0])
    return [tag_problem, *(p for key, field_type in in_order for p in problems_of(raw[key], field_type, (*where, key)))]


def _struct_problems(raw: object, kind: Any, where: _Where) -> list[tuple[_Where, str]]:
    if not isinstance(raw, dict):
        return [(where, f"expected a table, got {short(raw)}")]
    struct = get_origin(kind) or kind  # a generic struct with its parameters has the generic struct's configuration
    fields, tag = fields_of(kind), struct.__struct_config__.tag_field
    found: list[tuple[_Where, str]] = []
    if tag is not None and raw.get(tag) != struct.__struct_config__.tag:
        found.append(((*where, tag), f"expected {struct.__struct_config__.tag!r}, got {short(raw.get(tag))}"))
    unknown = f"unknown field; allowed here: {', '.join(fields)}"  # one text for all, because a file may have many
    for key in raw:
        if key not in fields and key != tag and struct.__struct_config__.forbid_unknown_fields:
            found.append(((*where, key), unknown))
    for key, field in fields.items():
        if key in raw:
            found += problems_of(raw[key], field.type, (*where, key))
        elif field.required:
            found.append((where, f"the field {key!r} is missing"))
    if not found and hasattr(struct, "__post_init__"):
        found += [(where, what) for _, what in _problem(raw, kind, where)]
    return found


@cache
def fields_of(kind: Any) -> dict[str, msgspec.structs.FieldInfo]:
    """Return the fields of a struct by their names in files."""
    return {field.encode_name: field for field in msgspec.structs.fields(kind)}


@cache
def without_none(kind: Any) -> tuple[Any, bool]:
    """Return X and True if `kind` is X | None; return any other kind unchanged, and False."""
    if get_origin(kind) in (Union, types.UnionType):
        rest = [k for k in get_args(kind) if k is not type(None)]
        if len(rest) == 1:
            return rest[0], True
        if len(rest) < len(get_args(kind)):
            return Union[tuple(rest)], True  # noqa: UP007  (a union of a computed number of types)
    return kind, False


def split(message: str) -> tuple[str, _Where]:
    """Split a message of msgspec, such as ``... - at `$.a[0]` ``, into its text and a place."""
    what, _, path = message.partition(" - at `$")
    parts = re.findall(r"\.([A-Za-z0-9_-]+)|\[(\d+)\]", path)
    return what, tuple(name or int(index) for name, index in parts)
