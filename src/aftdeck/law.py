"""Decorator of the compiled laws.

A *law* is a function that computes with one float at a time, and has few branches. The same source code is
compiled by Numba (with a cache on disk, `law_cache.py`), inlined in compiled loops over many arms, and run as plain
Python. Numba is imported at the first call of any law, because importing Numba takes longer than loading an arm or a
scenario. Loading an arm calls no law; loading a scenario runs them as plain Python (`interpreted`). In compiled code,
division by zero gives infinity, as in hardware; a law whose divisor could be zero avoids that division.

A law gives the same result, to the last bit, on every processor and as plain Python. For this purpose the compiler may
neither reorder sums nor fuse a product and a sum (only `fused` allows that), and a law calls no function of the C
library, because libraries differ: `elementary.py` has the functions that laws need. `tests/test_machine_code.py`
searches the machine code of all laws for such calls and instructions.

A process therefore may begin with plain Python while another one compiles, and change over between two calls
(`run_plain`, `prepare`; `law_change.py`).
"""

from __future__ import annotations

import contextlib
import functools
import importlib
import inspect
import os
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Literal, ParamSpec, TypeVar, cast

import numpy as np

from aftdeck.law_cache import LawCache, NotKept, here, only_kept
from aftdeck.law_digest import Options
from aftdeck.law_folder import cache_folder, compiled_before

_P = ParamSpec("_P")
_R = TypeVar("_R")

_loading = threading.RLock()
_waiting: list[_Declared] | None = []
"""Laws that are declared but not yet replaced by compiled functions; None after `load`."""
_prepared: list[tuple[dict[str, Any], str, Any]] | None = None
"""What the next call of a law replaces: namespaces, names in them, and compiled functions; None before `prepare`."""
_way: Literal["loaded", "compiled", "kept", "plain"] = "loaded"
"""How this process runs laws until `load`, which the first call of a law calls only in the way "loaded": see
`run_compiled`, `run_kept` and `run_plain`."""


class _Here(threading.local):
    """State of a thread: `plain` is True inside `interpreted`, and `nested` inside a law that runs there."""

    plain = nested = False


_here = _Here()


class _Declared:
    """Placeholder of a law until `load` replaces it by the compiled function.

    `load` replaces only names in modules. Elsewhere, for example in a list, a law stays a placeholder. Such a law can
    be called, but more slowly.
    """

    def __init__(self, function: Callable[..., Any], interpreted: bool, fused: bool, inlined: bool) -> None:
        functools.update_wrapper(self, function)
        self.function, self.options, self._interpreted = function, Options(fused, inlined), interpreted
        self._missing = False

    @functools.cached_property
    def compiled(self) -> Callable[..., Any]:
        """Law as a function that Numba compiles at its first call."""
        return _compiled(self.function, self.options)

    def __call__(self, *given: Any) -> Any:
        """Call the law in the way of this process and thread."""
        if _here.nested:
            return self.function(*given)
        if (here.only_kept or _way == "compiled") and not _here.plain:
            return self.compiled(*given)
        if _prepared is not None:
            load()
        if _waiting is not None:
            if self._interpreted and not _here.plain:
                return self.function(*given)
            if _here.plain or _way == "plain" or (_way == "kept" and self._missing):
                return _as_python(self.function, *given)
            if _way == "kept":
                return self._kept_or_plain(*given)
            load()
        return self.compiled(*given)

    def _kept_or_plain(self, *given: Any) -> Any:
        try:
            with only_kept():
                return self.compiled(*given)
        except NotKept:
            self._missing = True
            return _as_python(self.function, *given)

    @property
    def _numba_type_(self) -> Any:
        """Numba's type of the law, for a compiled function that calls the law through this placeholder."""
        typeof: Any = importlib.import_module("numba").typeof
        return typeof(self.compiled)


def _as_python(function: Callable[..., Any], *given: Any) -> Any:
    """Call a law as plain Python: divisions by zero are those of compiled code, and the numbers are Python's."""
    if _here.nested:
        return function(*given)
    _here.nested = True
    try:
        with np.errstate(all="ignore"):
            return _with_plain_numbers(function(*given))
    finally:
        _here.nested = False


def _with_plain_numbers(result: Any) -> Any:
    """Return the result of a law with Python's numbers in place of NumPy's, which elements of arrays are."""
    if isinstance(result, np.generic):
        return result.item()
    if isinstance(result, tuple):
        return tuple.__new__(type(result), map(_with_plain_numbers, result))
    return result


