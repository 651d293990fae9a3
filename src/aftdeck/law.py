"""Decorator of the compiled laws.

A *law* is a function that computes with one float at a time, and has few branches. The same source code is
compiled by Numba (with a cache on disk), inlined in compiled loops over many arms, and run as plain Python under
``NUMBA_DISABLE_JIT=1``. Numba is imported at the first call of any law, because importing Numba takes longer than
loading an arm or a scenario. Loading an arm calls no law; loading a scenario runs them as plain Python (`interpreted`).
In compiled code, division by zero gives infinity, as in hardware; a law
whose divisor could be zero avoids that division.

A law gives the same result, to the last bit, on every processor and as plain Python. For this purpose the compiler may
neither reorder sums nor fuse a product and a sum (only `fused` allows that), and a law calls no function of the C
library, because libraries differ: `elementary.py` has the functions that laws need. `tests/test_machine_code.py`
searches the machine code of all laws for such calls and instructions.

Numba's own cache checks only the file that defines a function, not the files of the functions that it calls. If a law
changed in one file, the cached code of its callers would still contain the old version. The machine code is therefore
in a folder whose name is a digest of all laws (`law_cache.py`). This folder is inside `NUMBA_CACHE_DIR` if that
variable is set, otherwise inside the user's cache folder. Checkouts with the same laws share it.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import importlib
import inspect
import os
import re
import shutil
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, ParamSpec, TypeVar, cast

import numpy as np

from aftdeck.folders import user_folder
from aftdeck.law_cache import ENDING, LawCache

_P = ParamSpec("_P")
_R = TypeVar("_R")

_loading = threading.RLock()
_waiting: list[_Declared] | None = []
"""Laws that are declared but not yet loaded; None after `load`."""


class _Here(threading.local):
    """State of a thread: `plain` is True inside `interpreted`, and `nested` inside a law that runs there."""

    plain = nested = False


_here = _Here()
_briefly = False
"""Whether this process calls laws for a short time only: see `use_briefly`."""

_DECLARED = re.compile(rb"^@(elementary_|large_)?law$", re.MULTILINE)
"""Decorator of a law, in a source file."""
_KEPT = 30 * 86_400.0
"""Time after which unused machine code of another version of the laws is deleted [s]."""


class _Declared:
    """Placeholder of a law until `load` replaces it by the compiled function.

    `load` replaces only names in modules. Elsewhere, for example in a list, a law stays a placeholder. Such a law can
    be called, but more slowly.
    """

    def __init__(self, function: Callable[..., Any], interpreted: bool, fused: bool, inlined: bool) -> None:
        functools.update_wrapper(self, function)
        self._interpreted, self._fused, self._inlined = interpreted, fused, inlined

    @functools.cached_property
    def compiled(self) -> Callable[..., Any]:
        """Law as a function that Numba compiles at its first call."""
        function: Callable[..., Any] = self.__wrapped__  # type: ignore[attr-defined]
        return _compiled(function, fused=self._fused, inlined=self._inlined)

    def __call__(self, *given: Any) -> Any:
        """Call an interpreted law, or any law inside `interpreted`, as plain Python; else load all laws first."""
        function: Callable[..., Any] = self.__wrapped__  # type: ignore[attr-defined]
        if _waiting is None or not (self._interpreted or _here.plain):
            load()
            return self.compiled(*given)
        return function(*given) if self._interpreted else _as_python(function, *given)

    @property
    def _numba_type_(self) -> Any:
        """Numba's type of the law, for a compiled function that calls the law through this placeholder."""
        load()
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
            return _compiled(function, fused=fused, inlined=inlined)
        _waiting.append(_Declared(function, interpreted, fused, inlined))
        return cast("Callable[_P, _R]", _waiting[-1])


def use_briefly() -> None:
    """Let the laws run as plain Python in this process if machine code cannot be kept on disk.

    For one run this takes a fifth of the time that their compilation takes. Call this before the first law.
    """
    global _briefly  # noqa: PLW0603
    _briefly = True


def load() -> None:
    """Import Numba, and replace each placeholder by its compiled law, in every module that has a name for it.

    Later calls then reach the compiled law directly, from Python and from other laws. The first call of any law calls
    this function.
    """
    global _waiting  # noqa: PLW0603
    with _loading:
        if _waiting is None:
            return
        if _briefly and cache_folder() is None:
            os.environ["NUMBA_DISABLE_JIT"] = "1"  # for processes that this one starts
            config: Any = importlib.import_module("numba").config
            config.DISABLE_JIT = 1
        compiled = {id(declared): declared.compiled for declared in _waiting}
        for module in list(sys.modules.values()):
            names = getattr(module, "__dict__", {})
            for name, value in list(names.items()):
                if type(value) is _Declared:  # `isinstance` would start lazy imports of other packages
                    names[name] = compiled[id(value)]
        _waiting = None


def _compiled(function: Callable[_P, _R], *, fused: bool, inlined: bool) -> Callable[_P, _R]:
    import numba  # noqa: PLC0415  (takes 0.6 s; only calling a law needs it)

    options: dict[str, Any] = {
        "error_model": "numpy",
        "fastmath": {"contract"} if fused else False,
        "forceinline": inlined,
        "nogil": True,
        "no_cfunc_wrapper": True,
    }
    compiled: Any = numba.njit(**options)(function)
    if compiled is function:  # NUMBA_DISABLE_JIT
        return cast("Callable[_P, _R]", functools.wraps(function)(functools.partial(_as_python, function)))
    folder = None if fused else cache_folder()  # the cache does not distinguish the two versions of a law
    if folder is not None and Path(function.__code__.co_filename).is_file():
        compiled._cache = LawCache(function, folder)
    return cast("Callable[_P, _R]", compiled)


def compiled_before(package: str = "") -> bool:
    """Return whether the cache on disk contains machine code of this version of the laws.

    Args:
        package: name of the package whose laws count; if it is empty, all laws count.
    """
    folder = cache_folder()
    return folder is not None and any(folder.glob(f"aftdeck.{package}*/*{ENDING}"))


@functools.cache
def state_of_the_laws() -> str:
    """Return a 16-digit digest of this file and of the sources of every subpackage that contains a law."""
    digest, home = hashlib.sha256(), Path(__file__).parent
    sources = {path: path.read_bytes() for path in sorted(home.rglob("*.py"))}
    packages = {path.relative_to(home).parts[0] for path, text in sources.items() if _DECLARED.search(text)}
    packages.add(Path(__file__).name)
    for path, text in sources.items():
        if path.relative_to(home).parts[0] in packages:
            digest.update(text)
    return digest.hexdigest()[:16]


@functools.cache
def cache_folder() -> Path | None:
    """Return the cache folder for this version of the laws; None if no folder can be written.

    Also delete the folders of other versions that have been unused for more than `_KEPT`.
    """
    name = f"laws-{state_of_the_laws()}"
    home = user_folder("cache", name)
    if home is None:
        return None
    folder = home / name
    with contextlib.suppress(OSError):
        folder.mkdir(exist_ok=True)
        folder.touch()
        for other in home.glob("laws-*"):
            if time.time() - other.stat().st_mtime > _KEPT:
                shutil.rmtree(other, ignore_errors=True)
    return folder
