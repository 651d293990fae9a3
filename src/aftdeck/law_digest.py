"""Digest of a law: of its code, and of everything outside it on which its machine code depends.

Numba's own cache checks only the file that defines a function. Machine code also contains the laws that the law calls,
and the values of the constants that it names. A change of a law therefore changes the digests of this law and of those
that call it, and of no other law.
"""

from __future__ import annotations

import enum
import hashlib
import threading
from collections.abc import Callable, Iterator
from types import BuiltinFunctionType, CodeType, FunctionType, ModuleType
from typing import Any, NamedTuple

import numpy as np

_OWN = "aftdeck"
_known: dict[FunctionType, str] = {}
"""Digests of functions, which do not change in a process."""
_open: list[FunctionType] = []
"""Functions whose digests are being computed, each used by the one before it."""
_lock = threading.RLock()


class Options(NamedTuple):
    """How a law is compiled: with fused products and sums, and inlined in the laws that call it."""

    fused: bool
    inlined: bool


def digest_of(function: Callable[..., Any]) -> str:
    """Return the digest of a function and of all that it uses.

    Raises:
        TypeError: it names a value of which no digest is known, or functions call each other in a circle.
    """
    assert isinstance(function, FunctionType)
    with _lock:
        if function in _known:
            return _known[function]
        if function in _open:
            if function is _open[-1]:
                return "itself"
            raise TypeError(f"laws call each other in a circle: {', '.join(one.__name__ for one in _open)}")
        _open.append(function)
        try:
            _known[function] = hashlib.sha256("\n".join(_parts(function)).encode()).hexdigest()[:32]
        finally:
            _open.pop()
        return _known[function]


def digest_of_types(types: Any) -> str:
    """Return the names of the fields of all named tuples among Numba's types, which these types do not have."""
    named = getattr(types, "instance_class", None)
    fields = [] if named is None else [f"{named.__module__}.{named.__qualname__}{named._fields}"]
    inner = types if isinstance(types, tuple) else getattr(types, "types", ())
    return ";".join((*fields, *filter(None, map(digest_of_types, inner))))


def _parts(function: FunctionType) -> Iterator[str]:
    """Yield what the digest of a function is made of."""
    yield from _code(function.__code__, function.__doc__)
    yield from map(_value, function.__defaults__ or ())
    yield from (f"{name}={_value(value)}" for name, value in (function.__kwdefaults__ or {}).items())
    yield from (_value(cell.cell_contents) for cell in function.__closure__ or ())
    names = sorted(set(_names(function.__code__)))
    for name in names:
        if name not in function.__globals__:
            continue  # a built-in function, or an attribute
        value = function.__globals__[name]
        yield f"{name}: {_value(value)}"
        if isinstance(value, ModuleType) and _is_own(value.__name__):
            yield from (f"{name}.{one}: {_value(getattr(value, one))}" for one in names if hasattr(value, one))


def _code(code: CodeType, text: str | None = None) -> Iterator[str]:
    """Yield the instructions and the constants of a function, without its docstring `text`."""
    yield f"{code.co_code.hex()} {code.co_argcount} {code.co_flags}"
    yield f"{code.co_names} {code.co_varnames} {code.co_freevars}"
    for k, constant in enumerate(code.co_consts):
        if isinstance(constant, CodeType):
            yield from _code(constant)
        elif k > 0 or text is None or constant != text:
            yield _value(constant)


def _names(code: CodeType) -> Iterator[str]:
    """Yield all names that a function uses: of other values, and of their attributes."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


def _value(value: Any) -> str:
    """Return a text that differs for values with different machine code."""
    if value is None or isinstance(value, bool | int | float | complex | str | bytes | np.generic):
        return f"{type(value).__name__} {value!r}"
    if isinstance(value, tuple | list | frozenset):
        values = sorted(map(_value, value)) if isinstance(value, frozenset) else map(_value, value)
        return f"{_class(type(value))}({', '.join(values)})"
    if isinstance(value, np.ndarray):
        return f"{value.dtype} {value.shape} {value.strides} {value.flags.writeable} {value.tobytes().hex()}"
    if isinstance(value, type):
        return _class(value)
    if isinstance(value, ModuleType | np.ufunc | BuiltinFunctionType):
        return f"{type(value).__name__} {value.__name__}"
    if isinstance(options := getattr(value, "options", None), Options):  # a law before its compilation
        return f"{digest_of(value.function)} {options}"
    if hasattr(value, "py_func"):  # Numba's function
        given = value.targetoptions
        options = Options(bool(given.get("fastmath")), bool(given.get("forceinline")))
        return f"{digest_of(value.py_func)} {options}"
    if isinstance(value, FunctionType):
        return digest_of(value) if _is_own(value.__module__) else f"{value.__module__}.{value.__qualname__}"
    if getattr(value, "__module__", "").partition(".")[0] == "numpy":
        return f"numpy {getattr(value, '__name__', value)}"
    raise TypeError(f"a law uses {value!r}, of which no digest is known")


def _class(kind: type) -> str:
    """Return the name of a type; of a named tuple also its fields, and of an enumeration its members."""
    more = f" {kind._fields}" if hasattr(kind, "_fields") else ""
    if issubclass(kind, enum.Enum):
        more = f" {[(name, _value(one.value)) for name, one in kind.__members__.items()]}"
    return f"{kind.__module__}.{kind.__qualname__}{more}"


def _is_own(module: str | None) -> bool:
    return module is not None and module.partition(".")[0] == _OWN
