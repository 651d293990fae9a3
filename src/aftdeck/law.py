"""Decorator of the compiled laws, and the sine and cosine that the laws share.

A *law* is straight-line scalar code: floats in, floats out, few branches. The same text runs compiled (Numba,
cached on disk), as plain Python under ``NUMBA_DISABLE_JIT=1``, and inside loops over many arms.
Numba is imported at the first call of any law: its import takes longer than loading an arm, which calls none.
Division by zero gives infinity, as in hardware; the laws guard the places where it could happen.

Numba's own cache checks only the file that defines a function, not the files of the functions that it calls. After a
law is corrected in one file, its callers would still contain the old version. The laws' cache is therefore kept in a
folder named by a digest of all laws, below `NUMBA_CACHE_DIR` if that is set, else in the user's cache folder.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import importlib
import os
import shutil
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, ParamSpec, TypeVar, cast

import platformdirs

_P = ParamSpec("_P")
_R = TypeVar("_R")

_loading = threading.RLock()
_waiting: list[_Declared] | None = []
"""Laws declared so far, until `load` makes them; None from then on."""

_KEPT = 30 * 86_400.0
"""Time for which unused machine code of another version of the laws is kept [s]."""

_TWO_BY_PI = 0.6366197723675814
_ROUNDER = 6755399441055744.0
"""1.5 * 2**52: floats near this value are the whole numbers; floats near its double are the even numbers."""
_HALF_PI_1 = 1.5707963267923333
"""First 36 bits of pi/2: whole multiples up to 2**17 are exact."""
_HALF_PI_2 = 2.563344151594519e-12
"""Remainder of pi/2 after `_HALF_PI_1`."""


class _Declared:
    """Declared law, which `load` replaces by the compiled one; a name that `load` misses still works, more slowly."""

    def __init__(self, function: Callable[..., Any], fused: bool) -> None:
        functools.update_wrapper(self, function)
        self._fused = fused

    @functools.cached_property
    def compiled(self) -> Callable[..., Any]:
        """Law as a function that Numba compiles at its first call."""
        return _compiled(self.__wrapped__, fused=self._fused)  # type: ignore[attr-defined]

    def __call__(self, *given: Any) -> Any:
        """Load all laws, then call this one."""
        load()
        return self.compiled(*given)

    @property
    def _numba_type_(self) -> Any:
        """Numba's type of the law, for a compiled function that knows the law by a name that `load` missed."""
        load()
        typeof: Any = importlib.import_module("numba").typeof
        return typeof(self.compiled)


