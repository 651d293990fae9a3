"""Arrays that compiled code uses without counting references to them.

Numba counts the references to each array, in each call and each assignment, with an atomic operation. In laws that pass
dozens of arrays on, this takes a third of the time. A law that Python calls may lend its arguments to the laws that it
calls: they live until it returns.
"""

from __future__ import annotations

import functools
from typing import Any, TypeVar

from aftdeck.law_digest import Options

_A = TypeVar("_A")


class _Lend:
    """`lend`, which plain Python calls as a function, and compiled code as Numba's own code."""

    options = Options(fused=False, inlined=True)

    @staticmethod
    def function(array: _A) -> _A:
        """Return the array."""
        return array

    def __call__(self, array: _A) -> _A:
        """Return the same array. In compiled code, the result and its parts have no count of references.

        The result and its parts may be used only until the law whose argument `array` is returns.
        """
        return array

    @functools.cached_property
    def _numba_type_(self) -> Any:
        """Numba's type of this function."""
        from numba.core.registry import cpu_target  # noqa: PLC0415  (takes 0.6 s; only laws need it)

        code = _compiled()
        cpu_target.typing_context.refresh()
        return cpu_target.typing_context.resolve_value_type(code)


@functools.cache
def _compiled() -> Any:
    """Return Numba's code of `lend`: the same array without the object that counts its references."""
    from numba.extending import intrinsic  # noqa: PLC0415

    def lent(context: Any, array: Any) -> Any:
        del context

        def code(target: Any, builder: Any, signature: Any, given: Any) -> Any:
            view = target.make_array(signature.args[0])(target, builder, value=given[0])
            view.meminfo, view.parent = view.meminfo.type(None), view.parent.type(None)
            return view._getvalue()

        return array(array), code

    return intrinsic(lent)


lend = _Lend()
