"""Named dimensions of a file, and quantities that are derived from the dimensions.

A file's ``[dimensions]`` table gives names to quantities. Any other value of the file may be an expression that uses
these names: a string that begins with ``=``, such as ``"= payload_length / 2 - 2 ft"``. An expression may use numbers
with or without a unit, names, ``+ - * /``, brackets, ``min``, ``max``, ``sqrt``, ``cos``, ``sin`` and ``tan``. Units
are checked: a length cannot be added to an angle, and an expression for a length must result in a length. The
expression of a dimension may use the dimensions listed above it.
"""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from aftdeck.files import Problem, Where
from aftdeck.units import Angle, AngularRate, Length, Mass, Quantity, Speed, Time, short, with_article

KEY = "dimensions"
"""Name of the table of dimensions."""
_LONGEST = 300
"""Maximum length of an expression [characters]; short enough that nested brackets cannot exhaust the parser."""
_LITERAL = re.compile(r"(?<![\w.])((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(?:\s*([A-Za-z]+(?:/s\b)?))?")
_NAME = re.compile(r"[a-z][a-z0-9_]*")

Powers = tuple[float, float, float, float]
"""Exponents of metre, kilogram, second and radian."""
_PLAIN: Powers = (0.0, 0.0, 0.0, 0.0)
_KINDS: dict[Powers, type[Quantity]] = {
    (1.0, 0.0, 0.0, 0.0): Length,
    (0.0, 0.0, 0.0, 1.0): Angle,
    (1.0, 0.0, -1.0, 0.0): Speed,
    (0.0, 0.0, -1.0, 1.0): AngularRate,
    (0.0, 1.0, 0.0, 0.0): Mass,
    (0.0, 0.0, 1.0, 0.0): Time,
}


class _Value(NamedTuple):
    number: float
    """The value in SI units."""
    powers: Powers


_WRONG = _Value(math.nan, _PLAIN)
"""Placeholder for a dimension whose value could not be computed."""


def derive(raw: dict[str, Any]) -> list[Problem]:
    """Replace the expressions in a file's raw contents (dicts and lists) by their values; return the problems found."""
    given = raw.get(KEY, {})
    if not isinstance(given, dict):
        return [Problem((KEY,), f"expected a table of named quantities, got {short(given)}")]
    problems: list[Problem] = []
    names: dict[str, _Value] = {}
    for name, value in given.items():
        try:
            names[name] = _dimension(name, value, names)
            given[name] = _file_value(names[name])
        except ValueError as error:
            names[name] = _WRONG
            problems.append(Problem((KEY, name), str(error)))
    return problems + _substituted(raw, names)


def derive_from(given: Mapping[str, str | float], raw: dict[str, Any]) -> list[Problem]:
    """Replace the expressions in `raw` by their values; return the problems found.

    The expressions may use the dimensions of another file.

    Args:
        given: dimensions of the other file, already evaluated by `derive`.
        raw: raw contents of this file, changed in place.
    """
    return _substituted(raw, {name: _dimension(name, value, {}) for name, value in given.items()})


def has_formulas(raw: dict[str, Any]) -> bool:
    """Return whether a file's raw contents hold any expression."""
    return next(_formulas(raw, ()), None) is not None


def is_formula(value: object) -> bool:
    """Return whether a value is an expression, or contains one."""
    return has_formulas({"": value})


def _substituted(raw: dict[str, Any], names: Mapping[str, _Value]) -> list[Problem]:
    problems = []
    for holder, key, where, text in list(_formulas(raw, ())):
        try:
            holder[key] = _file_value(_evaluated(text[1:], names))
        except ValueError as error:
            problems.append(Problem(where, str(error)))
    return problems


def _formulas(value: Any, where: Where) -> Iterator[tuple[Any, Any, Where, str]]:
    """Yield, for each expression: the table or list that contains it, its key or index, its place, and its text."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        if (*where, key) == (KEY,):
            continue
        if isinstance(item, str) and item.startswith("="):
            yield value, key, (*where, key), item
        else:
            yield from _formulas(item, (*where, key))


def _dimension(name: str, given: object, names: Mapping[str, _Value]) -> _Value:
    """Return a dimension's value; `names` holds the dimensions listed above this dimension."""
    if not _NAME.fullmatch(name):
        raise ValueError(
            f"{name!r} is not a valid name of a dimension: use small letters, digits and _, with a letter first"
        )
    if name in _FUNCTIONS:
        raise ValueError(f"{name!r} is the name of a function; choose another name for the dimension")
    if isinstance(given, str):
        return _evaluated(given.removeprefix("="), names)
    if isinstance(given, bool) or not isinstance(given, int | float) or not abs(given) < math.inf:
        raise ValueError(f"expected a quantity such as '12 ft', or an expression, got {short(given)}")
    return _Value(float(given), _PLAIN)


