"""Decorator of the compiled laws, and the sine and cosine that the laws share.

A *law* is a function that computes with one float at a time, and has few branches. The same source code is
compiled by Numba (with a cache on disk), inlined in compiled loops over many arms, and run as plain Python under
``NUMBA_DISABLE_JIT=1``. Numba is imported at the first call of any law, because importing Numba takes longer than
loading an arm. Loading an arm calls no law. In compiled code, division by zero gives infinity, as in hardware; a law
whose divisor could be zero avoids that division.

Numba's own cache checks only the file that defines a function, not the files of the functions that it calls. If a law
changed in one file, the cached code of its callers would still contain the old version. The laws' cache is therefore
in a folder whose name is a digest of all laws. This folder is inside `NUMBA_CACHE_DIR` if that variable is set,
otherwise inside the user's cache folder.
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
"""Laws that are declared but not yet loaded; None after `load`."""

_KEPT = 30 * 86_400.0
"""Time after which unused machine code of another version of the laws is deleted [s]."""

_TWO_BY_PI = 0.6366197723675814
_ROUNDER = 6755399441055744.0
"""1.5 * 2**52. Near this value, every float is a whole number; near twice this value, every float is even."""
_HALF_PI_1 = 1.5707963267923333
"""First 36 bits of pi/2. Its products with whole numbers up to 2**17 are exact."""
_HALF_PI_2 = 2.563344151594519e-12
"""Remainder of pi/2 after `_HALF_PI_1`."""


class _Declared:
    """Placeholder of a law until `load` replaces it by the compiled function.

    `load` replaces only names in modules. Elsewhere, for example in a list, a law stays a placeholder. Such a law can
    be called, but more slowly.
    """

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
        """Numba's type of the law, for a compiled function that calls the law through this placeholder."""
        load()
        typeof: Any = importlib.import_module("numba").typeof
        return typeof(self.compiled)


def law(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Declare a law. Numba compiles it at its first call and caches the machine code on disk.

    A law that another law calls is inlined (`forceinline`), because loops with function calls do not vectorise. A law
    releases Python's global lock (`nogil`), and is never called from C (`no_cfunc_wrapper`).
    """
    return _declared(function, fused=False)


def _fused_law(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Declare a law with fused multiply-add, if the processor has it: a sum with a product is rounded only once.

    Use this decorator only if each sum contains one product at most, or is exact. In a sum of two products, the
    compiler chooses which product to fuse, and its choice varies. The result for one arm alone would then differ in
    its last digits from the result for the same arm in a batch.
    """
    return _declared(function, fused=True)


def _declared(function: Callable[_P, _R], *, fused: bool) -> Callable[_P, _R]:
    with _loading:
        if _waiting is None:
            return _compiled(function, fused=fused)
        _waiting.append(_Declared(function, fused))
        return cast("Callable[_P, _R]", _waiting[-1])


def load() -> None:
    """Import Numba, and replace each placeholder by its compiled law, in every module that has a name for it.

    Later calls then reach the compiled law directly, from Python and from other laws. The first call of any law calls
    this function.
    """
    global _waiting  # noqa: PLW0603
    with _loading:
        if _waiting is None:
            return
        compiled = {id(declared): declared.compiled for declared in _waiting}
        for module in list(sys.modules.values()):
            names = getattr(module, "__dict__", {})
            for name, value in list(names.items()):
                if type(value) is _Declared:  # `isinstance` would start lazy imports of other packages
                    names[name] = compiled[id(value)]
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
    """Return whether the cache on disk contains machine code of this version of the laws."""
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
    """Return the cache folder for this version of the laws.

    Also delete the folders of other versions that have been unused for more than `_KEPT`.
    """
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
    """Return the nearest whole number, for |value| < 2**51, without a library call or a branch.

    If two whole numbers are equally near, the even one is returned.
    """
    return (value + _ROUNDER) - _ROUNDER


@_fused_law
def _oddness(value: float) -> float:
    """Return the sine of a whole number of quarter turns: 0, 1 or -1, without a branch.

    The result is the value minus the nearest even number; of two equally near numbers, the multiple of 4 is used.
    """
    return value - ((value + 2.0 * _ROUNDER) - 2.0 * _ROUNDER)


@_fused_law
def reduced(angle: float) -> tuple[float, float]:
    """Subtract the nearest whole number of quarter turns from an angle [rad]; return the rest [rad] and that number.

    Method of Cody and Waite: pi/2 is subtracted in two parts.
    """
    quarters = nearest(angle * _TWO_BY_PI)
    return (angle - quarters * _HALF_PI_1) - quarters * _HALF_PI_2, quarters


@_fused_law
def sincos_near_zero(x: float) -> tuple[float, float]:
    """Return sine and cosine of an angle [rad] of at most an eighth of a turn.

    The polynomials are the minimax polynomials of the standard C library. Their terms are grouped in pairs, which the
    processor can compute at the same time.
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
    """Return sine and cosine of an angle plus whole quarter turns, from the angle's sine `s` and cosine `c`.

    Both sums are exact, because each has a term that is 0.
    """
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