def law(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Declare a law. Numba compiles it at its first call and caches the machine code on disk.

    A law that another law calls is inlined (`forceinline`), because loops with function calls do not vectorise. A law
    releases Python's global lock (`nogil`), and is never called from C (`no_cfunc_wrapper`).
    """
    return _declared(function)


def elementary_law(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Declare a law that Python may call before Numba is loaded: until then it runs as plain Python.

    Files are read without Numba, and need sines and arc tangents. Both ways give the same result, to the last bit.
    """
    return _declared(function, interpreted=True)


def large_law(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Declare a law that other laws call instead of containing a copy of it.

    A call takes some nanoseconds. The compilation of a large law takes seconds, and would take them again in each law
    that contains a copy.
    """
    return _declared(function, inlined=False)


@contextlib.contextmanager
def interpreted() -> Iterator[None]:
    """Run the laws that this thread calls as plain Python, unless they are loaded already.

    Some thousand calls take less time than loading the laws. The results are the same, to the last bit.
    """
    before, _here.plain = _here.plain, True
    try:
        yield
    finally:
        _here.plain = before


def fused(exact: Callable[_P, _R]) -> Callable[_P, _R]:
    """Return another version of a law, with fused products and sums if the processor has them.

    This version is faster, but its last digits depend on the processor and on the compiler. No frame may depend on it.
    """
    return _declared(inspect.unwrap(exact), fused=True)


def _declared(
    function: Callable[_P, _R], *, interpreted: bool = False, fused: bool = False, inlined: bool = True
) -> Callable[_P, _R]:
    with _loading:
        if _waiting is None:
            return _compiled(function, Options(fused, inlined))
        _waiting.append(_Declared(function, interpreted, fused, inlined))
        return cast("Callable[_P, _R]", _waiting[-1])


def are_compiled() -> bool:
    """Return whether Numba compiles laws in this process, as it does unless `NUMBA_DISABLE_JIT` is set."""
    return os.environ.get("NUMBA_DISABLE_JIT", "0") in ("", "0")


def run_compiled() -> None:
    """Let this process compile each law at its first call, elementary laws too; only `interpreted` is plain Python.

    This is for a process that compiles for another one.
    """
    global _way  # noqa: PLW0603
    _way = "compiled"


def run_kept() -> None:
    """Let this process take each law from the disk if its machine code is there, and else run it as plain Python.

    It then compiles nothing, which is the quickest way to call laws for a short time.
    """
    global _way  # noqa: PLW0603
    if are_compiled():
        _way = "kept" if compiled_before() else "plain"


def run_plain() -> None:
    """Let this process run the laws as plain Python until `load`, which may be called at any time after `prepare`."""
    global _way  # noqa: PLW0603
    if are_compiled():
        _way = "plain"


def is_plain() -> bool:
    """Return whether this process runs the laws as plain Python for now, after `run_plain`."""
    return _waiting is not None and _prepared is None and _way == "plain"


def prepare() -> None:
    """Let the next call of a law in any thread, outside other laws, call `load`, which then takes no time."""
    global _prepared  # noqa: PLW0603
    with _loading:
        _prepared = None if _waiting is None else _replacements(_waiting)


def load() -> None:
    """Import Numba, and replace each placeholder by its compiled law, in every module that has a name for it.

    Later calls then reach the compiled law directly, from Python and from other laws. The first call of any law calls
    this function, unless `run_kept`, `run_compiled` or `run_plain` was called before.
    """
    global _waiting, _prepared  # noqa: PLW0603
    with _loading:
        if _waiting is None:
            return
        for names, name, compiled in _prepared or _replacements(_waiting):
            names[name] = compiled
        _waiting = _prepared = None


def _replacements(declared: list[_Declared]) -> list[tuple[dict[str, Any], str, Any]]:
    """Return the namespaces of all modules with names for laws, these names, and the compiled laws."""
    compiled = {id(one): one.compiled for one in declared}
    return [
        (module.__dict__, name, compiled[id(value)])
        for module in list(sys.modules.values())
        if hasattr(module, "__dict__")
        for name, value in list(module.__dict__.items())
        if type(value) is _Declared  # `isinstance` would start lazy imports of other packages
    ]


def _compiled(function: Callable[_P, _R], given: Options) -> Callable[_P, _R]:
    import numba  # noqa: PLC0415  (takes 0.6 s; only calling a law needs it)

    options: dict[str, Any] = {
        "error_model": "numpy",
        "fastmath": {"contract"} if given.fused else False,
        "forceinline": given.inlined,
        "nogil": True,
        "no_cfunc_wrapper": True,
    }
    named = importlib.import_module("aftdeck.law_link").named
    compiled: Any = numba.njit(pipeline_class=named(given), **options)(function)
    if compiled is function:  # NUMBA_DISABLE_JIT
        return cast("Callable[_P, _R]", functools.wraps(function)(functools.partial(_as_python, function)))
    if Path(function.__code__.co_filename).is_file():
        compiled._cache = LawCache(function, given, cache_folder())
    return cast("Callable[_P, _R]", compiled)