def law(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Declare a law, which is compiled at its first call; its machine code is kept on disk.

    A law that another law calls is inlined (`forceinline`); otherwise loops do not vectorise. A law releases Python's
    global lock (`nogil`), and is never called from C (`no_cfunc_wrapper`).
    """
    return _declared(function, fused=False)


def _fused_law(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Compile a law in which a product and the sum that uses it are rounded once, if the processor can do so.

    Use only for sums that have a product as one term, or that are exact. Elsewhere the compiler chooses which product
    to fuse, and not always the same one. One arm would then differ in its last digits from the same arm in a batch.
    """
    return _declared(function, fused=True)


def _declared(function: Callable[_P, _R], *, fused: bool) -> Callable[_P, _R]:
    with _loading:
        if _waiting is None:
            return _compiled(function, fused=fused)
        _waiting.append(_Declared(function, fused))
        return cast("Callable[_P, _R]", _waiting[-1])


def load() -> None:
    """Import Numba, and put the compiled law in the place of each declared one, in every module that names it.

    A law is then called without a detour, from Python and from other laws. The first call of any law does this.
    """
    global _waiting  # noqa: PLW0603
    with _loading:
        if _waiting is None:
            return
        made = {id(one): one.compiled for one in _waiting}
        for module in list(sys.modules.values()):
            names = getattr(module, "__dict__", {})
            for name, value in list(names.items()):
                if type(value) is _Declared:  # `isinstance` would wake the lazy objects of other packages
                    names[name] = made[id(value)]
        _waiting = None


def _compiled(function: Callable[_P, _R], *, fused: bool) -> Callable[_P, _R]:
    import numba  # noqa: PLC0415  (takes 0.6 s; only calling a law needs it)

    config: Any = numba.config
    options: dict[str, Any] = {
        "error_model": "numpy",
        "fastmath": {"contract"} if fused else False,
        "forceinline": True,
        "nogil": True,
        "no_cfunc_wrapper": True,
    }
    before = config.CACHE_DIR
    config.CACHE_DIR = _cache()
    compiled: Callable[_P, _R]
    try:
        compiled = numba.njit(cache=True, **options)(function)
    except RuntimeError:  # no folder is writable: compile for this process only
        compiled = numba.njit(**options)(function)
    finally:
        config.CACHE_DIR = before
    return compiled


def compiled_before() -> bool:
    """Return whether machine code of these laws is on disk."""
    return any(Path(_cache()).rglob("*.nbi"))


@functools.cache
def state_of_the_laws() -> str:
    """Return a 16-digit digest of this file and of the sources of every subpackage that contains a law."""
    digest, home = hashlib.sha256(), Path(__file__).parent
    sources = {path: path.read_bytes() for path in sorted(home.rglob("*.py"))}
    packages = {path.relative_to(home).parts[0] for path, text in sources.items() if b"@law" in text}
    for path, text in sources.items():
        if path.relative_to(home).parts[0] in packages:
            digest.update(text)
    return digest.hexdigest()[:16]


@functools.cache
def _cache() -> str:
    """Return the cache folder for this version of the laws; remove other versions' folders that are long unused."""
    own = os.environ.get("NUMBA_CACHE_DIR")
    home = Path(own) if own else platformdirs.user_cache_path("aftdeck")
    folder = home / f"laws-{state_of_the_laws()}"
    with contextlib.suppress(OSError):  # without write access nothing is cached
        folder.mkdir(parents=True, exist_ok=True)
        folder.touch()
        for other in home.glob("laws-*"):
            if time.time() - other.stat().st_mtime > _KEPT:
                shutil.rmtree(other, ignore_errors=True)
    return str(folder)


@_fused_law
def nearest(value: float) -> float:
    """Return the nearest whole number, the even one of two, for |value| < 2**51; no library call, no branch."""
    return (value + _ROUNDER) - _ROUNDER


@_fused_law
def _oddness(value: float) -> float:
    """Return the sine of a whole number of quarter turns: 0, 1 or -1, without a branch.

    The result is the value minus the nearest even number; of two equally near numbers, the multiple of 4 is used.
    """
    return value - ((value + 2.0 * _ROUNDER) - 2.0 * _ROUNDER)


@_fused_law
def reduced(angle: float) -> tuple[float, float]:
    """Return an angle [rad] less the nearest number of quarter turns (Cody and Waite, two parts), and that number."""
    quarters = nearest(angle * _TWO_BY_PI)
    return (angle - quarters * _HALF_PI_1) - quarters * _HALF_PI_2, quarters


@_fused_law
def sincos_near_zero(x: float) -> tuple[float, float]:
    """Return sine and cosine of an angle [rad] within an eighth of a turn.

    Evaluates the minimax polynomials of the standard C library, with terms in pairs that do not wait for each other.
    """
    z = x * x
    w = z * z
    s = x + (x * z) * (
        (-1.66666666666666324348e-01 + z * 8.33333333332248946124e-03)
        + w
        * (
            (-1.98412698298579493134e-04 + z * 2.75573137070700676789e-06)
            + w * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)
        )
    )
    c = (1.0 - 0.5 * z) + w * (
        (4.16666666666666019037e-02 + z * -1.38888888888741095749e-03)
        + w
        * (
            (2.48015872894767294178e-05 + z * -2.75573143513906633035e-07)
            + w * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)
        )
    )
    return s, c


@_fused_law
def turned_on(s: float, c: float, quarters: float) -> tuple[float, float]:
    """Return a sine and cosine after adding whole quarter turns to their angle; both sums are exact."""
    sq, cq = _oddness(quarters), _oddness(quarters + 1.0)
    return s * cq + c * sq, c * cq - s * sq


@_fused_law
def sincos(angle: float) -> tuple[float, float]:
    """Return sine and cosine of an angle [rad] without a branch or a library call, so that loops vectorise.

    Error below 2e-16 for |angle| < 1e5.
    """
    x, quarters = reduced(angle)
    s, c = sincos_near_zero(x)
    return turned_on(s, c, quarters)