def _file_value(value: _Value) -> str | float:
    """Return a value in the form used in a file: a plain number, or a string that contains a number and its SI unit."""
    if value.powers == _PLAIN:
        return value.number
    if value.powers not in _KINDS:
        raise ValueError(f"the result is not a {', '.join(kind.noun for kind in _KINDS.values())} or number")
    return f"{value.number!r} {_KINDS[value.powers].unit}"


def _evaluated(text: str, names: Mapping[str, _Value]) -> _Value:
    """Return the value of an expression; raise ValueError if the expression is invalid or has no finite value."""
    if len(text) > _LONGEST:
        raise ValueError(f"an expression has at most {_LONGEST} characters, got {len(text)}")
    literals: list[_Value] = []

    def placeholder(match: re.Match[str]) -> str:
        literals.append(_literal(float(match[1]), match[2]))
        return f"__{len(literals) - 1}"

    try:
        tree = ast.parse(_LITERAL.sub(placeholder, text).strip(), mode="eval").body
    except (SyntaxError, RecursionError):
        raise ValueError(
            f"{short(text.strip())} is not an expression of numbers, units, names and + - * / ( )"
        ) from None
    value = _value(tree, {**names, **{f"__{i}": literal for i, literal in enumerate(literals)}})
    if not math.isfinite(value.number):
        raise ValueError(f"{short(text.strip())} has no finite value")
    return value


def _literal(number: float, unit: str | None) -> _Value:
    if unit is None:
        return _Value(number, _PLAIN)
    for powers, kind in _KINDS.items():
        try:
            return _Value(float(kind.read(f"{number!r} {unit}")), powers)
        except ValueError:
            continue
    raise ValueError(f"{unit!r} is not a unit of {', '.join(kind.noun for kind in _KINDS.values())}")


def _value(node: ast.expr, names: Mapping[str, _Value]) -> _Value:
    match node:
        case ast.Name(id=name):
            if name not in names:
                choices = ", ".join(known for known in names if not known.startswith("__")) or "none"
                raise ValueError(f"no dimension is named {name!r}; dimensions: {choices}")
            if names[name] is _WRONG:
                raise ValueError(f"the expression uses the dimension {name!r}, which has an error")
            return names[name]
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            value = _value(inner, names)
            return _Value(-value.number, value.powers)
        case ast.BinOp(left=left, op=op, right=right):
            return _combined(_value(left, names), op, _value(right, names))
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]) if name in _FUNCTIONS:
            return _function_value(name, [_value(arg, names) for arg in args])
        case _:
            raise ValueError(f"{ast.unparse(node)!r} cannot be computed; use numbers, names, + - * / and functions")


def _combined(a: _Value, op: ast.operator, b: _Value) -> _Value:
    match op:
        case ast.Add() | ast.Sub():
            _check_same_kind([a, b])
            return _Value(a.number + b.number if isinstance(op, ast.Add) else a.number - b.number, a.powers)
        case ast.Mult():
            return _Value(a.number * b.number, _sum(a.powers, b.powers, 1.0))
        case ast.Div():
            if b.number == 0.0:
                raise ValueError("the expression divides by 0")
            return _Value(a.number / b.number, _sum(a.powers, b.powers, -1.0))
        case _:
            raise ValueError("the only operators are + - * /")


def _sum(a: Powers, b: Powers, sign: float) -> Powers:
    m, kg, s, rad = (x + sign * y for x, y in zip(a, b, strict=True))
    return m, kg, s, rad


def _check_same_kind(values: list[_Value]) -> None:
    """Raise ValueError if the values have different units, and therefore cannot be added or compared."""
    if len({value.powers for value in values}) > 1:
        kinds = [_KINDS[value.powers].noun if value.powers in _KINDS else "number" for value in values]
        raise ValueError(f"{' and '.join(map(with_article, dict.fromkeys(kinds)))} cannot be added or compared")


_FUNCTIONS = ("min", "max", "sqrt", "cos", "sin", "tan")
_ANGLE: Powers = (0.0, 0.0, 0.0, 1.0)


def _function_value(name: str, args: list[_Value]) -> _Value:
    if name in ("min", "max"):
        if not args:
            raise ValueError(f"{name} needs at least 1 value")
        _check_same_kind(args)
        return (min if name == "min" else max)(args, key=lambda value: value.number)
    if len(args) != 1:
        raise ValueError(f"{name} takes 1 value, got {len(args)}")
    (arg,) = args
    if name == "sqrt":
        if arg.number < 0.0:
            raise ValueError(f"sqrt needs a value of 0 or more, got {arg.number:g}")
        m, kg, s, rad = (power / 2.0 for power in arg.powers)
        return _Value(math.sqrt(arg.number), (m, kg, s, rad))
    if arg.powers not in (_ANGLE, _PLAIN):
        raise ValueError(f"{name} needs an angle or a number")
    return _Value(getattr(math, name)(arg.number), _PLAIN)
