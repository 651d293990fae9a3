"""Reasons why the raw contents of a file do not fit its schema: names, types, plausible ranges, rules of structs."""

from __future__ import annotations

import re
import types
import unicodedata
from collections.abc import Callable, Iterator
from functools import cache
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin

import msgspec

from aftdeck.bounds import Bounds
from aftdeck.units import Quantity, decode_hook, short

_T = TypeVar("_T")
_Where = tuple[str | int, ...]
_Problems = list[tuple[_Where, str]]
_Check = Callable[[Any, _Where], _Problems]
"""Function that returns all reasons why a value is not valid; its arguments are the value and its place."""

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


def problems_of(raw: object, kind: Any) -> _Problems:
    """Return all reasons why `raw` is not a valid `kind`, each with its place.

    Args:
        raw: plain dicts, lists, numbers and strings.
        kind: the type, such as a struct.
    """
    return _check(kind)(raw, ())


@cache
def _check(kind: Any, bounds: Bounds | None = None) -> _Check:
    """Return the check of a type: all that depends on the type alone is found once, because files have many values.

    Args:
        kind: the type.
        bounds: plausible range, from the metadata of the type.
    """
    kind, optional = without_none(kind)
    check = _check_of_value(kind, bounds)
    return (lambda raw, where: [] if raw is None else check(raw, where)) if optional else check


def _check_of_value(kind: Any, bounds: Bounds | None) -> _Check:
    base, parts = get_origin(kind) or kind, get_args(kind)
    if base is Annotated:
        return _check_of_annotated(kind, bounds)
    if tagged := tagged_kinds(kind):
        return lambda raw, where: _tagged_problems(raw, tagged, where)
    if isinstance(base, type) and issubclass(base, msgspec.Struct):
        return lambda raw, where: _struct_problems(raw, kind, where)
    alone = _check_of_whole(kind, bounds)
    if base is tuple:
        each = [_check(part) for part in parts if part is not ...]
        return lambda raw, where: _tuple_problems(raw, each, parts[1:] == (...,), where, alone)
    if base is dict:
        of_item = _check(parts[1])
        return lambda raw, where: _dict_problems(raw, of_item, where)
    if base is Literal:
        what = f"expected one of {', '.join(map(str, parts))}, got "
        return lambda raw, where: alone(raw, where) if raw in parts else [(where, what + short(raw))]
    return alone


def _check_of_annotated(kind: Any, bounds: Bounds | None) -> _Check:
    """Return the check of a type with metadata; constraints of msgspec count only if the value is valid otherwise."""
    inner, *metas = get_args(kind)
    check = _check(inner, next((meta for meta in metas if isinstance(meta, Bounds)), bounds))
    if all(isinstance(meta, Bounds) for meta in metas):
        return check
    return lambda raw, where: check(raw, where) or _problem(raw, kind, where)


def _check_of_whole(kind: Any, bounds: Bounds | None) -> _Check:
    """Return the check of a value that is converted as a whole: a number, also for its plausible range, or a text."""
    quantity = kind if isinstance(kind, type) and issubclass(kind, Quantity) else None
    bounds = bounds or (quantity.bounds if quantity else None)
    if bounds is None:
        return lambda raw, where: _problem(raw, kind, where)
    within, unit = bounds, quantity.unit if quantity else ""

    def check(raw: object, where: _Where) -> _Problems:
        try:
            what = within.problem(convert(raw, kind), unit)
        except msgspec.ValidationError:
            return _problem(raw, kind, where)
        return [(where, what)] if what else []

    return check


def _tuple_problems(raw: object, each: list[_Check], repeated: bool, where: _Where, otherwise: _Check) -> _Problems:
    if not isinstance(raw, list) or not (repeated or len(raw) == len(each)):
        return otherwise(raw, where)
    checks = each * len(raw) if repeated else each
    return [p for i, item in enumerate(raw) for p in checks[i](item, (*where, i))]


def _dict_problems(raw: object, check: _Check, where: _Where) -> _Problems:
    if not isinstance(raw, dict):
        return [(where, f"expected a table, got {short(raw)}")]
    return [p for key, item in raw.items() for p in check(item, (*where, key))]


def _problem(raw: object, kind: Any, where: _Where) -> _Problems:
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


def _tagged_problems(raw: object, tagged: dict[str, Any], where: _Where) -> _Problems:
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
    return [tag_problem, *(p for key, field_type in in_order for p in _check(field_type)(raw[key], (*where, key)))]


def _struct_problems(raw: object, kind: Any, where: _Where) -> _Problems:
    if not isinstance(raw, dict):
        return [(where, f"expected a table, got {short(raw)}")]
    fields, struct = _fields(kind), get_origin(kind) or kind  # a generic struct has the configuration
    tag = struct.__struct_config__.tag_field
    found: _Problems = []
    if tag is not None and raw.get(tag) != struct.__struct_config__.tag:
        found.append(((*where, tag), f"expected {struct.__struct_config__.tag!r}, got {short(raw.get(tag))}"))
    if struct.__struct_config__.forbid_unknown_fields and (unknown := [k for k in raw if k not in fields and k != tag]):
        what = f"unknown field; allowed here: {', '.join(fields)}"  # one text for all, because a file may have many
        found += [((*where, key), what) for key in unknown]
    for key, (required, check) in fields.items():
        if key in raw:
            found += check(raw[key], (*where, key))
        elif required:
            found.append((where, f"the field {key!r} is missing"))
    if not found and hasattr(struct, "__post_init__"):
        found += [(where, what) for _, what in _problem(raw, kind, where)]
    return found


@cache
def _fields(kind: Any) -> dict[str, tuple[bool, _Check]]:
    """Return whether each field of a struct is required, and its check, by the fields' names in files."""
    return {name: (field.required, _check(field.type)) for name, field in fields_of(kind).items()}


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
